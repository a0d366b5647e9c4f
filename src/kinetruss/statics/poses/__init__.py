"""Static forces at single poses, and elastic deflection along a motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.statics.poses.deflection import loads_of, nodal_forces

__all__ = ["loads_of", "nodal_forces"]

__getattr__, __dir__ = late(__name__, {"deflection": "loads_of nodal_forces"})
