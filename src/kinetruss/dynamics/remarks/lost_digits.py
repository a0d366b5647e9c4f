"""Accelerations and forces next to singular positions: refined by what the equations still lack, their lost digits counted.

There the rows of the Jacobian all but depend on each other, most of all where light and heavy bodies meet: the Schur complement
of the equations of motion loses the square of what the equations themselves lose. A residual of the equations gives it back
(iterative refinement: Higham 2002, Accuracy and Stability of Numerical Algorithms, ch. 12). What round-off of the positions
does to the forces no solver can mend: it is measured, by positions that differ in their last digit.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.integrate.samples import NEAR
from kinetruss.kernels.solve.kkt import add_constraint_forces, evaluate, row_along, solve
from kinetruss.kernels.structure.mass import mass_times

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem
    from kinetruss.kernels.integrate.state import Samples

    Floats = NDArray[np.float64]

__all__ = ["TOO_FEW", "refine"]

LOW = 1e-2
"""Scaled pivot below which the accelerations and forces of a sample are refined."""
TURNS = 8
ROUND_OFF = 4 * 2.2e-16
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
    """Accelerations (3 n,) and row forces (r,) at t (s), x, v (3 n,)."""
    eq, ws, free = problem.eq, problem.ws, problem.eq.free
    a, N = np.zeros(x.size), np.zeros(len(eq.A))
    evaluate(eq, ws, problem.user.call, t, x, v, a, N)
    # M a + J^T N = f, J a = gamma, without what prescribed coordinates take
    f, gamma, own = ws.f.copy(), ws.gamma.copy(), np.zeros(x.size)
    own[free] = a[free]
    step, tension, rows, before = np.zeros(x.size), np.zeros(len(N)), np.zeros(len(N)), np.abs(N).max()
    for _ in range(TURNS):
        inertia = np.zeros(x.size)
        mass_times(eq, x, own, inertia)
        force = f - inertia
        add_constraint_forces(eq, ws, N, force)
        row_along(eq, ws, own, rows)
        solve(eq, ws, force, gamma - rows, step, tension)
        size = float(np.abs(tension).max())
        if not ROUND_OFF * np.abs(N).max() < size < 0.5 * before:
            break
        own[free] += step[free]
        N, before = N + tension, size
    a[free] = own[free]
    return a, N
