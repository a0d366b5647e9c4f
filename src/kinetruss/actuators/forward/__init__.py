"""Drive trains with a voltage, a current or a torque as input: alone, or many on a body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.forward.drive_model import COLUMNS, ENERGIES, DriveModel, drive_model_of, stored_energy
    from kinetruss.actuators.forward.ends import watch
    from kinetruss.actuators.forward.events import crossed
    from kinetruss.actuators.forward.inputs import (
        command_of,
        in_currents,
        is_stiff,
        kinks,
        longest_step,
        small_torques,
        source_of,
    )
    from kinetruss.actuators.forward.modes import Drives, MotorModes, unwrapped
    from kinetruss.actuators.forward.place_poles import gains_of
    from kinetruss.actuators.forward.slip import slipping
    from kinetruss.actuators.forward.steps import Step, Tolerances, method_from, step_of

__all__ = [
    "COLUMNS",
    "ENERGIES",
    "DriveModel",
    "Drives",
    "MotorModes",
    "Step",
    "Tolerances",
    "command_of",
    "crossed",
    "drive_model_of",
    "gains_of",
    "in_currents",
    "is_stiff",
    "kinks",
    "longest_step",
    "method_from",
    "slipping",
    "small_torques",
    "source_of",
    "step_of",
    "stored_energy",
    "unwrapped",
    "watch",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "drive_model": "COLUMNS ENERGIES DriveModel drive_model_of stored_energy",
        "ends": "watch",
        "events": "crossed",
        "inputs": "command_of in_currents is_stiff kinks longest_step small_torques source_of",
        "modes": "Drives MotorModes unwrapped",
        "place_poles": "gains_of",
        "slip": "slipping",
        "steps": "Step Tolerances method_from step_of",
    },
)
