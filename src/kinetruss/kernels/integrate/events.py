"""Events: a length, a coordinate, a sum of terms or a force arrives at a value. All of them in a step, as roots of its own
polynomial.

Coordinates, and squares of lengths, are polynomials in a step. Forces, sums, and what prescribed motions move, are not: they
are sampled at Chebyshev's places, in halves of halves until the polynomial through the samples has converged. Either polynomial
gives all its roots (integrate.roots); a root is then refined on the projected state.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.roots import DEGREE, NODES, TO_BERNSTEIN, bernstein, roots
from kinetruss.kernels.integrate.samples import ask_at, restore_failed
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.structure.terms import term_value

__all__ = ["begin_watch", "got_look", "got_root", "next_root", "scan", "wanted"]

BAND, FORCE_BAND = 1e-12, 1e-10
"""Distance from its value at which a quantity counts as equal to it: relative to it and to a member, or the largest force."""
START = 100.0
"""The same at the start of a run, as a multiple of the other."""
ROUND_OFF = 16 * 2.2e-16
"""Of the polynomials, relative to the sum of their coefficients."""
CONVERGED = 1e-8
"""Largest last coefficients of a converged polynomial through samples, relative to its scale."""
NARROWEST = 1.0 / 64.0
"""Smallest fraction of a step that is sampled; it is not halved again, as next to a singular position."""
TURNS = 6
TURN = 2.0 * math.pi
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


@kernel_bare
def wanted(control: Control, e: int) -> int:
    """Request for a watched quantity: forces need the equations of motion."""
    return m.PROJECT | m.EVALUATE if control.event_kind[e] == m.FORCE else m.PROJECT


@kernel_bare
def _sum(control: Control, x: F1, e: int) -> float:
    """The sum of the terms of quantity e."""
    total = 0.0
    for t in range(control.event_ptr[e], control.event_ptr[e + 1]):
        total += term_value(control.event_form, control.event_term, control.event_data, t, x)
    return total


@kernel_bare
def _opposite(control: Control, work: Work, e: int) -> bool:
    """True half a turn from the value, where the sine of `_measure` is 0 too."""
    period = control.event_period[e]
    if control.event_kind[e] != m.SUM or period == 0.0:
        return False
    return math.cos(TURN * (_sum(control, work.x, e) - control.event_value[e]) / period) < 0.0


@kernel_bare
def _measure(control: Control, work: Work, e: int) -> tuple[float, float]:
    """Quantity e less its value, from the reply of the driver, and the size of what it is compared with."""
    restore_failed(control, work)
    kind, value, x = control.event_kind[e], control.event_value[e], work.x
    a, b, scale = control.event_A[e], control.event_B[e], abs(value)
    if kind == m.FORCE:
        N = work.N
        # forces compare with the largest force of the instant
        for k in range(N.size):
            scale = max(scale, abs(N[k]))
        return N[a] - value, scale
    if kind == m.SUM:
        gap, period = _sum(control, x, e) - value, control.event_period[e]
        if period > 0.0:
            # the same on every turn, without a jump half a turn off
            return period / TURN * math.sin(TURN * gap / period), scale + 1.0
        return gap, scale + control.size
    scale += control.size
    if kind == m.COORDINATE:
        return x[a] - value, scale
    dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
    return math.sqrt(dx * dx + dy * dy + dz * dz) - value, scale


@kernel_bare
def _band(control: Control, e: int) -> float:
    return FORCE_BAND if control.event_kind[e] == m.FORCE else BAND


@kernel_late
def begin_watch(control: Control, memory: Memory, work: Work) -> None:
    """The side on which every quantity is at the start: 0 where it stands at its value."""
    # sign of g - g_0 at the start, 0 within round-off
    for e in range(memory.watched.size):
        gap, scale = _measure(control, work, e)
        off = START * _band(control, e) * scale
        memory.watched[e] = 1.0 if gap > off else (-1.0 if gap < -off else 0.0)


@kernel_late
def scan(control: Control, memory: Memory, work: Work) -> int:
    """Begin to look for events in the last step."""
    work.before = memory.events_met
    work.watch = -1
    return _next_event(control, memory, work)


@kernel_bare
def _next_event(control: Control, memory: Memory, work: Work) -> int:
    """All roots of the next quantity; behind the last one, what comes behind events."""
    work.watch += 1
    work.roots_found, work.turn = 0, 0
    if work.watch == memory.watched.size:
        _cut(memory, work.before)
        work.phase = m.CHECKS
        return 0
    if control.event_sampled[work.watch]:
        pieces = work.spans
        pieces[0, 0], pieces[0, 1], work.look, work.spans_left = 0.0, 1.0, 0, 1
        work.right = 0.0
        return _look(control, memory, work)
    n, size = _polynomial(control, memory, work, work.watch)
    value = abs(control.event_value[work.watch])
    scale = value + control.size
    if control.event_kind[work.watch] == m.LENGTH:
        # a square is off by twice the length times its error
        scale *= max(2.0 * value, BAND * scale)
    _isolate(memory, work, work.watch, n, max(BAND * scale, ROUND_OFF * size), START * BAND * scale, 0.0, 1.0)
    work.phase = m.CROSSINGS
    return 0


@kernel_bare
def _isolate(memory: Memory, work: Work, e: int, n: int, band: float, level: float, low: float, width: float) -> None:
    """Append the roots of the polynomial in POLYNOMIALS[3], over the part of the step from `low` on."""
    found, piece = work.roots, work.piece_roots
    b, stack, scratch = work.polynomials[3], work.stack, work.polynomials[4]
    if memory.steps > 1 or low > 0.0:
        level = 0.0
    count, side = roots(b, n, int(memory.watched[e]), band, level, stack, piece, scratch)
    memory.watched[e] = side
    # roots of the piece, put back on the scale of the whole step
    for k in range(count):
        if work.roots_found < found.shape[0]:
            row = found[work.roots_found]
            row[0], row[1], row[2] = low + width * piece[k, 0], piece[k, 1], piece[k, 2] / width
            work.roots_found += 1


@kernel_bare
def _powers(memory: Memory, i: int, out: F1) -> int:
    """Coordinate i of the state in powers of the fraction of the step into out; ends exactly at the new state."""
    F, count = memory.dense, memory.dense.shape[0] if memory.series != 0 else 8
    # a power series has its coefficients already
    for j in range(count):
        out[j] = F[j, i]
    if memory.series == 0:
        # DOP853: from the nested form of the interpolant to powers of s
        for j in range(8):
            out[j] = 0.0
            for k in range(8):
                out[j] += POWERS[k, j] * F[k, i]
    total = 0.0
    # sum of the coefficients: value at s = 1; what it lacks of the new state goes into the linear one
    for j in range(count - 1, -1, -1):
        total += out[j]
    out[1] += memory.y[0, i] - total
    return count


@kernel_bare
def _polynomial(control: Control, memory: Memory, work: Work, e: int) -> tuple[int, float]:
    """A coordinate less its value, or the square of a length less that of its value, into POLYNOMIALS[3] (Bernstein).

    Returns the degree and the sum of the sizes of the coefficients.
    """
    at, value, P, x = control.event_at[e], control.event_value[e], work.polynomials, control.stand
    count = memory.dense.shape[0] if memory.series != 0 else 8
    if control.event_kind[e] == m.COORDINATE:
        if at[0] >= 0:
            _powers(memory, at[0], P[4])
        else:
            # a prescribed coordinate that stands still is a constant
            for j in range(count):
                P[4, j] = x[control.event_A[e]] if j == 0 else 0.0
        P[4, 0] -= value
        return count - 1, bernstein(P[4], count - 1, P[3])
    n = 2 * (count - 1)
    # |d(s)|^2 has twice the degree of d(s)
    for j in range(n + 1):
        P[4, j] = 0.0
    # d = x_B - x_A as polynomials, and the sum of d_c^2 over the axes
    for c in range(3):
        d, other = P[c], P[3]
        for j in range(count):
            d[j] = 0.0
        for end in range(2):
            i, sign = at[3 * end + c], 1.0 if end == 1 else -1.0
            if i < 0:
                first = control.event_B[e] if end == 1 else control.event_A[e]
                d[0] += sign * x[first + c]
                continue
            _powers(memory, i, other)
            for j in range(count):
                d[j] += sign * other[j]
        for j in range(count):
            for k in range(count):
                P[4, j + k] += d[j] * d[k]
    P[4, 0] -= value**2
    return n, bernstein(P[4], n, P[3])


@kernel_bare
def _ask(control: Control, memory: Memory, work: Work, s: float, phase: int) -> int:
    """Ask for the state at the fraction s of the step; a jump at either end belongs to the neighbouring step."""
    k = memory.interval
    ask_at(control, memory, memory.t if s == 1.0 else memory.t_old + s * memory.h_old, work)
    breaks = control.breaks
    work.ask_t = min(max(work.ask_t, breaks[1, k]), breaks[2, k])
    work.phase = phase
    return wanted(control, work.watch)


@kernel_bare
def _look(control: Control, memory: Memory, work: Work) -> int:
    """Ask for the next sample of a piece of the step."""
    piece = work.spans[work.spans_left - 1]
    s = piece[0] + piece[1] * NODES[work.look] if work.look < DEGREE else piece[0] + piece[1]
    return _ask(control, memory, work, s, m.GOT_LOOK)


@kernel_late
def got_look(control: Control, memory: Memory, work: Work) -> int:
    """A sample; behind the last one of a piece its roots, or its halves."""
    pieces, P = work.spans, work.polynomials
    gap, scale = _measure(control, work, work.watch)
    P[0, work.look], work.right = gap, max(work.right, scale)
    work.look += 1
    if work.look <= DEGREE:
        return _look(control, memory, work)
    work.look = 0
    last, low, width = 0.0, pieces[work.spans_left - 1, 0], pieces[work.spans_left - 1, 1]
    # the last two Chebyshev coefficients tell whether the interpolant has converged
    for r in range(2):
        total = 0.0
        for k in range(DEGREE + 1):
            total += LAST[r, k] * P[0, k]
        last = larger(last, abs(total))
    if not last <= CONVERGED * work.right and width > NARROWEST:
        half = 0.5 * width
        pieces[work.spans_left - 1, 0], pieces[work.spans_left - 1, 1] = low + half, half
        pieces[work.spans_left, 0], pieces[work.spans_left, 1] = low, half
        work.spans_left += 1
        return _look(control, memory, work)
    # from samples at Chebyshev's places to Bernstein coefficients
    for i in range(DEGREE + 1):
        P[3, i] = 0.0
        for k in range(DEGREE + 1):
            P[3, i] += TO_BERNSTEIN[i, k] * P[0, k]
    band = _band(control, work.watch) * work.right
    _isolate(memory, work, work.watch, DEGREE, band, START * band, low, width)
    work.spans_left -= 1
    if work.spans_left > 0:
        return _look(control, memory, work)
    work.phase = m.CROSSINGS
    return 0


@kernel_late
def next_root(control: Control, memory: Memory, work: Work) -> int:
    """Enter the next root of a quantity; a steep one is first drawn to where the projected state has the value."""
    if work.turn >= work.roots_found:
        return _next_event(control, memory, work)
    row = work.roots[work.turn]
    work.best, work.left, work.left_f, work.look = row[0], row[0], math.inf, 0
    if row[2] == 0.0 and control.event_kind[work.watch] != m.SUM:
        return _keep(control, memory, work)
    return _ask(control, memory, work, row[0], m.GOT_ROOT)


@kernel_late
def got_root(control: Control, memory: Memory, work: Work) -> int:
    """What the projected state still lacks at LEFT; Newton's method with the slope of the polynomial, as long as it gains."""
    row = work.roots[work.turn]
    gap, scale = _measure(control, work, work.watch)
    if _opposite(control, work, work.watch):
        work.turn += 1
        work.phase = m.CROSSINGS
        return 0
    if not abs(gap) < 0.5 * work.left_f:
        return _keep(control, memory, work)
    work.best, work.left_f = work.left, abs(gap)
    slope, e = row[2], work.watch
    if control.event_kind[e] == m.LENGTH and not control.event_sampled[e]:
        slope /= 2.0 * abs(control.event_value[e])
    new = work.left - gap / slope if slope != 0.0 else work.left
    work.look += 1
    if abs(gap) <= 1e-16 * scale or work.look > TURNS or not abs(new - row[0]) <= 1e-3 or not 0.0 <= new <= 1.0:
        return _keep(control, memory, work)
    work.left = new
    return _ask(control, memory, work, new, m.GOT_ROOT)


@kernel_bare
def _keep(control: Control, memory: Memory, work: Work) -> int:
    """Enter an event in its place by time, if it comes from the wanted side."""
    kept = memory.events
    e, s, k = work.watch, work.best, memory.events_met
    way = work.roots[work.turn, 1]
    work.turn += 1
    work.phase = m.CROSSINGS
    if control.event_direction[e] * way < 0.0:
        return 0
    t = memory.t if s == 1.0 else memory.t_old + s * memory.h_old
    if control.event_stops[e] and t < memory.stop:
        memory.stop = t
    if k < kept.shape[0]:
        # insertion by time: later events move up
        while k > 0 and kept[k - 1, 1] > t:
            for c in range(4):
                kept[k, c] = kept[k - 1, c]
            k -= 1
        kept[k, 0], kept[k, 1], kept[k, 2], kept[k, 3] = e, t, way, control.event_value[e]
    memory.events_met += 1
    return 0


@kernel_bare
def _cut(memory: Memory, before: int) -> None:
    """What would come behind a stop does not happen."""
    kept = memory.events
    # events beyond the one that ends the run
    while before < memory.events_met <= kept.shape[0] and kept[memory.events_met - 1, 1] > memory.stop:
        memory.events_met -= 1
