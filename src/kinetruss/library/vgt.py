"""Variable-geometry trusses: the triangular truss, the double-octahedral truss and its chains, and their motions."""

from kinetruss.library._double_octahedral import double_octahedral, slew
from kinetruss.library._triangular import lacy_step, triangular

__all__ = ["double_octahedral", "lacy_step", "slew", "triangular"]
