"""Loads, load cases and moving supports."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated

from pydantic import Field, model_validator

from kinetruss.model._record import ForceVector, GravityVector, Name, Number, Point, Record, Series, Time

__all__ = ["History", "LoadCase", "NodalForce"]


def check_times(times: tuple[float, ...]) -> None:
    """Times must increase; the message names the first that does not."""
    for index, (before, after) in enumerate(pairwise(times), start=1):
        if after <= before:
            raise ValueError(
                f"time goes back or stands still: entry {index + 1} is {after:g} s after {before:g} s. Sort the table by time."
            )


class NodalForce(Record):
    """A force on a node: constant (`force`, N), or a table in time (`times` s, `forces` N; linear between, held outside)."""

    node: Name
    force: ForceVector | None = None
    times: Annotated[tuple[Time, ...], Series] | None = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None

    @model_validator(mode="after")
    def _one_form(self) -> NodalForce:
        if (self.force is None) == (self.forces is None):
            has = "neither a force nor a table of forces" if self.force is None else "both a force and a table of forces"
            raise ValueError(f"has {has}. Give one: force: [..], or times and forces.")
        if self.forces is not None:
            if self.times is None or len(self.times) != len(self.forces) or len(self.times) < 2:
                raise ValueError("the table has not as many times as forces, or less than two. Give one force for each time.")
            check_times(self.times)
        return self


class LoadCase(Record):
    """Which loads act: nodal forces with factors (all with 1 where None), and gravity if it differs from the model's."""

    loads: dict[Name, Number] | None = None
    gravity: GravityVector | None = None


class History(Record):
    """Displacement of a support from where it stands in the model: times (s) and displacements (m), quintic spline between."""

    times: Annotated[tuple[Time, ...], Field(min_length=2), Series]
    displacements: Annotated[tuple[Point, ...], Series]

    @model_validator(mode="after")
    def _table(self) -> History:
        if len(self.times) != len(self.displacements):
            raise ValueError(f"{len(self.times)} times but {len(self.displacements)} displacements. Give one of each.")
        check_times(self.times)
        return self
