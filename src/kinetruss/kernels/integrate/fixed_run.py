"""Steps of fixed size one after another: what is foreseen for the next, its interpolant, and steps next to singular positions.

One driver for the three methods: energy-momentum midpoint rule, generalised alpha, RATTLE.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, I1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import Run
from kinetruss.kernels.integrate.fixed_steps import Step, new_step, rattle_step, solve_damped, solve_step
from kinetruss.kernels.integrate.loop import accept, goes_on, target
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace

NEAR, EXTRAPOLATED_MOST = 0.2, 12
"""Scaled pivot, relative to the largest one, and number of steps for which accelerations may be extrapolated."""
LOW = 0.95
"""Scaled pivot, relative to the largest one, below which the pivot at the end of a step is computed."""
TURNED = 0.1
"""Fraction of the length of a step by which its end may differ from a straight line, next to a singular position."""


@kernel_bare
def _begin(free: I1, memory: Memory, x: F1, step: Step) -> None:
    """Spread the state over the ends of the step and a, as it is foreseen; prescribed coordinates stand where they are."""
    x0, v0, x1, v1, a, N, nf = step.x0, step.v0, step.x1, step.v1, step.a, step.N, free.size
    for y in (step.x0, step.x1, step.xe):
        for j in range(x.size):
            y[j] = x[j]
    # velocities and accelerations of prescribed coordinates, until a motion sets them
    for y in (step.v0, step.v1, step.ve, step.a, step.p, step.q):
        for j in range(x.size):
            y[j] = 0.0
    # free coordinates from the last step; a extrapolated by up to a parabola through the last three steps
    for i in range(nf):
        j = free[i]
        x0[j] = x1[j] = memory.y[0, i]
        v0[j] = v1[j] = memory.y[0, nf + i]
        a[j] = memory.y[1, nf + i]
        # as they have changed in the last steps
        if memory.steps > 1:
            a[j] += 2.0 * memory.y[1, nf + i] - 3.0 * memory.y[3, i] + memory.y[3, nf + i]
        elif memory.steps > 0:
            a[j] += memory.y[1, nf + i] - memory.y[3, i]
    # multipliers of the last step as first guess
    for k in range(N.size):
        N[k] = memory.multiplier[k]


@kernel_bare
def _bases(free: I1, control: Control, memory: Memory, step: Step) -> None:
    """p, q, s and c of x1 = p + s a and v1 = q + c a."""
    x0, v0, a, p, q, nf, h = step.x0, step.v0, step.a, step.p, step.q, free.size, step.h
    if control.method == m.MIDPOINT:
        # midpoint rule: x1 = x0 + h v0 + h^2/2 a, v1 = v0 + h a
        for i in range(nf):
            p[free[i]], q[free[i]] = x0[free[i]] + h * v0[free[i]], v0[free[i]]
        step.s, step.c = 0.5 * h * h, h
        return
    rho = control.rho
    alpha_m, alpha_f = (2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0)
    gamma = 0.5 + alpha_f - alpha_m
    beta = 0.25 * (0.5 + gamma) ** 2
    if memory.steps == 0:
        # generalised alpha starts with its algorithmic acceleration equal to a
        for i in range(nf):
            memory.y[2, i] = a[free[i]]
    # Newmark's formulas with the algorithmic acceleration eliminated: what does not depend on the new a
    for i in range(nf):
        j = free[i]
        old = memory.y[2, i]
        new = (alpha_f * memory.y[1, nf + i] - alpha_m * old) / (1.0 - alpha_m)
        p[j] = x0[j] + h * v0[j] + h * h * ((0.5 - beta) * old + beta * new)
        q[j] = v0[j] + h * ((1.0 - gamma) * old + gamma * new)
        memory.y[2, nf + i] = new
    share = (1.0 - alpha_f) / (1.0 - alpha_m)
    step.s, step.c = h * h * beta * share, h * gamma * share


@kernel_bare
def _end(free: I1, control: Control, memory: Memory, step: Step) -> None:
    """Make the step the last one; its interpolant is the cubic through both ends."""
    y, F, nf, h = memory.y, memory.dense, free.size, step.h
    x1, v1, a, N = step.x1, step.v1, step.a, step.N
    midway = control.method != m.ALPHA
    if not midway:
        rho = control.rho
        share = (1.0 - rho / (rho + 1.0)) / (1.0 - (2.0 * rho - 1.0) / (rho + 1.0))
        # algorithmic acceleration of the next step, the part with the new a
        for i in range(nf):
            y[2, i] = y[2, nf + i] + share * a[free[i]]
    # cubic Hermite interpolant of positions and velocities over the step
    for i in range(nf):
        for k, new, rate_0, rate_1 in (
            (i, x1[free[i]], y[0, nf + i], v1[free[i]]),
            (nf + i, v1[free[i]], y[1, nf + i], a[free[i]]),
        ):
            change = new - y[0, k]
            if midway and k >= nf:
                rate_0 = rate_1 = change / h
            F[0, k], F[1, k] = y[0, k], change
            F[2, k], F[3, k] = h * rate_0 - change, 2.0 * change - h * (rate_0 + rate_1)
    # the history moves back by one step
    for i in range(nf):
        y[3, nf + i], y[3, i] = y[3, i], y[1, nf + i]
        y[0, i], y[0, nf + i] = x1[free[i]], v1[free[i]]
        y[1, i], y[1, nf + i] = v1[free[i]], a[free[i]]
    # multipliers of this step
    for k in range(N.size):
        memory.multiplier[k] = N[k]
    accept(memory, h, step.t_1, memory.pivot, 0)


@kernel_bare
def _extrapolated(eq: Equations, ws: Workspace, midpoint: bool, memory: Memory, work: Work, step: Step) -> bool:
    """Next to a singular position, where no iteration converges: extrapolated accelerations, then the projection.

    True if that is all there is to it; such steps follow one another only a few times.
    """
    free, h, t_1 = eq.free, step.h, step.t_1
    if not memory.pivot < NEAR * memory.pivot_most or memory.carried >= EXTRAPOLATED_MOST:
        return False
    k = memory.passages_met
    known = k > 0 and k <= memory.passages.shape[0] and memory.passages[min(k, memory.passages.shape[0]) - 1, 0] > t_1 - 3.0 * h
    if memory.carried == 0 and not known:
        if k < memory.passages.shape[0]:
            memory.passages[k, 0], memory.passages[k, 1], memory.passages[k, 2] = t_1 - 0.5 * h, memory.pivot, 0.0
        memory.passages_met += 1
    memory.carried += 1
    _begin(free, memory, work.x, step)
    x0, v0, x1, v1, a, nf = step.x0, step.v0, step.x1, step.v1, step.a, free.size
    # x1, v1 for an acceleration that is linear in time over the step
    for i in range(nf):
        j = free[i]
        first = a[j] if midpoint else memory.y[1, nf + i]
        x1[j] = x0[j] + h * v0[j] + h * h * (first / 3.0 + a[j] / 6.0)
        v1[j] = v0[j] + 0.5 * h * (first + a[j])
    return project(eq, ws, t_1, x1, v1, 1e-12)[0]


@kernel_bare
def _goes_on(free: I1, memory: Memory, step: Step) -> bool:
    """False where a step next to a singular position left in another direction than it came: it settled on another branch."""
    x0, v0, x1, nf, h = step.x0, step.v0, step.x1, free.size, step.h
    if not memory.pivot < NEAR * memory.pivot_most:
        return True
    fastest, gain, before, off = 0.0, 0.0, 0.0, 0.0
    # size of v0, of the change of direction x1 - x0 - h v0, and of the accelerations before
    for i in range(nf):
        j = free[i]
        fastest, off = max(fastest, abs(v0[j])), max(off, abs(x1[j] - x0[j] - h * v0[j]))
        gain, before = max(gain, abs(memory.y[1, nf + i])), max(before, abs(memory.y[3, i]))
    if memory.steps > 1:
        gain = min(gain, before)
    return off <= TURNED * h * fastest + h * h * gain


@kernel_bare
def _passing(eq: Equations, ws: Workspace, memory: Memory, work: Work, step: Step) -> None:
    """Into NEAR_T when a singular position seems to have been passed in the step (kernels.integrate.singular.crossed).

    The pivot is the size of a number that changes its sign there: the sum of the two at the ends of the step, not their
    difference, fits the slope that was seen in the step before. Extrapolated steps have entered theirs.
    """
    before, start, end = memory.pivot_0, memory.pivot_1, memory.pivot
    work.near_t = -math.inf
    if memory.carried > 0:
        memory.pivot_0, memory.pivot_1 = -1.0, -1.0
        return
    if end < LOW * memory.pivot_most:
        prepare_rows(eq, ws, step.t_1, step.x1, step.v1)
        end = factor(eq, ws, step.x1)
    memory.pivot_0, memory.pivot_1 = start, end
    both, change = start + end, abs(before - start)
    if before < 0.0 or start < 0.0 or not both > 0.0:
        return
    if abs(both - change) < abs(abs(start - end) - change):
        work.near_t = step.t_1 - step.h + step.h * start / both


@kernel_bare
def _step(run: Run, step: Step) -> None:
    """One step; where there is none, `code` says so."""
    eq, ws, control, memory, work = run.eq, run.ws, run.control, run.memory, run.work
    free, method = eq.free, control.method
    step.h, step.t_1 = target(control, memory, control.fixed_step)
    if memory.steps == 0:
        memory.pivot_0, memory.pivot_1 = -1.0, memory.pivot
    _begin(free, memory, work.x, step)
    if method == m.RATTLE:
        good = rattle_step(eq, ws, run.user, control, memory, step)
    else:
        _bases(free, control, memory, step)
        good = solve_step(eq, ws, run.user, control, memory, step)
        if not good and control.place.size > 0 and not memory.pivot < NEAR * memory.pivot_most:
            _begin(free, memory, work.x, step)
            _bases(free, control, memory, step)
            good = solve_damped(eq, ws, run.user, control, memory, step) == 1
        good = good and _goes_on(free, memory, step)
    if good:
        memory.carried = 0
    else:
        good = _extrapolated(eq, ws, method == m.MIDPOINT, memory, work, step)
    if good:
        _end(free, control, memory, step)
        _passing(eq, ws, memory, work, step)
    else:
        work.code = m.NOT_CONVERGED if _known(run, step) else m.NOT_FINITE


@kernel_bare
def _known(run: Run, step: Step) -> bool:
    """False where forces are no numbers in the middle or at the end of a step along the velocities at its start."""
    x, v = step.x1, step.v1
    for share in (0.5, 1.0):
        for j in range(x.size):
            x[j], v[j] = step.x0[j] + share * step.h * step.v0[j], step.v0[j]
        applied(run.eq, run.user, step.t_1 - (1.0 - share) * step.h, x, v, step.f)
        for j in range(x.size):
            if not abs(step.f[j]) < math.inf:
                return False
    return True


@kernel
def steps_of_fixed_size(run: Run, samples: Samples) -> None:
    """Steps while the run goes on."""
    _steps(run, samples, new_step(run.work.x.size, run.memory.multiplier.size))


@kernel_bare
def _steps(run: Run, samples: Samples, step: Step) -> None:
    while goes_on(run, samples):
        _step(run, step)
