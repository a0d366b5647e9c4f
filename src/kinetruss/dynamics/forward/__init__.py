"""Forward dynamics: the problem, its integration to given times, and the record of the result."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.record import simulation_of
    from kinetruss.dynamics.forward.set_up import Options, problem_of
    from kinetruss.dynamics.forward.stepper import Stepper
    from kinetruss.dynamics.forward.steppers import stepper_for

__all__ = ["Options", "Stepper", "problem_of", "simulation_of", "stepper_for"]

__getattr__, __dir__ = late(
    __name__,
    {
        "record": "simulation_of",
        "set_up": "Options problem_of",
        "stepper": "Stepper",
        "steppers": "stepper_for",
    },
)
