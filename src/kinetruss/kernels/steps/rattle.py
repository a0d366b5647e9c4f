"""One step of RATTLE: leapfrog whose row forces keep positions and velocities on the constraints.

v' = v0 + h/2 a, M a + J0^T N = f0, rows at x1 = x0 + h v'; v1 = v' + h/2 b, M b + J1^T P = f1, J1 v1 = rates at the end.
Andersen (1983), Journal of Computational Physics 52, 24; Hairer, Lubich & Wanner (2006), Geometric Numerical Integration,
VII.1.4. Symplectic where forces do not depend on velocities; those that do see the velocity foreseen for the end.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.integrate.state import Control, Memory
from kinetruss.kernels.solve.kkt import factor, prepare_rows, row_along, row_gaps, row_rate_gaps, solve
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["rattle_step"]

MOST = 60
SETTLED = 1e-14


@kernel_bare
def _zero(y):  # type: ignore[no-untyped-def]
    for j in range(y.size):
        y[j] = 0.0


@kernel_bare
def _to_the_rows(eq: Equations, ws, control: Control, memory: Memory, work, aim_1, N, dN, phi, h):  # type: ignore[no-untyped-def]
    """Change a in work[6] and N until x1 in work[2] meets the rows at the end; the metric is that of the mass at the start."""
    free, size = eq.free, control.size
    x0, v0, x1, a, f, da = work[0], work[1], work[2], work[6], work[9], work[10]
    last, s = math.inf, 0.5 * h * h
    _zero(f)
    for turn in range(MOST):
        for i in range(free.size):
            j = free[i]
            x1[j] = x0[j] + h * v0[j] + s * a[j]
        row_gaps(eq, x1, aim_1, phi)
        for k in range(phi.size):
            phi[k] /= -s
        _zero(da)
        solve(eq, ws, f, phi, da, dN)
        change = 0.0
        for i in range(free.size):
            a[free[i]] += da[free[i]]
            change = larger(change, abs(da[free[i]]) * s)
        for k in range(N.size):
            N[k] += dN[k]
        memory.newtons += 1
        if not change < math.inf:
            return False
        if change <= SETTLED * size or (turn > 1 and change <= control.tolerance * size and change > 0.3 * last):
            return True
        last = change
    return False


@kernel_bare
def rattle_step(eq: Equations, ws: Workspace, user, control, memory: Memory, work, aim_1, N, dN, phi, h, t_1):  # type: ignore[no-untyped-def]
    """From x0, v0 in work[0:2] to x1, v1 in work[2:4]; a in work[6], N (rows,) at the end in N. True if it settled."""
    free = eq.free
    x0, v0, x1, v1, a, f = work[0], work[1], work[2], work[3], work[6], work[9]
    t_0, half = t_1 - h, 0.5 * h
    prepare_rows(eq, ws, t_1, x1, v1)
    aim = ws.aim
    for k in range(3):
        for j in range(N.size):
            aim_1[k, j] = aim[k, j]
    prepare_rows(eq, ws, t_0, x0, v0)
    memory.pivot = factor(eq, ws, x0)
    # forces at the start; along the rows, accelerations as foreseen
    applied(eq, user, t_0, x0, v0, f)
    row_along(eq, ws, a, phi)
    solve(eq, ws, f, phi, a, N)
    if not _to_the_rows(eq, ws, control, memory, work, aim_1, N, dN, phi, h):
        return False
    for i in range(free.size):
        j = free[i]
        x1[j] = x0[j] + h * v0[j] + half * h * a[j]
        v1[j] = v0[j] + h * a[j]
    prepare_rows(eq, ws, t_1, x1, v1)
    factor(eq, ws, x1)
    applied(eq, user, t_1, x1, v1, f)
    for i in range(free.size):
        v1[free[i]] = v0[free[i]] + half * a[free[i]]
    row_rate_gaps(eq, ws, x1, v1, ws.aim, phi)
    for k in range(phi.size):
        phi[k] /= -half
    solve(eq, ws, f, phi, a, N)
    good = True
    for i in range(free.size):
        v1[free[i]] += half * a[free[i]]
        good = good and abs(v1[free[i]]) < math.inf
    return good
