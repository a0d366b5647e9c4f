"""A segment of a motion that begins in or near a singular position, as one polynomial.

In a singular position rows of the Jacobian are dependent, and accelerations are differences of small numbers. Explicit
steps lose the branch, because their stages do not satisfy the constraints before the projection. The motion itself is
smooth. So a(t) is a polynomial that satisfies the equations of motion at collocation points (Hairer, Norsett & Wanner
1993, section II.7). All points keep a distance from the start. They lie on both sides of it if the equations do not
depend on time, else after it. A fixed-point iteration finds the polynomial: positions and velocities at the points are
integrals of a(t), projected onto the constraints.
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
"""Fraction of the segment, next to the start, without collocation points."""
BOTH_SIDES = 6
"""Number of collocation points on each side of the start, if they lie on both sides."""
ONE_SIDE = 8
"""Number of collocation points if all lie after the start."""
ITERATIONS = 40
"""Largest number of fixed-point iterations."""
CONVERGED = 1e-13
"""Change of accelerations, as a fraction of the largest one, at which the iteration has converged."""
SHORTER = 0.7
"""Factor from one trial length to the next. A long segment is no polynomial, or has a point near another singularity."""
TRIES = 10
"""Largest number of trial lengths."""
TAIL = 0.1
"""Effect of the last two coefficients of the accelerations on velocities, as a factor."""
GOOD = 3e-10
"""Error of a segment that ends the search. The error is the correction by the projection, relative to the shortest member
or the largest speed."""
USABLE = 1e-6
"""Largest error of a segment that is accepted."""
WORTH = 0.1
"""A shorter segment replaces an accepted one if its error is smaller by this factor."""


@dataclass(frozen=True, eq=False)
class _Plan:
    """Collocation points s (k,) as fractions of the segment, and matrices that act on values there.

    once, twice (k, k) : single and double integrals from 0 to s. begin (k,) : the value at 0. last (2, k) : the last two
    Chebyshev coefficients. read (8,) : instants of the interpolant; read_once, read_twice (8, k) : integrals from 0 to them.
    back (8, 8) : from states at `read` to the interpolant of a step (see kernels.steps.dop853.interpolate).
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
    """The start of a segment: t, s; x, v (3 n,), m, m/s; a first guess of a (3 n,), m/s^2."""

    t: float
    x: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Segment:
    """From `begin` to `end` (s). a0 (3 n,), N0 (rows,) : at the start. x, v, a (3 n,), N (rows,) : at the end.

    dense (8, 2 nf) : the interpolant. pivot : scaled pivot at the end. evaluations : number of evaluations.
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
    # the Chebyshev variable goes from -1 to 1 over all points and is `low` at the start of the segment
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
    """The segment from a state, over `span` (s) or less; None if no segment satisfies the constraints.

    both : the equations do not depend on time, so that points before the start are allowed. size : length of the shortest
    member, m. tolerance : of the projections.
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
    """The polynomial over `span` (s), its error, and the number of evaluations."""
    x0, v0, rows, k = start.x, start.v, len(problem.eq.row), len(plan.s)
    a, N, pivots = np.tile(start.a, (k, 1)), np.zeros((k, rows)), np.zeros(k)
    last, off = np.inf, np.inf
    for turn in range(ITERATIONS):
        # x(s) = x0 + h s v0 + h^2 (double integral of a), v(s) = v0 + h (integral of a), with h = span
        x = x0 + span * plan.s[:, None] * v0 + span**2 * (plan.twice @ a)
        v = v0 + span * (plan.once @ a)
        speed, new, off = float(np.abs(v).max()), np.zeros_like(a), 0.0
        for i, s in enumerate(plan.s):
            # project onto the constraints, then M a + J^T N = f, J a = gamma gives the next a and N at this point
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
    # if a(t) is not resolved by the polynomial, its last coefficients are large
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
