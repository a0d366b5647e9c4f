"""Loads, load cases and moving supports."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, model_validator

from kinetruss.model._record import ForceVector, GravityVector, Name, Number, Point, Record, Series, Time
from kinetruss.model._table import Table

__all__ = ["History", "LoadCase", "NodalForce"]


Shape = Literal["spline", "monotone"]
"""The interpolation of a table."""


def check_times(times: tuple[float, ...]) -> None:
    """Times must increase; the message names the first that does not."""
    for index, (before, after) in enumerate(pairwise(times), start=1):
        if after <= before:
            raise ValueError(
                f"time goes back or stands still: entry {index + 1} is {after:g} s after {before:g} s. Sort the table by time."
            )


def check_table(times: tuple[float, ...], values: tuple[object, ...], what: str) -> None:
    """A table has one value for each time, and its times increase."""
    if len(times) != len(values):
        raise ValueError(f"{len(times)} times but {len(values)} {what}. Give one of each.")
    check_times(times)


class InTime(Record):
    """A value, or a table of values in time."""

    def _one_form(self, one: str, many: str) -> None:
        value, table, times = getattr(self, one), getattr(self, many), getattr(self, "times", None)
        if (value is None) == (table is None):
            has = f"neither a {one} nor a table of {many}" if value is None else f"both a {one} and a table of {many}"
            raise ValueError(f"has {has}. Give one: {one}, or times and {many}.")
        if table is not None:
            if times is None or len(times) != len(table):
                raise ValueError(f"has {len(times or ())} times and {len(table)} {many}. Give one of {many} for each time.")
            if len(times) < 2:
                raise ValueError(f"has a table of {len(times)} times. Give at least two, or one constant {one}.")
            check_times(times)


class NodalForce(InTime):
    """A force on a node: constant, or a table in time.

    node : on which it acts.
    force : constant force, N.
    times, forces : a table, s and N; linear between its points, constant outside.

    >>> import kinetruss as kt
    >>> kt.NodalForce(node="T", force=(0, "-1.5 kN"))
    NodalForce(node='T', force=(0.0, -1500.0))
    """

    node: Name
    force: ForceVector | None = None
    times: Annotated[tuple[Time, ...], Series] | None = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None

    @model_validator(mode="after")
    def _sound(self) -> NodalForce:
        self._one_form("force", "forces")
        return self


class LoadCase(Record):
    """Which loads act.

    loads : name of a load -> factor; all loads with factor 1 where not given.
    gravity : m/s^2, if it differs from that of the model.
    """

    loads: Table[Name, Number] | None = None
    gravity: GravityVector | None = None


class History(Record):
    """Displacement of a support from its position in the model. A run beyond the table is refused.

    times : s.
    displacements : m, one row a time; a quintic spline goes through them.
    shape : ``spline``, or ``monotone``, which never overshoots the points, as in `Spline`.
    """

    times: Annotated[tuple[Time, ...], Field(min_length=2), Series]
    displacements: Annotated[tuple[Point, ...], Series]
    shape: Shape = "spline"

    @model_validator(mode="after")
    def _table(self) -> History:
        check_table(self.times, self.displacements, "displacements")
        return self
