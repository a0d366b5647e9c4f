"""Changes of mode and wanted events within a step, as roots of its interpolant."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import brentq

from kinetruss.kernels.integrate.events import CONVERGED, LAST, NARROWEST, START
from kinetruss.kernels.integrate.roots import DEEPEST, DEGREE, NODES, TO_BERNSTEIN, roots
from kinetruss.kernels.integrate.state import COORDINATE, LENGTH

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["crossed", "first_change", "user_values"]

LOOKS = 4
"""Places within a step at which a change is looked for."""
HALVINGS = 40
BAND = 1e-10
"""Distance from its value at which a quantity counts as being there, in parts of its size."""

Values = Callable[[float, Any], Any]


def first_change(
    watch: tuple[list[tuple[int, str]], Values], start: tuple[float, NDArray[np.float64]], dense: Any
) -> tuple[tuple[int, str] | None, float]:
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
    events: Sequence[tuple[int, int, int, float, int, bool]],
    values: Values,
    dense: Any,
    until: float,
    sides: NDArray[np.float64],
) -> tuple[list[tuple[int, float, int, float]], NDArray[np.float64]]:
    """All wanted events from the start of a step until a time (s): index, time, direction, value; in the order of time.

    sides (events,) : where every quantity was before (see kernels.integrate.roots), NaN at the start; returned behind the step.
    """
    found, behind, begin = [], sides.copy(), float(dense.t_min)
    known: dict[float, Any] = {}

    def row(t: float) -> Any:
        if t not in known:
            known[t] = values(t, dense(t))
        return known[t]

    for i, (_, _, _, wanted, direction, _) in enumerate(events):

        def gap(t: float, i: int = i, wanted: float = wanted) -> float:
            return float(row(t)[i] - wanted)

        for a, b, f in _pieces(gap, begin, until, abs(wanted)):
            band = BAND * (abs(wanted) + float(np.abs(f).max()))
            if np.isnan(behind[i]):
                behind[i] = np.sign(f[0]) if abs(f[0]) > START * band else 0.0
            level = START * band if np.isnan(sides[i]) and a == begin else 0.0
            stack, places, scratch = np.zeros((DEEPEST + 2, DEGREE + 3)), np.zeros((2 * DEGREE + 8, 3)), np.zeros(DEGREE + 1)
            count, behind[i] = roots(TO_BERNSTEIN @ f, DEGREE, int(behind[i]), band, level, stack, places, scratch)
            for s, way, slope in places[:count]:
                if direction * way >= 0:
                    found.append((i, _drawn(gap, a + s * (b - a), slope / (b - a), a, b), int(way), float(wanted)))
    return sorted(found, key=lambda one: one[1]), behind


def _pieces(
    value: Callable[[float], float], begin: float, end: float, size: float
) -> Iterator[tuple[float, float, NDArray[np.float64]]]:
    """Pieces of a step with samples at Chebyshev's places, so short that the polynomial through them has converged."""
    pieces = [(begin, end)]
    while pieces:
        a, b = pieces.pop()
        f = np.array([value(a + (b - a) * s) for s in NODES[:-1]] + [value(b)])
        scale = size + float(np.abs(f).max())
        if not np.abs(LAST @ f).max() <= CONVERGED * scale and b - a > NARROWEST * (end - begin):
            middle = 0.5 * (a + b)
            pieces += [(middle, b), (a, middle)]
            continue
        yield a, b, f


def _drawn(value: Callable[[float], float], t: float, slope: float, begin: float, end: float) -> float:
    """A root of a polynomial, drawn to that of the value itself by Newton's method."""
    for _ in range(4):
        gap = value(t)
        new = t - gap / slope if slope != 0.0 else t
        if gap == 0.0 or not begin <= new <= end or not abs(value(new)) < abs(gap):
            break
        t = new
    return t


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
