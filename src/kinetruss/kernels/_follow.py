"""Positions, velocities and accelerations along a motion: one forward sweep over the blocks a sample.

Positions by Newton's method, started from the Taylor series of the sample before and first tried with its factors
(chord steps); velocities and accelerations with the factors at the solution. Where a step fails, the way between the
two samples is walked in smaller steps (step-limited continuation), so no other branch is reached in silence.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels._blocks import aim, jacobian, newton_block, newton_step, residuals, targets
from kinetruss.kernels._jit import kernel, kernel_inline
from kinetruss.kernels._lu import lu_factor, lu_solve, lu_solve_transposed
from kinetruss.kernels._plan import ANGLE

__all__ = ["DONE", "FLIPPED", "STUCK", "WEAK", "follow", "march"]

DONE, STUCK, FLIPPED, WEAK = 0, 1, 2, 3


@kernel
def _faces(plan, x, i, target):  # type: ignore[no-untyped-def]
    """Every angle row points where its angle says, not the opposite way (n . d = 0 holds for both)."""
    for e in range(plan.driven.size):
        k = plan.driven[e]
        if plan.kind[k] == ANGLE:
            dx, dy = x[i, plan.B[k]] - x[i, plan.A[k]], x[i, plan.B[k] + 1] - x[i, plan.A[k] + 1]
            if math.cos(target[k]) * dx + math.sin(target[k]) * dy <= 0.0:
                return False
    return True


@kernel
def _first_step(plan, ends):  # type: ignore[no-untyped-def]
    """Share of the way that turns no angle by more than half a radian."""
    turn = 0.5
    for e in range(plan.driven.size):
        k = plan.driven[e]
        if plan.kind[k] == ANGLE:
            turn = max(turn, abs(ends[1, plan.drive[k]] - ends[0, plan.drive[k]]))
    return 0.5 / turn


@kernel
def march(plan, x, i, ends, from_moving, to_moving, scale):  # type: ignore[no-untyped-def]
    """Walk row i of x from drive values ends[0] to ends[1] in steps that adapt.

    Returns the fraction of the way reached: 1 when done; x[i] is then the solution, else the last good state.
    """
    n_rows = plan.row.size
    lu = np.empty(plan.lu_ptr[-1])
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((n_rows, 3))
    work = np.empty(n_rows + 1)
    target, inverse = targets(plan)
    trial = np.empty((1, x.shape[1]))
    trial[0] = x[i]
    now = np.empty((1, ends.shape[1]))
    largest = _first_step(plan, ends)
    done, step = 0.0, largest
    while done < 1.0:
        reach = min(1.0, done + step)
        for d in range(ends.shape[1]):
            now[0, d] = ends[0, d] + reach * (ends[1, d] - ends[0, d]) if reach < 1.0 else ends[1, d]
        aim(plan, now, 0, target, inverse)
        for k in range(plan.moving.size):
            trial[0, plan.moving[k]] = from_moving[k] + reach * (to_moving[k] - from_moving[k])
        good = True
        for b in range(plan.ptr.size - 1):
            if not newton_block(plan, b, trial, 0, target, inverse, lu, pivot, gradient, work, 0.2 * scale):
                good = False
                break
        if good:
            good = _faces(plan, trial, 0, target)
            for c in range(x.shape[1]):
                good = good and abs(trial[0, c] - x[i, c]) < 0.5 * scale
        if good:
            done = reach
            x[i] = trial[0]
            step = min(2.0 * step, largest)
        else:
            trial[0] = x[i]
            step *= 0.5
            if step < 1e-6:
                return done
    return 1.0


@kernel_inline
def _chord(plan, b, x, i, target, inverse, lu, pivot, gradient, work, scale):  # type: ignore[no-untyped-def]
    """Newton steps on block b with the factors at hand; True when they settle to round-off."""
    first = plan.ptr[b]
    before = 0.05 * scale
    for _ in range(5):
        residuals(plan, b, x, i, target, inverse, gradient, work)
        lu_solve(lu, pivot, plan.lu_ptr[b], first, plan.ptr[b + 1] - first, work)
        step = newton_step(plan, b, x, i, work)
        # the factors are one sample old: what is left is this step times their relative change
        if step < 1e-11 * scale:
            return True
        if not step < 0.3 * before:
            return False
        before = step
    return False


@kernel_inline
def _known(plan, k, y, i, gradient):  # type: ignore[no-untyped-def]
    """What earlier blocks and supports contribute to row k of y (coordinates of its own block are zero)."""
    A, B = plan.A[k], plan.B[k]
    along = gradient[k, 0] * (y[i, B] - y[i, A]) + gradient[k, 1] * (y[i, B + 1] - y[i, A + 1])
    return along + gradient[k, 2] * (y[i, B + 2] - y[i, A + 2])


@kernel
def _angle_terms(plan, k, x, v, i, target, rate, second):  # type: ignore[no-untyped-def]
    """Right-hand sides of an angle row n . d = 0: of n . d' (rate l) and of n . d''."""
    A, B = plan.A[k], plan.B[k]
    c, s = math.cos(target[k]), math.sin(target[k])
    dx, dy = x[i, B] - x[i, A], x[i, B + 1] - x[i, A + 1]
    dvx, dvy = v[i, B] - v[i, A], v[i, B + 1] - v[i, A + 1]
    along = c * dx + s * dy
    return rate * along, second * along + 2.0 * rate * (c * dvx + s * dvy) + rate * rate * (c * dy - s * dx)


