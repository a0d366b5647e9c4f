"""Lead screws: torque against thrust, and whether they hold by themselves.

With lead l = 2 pi lead (m a turn), mean diameter d, friction mu and thread half-angle a (Shigley, Mechanical Engineering
Design, power screws; Lacy, 1991, eq. 2.36 to 2.38):

    raising   T = F d/2 (l + pi mu d sec a)/(pi d - mu l sec a)
    lowering  T = F d/2 (pi mu d sec a - l)/(pi d + mu l sec a)

T is counted along the motion: a negative lowering torque must be held back, or it drives the gear.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.model import LeadScrew

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def raising_torque(screw: LeadScrew, thrust: float) -> float:
    """Torque (N m) along the motion that moves a screw against a thrust (N, as a magnitude).

    Raises
    ------
    InputError : the screw jams: mu tan(lambda) sec(a) >= 1, no torque raises the load.

    Examples
    --------
    >>> import kinetruss as kt
    >>> screw = kt.LeadScrew(lead=0.002, mean_diameter=0.02, friction=0.3)
    >>> round(kt.actuators.raising_torque(screw, 100.0), 4)  # N m: F d/2 (0.2 + 0.3)/(1 - 0.2 * 0.3)
    0.5319
    """
    slope, friction = _thread(screw)
    if slope * friction >= 1:
        raise InputError(
            f"The screw jams: lead {screw.lead:g} m/rad on mean diameter {screw.mean_diameter:g} m with friction "
            f"{screw.friction:g} cannot be raised by any torque. Take a smaller lead or less friction."
        )
    radius = float(screw.mean_diameter / 2)
    return thrust * radius * (slope + friction) / (1 - friction * slope)


def lowering_torque(screw: LeadScrew, thrust: float) -> float:
    """Torque (N m) along the motion that moves a screw with a thrust (N, as a magnitude); negative: it must be held back.

    >>> lowering_torque(LeadScrew(lead=0.003, mean_diameter=0.02, friction=0.3), 100.0)  # lead = mu d/2: the limit
    0.0
    """
    slope, friction = _thread(screw)
    radius = float(screw.mean_diameter / 2)
    return thrust * radius * (friction - slope) / (1 + friction * slope)


def screw_torque(screw: LeadScrew, thrust: ArrayLike, moving: ArrayLike) -> NDArray[np.float64]:
    """Torque on the screw (N m, positive when it drives the member longer), shape of thrust and moving together.

    Parameters
    ----------
    thrust : N, positive when it is compression in the actuator (= minus the tension of the member).
    moving : rate of length (m/s), or its sign; 0 stands still.

    The sign of the power thrust x rate chooses: positive work raises the load, negative lowers it. At standstill the
    screw holds: no torque where it is self-locking, else what keeps it from running back.

    Examples
    --------
    >>> import kinetruss as kt
    >>> screw = kt.LeadScrew(lead=0.002, mean_diameter=0.02, friction=0.3)
    >>> kt.actuators.screw_torque(screw, 100.0, [1, -1, 0]).round(4).tolist()  # raise, lower, stand still: it locks itself
    [0.5319, -0.0943, 0.0]
    """
    push, direction = np.broadcast_arrays(np.asarray(thrust, float), np.sign(np.asarray(moving, float)))
    up, down = raising_torque(screw, 1.0), lowering_torque(screw, 1.0)
    moved = direction * np.abs(push) * np.where(push * direction >= 0, up, down)
    return np.where(direction == 0, holding_torque(screw, push), moved)


def holding_torque(screw: LeadScrew, thrust: ArrayLike) -> NDArray[np.float64]:
    """Torque on the screw (N m, positive towards longer) that keeps it from running back: zero where it is self-locking.

    Counted with the running friction, which is on the safe side.

    >>> import kinetruss as kt
    >>> ball, steep = (kt.LeadScrew(lead=0.002, mean_diameter=0.02, friction=friction) for friction in (0.0, 0.3))
    >>> kt.actuators.holding_torque(ball, 1000.0).round(6).item()  # N m: without friction thrust x lead
    2.0
    >>> kt.actuators.holding_torque(steep, 1000.0).item()  # friction holds the load
    0.0
    """
    held: NDArray[np.float64] = np.asarray(thrust, float) * max(0.0, -lowering_torque(screw, 1.0))
    return held


def breakaway_torque(screw: LeadScrew, thrust: ArrayLike, direction: ArrayLike) -> NDArray[np.float64]:
    """Torque on the screw (N m, positive towards longer) that starts it from rest, with its static friction.

    direction : sign of the motion to come; 0 means against the load, which takes most.

    >>> import kinetruss as kt
    >>> screw = kt.LeadScrew(lead=0.002, mean_diameter=0.02, friction=0.3, static_friction=0.4)
    >>> kt.actuators.breakaway_torque(screw, 100.0, [1, -1]).round(3).tolist()  # longer, against the load; shorter, with it
    [0.652, -0.185]
    """
    push, wanted = np.broadcast_arrays(np.asarray(thrust, float), np.sign(np.asarray(direction, float)))
    return screw_torque(sticking(screw), push, np.where(wanted == 0, np.where(push < 0, -1.0, 1.0), wanted))


def sticking(screw: LeadScrew) -> LeadScrew:
    """The screw at rest: its static friction as friction."""
    return screw if screw.static_friction is None else screw.with_(friction=screw.static_friction)


def is_self_locking(screw: LeadScrew) -> bool:
    """True where no thrust runs the screw back: tan(lambda) <= mu sec(a), i.e. lead <= mu d/2 sec(a).

    >>> import kinetruss as kt
    >>> [kt.actuators.is_self_locking(kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=mu)) for mu in (0.05, 0.15)]
    [False, True]
    """
    return bool(screw.lead <= largest_self_locking_lead(screw) * (1 + 1e-12))


def largest_self_locking_lead(screw: LeadScrew) -> float:
    """The largest lead (m/rad) that still holds by friction, for this diameter, friction and flank: mu d/2 sec(a).

    >>> import kinetruss as kt
    >>> screw = kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.15)
    >>> round(kt.actuators.largest_self_locking_lead(screw), 6)  # m/rad: mu d/2
    0.0015
    """
    return float(screw.mean_diameter / 2 * screw.friction / math.cos(screw.flank))


def gear_ratio_for(screw: LeadScrew, motor_speed: float, length_rate: float) -> float:
    """Gear ratio (motor turns a screw turn) at which a motor at motor_speed (rad/s) gives length_rate (m/s).

    >>> round(gear_ratio_for(LeadScrew(lead=0.003, mean_diameter=0.02), 400.0, 1.2477), 5)
    0.96177
    """
    if motor_speed == 0 or length_rate == 0:
        raise InputError("A gear ratio needs a motor speed and a rate of length other than zero.")
    return float(abs(motor_speed) * screw.lead / abs(length_rate))


def _thread(screw: LeadScrew) -> tuple[float, float]:
    """Slope tan(lambda) = lead/(d/2) and effective friction mu sec(a)."""
    return float(screw.lead / (screw.mean_diameter / 2)), float(screw.friction / math.cos(screw.flank))
