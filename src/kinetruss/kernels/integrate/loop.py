"""The loop of an integration, the same for all methods: what comes behind a step, samples that are due, whether to go on.

    while goes_on(run, samples):
        a step of the method

Steps never end at wanted times: samples come from the dense output, projected. The equations are asked at one
place (`find`), and a method is reached by the address in `Control.steps_at`.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.calls import Interface
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import (
    ENERGY,
    EVALUATE,
    Run,
    find,
    largest_pivot,
    put_state,
    rule_of_fixed_steps,
    take_rate,
)
from kinetruss.kernels.integrate.events import begin_watch, scan
from kinetruss.kernels.integrate.roots import DEEPEST, DEGREE
from kinetruss.kernels.integrate.samples import keep_between, must_drain, write_due
from kinetruss.kernels.integrate.singular import enter_passage
from kinetruss.kernels.integrate.state import Control, Memory, Samples
from kinetruss.kernels.structure.equations import Equations, Workspace

CAREFUL = 0.1
"""First step of Radau IIA, relative to that of other methods."""
GAIN = 1e-3
"""Growth of energy without any source, relative to the largest kinetic energy, at which a run stops."""
LEAST = 1e-14
"""Smallest step, as a fraction of the time or of the whole run."""
ON_ROWS = 1e-13
"""Tolerance of the projections of methods with steps of fixed size."""
_, INTEGERS, REALS = m.Work.COUNT


@Interface
def steps(run: Run, samples: Samples) -> None:
    """Steps of a method while the run goes on; it may have scratch of its own."""


_steps = steps.call


@kernel
def march(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, samples: Samples, budget: int
) -> tuple[int, int]:
    """Go on from `memory` and fill the samples, in at most `budget` steps. Returns a code and how many are filled; ASIDE
    where a step of another method is wanted that is not compiled yet.
    """
    size, n, rows = memory.y.shape[1], samples.x.shape[1], memory.multiplier.size
    degree = max(2 * (memory.dense.shape[0] - 1), DEGREE) if memory.watched.size > 0 else -1
    deep, most = (DEEPEST + 2, 2 * degree + 8) if degree > 0 else (0, 0)
    # in the order of the fields
    shapes = (
        (14, 1),
        (16, size),
        (5, size),
        (n, 1),
        (n, 1),
        (n, 1),
        (rows, 1),
        (size - 2 * control.free.size, 1),
        (5, degree + 1),
        (deep, degree + 3),
        (most, 3),
        (64 * most, 3),
        (16, 2),
    )
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    work = m.Work(ints, reals)
    work.last_sample, work.budget, work.code = samples.times.size, budget, m.GOING
    work.factored, work.near_t = -1.0, -math.inf
    work.tolerance = ON_ROWS if rule_of_fixed_steps(control) else control.tolerance
    # prescribed coordinates at rest keep their places
    for i in range(n):
        work.x[i] = control.stand[i]
    run = Run(eq, ws, user, control, memory, work)
    _steps(control.steps_at, (run, samples))
    largest_pivot(run)
    return work.code, work.next_sample


@kernel_bare
def goes_on(run: Run, samples: Samples) -> int:
    """What comes before the first step or behind one, and samples that are due; 0 where the call ends, `code` says why."""
    control, memory, work = run.control, run.memory, run.work
    if work.code != m.GOING:
        return 0
    if memory.started == 0:
        _start(run)
    elif work.begun or memory.launched:  # a step from outside is one too
        _behind(run, samples)
    work.begun, memory.launched = 1, 0
    if work.code == m.GOING:
        write_due(run, samples)
    if work.code != m.GOING:
        return 0
    if work.next_sample >= work.last_sample or memory.t >= control.t_end:
        work.code = m.DONE
    elif work.budget <= 0 or must_drain(memory):
        work.code = m.PAUSED
    elif memory.steps + memory.rejected >= control.max_steps:
        work.code = m.TOO_MANY_STEPS
    else:
        work.budget -= 1
        work.next_time = samples.times[work.next_sample]
        return 1
    return 0


@kernel_bare
def _begin_interval(run: Run) -> None:
    """The rate of the present state, just behind the start of its interval."""
    control, memory, k = run.control, run.memory, run.memory.interval
    put_state(control, memory.y[0], min(max(memory.t, control.breaks[1, k]), control.breaks[2, k]), run.work)
    find(run, EVALUATE, 0)
    take_rate(control, run.work, memory.y[1])


@kernel_bare
def _start(run: Run) -> None:
    """Rate, pivot and first size of step, energy, and where watched quantities are."""
    control, memory, work = run.control, run.memory, run.work
    memory.t_start = memory.t_old = memory.t
    memory.h_old, memory.error_old, memory.stop = 0.0, 1e-4, math.inf
    _begin_interval(run)
    memory.pivot = memory.pivot_most = work.new_pivot
    memory.h = _first_size(control, memory)
    # multipliers at the start, as first guess of implicit methods
    for i in range(work.N.size):
        memory.multiplier[i] = work.N[i]
    put_state(control, memory.y[0], memory.t, work)
    find(run, ENERGY, 0)
    memory.kinetic_most = work.kinetic
    memory.energy_least = work.kinetic + work.potential
    if memory.watched.size > 0:
        begin_watch(run)
    memory.started = 1


@kernel_bare
def _first_size(control: Control, memory: Memory) -> float:
    """A first step (s): the part 0.5 rtol^(1/8) of the time in which a member moves by its length."""
    if control.first_step > 0.0:
        return control.first_step
    speed, gain, span, nf = 0.0, 0.0, control.t_end - memory.t, control.free.size
    # |v|/L and |a|/L, the largest over the coordinates
    for i in range(nf):
        speed = max(speed, abs(memory.y[0, nf + i]) / control.length[i])
        gain = max(gain, abs(memory.y[1, nf + i]) / control.length[i])
    pace = max(speed, math.sqrt(gain))
    part = 0.5 * control.rtol**0.125
    if control.method == m.RADAU:
        # the first estimate of its error leaves out what is stiff
        part *= CAREFUL
    return min(span, part / pace) if pace > 0.0 else 1e-3 * span


@kernel_bare
def target(control: Control, memory: Memory, h: float) -> tuple[float, float]:
    """Size (s) and end (s) of a step of about h that ends at no later than the next jump or the end of the run."""
    end, fixed = control.breaks[0, memory.interval + 1], control.fixed_step
    t = memory.t + h
    if fixed > 0.0:
        t = memory.t_start + fixed * (math.floor((memory.t - memory.t_start) / fixed + 1e-6) + 1.0)
        # all alike to the last digit, unless a jump has cut one short
        h = fixed if abs(t - memory.t - fixed) < 1e-9 * fixed else t - memory.t
    if t + 0.01 * h >= end:
        return end - memory.t, end
    return h, t


@kernel_inline
def accept(memory: Memory, h: float, t: float, pivot: float, series: int) -> None:
    """Make a step of h (s) that ends at t (s), with a scaled pivot there, the last one; series : as in the memory."""
    memory.t_old, memory.h_old, memory.t = memory.t, h, t
    memory.pivot, memory.pivot_most = pivot, max(memory.pivot_most, pivot)
    memory.series, memory.alone = series, 0
    memory.steps += 1


@kernel_bare
def _behind(run: Run, samples: Samples) -> None:
    """Behind an accepted step: singular positions, events, stiffness, energy, jumps."""
    control, memory, work = run.control, run.memory, run.work
    keep_between(control, memory, samples, work)
    if memory.t_old < work.near_t < memory.t:
        enter_passage(run)
    if memory.watched.size > 0:
        scan(run)
    if memory.stiff_steps > 15 and _endless(control, memory):
        work.code = m.STIFF
        return
    if control.isolated != 0.0 and _gained(run):
        work.code = m.ENERGY_GROWS
        return
    # where something jumps at the end of the step, the next one starts with the rate behind the jump
    k = memory.interval
    if memory.t >= control.breaks[0, k + 1] and k + 2 < control.breaks.shape[1]:
        memory.interval = k + 1
        _begin_interval(run)


@kernel_bare
def _endless(control: Control, memory: Memory) -> bool:
    """True where steps of the present size would be too many for what is left."""
    left = control.max_steps - memory.steps - memory.rejected
    return control.t_end - memory.t > left * memory.h


@kernel_bare
def _gained(run: Run) -> bool:
    """True where the energy has grown though nothing feeds it."""
    memory, work = run.memory, run.work
    put_state(run.control, memory.y[0], memory.t, work)
    find(run, ENERGY, 0)
    moving = work.kinetic
    energy = moving + work.potential
    memory.kinetic_most = max(memory.kinetic_most, moving)
    memory.energy_least = min(memory.energy_least, energy)
    return energy - memory.energy_least > GAIN * memory.kinetic_most + 1e-9 * abs(energy)
