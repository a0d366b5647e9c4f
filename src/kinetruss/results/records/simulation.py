"""The result of a simulation: its histories, its events, and the accuracy of the integration."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.results.records.arrays import Column, variable
from kinetruss.results.records.records import Forces, Motion, Result
from kinetruss.results.records.units import unit_along

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Occurrence", "Passage", "Simulation", "happened"]


@dataclass(frozen=True, slots=True)
class Occurrence:
    """An event: its name, time (s), direction of its quantity, rising (+1) or falling (-1), and the value there."""

    name: str
    time: float
    direction: int
    value: float

    def __str__(self) -> str:
        return f"{self.name} at t = {self.time:.9g} s, {'rising' if self.direction > 0 else 'falling'}"


@dataclass(frozen=True, slots=True)
class Passage:
    """A passage of a singular position: its time (s), and the smallest scaled pivot there (0 is singular).

    The motion continues on the branch with continuous positions and velocities. `certain` is False if another branch is so
    near that the tolerance cannot distinguish them.
    """

    time: float
    pivot: float
    certain: bool = True

    def __str__(self) -> str:
        doubt = "" if self.certain else ", branch not certain"
        return f"t = {self.time:.6g} s (smallest pivot {self.pivot:.2g}{doubt})"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Simulation(Result):
    """Forward dynamics; see `dynamics.simulate`.

    motion : positions, velocities, accelerations; forces : member forces, reactions, drive forces along it.
    data : energies, momenta and diagnostics of the integration over time.
    """

    motion: Motion
    forces: Forces

    @property
    def events(self) -> tuple[Occurrence, ...]:
        """The events in order of time."""
        return occurrences(self.data)

    @property
    def passages(self) -> tuple[Passage, ...]:
        """The singular positions passed, in order of time."""
        return passages(self.data)


def happened(arrays: Mapping[str, Any]) -> dict[str, Column]:
    """The variables of a simulation without a time axis, from plain arrays.

    events (k, 4) : index of the event, time, direction, value; event_names and event_units of all events; passages (k, 3) :
    time, smallest pivot, 1 if the branch is certain.
    """
    if "events" not in arrays:
        return {}
    events, passed = arrays["events"], arrays["passages"]
    names = np.array([str(arrays["event_names"][int(k)]) for k in events[:, 0]], str)
    units = [str(arrays["event_units"][int(k)]) for k in events[:, 0]]
    unit, own = unit_along("occurrence", units, "event_unit", "m")
    several = {"event_unit": variable(("occurrence",), np.array(units, str), "", "unit of the value")} if own else {}
    one, other = ("occurrence",), ("passage",)
    return {
        "event_name": variable(one, names, "", "event"),
        "event_time": variable(one, events[:, 1].copy(), "s", "time of the event"),
        "event_direction": variable(one, events[:, 2].copy(), "", "1 rising, -1 falling"),
        "event_value": variable(one, events[:, 3].copy(), unit, "value at the event"),
        "passage_time": variable(other, passed[:, 0].copy(), "s", "time of the passage of a singular position"),
        "passage_pivot": variable(other, passed[:, 1].copy(), "", "smallest scaled pivot there"),
        "passage_certain": variable(other, passed[:, 2].copy(), "", "1 if the branch is certain"),
    } | several


def occurrences(data: xr.Dataset) -> tuple[Occurrence, ...]:
    """Events of a dataset of a simulation."""
    if "event_time" not in data:
        return ()
    columns = (data[f"event_{key}"].values.tolist() for key in ("name", "time", "direction", "value"))
    return tuple(Occurrence(str(n), float(t), int(way), float(y)) for n, t, way, y in zip(*columns, strict=True))


def passages(data: xr.Dataset) -> tuple[Passage, ...]:
    """Passages of singular positions of a dataset of a simulation."""
    if "passage_time" not in data:
        return ()
    columns = (data[f"passage_{key}"].values.tolist() for key in ("time", "pivot", "certain"))
    return tuple(Passage(float(t), float(pivot), bool(sure)) for t, pivot, sure in zip(*columns, strict=True))
