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
from kinetruss.kernels._plan import ANGLE, LENGTH
from kinetruss.kernels._sums import sum_jacobian, sum_known, sum_residuals, sum_second, sum_terms

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
        if plan.kind[k] != LENGTH:
            turn = max(turn, abs(ends[1, plan.drive[k]] - ends[0, plan.drive[k]]))
    return 0.5 / turn


@kernel
def march(plan, x, i, ends, from_moving, to_moving, scale):  # type: ignore[no-untyped-def]
    """Walk row i of x from drive values ends[0] to ends[1] in steps that adapt.

    Returns the fraction of the way reached: 1 when done; x[i] is then the solution, else the last good state.
    """
    n_rows = plan.row.size
    lu = np.empty((n_rows, plan.width))
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((n_rows, 3))
    work = np.empty(n_rows + 1)
    terms = np.empty((plan.term_kind.size, 10))
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
        aim(plan.driven, plan.drive, now, 0, target, inverse)
        for k in range(plan.moving.size):
            trial[0, plan.moving[k]] = from_moving[k] + reach * (to_moving[k] - from_moving[k])
        good = True
        for b in range(plan.ptr.size - 1):
            if not newton_block(plan, b, trial, 0, target, inverse, lu, pivot, gradient, terms, work, 0.2 * scale):
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
def _chord(kind, A, B, col, first, last, x, i, target, inverse, lu, pivot, gradient, work, scale):  # type: ignore[no-untyped-def]
    """Newton steps on a block with the factors at hand; True when they settle to round-off."""
    before = 0.05 * scale
    for _ in range(5):
        residuals(kind, A, B, first, last, x, i, target, inverse, gradient, work)
        lu_solve(lu, pivot, first, last - first, work)
        step = newton_step(col, first, last, x, i, work)
        # the factors are one sample old: what is left is this step times their relative change
        if step < 1e-11 * scale:
            return True
        if not step < 0.3 * before:
            return False
        before = step
    return False


@kernel
def _chord_sums(plan, b, x, i, target, inverse, lu, pivot, gradient, terms, work, scale):  # type: ignore[no-untyped-def]
    """`_chord` of a block of a plan that has sums."""
    first, last, before = plan.ptr[b], plan.ptr[b + 1], 0.05 * scale
    for _ in range(5):
        residuals(plan.kind, plan.A, plan.B, first, last, x, i, target, inverse, gradient, work)
        sum_residuals(plan, b, first, x[i], target, terms, work)
        lu_solve(lu, pivot, first, last - first, work)
        step = newton_step(plan.col, first, last, x, i, work)
        if step < 1e-11 * scale:
            return True
        if not step < 0.3 * before:
            return False
        before = step
    return False


@kernel
def _sums_velocity(plan, b, v, i, rates, lu, pivot, gradient, terms, work, x, target):  # type: ignore[no-untyped-def]
    """`_velocity` of a block that has sums."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for k in range(first, last):
        v[i, plan.col[k]] = 0.0
    for k in range(first, last):
        d = plan.drive[k]
        wanted = rates[i, d] if d >= 0 else 0.0
        if plan.kind[k] == ANGLE:
            wanted, _ = _angle_terms(plan.A[k], plan.B[k], x, v, i, target[k], wanted, 0.0)
        work[k - first] = wanted - _known(plan.A[k], plan.B[k], k, v, i, gradient)
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        work[plan.sum_row[j] - first] *= plan.sum_scale[j]
    sum_known(plan, b, first, v[i], terms, work)
    lu_solve(lu, pivot, first, last - first, work)
    for k in range(first, last):
        v[i, plan.col[k]] = work[k - first]


@kernel
def _sums_acceleration(plan, b, v, a, i, rates, seconds, inverse, lu, pivot, gradient, terms, work, x, target):  # type: ignore[no-untyped-def]
    """`_acceleration` of a block that has sums."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for k in range(first, last):
        a[i, plan.col[k]] = 0.0
    for k in range(first, last):
        d, p, q = plan.drive[k], plan.A[k], plan.B[k]
        rate, wanted = 0.0, 0.0
        if d >= 0:
            rate, wanted = rates[i, d], seconds[i, d]
        if plan.kind[k] == ANGLE:
            _, wanted = _angle_terms(p, q, x, v, i, target[k], rate, wanted)
        else:
            dx, dy, dz = v[i, q] - v[i, p], v[i, q + 1] - v[i, p + 1], v[i, q + 2] - v[i, p + 2]
            wanted += (rate * rate - dx * dx - dy * dy - dz * dz) * inverse[k]
        work[k - first] = wanted - _known(p, q, k, a, i, gradient)
    sum_second(plan, b, first, x[i], v[i], seconds[i], plan.drive, work)
    sum_known(plan, b, first, a[i], terms, work)
    lu_solve(lu, pivot, first, last - first, work)
    for k in range(first, last):
        a[i, plan.col[k]] = work[k - first]


