"""Operating conditions: the states in which a structure does its motions and carries its load cases."""

from __future__ import annotations

from pydantic import model_validator

from kinetruss.model._record import ForceVector, GravityVector, Mass, Name, Number, Record
from kinetruss.model._table import ReadOnly, Table

__all__ = ["Condition"]


class Condition(Record):
    """A state in which the structure works: weight, payloads, base acceleration, temperature, disturbed actuators.

    gravity : m/s^2, in place of that of the model and of every load case; nodes with a gravity of their own keep it.
    payloads : node -> mass, kg, added there. forces : node -> force, N, added to every load case.
    base_acceleration : m/s^2, of the supports with everything that stands on them, translation; node motions stay relative
        to the base. Weights change to those under gravity minus it (d'Alembert).
    temperature : difference from the temperature of the model's lengths, K, of all members; temperatures : member -> K,
        instead of it. See `Material.thermal_expansion`. Driven lengths stay as commanded, bodies and continua as they are.
    locked : drives held at their value in the model, whatever they are told to do.
    released : drives let go: they carry no force.
    failed : members taken out, with their mass.
    """

    gravity: GravityVector | None = None
    payloads: Table[Name, Mass] = ReadOnly()
    forces: Table[Name, ForceVector] = ReadOnly()
    base_acceleration: GravityVector | None = None
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
