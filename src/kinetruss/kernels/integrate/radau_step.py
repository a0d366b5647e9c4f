"""One step of Radau IIA on the index-1 form: three stages at once by a simplified Newton method, judged, then projected.

The unknowns are the accelerations a_j of the stages, X_i = x + c_i h v + h^2 sum (A A)_ij a_j and V_i = v + h sum A_ij a_j, and
the tensions of bars with a law; what is solved is a_i = F(t_i, X_i, V_i), with the accelerations F of the equations.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.record import F0, F1, F2, I0, Record, record
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import Run, put_state
from kinetruss.kernels.integrate.dop853_step import dop853_step
from kinetruss.kernels.integrate.loop import LEAST, accept, goes_on, target
from kinetruss.kernels.integrate.radau_matrices import (
    AA,
    EA,
    EAA,
    LEFT,
    MOST,
    NODES,
    REAL,
    RIGHT,
    A,
    Matrices,
    factor_both,
    filtered,
    matrices_at,
    new_matrices,
    smaller_step,
    solve_both,
    step_behind,
)
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.solve.accelerations import accelerate_under, evaluate
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project_near
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.laws import law_tension, length_rate

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
def _residuals(run: Run, own: Stages) -> None:
    """r = a - F of all stages; their pivots."""
    eq, ws, control, memory, work = run.eq, run.ws, run.control, run.memory, run.work
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
        applied(eq, run.user, t, x, v, ws.f)
        _swap_tensions(eq, x, v, own.S[s], own.q[s], ws.f)
        accelerate_under(eq, ws, t, x, v, a, work.N)
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
def _tensions(run: Run, own: Stages) -> None:
    """Tensions of laws as they are at the start into S."""
    eq, memory, x, v = run.eq, run.memory, run.work.x, run.work.v
    put_state(run.control, memory.y[0], memory.t, run.work)
    for k in range(own.S.shape[1]):
        L, _, Ld = length_rate(x, v, eq.law_A[k], eq.law_B[k])
        for s in range(3):
            own.S[s, k] = law_tension(eq, k, L, Ld)


@kernel_bare
def solve_stages(run: Run, matrices: Matrices, own: Stages) -> int:
    """Newton's method for the stages of a step. 1 where it converged, 0 where not, -1 where numbers are not finite."""
    eq, control, memory = run.eq, run.control, run.memory
    enough, last, rate = min(0.03, math.sqrt(own.rtol)), math.inf, 1.0
    _extrapolate(memory, own)
    _place(memory, own)
    _tensions(run, own)
    for iteration in range(MOST):
        _residuals(run, own)
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


# F are the accelerations of the equations with J a = gamma, so stages may lie off the constraints by their error; the end of
# the step is projected (Hairer & Wanner, Solving Ordinary Differential Equations II, sections IV.8 and VII.2).

ASIDE = 2
"""Returned for a step that DOP853 takes instead: next to a singular position, which its stages know how to avoid."""
LOW, TOGETHER = 0.1, 0.4
"""Scaled pivots next to a singular position, in parts of the largest one: of a stage, and the sum of two neighbours."""
FEWER = 0.5
"""Next try of a step, in parts of the last one, where Newton's method did not converge."""
SPOILT = 10
"""Steps with numbers that are not finite after which there is no other try."""
FAR = 100.0
"""Way of the projection, in parts of the error allowed, beyond which the end is not believed."""


@kernel_bare
def _estimate(control: Control, matrices: Matrices, gain: F1, faster: F1, own: Stages) -> float:
    """REAL h f + sum e_i (Y_i - y), filtered, into error; returns its size, in parts of that allowed.

    f has the accelerations gain (nf,) and, as velocities, those at the start and faster (nf,).
    """
    nf, a, ex, ev, h = own.a.shape[1], own.a, own.error[0], own.error[1], own.h
    # of x_i and v_i; h v_i of the start cancels
    for i in range(nf):
        ex[i] = h * (REAL * faster[i] + h * (EAA[0] * a[0, i] + EAA[1] * a[1, i] + EAA[2] * a[2, i]))
        ev[i] = h * (REAL * gain[i] + EA[0] * a[0, i] + EA[1] * a[1, i] + EA[2] * a[2, i])
    filtered(control, matrices, h, ex, ev)
    total = 0.0
    for i in range(nf):
        total += (ex[i] / own.scale[i]) ** 2 + (ev[i] / own.scale[nf + i]) ** 2
    return math.sqrt(total / (2.0 * nf))


