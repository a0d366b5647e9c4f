"""Operating conditions: the states in which a structure does its motions and carries its load cases."""

from __future__ import annotations

from pydantic import model_validator

from kinetruss.model._record import (
    Flag,
    ForceVector,
    GravityVector,
    Mass,
    Name,
    Number,
    Point,
    Record,
    Spin,
    SpinRate,
)
from kinetruss.model._table import ReadOnly, Table

__all__ = ["BaseRotation", "Condition"]


class BaseRotation(Record):
    """A base that rotates with everything that stands on it; node motions stay relative to it.

    angular_velocity, angular_acceleration : rad/s, rad/s^2, along the axes of the base, [about z] in the plane; they hold
        during the whole motion. center : m, the point about which the base rotates, by default the origin.
    gravity_turns : gravity, that of load cases too, keeps its direction in space and so turns as seen from the base; as given
        it is the one at 0 s. By default it stays along the axes of the base. With a constant angular velocity only.
    """

    angular_velocity: Spin | None = None
    angular_acceleration: SpinRate | None = None
    center: Point | None = None
    gravity_turns: Flag = False

    @model_validator(mode="after")
    def _rotates(self) -> BaseRotation:
        if self.angular_velocity is None and self.angular_acceleration is None:
            raise ValueError(
                "has neither angular_velocity nor angular_acceleration. Write for example angular_velocity: [0, 0, 2 rad/s], "
                "in the plane [2 rad/s]."
            )
        if self.gravity_turns and any(self.angular_acceleration or ()):
            raise ValueError(
                "has gravity_turns and an angular_acceleration: the way in which the base has turned then is not known. "
                "Give one of them."
            )
        return self


class Condition(Record):
    """A state in which the structure works: weight, payloads, base acceleration, temperature, disturbed actuators.

    gravity : m/s^2, in place of that of the model and of every load case; nodes with a gravity of their own keep it.
    payloads : node -> mass, kg, added there. forces : node -> force, N, added to every load case.
    base_acceleration : m/s^2, of the supports with everything that stands on them, translation; node motions stay relative
        to the base. Weights change to those under gravity minus it (d'Alembert). Of a base that rotates: of its center.
    base_rotation : in place of that of the model; see `BaseRotation`.
    temperature : difference from the temperature of the model's lengths, K, of all members; temperatures : member -> K,
        instead of it. See `Material.thermal_expansion`. Driven lengths stay as commanded, bodies and continua as they are.
    locked : drives held at their value in the model, whatever their commands are.
    released : drives that carry no force.
    failed : members taken out, with their mass.
    """

    gravity: GravityVector | None = None
    payloads: Table[Name, Mass] = ReadOnly()
    forces: Table[Name, ForceVector] = ReadOnly()
    base_acceleration: GravityVector | None = None
    base_rotation: BaseRotation | None = None
    temperature: Number = 0.0
    temperatures: Table[Name, Number] = ReadOnly()
    locked: tuple[Name, ...] = ()
    released: tuple[Name, ...] = ()
    failed: tuple[Name, ...] = ()

    @model_validator(mode="after")
    def _one_fate(self) -> Condition:
        seen: dict[str, str] = {}
        for fate in ("locked", "released", "failed"):
            for name in getattr(self, fate):
                if name in seen:
                    raise ValueError(f"{name!r} is {seen[name]} and {fate}. Name it once.")
                seen[name] = fate
        return self

    @property
    def moves_otherwise(self) -> bool:
        """True if motions under it are others than without it."""
        changed = (self.temperature, self.temperatures, self.locked, self.released, self.failed)
        return any(bool(one) for one in changed)