@kernel_inline
def _known(a, b, k, y, i, gradient):  # type: ignore[no-untyped-def]
    """What earlier blocks and supports contribute to row k of y (coordinates of its own block are zero)."""
    along = gradient[k, 0] * (y[i, b] - y[i, a]) + gradient[k, 1] * (y[i, b + 1] - y[i, a + 1])
    return along + gradient[k, 2] * (y[i, b + 2] - y[i, a + 2])


@kernel
def _angle_terms(a, b, x, v, i, angle, rate, second):  # type: ignore[no-untyped-def]
    """Right-hand sides of an angle row n . d = 0: of n . d' (rate l) and of n . d''."""
    c, s = math.cos(angle), math.sin(angle)
    dx, dy = x[i, b] - x[i, a], x[i, b + 1] - x[i, a + 1]
    dvx, dvy = v[i, b] - v[i, a], v[i, b + 1] - v[i, a + 1]
    along = c * dx + s * dy
    return rate * along, second * along + 2.0 * rate * (c * dvx + s * dvy) + rate * rate * (c * dy - s * dx)


@kernel_inline
def _velocity(kind, A, B, drive, col, first, last, x, v, i, target, rates, lu, pivot, gradient, work):  # type: ignore[no-untyped-def]
    """J v = L' (an angle: angular rate times length) for one block."""
    for k in range(first, last):
        v[i, col[k]] = 0.0
    for k in range(first, last):
        d = drive[k]
        wanted = rates[i, d] if d >= 0 else 0.0
        if kind[k] == ANGLE:
            wanted, _ = _angle_terms(A[k], B[k], x, v, i, target[k], wanted, 0.0)
        work[k - first] = wanted - _known(A[k], B[k], k, v, i, gradient)
    lu_solve(lu, pivot, first, last - first, work)
    for k in range(first, last):
        v[i, col[k]] = work[k - first]


@kernel_inline
def _acceleration(kind, A, B, drive, col, first, last, x, v, a, i, target, inverse, rates, seconds, lu, pivot, gradient,  # type: ignore[no-untyped-def]
                  work):  # fmt: skip
    """J a = L'' + (L'^2 - |v_B - v_A|^2)/L (an angle: its own terms) for one block."""
    for k in range(first, last):
        a[i, col[k]] = 0.0
    for k in range(first, last):
        d = drive[k]
        rate, wanted = 0.0, 0.0
        if d >= 0:
            rate, wanted = rates[i, d], seconds[i, d]
        p, q = A[k], B[k]
        if kind[k] == ANGLE:
            _, wanted = _angle_terms(p, q, x, v, i, target[k], rate, wanted)
        else:
            dx, dy, dz = v[i, q] - v[i, p], v[i, q + 1] - v[i, p + 1], v[i, q + 2] - v[i, p + 2]
            wanted += (rate * rate - dx * dx - dy * dy - dz * dz) * inverse[k]
        work[k - first] = wanted - _known(p, q, k, a, i, gradient)
    lu_solve(lu, pivot, first, last - first, work)
    for k in range(first, last):
        a[i, col[k]] = work[k - first]


