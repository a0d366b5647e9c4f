"""Accelerations and forces next to singular positions: refined by what the equations still lack, their lost digits counted.

There the rows of the Jacobian all but depend on each other, most of all where light and heavy bodies meet: the Schur complement
of the equations of motion loses the square of what the equations themselves lose. A residual of the equations gives it back
(`solve_refined` of the kernels). What round-off of the positions does to the forces no solver can mend: it is measured, by
positions that differ in their last digit.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.integrate.samples import NEAR
from kinetruss.kernels.solve.kkt import evaluate

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem
    from kinetruss.kernels.integrate.state import Samples

    Floats = NDArray[np.float64]

__all__ = ["TOO_FEW", "refine"]

LOW = 1e-2
"""Scaled pivot below which the accelerations and forces of a sample are refined."""
TOO_FEW = 1e-7
"""Share of the largest force beyond which the message names what is lost: fewer than seven digits are left."""


def refine(problem: Problem, samples: Samples, done: int, pivot_most: float, lost: Floats) -> None:
    """Refine the first `done` samples next to singular positions, in place.

    pivot_most : the largest scaled pivot met: samples in a singular position itself are left as they are. lost (3,) : the
    largest share of a force that is lost, its time (s), the pivot there; it is kept up to date.
    """
    if problem.motors is not None or not samples.N.shape[1]:
        return
    pivots = samples.diagnostics[:done, 1]
    for k in np.flatnonzero((pivots < LOW) & (pivots >= NEAR * pivot_most) & np.isfinite(samples.a[:done]).all(axis=1)):
        t, x, v = float(samples.times[k]), samples.x[k], samples.v[k]
        a, N = _refined(problem, t, x.copy(), v.copy())
        last_digit = np.spacing(np.abs(x)) * np.random.default_rng(0).choice((-1.0, 1.0), x.size)
        _, other = _refined(problem, t, x + last_digit, v.copy())
        if not (np.isfinite(a).all() and np.isfinite(N).all() and np.isfinite(other).all()):
            continue
        samples.a[k], samples.N[k] = a, N
        # where all forces are round-off, none is lost
        share = float(np.abs(other - N).max() / max(np.abs(N).max(), np.abs(problem.ws.f).max(), 1e-300))
        if share > lost[0]:
            lost[:] = share, t, pivots[k]


def _refined(problem: Problem, t: float, x: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Accelerations (3 n,) and row forces (r,), N, at t (s), x, v (3 n,)."""
    a, N = np.zeros(x.size), np.zeros(len(problem.eq.A))
    problem.ws.pivot[1] = 0.0  # wherever the motion comes from
    evaluate(problem.eq, problem.ws, problem.user.call, t, x, v, a, N)
    return a, N