@kernel_bare
def _error(run: Run, matrices: Matrices, own: Stages) -> float:
    """The error of the step, in parts of that allowed.

    At the start and behind a rejected step, a large one is estimated anew with the rates beside the start by the error: parts
    that a stiff law forgets at once count no longer (Hairer & Wanner II, eq. IV.8.21).
    """
    control, memory, work = run.control, run.memory, run.work
    free, nf, y, x, v = control.free, own.a.shape[1], memory.y, work.x, work.v
    gain, faster = own.r[0], own.r[1]
    for i in range(nf):
        gain[i], faster[i] = y[1, nf + i], 0.0
    error = _estimate(control, matrices, gain, faster, own)
    if not (own.again and 1.0 <= error < math.inf):
        return error
    for i in range(nf):
        x[free[i]], v[free[i]] = y[0, i] + own.error[0, i], y[0, nf + i] + own.error[1, i]
        faster[i] = own.error[1, i]
    start = max(memory.t, control.breaks[1, memory.interval])
    evaluate(run.eq, run.ws, run.user, start, x, v, work.a, run.ws.multiplier)
    memory.evaluations += 1
    for i in range(nf):
        gain[i] = work.a[free[i]]
    return _estimate(control, matrices, gain, faster, own)


@kernel_bare
def _near_singular(memory: Memory, own: Stages) -> float:
    """Fraction of the step at which a singular position is near, in a stage or between two of them; -1 where there is none.

    The pivot is the size of a number that changes its sign there: then the sum of two, not their difference, fits the slope
    that is seen beside them.
    """
    p, most = own.pivots, memory.pivot_most
    for k in range(3):
        if p[k + 1] < LOW * most:
            return NODES[k]
    for k in range(3):
        begin = NODES[k - 1] if k > 0 else 0.0
        width, slope, both, change = NODES[k] - begin, 0.0, p[k] + p[k + 1], abs(p[k] - p[k + 1])
        if k > 0:
            slope = abs(p[k] - p[k - 1]) / (begin - (NODES[k - 2] if k > 1 else 0.0))
        if k < 2:
            slope = max(slope, abs(p[k + 2] - p[k + 1]) / (NODES[k + 1] - NODES[k]))
        if both < TOGETHER * most and abs(both - slope * width) < abs(change - slope * width):
            return begin + width * p[k] / both
    return -1.0


@kernel_bare
def _project_end(run: Run, t: float, own: Stages) -> bool:
    """Project the end of the step into x and v of the work. False where it is not believed."""
    control, work = run.control, run.work
    free, x, v, nf = control.free, work.x, work.v, control.free.size
    for i in range(nf):
        x[free[i]], v[free[i]] = own.x[2, i], own.v[2, i]
    # the factors at hand are of the last stage but for the last change
    ok, work.moved, _, work.end_pivot = project_near(run.eq, run.ws, t, x, v, control.tolerance, True)
    off = 0.0
    for i in range(nf):
        off += ((x[free[i]] - own.x[2, i]) / own.scale[i]) ** 2 + ((v[free[i]] - own.v[2, i]) / own.scale[nf + i]) ** 2
    return ok and off < FAR * FAR * 2.0 * nf


@kernel_bare
def _keep(control: Control, memory: Memory, work: Work, t: float, own: Stages) -> None:
    """Make the step the last one. Its interpolant: the quintic of places through places, velocities and accelerations at both
    ends, in powers of the fraction of the step; that of velocities is its rate.
    """
    free, y, F, nf, h = control.free, memory.y, memory.dense, control.free.size, own.h
    for j in range(6, F.shape[0]):
        for i in range(2 * nf):
            F[j, i] = 0.0
    # the quintic of x_i, and its rate
    for i in range(nf):
        x0, v0, a0 = y[0, i], h * y[0, nf + i], h * h * y[1, nf + i]
        x1, v1, a1 = work.x[free[i]], h * work.v[free[i]], h * h * own.a[2, i]
        d, e, g = x1 - x0 - v0 - 0.5 * a0, v1 - v0 - a0, 0.5 * (a1 - a0)
        F[0, i], F[1, i], F[2, i] = x0, v0, 0.5 * a0
        F[3, i], F[4, i], F[5, i] = 10.0 * d - 4.0 * e + g, -15.0 * d + 7.0 * e - 2.0 * g, 6.0 * d - 3.0 * e + g
        for j in range(5):
            F[j, nf + i] = (j + 1) * F[j + 1, i] / h
        F[5, nf + i] = 0.0
        y[0, i], y[0, nf + i] = work.x[free[i]], work.v[free[i]]
        y[1, i], y[1, nf + i] = work.v[free[i]], own.a[2, i]
        y[2, i], y[2, nf + i] = own.a[0, i], own.a[1, i]
    for k in range(work.N.size):
        memory.multiplier[k] = work.N[k]
    memory.constraint = work.moved
    accept(memory, h, t, work.end_pivot, 1)


