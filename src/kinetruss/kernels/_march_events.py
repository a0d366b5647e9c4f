"""Events: a length, a coordinate or a force passes a value. Found as roots on the dense output of a step."""

from __future__ import annotations

import math

from kinetruss.kernels import _march_state as m
from kinetruss.kernels._jit import kernel_inner
from kinetruss.kernels._march_samples import ask_at, settle
from kinetruss.kernels._parts import integers, matrix, vector

__all__ = ["crossings", "got_look", "got_root", "measure", "scan", "wanted"]

LOOKS = 4
"""Places within a step at which a change of sign is looked for."""


@kernel_inner
def wanted(control):  # type: ignore[no-untyped-def]
    """What the driver has to find for watched quantities: forces need the equations."""
    for e in range(matrix(control, m.WATCHES).shape[0]):
        if matrix(control, m.WATCHES)[e, m.KIND] == m.FORCE:
            return m.PROJECT | m.EVALUATE
    return m.PROJECT


@kernel_inner
def measure(control, room, out):  # type: ignore[no-untyped-def]
    """Watched quantities less their values from the answer of the driver into out (e,)."""
    settle(control, room)
    x = vector(room, m.X)
    for e in range(out.size):
        event = matrix(control, m.WATCHES)[e]
        a, b = int(event[m.NODE_A]), int(event[m.NODE_B])
        if event[m.KIND] == m.LENGTH:
            dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
            out[e] = math.sqrt(dx * dx + dy * dy + dz * dz) - event[m.VALUE]
        elif event[m.KIND] == m.COORDINATE:
            out[e] = x[a] - event[m.VALUE]
        else:
            out[e] = vector(room, m.PULLS)[a] - event[m.VALUE]


@kernel_inner
def scan(control, memory, room):  # type: ignore[no-untyped-def]
    """Begin to look for events in the last step."""
    integers(room, m.AT)[m.LOOK] = 0
    integers(room, m.AT)[m.BEFORE] = memory.count[m.EVENTS]
    vector(room, m.NUM)[m.LEFT] = memory.real[m.T_OLD]
    for e in range(memory.watched.size):
        matrix(room, m.VALUES)[0, e] = memory.watched[e]
    return _look(control, memory, room)


@kernel_inner
def _look(control, memory, room):  # type: ignore[no-untyped-def]
    """Ask for the state at the next place within the step."""
    real, k = memory.real, integers(room, m.AT)[m.LOOK] + 1
    vector(room, m.NUM)[m.RIGHT] = real[m.T] if k == LOOKS else real[m.T_OLD] + real[m.H_OLD] * k / LOOKS
    ask_at(control, memory, vector(room, m.NUM)[m.RIGHT], room)
    integers(room, m.AT)[m.PHASE] = m.GOT_LOOK
    return wanted(control)


@kernel_inner
def got_look(control, room):  # type: ignore[no-untyped-def]
    """Values at a place within the step; go through what has crossed."""
    measure(control, room, matrix(room, m.VALUES)[1])
    integers(room, m.AT)[m.WATCH] = -1
    integers(room, m.AT)[m.PHASE] = m.CROSSINGS
    return 0


@kernel_inner
def _crossed(before, after, direction):  # type: ignore[no-untyped-def]
    """1 or -1 where a value rises or falls through zero in a wanted direction, else 0."""
    if before < 0.0 <= after and direction >= 0:
        return 1
    if before > 0.0 >= after and direction <= 0:
        return -1
    return 0


