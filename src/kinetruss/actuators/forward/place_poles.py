"""Gains of a position loop by pole placement."""

from __future__ import annotations

from dataclasses import dataclass

from kinetruss.actuators.forward.plant import Plant, plant_of
from kinetruss.model import DriveTrain, PositionLoop

__all__ = ["Gains", "place_poles"]


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
    """
    return gains_of(plant_of(train, "voltage", mass), loop)


def gains_of(plant: Plant, loop: PositionLoop) -> Gains:
    """The same from the constants of a plant."""
    w, zeta, shaft = loop.natural_frequency, loop.damping, plant.shaft
    # acceleration of the length a unit of current; back-emf a rate of length
    push = plant.torque_constant / (shaft.inertia * shaft.speed + plant.mass / shaft.speed)
    emf, gain = plant.emf_constant * shaft.speed, plant.gain
    if plant.source == "current":
        return Gains(position=w**2 / (push * gain), rate=2 * zeta * w / (push * gain), current=0.0, order=2)
    R, L = plant.resistance, plant.inductance
    if not plant.inductive:
        scale = R / (push * gain)
        return Gains(position=w**2 * scale, rate=2 * zeta * w * scale - emf / gain, current=0.0, order=2)
    p = loop.third_pole * w
    return Gains(
        position=w**2 * p * L / (push * gain),
        rate=((w**2 + 2 * zeta * w * p) * L / push - emf) / gain,
        current=((2 * zeta * w + p) * L - R) / gain,
        order=3,
    )
