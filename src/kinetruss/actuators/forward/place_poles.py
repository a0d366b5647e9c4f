"""Gains of a position loop by pole placement."""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.actuators.forward.drive_model import DriveModel, drive_model_of
from kinetruss.errors import InputError
from kinetruss.model import DriveTrain, PositionLoop

__all__ = ["Gains", "gains_of", "place_poles", "refuse_jam"]


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
