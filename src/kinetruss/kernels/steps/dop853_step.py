"""One step of DOP853 on the index-1 form: try, judge, project, accept. Questions go to the driver, answers come back."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_inline, kernel_inner
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.between import TURN, turning
from kinetruss.kernels.integrate.samples import NEAR, ask_state, gather
from kinetruss.kernels.integrate.singular import crossed, size_around
from kinetruss.kernels.integrate.state import Control, Room
from kinetruss.kernels.steps.dop853 import dense_coefficients, error_norm, next_step, stage_state, stiffness
from kinetruss.kernels.steps.dop853_table import C

__all__ = ["begin_step", "got_new", "got_stage", "target", "try_step"]

LEAST = 1e-14
"""Smallest step, in parts of the time or of the whole run."""
SHARE, END_SHARE = 0.035, 0.2
"""Parts of a step that stages and its end keep away from singular positions."""
BLUR = 0.4
"""Part of the tolerance of constraints that is taken for round-off."""
BLURRED = 100.0
"""Error by round-off, in parts of the one allowed, beyond which stages of a step had better lie elsewhere."""
REPEATS = 5
"""Times that a step is shortened next to a singular position before others may step over it."""
BLURS, SMALLER = 12, 0.88
"""Other sizes tried for it, each this part of the one before."""
BOUNDARY = 4.5
"""h |lambda| beyond which the method is near the border of its stability (5.97 on the imaginary axis, 6.4 on the real one)."""


@kernel_inner
def target(control: Control, memory, h):  # type: ignore[no-untyped-def]
    """Size (s) and end (s) of a step of about h that ends at no later than the next jump or the end of the run."""
    real, end, fixed = (
        memory.real,
        control.breaks[0, memory.count[m.BREAK] + 1],
        control.real[m.FIXED_STEP],
    )
    t = real[m.T] + h
    if fixed > 0.0:
        t = real[m.T_START] + fixed * (math.floor((real[m.T] - real[m.T_START]) / fixed + 1e-6) + 1.0)
        # all alike to the last digit, unless a jump has cut one short
        h = fixed if abs(t - real[m.T] - fixed) < 1e-9 * fixed else t - real[m.T]
    if t + 0.01 * h >= end:
        return end - real[m.T], end
    return h, t


@kernel_inner
def begin_step(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """A step of the size that the last one has left."""
    at, num, fixed = room.at, room.num, control.real[m.FIXED_STEP] > 0.0
    at[m.NEAR], at[m.SPOILT], at[m.REPEATED], at[m.BLURS] = 0, 0, 0, 0
    num[m.SIZE_H], num[m.MOST_H], num[m.NEAR_T] = memory.real[m.H], 1.05 * memory.real[m.H], -math.inf
    num[m.CAP] = 0.0 if fixed else control.real[m.PIVOT_LIMIT] * memory.real[m.PIVOT_MOST]
    num[m.LOWEST], num[m.NEW_PIVOT] = math.inf, memory.real[m.PIVOT]
    num[m.SHARE], num[m.MOST] = SHARE, max(memory.real[m.PIVOT_MOST], 1e-300)
    K = room.stages
    for i in range(memory.y.shape[1]):
        K[0, i] = memory.y[1, i]
    num[m.START_BLUR] = _blur(control, room, 0, memory.real[m.PIVOT])
    at[m.PHASE] = m.TRY
    return 0


@kernel_inner
def try_step(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """First stage of a step of the size in hand."""
    real, at, num = memory.real, room.at, room.num
    h, t = target(control, memory, num[m.SIZE_H])
    short = not h > LEAST * max(abs(real[m.T]), control.real[m.T_END] - real[m.T_START])
    singular = min(num[m.LOWEST], num[m.NEW_PIVOT], real[m.PIVOT]) < num[m.CAP]
    if (short or at[m.REPEATED] >= REPEATS) and singular and at[m.SPOILT] == 0 and memory.count[m.ALONE] == 0:
        at[m.CODE], at[m.PHASE] = m.BLIND, m.END
        return m.FINISH
    if short:
        at[m.CODE] = m.STEP_TOO_SMALL if at[m.SPOILT] == 0 else m.NOT_FINITE
        at[m.PHASE] = m.END
        return m.FINISH
    num[m.TRY_H], num[m.TRY_T], num[m.LOWEST], num[m.WHERE], num[m.BLUR] = h, t, math.inf, 0.0, num[m.START_BLUR]
    at[m.STAGE], at[m.END_STAGE] = 1, 12
    return _ask_stage(control, memory, room)


@kernel_inner
def _ask_stage(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    s, h, k = room.at[m.STAGE], room.num[m.TRY_H], memory.count[m.BREAK]
    stage_state(memory.y[0], room.stages, s, h, room.states[1])
    # a jump at either end belongs to the neighbouring step
    t = min(max(memory.real[m.T] + C[s] * h, control.breaks[1, k]), control.breaks[2, k])
    ask_state(control.free, room.states[1], t, room)
    room.at[m.PHASE] = m.GOT_STAGE
    # what a stage of the interpolant is off the constraints, next to a singular position it feels 1/p times
    near = s > 12 and room.num[m.LOWEST] < room.num[m.CAP]
    return m.PROJECT | m.EVALUATE if near or control.real[m.STAGES_PROJECTED] != 0.0 else m.EVALUATE


@kernel_inline
def _take_rate(free, room: Room, s):  # type: ignore[no-untyped-def]
    """Rate of the state that was asked into STAGES[s]."""
    nf, K, v, a = free.size, room.stages, room.v, room.a
    for i in range(nf):
        K[s, i] = v[free[i]]
        K[s, nf + i] = a[free[i]]


@kernel_inner
def got_stage(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """Next stage, or what follows the last one."""
    at, num, s = room.at, room.num, room.at[m.STAGE]
    _take_rate(control.free, room, s)
    pivot = num[m.NEW_PIVOT]
    if s < 12 and _near(memory.real[m.PIVOT], room, C[s], num[m.SHARE]):
        return _go_around(memory, room, C[s])
    if pivot < num[m.LOWEST]:
        num[m.LOWEST], num[m.WHERE] = pivot, C[s]
    if s < 13:
        num[m.PIVOTS + s], num[m.BLUR] = pivot, max(num[m.BLUR], _blur(control, room, s, pivot))
    at[m.STAGE] = s + 1
    if s + 1 < at[m.END_STAGE]:
        return _ask_stage(control, memory, room)
    if s == 15:
        dense_coefficients(memory.y[0], room.states[2], room.stages, num[m.TRY_H], memory.dense)
        return _commit(control, memory, room)
    return _judge(control, memory, room)


@kernel_inner
def _near(start, room: Room, c, share):  # type: ignore[no-untyped-def]
    """True where the answer at the fraction c is nearer to a singular position than `share` of the step.

    The pivot falls from its size at the start in proportion to the distance; early stages cannot be behind the position yet.
    """
    p = room.num[m.NEW_PIVOT]
    if p >= room.num[m.CAP] or room.at[m.NEAR] >= m.TRIES:
        return False
    return p * c < share * (start + p if c >= 0.25 else start - p)


@kernel_inner
def _singular_at(start, room: Room, c):  # type: ignore[no-untyped-def]
    """Fraction of the step at which the pivot vanishes, given its size at the start, and its answer at the fraction c.

    It falls in proportion to the distance and is near c, before or behind; which, the lowest one of another stage tells.
    """
    p, num = room.num[m.NEW_PIVOT], room.num
    best, least = c, math.inf
    for sign in (-1.0, 1.0):
        place = c * start / max(start + sign * p, 1e-300)
        off = abs(abs(num[m.WHERE] - place) * start / place - num[m.LOWEST]) if num[m.LOWEST] < math.inf else 0.0
        if off < least:
            best, least = place, off
    return best


@kernel_inner
def _go_around(memory, room: Room, c):  # type: ignore[no-untyped-def]
    """Another size, with the singular position between two stages."""
    num, h = room.num, room.num[m.TRY_H]
    memory.count[m.REJECTED] += 1
    room.at[m.NEAR] += 1
    if room.at[m.NEAR] == m.TRIES and memory.count[m.ALONE] == 0:
        # no size keeps clear of it
        room.at[m.CODE], room.at[m.PHASE] = m.BLIND, m.END
        return m.FINISH
    where = _singular_at(memory.real[m.PIVOT], room, c)
    num[m.NEAR_T] = memory.real[m.T] + where * h
    num[m.SIZE_H] = size_around(where * h, num[m.MOST_H])
    num[m.SHARE] *= 0.7
    room.at[m.PHASE] = m.TRY
    return 0


@kernel_inner
def _blur(control: Control, room: Room, s, p):  # type: ignore[no-untyped-def]
    """Acceleration (m/s^2) that stage s, of pivot p, loses in round-off; 0 far from singular positions.

    What round-off leaves of the constraints turns the shape by 1/p of it. With q = p/(largest p), 1 far from such positions,
    q changes at the rate v/length, which changes by the acceleration: together the second derivative of 1/p.
    """
    if p >= room.num[m.CAP]:
        return 0.0
    most = room.num[m.MOST]
    speed, gain, nf, q, K = 0.0, 0.0, control.free.size, max(p / most, 1e-10), room.stages
    for i in range(nf):
        speed = max(speed, abs(K[s, i]))
        gain = max(gain, abs(K[s, nf + i]))
    bend = speed * speed / (q * control.real[m.SIZE])
    return BLUR * control.real[m.TOLERANCE] * (bend + gain) / (most * q * q)


@kernel_inner
def _scales(control: Control, memory, h, new, num, scale):  # type: ignore[no-untyped-def]
    """Size of errors that count as 1: of a position in parts of member lengths, of a velocity in parts of the largest one.

    Where all come to rest, what is gained in the step counts as velocity. Where a stage has the pivot p, what is left of the
    constraints by round-off turns the shape by 1/p of it, and p falls in time: it is felt in accelerations like the second
    derivative of 1/p, 1/q^3 times with q = p/(largest p): light bodies make p small everywhere, which is no such thing. No
    smaller error can be asked for. What the stages lose at the speed they really have (see `_blur`), in parts of the error
    allowed, is left in num[BLURRED].
    """
    atol, rtol, nf, y = (
        control.real[m.ATOL],
        control.real[m.RTOL],
        control.free.size,
        memory.y[0],
    )
    fastest, gain = 0.0, 0.0
    for i in range(nf, 2 * nf):
        fastest = max(fastest, abs(y[i]), abs(new[i]))
        gain = max(gain, abs(memory.y[1, i]))
    fastest = max(fastest, h * gain)
    q = num[m.LOWEST] / num[m.MOST]
    blurred = atol + BLUR * control.real[m.TOLERANCE] * h * gain / (num[m.MOST] * max(q * q * q, 1e-15))
    num[m.BLURRED] = h * num[m.BLUR] / max(atol + rtol * fastest, 1e-300)
    length = control.length
    for i in range(nf):
        scale[i] = atol + rtol * length[i] + h * blurred
        scale[nf + i] = rtol * fastest + blurred
    for i in range(2 * nf, y.size):
        scale[i] = atol + rtol * max(abs(y[i]), abs(new[i]))


@kernel_inner
def _judge(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """The error of the step; a good new state is projected and evaluated. It stays in STATES[2], its scale in STATES[4]."""
    num, h, K, states = room.num, room.num[m.TRY_H], room.stages, room.states
    new, scale = states[2], states[4]
    for i in range(new.size):
        states[3, i] = states[1, i]
    stage_state(memory.y[0], K, 12, h, new)
    _scales(control, memory, h, new, num, scale)
    num[m.ERROR] = error_norm(K, h, scale)
    fixed = control.real[m.FIXED_STEP] > 0.0
    if _elsewhere(memory, room):
        return m.FINISH if room.at[m.PHASE] == m.END else 0
    if not num[m.ERROR] < math.inf or (num[m.ERROR] > 1.0 and not fixed):
        return _reject(control, memory, room)
    ask_state(control.free, new, num[m.TRY_T], room)
    room.at[m.PHASE] = m.GOT_NEW
    return m.PROJECT | m.EVALUATE


@kernel_inner
def _elsewhere(memory, room: Room):  # type: ignore[no-untyped-def]
    """True where the step is tried in another size, for a stage has lost too much in round-off; the last try is the best size.

    Turning back just behind a singular position passes it twice in one step, and there may be no size that avoids both: then
    the call ends, for others to step over it, unless they have tried. What the start of the step has lost no size can mend.
    """
    at, num = room.at, room.num
    if num[m.BLURRED] <= BLURRED or num[m.BLUR] <= 2.0 * num[m.START_BLUR] or at[m.BLURS] > BLURS:
        return False
    if at[m.BLURS] == 0 or num[m.BLURRED] < num[m.LEAST_BLURRED]:
        num[m.LEAST_BLURRED], num[m.CLEAR_H] = num[m.BLURRED], num[m.TRY_H]
    at[m.BLURS] += 1
    num[m.SIZE_H] = num[m.TRY_H] * SMALLER if at[m.BLURS] <= BLURS else num[m.CLEAR_H]
    memory.count[m.REJECTED] += 1
    at[m.PHASE] = m.TRY
    if at[m.BLURS] > BLURS and memory.count[m.ALONE] == 0:
        at[m.CODE], at[m.PHASE] = m.BLIND, m.END
    return True


@kernel_inner
def _reject(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """A smaller step: by the error, or by far where numbers are not finite."""
    at, num = room.at, room.num
    memory.count[m.REJECTED] += 1
    at[m.PHASE] = m.TRY
    if num[m.ERROR] < math.inf:
        at[m.REPEATED] += 1
        num[m.SIZE_H] = num[m.MOST_H] = next_step(num[m.TRY_H], num[m.ERROR], memory.real[m.ERROR_OLD], False)
        return 0
    at[m.SPOILT] += 1
    num[m.SIZE_H] = num[m.MOST_H] = 0.1 * num[m.TRY_H]
    if at[m.SPOILT] > 10 or control.real[m.FIXED_STEP] > 0.0:
        at[m.CODE], at[m.PHASE] = m.NOT_FINITE, m.END
        return m.FINISH
    return 0


@kernel_inner
def got_new(control: Control, memory, samples, room: Room):  # type: ignore[no-untyped-def]
    """Accept the projected state, unless it is near a singular position, or was moved to another branch."""
    at, num, states, nf = room.at, room.num, room.states, control.free.size
    new = states[1]
    gather(control.free, room, new)
    moved = 0.0
    for i in range(nf):
        moved += ((new[i] - states[2, i]) / states[4, i]) ** 2
    if control.real[m.FIXED_STEP] == 0.0:
        if _near(memory.real[m.PIVOT], room, 1.0, END_SHARE):
            return _go_around(memory, room, 1.0)
        if num[m.OK] == 0.0 or not moved < 100.0 * nf + 1.0:
            num[m.ERROR] = 1e3
            return _reject(control, memory, room)
    _take_rate(control.free, room, 12)
    num[m.PIVOTS], num[m.PIVOTS + 12] = memory.real[m.PIVOT], num[m.NEW_PIVOT]
    where = crossed(num[m.PIVOTS :], memory.real[m.PIVOT_MOST])
    num[m.NEAR_T] = memory.real[m.T] + where * num[m.TRY_H] if where >= 0.0 else -math.inf
    memory.real[m.CONSTRAINT], num[m.END_PIVOT] = num[m.MOVED], num[m.NEW_PIVOT]
    memory.real[m.STIFFNESS] = stiffness(room.stages, states[3], states[2], num[m.TRY_H], nf)
    for i in range(new.size):
        states[2, i] = new[i]
    passed = memory.real[m.T] < num[m.NEAR_T] < num[m.TRY_T]
    # at its end the state itself is the sample, but in a singular position
    inside = samples.times[at[m.SAMPLE]] < num[m.TRY_T] or num[m.NEW_PIVOT] < 2.0 * NEAR * memory.real[m.PIVOT_MOST]
    if passed or memory.watched.size > 0 or (at[m.SAMPLE] < at[m.LAST] and inside) or _turns_far(control, memory, room):
        at[m.STAGE], at[m.END_STAGE] = 13, 16
        return _ask_stage(control, memory, room)
    return _commit(control, memory, room)


@kernel_inner
def _turns_far(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """True where something turns so far in the step that states between its ends are needed; how fast, into TURNING."""
    num, fastest, states, y = room.num, 0.0, room.states, memory.y
    for k in range(2):
        for i in range(y.shape[1]):
            states[0, i] = states[2, i] if k == 0 else y[0, i]
        ask_state(control.free, states[0], num[m.ASK_T], room)
        fastest = max(fastest, turning(control, room))
    num[m.TURNING] = fastest
    return fastest * num[m.TRY_H] > TURN


@kernel_inner
def _commit(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """The new state, its rate, and the size of the next step."""
    real, count, num, at = memory.real, memory.count, room.num, room.at
    h, error = num[m.TRY_H], num[m.ERROR]
    real[m.T_OLD], real[m.H_OLD], real[m.T] = real[m.T], h, num[m.TRY_T]
    new, rate = room.states[2], room.stages[12]
    for i in range(memory.y.shape[1]):
        memory.y[0, i] = new[i]
        memory.y[1, i] = rate[i]
    grown = next_step(h, error, real[m.ERROR_OLD], at[m.REPEATED] > 0)
    if num[m.BLURRED] > 1.0:
        # its error was measured against what round-off spoils, and is no ground for a long step
        grown = min(grown, 2.0 * h)
    # a step cut short, by a jump or a singular position, says nothing against the size before it
    real[m.H] = grown if h >= real[m.H] or at[m.REPEATED] > 0 else max(grown, min(real[m.H], 6.0 * h))
    if control.real[m.FIXED_STEP] > 0.0:
        real[m.H] = h
    real[m.ERROR_OLD], real[m.PIVOT] = max(error, 1e-4), num[m.END_PIVOT]
    real[m.PIVOT_MOST] = max(real[m.PIVOT_MOST], real[m.PIVOT])
    count[m.STEPS] += 1
    count[m.SERIES] = 0
    count[m.ALONE] = 0
    count[m.STIFF_STEPS] = count[m.STIFF_STEPS] + 1 if real[m.STIFFNESS] > BOUNDARY else max(0, count[m.STIFF_STEPS] - 1)
    at[m.PHASE] = m.COMMITTED
    return 0