@kernel_inline
def _velocity(plan, b, x, v, i, target, rates, lu, pivot, gradient, work):  # type: ignore[no-untyped-def]
    """J v = L' (an angle: angular rate times length) for block b."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for k in range(first, last):
        v[i, plan.col[k]] = 0.0
    for k in range(first, last):
        drive = plan.drive[k]
        wanted = rates[i, drive] if drive >= 0 else 0.0
        if plan.kind[k] == ANGLE:
            wanted, _ = _angle_terms(plan, k, x, v, i, target, wanted, 0.0)
        work[k - first] = wanted - _known(plan, k, v, i, gradient)
    lu_solve(lu, pivot, plan.lu_ptr[b], first, last - first, work)
    for k in range(first, last):
        v[i, plan.col[k]] = work[k - first]


@kernel_inline
def _acceleration(plan, b, x, v, a, i, target, inverse, rates, seconds, lu, pivot, gradient, work):  # type: ignore[no-untyped-def]
    """J a = L'' + (L'^2 - |v_B - v_A|^2)/L (an angle: its own terms) for block b."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for k in range(first, last):
        a[i, plan.col[k]] = 0.0
    for k in range(first, last):
        drive = plan.drive[k]
        rate, wanted = 0.0, 0.0
        if drive >= 0:
            rate, wanted = rates[i, drive], seconds[i, drive]
        if plan.kind[k] == ANGLE:
            _, wanted = _angle_terms(plan, k, x, v, i, target, rate, wanted)
        else:
            A, B = plan.A[k], plan.B[k]
            dx, dy, dz = v[i, B] - v[i, A], v[i, B + 1] - v[i, A + 1], v[i, B + 2] - v[i, A + 2]
            wanted += (rate * rate - dx * dx - dy * dy - dz * dz) * inverse[k]
        work[k - first] = wanted - _known(plan, k, a, i, gradient)
    lu_solve(lu, pivot, plan.lu_ptr[b], first, last - first, work)
    for k in range(first, last):
        a[i, plan.col[k]] = work[k - first]


@kernel_inline
def _gauge(plan, b, lu, pivot, weak, work, turn):  # type: ignore[no-untyped-def]
    """Smallest singular value of block b, one step of inverse iteration: A^-T and A^-1 in turn; `weak` keeps the vector."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    for k in range(n):
        work[k] = weak[first + k]
    if turn % 2 == 0:
        lu_solve_transposed(lu, pivot, plan.lu_ptr[b], first, n, work)
    else:
        lu_solve(lu, pivot, plan.lu_ptr[b], first, n, work)
    total = 0.0
    for k in range(n):
        total += work[k] * work[k]
    size = 1.0 / math.sqrt(total)
    for k in range(n):
        weak[first + k] = size * work[k]
    return size


@kernel_inline
def _predict(x, v, a, i, t):  # type: ignore[no-untyped-def]
    """Taylor series from sample i - 1, with the change of acceleration before it as third derivative."""
    h = t[i] - t[i - 1]
    if i == 1:
        for c in range(x.shape[1]):
            x[i, c] = x[i - 1, c] + h * (v[i - 1, c] + 0.5 * h * a[i - 1, c])
        return
    third = h / (3.0 * (t[i - 1] - t[i - 2]))
    for c in range(x.shape[1]):
        bend = a[i - 1, c] + third * (a[i - 1, c] - a[i - 2, c])
        x[i, c] = x[i - 1, c] + h * (v[i - 1, c] + 0.5 * h * bend)


@kernel_inline
def _settle(plan, x, i, moving, target, inverse, lu, pivot, gradient, work, scale):  # type: ignore[no-untyped-def]
    """All blocks of sample i by chord steps from the predicted positions; False if one does not settle."""
    for k in range(plan.moving.size):
        x[i, plan.moving[k]] = moving[i, k]
    for b in range(plan.ptr.size - 1):
        if not _chord(plan, b, x, i, target, inverse, lu, pivot, gradient, work, scale):
            return False
    return _faces(plan, x, i, target)


@kernel
def _walk(plan, x, i, start, start_values, start_moving, values, moving, scale):  # type: ignore[no-untyped-def]
    """Sample i by continuation from sample i - 1, or from the start configuration; the fraction reached."""
    ends = np.empty((2, values.shape[1]))
    ends[1] = values[i]
    if i == 0:
        x[0] = start
        ends[0] = start_values
        return march(plan, x, 0, ends, start_moving, moving[0], scale)
    x[i] = x[i - 1]
    ends[0] = values[i - 1]
    return march(plan, x, i, ends, moving[i - 1], moving[i], scale)


@kernel
def follow(plan, start, start_values, start_moving, t, values, rates, seconds, moving, moving_rate,
           moving_acceleration, scale, least, x, v, a, gauge):  # type: ignore[no-untyped-def]  # fmt: skip
    """Fill x, v, a (times, 3 n) and gauge (times,) for the drive histories (times, drives) and moving coordinates.

    start : (3 n,) a configuration that satisfies start_values, start_moving. scale : shortest bar, m.
    least : stop where the smallest singular value of a block falls below it.
    Returns (reason, number of good samples, fraction of the way to the next sample reached).
    """
    n_rows = plan.row.size
    lu = np.empty(plan.lu_ptr[-1])
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((n_rows, 3))
    work = np.empty(n_rows + 1)
    target, inverse = targets(plan)
    weak = np.ones(n_rows + 1)
    sign = np.zeros(plan.ptr.size)
    for i in range(t.size):
        quick = False
        aim(plan, values, i, target, inverse)
        if i > 0:
            _predict(x, v, a, i, t)
            quick = _settle(plan, x, i, moving, target, inverse, lu, pivot, gradient, work, scale)
        if not quick:
            reached = _walk(plan, x, i, start, start_values, start_moving, values, moving, scale)
            if reached < 1.0:
                return STUCK, i, reached
        for c in range(x.shape[1]):
            v[i, c] = 0.0
            a[i, c] = 0.0
        for k in range(plan.moving.size):
            v[i, plan.moving[k]] = moving_rate[i, k]
            a[i, plan.moving[k]] = moving_acceleration[i, k]
        smallest = 1.0
        for b in range(plan.ptr.size - 1):
            first = plan.ptr[b]
            jacobian(plan, b, x, i, target, inverse, lu, gradient, work)
            now = lu_factor(lu, pivot, plan.lu_ptr[b], first, plan.ptr[b + 1] - first)
            if i > 0 and now != sign[b]:
                return FLIPPED, i, 0.0
            sign[b] = now
            for turn in range(i, i + (1 if i > 0 else 16)):
                weakest = _gauge(plan, b, lu, pivot, weak, work, turn)
            smallest = min(smallest, weakest)
            _velocity(plan, b, x, v, i, target, rates, lu, pivot, gradient, work)
            _acceleration(plan, b, x, v, a, i, target, inverse, rates, seconds, lu, pivot, gradient, work)
        gauge[i] = smallest
        if not smallest >= least:
            return WEAK, i, 0.0
    return DONE, t.size, 1.0
