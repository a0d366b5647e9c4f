"""Equilibrium without a motion: pose by pose, by the stiffness method, and elastic deflection on top of a rigid motion.

Parts are imported when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.statics.large.equilibrium import Equilibrium, equilibrium
    from kinetruss.statics.large.path import Path, path
    from kinetruss.statics.poses.at_poses import at_poses
    from kinetruss.statics.poses.deflection import Deflection, deflection
    from kinetruss.statics.poses.platform_stiffness import platform_stiffness
    from kinetruss.statics.small.buckling import Buckling, buckling
    from kinetruss.statics.small.linear import Linear, linear

__all__ = [
    "Buckling", "Deflection", "Equilibrium", "Linear", "Path", "at_poses", "buckling", "deflection", "equilibrium", "linear",
    "path", "platform_stiffness",
]  # fmt: skip

_HOME = {
    "Buckling": "small.buckling", "buckling": "small.buckling",
    "Deflection": "poses.deflection", "Equilibrium": "large.equilibrium", "Linear": "small.linear", "at_poses": "poses.at_poses",
    "Path": "large.path", "deflection": "poses.deflection", "equilibrium": "large.equilibrium", "linear": "small.linear", "path": "large.path",
    "platform_stiffness": "poses.platform_stiffness",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.statics.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.statics' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
