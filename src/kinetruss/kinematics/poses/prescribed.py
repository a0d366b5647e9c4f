"""The configurations of a grid of places of a node that fixes them: swept with the node prescribed and the drives released.

So the sweep also passes positions in which the drives do not hold the structure.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kinematics.given.support import support_history
from kinetruss.kinematics.path.follow import follow_path
from kinetruss.kinematics.path.redundant import Path
from kinetruss.kinematics.targets.inverse import release
from kinetruss.mechanics import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Slice", "places"]

STEPS = 25
"""Samples on the way from the start to the slice."""


@dataclass(frozen=True, eq=False)
class Slice:
    """Input of the sweep: the system, the node, two of its axes, their values u and v, and the level of all coordinates."""

    system: System
    node: str
    axes: tuple[int, int]
    u: NDArray[np.float64]
    v: NDArray[np.float64]
    level: NDArray[np.float64]
    least: float

    @cached_property
    def released(self) -> System:
        """The system with the node prescribed in place of the drives."""
        first = 3 * self.system.node_index(self.node)
        return release(self.system, tuple(range(first, first + self.system.dim)))


def places(cut: Slice) -> NDArray[np.float64]:
    """Flat positions (v, u, 3 n); NaN out of reach.

    From the start to the slice along its lines, first all rows from the line through the start, then all columns: a place is
    reached if one of the two paths leads to it by steps that Newton's method can follow.
    """
    x = np.full((len(cut.v), len(cut.u), cut.system.x0.size), np.nan)
    _sweep(cut, x, swapped=False)
    _sweep(cut, x, swapped=True)
    return x


def _sweep(cut: Slice, x: NDArray[np.float64], *, swapped: bool) -> None:
    """Fill x (along, across, 3 n): from the start to the slice, along the line through it, then all lines that cross it."""
    first, second = (cut.u, cut.v) if swapped else (cut.v, cut.u)
    one, other = cut.axes if swapped else cut.axes[::-1]
    here = cut.system.x0.reshape(-1)[cut.released.coordinate_drive[:, 0]]
    entry = cut.level.copy()
    entry[other] = np.clip(here[other], second[0], second[-1])
    entry[one] = np.clip(here[one], first[0], first[-1])
    for k, place, state in _line(cut, _way(cut, here, entry), entry, one, first):
        for j, _, flat in _line(cut, state, place, other, second):
            row, column = (j, k) if swapped else (k, j)
            if np.isnan(x[row, column, 0]):
                x[row, column] = flat


def _way(cut: Slice, here: NDArray[np.float64], entry: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Flat positions with the point at `entry`, reached from the model's configuration, or None."""
    states = _reached(cut, here + np.linspace(0, 1, STEPS)[:, None] * (entry - here), cut.system.x0.reshape(-1))
    return states[-1] if len(states) == STEPS else None


def _line(cut: Slice, state: Any, place: NDArray[np.float64], axis: int, values: NDArray[np.float64]) -> Any:
    """(index, place, flat positions) of the values on one axis that are reached from `place`, upwards and downwards."""
    if state is None:
        return
    middle = int(np.searchsorted(values, place[axis]))
    for order in (range(middle, len(values)), range(middle - 1, -1, -1)):
        way = np.repeat(place[None], len(order) + 1, axis=0)
        way[1:, axis] = values[list(order)]
        yield from zip(order, way[1:], _reached(cut, way, state)[1:], strict=False)


def _reached(cut: Slice, way: NDArray[np.float64], state: NDArray[np.float64]) -> NDArray[np.float64]:
    """Flat positions (good, 3 n) along places (k, dim) of the point, from a state at the first of them."""
    t = np.arange(len(way), dtype=float)
    still = np.zeros_like(way)
    supports = support_history(cut.released, np.zeros(len(way)))
    x, v, a = (np.ascontiguousarray(np.hstack([one, y])) for one, y in zip((way, still, still), supports, strict=True))
    path = Path(t=t, drive=(way, still, still), moving=(x, v, a))
    found = follow_path(cut.released, path, "workspace", start=state.reshape(-1, 3)[:, : cut.system.dim], least=cut.least)
    position = found.data["position"].values
    full = np.zeros((len(position), len(cut.system.nodes), 3))
    full[:, :, : cut.system.dim] = position
    return full.reshape(len(position), -1)
