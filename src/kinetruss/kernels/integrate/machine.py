"""The course of an integration without any equations, by reverse communication: the next request, given the last reply.

A driver calls `proceed`, does what it requests (project, evaluate, energy, a step of an implicit method) for the state in
`Work`, and calls again, until the request is FINISH. So the equations enter one small function, and are compiled into it once.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.dop853_step import begin_step, got_new, got_stage, try_step
from kinetruss.kernels.integrate.events import begin_watch, got_look, got_root, next_root, scan, wanted
from kinetruss.kernels.integrate.samples import ask_at, ask_state, got_last, got_sample, keep_between, must_drain, next_sample
from kinetruss.kernels.integrate.singular import begin_passage, passage_left, passage_middle, passage_right, passage_vertex
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work

__all__ = ["proceed"]

SINGULAR = 1e-6
"""Scaled pivot, relative to the largest one met, below which no series begins."""
CAREFUL = 0.1
"""First step of Radau IIA, relative to that of other methods."""
GAIN = 1e-3
"""Growth of energy without any source, relative to the largest kinetic energy, at which a run stops."""


@kernel_bare
def proceed(control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Take the reply to the last request; returns the next request."""
    # phases that need nothing from the equations follow one another here
    while True:
        phase = work.phase
        if phase == m.GOT_STAGE:
            ask = got_stage(control, memory, work)
        elif phase < m.TRY:
            ask = _outside(phase, control, memory, samples, work)
        elif phase == m.TRY:
            ask = try_step(control, memory, work)
        elif phase == m.GOT_NEW:
            ask = got_new(control, memory, samples, work)
        else:
            ask = _behind(phase, control, memory, samples, work)
        if ask != 0:
            return ask


