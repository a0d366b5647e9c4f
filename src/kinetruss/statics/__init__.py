"""Static equilibrium: at single poses, with large displacements, by the stiffness method; elastic deflection along a motion.

Parts are imported when first used.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.deflections import (
        Deflection as Deflection,
        deflection as deflection,
        platform_stiffness as platform_stiffness,
    )
    from kinetruss.statics.large_displacements import Equilibrium as Equilibrium, equilibrium as equilibrium
    from kinetruss.statics.linear_buckling import Buckling as Buckling, buckling as buckling
    from kinetruss.statics.linear_statics import Linear as Linear, linear as linear
    from kinetruss.statics.paths import Path as Path, path as path
    from kinetruss.statics.poses import at_poses as at_poses

__getattr__, __dir__, __all__ = late(__name__)
