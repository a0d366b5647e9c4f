"""Positions, velocities and accelerations along a motion: one forward sweep over the blocks a sample.

Positions by Newton's method, started from the Taylor series of the sample before and first tried with its factors
(chord steps); velocities and accelerations with the factors at the solution. Where a step fails, the way between the
two samples is walked in smaller steps (step-limited continuation), so no other branch is reached in silence.
"""

from __future__ import annotations

import math

import numba
import numpy as np

from kinetruss.kernels._blocks import block_jacobian, block_residual, newton_block, row_value
from kinetruss.kernels._lu import lu_factor, lu_solve, lu_solve_transposed
from kinetruss.kernels._plan import ANGLE

__all__ = ["DONE", "FLIPPED", "STUCK", "WEAK", "follow", "march"]

DONE, STUCK, FLIPPED, WEAK = 0, 1, 2, 3


@numba.njit(cache=True)
def march(plan, x, from_values, to_values, from_moving, to_moving, scale):  # type: ignore[no-untyped-def]
    """Walk from one set of drive values to another in steps that adapt; x (3 n) changes in place.

    Returns the fraction of the way reached: 1 when done; x is then the solution, else the last good state.
    """
    n_rows = plan.row.size
    lu = np.empty(plan.lu_ptr[-1])
    pivot = np.empty(n_rows, np.int64)
    gradient = np.empty((plan.p.size, 3))
    work = np.empty(n_rows + 1)
    values = np.empty_like(from_values)
    trial = x.copy()
    done, step = 0.0, 1.0
    while done < 1.0:
        reach = min(1.0, done + step)
        for d in range(values.size):
            values[d] = from_values[d] + reach * (to_values[d] - from_values[d])
        for k in range(plan.moving.size):
            trial[plan.moving[k]] = from_moving[k] + reach * (to_moving[k] - from_moving[k])
        good = True
        for b in range(plan.ptr.size - 1):
            if not newton_block(plan, b, trial, values, lu, pivot, gradient, work, 0.2 * scale):
                good = False
                break
        if good:
            for i in range(x.size):
                good = good and abs(trial[i] - x[i]) < 0.5 * scale
        if good:
            done = reach
            x[:] = trial
            step *= 2.0
        else:
            trial[:] = x
            step *= 0.5
            if step < 1e-6:
                return done
    return 1.0


@numba.njit(cache=True)
def _chord(plan, b, x, values, lu, pivot, work, scale):  # type: ignore[no-untyped-def]
    """Newton steps on block b with the factors at hand; True when they settle."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    before = 0.05 * scale
    for _ in range(5):
        block_residual(plan, b, x, values, work)
        lu_solve(lu, pivot[first:], plan.lu_ptr[b], n, work)
        step = 0.0
        for k in range(n):
            step = max(step, abs(work[k]))
        if not step < 0.3 * before:
            return False
        for k in range(n):
            x[plan.col[first + k]] += work[k]
        if step < 1e-11 * scale:
            return True
        before = step
    return False


@numba.njit(cache=True)
def _polish(plan, b, x, values, lu, pivot, gradient, work):  # type: ignore[no-untyped-def]
    """Factor block b at x and take one last Newton step with it; returns the sign of the determinant."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    block_jacobian(plan, b, x, values, lu, gradient)
    sign = lu_factor(lu, pivot[first:], plan.lu_ptr[b], n)
    block_residual(plan, b, x, values, work)
    lu_solve(lu, pivot[first:], plan.lu_ptr[b], n, work)
    for k in range(n):
        x[plan.col[first + k]] += work[k]
    return sign