@kernel_bare
def _outside(phase: int, control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Phases between steps: the start, output, the decision to go on."""
    if phase == m.BEGIN:
        return _begin(control, memory, work)
    if phase == m.START_RATE:
        return _start_rate(control, memory, work)
    if phase == m.START_ENERGY:
        return _start_energy(control, memory, work)
    if phase == m.START_WATCH:
        begin_watch(control, memory, work)
        return _started(memory, work)
    if phase == m.GOT_SAMPLE:
        return got_sample(control, memory, samples, work)
    if phase == m.GOT_LAST:
        return got_last(control, memory, samples, work)
    return _loop(control, memory, samples, work)


@kernel_bare
def _behind(phase: int, control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Phases behind an accepted step: singular positions, events, energy, jumps."""
    if phase == m.COMMITTED:
        work.phase = m.SCAN
        keep_between(control, memory, samples, work)
        if memory.t_old < work.near_t < memory.t:
            return begin_passage(control, memory, work)
        return 0
    if phase == m.SCAN:
        work.phase = m.CHECKS
        return scan(control, memory, work) if memory.watched.size > 0 else 0
    if phase == m.GOT_LOOK:
        return got_look(control, memory, work)
    if phase == m.CROSSINGS:
        return next_root(control, memory, work)
    if phase == m.GOT_ROOT:
        return got_root(control, memory, work)
    if phase == m.PASSAGE_MIDDLE:
        return passage_middle(control, memory, work)
    if phase == m.PASSAGE_LEFT:
        return passage_left(control, memory, work)
    if phase == m.PASSAGE_RIGHT:
        return passage_right(control, memory, work)
    if phase == m.PASSAGE_VERTEX:
        return passage_vertex(control, memory, work)
    if phase == m.CHECKS:
        return _checks(control, memory, work)
    if phase == m.GOT_ENERGY:
        return _got_energy(memory, work)
    return _jump(phase, control, memory, work)


@kernel_bare
def _end(code: int, work: Work) -> int:
    work.code, work.phase = code, m.END
    return m.FINISH


@kernel_bare
def _ask_rate(control: Control, memory: Memory, work: Work, phase: int) -> int:
    """Ask for the rate of the present state, just behind the start of its interval."""
    k = memory.interval
    ask_state(
        control.free,
        memory.y[0],
        min(max(memory.t, control.breaks[1, k]), control.breaks[2, k]),
        work,
    )
    work.phase = phase
    return m.EVALUATE


@kernel_bare
def _take_rate(control: Control, memory: Memory, work: Work) -> None:
    nf = control.free.size
    # y' = (v, a) of the free coordinates
    for i in range(nf):
        memory.y[1, i] = work.v[control.free[i]]
        memory.y[1, nf + i] = work.a[control.free[i]]


@kernel_bare
def _begin(control: Control, memory: Memory, work: Work) -> int:
    """Go on from the memory, or start."""
    if memory.started:
        # behind a step from outside, what comes behind every step
        work.phase = m.COMMITTED if memory.launched else m.LOOP
        work.near_t = -math.inf
        memory.launched = 0
        return 0
    memory.t_start = memory.t_old = memory.t
    memory.h_old, memory.error_old, memory.stop = 0.0, 1e-4, math.inf
    return _ask_rate(control, memory, work, m.START_RATE)


@kernel_bare
def _start_rate(control: Control, memory: Memory, work: Work) -> int:
    """Rate, pivot and first size of step are known; ask for the energy."""
    _take_rate(control, memory, work)
    memory.pivot = memory.pivot_most = work.new_pivot
    memory.h = _first_size(control, memory)
    # multipliers at the start, as first guess of implicit methods
    for i in range(work.N.size):
        memory.multiplier[i] = work.N[i]
    ask_state(control.free, memory.y[0], memory.t, work)
    work.phase = m.START_ENERGY
    return m.ENERGY


@kernel_bare
def _start_energy(control: Control, memory: Memory, work: Work) -> int:
    memory.kinetic_most = work.kinetic
    memory.energy_least = work.kinetic + work.potential
    if memory.watched.size == 0:
        return _started(memory, work)
    ask_at(control, memory, memory.t, work)
    work.phase = m.START_WATCH
    return _most_wanted(control)


@kernel_bare
def _most_wanted(control: Control) -> int:
    """What the driver has to find for all watched quantities."""
    ask = 0
    # union of what the watched quantities need
    for e in range(control.event_kind.size):
        ask |= wanted(control, e)
    return ask


@kernel_bare
def _started(memory: Memory, work: Work) -> int:
    memory.started = 1
    work.phase = m.LOOP
    return 0


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
def _loop(control: Control, memory: Memory, samples: Samples, work: Work) -> int:
    """Output that is due, or another step."""
    ask = next_sample(control, memory, samples, work)
    if ask != 0:
        return ask
    if work.next_sample >= work.last_sample or memory.t >= control.t_end:
        return _end(m.DONE, work)
    if work.budget <= 0 or must_drain(memory):
        return _end(m.PAUSED, work)
    if memory.steps + memory.rejected >= control.max_steps:
        return _end(m.TOO_MANY_STEPS, work)
    work.budget -= 1
    # a singular start is left by steps whose stages lie beside it
    if work.explicit == 1 or (work.explicit == m.BY_SERIES and memory.pivot < SINGULAR * memory.pivot_most):
        return begin_step(control, memory, work)
    work.phase = m.GOT_STEP
    return m.STEP


@kernel_bare
def _checks(control: Control, memory: Memory, work: Work) -> int:
    """Stiffness; energy where nothing feeds it."""
    if memory.stiff_steps > 15 and _endless(control, memory):
        return _end(m.STIFF, work)
    work.phase = m.JUMP
    if control.isolated == 0.0:
        return 0
    ask_state(control.free, memory.y[0], memory.t, work)
    work.phase = m.GOT_ENERGY
    return m.ENERGY


@kernel_bare
def _endless(control: Control, memory: Memory) -> bool:
    """True where steps of the present size would be too many for what is left."""
    left = control.max_steps - memory.steps - memory.rejected
    return control.t_end - memory.t > left * memory.h


@kernel_bare
def _got_energy(memory: Memory, work: Work) -> int:
    """Stop where the energy has grown though nothing feeds it."""
    moving = work.kinetic
    energy = moving + work.potential
    memory.kinetic_most = max(memory.kinetic_most, moving)
    memory.energy_least = min(memory.energy_least, energy)
    work.phase = m.JUMP
    if energy - memory.energy_least > GAIN * memory.kinetic_most + 1e-9 * abs(energy):
        return _end(m.ENERGY_GROWS, work)
    return 0


@kernel_bare
def _jump(phase: int, control: Control, memory: Memory, work: Work) -> int:
    """Where something jumps at the end of the step, the next one starts with the rate behind the jump."""
    k = memory.interval
    if phase == m.GOT_STEP:
        work.phase = m.COMMITTED
        return 0 if work.ok > 0.0 else _end(work.code, work)
    if phase == m.GOT_JUMP:
        _take_rate(control, memory, work)
    elif memory.t >= control.breaks[0, k + 1] and k + 2 < control.breaks.shape[1]:
        memory.interval = k + 1
        return _ask_rate(control, memory, work, m.GOT_JUMP)
    work.phase = m.LOOP
    return 0