@kernel_inner
def crossings(control, memory, room):  # type: ignore[no-untyped-def]
    """The next event that has crossed between the last two places: begin to find its time. Else go to the next place."""
    at, num, low, high = integers(room, m.AT), vector(room, m.NUM), matrix(room, m.VALUES)[0], matrix(room, m.VALUES)[1]
    for e in range(at[m.WATCH] + 1, low.size):
        if _crossed(low[e], high[e], matrix(control, m.WATCHES)[e, m.DIRECTION]) != 0:
            at[m.WATCH], at[m.TURN] = e, 0
            num[m.BEST], num[m.LEFT_F] = num[m.LEFT], low[e]
            num[m.SIDE_F], num[m.RIGHT_F] = num[m.RIGHT], high[e]
            return _trial(control, memory, room)
    for e in range(low.size):
        low[e] = high[e]
    num[m.LEFT] = num[m.RIGHT]
    at[m.LOOK] += 1
    if at[m.LOOK] < LOOKS and memory.real[m.STOP] == math.inf:
        return _look(control, memory, room)
    for e in range(low.size):
        memory.watched[e] = low[e]
    _cut(memory, at[m.BEFORE])
    at[m.PHASE] = m.CHECKS
    return 0


@kernel_inner
def _trial(control, memory, room):  # type: ignore[no-untyped-def]
    """Ask for a better time of the event between BEST and SIDE_F; regula falsi, every third time bisection."""
    at, num = integers(room, m.AT), vector(room, m.NUM)
    a, b, fa, fb = num[m.BEST], num[m.SIDE_F], num[m.LEFT_F], num[m.RIGHT_F]
    t = 0.5 * (a + b) if at[m.TURN] % 3 == 2 else b - fb * (b - a) / (fb - fa)
    if not a < t < b:
        t = 0.5 * (a + b)
    if fb == 0.0 or not a < t < b or at[m.TURN] > 100 or b - a <= 4e-16 * max(abs(a), abs(b)):
        return _keep(control, memory, room)
    ask_at(control, memory, t, room)
    at[m.PHASE] = m.GOT_ROOT
    return wanted(control)


@kernel_inner
def got_root(control, memory, room):  # type: ignore[no-untyped-def]
    """The value at a trial time narrows the interval."""
    num, trial, e = vector(room, m.NUM), matrix(room, m.VALUES)[2], integers(room, m.AT)[m.WATCH]
    measure(control, room, trial)
    if trial[e] != 0.0 and (trial[e] < 0.0) == (num[m.LEFT_F] < 0.0):
        num[m.BEST], num[m.LEFT_F] = num[m.ASK_T], trial[e]
    else:
        num[m.SIDE_F], num[m.RIGHT_F] = num[m.ASK_T], trial[e]
    integers(room, m.AT)[m.TURN] += 1
    return _trial(control, memory, room)


@kernel_inner
def _keep(control, memory, room):  # type: ignore[no-untyped-def]
    """Enter an event in its place by time; what exceeds the room is counted but not kept."""
    e, t, k, kept = integers(room, m.AT)[m.WATCH], vector(room, m.NUM)[m.SIDE_F], memory.count[m.EVENTS], memory.events
    way = 1.0 if matrix(room, m.VALUES)[0, e] < 0.0 else -1.0
    if matrix(control, m.WATCHES)[e, m.STOPS] != 0.0 and t < memory.real[m.STOP]:
        memory.real[m.STOP] = t
    if k < kept.shape[0]:
        while k > 0 and kept[k - 1, 1] > t:
            for c in range(4):
                kept[k, c] = kept[k - 1, c]
            k -= 1
        kept[k, 0], kept[k, 1], kept[k, 2], kept[k, 3] = e, t, way, matrix(control, m.WATCHES)[e, m.VALUE]
    memory.count[m.EVENTS] += 1
    integers(room, m.AT)[m.PHASE] = m.CROSSINGS
    return 0


@kernel_inner
def _cut(memory, before):  # type: ignore[no-untyped-def]
    """What would come behind a stop does not happen."""
    count, kept = memory.count, memory.events
    while before < count[m.EVENTS] <= kept.shape[0] and kept[count[m.EVENTS] - 1, 1] > memory.real[m.STOP]:
        count[m.EVENTS] -= 1
