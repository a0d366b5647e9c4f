"""Events within a step of SciPy's methods, as roots on its interpolant: ends of modes, and quantities that arrive at a value.

The interpolant is a polynomial in time, of degree 7 (DOP853) or 3 (Radau). What is a straight line in the state, as rate,
current and stroke of a drive alone, is such a polynomial too: kernels.integrate.roots isolates its turning points, between
which it falls through zero once or not at all. Every other end of a mode (friction, saturation, a rate within a structure) has
a kink where a sign changes or needs the equations of the body, so that no polynomial through samples converges: its sign is
looked at in `LOOKS` places of a step.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.optimize import brentq

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


LOOKS = 4
"""Places within a step at which the sign of a value is looked at."""
HALVINGS = 40
CLEAR = 1e-9
"""Bernstein coefficients above this share of the largest: a polynomial that stays above zero, whatever the round-off."""
BAND = 1e-10
"""Distance from its value at which a quantity counts as being there, in parts of its size."""

Values = Callable[[float, Any], Any]


class Interpolant:
    """A step of SciPy's as one product: y(x) = y_0 + sum_i w_i(x) row_i, x from 0 to 1 between `t_min` and `t_max` (s).

    w_i of DOP853: x, x (1 - x), x^2 (1 - x), x^2 (1 - x)^2, ... (Hairer, Norsett & Wanner, Solving ODEs I, II.6); of Radau:
    x, x^2, x^3. SciPy's own call takes as long as several evaluations of a drive.
    """

    def __init__(self, dense: Any) -> None:
        self.t_min, self.t_max = float(dense.t_min), float(dense.t_max)
        self.start, self._length = dense.y_old, float(dense.h)
        self.nested = hasattr(dense, "F")
        self.rows = dense.F if self.nested else dense.Q.T

    def __call__(self, t: float) -> Floats:
        """The state (size,) at t (s)."""
        found: Floats = self.start + np.array(_weights((t - self.t_min) / self._length, self.nested)) @ self.rows
        return found

    def bernstein(self) -> Floats:
        """Coefficients (13, size) of the state in Bernstein's basis, of which every value is a mean."""
        found: Floats = self.start + _to_bernstein(self.nested) @ self.rows
        return found


def _weights(x: Any, nested: bool) -> tuple[Any, ...]:
    if not nested:
        return x, x * x, x * x * x
    y = 1.0 - x
    a = x * y
    b, c = a * x, a * a
    return x, a, b, c, c * x, c * a, c * b


@cache
def _to_bernstein(nested: bool) -> Floats:
    from kinetruss.kernels.integrate.roots import NODES, TO_BERNSTEIN

    found: Floats = TO_BERNSTEIN @ np.array(_weights(NODES, nested)).T
    return found


class ModeEvent(NamedTuple):
    """What ends a mode of a motor: a value falls through zero.

    line : place c, slope s and offset o where the value is the straight line o + s y[c] in the state, else None.
    """

    motor: int
    name: str
    value: Callable[[Any], float]
    line: tuple[int, float, float] | None = None


def first_change(
    events: Sequence[ModeEvent], values: Values, start: tuple[float, Floats], dense: Interpolant
) -> tuple[ModeEvent | None, float]:
    """The first event of a step and its time (s); None and the end of the step where there is none.

    values : of those events that are no straight lines. start : time (s) and state, which the interpolant has but for the
    tolerance of the projection.
    """
    sampled, lines = [one for one in events if one.line is None], [one for one in events if one.line is not None]
    looks = list(_turns(lines, start, dense))
    if sampled:
        even = [dense.t_min + (dense.t_max - dense.t_min) * k / LOOKS for k in range(1, LOOKS)] + [dense.t_max]
        table = zip(values(*start), *(values(place, dense(place)) for place in even), strict=True)
        for i, (one, row) in enumerate(zip(sampled, table, strict=True)):
            looks.append((one, lambda t, i=i: values(t, dense(t))[i], [dense.t_min, *even], row))
    event, first = None, dense.t_max
    for one, value, places, row in looks:
        if (root := _fall(value, places, row)) is not None and (event is None or root < first):
            event, first = one, root
    return event, first


def _turns(lines: Sequence[ModeEvent], start: tuple[float, Floats], dense: Interpolant) -> Iterator[tuple[Any, Any, Any, Any]]:
    """Straight lines that may fall through zero: with their value, the turning points and ends of the step, values there."""
    if not lines:
        return
    begin, end, coefficients = dense.t_min, dense.t_max, dense.bernstein().T.tolist()
    for one in lines:
        c, slope, offset = one.line or (0, 0.0, 0.0)
        b = [offset + slope * y for y in coefficients[c]]
        if min(b) > CLEAR * max(map(abs, b)):
            continue

        def value(t: float, c: int = c, slope: float = slope, offset: float = offset) -> float:
            return float(offset + slope * dense(t)[c])

        places = [begin, *(begin + s * (end - begin) for s in _turning_points(np.array(b))), end]
        yield one, value, places, [float(offset + slope * start[1][c]), *(value(t) for t in places[1:])]


