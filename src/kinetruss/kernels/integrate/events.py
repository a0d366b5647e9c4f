"""Events: a length, a coordinate or a force arrives at a value. All of them in a step, as roots of its own polynomial.

Coordinates, and squares of lengths, are polynomials in a step. Forces, and what prescribed motions move, are not: they are
sampled at Chebyshev's places, in halves of halves until the polynomial through the samples has converged. Either polynomial
gives all its roots (_event_roots); a root is then drawn to where the projected state has the value.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_inner
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.roots import DEGREE, NODES, TO_BERNSTEIN, bernstein, roots
from kinetruss.kernels.integrate.samples import ask_at, settle
from kinetruss.kernels.integrate.state import Control, Room

__all__ = ["begin_watch", "got_look", "got_root", "next_root", "scan", "wanted"]

BAND, FORCE_BAND = 1e-12, 1e-10
"""Distance from its value at which a quantity counts as being there: in parts of it and of a member, of the largest force."""
START = 100.0
"""The same at the start of a run, in parts of the other."""
ROUND_OFF = 16 * 2.2e-16
"""Of the polynomials, in parts of the sum of their coefficients."""
CONVERGED = 1e-8
"""Last coefficients of a polynomial through samples, in parts of its scale."""
NARROWEST = 1.0 / 64.0
"""Part of a step that is not halved again for samples, as next to a singular position."""
TURNS = 6
# the basis of the interpolant of DOP853 (see _dop853.interpolate) in powers of s
POWERS = np.zeros((8, 8))
POWERS[0, 0] = 1.0
for _k in range(7):
    if _k % 2 == 0:
        POWERS[_k + 1, 1:] = POWERS[_k, :-1]
    else:
        POWERS[_k + 1] = POWERS[_k]
        POWERS[_k + 1, 1:] -= POWERS[_k, :-1]
_PLACES = np.pi * np.arange(DEGREE + 1) / DEGREE
_ENDS = np.where((np.arange(DEGREE + 1) == 0) | (np.arange(DEGREE + 1) == DEGREE), 0.5, 1.0)
LAST = np.stack([np.cos(DEGREE * _PLACES) * _ENDS / DEGREE, 2.0 * np.cos((DEGREE - 1) * _PLACES) * _ENDS / DEGREE])
"""The last two Chebyshev coefficients from samples."""


@kernel_inner
def wanted(control: Control, e):  # type: ignore[no-untyped-def]
    """What the driver has to find for a watched quantity: forces need the equations."""
    return m.PROJECT | m.EVALUATE if control.events[e, m.KIND] == m.FORCE else m.PROJECT


@kernel_inner
def _measure(control: Control, room: Room, e):  # type: ignore[no-untyped-def]
    """Quantity e less its value, from the answer of the driver, and the size of what it is compared with."""
    settle(control, room)
    event, x = control.events[e], room.x
    a, b, scale = int(event[m.NODE_A]), int(event[m.NODE_B]), abs(event[m.VALUE])
    if event[m.KIND] == m.FORCE:
        pulls = room.pulls
        for k in range(pulls.size):
            scale = max(scale, abs(pulls[k]))
        return pulls[a] - event[m.VALUE], scale
    scale += control.real[m.SIZE]
    if event[m.KIND] == m.COORDINATE:
        return x[a] - event[m.VALUE], scale
    dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
    return math.sqrt(dx * dx + dy * dy + dz * dz) - event[m.VALUE], scale


@kernel_inner
def _band(control: Control, e):  # type: ignore[no-untyped-def]
    return FORCE_BAND if control.events[e, m.KIND] == m.FORCE else BAND


@kernel_inner
def begin_watch(control, memory, room):  # type: ignore[no-untyped-def]
    """The side on which every quantity is at the start: 0 where it stands at its value."""
    for e in range(memory.watched.size):
        gap, scale = _measure(control, room, e)
        off = START * _band(control, e) * scale
        memory.watched[e] = 1.0 if gap > off else (-1.0 if gap < -off else 0.0)


@kernel_inner
def scan(control, memory, room: Room):  # type: ignore[no-untyped-def]
    """Begin to look for events in the last step."""
    room.at[m.BEFORE] = memory.count[m.EVENTS]
    room.at[m.WATCH] = -1
    return _next_event(control, memory, room)


@kernel_inner
def _next_event(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """All roots of the next quantity; behind the last one, what comes behind events."""
    at = room.at
    at[m.WATCH] += 1
    at[m.FOUND], at[m.TURN] = 0, 0
    if at[m.WATCH] == memory.watched.size:
        _cut(memory, at[m.BEFORE])
        at[m.PHASE] = m.CHECKS
        return 0
    if control.events[at[m.WATCH], m.SAMPLED] != 0.0:
        pieces = room.spans
        pieces[0, 0], pieces[0, 1], at[m.LOOK], at[m.TOP] = 0.0, 1.0, 0, 1
        room.num[m.RIGHT] = 0.0
        return _look(control, memory, room)
    n, size = _polynomial(control, memory, room, at[m.WATCH])
    scale = abs(control.events[at[m.WATCH], m.VALUE]) + control.real[m.SIZE]
    if control.events[at[m.WATCH], m.KIND] == m.LENGTH:
        # a square is off by twice the length times its error
        scale *= max(2.0 * abs(control.events[at[m.WATCH], m.VALUE]), BAND * scale)
    _isolate(memory, room, at[m.WATCH], n, max(BAND * scale, ROUND_OFF * size), START * BAND * scale, 0.0, 1.0)
    at[m.PHASE] = m.CROSSINGS
    return 0


@kernel_inner
def _isolate(memory, room: Room, e, n, band, level, low, width):  # type: ignore[no-untyped-def]
    """Append the roots of the polynomial in POLYNOMIALS[3], over the part of the step from `low` on."""
    at, found, piece = room.at, room.roots, room.piece_roots
    b, stack, spare = room.polynomials[3], room.stack, room.polynomials[4]
    if memory.count[m.STEPS] > 1 or low > 0.0:
        level = 0.0
    count, side = roots(b, n, int(memory.watched[e]), band, level, stack, piece, spare)
    memory.watched[e] = side
    for k in range(count):
        if at[m.FOUND] < found.shape[0]:
            row = found[at[m.FOUND]]
            row[0], row[1], row[2] = low + width * piece[k, 0], piece[k, 1], piece[k, 2] / width
            at[m.FOUND] += 1


@kernel_inner
def _powers(memory, i, out):  # type: ignore[no-untyped-def]
    """Coordinate i of the state in powers of the fraction of the step into out; ends exactly at the new state."""
    F, count = memory.dense, memory.dense.shape[0] if memory.count[m.SERIES] != 0 else 8
    for j in range(count):
        out[j] = F[j, i]
    if memory.count[m.SERIES] == 0:
        for j in range(8):
            out[j] = 0.0
            for k in range(8):
                out[j] += POWERS[k, j] * F[k, i]
    total = 0.0
    for j in range(count - 1, -1, -1):
        total += out[j]
    out[1] += memory.y[0, i] - total
    return count


@kernel_inner
def _polynomial(control: Control, memory, room: Room, e):  # type: ignore[no-untyped-def]
    """A coordinate less its value, or the square of a length less that of its value, into POLYNOMIALS[3] (Bernstein).

    Returns the degree and the sum of the sizes of the coefficients.
    """
    event, P, x = control.events[e], room.polynomials, control.stand
    count = memory.dense.shape[0] if memory.count[m.SERIES] != 0 else 8
    if event[m.KIND] == m.COORDINATE:
        if event[m.PLACE_A] >= 0.0:
            _powers(memory, int(event[m.PLACE_A]), P[4])
        else:
            for j in range(count):
                P[4, j] = x[int(event[m.NODE_A])] if j == 0 else 0.0
        P[4, 0] -= event[m.VALUE]
        return count - 1, bernstein(P[4], count - 1, P[3])
    n = 2 * (count - 1)
    for j in range(n + 1):
        P[4, j] = 0.0
    for c in range(3):
        d, other = P[c], P[3]
        for j in range(count):
            d[j] = 0.0
        for end in range(2):
            i = int(event[m.PLACE_A + 3 * end + c])
            sign = 1.0 if end == 1 else -1.0
            if i < 0:
                d[0] += sign * x[int(event[m.NODE_A + end]) + c]
                continue
            _powers(memory, i, other)
            for j in range(count):
                d[j] += sign * other[j]
        for j in range(count):
            for k in range(count):
                P[4, j + k] += d[j] * d[k]
    P[4, 0] -= event[m.VALUE] ** 2
    return n, bernstein(P[4], n, P[3])


@kernel_inner
def _ask(control: Control, memory, room: Room, s, phase):  # type: ignore[no-untyped-def]
    """Ask for the state at the fraction s of the step; a jump at either end belongs to the neighbouring step."""
    real, k = memory.real, memory.count[m.BREAK]
    ask_at(control, memory, real[m.T] if s == 1.0 else real[m.T_OLD] + s * real[m.H_OLD], room)
    num, breaks = room.num, control.breaks
    num[m.ASK_T] = min(max(num[m.ASK_T], breaks[1, k]), breaks[2, k])
    room.at[m.PHASE] = phase
    return wanted(control, room.at[m.WATCH])


@kernel_inner
def _look(control, memory, room: Room):  # type: ignore[no-untyped-def]
    """Ask for the next sample of a piece of the step."""
    at, piece = room.at, room.spans[room.at[m.TOP] - 1]
    s = piece[0] + piece[1] * NODES[at[m.LOOK]] if at[m.LOOK] < DEGREE else piece[0] + piece[1]
    return _ask(control, memory, room, s, m.GOT_LOOK)


@kernel_inner
def got_look(control, memory, room: Room):  # type: ignore[no-untyped-def]
    """A sample; behind the last one of a piece its roots, or its halves."""
    at, num, pieces, P = room.at, room.num, room.spans, room.polynomials
    gap, scale = _measure(control, room, at[m.WATCH])
    P[0, at[m.LOOK]], num[m.RIGHT] = gap, max(num[m.RIGHT], scale)
    at[m.LOOK] += 1
    if at[m.LOOK] <= DEGREE:
        return _look(control, memory, room)
    at[m.LOOK] = 0
    last, low, width = 0.0, pieces[at[m.TOP] - 1, 0], pieces[at[m.TOP] - 1, 1]
    for r in range(2):
        total = 0.0
        for k in range(DEGREE + 1):
            total += LAST[r, k] * P[0, k]
        last = larger(last, abs(total))
    if not last <= CONVERGED * num[m.RIGHT] and width > NARROWEST:
        half = 0.5 * width
        pieces[at[m.TOP] - 1, 0], pieces[at[m.TOP] - 1, 1] = low + half, half
        pieces[at[m.TOP], 0], pieces[at[m.TOP], 1] = low, half
        at[m.TOP] += 1
        return _look(control, memory, room)
    for i in range(DEGREE + 1):
        P[3, i] = 0.0
        for k in range(DEGREE + 1):
            P[3, i] += TO_BERNSTEIN[i, k] * P[0, k]
    band = _band(control, at[m.WATCH]) * num[m.RIGHT]
    _isolate(memory, room, at[m.WATCH], DEGREE, band, START * band, low, width)
    at[m.TOP] -= 1
    if at[m.TOP] > 0:
        return _look(control, memory, room)
    at[m.PHASE] = m.CROSSINGS
    return 0


@kernel_inner
def next_root(control, memory, room: Room):  # type: ignore[no-untyped-def]
    """Enter the next root of a quantity; a steep one is first drawn to where the projected state has the value."""
    at, num = room.at, room.num
    if at[m.TURN] >= at[m.FOUND]:
        return _next_event(control, memory, room)
    row = room.roots[at[m.TURN]]
    num[m.BEST], num[m.LEFT], num[m.LEFT_F], at[m.LOOK] = row[0], row[0], math.inf, 0
    if row[2] == 0.0:
        return _keep(control, memory, room)
    return _ask(control, memory, room, row[0], m.GOT_ROOT)


@kernel_inner
def got_root(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """What the projected state still lacks at LEFT; Newton's method with the slope of the polynomial, as long as it gains."""
    at, num = room.at, room.num
    row = room.roots[at[m.TURN]]
    gap, scale = _measure(control, room, at[m.WATCH])
    if not abs(gap) < 0.5 * num[m.LEFT_F]:
        return _keep(control, memory, room)
    num[m.BEST], num[m.LEFT_F] = num[m.LEFT], abs(gap)
    slope, event = row[2], control.events[at[m.WATCH]]
    if event[m.KIND] == m.LENGTH and event[m.SAMPLED] == 0.0:
        slope /= 2.0 * abs(event[m.VALUE])
    new = num[m.LEFT] - gap / slope
    at[m.LOOK] += 1
    if abs(gap) <= 1e-16 * scale or at[m.LOOK] > TURNS or not abs(new - row[0]) <= 1e-3 or not 0.0 <= new <= 1.0:
        return _keep(control, memory, room)
    num[m.LEFT] = new
    return _ask(control, memory, room, new, m.GOT_ROOT)


