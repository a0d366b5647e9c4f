"""One step of an implicit method: Newton's method for accelerations a and row forces N.

With positions x1 = p + s a and velocities v1 = q + c a at the end of the step, M a + J^T N = f at a point (xe, ve) of it and
the rows at its end hold. Midpoint rule with discrete gradients (Gonzalez 1999, Physica D 132, 165): xe = (x0 + x1)/2,
ve = (x1 - x0)/h; rows are quadratic, so J at the midpoint is their discrete gradient, and bars with a law pull by their secant:
(V(L1) - V(L0))/((L1^2 - L0^2)/2) along the middle of the two positions. Generalised alpha (Arnold & Brüls 2007, Multibody
System Dynamics 18, 185): xe = x1, ve = v1.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.integrate.state import Control, Memory
from kinetruss.kernels.solve.kkt import factor, prepare_rows, row_gaps, row_pulls_off, solve
from kinetruss.kernels.steps.tangent import tangent_factor, tangent_solve
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.continua import swap_continua
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import law_energy, law_tension, pull, stretched
from kinetruss.kernels.structure.mass import direction, mass_times
from kinetruss.kernels.structure.plan import CABLE, GREEN
from kinetruss.kernels.structure.structure import Structure

__all__ = ["secant", "solve_step"]

MOST = 60
SETTLED = 1e-14
"""Change of a position, in lengths of members, below which nothing is left to gain."""


@kernel_bare
def secant(law, k, l0, c, L0, L1, h):  # type: ignore[no-untyped-def]
    """Pull over length (N/m) of a bar that goes from L0 to L1 (m) in h (s): its work is exactly the energy it takes."""
    mean = 0.5 * (L0 + L1)
    damped = c * (L1 - L0) / (h * mean)
    if law == GREEN:
        return 0.25 * k * (L0 * L0 + L1 * L1 - 2.0 * l0 * l0) / (l0 * l0) + damped
    if law == CABLE and min(L0, L1) < l0:
        if abs(L1 - L0) < 1e-9 * l0:
            return pull(law, k, l0, c, mean, (L1 - L0) / h) / mean
        stored = law_energy(law, k, l0, L1) - law_energy(law, k, l0, L0)
        return max(0.0, stored / (mean * (L1 - L0)) + (damped if mean > l0 else 0.0))
    return max(0.0, k * (mean - l0) / mean + damped) if law == CABLE else k * (mean - l0) / mean + damped


@kernel_bare
def _swap_laws(s: Structure, x0, x1, xe, ve, h, f):  # type: ignore[no-untyped-def]
    """Replace the tensions of laws at (xe, ve) in f by their secants."""
    for j in range(s.law_A.size):
        A, B = s.law_A[j], s.law_B[j]
        L, u, Ld = stretched(xe, ve, A, B)
        k, l0, c = s.law[j, 0], s.law[j, 1], s.law[j, 2]
        change = secant(s.law_kind[j], k, l0, c, direction(x0, A, B)[0], direction(x1, A, B)[0], h) * L - law_tension(
            s, j, L, Ld
        )
        for i in range(3):
            f[A + i] += change * u[i]
            f[B + i] -= change * u[i]


@kernel_bare
def _unbalanced(eq: Equations, ws, x, a, N, f, h):  # type: ignore[no-untyped-def]
    """f -= M a + J^T N, with the gradients in ws; h (3 n,) is room."""
    mass_times(eq, x, a, h)
    for c in range(f.size):
        f[c] -= h[c]
    row_pulls_off(eq, ws, N, f)


@kernel_bare
def _place(free, work, s, c, h, midpoint):  # type: ignore[no-untyped-def]
    """x1, v1 and the point of the equations from the accelerations work[6]; work: x0, v0, x1, v1, xe, ve, a, p, q, f, da, h."""
    x0, x1, v1, xe, ve, a, p, q = work[0], work[2], work[3], work[4], work[5], work[6], work[7], work[8]
    for i in range(free.size):
        j = free[i]
        x1[j] = p[j] + s * a[j]
        v1[j] = q[j] + c * a[j]
    for j in range(x0.size):
        xe[j] = 0.5 * (x0[j] + x1[j]) if midpoint else x1[j]
        ve[j] = (x1[j] - x0[j]) / h if midpoint else v1[j]


@kernel_bare
def solve_step(  # type: ignore[no-untyped-def]
    eq: Equations, ws: Workspace, user, control: Control, memory: Memory, work, aim_1, N, dN, phi, s, c, h, t_1, midpoint
):
    """Find a in work[6] and N (rows,) of a step of h (s) to t_1, from the values there. True if they settled.

    s, c : parts of a in x1 and v1. aim_1 (3, rows), phi, dN (rows,) : room.
    """
    free, tight, size = (
        eq.free,
        control.tolerance * control.size,
        control.size,
    )
    x0, x1, v1, xe, ve, a, f, da, room = work[0], work[2], work[3], work[4], work[5], work[6], work[9], work[10], work[11]
    prepare_rows(eq, ws, t_1, x1, v1)
    aim = ws.aim
    for k in range(3):
        for j in range(N.size):
            aim_1[k, j] = aim[k, j]
    t_e = t_1 - 0.5 * h if midpoint else t_1
    if midpoint:
        prepare_rows(eq, ws, t_e, xe, ve)
    stiff, last = control.place.size > 0, math.inf
    for turn in range(MOST):
        _place(free, work, s, c, h, midpoint)
        applied(eq, user, t_e, xe, ve, f)
        if midpoint:
            _swap_laws(eq, x0, x1, xe, ve, h, f)
        if midpoint and eq.edge_A.size:
            swap_continua(eq, x0, x1, xe, f)
        memory.pivot = factor(eq, ws, xe)
        _unbalanced(eq, ws, xe, a, N, f, room)
        row_gaps(eq, x1, aim_1, phi)
        for k in range(phi.size):
            phi[k] /= -s
        for j in range(da.size):
            da[j] = 0.0
        if stiff:
            half = 0.5 if midpoint else 1.0
            if turn % 4 == 0:
                tangent_factor(eq, ws, control, xe, ve, N, half * s, half * c)
            tangent_solve(eq, control, f, phi, da, dN)
        else:
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
        if change <= SETTLED * size or (turn > 1 and change <= tight and change > 0.3 * last):
            _place(free, work, s, c, h, midpoint)
            return True
        last = change
    return False
