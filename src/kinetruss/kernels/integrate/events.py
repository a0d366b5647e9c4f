"""Events: a length, a coordinate, a sum of terms or a force arrives at a value. All of them in a step, as roots of its own
polynomial.

Coordinates, and squares of lengths, are polynomials in a step. Forces, sums, and what prescribed motions move, are not: they
are sampled at Chebyshev's places, in halves of halves until the polynomial through the samples has converged. Either polynomial
gives all its roots (integrate.roots); a root is then refined on the projected state.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import EVALUATE, PROJECT, Run, find
from kinetruss.kernels.integrate.roots import DEGREE, NODES, TO_BERNSTEIN, bernstein, roots
from kinetruss.kernels.integrate.samples import put_at, restore_failed
from kinetruss.kernels.integrate.state import Control, Memory, Work
from kinetruss.kernels.structure.terms import term_value

__all__ = ["begin_watch", "scan", "watching"]

watching = Apart("run.control.watching[{}]")
"""Kernels of simulations with events."""

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
    """Quantity e less its value, in the state that was found, and the size of what it is compared with."""
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


@watching
def begin_watch(run: Run) -> None:
    """The side on which every quantity is at the start: 0 where it stands at its value."""
    control, memory, work, forces = run.control, run.memory, run.work, False
    for e in range(memory.watched.size):
        forces = forces or control.event_kind[e] == m.FORCE
    put_at(run, memory.t)
    find(run, PROJECT | EVALUATE if forces else PROJECT, 0)
    # sign of g - g_0 at the start, 0 within round-off
    for e in range(memory.watched.size):
        gap, scale = _measure(control, work, e)
        off = START * _band(control, e) * scale
        memory.watched[e] = 1.0 if gap > off else (-1.0 if gap < -off else 0.0)


@watching
def scan(run: Run) -> None:
    """Enter the events in the last step."""
    memory, work, before = run.memory, run.work, run.memory.events_met
    for e in range(memory.watched.size):
        work.roots_found = 0
        if run.control.event_sampled[e]:
            _sampled(run, e)
        else:
            _whole(run, e)
        for k in range(work.roots_found):
            if _drawn(run, e, work.roots[k]):
                _keep(run, e, work.roots[k, 1])
    _cut(memory, before)


@kernel_bare
def _whole(run: Run, e: int) -> None:
    """All roots of a quantity that is a polynomial over the step."""
    control, memory, work = run.control, run.memory, run.work
    n, size = _polynomial(control, memory, work, e)
    value = abs(control.event_value[e])
    scale = value + control.size
    if control.event_kind[e] == m.LENGTH:
        # a square is off by twice the length times its error
        scale *= max(2.0 * value, BAND * scale)
    _isolate(memory, work, e, n, max(BAND * scale, ROUND_OFF * size), START * BAND * scale, 0.0, 1.0)


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
def _measure_at(run: Run, e: int, s: float) -> tuple[float, float]:
    """`_measure` at the fraction s of the step; a jump at either end belongs to the neighbouring step."""
    control, memory, work = run.control, run.memory, run.work
    breaks, k = control.breaks, memory.interval
    put_at(run, memory.t if s == 1.0 else memory.t_old + s * memory.h_old)
    work.ask_t = min(max(work.ask_t, breaks[1, k]), breaks[2, k])
    find(run, PROJECT | EVALUATE if control.event_kind[e] == m.FORCE else PROJECT, 0)
    return _measure(control, work, e)


@kernel_bare
def _sampled(run: Run, e: int) -> None:
    """All roots of a quantity that is sampled, piece by piece of the step, in halves until its polynomial has converged."""
    control, memory, work = run.control, run.memory, run.work
    pieces, P, count = work.spans, work.polynomials, 1
    pieces[0, 0], pieces[0, 1] = 0.0, 1.0
    work.right = 0.0
    while count > 0:
        low, width, last = pieces[count - 1, 0], pieces[count - 1, 1], 0.0
        for i in range(DEGREE + 1):
            gap, scale = _measure_at(run, e, low + width * NODES[i] if i < DEGREE else low + width)
            P[0, i], work.right = gap, max(work.right, scale)
        # the last two Chebyshev coefficients tell whether the interpolant has converged
        for r in range(2):
            total = 0.0
            for k in range(DEGREE + 1):
                total += LAST[r, k] * P[0, k]
            last = larger(last, abs(total))
        if not last <= CONVERGED * work.right and width > NARROWEST:
            half = 0.5 * width
            pieces[count - 1, 0], pieces[count - 1, 1] = low + half, half
            pieces[count, 0], pieces[count, 1] = low, half
            count += 1
            continue
        # from samples at Chebyshev's places to Bernstein coefficients
        for i in range(DEGREE + 1):
            P[3, i] = 0.0
            for k in range(DEGREE + 1):
                P[3, i] += TO_BERNSTEIN[i, k] * P[0, k]
        band = _band(control, e) * work.right
        _isolate(memory, work, e, DEGREE, band, START * band, low, width)
        count -= 1


@kernel_bare
def _drawn(run: Run, e: int, root: F1) -> bool:
    """The place of a root into BEST, a steep one drawn to where the projected state has the value; False where that is another.

    Newton's method with the slope of the polynomial, as long as it gains.
    """
    control, work, slope = run.control, run.work, root[2]
    work.best, work.left, work.left_f = root[0], root[0], math.inf
    if slope == 0.0 and control.event_kind[e] != m.SUM:
        return True
    if control.event_kind[e] == m.LENGTH and not control.event_sampled[e]:
        slope /= 2.0 * abs(control.event_value[e])
    for _ in range(TURNS + 1):
        gap, scale = _measure_at(run, e, work.left)
        if _opposite(control, work, e):
            return False
        if not abs(gap) < 0.5 * work.left_f:
            break
        work.best, work.left_f = work.left, abs(gap)
        new = work.left - gap / slope if slope != 0.0 else work.left
        if abs(gap) <= 1e-16 * scale or not abs(new - root[0]) <= 1e-3 or not 0.0 <= new <= 1.0:
            break
        work.left = new
    return True


@kernel_bare
def _keep(run: Run, e: int, way: float) -> None:
    """Enter an event in its place by time, if it comes from the wanted side."""
    control, memory = run.control, run.memory
    kept, s, k = memory.events, run.work.best, memory.events_met
    if control.event_direction[e] * way < 0.0:
        return
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


@kernel_bare
def _cut(memory: Memory, before: int) -> None:
    """What would come behind a stop does not happen."""
    kept = memory.events
    # events beyond the one that ends the run
    while before < memory.events_met <= kept.shape[0] and kept[memory.events_met - 1, 1] > memory.stop:
        memory.events_met -= 1
