"""One step of DOP853 on the index-1 form: try, judge, project, accept."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import EVALUATE, PROJECT, Run, find, put_state, take_rate
from kinetruss.kernels.integrate.dop853 import C, dense_coefficients, error_norm, next_step, stage_state, stiffness
from kinetruss.kernels.integrate.loop import LEAST, accept, goes_on, target
from kinetruss.kernels.integrate.samples import NEAR, TURN, gather, turning
from kinetruss.kernels.integrate.singular import crossed, size_avoiding
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work

SHARE, END_SHARE = 0.035, 0.2
"""Least distance of a stage, and of the end of a step, from a singular position: a fraction of the step."""
ROUND_OFF = 0.4
"""Fraction of the tolerance of constraints that counts as round-off."""
ROUND_OFF_MOST = 100.0
"""Error by round-off, as a multiple of the allowed error, above which the step is tried in another size."""
REPEATS = 5
"""Number of times that a step is shortened next to a singular position before a segment crosses it (dynamics.starting)."""
RESIZED_MOST, SMALLER = 12, 0.88
"""Number of other sizes that are tried, and the ratio of each to the one before."""
aside = Apart("run.control.aside_at")
"""The step that other methods take next to a singular position."""
BOUNDARY = 4.5
"""h |lambda| beyond which the method is near the border of its stability (5.97 on the imaginary axis, 6.4 on the real one)."""


@kernel_bare
def dop853_steps(run: Run, samples: Samples) -> None:
    """Steps while the run goes on."""
    while goes_on(run, samples):
        dop853_step(run)


@aside
def dop853_step(run: Run) -> None:
    """One step, of the size that the last one has left, or smaller; where there is none, `code` says why."""
    control, memory, work = run.control, run.memory, run.work
    work.near, work.spoilt, work.repeated, work.resized = 0, 0, 0, 0
    work.size_h, work.most_h, work.near_t = memory.h, 1.05 * memory.h, -math.inf
    work.cap = 0.0 if control.fixed_step > 0.0 else control.pivot_limit * memory.pivot_most
    work.lowest, work.new_pivot = math.inf, memory.pivot
    work.share, work.most = SHARE, max(memory.pivot_most, 1e-300)
    K = work.stages
    # first stage: the rate at the start
    for i in range(memory.y.shape[1]):
        K[0, i] = memory.y[1, i]
    work.start_round_off = _round_off(control, work, 0, memory.pivot)
    while work.code == m.GOING:
        if _begun(control, memory, work) and _stages(run, 1, 12) and _judged(run) and _ended(run):
            _commit(control, memory, work)
            return


@kernel_bare
def _begun(control: Control, memory: Memory, work: Work) -> bool:
    """The size and the end of the next try; False where there is none."""
    h, t = target(control, memory, work.size_h)
    short = not h > LEAST * max(abs(memory.t), control.t_end - memory.t_start)
    singular = min(work.lowest, work.new_pivot, memory.pivot) < work.cap
    if (short or work.repeated >= REPEATS) and singular and work.spoilt == 0 and memory.alone == 0:
        work.code = m.UNDETERMINED
    elif short:
        work.code = m.STEP_TOO_SMALL if work.spoilt == 0 else m.NOT_FINITE
    work.try_h, work.try_t, work.lowest, work.where, work.round_off = h, t, math.inf, 0.0, work.start_round_off
    return work.code == m.GOING


@kernel_bare
def _stages(run: Run, first: int, last: int) -> bool:
    """The rates of some stages; False where one is near a singular position."""
    control, memory, work = run.control, run.memory, run.work
    h, k = work.try_h, memory.interval
    for s in range(first, last):
        stage_state(memory.y[0], work.stages, s, h, work.states[1])
        # a jump at either end belongs to the neighbouring step
        t = min(max(memory.t + C[s] * h, control.breaks[1, k]), control.breaks[2, k])
        put_state(control, work.states[1], t, work)
        # what a stage of the interpolant is off the constraints, next to a singular position it feels 1/p times
        near = s > 12 and work.lowest < work.cap
        find(run, PROJECT | EVALUATE if near or control.stages_projected != 0.0 else EVALUATE, 0)
        take_rate(control, work, work.stages[s])
        pivot = work.new_pivot
        if s < 12 and _near(memory.pivot, work, C[s], work.share):
            _avoid_singular(memory, work, C[s])
            return False
        if pivot < work.lowest:
            work.lowest, work.where = pivot, C[s]
        if s < 12:
            work.pivots[s], work.round_off = pivot, max(work.round_off, _round_off(control, work, s, pivot))
    return True


@kernel_bare
def _near(start: float, work: Work, c: float, share: float) -> bool:
    """True where what was found at the fraction c is nearer to a singular position than `share` of the step.

    The pivot falls from its size at the start in proportion to the distance; early stages cannot be behind the position yet.
    """
    p = work.new_pivot
    if p >= work.cap or work.near >= m.TRIES:
        return False
    return p * c < share * (start + p if c >= 0.25 else start - p)


@kernel_bare
def _singular_at(start: float, work: Work, c: float) -> float:
    """Fraction of the step at which the pivot vanishes, given its size at the start, and what was found at the fraction c.

    It falls in proportion to the distance and is near c, before or behind; which, the lowest one of another stage tells.
    """
    p = work.new_pivot
    best, least = c, math.inf
    # p is linear in the distance: the two places where it vanishes, one before and one behind c
    for sign in (-1.0, 1.0):
        place = c * start / max(start + sign * p, 1e-300)
        off = abs(abs(work.where - place) * start / place - work.lowest) if work.lowest < math.inf else 0.0
        if off < least:
            best, least = place, off
    return best


@kernel_bare
def _avoid_singular(memory: Memory, work: Work, c: float) -> None:
    """Another size, with the singular position between two stages; the end where no size keeps clear of it."""
    h = work.try_h
    memory.rejected += 1
    work.near += 1
    if work.near == m.TRIES and memory.alone == 0:
        work.code = m.UNDETERMINED
        return
    where = _singular_at(memory.pivot, work, c)
    work.near_t = memory.t + where * h
    work.size_h = size_avoiding(where * h, work.most_h)
    work.share *= 0.7


@kernel_bare
def _round_off(control: Control, work: Work, s: int, p: float) -> float:
    """Acceleration (m/s^2) that stage s, of pivot p, loses in round-off; 0 far from singular positions.

    What round-off leaves of the constraints turns the shape by 1/p of it. With q = p/(largest p), 1 far from such positions,
    q changes at the rate v/length, which changes by the acceleration: together the second derivative of 1/p.
    """
    if p >= work.cap:
        return 0.0
    most = work.most
    speed, gain, nf, q, K = 0.0, 0.0, control.free.size, max(p / most, 1e-10), work.stages
    # largest speed and acceleration of the stage
    for i in range(nf):
        speed = max(speed, abs(K[s, i]))
        gain = max(gain, abs(K[s, nf + i]))
    second = speed * speed / (q * control.size)
    return ROUND_OFF * control.tolerance * (second + gain) / (most * q * q)


@kernel_bare
def _scales(control: Control, memory: Memory, h: float, new: F1, work: Work, scale: F1) -> None:
    """Size of errors that count as 1: of a position in parts of member lengths, of a velocity in parts of the largest one.

    Where all come to rest, what is gained in the step counts as velocity. Where a stage has the pivot p, what is left of the
    constraints by round-off turns the shape by 1/p of it, and p falls in time: it is felt in accelerations like the second
    derivative of 1/p, 1/q^3 times with q = p/(largest p): light bodies make p small everywhere, which is no such thing. No
    smaller error can be asked for. What the stages lose at the speed they really have (see `_round_off`), in parts of the error
    allowed, is left in `Work.round_off_error`.
    """
    atol, rtol, nf, y = control.atol, control.rtol, control.free.size, memory.y[0]
    fastest, gain = 0.0, 0.0
    # largest speed of both ends, largest acceleration
    for i in range(nf, 2 * nf):
        fastest = max(fastest, abs(y[i]), abs(new[i]))
        gain = max(gain, abs(memory.y[1, i]))
    fastest = max(fastest, h * gain)
    q = work.lowest / work.most
    round_off_error = atol + ROUND_OFF * control.tolerance * h * gain / (work.most * max(q * q * q, 1e-15))
    work.round_off_error = h * work.round_off / max(atol + rtol * fastest, 1e-300)
    length = control.length
    # atol + rtol (length or speed), and round-off next to singular positions
    for i in range(nf):
        scale[i] = atol + rtol * length[i] + h * round_off_error
        scale[nf + i] = rtol * fastest + round_off_error
    # extra states by their own size
    for i in range(2 * nf, y.size):
        scale[i] = atol + rtol * max(abs(y[i]), abs(new[i]))


@kernel_bare
def _judged(run: Run) -> bool:
    """The error of the step; the new state stays in STATES[2], its scale in STATES[4]. False where it is tried anew."""
    control, memory, work = run.control, run.memory, run.work
    h, K, states = work.try_h, work.stages, work.states
    new, scale = states[2], states[4]
    # state of stage 11, for the estimate of stiffness
    for i in range(new.size):
        states[3, i] = states[1, i]
    stage_state(memory.y[0], K, 12, h, new)
    _scales(control, memory, h, new, work, scale)
    work.error = error_norm(K, h, scale)
    if _resized(memory, work):
        return False
    if not work.error < math.inf or (work.error > 1.0 and not control.fixed_step > 0.0):
        _reject(control, memory, work)
        return False
    return True


@kernel_bare
def _resized(memory: Memory, work: Work) -> bool:
    """True where the step is tried in another size, for a stage has lost too much in round-off; the last try is the best size.

    Turning back just behind a singular position passes it twice in one step, and there may be no size that avoids both: then
    the call ends, for others to step over it, unless they have tried. What the start of the step has lost no size can mend.
    """
    if work.round_off_error <= ROUND_OFF_MOST or work.round_off <= 2.0 * work.start_round_off or work.resized > RESIZED_MOST:
        return False
    if work.resized == 0 or work.round_off_error < work.least_round_off:
        work.least_round_off, work.clear_h = work.round_off_error, work.try_h
    work.resized += 1
    work.size_h = work.try_h * SMALLER if work.resized <= RESIZED_MOST else work.clear_h
    memory.rejected += 1
    if work.resized > RESIZED_MOST and memory.alone == 0:
        work.code = m.UNDETERMINED
    return True


@kernel_bare
def _reject(control: Control, memory: Memory, work: Work) -> None:
    """A smaller step: by the error, or by far where numbers are not finite."""
    memory.rejected += 1
    if work.error < math.inf:
        work.repeated += 1
        work.size_h = work.most_h = next_step(work.try_h, work.error, memory.error_old, False)
        return
    work.spoilt += 1
    work.size_h = work.most_h = 0.1 * work.try_h
    if work.spoilt > 10 or control.fixed_step > 0.0:
        work.code = m.NOT_FINITE


@kernel_bare
def _ended(run: Run) -> bool:
    """Project and evaluate the new state, and find the interpolant if there is a need of it.

    False where the end is near a singular position, or was moved to another branch.
    """
    control, memory, work = run.control, run.memory, run.work
    states, nf = work.states, control.free.size
    new = states[1]
    put_state(control, states[2], work.try_t, work)
    # the factors at hand are of the last stage; next to a singular position every digit counts
    far = control.method != m.RADAU and work.lowest >= control.pivot_limit * memory.pivot_most
    find(run, PROJECT | EVALUATE, 1 if far else 0)
    gather(control.free, work, new)
    moved = 0.0
    # how far the projection has moved the state, in units of the allowed error
    for i in range(nf):
        moved += ((new[i] - states[2, i]) / states[4, i]) ** 2
    if control.fixed_step == 0.0:
        if _near(memory.pivot, work, 1.0, END_SHARE):
            _avoid_singular(memory, work, 1.0)
            return False
        if work.ok == 0.0 or not moved < 100.0 * nf + 1.0:
            work.error = 1e3
            _reject(control, memory, work)
            return False
    take_rate(control, work, work.stages[12])
    work.pivots[0], work.pivots[12] = memory.pivot, work.new_pivot
    where = crossed(work.pivots, memory.pivot_most)
    work.near_t = memory.t + where * work.try_h if where >= 0.0 else -math.inf
    memory.constraint, work.end_pivot = work.moved, work.new_pivot
    memory.stiffness = stiffness(work.stages, states[3], states[2], work.try_h, nf)
    # the projected state is the new one
    for i in range(new.size):
        states[2, i] = new[i]
    passed = memory.t < work.near_t < work.try_t
    # at its end the state itself is the sample, but in a singular position
    inside = work.next_time < work.try_t or work.new_pivot < 2.0 * NEAR * memory.pivot_most
    work.ends_only = 1
    if passed or memory.watched.size > 0 or inside or _turns_far(control, memory, work):
        work.ends_only = 0
        _stages(run, 13, 16)
        dense_coefficients(memory.y[0], states[2], work.stages, work.try_h, memory.dense)
    return True


@kernel_bare
def _turns_far(control: Control, memory: Memory, work: Work) -> bool:
    """True where something turns so far in the step that states between its ends are needed; how fast, into TURNING."""
    fastest, states, y = 0.0, work.states, memory.y
    # rates of turning at both ends
    for k in range(2):
        for i in range(y.shape[1]):
            states[0, i] = states[2, i] if k == 0 else y[0, i]
        put_state(control, states[0], work.ask_t, work)
        fastest = max(fastest, turning(control, work))
    work.turning = fastest
    return fastest * work.try_h > TURN


@kernel_bare
def _commit(control: Control, memory: Memory, work: Work) -> None:
    """The new state, its rate, and the size of the next step."""
    h, error = work.try_h, work.error
    new, rate = work.states[2], work.stages[12]
    # state and rate at the end of the step
    for i in range(memory.y.shape[1]):
        memory.y[0, i] = new[i]
        memory.y[1, i] = rate[i]
    grown = next_step(h, error, memory.error_old, work.repeated > 0)
    if work.round_off_error > 1.0:
        # its error was measured against what round-off spoils, and is no ground for a long step
        grown = min(grown, 2.0 * h)
    # a step cut short, by a jump or a singular position, says nothing against the size before it
    memory.h = grown if h >= memory.h or work.repeated > 0 else max(grown, min(memory.h, 6.0 * h))
    if control.fixed_step > 0.0:
        memory.h = h
    memory.error_old = max(error, 1e-4)
    accept(memory, h, work.try_t, work.end_pivot, 0)
    memory.stiff_steps = memory.stiff_steps + 1 if memory.stiffness > BOUNDARY else max(0, memory.stiff_steps - 1)
