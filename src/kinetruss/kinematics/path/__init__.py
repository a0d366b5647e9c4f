"""Positions along a path: one configuration, a whole trajectory, and states between its samples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.path.assemble import assembled, refuse_unmet
    from kinetruss.kinematics.path.follow import course_along, instants, off_pose, path_of, sweep_path
    from kinetruss.kinematics.path.in_between import halved
    from kinetruss.kinematics.path.motion import Course, motion_of, rods_that_stick_out
    from kinetruss.kinematics.path.passed import Passed, refined
    from kinetruss.kinematics.path.redundant import LEAST
    from kinetruss.kinematics.path.sample import Sampled, check_trajectory, start_values

__all__ = [
    "Course",
    "LEAST",
    "Passed",
    "Sampled",
    "assembled",
    "check_trajectory",
    "course_along",
    "halved",
    "instants",
    "motion_of",
    "off_pose",
    "path_of",
    "refined",
    "refuse_unmet",
    "rods_that_stick_out",
    "start_values",
    "sweep_path",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "assemble": "assembled refuse_unmet",
        "follow": "course_along instants off_pose path_of sweep_path",
        "in_between": "halved",
        "motion": "Course motion_of rods_that_stick_out",
        "passed": "Passed refined",
        "redundant": "LEAST",
        "sample": "Sampled check_trajectory start_values",
    },
)
