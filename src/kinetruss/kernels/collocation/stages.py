"""The three stages of a step of Radau IIA, found at once by a simplified Newton method.

The unknowns are the accelerations a_j of the stages, X_i = x + c_i h v + h^2 sum (A A)_ij a_j and V_i = v + h sum A_ij a_j, and
the tensions of bars with a law; what is solved is a_i = F(t_i, X_i, V_i), with the accelerations F of the equations.
"""

from __future__ import annotations

import math

from kinetruss.kernels.collocation.coefficients import AA, LEFT, MOST, NODES, RIGHT, A
from kinetruss.kernels.collocation.matrices import Matrices, solve_both
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.record import F0, F1, F2, I0, Record, record
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.solve.kkt import accelerate_under, factor, prepare_rows, project_near
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import law_tension, length_rate

__all__ = ["Stages", "new_stages", "solve_stages"]

LATER = 4.0
"""Growth of the change from the first iteration to the second with which Newton's method goes on."""


@record
class Stages(Record):
    """iterations : of Newton's method in the step. stiff : 1 where there are matrices. again : 1 where a large error is
    estimated anew. h : size of the step, s. rtol, atol : of the error estimate, which is of order 3.

    a, x, v, r (3, nf) : accelerations, places and velocities of the stages, residuals. scale (2 nf,) : size of errors that
    count as 1. error (2, nf) : of places and velocities. pivots (4,) : scaled pivots at the start and of the stages.
    S, q (3, laws) : tensions of bars with a law in the stages, N, and their residuals.
    """

    iterations: I0
    stiff: I0
    again: I0
    h: F0
    rtol: F0
    atol: F0
    a: F2
    x: F2
    v: F2
    r: F2
    scale: F1
    error: F2
    pivots: F1
    S: F2
    q: F2


_, INTEGERS, REALS = Stages.COUNT


@kernel
def new_stages(control: Control, laws: int) -> Stages:
    """Work for stages. The true error is of order 5: with rtol^(2/3) for the estimate it is in proportion to rtol."""
    nf = control.free.size
    # in the order of the fields
    shapes = ((3, nf), (3, nf), (3, nf), (3, nf), (2 * nf, 1), (2, nf), (4, 1), (3, laws), (3, laws))
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    own = Stages(ints, reals)
    own.rtol = 0.1 * control.rtol ** (2.0 / 3.0)
    own.atol = own.rtol * control.atol / control.rtol
    own.stiff = 1 if control.place.size > 0 else 0
    return own


@kernel_bare
def _extrapolate(memory: Memory, own: Stages) -> None:
    """Accelerations of the stages: the parabola through those of the last step, or what they are at the start."""
    nf, y, a = own.a.shape[1], memory.y, own.a
    known = memory.series != 0 and memory.h_old > 0.0
    # Lagrange's polynomials of the nodes of the last step, at the stages of this one
    for s in range(3):
        z = 1.0 + NODES[s] * own.h / memory.h_old if known else 1.0
        first = (z - NODES[1]) * (z - NODES[2]) / ((NODES[0] - NODES[1]) * (NODES[0] - NODES[2]))
        second = (z - NODES[0]) * (z - NODES[2]) / ((NODES[1] - NODES[0]) * (NODES[1] - NODES[2]))
        third = (z - NODES[0]) * (z - NODES[1]) / ((NODES[2] - NODES[0]) * (NODES[2] - NODES[1]))
        for i in range(nf):
            a[s, i] = y[1, nf + i]
            if known:
                a[s, i] = first * y[2, i] + second * y[2, nf + i] + third * y[1, nf + i]


@kernel_bare
def _place(memory: Memory, own: Stages) -> None:
    """Places and velocities of the stages from their accelerations."""
    nf, y, a, h = own.a.shape[1], memory.y, own.a, own.h
    for s in range(3):
        for i in range(nf):
            v = y[0, nf + i]
            own.v[s, i] = v + h * (A[s, 0] * a[0, i] + A[s, 1] * a[1, i] + A[s, 2] * a[2, i])
            change = AA[s, 0] * a[0, i] + AA[s, 1] * a[1, i] + AA[s, 2] * a[2, i]
            own.x[s, i] = y[0, i] + h * (NODES[s] * v + h * change)


@kernel_bare
def _scales(control: Control, memory: Memory, own: Stages) -> None:
    """Errors of places count in parts of member lengths, of velocities in parts of the largest one."""
    nf, fastest = own.a.shape[1], 0.0
    for i in range(nf):
        fastest = max(fastest, abs(memory.y[0, nf + i]))
        for s in range(3):
            fastest = max(fastest, abs(own.v[s, i]))
    # of x_i and v_i
    for i in range(nf):
        own.scale[i] = own.atol + own.rtol * control.length[i]
        own.scale[nf + i] = own.atol + own.rtol * fastest


@kernel_bare
def _swap_tensions(eq: Equations, x: F1, v: F1, S: F1, q: F1, f: F1) -> None:
    """Replace the tensions N of laws at x, v in f by S; q = S - N."""
    # f += (N - S) G^T of each bar with a law
    for k in range(S.size):
        A, B = eq.law_A[k], eq.law_B[k]
        L, u, Ld = length_rate(x, v, A, B)
        q[k] = S[k] - law_tension(eq, k, L, Ld)
        for c in range(3):
            f[A + c] += q[k] * u[c]
            f[B + c] -= q[k] * u[c]


