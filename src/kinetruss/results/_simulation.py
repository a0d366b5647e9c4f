"""A motion that was let go: its histories, what happened on the way, and how well it was integrated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kinetruss.results._records import Forces, Motion, Result

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Occurrence", "Passage", "Simulation"]


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A wanted event came: its name, when (s), and whether its quantity was rising (+1) or falling (-1)."""

    name: str
    time: float
    direction: int

    def __str__(self) -> str:
        return f"{self.name} at t = {self.time:.9g} s, {'rising' if self.direction > 0 else 'falling'}"


@dataclass(frozen=True, slots=True)
class Passage:
    """A singular position was passed: when (s), and the smallest scaled pivot seen there (0 is singular).

    The branch kept is the one that continues the motion: positions and velocities stay continuous.
    """

    time: float
    pivot: float

    def __str__(self) -> str:
        return f"t = {self.time:.6g} s (smallest pivot {self.pivot:.2g})"


@dataclass(frozen=True, kw_only=True, eq=False)
class Simulation(Result):
    """Forward dynamics; see `dynamics.simulate`.

    motion : positions, velocities, accelerations; forces : member forces, reactions, drive forces along it.
    data : energies, momenta and how the integration went, over time.
    """

    motion: Motion
    forces: Forces

    @property
    def events(self) -> tuple[Occurrence, ...]:
        """Wanted events that came, in the order of time."""
        return occurrences(self.data)

    @property
    def passages(self) -> tuple[Passage, ...]:
        """Singular positions passed, in the order of time."""
        return passages(self.data)


def occurrences(data: xr.Dataset) -> tuple[Occurrence, ...]:
    """Events of a dataset of a simulation."""
    if "event_time" not in data:
        return ()
    names, times, ways = (data[key].values.tolist() for key in ("event_name", "event_time", "event_direction"))
    return tuple(Occurrence(str(name), float(t), int(way)) for name, t, way in zip(names, times, ways, strict=True))


def passages(data: xr.Dataset) -> tuple[Passage, ...]:
    """Passages of singular positions of a dataset of a simulation."""
    if "passage_time" not in data:
        return ()
    times, pivots = (data[key].values.tolist() for key in ("passage_time", "passage_pivot"))
    return tuple(Passage(float(t), float(pivot)) for t, pivot in zip(times, pivots, strict=True))
