"""Changes of mode and wanted events within a step, as roots of its interpolant."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import brentq

from kinetruss.kernels._march_state import COORDINATE, LENGTH

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["crossed", "first_change", "user_values"]

LOOKS = 4
"""Places within a step at which a change is looked for."""
HALVINGS = 40

Values = Callable[[float, Any], Any]


def first_change(
    watch: tuple[list[tuple[int, str]], Values], start: tuple[float, NDArray[np.float64]], dense: Any
) -> tuple[tuple[int, str] | None, float]:  # fmt: skip
    """The first fall of a watched value through zero: motor and name, and when (s); else None and its end."""
    names, values = watch
    places = np.linspace(dense.t_min, dense.t_max, LOOKS + 1)
    table = [values(*start), *(values(place, dense(place)) for place in places[1:])]
    name, first = None, float(dense.t_max)
    for i, label in enumerate(names):

        def value(t: float, i: int = i) -> float:
            return float(values(t, dense(t))[i])

        old, at = table[0][i], places[0]
        for place, row in zip(places[1:], table[1:], strict=True):
            new = row[i]
            if old == 0 > new:
                old, at = _rise(value, at, place)
            if old > 0 >= new:
                root = _root(value, at, place)
                if name is None or root < first:
                    name, first = label, root
                break
            old, at = new, place
    return name, first


def _rise(value: Callable[[float], float], begin: float, end: float) -> tuple[float, float]:
    """Where what starts at zero, and is below zero at `end`, is above it in between: value and place; else zero."""
    for k in range(1, HALVINGS):
        place = begin + (end - begin) * 0.5**k
        if (found := value(place)) > 0:
            return found, place
    return 0.0, begin


def _root(value: Callable[[float], float], begin: float, end: float) -> float:
    # the state at the beginning of a step is projected, its interpolant is not: they differ by less than the tolerance
    if value(begin) <= 0:
        return begin
    return float(brentq(value, begin, end, xtol=1e-15, rtol=8.9e-16))


def crossed(
    events: Sequence[tuple[int, int, int, float, int, bool]], values: Values, start: tuple[float, NDArray[np.float64]],
    dense: Any, until: float,
) -> list[tuple[int, float, int, float]]:  # fmt: skip
    """Wanted events from the start of a step until a time (s): index, time, direction, value; in the order of time."""
    if not events:
        return []
    places = np.linspace(dense.t_min, until, LOOKS + 1)
    table = [values(*start), *(values(place, dense(place)) for place in places[1:])]
    found = []
    for i, (_, _, _, wanted, direction, _) in enumerate(events):

        def beyond(t: float, i: int = i, wanted: float = wanted) -> float:
            return float(values(t, dense(t))[i] - wanted)

        for a, b, old, new in zip(places[:-1], places[1:], table[:-1], table[1:], strict=True):
            before, behind = old[i] - wanted, new[i] - wanted
            way = 1 if before < 0 <= behind else -1 if before > 0 >= behind else 0
            if way and direction in (0, way):
                inside = beyond(a) * way < 0
                t = float(brentq(beyond, a, b, xtol=1e-15, rtol=8.9e-16)) if inside and behind else float(b if inside else a)
                found.append((i, t, way, float(wanted)))
    return sorted(found, key=lambda one: one[1])


def user_values(events: Any, modes: Any, edge: int, t: float, y: NDArray[np.float64]) -> list[float]:
    """Lengths, coordinates and forces that are watched."""
    x, _ = modes.state(y)
    found, N = [], None
    for kind, a, b, *_ in events:
        if kind == COORDINATE:
            found.append(float(x[a]))
        elif kind == LENGTH:
            found.append(float(np.linalg.norm(x[b : b + 3] - x[a : a + 3])))
        else:
            N = modes.observed(t, edge, y)[3] if N is None else N
            found.append(float(N[a]))
    return found
