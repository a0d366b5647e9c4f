"""Equations of a drive train: what feeds the motor, how the drive accelerates, where its power goes."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from kinetruss.actuators.trains.shaft import Shaft, shaft_of
from kinetruss.errors import InputError
from kinetruss.model import DriveTrain

__all__ = ["Feed", "Mode", "Piece", "Plant", "Seen", "observe", "plant_of", "rates"]


@dataclass(frozen=True, slots=True)
class Plant:
    """Constants of a drive train at its motor's shaft. source : what the gain gives, ``current`` or ``voltage``.

    Limits that nobody gives are infinite. mass : kg, moves with the length; kg m^2, turns with the angle. inductive : the
    current is a state of its own.
    """

    shaft: Shaft
    mass: float
    resistance: float
    inductance: float
    torque_constant: float
    emf_constant: float
    source: str
    gain: float
    max_input: float
    max_voltage: float
    max_current: float
    max_rate: float

    @property
    def inductive(self) -> bool:
        """True where a voltage drives the current through an inductance."""
        return self.source == "voltage" and self.inductance > 0


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of time without a kink: command(t, length, rate, current) V or A; thrust(t, length) N."""

    command: Callable[[float, float, float, float], float]
    thrust: Callable[[float, float], float]


@dataclass(frozen=True, slots=True)
class Mode:
    """direction : of the motion, 0 sticks. held : by the speed limit; over : beyond it. limited : sign of a limited current."""

    direction: int
    held: bool = False
    over: bool = False
    limited: int = 0


class Feed(NamedTuple):
    """What reaches the motor. over_* : how far what is wanted exceeds each limit (negative: below it)."""

    command: float
    driving: float
    current: float
    voltage: float
    over_input: float
    over_voltage: float
    over_current: float


class Seen(NamedTuple):
    """Everything about one instant; powers in W."""

    feed: Feed
    current: float
    voltage: float
    current_rate: float
    acceleration: float
    thrust: float
    screw_torque: float
    electrical: float
    copper: float
    motor: float
    gear: float
    screw: float
    actuator: float


# what counts as beyond a limit: a command exactly at it does not saturate
SLACK = 1e-9


def plant_of(train: DriveTrain, source: str, mass: float) -> Plant:
    """Constants of a train that is fed by a voltage or a current (`source`), or by its amplifier where it has one.

    Raises
    ------
    InputError : no resistance where a voltage must give a current; a mass that would jam the screw.
    """
    motor, amplifier, shaft = train.motor, train.amplifier, shaft_of(train)
    if amplifier is not None and source == "current":
        raise InputError("The drive has an amplifier: its input is a voltage. Give voltage instead of current.")
    if amplifier is not None:
        source = "current" if amplifier.current_gain is not None else "voltage"
    if motor.resistance == 0 and (motor.inductance == 0 or source == "current") and not _pure_current(train, source):
        raise InputError("A motor without winding resistance has no finite current at a voltage. Give its resistance.")
    rotor = shaft.inertia * shaft.speed
    if mass * shaft.down >= rotor:
        what, unit, locks = ("An inertia", "kg m^2", "gear") if shaft.turns else ("A mass", "kg", "screw")
        raise InputError(
            f"{what} of {mass:g} {unit} jams the self-locking {locks} whenever it drives it: at most {rotor / shaft.down:.4g} "
            f"{unit} for this rotor. Take less, more rotor inertia or a larger gear ratio."
        )
    return Plant(
        shaft=shaft,
        mass=mass,
        resistance=motor.resistance,
        inductance=motor.inductance,
        source=source,
        torque_constant=motor.torque_constant,
        emf_constant=motor.emf_constant,
        gain=1.0 if amplifier is None else amplifier.gain,
        max_input=_least(amplifier.max_input if amplifier else None),
        max_voltage=_least(motor.max_voltage, amplifier.max_voltage if amplifier else None),
        max_current=_least(
            motor.max_current,
            amplifier.max_current if amplifier else None,
            None if motor.max_torque is None else motor.max_torque / motor.torque_constant,
        ),
        max_rate=_least(motor.max_speed) / shaft.speed,
    )


