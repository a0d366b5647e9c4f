"""Variable-geometry trusses: the triangular truss, the double-octahedral truss and its chains, and their motions."""

from kinetruss.late import listed
from kinetruss.library.vgt.double_octahedral import double_octahedral, slew
from kinetruss.library.vgt.triangular import lacy_step, triangular

__all__ = ["double_octahedral", "lacy_step", "slew", "triangular"]

__dir__ = listed(__name__)