@kernel_bare
def _turned(table: F2, r: F2) -> None:
    """Replace r (3, .) by table (3, 3) times it."""
    for i in range(r.shape[1]):
        p, q, s = r[0, i], r[1, i], r[2, i]
        for k in range(3):
            r[k, i] = table[k, 0] * p + table[k, 1] * q + table[k, 2] * s


@kernel_bare
def _residuals(eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, work: Work, own: Stages) -> None:
    """r = a - F of all stages; their pivots."""
    free, x, v, a, k = control.free, work.x, work.v, work.a, memory.interval
    for s in range(3):
        # a jump at either end belongs to the neighbouring step
        t = min(max(memory.t + NODES[s] * own.h, control.breaks[1, k]), control.breaks[2, k])
        for i in range(free.size):
            x[free[i]], v[free[i]] = own.x[s, i], own.v[s, i]
        pivot = -1.0
        if control.stages_projected != 0.0:
            _, _, _, pivot = project_near(eq, ws, t, x, v, control.tolerance, False)
        if pivot == -1.0:
            prepare_rows(eq, ws, t, x, v)
            pivot = factor(eq, ws, x)
        own.pivots[1 + s] = pivot
        applied(eq, user, t, x, v, ws.f)
        _swap_tensions(eq, x, v, own.S[s], own.q[s], ws.f)
        accelerate_under(eq, ws, x, v, a, work.N)
        memory.evaluations += 1
        # r_s = a_s - F(t_s, X_s, V_s; S_s)
        for i in range(free.size):
            own.r[s, i] = own.a[s, i] - a[free[i]]


@kernel_bare
def _improve(eq: Equations, control: Control, matrices: Matrices, memory: Memory, own: Stages) -> float:
    """One change of the stages by their residuals; returns its size, in parts of the errors allowed."""
    nf, a, r, h = own.a.shape[1], own.a, own.r, own.h
    if own.stiff:
        _turned(LEFT, r)
        _turned(LEFT, own.q)
        solve_both(eq, control, h, matrices, r, own.q)
        _turned(RIGHT, r)
        _turned(RIGHT, own.q)
    else:
        # without stiff parts M + ... is M: the change is the residual
        for k in range(3):
            for i in range(nf):
                r[k, i] = -r[k, i]
    # a_k and S_k of the stages
    for k in range(3):
        for i in range(nf):
            a[k, i] += r[k, i]
        for i in range(own.S.shape[1]):
            own.S[k, i] += own.q[k, i]
    _place(memory, own)
    _scales(control, memory, own)
    # mean square of the changes of X_s and V_s, in parts of the errors allowed
    total = 0.0
    for s in range(3):
        for i in range(nf):
            dv = h * (A[s, 0] * r[0, i] + A[s, 1] * r[1, i] + A[s, 2] * r[2, i])
            dx = h * h * (AA[s, 0] * r[0, i] + AA[s, 1] * r[1, i] + AA[s, 2] * r[2, i])
            total += (dx / own.scale[i]) ** 2 + (dv / own.scale[nf + i]) ** 2
    return math.sqrt(total / (6.0 * nf))


@kernel_bare
def _tensions(eq: Equations, control: Control, memory: Memory, work: Work, own: Stages) -> None:
    """Tensions of laws as they are at the start into S."""
    free, x, v = control.free, work.x, work.v
    for i in range(free.size):
        x[free[i]], v[free[i]] = memory.y[0, i], memory.y[0, free.size + i]
    for k in range(own.S.shape[1]):
        L, _, Ld = length_rate(x, v, eq.law_A[k], eq.law_B[k])
        for s in range(3):
            own.S[s, k] = law_tension(eq, k, L, Ld)


@kernel_bare
def solve_stages(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, work: Work, matrices: Matrices, own: Stages
) -> int:
    """Newton's method for the stages of a step. 1 where it converged, 0 where not, -1 where numbers are not finite."""
    enough, last, rate = min(0.03, math.sqrt(own.rtol)), math.inf, 1.0
    _extrapolate(memory, own)
    _place(memory, own)
    _tensions(eq, control, memory, work, own)
    for iteration in range(MOST):
        _residuals(eq, ws, user, control, memory, work, own)
        change = _improve(eq, control, matrices, memory, own)
        memory.newtons += 1
        own.iterations = iteration + 1
        if not change < math.inf:
            return -1
        if iteration > 0:
            rate = change / last
            # what the tensions lack at first, the accelerations lack an iteration later
            if rate >= (1.0 if iteration > 1 else LATER) and change > enough:
                return 0
        # what is still lacking is a geometric series
        lacking = change * (rate / (1.0 - rate) if rate < 0.9 else 10.0)
        if lacking <= enough:
            return 1
        if iteration > 1 and lacking * rate ** (MOST - 1 - iteration) > enough:
            return 0
        last = change
    return 0