def _turning_points(b: Floats) -> list[float]:
    """Places in (0, 1), sorted, between which the polynomial with the Bernstein coefficients b rises or falls alone."""
    slopes = len(b) * np.diff(b)
    found, _ = _isolated(slopes, 0, BAND * float(np.abs(slopes).max()), 0.0)
    return sorted(float(s) for s, _, _ in found if 0.0 < s < 1.0)


def _isolated(b: Floats, side: int, band: float, level: float) -> tuple[Floats, int]:
    """Arrivals at zero (k, 3) of a polynomial, and the side behind them; see kernels.integrate.roots."""
    from kinetruss.kernels.integrate.roots import DEEPEST, roots

    n = len(b) - 1
    stack, places, spare = np.zeros((DEEPEST + 2, n + 3)), np.zeros((2 * n + 8, 3)), np.zeros(n + 1)
    count, side = roots(b, n, side, band, level, stack, places, spare)
    return places[:count], int(side)


def _fall(value: Callable[[float], float], places: Any, row: Sequence[float]) -> float | None:
    """The first fall of a value through zero between places (s) where it is known; None where there is none."""
    old, at = row[0], places[0]
    for place, new in zip(places[1:], row[1:], strict=True):
        if old == 0 > new:
            old, at = _rise(value, at, place)
        if old > 0 >= new:
            # the state at the beginning of a step is projected, its interpolant is not
            return float(at) if value(at) <= 0 else float(brentq(value, at, place, xtol=1e-15, rtol=8.9e-16))
        old, at = new, place
    return None


def _rise(value: Callable[[float], float], begin: float, end: float) -> tuple[float, float]:
    """Where what starts at zero, and is below zero at `end`, is above it in between: value and place; else zero."""
    for k in range(1, HALVINGS):
        place = begin + (end - begin) * 0.5**k
        if (found := value(place)) > 0:
            return found, place
    return 0.0, begin


def crossed(
    events: Sequence[tuple[Any, ...]],
    values: Values,
    dense: Any,
    until: float,
    sides: NDArray[np.float64],
) -> tuple[list[tuple[int, float, int, float]], NDArray[np.float64]]:
    """All wanted events from the start of a step until a time (s): index, time, direction, value; in the order of time.

    sides (events,) : where every quantity was before (see kernels.integrate.roots), NaN at the start; returned behind the step.
    """
    from kinetruss.kernels.integrate.events import START
    from kinetruss.kernels.integrate.roots import TO_BERNSTEIN

    found, behind, begin = [], sides.copy(), float(dense.t_min)
    known: dict[float, Any] = {}

    def row(t: float) -> Any:
        if t not in known:
            known[t] = values(t, dense(t))
        return known[t]

    for i, (_, _, _, wanted, direction, *_) in enumerate(events):

        def gap(t: float, i: int = i, wanted: float = wanted) -> float:
            return float(row(t)[i] - wanted)

        for a, b, f in _parts(gap, begin, until, abs(wanted)):
            band = BAND * (abs(wanted) + float(np.abs(f).max()))
            if np.isnan(behind[i]):
                behind[i] = np.sign(f[0]) if abs(f[0]) > START * band else 0.0
            level = START * band if np.isnan(sides[i]) and a == begin else 0.0
            places, behind[i] = _isolated(TO_BERNSTEIN @ f, int(behind[i]), band, level)
            for s, way, slope in places:
                if direction * way >= 0:
                    found.append((i, _drawn(gap, a + s * (b - a), slope / (b - a), a, b), int(way), float(wanted)))
    return sorted(found, key=lambda one: one[1]), behind


def _parts(
    value: Callable[[float], float], begin: float, end: float, size: float
) -> Iterator[tuple[float, float, NDArray[np.float64]]]:
    """Parts of a step with samples at Chebyshev's places, so short that the polynomial through them has converged."""
    from kinetruss.kernels.integrate.events import CONVERGED, LAST, NARROWEST
    from kinetruss.kernels.integrate.roots import NODES

    parts = [(begin, end)]
    while parts:
        a, b = parts.pop()
        f = np.array([value(a + (b - a) * s) for s in NODES[:-1]] + [value(b)])
        scale = size + float(np.abs(f).max())
        if not np.abs(LAST @ f).max() <= CONVERGED * scale and b - a > NARROWEST * (end - begin):
            middle = 0.5 * (a + b)
            parts += [(middle, b), (a, middle)]
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