def _pure_current(train: DriveTrain, source: str) -> bool:
    given = train.motor.max_voltage is not None or (train.amplifier is not None and train.amplifier.max_voltage is not None)
    return source == "current" and not given


def _least(*limits: float | None) -> float:
    return min((limit for limit in limits if limit is not None), default=math.inf)


def _clip(value: float, limit: float) -> float:
    return limit if value > limit else -limit if value < -limit else value


def feed(plant: Plant, piece: Piece, t: float, length: float, rate: float, current: float) -> Feed:
    """Command, through the amplifier and its limits, to voltage and current of the motor.

    A source of current gives what its voltage limit leaves; a source of voltage is held back by its current limit. With
    inductance `current` is what flows, and `driving` the voltage at the winding; else the current follows at once.
    """
    command = piece.command(t, length, rate, current)
    wanted = plant.gain * _clip(command, plant.max_input)
    emf = plant.emf_constant * plant.shaft.speed * rate
    over_input = abs(command) - plant.max_input * (1 + SLACK)
    if plant.source == "current":
        flowing = _clip(wanted, plant.max_current)
        voltage = plant.resistance * flowing + emf
        over_voltage = abs(voltage) - plant.max_voltage * (1 + SLACK)
        if over_voltage > 0:
            flowing = (_clip(voltage, plant.max_voltage) - emf) / plant.resistance
            voltage = plant.resistance * flowing + emf
        over_current = abs(wanted) - plant.max_current * (1 + SLACK)
        return Feed(command, wanted, flowing, voltage, over_input, over_voltage, over_current)
    driving = _clip(wanted, plant.max_voltage)
    over_voltage = abs(wanted) - plant.max_voltage * (1 + SLACK)
    if plant.inductive:
        return Feed(command, driving, current, driving, over_input, over_voltage, -math.inf)
    free = (driving - emf) / plant.resistance
    flowing = _clip(free, plant.max_current)
    over_current = abs(free) - plant.max_current * (1 + SLACK)
    return Feed(command, driving, flowing, plant.resistance * flowing + emf, over_input, over_voltage, over_current)


def observe(plant: Plant, piece: Piece, mode: Mode, t: float, state: tuple[float, float, float]) -> Seen:
    """Forces, motion and powers at one instant; state : length m, rate m/s, current A (used where it is a state)."""
    length, rate, current = state
    shaft, direction = plant.shaft, mode.direction
    given = feed(plant, piece, t, length, rate, current)
    load = piece.thrust(t, length)
    flowing, voltage, change = given.current, given.voltage, 0.0
    if mode.held:
        flowing = direction * shaft.needed(direction, load) / plant.torque_constant
    speed = shaft.speed * rate
    if mode.held or mode.limited:
        voltage = plant.resistance * flowing + plant.emf_constant * speed
    elif plant.inductive:
        change = (voltage - plant.resistance * flowing - plant.emf_constant * speed) / plant.inductance
    moving = direction != 0 and not mode.held
    acceleration = shaft.acceleration(direction, plant.torque_constant * flowing, load, plant.mass) if moving else 0.0
    thrust = load + plant.mass * acceleration
    against = direction * thrust
    torque = direction * (against * shaft.screw_up if against >= 0 else -against * shaft.screw_down)
    through = direction * shaft.resistance(against) * speed
    screw_power, work = torque * rate / shaft.lead, thrust * rate
    return Seen(
        given,
        flowing,
        voltage,
        change,
        acceleration,
        thrust,
        torque,
        voltage * flowing,
        plant.resistance * flowing**2,
        shaft.friction * abs(speed) + (plant.emf_constant - plant.torque_constant) * speed * flowing,
        through - screw_power,
        screw_power - work,
        work,
    )


def rates(plant: Plant, piece: Piece, mode: Mode, t: float, y: list[float]) -> list[float]:
    """Derivatives of length, rate, current, and of the energies of `Seen`, in its order."""
    seen = observe(plant, piece, mode, t, (y[0], y[1], y[2]))
    rate = y[1] if mode.direction else 0.0
    return [rate, seen.acceleration, seen.current_rate, *seen[7:]]
