"""Positions along a path: one configuration, a trajectory, what lies between its samples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.path.assemble import assembled, refuse_unmet
    from kinetruss.kinematics.path.follow import instants
    from kinetruss.kinematics.path.motion import Course, motion_of
    from kinetruss.kinematics.path.passed import Passed, refined
    from kinetruss.kinematics.path.redundant import LEAST
    from kinetruss.kinematics.path.sample import start_values

__all__ = [
    "Course",
    "LEAST",
    "Passed",
    "assembled",
    "instants",
    "motion_of",
    "refined",
    "refuse_unmet",
    "start_values",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "assemble": "assembled refuse_unmet",
        "follow": "instants",
        "motion": "Course motion_of",
        "passed": "Passed refined",
        "redundant": "LEAST",
        "sample": "start_values",
    },
)
