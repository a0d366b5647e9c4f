"""Results of simulations and of drive trains: histories, events, episodes, accuracy of the integration."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, quantity
from kinetruss.model import Spline
from kinetruss.results.arrays import Column, variable
from kinetruss.results.records import Forces, Motion, Result
from kinetruss.results.wide_tables import unit_along

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True, slots=True)
class Episode:
    """An interval in which a drive could not follow its input, or moved without it.

    kind : ``input saturated``, ``voltage saturated``, ``current saturated``, ``speed limit``, ``too fast``, ``stuck``,
    ``driven back``, ``end of stroke``.
    start, end : s. time : s, of the worst. wanted, possible : in `unit`, there; for ``stuck`` the torque that would start it
    and the torque given.
    """

    kind: str
    start: float
    end: float
    time: float
    wanted: float
    possible: float
    unit: str

    @property
    def ratio(self) -> float:
        """Ratio of wanted to possible."""
        return self.wanted / self.possible if self.possible else float("inf")

    def __str__(self) -> str:
        possible = quantity(self.possible, self.unit)
        when = f"from {instant(self.start)} to {instant(self.end)}"
        if self.kind == "end of stroke":
            moved = "angle" if self.unit == "rad" else "length"
            return f"end of stroke at {instant(self.start)}: {moved} {quantity(self.possible, self.unit, 6)}."
        if self.kind == "driven back":
            return f"the load drives the motor {when}."
        if self.kind == "stuck":
            return self._stuck(when)
        if self.kind == "speed limit":
            return f"the motor runs at its largest speed of {possible} {when}."
        if not self.ratio > 1 + 1e-6:
            return f"{self.kind} {when}: at its limit of {possible}."
        more = f"{quantity(self.ratio - 1, '%')} more than {possible}"
        return f"{self.kind} {when}: at {instant(self.time)} it would take {quantity(self.wanted, self.unit)}, {more}."

    def _stuck(self, when: str) -> str:
        missing = self.wanted - self.possible
        wanted, possible, less = (quantity(one, "N m") for one in (self.wanted, self.possible, missing))
        if missing <= 1e-6 * self.wanted:
            return f"stuck {when}, until the motor has the {wanted} that start it."
        return f"stuck {when}: starting takes {wanted} at the motor, it has {possible}, {less} less."


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class DriveRun(Result):
    """Histories of a drive train over time; see `actuators.simulate_drive`.

    episodes : intervals in which it was limited, in order of time.
    """

    episodes: tuple[Episode, ...] = ()

    def trajectory(self, drive: str) -> Spline:
        """The history of the length or angle as a trajectory of a drive or active member: a quintic spline through samples.

        If the acceleration jumps (a step input, a reversal of friction), the spline smooths the jump between two samples.
        """
        moved = "angle" if "angle" in self.data else "length"
        rows, values = (tuple(self.data[name].values.tolist()) for name in ("time", moved))
        # the user chooses the sample spacing; a long interval is not a gap of a measured record
        return Spline(times=rows, values={drive: values}, largest_gap=1e9)


# The result of a simulation: its histories, its events, and the accuracy of the integration.


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
