"""One step of fixed size: of an implicit method by Newton's method, or of RATTLE."""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F0, F1, F2, I1, Record, record
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Memory
from kinetruss.kernels.integrate.tangent import tangent_factor, tangent_solve
from kinetruss.kernels.solve.accelerations import add_friction
from kinetruss.kernels.solve.kkt import add_constraint_forces, factor, prepare_rows, row_along, row_gaps, row_rate_gaps, solve
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.element_table import swap_elements
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import bar_tension, law_energy, law_tension, length_rate
from kinetruss.kernels.structure.mass import direction, mass_times
from kinetruss.kernels.structure.structure import CABLE, GREEN, Structure

MOST = 60
"""Iterations of Newton's method."""
CONVERGED = 1e-14
"""Change of a position, in lengths of members, below which nothing is left to gain."""


@record
class Step(Record):
    """h : size, s; t_1 : its end, s. s (s^2), c (s) : what accelerations add to the end, x1 = p + s a, v1 = q + c a.

    x0, x1 (3 n,) : places at both ends, m; v0, v1 : velocities; xe, ve : where the equations of motion hold. a (3 n,) :
    accelerations, N (rows,) row forces that are looked for; p, q (3 n,) : the end without accelerations. target (3, rows) :
    what rows are held to at the end. Workspace: f (3 n,) forces without balance, da, work (3 n,), dN, gap (rows,).
    """

    h: F0
    t_1: F0
    s: F0
    c: F0
    x0: F1
    v0: F1
    x1: F1
    v1: F1
    xe: F1
    ve: F1
    a: F1
    p: F1
    q: F1
    f: F1
    da: F1
    work: F1
    target: F2
    N: F1
    dN: F1
    gap: F1


_, INTEGERS, REALS = Step.COUNT


@kernel
def new_step(n: int, rows: int) -> Step:
    """A step with n coordinates and so many rows."""
    # in the order of the fields
    shapes = (
        (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1), (n, 1),
        (3, rows), (rows, 1), (rows, 1), (rows, 1),
    )  # fmt: skip
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    return Step(ints, reals)


@kernel_bare
def hold_end(eq: Equations, ws: Workspace, step: Step) -> None:
    """What rows are held to at the end into target; prescribed coordinates of x1 and v1 are set."""
    prepare_rows(eq, ws, step.t_1, step.x1, step.v1)
    now, target = ws.target, step.target
    # targets at the end of the step
    for k in range(3):
        for j in range(target.shape[1]):
            target[k, j] = now[k, j]


@kernel_inline
def change_by(free: I1, step: Step) -> float:
    """a += da, N += dN; returns the largest change of a place at the end, m."""
    a, da, N, dN, s, change = step.a, step.da, step.N, step.dN, step.s, 0.0
    # Newton's correction of a; positions change by s da
    for i in range(free.size):
        a[free[i]] += da[free[i]]
        change = larger(change, abs(da[free[i]]) * s)
    # and of the multipliers
    for k in range(N.size):
        N[k] += dN[k]
    return change


@kernel_inline
def converged(control: Control, turn: int, change: float, last: float) -> bool:
    """True where nothing is left to gain, or little and no iteration gains much more; change, last : of two iterations, m."""
    tight = control.tolerance * control.size
    return change <= CONVERGED * control.size or (turn > 1 and change <= tight and change > 0.3 * last)


# One step of an implicit method: Newton's method for accelerations a and row forces N.
#
# With positions x1 = p + s a and velocities v1 = q + c a at the end of the step, M a + J^T N = f at a point (xe, ve) of it and
# the rows at its end hold. Midpoint rule with discrete gradients (Gonzalez 1999, Physica D 132, 165): xe = (x0 + x1)/2,
# ve = (x1 - x0)/h; rows are quadratic, so J at the midpoint is their discrete gradient, and bars with a law have the tension of
# their secant: (V(L1) - V(L0))/((L1^2 - L0^2)/2) along the middle of the two positions. Generalised alpha (Arnold & Brüls 2007,
# Multibody System Dynamics 18, 185): xe = x1, ve = v1.


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


@kernel_bare
def _forces(eq: Equations, ws: Workspace, user: int, t: float, x: F1, v: F1, f: F1) -> None:
    """All forces at t, x, v, where the matrix is factored, into f (3 n,)."""
    applied(eq, user, t, x, v, f)
    if eq.bearing_ints.size:
        add_friction(eq, ws, t, x, v, f)


