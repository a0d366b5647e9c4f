"""Histories of the motors of a simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.results import variable

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.dynamics.motors.motors import Motors

__all__ = ["TOLD", "with_motors"]

TOLD = {
    "motor_command": ("", "input, as told (V or A)"),
    "motor_voltage": ("V", "motor voltage"),
    "motor_current": ("A", "motor current"),
    "motor_torque": ("N m", "motor torque (torque constant x current)"),
    "motor_angle": ("rad", "turned by the motor since the start"),
    "motor_speed": ("rad/s", "speed of the motor"),
    "motor_direction": ("", "direction of the motion: 1 longer or turning on, -1 shorter or back, 0 sticks"),
    "screw_torque": ("N m", "torque on the screw, positive towards longer; 0 at standstill, none of an angle"),
    "electrical_energy": ("J", "taken from the source so far"),
    "copper_energy": ("J", "heat in the winding so far"),
    "motor_loss": ("J", "friction of the motor so far"),
    "gear_loss": ("J", "lost in the gear so far"),
    "screw_loss": ("J", "friction of the screw so far"),
    "actuator_work": ("J", "work of the thrust or torque on the structure so far"),
    "motor_stored_energy": ("J", "in rotor and winding"),
}
"""In the order in which they come."""


def with_motors(frame: xr.Dataset, motors: Motors, extra: NDArray[np.float64]) -> xr.Dataset:
    """The dataset with histories (time, motor) from the columns (time, motors x histories)."""
    table = extra.reshape(len(extra), len(motors.names), len(TOLD))
    both = ("time", "motor")
    found = {name: variable(both, table[:, :, k].copy(), *words) for k, (name, words) in enumerate(TOLD.items())}
    spent = sum(table[:, :, list(TOLD).index(name)] for name in SPENT)
    balance = table[:, :, list(TOLD).index("electrical_energy")] - spent - table[:, :, -1] + motors.stored
    found["motor_energy_balance"] = variable(both, balance, "J", "electrical energy minus all it went to")
    return frame.assign_coords(motor=variable(("motor",), np.array(motors.names, str), "", "motor-driven drive")).assign(found)


SPENT = ("copper_energy", "motor_loss", "gear_loss", "screw_loss", "actuator_work")
