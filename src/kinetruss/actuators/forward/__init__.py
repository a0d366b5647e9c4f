"""Drive trains with a voltage, a current or a torque as input: alone, or many on a body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.forward.drive_model import COLUMNS, ENERGIES, drive_model_of, stored_energy
    from kinetruss.actuators.forward.ends import watch
    from kinetruss.actuators.forward.events import crossed
    from kinetruss.actuators.forward.inputs import in_currents, inputs_of, kinks, source_of
    from kinetruss.actuators.forward.modes import Drives, MotorModes, unwrapped
    from kinetruss.actuators.forward.slip import slipping
    from kinetruss.actuators.forward.steps import Step, Tolerances, method_from, step_of

__all__ = [
    "COLUMNS",
    "ENERGIES",
    "Drives",
    "MotorModes",
    "Step",
    "Tolerances",
    "crossed",
    "drive_model_of",
    "in_currents",
    "inputs_of",
    "kinks",
    "method_from",
    "slipping",
    "source_of",
    "step_of",
    "stored_energy",
    "unwrapped",
    "watch",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "drive_model": "COLUMNS ENERGIES drive_model_of stored_energy",
        "ends": "watch",
        "events": "crossed",
        "inputs": "in_currents inputs_of kinks source_of",
        "modes": "Drives MotorModes unwrapped",
        "slip": "slipping",
        "steps": "Step Tolerances method_from step_of",
    },
)
