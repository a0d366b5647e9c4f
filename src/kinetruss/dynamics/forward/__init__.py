"""Forward dynamics: a problem, steps to wanted times, the record of what happened."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.record import simulation_of
    from kinetruss.dynamics.forward.stepper import Stepper

__all__ = ["Stepper", "simulation_of"]

__getattr__, __dir__ = late(
    __name__,
    {
        "record": "simulation_of",
        "stepper": "Stepper",
    },
)
