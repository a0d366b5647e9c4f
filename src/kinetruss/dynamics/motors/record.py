"""Histories of the motors of a simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.forward import COLUMNS, ENERGIES
from kinetruss.results import Column, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.motors.motors import Motors

__all__ = ["motor_histories", "motor_names"]


def motor_names(motors: Motors) -> dict[str, Column]:
    """The axis of the motors."""
    return {"motor": variable(("motor",), np.array(motors.names, str), "", "motor-driven drive")}


def motor_histories(motors: Motors, extra: NDArray[np.float64]) -> dict[str, Column]:
    """Histories (time, motor) from the columns (time, motors x histories)."""
    table = extra.reshape(len(extra), len(motors.names), len(COLUMNS))
    both = ("time", "motor")
    found = {name: variable(both, table[:, :, k].copy(), *words) for k, (name, words) in enumerate(COLUMNS.items())}
    spent = sum(table[:, :, list(COLUMNS).index(name)] for name in ENERGIES[1:])
    balance = table[:, :, list(COLUMNS).index("electrical_energy")] - spent - table[:, :, -1] + motors.stored
    found["motor_energy_balance"] = variable(both, balance, "J", "electrical energy minus all it went to")
    return found
