"""Equations of a drive train, and gains of a position loop around it by pole placement."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from kinetruss.actuators.shafts import Shaft, shaft_of
from kinetruss.errors import InputError
from kinetruss.model import DriveTrain, PositionLoop

ENERGIES = ("electrical_energy", "copper_energy", "motor_loss", "gear_loss", "screw_loss", "actuator_work")
"""The integrals of the powers of an `Observation`, in its order: what is taken, and all that it goes to."""
COLUMNS = {
    "motor_command": ("", "input, as given (V or A)"),
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
"""What is recorded of each motor, in this order."""

Command = Callable[[float, float, float, float], float]
"""Input (V or A) from time, length, rate and current, between two jumps of it."""


@dataclass(frozen=True, slots=True)
class DriveModel:
    """Constants of a drive train at its motor's shaft. source : what the gain gives, ``current`` or ``voltage``.

    Limits that nobody gives are infinite. inductive : the current is a state of its own, as a voltage drives it
    through an inductance.
    """

    shaft: Shaft
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
    inductive: bool


BELOW, HELD, BEYOND = 0, 1, 2
"""Of the speed of a motor: below its limit, held there by the electronics, beyond it."""


@dataclass(slots=True)
class Mode:
    """All that is remembered of a motor beside the state.

    direction : of the motion, 0 sticks at `place` (m, rad). limited : sign of a limited current. saturated : input, voltage,
    current. speed : `BELOW`, `HELD` or `BEYOND`. jammed, fast : s, when it first jammed and went beyond its speed, or NaN.
    """

    direction: int
    limited: int
    place: float
    saturated: list[bool]
    speed: int
    jammed: float
    fast: float

    @classmethod
    def of(cls, row: list[float]) -> Mode:
        """From a row of numbers."""
        direction, limited, place, *saturated, speed, jammed, fast = row
        return cls(int(direction), int(limited), place, [bool(one) for one in saturated], int(speed), jammed, fast)

    def row(self) -> list[float]:
        """As a row of numbers."""
        return [self.direction, self.limited, self.place, *self.saturated, self.speed, self.jammed, self.fast]


class MotorInput(NamedTuple):
    """What reaches the motor. over_* : how far what is wanted exceeds each limit (negative: below it)."""

    command: float
    driving: float
    current: float
    voltage: float
    over_input: float
    over_voltage: float
    over_current: float


class Observation(NamedTuple):
    """A motor at one instant: A, V, A/s, N m, and powers in W, which end in the energies of a state."""

    input: MotorInput
    current: float
    voltage: float
    current_rate: float
    screw_torque: float
    electrical: float
    copper: float
    motor: float
    gear: float
    screw: float
    actuator: float


# what counts as beyond a limit: a command exactly at it does not saturate
SLACK = 1.0 + 1e-9


def drive_model_of(train: DriveTrain, source: str) -> DriveModel:
    """Constants of a train whose input is a voltage or a current (`source`), or that of its amplifier where it has one.

    Raises
    ------
    InputError : no resistance where a voltage must give a current.
    """
    motor, amplifier, shaft = train.motor, train.amplifier, shaft_of(train)
    if amplifier is not None and source == "current":
        raise InputError("The drive has an amplifier: its input is a voltage. Give voltage instead of current.")
    if amplifier is not None:
        source = "current" if amplifier.current_gain is not None else "voltage"
    if motor.resistance == 0 and (motor.inductance == 0 or source == "current") and not _pure_current(train, source):
        raise InputError("A motor without winding resistance has no finite current at a voltage. Give its resistance.")
    return DriveModel(
        shaft=shaft,
        inductive=source == "voltage" and motor.inductance > 0,
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


def motor_input(model: DriveModel, command: Command, t: float, length: float, rate: float, current: float) -> MotorInput:
    """Command, through the amplifier and its limits, to voltage and current of the motor.

    A source of current gives what its voltage limit leaves; a source of voltage is held back by its current limit. With
    inductance `current` is what flows, and `driving` the voltage at the winding; else the current follows at once.
    """
    given = command(t, length, rate, current)
    wanted = model.gain * _clip(given, model.max_input)
    emf = model.emf_constant * model.shaft.speed * rate
    over_input = abs(given) - model.max_input * SLACK
    if model.source == "current":
        flowing = _clip(wanted, model.max_current)
        voltage = model.resistance * flowing + emf
        over_voltage = abs(voltage) - model.max_voltage * SLACK
        if over_voltage > 0:
            flowing = (_clip(voltage, model.max_voltage) - emf) / model.resistance
            voltage = model.resistance * flowing + emf
        over_current = abs(wanted) - model.max_current * SLACK
        return MotorInput(given, wanted, flowing, voltage, over_input, over_voltage, over_current)
    driving = _clip(wanted, model.max_voltage)
    over_voltage = abs(wanted) - model.max_voltage * SLACK
    if model.inductive:
        return MotorInput(given, driving, current, driving, over_input, over_voltage, -math.inf)
    free = (driving - emf) / model.resistance
    flowing = _clip(free, model.max_current)
    over_current = abs(free) - model.max_current * SLACK
    return MotorInput(given, driving, flowing, model.resistance * flowing + emf, over_input, over_voltage, over_current)


def observe(model: DriveModel, given: MotorInput, mode: Mode, rate: float, thrust: float) -> Observation:
    """Electrical and mechanical quantities of a motor with an input, at a rate (m/s), against the whole thrust (N)."""
    shaft, direction = model.shaft, mode.direction
    flowing, voltage, change = given.current, given.voltage, 0.0
    held = mode.speed == HELD
    if held:
        flowing = direction * shaft.needed(direction, thrust) / model.torque_constant
    speed = shaft.speed * rate
    if held or mode.limited:
        voltage = model.resistance * flowing + model.emf_constant * speed
    elif model.inductive:
        change = (voltage - model.resistance * flowing - model.emf_constant * speed) / model.inductance
    against = direction * thrust
    torque = direction * (against * shaft.screw_up if against >= 0 else -against * shaft.screw_down)
    through = direction * shaft.resistance(against) * speed
    screw_power, work = torque * rate / shaft.lead, thrust * rate
    return Observation(
        given,
        flowing,
        voltage,
        change,
        torque,
        voltage * flowing,
        model.resistance * flowing**2,
        shaft.friction * abs(speed) + (model.emf_constant - model.torque_constant) * speed * flowing,
        through - screw_power,
        screw_power - work,
        work,
    )


def stored_energy(model: DriveModel, rate: float, current: float) -> float:
    """J in rotor and winding."""
    winding = 0.5 * model.inductance * current**2 if model.inductive else 0.0
    return 0.5 * model.shaft.inertia * (model.shaft.speed * rate) ** 2 + winding


# Gains of a position loop by pole placement.


@dataclass(frozen=True, slots=True)
class Gains:
    """Input = position (target - length) - rate x rate of length - current x current: V/m, V s/m, V/A.

    Of an angle they are V/rad, V s/rad, V/A.

    order : of the loop, 2, or 3 where the winding's inductance counts.
    """

    position: float
    rate: float
    current: float
    order: int


def place_poles(train: DriveTrain, loop: PositionLoop, mass: float = 0.0) -> Gains:
    """Gains that give the position loop of a drive the poles asked for.

    The drive without its frictions and saturations: J' w' = K_t i with J' = J + m (lead/G)^2 for the `mass` (kg) that moves
    with the length, or the inertia (kg m^2) that turns with the angle, where the lead is 1; a current amplifier gives i = g u,
    a voltage amplifier R i + L i' + K_b w = g u. The loop is

        w^2/(s^2 + 2 zeta w s + w^2), or times p/(s + p) where L counts (a voltage amplifier, inductance above 0).

    Returns
    -------
    Gains.

    Source: state feedback by comparison of coefficients; Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems,
    ch. 7. Friction leaves an error at rest: there is no integral part.

    Examples
    --------
    >>> import kinetruss as kt
    >>> motor = kt.Motor(inertia=1e-3, resistance=1.0, torque_constant=0.1, emf_constant=0.1)
    >>> train = kt.DriveTrain(motor=motor, gear=kt.Gear(ratio=10), amplifier=kt.Amplifier(current_gain=1.0))
    >>> loop = kt.PositionLoop(target="30 deg", settling_time=1.0, damping=0.8)
    >>> gains = kt.actuators.place_poles(train, loop, mass=0.9)
    >>> gains.order, round(gains.rate / gains.position, 6)  # 2 zeta/w
    (2, 0.32)
    """
    model = drive_model_of(train, "voltage")
    refuse_jam(model, mass)
    return gains_of(model, loop, mass)


def refuse_jam(model: DriveModel, mass: float) -> None:
    """InputError where a mass (kg, kg m^2) would jam the self-locking screw or gear whenever it drives it."""
    shaft = model.shaft
    rotor = shaft.inertia * shaft.speed
    if mass * shaft.down >= rotor:
        what, unit, locks = ("An inertia", "kg m^2", "gear") if shaft.turns else ("A mass", "kg", "screw")
        raise InputError(
            f"{what} of {mass:g} {unit} jams the self-locking {locks} whenever it drives it: at most {rotor / shaft.down:.4g} "
            f"{unit} for this rotor. Take less, more rotor inertia or a larger gear ratio."
        )


def gains_of(model: DriveModel, loop: PositionLoop, mass: float) -> Gains:
    """The same from the constants of a drive."""
    w, zeta, shaft = loop.natural_frequency, loop.damping, model.shaft
    # acceleration of the length a unit of current; back-emf a rate of length
    push = model.torque_constant / (shaft.inertia * shaft.speed + mass / shaft.speed)
    emf, gain = model.emf_constant * shaft.speed, model.gain
    if model.source == "current":
        return Gains(position=w**2 / (push * gain), rate=2 * zeta * w / (push * gain), current=0.0, order=2)
    R, L = model.resistance, model.inductance
    if not model.inductive:
        scale = R / (push * gain)
        return Gains(position=w**2 * scale, rate=2 * zeta * w * scale - emf / gain, current=0.0, order=2)
    p = loop.third_pole * w
    return Gains(
        position=w**2 * p * L / (push * gain),
        rate=((w**2 + 2 * zeta * w * p) * L / push - emf) / gain,
        current=((2 * zeta * w + p) * L - R) / gain,
        order=3,
    )