@kernel_bare
def _begin(run: Run, matrices: Matrices, own: Stages) -> None:
    """The matrices at the start of the step."""
    if own.stiff:
        control, memory, x, v = run.control, run.memory, run.work.x, run.work.v
        put_state(control, memory.y[0], memory.t, run.work)
        matrices_at(run.eq, run.ws, control, memory.t, x, v, memory.multiplier, matrices)


@kernel_bare
def _try(run: Run, matrices: Matrices, own: Stages) -> int:
    """Stages and error of a step of the size in hand. 1 : good; 0 : no error is known; -1 : numbers are not finite; ASIDE.

    The error is left in `error` of the work.
    """
    control, memory, work = run.control, run.memory, run.work
    fixed = control.fixed_step > 0.0
    work.error, work.near_t = math.inf, -math.inf
    if own.stiff:
        factor_both(control, own.h, matrices)
    found = solve_stages(run, matrices, own)
    if found != 1:
        return found
    near = _near_singular(memory, own)
    if near >= 0.0 and not fixed:
        return ASIDE
    if near >= 0.0:
        work.near_t = memory.t + near * own.h
    work.error = _error(run, matrices, own)
    return 1


@kernel_bare
def _next_size(memory: Memory, h: float, error: float, tries: int, own: Stages) -> float:
    """Size of the step behind one of h that is accepted."""
    grown = step_behind(h, error, memory.h_old if memory.series != 0 else 0.0, memory.error_old, own.iterations)
    memory.error_old = max(error, 1e-2)
    if tries > 0:
        return min(grown, h)
    # a step cut short by a jump says nothing against the size before it
    return grown if h >= memory.h else max(grown, min(memory.h, 6.0 * h))


@kernel_bare
def radau_step(run: Run, matrices: Matrices, own: Stages) -> int:
    """One step. 1 where it is taken, 0 where there is none (`code` of the work says why), ASIDE."""
    control, memory, work = run.control, run.memory, run.work
    fixed, h, spoilt, tries = control.fixed_step, memory.h, 0, 0
    own.pivots[0] = memory.pivot
    if memory.pivot < LOW * memory.pivot_most and fixed == 0.0:
        return ASIDE
    _begin(run, matrices, own)
    while True:
        h, t = target(control, memory, fixed if fixed > 0.0 else h)
        if not h > LEAST * max(abs(memory.t), control.t_end - memory.t_start):
            work.code = m.STEP_TOO_SMALL if spoilt == 0 else m.NOT_FINITE
            return 0
        own.h, own.again = h, 1 if fixed == 0.0 and (tries > 0 or memory.steps == 0) else 0
        found = _try(run, matrices, own)
        if found == ASIDE:
            return ASIDE
        if found == 1 and (work.error <= 1.0 or (fixed > 0.0 and work.error < math.inf)):
            if _project_end(run, t, own):
                break
            work.error = 1e3
        memory.rejected += 1
        tries += 1
        spoilt += found < 0
        if fixed > 0.0 or spoilt > SPOILT:
            work.code = m.NOT_CONVERGED if spoilt == 0 else m.NOT_FINITE
            return 0
        h = smaller_step(h, work.error) if work.error < math.inf else FEWER * h if found == 0 else 0.1 * h
    memory.h = _next_size(memory, h, work.error, tries, own)
    _keep(control, memory, work, t, own)
    return 1


@kernel
def radau_steps(run: Run, samples: Samples) -> None:
    """Steps while the run goes on."""
    laws = run.eq.law_A.size
    _steps(run, samples, new_matrices(run.control, laws), new_stages(run.control, laws))


@kernel_bare
def _steps(run: Run, samples: Samples, matrices: Matrices, own: Stages) -> None:
    while goes_on(run, samples):
        if radau_step(run, matrices, own) == ASIDE:
            dop853_step(run)
