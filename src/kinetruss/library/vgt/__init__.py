"""Variable-geometry trusses: the triangular truss, the double-octahedral truss and its chains, and their motions."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.library.vgt.octahedral_truss import double_octahedral as double_octahedral, slew as slew
    from kinetruss.library.vgt.triangular_truss import lacy_step as lacy_step, triangular as triangular

__getattr__, __dir__, __all__ = late(__name__)
