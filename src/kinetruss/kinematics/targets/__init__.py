"""Inverse kinematics: from prescribed poses to the motion of the drives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.targets.inverse import course_to

__all__ = ["course_to"]

__getattr__, __dir__ = late(__name__, {"inverse": "course_to"})