@kernel_inline
def _lacking(eq: Equations, ws: Workspace, user: int, step: Step, t_e: float, midpoint: bool) -> float:
    """What the equations at t_e (s) and the rows at the end lack with the a and N at hand, into f and gap; factors the matrix.

    Returns the smallest scaled pivot.
    """
    xe, ve, f, gap = step.xe, step.ve, step.f, step.gap
    _place(eq.free, step, midpoint)
    pivot = factor(eq, ws, xe)
    _forces(eq, ws, user, t_e, xe, ve, f)
    if midpoint:
        _swap_laws(eq, step.x0, step.x1, xe, ve, step.h, f)
        swap_elements(eq, t_e, step.x0, step.x1, xe, ve, step.h, f)
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


HALVINGS = 16
"""Times that a correction is halved."""
RINGING, AT_REST = 0.05, 1e-3
"""Largest mean velocity in parts of that at the end, and smallest velocity at the end in parts of the change foreseen, of a
coordinate that swings to and fro where it should come to rest."""


@kernel_bare
def _rings(free: I1, step: Step, first: F1) -> bool:
    """True where a coordinate leaves a step as fast as it came, backwards, and its acceleration is not that foreseen: the
    midpoint rule does not damp what is stiffer than its step, it reverses it.
    """
    for i in range(free.size):
        j = free[i]
        end, foreseen = abs(step.v1[j]), step.c * abs(first[j])
        turned = abs(step.ve[j]) < RINGING * end and step.c * abs(step.a[j] - first[j]) > end
        if turned and end > AT_REST * foreseen:
            return True
    return False


@kernel
def solve_damped(eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, step: Step) -> int:
    """`solve_step` where full corrections do not converge: with as much of each as makes the next one smaller. 1 if it does.

    Friction that is all there at a small rate has a slope within it only; a correction from outside leads past it, over and
    over. What is compared are corrections with the same matrix (the natural test of monotonicity: Deuflhard, Newton Methods for
    Nonlinear Problems, 2004, section 3.3).
    """
    free, midpoint, t_e = eq.free, control.method == m.MIDPOINT, step.t_1
    hold_end(eq, ws, step)
    if midpoint:
        t_e -= 0.5 * step.h
        prepare_rows(eq, ws, t_e, step.xe, step.ve)
    last, half = math.inf, 0.5 if midpoint else 1.0
    way, way_N, first = np.zeros(step.a.size), np.zeros(step.N.size), np.zeros(step.a.size)
    for i in range(free.size):
        first[free[i]] = step.a[free[i]]
    for turn in range(MOST):
        memory.pivot = _lacking(eq, ws, user, step, t_e, midpoint)
        tangent_factor(eq, ws, control, step.xe, step.ve, step.N, half * step.s, half * step.c)
        tangent_solve(eq, control, step.f, step.gap, step.da, step.dN)
        for i in range(free.size):
            way[free[i]] = step.da[free[i]]
        for k in range(way_N.size):
            way_N[k] = step.dN[k]
        # all of the correction
        change, share = change_by(free, step), 1.0
        memory.newtons += 1
        if not change < math.inf:
            return 0
        if converged(control, turn, change, last):
            _place(free, step, midpoint)
            return 0 if midpoint and _rings(free, step, first) else 1
        for _ in range(HALVINGS):
            _lacking(eq, ws, user, step, t_e, midpoint)
            tangent_solve(eq, control, step.f, step.gap, step.da, step.dN)
            left = 0.0
            for i in range(free.size):
                left = larger(left, abs(step.da[free[i]]) * step.s)
            if left <= (1.0 - 0.25 * share) * change:
                break
            # half of it is taken back
            share *= 0.5
            for i in range(free.size):
                step.a[free[i]] -= share * way[free[i]]
            for k in range(way_N.size):
                step.N[k] -= share * way_N[k]
        last = change
    return 0


# One step of RATTLE: leapfrog whose row forces keep positions and velocities on the constraints.
#
# v' = v0 + h/2 a, M a + J0^T N = f0, rows at x1 = x0 + h v'; v1 = v' + h/2 b, M b + J1^T P = f1, J1 v1 = rates at the end.
# Andersen (1983), Journal of Computational Physics 52, 24; Hairer, Lubich & Wanner (2006), Geometric Numerical Integration,
# VII.1.4. Symplectic where forces do not depend on velocities; those that do see the velocity foreseen for the end.


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
    _forces(eq, ws, user, t_0, x0, v0, f)
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
    _forces(eq, ws, user, step.t_1, x1, v1, f)
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