@numba.njit(cache=True)
def _rates(plan, b, x, v, a, values, rates, accelerations, lu, pivot, gradient, work):  # type: ignore[no-untyped-def]
    """Velocities and accelerations of block b: J v = L', J a = (L'^2 + L L'' - |v_q - v_p|^2)/L (angles: their own terms)."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    for order in range(2):
        y = v if order == 0 else a
        for k in range(n):
            y[plan.col[first + k]] = 0.0
        for k in range(n):
            r = plan.row[first + k]
            p, q = 3 * plan.p[r], 3 * plan.q[r]
            drive = plan.drive[r]
            rate = rates[drive] if drive >= 0 else 0.0
            second = accelerations[drive] if drive >= 0 else 0.0
            value = row_value(plan, r, values)
            dvx, dvy, dvz = v[q] - v[p], v[q + 1] - v[p + 1], v[q + 2] - v[p + 2]
            if plan.kind[r] == ANGLE:
                cx, sy = math.cos(value), math.sin(value)
                dx, dy = x[q] - x[p], x[q + 1] - x[p + 1]
                along = cx * dx + sy * dy
                if order == 0:
                    wanted = rate * along
                else:
                    wanted = 2.0 * rate * (cx * dvx + sy * dvy) + second * along + rate * rate * (cx * dy - sy * dx)
            elif order == 0:
                wanted = rate
            else:
                wanted = (rate * rate - dvx * dvx - dvy * dvy - dvz * dvz) / value + second
            wanted -= gradient[r, 0] * (y[q] - y[p])
            wanted -= gradient[r, 1] * (y[q + 1] - y[p + 1])
            wanted -= gradient[r, 2] * (y[q + 2] - y[p + 2])
            work[k] = wanted
        lu_solve(lu, pivot[first:], plan.lu_ptr[b], n, work)
        for k in range(n):
            y[plan.col[first + k]] = work[k]


@numba.njit(cache=True)
def _gauge(plan, b, lu, pivot, weak, rounds):  # type: ignore[no-untyped-def]
    """Smallest singular value of block b by inverse iteration on A^T A; `weak` keeps the vector between samples."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    o = plan.lu_ptr[b]
    size = 1.0
    for _ in range(rounds):
        lu_solve_transposed(lu, pivot[first:], o, n, weak[first:])
        total = 0.0
        for k in range(first, first + n):
            total += weak[k] * weak[k]
        size = math.sqrt(total)
        lu_solve(lu, pivot[first:], o, n, weak[first:])
        total = 0.0
        for k in range(first, first + n):
            total += weak[k] * weak[k]
        norm = 1.0 / math.sqrt(total)
        for k in range(first, first + n):
            weak[k] *= norm
    return 1.0 / size


@numba.njit(cache=True)
def _predict(x, v, a, i, h):  # type: ignore[no-untyped-def]
    for c in range(x.shape[1]):
        x[i, c] = x[i - 1, c] + h * (v[i - 1, c] + 0.5 * h * a[i - 1, c])


@numba.njit(cache=True)
def _settle(plan, x, i, values, moving, lu, pivot, work, scale):  # type: ignore[no-untyped-def]
    """All blocks of sample i by chord steps from the predicted positions; False if one does not settle."""
    for k in range(plan.moving.size):
        x[i, plan.moving[k]] = moving[i, k]
    for b in range(plan.ptr.size - 1):
        if not _chord(plan, b, x[i], values[i], lu, pivot, work, scale):
            return False
    return True


@numba.njit(cache=True, nogil=True)
def follow(plan, start, start_values, start_moving, t, values, rates, accelerations, moving, moving_rate,
           moving_acceleration, scale, least, x, v, a, gauge):  # type: ignore[no-untyped-def]  # fmt: skip
    """Fill x, v, a (times, 3 n) and gauge (times,) for the drive histories.

    start : (3 n,) a configuration that satisfies start_values, start_moving. scale : shortest bar, m.
    least : stop where the smallest singular value of a block falls below it.
    Returns (reason, number of good samples, fraction of the way to the next sample reached).
    """
    n_rows = plan.row.size
    lu = np.empty(plan.lu_ptr[-1])
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((plan.p.size, 3))
    work = np.empty(n_rows + 1)
    weak = np.ones(n_rows + 1)
    sign = np.zeros(plan.ptr.size)
    for i in range(t.size):
        quick = False
        if i > 0:
            _predict(x, v, a, i, t[i] - t[i - 1])
            quick = _settle(plan, x, i, values, moving, lu, pivot, work, scale)
        if not quick:
            if i == 0:
                x[0] = start
                reached = march(plan, x[0], start_values, values[0], start_moving, moving[0], scale)
            else:
                x[i] = x[i - 1]
                reached = march(plan, x[i], values[i - 1], values[i], moving[i - 1], moving[i], scale)
            if reached < 1.0:
                return STUCK, i, reached
        v[i] = 0.0
        a[i] = 0.0
        for k in range(plan.moving.size):
            v[i, plan.moving[k]] = moving_rate[i, k]
            a[i, plan.moving[k]] = moving_acceleration[i, k]
        smallest = 1e300
        for b in range(plan.ptr.size - 1):
            now = _polish(plan, b, x[i], values[i], lu, pivot, gradient, work)
            if i > 0 and now != sign[b]:
                return FLIPPED, i, 0.0
            sign[b] = now
            weakest = _gauge(plan, b, lu, pivot, weak, 1 if i > 0 else 8)
            smallest = min(smallest, weakest)
            _rates(plan, b, x[i], v[i], a[i], values[i], rates[i], accelerations[i], lu, pivot, gradient, work)
        gauge[i] = smallest if n_rows > 0 else 1.0
        if gauge[i] < least:
            return WEAK, i, 0.0
    return DONE, t.size, 1.0
