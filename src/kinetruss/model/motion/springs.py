"""Springs: laws on a coordinate, with stiffness, damping, friction and play."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, model_validator

from kinetruss.model._record import (
    Coordinate,
    Number,
    PositiveRate,
    Record,
    Resisting,
    SpringDamping,
    SpringForce,
    SpringStiffness,
    Width,
)
from kinetruss.model.motion.drives import Measured, turns
from kinetruss.units import Tagged

__all__ = ["Spring"]

_UNITS = {"length": "m, N and s", "angle": "rad, N m and s"}
Points = Annotated[tuple[tuple[Number, Number], ...], Field(min_length=2)]


class Spring(Record):
    """A law on a coordinate: what resists the angle of a hinge, a length, an offset from a line, or a sum of such.

    The coordinate c is given as the drive that would move it (`coordinate`), or as a sum of factor times coordinate (`terms`,
    as of a `Coupling`). The generalised force on it, N or N m, with e = c - rest, is

        -(preload + stiffness s) - damping c' - friction tanh(c'/slip),    s = e outside the play, 0 within it.

    `play` is the half-width of a dead band: s = e - play for e > play, s = e + play for e < -play. `table` replaces the
    stiffness by points (s, force), both ascending, in SI units: between them a monotone cubic (Fritsch & Carlson, SIAM J.
    Numer. Anal. 17 (1980) 238), beyond them straight on. `rest` is by default the value of the coordinate in the model.
    `friction` is Coulomb's, of a given size; `slip` is the rate at which it has 76 % of it. It creeps below, it does not stick.

    Units: stiffness N/m or N m/rad, damping N s/m or N m s/rad, friction and preload N or N m, slip m/s or rad/s. An angle must
    stay within half a turn of `rest`; the moment of a spring wound up by more turns is given as its preload.

    coordinate : on which it acts, as a drive that would move it.
    terms : a sum of coordinates in its place: pairs of coordinate and factor.
    stiffness : N/m or N m/rad.
    rest : value of the coordinate without force, m or rad; by default that in the model.
    damping : N s/m or N m s/rad.
    friction : size of Coulomb's friction, N or N m.
    slip : rate at which the friction has 76 % of its size, m/s or rad/s.
    play : half-width of the dead band, m or rad.
    preload : force at rest, N or N m.
    table : points (deflection, force) in place of the stiffness.
    """

    coordinate: Measured | None = None
    terms: Annotated[tuple[tuple[Measured, Number], ...], Field(min_length=1)] | None = None
    stiffness: SpringStiffness = 0.0
    rest: Coordinate | None = None
    damping: SpringDamping = 0.0
    friction: Resisting = 0.0
    slip: PositiveRate = 1e-3
    play: Width = 0.0
    preload: SpringForce = 0.0
    table: Points | None = None

    @property
    def parts(self) -> tuple[tuple[Any, float], ...]:
        """Coordinates and their factors."""
        return self.terms if self.terms is not None else ((self.coordinate, 1.0),)

    @model_validator(mode="after")
    def _sound(self) -> Spring:
        if (self.coordinate is None) == (self.terms is None):
            raise ValueError("a spring acts on one coordinate or on a sum of them. Give coordinate, or terms.")
        if not (self.stiffness or self.damping or self.friction or self.preload or self.table):
            raise ValueError("the spring has no force. Give stiffness, damping, friction, preload or table.")
        if self.table and self.stiffness:
            raise ValueError("stiffness and table both state the force. Leave one out.")
        if self.play and not (self.stiffness or self.table):
            raise ValueError("play is the dead band of a stiffness. Give stiffness, or leave play out.")
        if self.play and self.preload:
            raise ValueError("a preload closes the play: the force within it is 0. Leave one out.")
        for before, after in pairwise(self.table or ()):
            if after[0] <= before[0] or after[1] < before[1]:
                raise ValueError(f"table: {after} follows {before}. Give ascending deflections, and forces that do not fall.")
        self._check_units()
        return self

    def _check_units(self) -> None:
        """Units that were written must be those of the coordinate; the numbers then are plain ones."""
        kinds = {"angle" if turns(one) else "length" for one, _ in self.parts}
        for name in ("stiffness", "rest", "damping", "friction", "slip", "play", "preload"):
            value = getattr(self, name)
            if isinstance(value, Tagged):
                if value.quantity and self.coordinate is not None and value.quantity not in kinds:
                    kind = kinds.pop()
                    raise ValueError(
                        f"{name} has the unit of {'a length' if kind == 'angle' else 'an angle'}. Use {_UNITS[kind]}."
                    )
                self.__dict__[name] = float(value)

    if TYPE_CHECKING:

        def __init__(self, *, coordinate: Any = None, terms: Any = None, table: Any = None, **numbers: Any) -> None: ...
