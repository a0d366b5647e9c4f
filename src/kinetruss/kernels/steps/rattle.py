"""One step of RATTLE: leapfrog whose row forces keep positions and velocities on the constraints.

v' = v0 + h/2 a, M a + J0^T N = f0, rows at x1 = x0 + h v'; v1 = v' + h/2 b, M b + J1^T P = f1, J1 v1 = rates at the end.
Andersen (1983), Journal of Computational Physics 52, 24; Hairer, Lubich & Wanner (2006), Geometric Numerical Integration,
VII.1.4. Symplectic where forces do not depend on velocities; those that do see the velocity foreseen for the end.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate.state import Control, Memory
from kinetruss.kernels.solve.kkt import factor, prepare_rows, row_along, row_gaps, row_rate_gaps, solve
from kinetruss.kernels.steps.step import MOST, Step, change_by, converged, hold_end
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["rattle_step"]


@kernel_bare
def _zero(y: F1) -> None:
    for j in range(y.size):
        y[j] = 0.0


@kernel_bare
def _to_the_rows(eq: Equations, ws: Workspace, control: Control, memory: Memory, step: Step) -> bool:
    """Change a and N until x1 meets the rows at the end; the metric is that of the mass at the start."""
    free, x0, v0, x1, a, gap = eq.free, step.x0, step.v0, step.x1, step.a, step.gap
    last, h, s = math.inf, step.h, step.s
    _zero(step.f)
    # Newton's method for Phi(x1) = 0, J of the start held fixed
    for turn in range(MOST):
        for i in range(free.size):
            j = free[i]
            x1[j] = x0[j] + h * v0[j] + s * a[j]
        row_gaps(eq, x1, step.target, gap)
        for k in range(gap.size):
            gap[k] /= -s
        _zero(step.da)
        solve(eq, ws, step.f, gap, step.da, step.dN)
        change = change_by(free, step)
        memory.newtons += 1
        if not change < math.inf:
            return False
        if converged(control, turn, change, last):
            return True
        last = change
    return False


@kernel_bare
def rattle_step(eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, step: Step) -> bool:
    """From x0, v0 to x1, v1, with N at the end. True if it converged."""
    free, x0, v0, x1, v1, a, f, gap = eq.free, step.x0, step.v0, step.x1, step.v1, step.a, step.f, step.gap
    h, t_0, half = step.h, step.t_1 - step.h, 0.5 * step.h
    step.s = half * h
    hold_end(eq, ws, step)
    prepare_rows(eq, ws, t_0, x0, v0)
    memory.pivot = factor(eq, ws, x0)
    # forces at the start; along the rows, accelerations as foreseen
    applied(eq, user, t_0, x0, v0, f)
    row_along(eq, ws, a, gap)
    solve(eq, ws, f, gap, a, step.N)
    if not _to_the_rows(eq, ws, control, memory, step):
        return False
    # x1 = x0 + h v', v' = v0 + h/2 a; the velocity foreseen for the forces at the end
    for i in range(free.size):
        j = free[i]
        x1[j] = x0[j] + h * v0[j] + half * h * a[j]
        v1[j] = v0[j] + h * a[j]
    prepare_rows(eq, ws, step.t_1, x1, v1)
    factor(eq, ws, x1)
    applied(eq, user, step.t_1, x1, v1, f)
    # v' = v0 + h/2 a
    for i in range(free.size):
        v1[free[i]] = v0[free[i]] + half * a[free[i]]
    row_rate_gaps(eq, ws, x1, v1, ws.target, gap)
    # J b = -(J v' - rates)/(h/2)
    for k in range(gap.size):
        gap[k] /= -half
    solve(eq, ws, f, gap, a, step.N)
    good = True
    # v1 = v' + h/2 b
    for i in range(free.size):
        v1[free[i]] += half * a[free[i]]
        good = good and abs(v1[free[i]]) < math.inf
    return good
