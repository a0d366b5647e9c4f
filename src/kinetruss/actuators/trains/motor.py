"""Gear and DC motor behind a screw, or on the axis of an angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.model import Gear, LeadScrew, Motor

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["DIRECT", "at_motor", "motor_demand"]

DIRECT = Gear(ratio=1.0)
"""No gear: the motor sits on the screw, or on the axis of the angle."""


def motor_demand(
    screw: LeadScrew | None,
    gear: Gear | None,
    motor: Motor,
    torque: ArrayLike,
    rate: ArrayLike,
    acceleration: ArrayLike,
    current_rate: ArrayLike = 0.0,
) -> dict[str, NDArray[np.float64]]:
    """What a motor must deliver.

    Parameters
    ----------
    torque : on the screw (N m), positive when it drives the member longer. rate, acceleration : of the length, m/s, m/s^2.
    screw : None where the gear turns an angle; torque is then that on the angle, rate and acceleration are the angle's.
    current_rate : of the current (A/s), counts where the motor has an inductance.

    Returns
    -------
    ``motor_speed`` rad/s, ``motor_torque`` N m (Kt i, positive when it drives the member longer), ``current`` A,
    ``voltage`` V, ``mechanical_power`` and ``electrical_power`` W.

    Notes
    -----
    w = G L'/lead, T = J w' + T_f sign(w) + T_p eta^(-+1)/G, i = T/Kt, U = R i + L i' + Kb w. The gear's efficiency divides
    where power flows to the screw and multiplies where it flows back (`back_efficiency`, where one is given); at standstill it
    is left out, which is on the safe side, unless the gear is self-locking.
    The inertia of the gear counts at the motor's shaft. Source: Lacy (1991, eq. 2.40 and 4.78), the load torque divided
    by the gear ratio.

    Examples
    --------
    >>> import kinetruss as kt
    >>> motor = kt.Motor(inertia=0.0, resistance=2.0, torque_constant=0.1, emf_constant=0.1)
    >>> gear = kt.Gear(ratio=10, efficiency=0.8)
    >>> found = kt.actuators.motor_demand(None, gear, motor, torque=8.0, rate=3.0, acceleration=0.0)  # N m, rad/s
    >>> for name in ("motor_speed", "motor_torque", "current", "voltage", "electrical_power"):
    ...     print(name, found[name].round(6))
    motor_speed 30.0
    motor_torque 1.0
    current 10.0
    voltage 23.0
    electrical_power 230.0
    """
    stage = gear or DIRECT
    velocity, lead = np.asarray(rate, float), 1.0 if screw is None else screw.lead
    speed = stage.ratio * velocity / lead
    inertia = (motor.inertia + stage.inertia) * stage.ratio * np.asarray(acceleration, float) / lead
    total = inertia + motor.friction_torque * np.sign(speed) + at_motor(stage, torque, velocity)
    current = total / motor.torque_constant
    voltage = motor.resistance * current + motor.emf_constant * speed + motor.inductance * np.asarray(current_rate, float)
    return {
        "motor_speed": speed,
        "motor_torque": total,
        "current": current,
        "voltage": voltage,
        "mechanical_power": total * speed,
        "electrical_power": voltage * current,
    }


def at_motor(gear: Gear | None, torque: ArrayLike, direction: ArrayLike) -> NDArray[np.float64]:
    """Torque at the motor (N m) for one behind the gear, moving in a direction (a rate, or its sign; 0 stands still).

    At standstill the loss is left out, but a gear that is self-locking holds all of it.
    """
    stage, at_screw = gear or DIRECT, np.asarray(torque, float)
    power = at_screw * np.asarray(direction, float)
    still = 0.0 if stage.self_locking else 1.0
    loss = np.where(power > 0, 1 / stage.efficiency, np.where(power < 0, stage.backwards, still))
    return at_screw * loss / stage.ratio
