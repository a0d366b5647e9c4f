"""Positions of nodes: arguments of users, poses of bays, motions of groups, values of rows and drives, axes of beams."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.mechanics.configuration.bay import FIT, POSE, bay_of, departs, pose_fault, pose_members, pose_values
    from kinetruss.mechanics.configuration.curves import BeamCurves, beam_curves
    from kinetruss.mechanics.configuration.planes import Rates, gimbal_angles, normalised, size, turn, vector_area
    from kinetruss.mechanics.configuration.positions import names_of, number_of, positions_of, vectors_of
    from kinetruss.mechanics.configuration.readings import drive_places, drive_values, row_values, shortest
    from kinetruss.mechanics.configuration.rigid_motion import centred, spin_of
    from kinetruss.mechanics.configuration.rotating_base import ROTATION, RotatingBase, base_of, rates_in_space

__all__ = [
    "FIT",
    "BeamCurves",
    "Rates",
    "POSE",
    "ROTATION",
    "RotatingBase",
    "base_of",
    "bay_of",
    "beam_curves",
    "centred",
    "departs",
    "drive_places",
    "drive_values",
    "gimbal_angles",
    "names_of",
    "normalised",
    "number_of",
    "pose_fault",
    "pose_members",
    "pose_values",
    "positions_of",
    "rates_in_space",
    "row_values",
    "shortest",
    "size",
    "spin_of",
    "turn",
    "vector_area",
    "vectors_of",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "bay": "FIT POSE bay_of departs pose_fault pose_members pose_values",
        "curves": "BeamCurves beam_curves",
        "planes": "Rates gimbal_angles normalised size turn vector_area",
        "positions": "names_of number_of positions_of vectors_of",
        "readings": "drive_places drive_values row_values shortest",
        "rigid_motion": "centred spin_of",
        "rotating_base": "ROTATION RotatingBase base_of rates_in_space",
    },
)
