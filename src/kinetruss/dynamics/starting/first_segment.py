"""A segment of a motion that begins in, or right beside, a singular position: one polynomial over it.

There rows of the Jacobian depend on each other, accelerations are differences of small numbers, and explicit steps, whose
stages are off the constraints at first, lose the branch. Along the motion itself everything is smooth. So a(t) is a polynomial
that obeys the equations of motion at instants which all keep their distance from the start, on both sides of it where the
equations do not depend on time, behind it where they do (collocation: Hairer, Norsett & Wanner 1993, section II.7). It is
found by iteration: positions and velocities at the instants are integrals of a(t), brought onto the constraints.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from kinetruss.kernels.solve.kkt import evaluate, project

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["Segment", "State", "segment"]

GAP = 0.4
"""Part of the segment next to the start without instants."""
BOTH_SIDES, ONE_SIDE = 6, 8
"""Instants on each of two sides, or on one."""
ITERATIONS = 40
CONVERGED = 1e-13
"""Most fixed-point iterations, and the change of accelerations that ends them, in parts of the largest acceleration."""
SHORTER, TRIES = 0.7, 10
"""Segments tried, each this part of the one before: one too long is no polynomial, or has an instant in a bad place."""
TAIL = 0.1
"""Share of the last coefficients of the accelerations that velocities feel."""
GOOD, USABLE, WORTH = 3e-10, 1e-6, 0.1
"""Distance of the instants from the constraints before the projection, in parts of the shortest member or of the largest speed:
a segment below GOOD ends the search; the first one below USABLE is kept, and a shorter one instead of it if its distance is
less than WORTH of that."""


@dataclass(frozen=True, eq=False)
class _Plan:
    """Instants s (k,) in parts of the segment. From values there: integrals from 0 to s, once and twice (k, k); the value at
    0, `begin` (k,); the `last` two coefficients (2, k); integrals to the instants `read` (8,), read_once and read_twice (8, k).
    back (8, 8) : from states at `read` the interpolant of a step (see kernels.steps.dop853.interpolate).
    """

    s: NDArray[np.float64]
    once: NDArray[np.float64]
    twice: NDArray[np.float64]
    begin: NDArray[np.float64]
    last: NDArray[np.float64]
    read: NDArray[np.float64]
    read_once: NDArray[np.float64]
    read_twice: NDArray[np.float64]
    back: NDArray[np.float64]


class State(NamedTuple):
    """Where a segment begins: t, s; x, v (3 n,) m, m/s; a first guess of a (3 n,), m/s^2."""

    t: float
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Segment:
    """From `begin` to `end` (s). a0 (3 n,), N0 (rows,) : at the start. x, v, a (3 n,), N (rows,) : at the end.

    dense (8, 2 nf) : the interpolant between. pivot : at the end, scaled. evaluations : taken.
    """

    begin: float
    end: float
    a0: NDArray[np.float64]
    N0: NDArray[np.float64]
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    N: NDArray[np.float64]
    dense: NDArray[np.float64]
    pivot: float
    evaluations: int


@cache
def _plan(both: bool) -> _Plan:
    count = BOTH_SIDES if both else ONE_SIDE
    places = 0.5 - 0.5 * np.cos((2 * np.arange(count) + 1) * np.pi / (2 * count))
    right = GAP + (1 - GAP) * (places - places[0]) / (places[-1] - places[0])
    s = np.concatenate([-right[::-1], right]) if both else right
    k = len(s)
    # the polynomials' own variable goes from -1 to 1 over all instants, and is `low` at the start
    low, scale = (0.0, 1.0) if both else (-1.0, 2.0)

    def local(t: NDArray[np.float64]) -> NDArray[np.float64]:
        return scale * t + low

    fit = np.linalg.inv(chebyshev.chebvander(local(s), k - 1))
    single = np.stack([chebyshev.chebint(c, 1, lbnd=low) for c in fit.T], axis=1) / scale
    double = np.stack([chebyshev.chebint(chebyshev.chebint(c, 1, lbnd=low), 1, lbnd=low) for c in fit.T], axis=1) / scale**2
    r = np.linspace(0.0, 1.0, 8)
    basis = [
        r**0,
        r,
        r * (1 - r),
        r**2 * (1 - r),
        (r * (1 - r)) ** 2,
        r**3 * (1 - r) ** 2,
        (r * (1 - r)) ** 3,
        r**4 * (1 - r) ** 3,
    ]
    return _Plan(
        s=s,
        once=chebyshev.chebvander(local(s), k) @ single,
        twice=chebyshev.chebvander(local(s), k + 1) @ double,
        begin=(chebyshev.chebvander(local(np.zeros(1)), k - 1) @ fit)[0],
        last=np.array(fit[-2:], float),
        read=r,
        read_once=chebyshev.chebvander(local(r), k) @ single,
        read_twice=chebyshev.chebvander(local(r), k + 1) @ double,
        back=np.linalg.inv(np.stack(basis, axis=1)),
    )


def segment(problem: Problem, start: State, span: float, *, both: bool, size: float, tolerance: float) -> Segment | None:
    """The segment from a state, over `span` (s) or less; None where none obeys the constraints.

    both : the equations do not depend on time, so that instants before the start serve too. size : of the smallest member, m.
    tolerance : of the projections.
    """
    best, least, count = None, USABLE, 0
    for _ in range(TRIES):
        found, off, taken = _segment(problem, start, span, _plan(both), size, tolerance)
        count += taken
        if found is not None and off < (least if best is None else WORTH * least):
            best, least = found, off
        if least <= GOOD:
            break
        span *= SHORTER
    return None if best is None else Segment(**{**vars(best), "evaluations": count})


def _segment(
    problem: Problem, start: State, span: float, plan: _Plan, size: float, tolerance: float
) -> tuple[Segment | None, float, int]:
    """The polynomial over `span` (s), how far it is off the constraints, and the evaluations it took."""
    x0, v0, rows, k = start.x, start.v, len(problem.eq.row), len(plan.s)
    a, N, pivots = np.tile(start.a, (k, 1)), np.zeros((k, rows)), np.zeros(k)
    last, off = np.inf, np.inf
    for turn in range(ITERATIONS):
        x = x0 + span * plan.s[:, None] * v0 + span**2 * (plan.twice @ a)
        v = v0 + span * (plan.once @ a)
        speed, new, off = float(np.abs(v).max()), np.zeros_like(a), 0.0
        for i, s in enumerate(plan.s):
            t = start.t + max(span * s, 0.0)
            good, moved, turned = project(problem.eq, problem.ws, t, x[i], v[i], tolerance)
            if not good or not np.isfinite(x[i]).all():
                return None, np.inf, k * turn + i
            pivots[i] = evaluate(problem.eq, problem.ws, problem.user.call, t, x[i], v[i], new[i], N[i])
            off = max(off, moved / size, turned / max(speed, 1e-300))
        change, largest = float(np.abs(new - a).max()), float(np.abs(new).max())
        a = new
        if not np.isfinite(change):
            return None, np.inf, k * (turn + 1)
        if change <= CONVERGED * largest or (turn > 4 and change > 0.7 * last and change < 1e-6 * largest):
            break
        last = change
    else:
        return None, np.inf, k * ITERATIONS
    # what is no polynomial shows in the last coefficients
    off = max(off, TAIL * span * float(np.abs(plan.last @ a).max()) / max(speed, 1e-300))
    free = problem.eq.free
    states = np.concatenate(
        [
            (x0 + span * plan.read[:, None] * v0 + span**2 * (plan.read_twice @ a))[:, free],
            (v0 + span * (plan.read_once @ a))[:, free],
        ],
        axis=1,
    )
    states[-1] = np.concatenate([x[-1][free], v[-1][free]])
    found = Segment(
        begin=start.t,
        end=start.t + span,
        a0=plan.begin @ a,
        N0=plan.begin @ N,
        x=x[-1],
        v=v[-1],
        a=a[-1],
        N=N[-1],
        dense=plan.back @ states,
        pivot=float(pivots[-1]),
        evaluations=0,
    )
    return found, off, k * (turn + 1)
