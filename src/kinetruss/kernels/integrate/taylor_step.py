"""One step by the power series of the motion (see series.recurrence), ended where its last orders fall below the tolerance.

A series goes through singular positions as the motion itself does; only its ends are kept away from them. A step that turns
out too long ends earlier on the same series, which costs nothing anew.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1
from kinetruss.kernels.coordinates.tape import Tape
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.answers import PIVOT, Run, find, largest_pivot, put_state
from kinetruss.kernels.integrate.dop853_step import dop853_step
from kinetruss.kernels.integrate.loop import LEAST, accept, goes_on, target
from kinetruss.kernels.integrate.samples import state_within
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.series.orders import SeriesWork, series_work
from kinetruss.kernels.series.recurrence import series
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project_near
from kinetruss.kernels.structure.lengths import line_turning

END_SHARE = 0.3
"""Least ratio of the scaled pivot at the end of a step to that at its start; below it the step ends somewhere else."""
GROW = 10.0
"""Largest ratio of a step to the last one."""
SHORTER = 0.84
"""Ratio of the next try of a step to the last one where its end is near a singular position."""
OFF = 1e3
"""Distance of an end from the constraints, as a multiple of the allowed error, above which the series has not converged."""
HARMLESS = 1e-6
"""The same as a multiple of pivot times length: the projection removes it and leaves an error of second order."""
ROUND_OFF = 100.0
"""Allowed error next to a singular position, as a multiple of the change of shape by which round-off violates constraints."""
STEEPEST, MOST_STEEP = 2.0, 10.0
"""How fast a pivot falls, in parts of the largest one and of the fastest turning of a row: at first sight, and at most (where
light and heavy bodies meet)."""
NEAREST, MOST_LOOKS, PROBES, CLOSER = 2e-4, 1000, 6, 40
"""Pivot, in parts of the largest one, below which passages are looked for in equal parts; places looked at in a step, at most
and at first; steps towards one passage."""
TOO_NEAR = 0.05
"""Ratio of a pivot to the one before, below which it is too near to a passage to tell on which side it lies."""
FEWEST = 6
"""Lowest order of a series next to a singular position."""
SINGULAR, CLEAR = 1e-3, 0.9
"""Scaled pivots, in parts of the largest one met: of a passage; at both ends of a step in which none is looked for."""
AT_SINGULAR = 1e-6
"""The same, below which no series begins."""


@kernel_bare
def _round_off(control: Control, memory: Memory) -> float:
    """Part of the places (m) that no series is better than, next to a singular position at the pivot p; 0 far from any.

    What round-off leaves of the constraints turns the shape by 1/p of it: a pole at the singular position, whose orders j grow
    with the -jth power of the distance. The projection takes it off again.
    """
    p = memory.pivot
    if p >= control.pivot_limit * memory.pivot_most:
        return 0.0
    return ROUND_OFF * control.tolerance * control.size / max(p, 1e-6)


@kernel_bare
def _norms(control: Control, X: F2, round_off: float, norms: F2) -> None:
    """How large every order of the places is: in parts of the errors allowed, into norms[0]; in m, into norms[1].

    The tolerance of a place is a part of the lengths of members.
    """
    free, length = control.free, control.length
    # |X_j| of each order: in units of the allowed error, and in m
    for j in range(X.shape[0]):
        off, most, total = 0.0, 0.0, 0.0
        for i in range(free.size):
            size = abs(X[j, free[i]])
            off, most = max(off, size / (control.atol + round_off + control.rtol * length[i])), max(most, size)
            total += size
        norms[0, j], norms[1, j] = off, most if total < math.inf else math.nan


@kernel_bare
def _reach(control: Control, norms: F2, last: int, j: int, s: float, round_off: float) -> float:
    """Time (s) at which the order j of places and velocities is as large as errors may be.

    The tolerance of velocities is a part of the largest one up to then.
    """
    most = norms[1, j]
    if not most > 0.0:
        return math.inf if most == 0.0 else 0.0
    h = s * norms[0, j] ** (-1.0 / j)
    z, power, fastest = min(h / s, GROW), 1.0, 0.0
    # largest speed up to the end of such a step
    for k in range(1, last + 1):
        fastest = max(fastest, k * norms[1, k] * power)
        power *= z
    swift = s * (j * most / (control.rtol * fastest)) ** (-1.0 / (j - 1))
    if round_off > 0.0:
        swift = max(swift, s * (most / round_off) ** (-1.0 / j))
    return min(h, swift)


@kernel_bare
def _size(control: Control, memory: Memory, own: SeriesWork) -> tuple[float, int]:
    """Longest step (s) with two last orders that are small enough, and the last; next to a singular position of all orders."""
    X, norms, s = own.x, own.norms, memory.h
    last, round_off = X.shape[0] - 1, _round_off(control, memory)
    _norms(control, X, round_off, norms)
    first = min(FEWEST, last) if round_off > 0.0 else last
    best, order, before = 0.0, last, _reach(control, norms, last, first - 1, s, round_off)
    # order whose term, with that before it, stays below the tolerance for longest
    for j in range(first, last + 1):
        now = _reach(control, norms, last, j, s, round_off)
        if min(before, now) >= best:
            best, order = min(before, now), j
        before = now
    if memory.steps > 0:
        best = min(best, GROW * memory.h_old)
    return min(best, control.t_end - memory.t_start), order


@kernel_bare
def _place(X: F2, last: int, free: I1, z: float, s: float, x: F1, v: F1) -> bool:
    """Places and velocities at tau = z, by the orders up to `last`; True where all are finite."""
    total = 0.0
    # Horner's scheme for x(z) and its derivative
    for i in range(free.size):
        c = free[i]
        place, rate = X[last, c], last * X[last, c]
        for j in range(last - 1, 0, -1):
            place = place * z + X[j, c]
            rate = rate * z + j * X[j, c]
        x[c], v[c] = place * z + X[0, c], rate / s
        total += abs(x[c]) + abs(v[c])
    return total < math.inf


@kernel_bare
def _end(run: Run, own: SeriesWork, last: int, h: float) -> bool:
    """Find the end of a step of at most about h (s). False where there is none.

    Size and end (s), smallest pivot and change (m) are left in try_h, try_t, end_pivot and moved of `work`, the state in x and
    v; `near` counts ends near singular positions.
    """
    control, memory, work = run.control, run.memory, run.work
    x, v, X = work.x, work.v, own.x
    free, fixed = control.free, control.fixed_step > 0.0
    s, tol, start = memory.h, control.tolerance, memory.pivot
    allowed, best, best_h = OFF * (control.atol + control.rtol * control.size), -1.0, 0.0
    work.near, work.spoilt = 0, 0
    # shorter ends on the same series until one is good, clear of singular positions
    for _ in range(40):
        h, t = target(control, memory, h)
        if not h > LEAST * max(abs(memory.t), control.t_end - memory.t_start):
            break
        if not _place(X, last, free, h / s, s, x, v):
            work.spoilt = 1
            break
        ok, moved, _, pivot = project_near(run.eq, run.ws, t, x, v, tol, False)
        good = ok and moved <= max(allowed, HARMLESS * pivot * control.size)
        if fixed or (good and (pivot >= END_SHARE * min(start, 0.5 * memory.pivot_most) or work.near > m.TRIES)):
            work.try_h, work.try_t, work.end_pivot, work.moved = h, t, pivot, moved
            return ok
        memory.rejected += 1
        if good:
            work.near += 1
            if pivot > best:
                best, best_h = pivot, h
            h = SHORTER * h if work.near < m.TRIES else best_h
            work.near += work.near == m.TRIES
        else:
            h *= 0.6
    return False


@kernel_bare
def _keep(control: Control, memory: Memory, work: Work, own: SeriesWork, last: int) -> None:
    """Make the step that `_end` has left the last one."""
    y, F, X, s = memory.y, memory.dense, own.x, memory.h
    free, x, v, h = control.free, work.x, work.v, work.try_h
    z = h / s
    nf, power = free.size, 1.0
    # interpolant: X_j (h/s)^j of positions, its derivative of velocities
    for j in range(F.shape[0]):
        for i in range(nf):
            F[j, i] = X[j, free[i]] * power if j <= last else 0.0
            F[j, nf + i] = (j + 1) * X[j + 1, free[i]] * power / s if j < last else 0.0
        power *= z
    # state and rate at the end, a from the second derivative of the series
    for i in range(nf):
        c, gain = free[i], 0.0
        for j in range(last, 1, -1):
            gain = gain * z + j * (j - 1) * X[j, c]
        y[0, i], y[0, nf + i], y[1, i], y[1, nf + i] = x[c], v[c], v[c], gain / (s * s)
    memory.constraint = work.moved
    accept(memory, h, work.try_t, work.end_pivot, 1)


@kernel_bare
def _pivot_at(run: Run, c: float) -> float:
    """Smallest pivot at the fraction c of the last step."""
    memory, y = run.memory, run.work.states[0]
    state_within(memory, c, y)
    put_state(run.control, y, memory.t_old + c * memory.h_old, run.work)
    find(run, PIVOT, 0)
    return run.work.new_pivot


@kernel_bare
def _fastest(run: Run) -> float:
    """Fastest turning (rad/s) of a row between two nodes, at the start, in the middle and at the end of the last step."""
    memory, work, A, B, fastest = run.memory, run.work, run.eq.A, run.eq.B, 0.0
    for k in range(3):
        state_within(memory, 0.5 * k, work.states[0])
        put_state(run.control, work.states[0], memory.t, work)
        for j in range(A.size):
            fastest = max(fastest, line_turning(work.x, work.v, A[j], B[j]))
    return fastest


@kernel_bare
def _passage(run: Run, first: float) -> None:
    """Enter all places of the last step that went through a singular position: there a pivot, known but for its sign, is zero.

    The pivot is about the sine of an angle between rows: it falls about as fast as two of them turn towards each other. So from
    any place the next one to look at is where it could be zero at the earliest. first : the pivot at the start.
    """
    memory, work = run.memory, run.work
    most, end = memory.pivot_most, memory.pivot
    turned, highest, s, p, width = _fastest(run) * memory.h_old, most, 0.0, first, 1.0 / PROBES
    if most == 0.0 or first + end > MOST_STEEP * turned:
        return
    slope = 0.0
    # how high and how steep it is, first from a few places
    for k in range(1, PROBES + 1):
        q = end if k == PROBES else _pivot_at(run, k * width)
        highest, slope = max(highest, q), max(slope, 1.5 * abs(q - p) / width)
        p = q
    slope = max(slope, STEEPEST * turned * highest)
    p, seen = first, slope / STEEPEST
    # by the largest slope, the pivot cannot vanish before s + p/slope: that is the next place to look
    for _ in range(MOST_LOOKS):
        if s >= 1.0 or p + end > slope * (1.0 - s):
            return
        new = s + max(p, NEAREST * most) / slope
        if new >= 1.0:
            new = 1.0
        q = end if new == 1.0 else _pivot_at(run, new)
        if new < 1.0 and q < TOO_NEAR * p:  # whether the passage is before or behind cannot be seen from here
            new = s + 0.7 * (new - s)
            q = _pivot_at(run, new)
        width, both, change = new - s, p + q, abs(p - q)
        through = both <= 1.05 * slope * width and abs(both - seen * width) < abs(change - seen * width)
        if through or (new == 1.0 and q < SINGULAR * most):
            work.left, work.left_f, work.right, work.right_f = s, p, new, q
            _enter(run)
            change = both if through else change
        seen = change / width
        slope = max(slope, 1.2 * seen)
        s, p = new, q


@kernel_bare
def _enter(run: Run) -> None:
    """Where the pivot vanishes between the fractions left and right, by its slope to either side; an entry where it does.

    left_f, right_f : the pivots there.
    """
    memory, work = run.memory, run.work
    a, b, most, k = work.left, work.right, memory.pivot_most, memory.passages_met
    slope = (work.left_f + work.right_f) / (b - a)
    where = a + work.left_f / slope
    low = _pivot_at(run, where)
    # a step towards zero to either side; where both go too far, the pivot is steeper than it seemed
    steep = slope
    # secant steps on |p| to both sides of its zero
    for _ in range(CLOSER):
        if low < 0.01 * SINGULAR * most or where + low / steep == where:
            break
        right, left = min(where + low / steep, b), max(where - low / steep, a)
        p = _pivot_at(run, right)
        if p < low:
            low, where = p, right
            continue
        p = _pivot_at(run, left)
        if p < low:
            low, where = p, left
        else:
            steep *= 2.0
    when = memory.t_old + where * memory.h_old
    if low > SINGULAR * most:
        return
    # found from both sides
    same = 4.0 * SINGULAR * most / slope * memory.h_old
    if 0 < k <= memory.passages.shape[0] and abs(when - memory.passages[k - 1, 0]) < same:
        return
    if k < memory.passages.shape[0]:
        row = memory.passages[k]
        row[0], row[1] = when, low
        row[2] = 1.0 if work.near < m.TRIES else 0.0
    memory.passages_met = k + 1


@kernel_bare
def _step(run: Run, own: SeriesWork) -> None:
    """One step; where there is none, `code` says why."""
    eq, ws, control, memory, work = run.eq, run.ws, run.control, run.memory, run.work
    x, v = work.x, work.v
    largest_pivot(run)
    put_state(control, memory.y[0], memory.t, work)
    prepare_rows(eq, ws, memory.t, x, v)
    first = work.factored
    if first < 0.0:
        first = factor(eq, ws, x)
    memory.pivot = first
    tape = Tape(control.tape_ints, control.tape_reals)
    series(eq, ws, tape, control.tape_laws, own, memory.t, memory.h, x, v)
    memory.evaluations += 1
    fixed = control.fixed_step
    most, last = _size(control, memory, own)
    if fixed > 0.0:
        most, last = fixed, own.x.shape[0] - 1
    if not _end(run, own, last, most):
        finite = most > 0.0 and work.spoilt == 0
        work.code = m.STEP_TOO_SMALL if finite else m.NOT_FINITE
        if finite and first < CLEAR * memory.pivot_most and memory.alone == 0:
            work.code = m.UNDETERMINED
        return
    _keep(control, memory, work, own, last)
    work.factored = work.end_pivot
    _passage(run, first)
    memory.h = most


@kernel
def taylor_steps(run: Run, samples: Samples) -> None:
    """Steps while the run goes on."""
    control = run.control
    tape = Tape(control.tape_ints, control.tape_reals)
    _steps(run, samples, series_work(run.eq, control.stand, int(control.orders), tape))


@kernel_bare
def _steps(run: Run, samples: Samples, own: SeriesWork) -> None:
    memory = run.memory
    while goes_on(run, samples):
        # a singular start is left by steps whose stages lie beside it
        if memory.pivot < AT_SINGULAR * memory.pivot_most:
            if run.control.aside_at != 0:
                dop853_step(run)
            else:
                run.work.code = m.ASIDE
        else:
            _step(run, own)
