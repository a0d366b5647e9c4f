"""Equilibrium without a motion: pose by pose, by the stiffness method, and elastic deflection on top of a rigid motion.

Parts are imported when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kinetruss.statics._at_poses import at_poses
    from kinetruss.statics._buckling import Buckling, buckling
    from kinetruss.statics._deflection import Deflection, deflection
    from kinetruss.statics._equilibrium import Equilibrium, equilibrium
    from kinetruss.statics._linear import Linear, linear
    from kinetruss.statics._path import Path, path
    from kinetruss.statics._platform_stiffness import platform_stiffness

__all__ = [
    "Buckling", "Deflection", "Equilibrium", "Linear", "Path", "at_poses", "buckling", "deflection", "equilibrium", "linear",
    "path", "platform_stiffness",
]  # fmt: skip

_HOME = {
    "Buckling": "_buckling", "buckling": "_buckling",
    "Deflection": "_deflection", "Equilibrium": "_equilibrium", "Linear": "_linear", "at_poses": "_at_poses",
    "Path": "_path", "deflection": "_deflection", "equilibrium": "_equilibrium", "linear": "_linear", "path": "_path",
    "platform_stiffness": "_platform_stiffness",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.statics.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.statics' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
