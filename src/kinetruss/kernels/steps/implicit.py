"""One step of an implicit method: Newton's method for accelerations a and row forces N.

With positions x1 = p + s a and velocities v1 = q + c a at the end of the step, M a + J^T N = f at a point (xe, ve) of it and
the rows at its end hold. Midpoint rule with discrete gradients (Gonzalez 1999, Physica D 132, 165): xe = (x0 + x1)/2,
ve = (x1 - x0)/h; rows are quadratic, so J at the midpoint is their discrete gradient, and bars with a law have the tension of
their secant: (V(L1) - V(L0))/((L1^2 - L0^2)/2) along the middle of the two positions. Generalised alpha (Arnold & Brüls 2007,
Multibody System Dynamics 18, 185): xe = x1, ve = v1.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, I1
from kinetruss.kernels.constraints.springs import swap_springs
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Memory
from kinetruss.kernels.solve.kkt import add_constraint_forces, factor, prepare_rows, row_gaps, solve
from kinetruss.kernels.steps.step import MOST, Step, change_by, converged, hold_end
from kinetruss.kernels.steps.tangent import tangent_factor, tangent_solve
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.continua import swap_continua
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import bar_tension, law_energy, law_tension, length_rate
from kinetruss.kernels.structure.mass import direction, mass_times
from kinetruss.kernels.structure.plan import CABLE, GREEN
from kinetruss.kernels.structure.structure import Structure

__all__ = ["secant", "solve_step"]


@kernel_bare
def secant(law: int, k: float, l0: float, c: float, L0: float, L1: float, h: float) -> float:
    """Pull over length (N/m) of a bar that goes from L0 to L1 (m) in h (s): its work is exactly the energy it takes."""
    mean = 0.5 * (L0 + L1)
    damped = c * (L1 - L0) / (h * mean)
    if law == GREEN:
        return 0.25 * k * (L0 * L0 + L1 * L1 - 2.0 * l0 * l0) / (l0 * l0) + damped
    if law == CABLE and min(L0, L1) < l0:
        if abs(L1 - L0) < 1e-9 * l0:
            return bar_tension(law, k, l0, c, mean, (L1 - L0) / h) / mean
        stored = law_energy(law, k, l0, L1) - law_energy(law, k, l0, L0)
        return max(0.0, stored / (mean * (L1 - L0)) + (damped if mean > l0 else 0.0))
    return max(0.0, k * (mean - l0) / mean + damped) if law == CABLE else k * (mean - l0) / mean + damped


@kernel_bare
def _swap_laws(s: Structure, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """Replace the tensions of laws at (xe, ve) in f by their secants."""
    # discrete gradient of each bar: (V(L1) - V(L0))/((L1^2 - L0^2)/2) L instead of N(L)
    for j in range(s.law_A.size):
        A, B = s.law_A[j], s.law_B[j]
        L, u, Ld = length_rate(xe, ve, A, B)
        k, l0, c = s.law[j, 0], s.law[j, 1], s.law[j, 2]
        change = secant(s.law_kind[j], k, l0, c, direction(x0, A, B)[0], direction(x1, A, B)[0], h) * L - law_tension(
            s, j, L, Ld
        )
        for i in range(3):
            f[A + i] += change * u[i]
            f[B + i] -= change * u[i]


@kernel_bare
def _unbalanced(eq: Equations, ws: Workspace, x: F1, a: F1, N: F1, f: F1, h: F1) -> None:
    """f -= M a + J^T N, with the gradients in ws; h (3 n,) is scratch."""
    mass_times(eq, x, a, h)
    # f - M a
    for c in range(f.size):
        f[c] -= h[c]
    add_constraint_forces(eq, ws, N, f)


@kernel_inline
def _place(free: I1, step: Step, midpoint: bool) -> None:
    """x1, v1 and the point of the equations from the accelerations."""
    x0, x1, v1, xe, ve = step.x0, step.x1, step.v1, step.xe, step.ve
    a, p, q, s, c, h = step.a, step.p, step.q, step.s, step.c, step.h
    # x1 = p + s a, v1 = q + c a
    for i in range(free.size):
        j = free[i]
        x1[j] = p[j] + s * a[j]
        v1[j] = q[j] + c * a[j]
    # xe, ve where the equations of motion hold: midpoint, or the end
    for j in range(x0.size):
        xe[j] = 0.5 * (x0[j] + x1[j]) if midpoint else x1[j]
        ve[j] = (x1[j] - x0[j]) / h if midpoint else v1[j]


@kernel_inline
def _lacking(eq: Equations, ws: Workspace, user: int, step: Step, t_e: float, midpoint: bool) -> float:
    """What the equations at t_e (s) and the rows at the end lack with the a and N at hand, into f and gap; factors the matrix.

    Returns the smallest scaled pivot.
    """
    xe, ve, f, gap = step.xe, step.ve, step.f, step.gap
    _place(eq.free, step, midpoint)
    applied(eq, user, t_e, xe, ve, f)
    if midpoint:
        _swap_laws(eq, step.x0, step.x1, xe, ve, step.h, f)
    if midpoint and eq.spring.size:
        swap_springs(eq, step.x0, step.x1, xe, ve, step.h, f)
    if midpoint and eq.edge_A.size:
        swap_continua(eq, step.x0, step.x1, xe, f)
    pivot = factor(eq, ws, xe)
    _unbalanced(eq, ws, xe, step.a, step.N, f, step.work)
    row_gaps(eq, step.x1, step.target, gap)
    # right-hand side of J da
    for k in range(gap.size):
        gap[k] /= -step.s  # x1 moves by s da: J da = -gap/s
    return pivot


@kernel_bare
def solve_step(eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, step: Step) -> bool:
    """Find a and N of a step, from the values there. True if they converged."""
    free, midpoint, t_e = eq.free, control.method == m.MIDPOINT, step.t_1
    hold_end(eq, ws, step)
    if midpoint:
        t_e -= 0.5 * step.h
        prepare_rows(eq, ws, t_e, step.xe, step.ve)
    tangent, last, half = control.place.size > 0, math.inf, 0.5 if midpoint else 1.0
    # Newton's method for a and N; its matrix with stiffness and damping is factored every fourth time
    for turn in range(MOST):
        memory.pivot = _lacking(eq, ws, user, step, t_e, midpoint)
        for j in range(step.da.size):
            step.da[j] = 0.0
        if tangent:
            if turn % 4 == 0:
                tangent_factor(eq, ws, control, step.xe, step.ve, step.N, half * step.s, half * step.c)
            tangent_solve(eq, control, step.f, step.gap, step.da, step.dN)
        else:
            solve(eq, ws, step.f, step.gap, step.da, step.dN)
        change = change_by(free, step)
        memory.newtons += 1
        if not change < math.inf:
            return False
        if converged(control, turn, change, last):
            _place(free, step, midpoint)
            return True
        last = change
    return False
