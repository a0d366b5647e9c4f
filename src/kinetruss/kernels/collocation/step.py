"""One step of Radau IIA on the index-1 form: stages a = F(t, x, v), judged, then projected onto the constraints.

F are the accelerations of the equations with J a = gamma, so stages may lie off the constraints by their error; the end of the
step is projected (Hairer & Wanner, Solving Ordinary Differential Equations II, sections IV.8 and VII.2).
"""

from __future__ import annotations

import math

from kinetruss.kernels.collocation.coefficients import EA, EAA, NODES, REAL, smaller_step, step_behind
from kinetruss.kernels.collocation.matrices import Matrices, factor_both, filtered, matrices_at
from kinetruss.kernels.collocation.stages import Stages, solve_stages
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.solve.kkt import evaluate, project_near
from kinetruss.kernels.steps.dop853_step import LEAST, target
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["ASIDE", "radau_step"]

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
def _error(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, work: Work, matrices: Matrices, own: Stages
) -> float:
    """The error of the step, in parts of that allowed.

    At the start and behind a rejected step, a large one is estimated anew with the rates beside the start by the error: parts
    that a stiff law forgets at once count no longer (Hairer & Wanner II, eq. IV.8.21).
    """
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
    evaluate(eq, ws, user, max(memory.t, control.breaks[1, memory.interval]), x, v, work.a, ws.multiplier)
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
def _project_end(eq: Equations, ws: Workspace, control: Control, work: Work, t: float, own: Stages) -> bool:
    """Project the end of the step into x and v of the work. False where it is not believed."""
    free, x, v, nf = control.free, work.x, work.v, control.free.size
    for i in range(nf):
        x[free[i]], v[free[i]] = own.x[2, i], own.v[2, i]
    # the factors at hand are of the last stage but for the last change
    ok, work.moved, _, work.end_pivot = project_near(eq, ws, t, x, v, control.tolerance, True)
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
    memory.series, memory.alone = 1, 0
    memory.steps += 1
    memory.t_old, memory.h_old, memory.t = memory.t, h, t
    memory.pivot, memory.constraint = work.end_pivot, work.moved
    memory.pivot_most = max(memory.pivot_most, work.end_pivot)
    work.end_stage = 0


@kernel_bare
def _begin(eq: Equations, ws: Workspace, control: Control, memory: Memory, work: Work, matrices: Matrices, own: Stages) -> None:
    """The matrices at the start of the step."""
    if own.stiff:
        x, v, free = work.x, work.v, control.free
        for i in range(free.size):
            x[free[i]], v[free[i]] = memory.y[0, i], memory.y[0, free.size + i]
        matrices_at(eq, ws, control, memory.t, x, v, memory.multiplier, matrices)


@kernel_bare
def _try(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, work: Work, matrices: Matrices, own: Stages
) -> int:
    """Stages and error of a step of the size in hand. 1 : good; 0 : no error is known; -1 : numbers are not finite; ASIDE.

    The error is left in `error` of the work.
    """
    fixed = control.fixed_step > 0.0
    work.error, work.near_t = math.inf, -math.inf
    if own.stiff:
        factor_both(control, own.h, matrices)
    found = solve_stages(eq, ws, user, control, memory, work, matrices, own)
    if found != 1:
        return found
    near = _near_singular(memory, own)
    if near >= 0.0 and not fixed:
        return ASIDE
    if near >= 0.0:
        work.near_t = memory.t + near * own.h
    work.error = _error(eq, ws, user, control, memory, work, matrices, own)
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
def radau_step(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, work: Work, matrices: Matrices, own: Stages
) -> int:
    """One step. 1 where it is taken, 0 where there is none (`code` of the work says why), ASIDE."""
    fixed, h, spoilt, tries = control.fixed_step, memory.h, 0, 0
    own.pivots[0] = memory.pivot
    if memory.pivot < LOW * memory.pivot_most and fixed == 0.0:
        return ASIDE
    _begin(eq, ws, control, memory, work, matrices, own)
    while True:
        h, t = target(control, memory, fixed if fixed > 0.0 else h)
        if not h > LEAST * max(abs(memory.t), control.t_end - memory.t_start):
            work.code = m.STEP_TOO_SMALL if spoilt == 0 else m.NOT_FINITE
            return 0
        own.h, own.again = h, 1 if fixed == 0.0 and (tries > 0 or memory.steps == 0) else 0
        found = _try(eq, ws, user, control, memory, work, matrices, own)
        if found == ASIDE:
            return ASIDE
        if found == 1 and (work.error <= 1.0 or (fixed > 0.0 and work.error < math.inf)):
            if _project_end(eq, ws, control, work, t, own):
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