@kernel_inline
def _gauge(first, last, lu, pivot, weak, work, turn):  # type: ignore[no-untyped-def]
    """Smallest singular value of a block, one step of inverse iteration: A^-T and A^-1 in turn; `weak` keeps the vector."""
    n = last - first
    for k in range(n):
        work[k] = weak[first + k]
    if turn % 2 == 0:
        lu_solve_transposed(lu, pivot, first, n, work)
    else:
        lu_solve(lu, pivot, first, n, work)
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
def follow(plan, start, start_values, start_moving, t, values, rates, seconds, moving, moving_rate,  # type: ignore[no-untyped-def]
           moving_acceleration, scale, least, x, v, a, gauge):  # fmt: skip
    """Fill x, v, a (times, 3 n) and gauge (times,) for the drive histories (times, drives) and moving coordinates.

    start : (3 n,) a configuration that satisfies start_values, start_moving. scale : shortest bar, m.
    least : stop where the smallest singular value of a block falls below it.
    Returns (reason, number of good samples, fraction of the way to the next sample reached).
    """
    n_rows, sums = plan.row.size, plan.sum_row.size > 0
    lu = np.empty((n_rows, plan.width))
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((n_rows, 3))
    work = np.empty(n_rows + 1)
    terms = np.empty((plan.term_kind.size, 10))
    target, inverse = targets(plan)
    weak = np.ones(n_rows + 1)
    sign = np.zeros(plan.ptr.size)
    A, B, kind, drive, driven, ptr, col, held = (
        plan.A, plan.B, plan.kind, plan.drive, plan.driven, plan.ptr, plan.col, plan.moving,
    )  # fmt: skip
    entry_ptr, entry_row, entry_col, entry_axis, entry_sign = (
        plan.entry_ptr, plan.entry_row, plan.entry_col, plan.entry_axis, plan.entry_sign,
    )  # fmt: skip
    blocks = ptr.size - 1
    for i in range(t.size):
        quick = i > 0
        aim(driven, drive, values, i, target, inverse)
        if quick:
            _predict(x, v, a, i, t)
            for k in range(held.size):
                x[i, held[k]] = moving[i, k]
            for b in range(blocks):
                if sums:
                    quick = quick and _chord_sums(plan, b, x, i, target, inverse, lu, pivot, gradient, terms, work, scale)
                    continue
                quick = quick and _chord(
                    kind, A, B, col, ptr[b], ptr[b + 1], x, i, target, inverse, lu, pivot, gradient, work, scale
                )
            quick = quick and _faces(plan, x, i, target)
        if not quick:
            reached = _walk(plan, x, i, start, start_values, start_moving, values, moving, scale)
            if reached < 1.0:
                return STUCK, i, reached
        for c in range(x.shape[1]):
            v[i, c] = 0.0
            a[i, c] = 0.0
        for k in range(held.size):
            v[i, held[k]] = moving_rate[i, k]
            a[i, held[k]] = moving_acceleration[i, k]
        smallest = 1.0
        for b in range(blocks):
            first, last = ptr[b], ptr[b + 1]
            residuals(kind, A, B, first, last, x, i, target, inverse, gradient, work)
            jacobian(first, last, entry_ptr[b], entry_ptr[b + 1], entry_row, entry_col, entry_axis, entry_sign, gradient, lu)
            if sums:
                sum_terms(plan, b, x[i], terms)
                sum_jacobian(plan, b, terms, lu)
            now = lu_factor(lu, pivot, first, last - first)
            if i > 0 and now != sign[b]:
                return FLIPPED, i, 0.0
            sign[b] = now
            # from above: exact but for the share of other directions left in the vector, which two turns a sample keep small
            for turn in range(2 if i > 0 else 100):
                weakest = _gauge(first, last, lu, pivot, weak, work, turn)
            smallest = min(smallest, weakest)
            if sums:
                _sums_velocity(plan, b, v, i, rates, lu, pivot, gradient, terms, work, x, target)
                _sums_acceleration(plan, b, v, a, i, rates, seconds, inverse, lu, pivot, gradient, terms, work, x, target)
                continue
            _velocity(kind, A, B, drive, col, first, last, x, v, i, target, rates, lu, pivot, gradient, work)
            _acceleration(kind, A, B, drive, col, first, last, x, v, a, i, target, inverse, rates, seconds, lu, pivot, gradient,
                          work)  # fmt: skip
        gauge[i] = smallest
        if not smallest >= least:
            return WEAK, i, 0.0
    return DONE, t.size, 1.0
