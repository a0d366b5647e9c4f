"""Gear and DC motor behind a screw."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.model import Gear, LeadScrew, Motor

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["DIRECT", "motor_demand"]

DIRECT = Gear(ratio=1.0)
"""No gear: the motor sits on the screw."""


def motor_demand(
    screw: LeadScrew, gear: Gear | None, motor: Motor, torque: ArrayLike, rate: ArrayLike, acceleration: ArrayLike
) -> dict[str, NDArray[np.float64]]:
    """What a motor must deliver.

    Parameters
    ----------
    torque : on the screw (N m), positive when it drives the member longer. rate, acceleration : of the length, m/s, m/s^2.

    Returns
    -------
    ``motor_speed`` rad/s, ``motor_torque`` N m (Kt i, positive when it drives the member longer), ``current`` A,
    ``voltage`` V, ``mechanical_power`` and ``electrical_power`` W.

    Notes
    -----
    w = G L'/lead, T = J w' + T_f sign(w) + T_p eta^(-+1)/G, i = T/Kt, U = R i + Kb w. The gear's efficiency divides where
    power flows to the screw and multiplies where it flows back; at standstill it is left out, which is on the safe side.
    The inertia of the gear counts at the motor's shaft. Source: Lacy (1991, eq. 2.40 and 4.78), the load torque divided
    by the gear ratio.
    """
    stage = gear or DIRECT
    at_screw, velocity = np.asarray(torque, float), np.asarray(rate, float)
    speed = stage.ratio * velocity / screw.lead
    power = at_screw * velocity
    loss = np.where(power > 0, 1 / stage.efficiency, np.where(power < 0, stage.efficiency, 1.0))
    inertia = (motor.inertia + stage.inertia) * stage.ratio * np.asarray(acceleration, float) / screw.lead
    total = inertia + motor.friction_torque * np.sign(speed) + at_screw * loss / stage.ratio
    current = total / motor.torque_constant
    voltage = motor.resistance * current + motor.emf_constant * speed
    return {
        "motor_speed": speed,
        "motor_torque": total,
        "current": current,
        "voltage": voltage,
        "mechanical_power": total * speed,
        "electrical_power": voltage * current,
    }