@kernel_inner
def _keep(control: Control, memory, room: Room):  # type: ignore[no-untyped-def]
    """Enter an event in its place by time, if it comes from the wanted side."""
    at, kept, real = room.at, memory.events, memory.real
    e, s, k = at[m.WATCH], room.num[m.BEST], memory.count[m.EVENTS]
    event, way = control.events[e], room.roots[at[m.TURN], 1]
    at[m.TURN] += 1
    at[m.PHASE] = m.CROSSINGS
    if event[m.DIRECTION] * way < 0.0:
        return 0
    t = real[m.T] if s == 1.0 else real[m.T_OLD] + s * real[m.H_OLD]
    if event[m.STOPS] != 0.0 and t < real[m.STOP]:
        real[m.STOP] = t
    if k < kept.shape[0]:
        while k > 0 and kept[k - 1, 1] > t:
            for c in range(4):
                kept[k, c] = kept[k - 1, c]
            k -= 1
        kept[k, 0], kept[k, 1], kept[k, 2], kept[k, 3] = e, t, way, event[m.VALUE]
    memory.count[m.EVENTS] += 1
    return 0


@kernel_inner
def _cut(memory, before):  # type: ignore[no-untyped-def]
    """What would come behind a stop does not happen."""
    count, kept = memory.count, memory.events
    while before < count[m.EVENTS] <= kept.shape[0] and kept[count[m.EVENTS] - 1, 1] > memory.real[m.STOP]:
        count[m.EVENTS] -= 1
