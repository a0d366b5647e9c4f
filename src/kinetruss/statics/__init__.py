"""Static equilibrium: at single poses, with large displacements, by the stiffness method; elastic deflection along a motion.

Parts are imported when first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.large.equilibrium import Equilibrium, equilibrium
    from kinetruss.statics.large.path import Path, path
    from kinetruss.statics.poses.at_poses import at_poses
    from kinetruss.statics.poses.deflection import Deflection, deflection
    from kinetruss.statics.poses.platform_stiffness import platform_stiffness
    from kinetruss.statics.small.buckling import Buckling, buckling
    from kinetruss.statics.small.linear import Linear, linear

__all__ = [
    "Buckling",
    "Deflection",
    "Equilibrium",
    "Linear",
    "Path",
    "at_poses",
    "buckling",
    "deflection",
    "equilibrium",
    "linear",
    "path",
    "platform_stiffness",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "large.equilibrium": "Equilibrium equilibrium",
        "large.path": "Path path",
        "poses.at_poses": "at_poses",
        "poses.deflection": "Deflection deflection",
        "poses.platform_stiffness": "platform_stiffness",
        "small.buckling": "Buckling buckling",
        "small.linear": "Linear linear",
    },
)
