"""Screw, gear and motor of a drive, seen from the motor's shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.actuators.screws import lowering_torque, raising_torque, sticking
from kinetruss.errors import InputError
from kinetruss.model import Active, Amplifier, AngleDrive, DriveTrain, Gear, HingeDrive, LeadScrew, Model, Motor, nearest

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike, NDArray


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


# Gear and screw, or gear alone, seen from the motor's shaft.
#
# What it moves is a length against a thrust, or an angle against a torque: of an angle, read N m for N, rad for m, kg m^2 for
# kg.


@dataclass(frozen=True, slots=True)
class Shaft:
    """What a thrust and a rate of length are at the motor.

    speed : rad/m, motor speed a rate of length, G/lead. gear : G. lead : m/rad. inertia : kg m^2, of motor and gear.
    friction : N m, of the motor. up, down : N m a newton at the motor, along the motion, to raise and to lower a load; negative
    where lowering must be held back. rest_up, rest_down : the same with the screw's static friction. screw_up, screw_down : at
    the screw, or behind the gear of an angle (1, -1), whose lead is 1. turns : it is an angle.
    """

    speed: float
    gear: float
    lead: float
    inertia: float
    friction: float
    up: float
    down: float
    rest_up: float
    rest_down: float
    screw_up: float
    screw_down: float
    turns: bool

    def resistance(self, against: float) -> float:
        """Torque (N m) along the motion for a thrust (N) counted along the motion: positive is raised, negative lowered."""
        return against * self.up if against >= 0 else -against * self.down

    def needed(self, direction: int, thrust: float) -> float:
        """Torque (N m) along `direction` that keeps the drive moving at a constant speed."""
        return self.friction + self.resistance(direction * thrust)

    def breakaway(self, direction: int, thrust: float) -> float:
        """Torque (N m) along `direction` that starts it from rest."""
        against = direction * thrust
        return self.friction + (against * self.rest_up if against >= 0 else -against * self.rest_down)

    def acceleration(self, direction: int, torque: float, thrust: float, mass: float) -> float:
        """Acceleration of the length (m/s^2) when the motor gives `torque` (N m) and moves `mass` (kg) against `thrust` (N).

        J G/lead a = T - T_f - R(F + m a) along the motion; R has one slope for raising and one for lowering, so that the
        solution is on one of two straight lines.
        """
        given = direction * torque - self.friction
        load, rotor = direction * thrust, self.inertia * self.speed
        found = (given - load * self.up) / (rotor + mass * self.up)
        if load + mass * found < 0:
            found = (given + load * self.down) / (rotor - mass * self.down)
        return direction * found


def shaft_of(train: DriveTrain) -> Shaft:
    """Gear and screw of a drive train at its motor's shaft.

    The gear's efficiency divides what flows to the screw, and multiplies what flows back.
    """
    screw, gear = train.screw, train.gear

    def geared(torque: float) -> float:
        return torque / gear.ratio / gear.efficiency if torque > 0 else torque / gear.ratio * gear.backwards

    up, down, rest_up, rest_down = 1.0, -1.0, 1.0, -1.0
    if screw is not None:
        rest = sticking(screw)
        up, down = raising_torque(screw, 1.0), lowering_torque(screw, 1.0)
        rest_up, rest_down = raising_torque(rest, 1.0), lowering_torque(rest, 1.0)
    lead = 1.0 if screw is None else screw.lead
    inertia = train.motor.inertia + gear.inertia
    if inertia <= 0:
        raise InputError("A drive without inertia of motor and gear has no acceleration. Give the motor's inertia.")
    return Shaft(
        speed=gear.ratio / lead,
        gear=gear.ratio,
        lead=lead,
        inertia=inertia,
        friction=train.motor.friction_torque,
        up=geared(up),
        down=geared(down),
        rest_up=geared(rest_up),
        rest_down=geared(rest_down),
        screw_up=up,
        screw_down=down,
        turns=screw is None,
    )


# The drive train of an active member, or of a drive of an angle.

Geared = Active | AngleDrive | HingeDrive
"""What a drive train belongs to."""


class Parts(NamedTuple):
    """What is known of a drive train; of that of an angle, there is no screw."""

    screw: LeadScrew | None
    gear: Gear | None
    motor: Motor | None
    amplifier: Amplifier | None


class Output(NamedTuple):
    """Where the gear ends: rate of the length or angle (m/s or rad/s), torque there (N m) and speed (rad/s).

    lead : rate over speed, m/rad of a screw, 1 of an angle.
    """

    rate: NDArray[np.float64]
    torque: NDArray[np.float64]
    speed: NDArray[np.float64]
    lead: float


def output_of(parts: Parts, one: Geared, data: Mapping[str, NDArray[np.float64]]) -> Output | None:
    """What the histories of an actuator say behind its gear; None of a member without a screw."""
    if not isinstance(one, Active):
        return Output(data["angle_rate"], data["drive_torque"], data["angle_rate"], 1.0)
    if parts.screw is None:
        return None
    return Output(data["length_rate"], data["screw_torque"], data["screw_speed"], parts.screw.lead)


def parts_of(model: Model, active: Geared) -> Parts:
    """Screw, gear, motor and amplifier of an actuator, looked up where they are named; None where it has none."""
    screw = active.screw if isinstance(active, Active) else None
    return Parts(
        model.screws[screw] if isinstance(screw, str) else screw,
        model.gears[active.gear] if isinstance(active.gear, str) else active.gear,
        model.motors[active.motor] if isinstance(active.motor, str) else active.motor,
        model.amplifiers[active.amplifier] if isinstance(active.amplifier, str) else active.amplifier,
    )


def train_of(model: Model, name: str) -> DriveTrain:
    """The drive train of an active member, or of a drive of an angle (without a screw), as `simulate_drive` takes it.

    Raises
    ------
    InputError : nothing of that name, no screw, or no motor.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> train = kt.actuators.train_of(model, "actuator")
    >>> train.gear.ratio, float(train.screw.lead)
    (5.2, 0.003)
    """
    if name in model.drives and name not in model.actuators:
        raise InputError(f"Drive {name!r} has no motor: there is no drive train. Give it one.")
    if name not in model.actuators:
        raise InputError(f"The model has no active member {name!r}, and no drive of an angle. {nearest(name, model.actuators)}")
    one = model.actuators[name]
    screw, gear, motor, amplifier = parts_of(model, one)
    what, wanted = (
        ("Active member", (("screw", screw), ("motor", motor))) if isinstance(one, Active) else ("Drive", (("motor", motor),))
    )
    lacks = " and no ".join(word for word, part in wanted if part is None)
    if lacks or motor is None:
        raise InputError(f"{what} {name!r} has no {lacks}: there is no drive train. Give it one.")
    return DriveTrain(screw=screw, motor=motor, gear=gear or Gear(ratio=1.0), amplifier=amplifier)
