"""Drives, trajectories, tasks, methods and runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.motion.runs import FLEXIBLE, MISSION, STANDING, STATIC

__all__ = ["FLEXIBLE", "MISSION", "STANDING", "STATIC"]

__getattr__, __dir__ = late(__name__, {"runs": "FLEXIBLE MISSION STANDING STATIC"})
