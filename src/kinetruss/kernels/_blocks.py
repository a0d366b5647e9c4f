"""One block of the block triangular form: its rows, its Jacobian, its Newton step.

Row of a bar, d = x_B - x_A: residual (|d|^2/L - L)/2, gradient d/L; of an angle: n . d with n = (-sin, cos), gradient n.
Scaled like this, all gradients are unit vectors at the solution, and pivots can be compared. Sums of terms: see _sums.

Steps of hot loops take arrays, not the plan: each access to a field of the record costs as much as a row (a reference is
counted). The fields keep their names.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels._jit import kernel, kernel_inline
from kinetruss.kernels._lu import lu_factor, lu_solve
from kinetruss.kernels._plan import LENGTH, SUM
from kinetruss.kernels._sums import sum_jacobian, sum_residuals

__all__ = ["aim", "jacobian", "newton_block", "newton_step", "residuals", "row_gradient", "targets"]


@kernel
def targets(plan):  # type: ignore[no-untyped-def]
    """Room for what rows are held to: target (rows,) m or rad, and its reciprocal; constant rows are filled in."""
    target = plan.value.copy()
    inverse = np.ones(target.size)
    for k in range(target.size):
        if plan.kind[k] == LENGTH and target[k] > 0.0:
            inverse[k] = 1.0 / target[k]
    return target, inverse


@kernel_inline
def aim(driven, drive, values, i, target, inverse):  # type: ignore[no-untyped-def]
    """Set the targets of driven rows to sample i of the drives' values (times, drives)."""
    for d in range(driven.size):
        k = driven[d]
        target[k] = values[i, drive[k]]
        inverse[k] = 1.0 / target[k]


@kernel_inline
def row_gradient(kind, A, B, k, x, i, target, inverse, gradient):  # type: ignore[no-untyped-def]
    """Residual of row k at x[i]; its gradient with respect to the position of B into gradient[k]."""
    a, b = A[k], B[k]
    dx, dy, dz = x[i, b] - x[i, a], x[i, b + 1] - x[i, a + 1], x[i, b + 2] - x[i, a + 2]
    if kind[k] != LENGTH:
        if kind[k] == SUM:
            gradient[k, 0], gradient[k, 1], gradient[k, 2] = 0.0, 0.0, 0.0
            return 0.0
        gx, gy = -math.sin(target[k]), math.cos(target[k])
        gradient[k, 0], gradient[k, 1], gradient[k, 2] = gx, gy, 0.0
        return gx * dx + gy * dy
    scale = inverse[k]
    gradient[k, 0], gradient[k, 1], gradient[k, 2] = dx * scale, dy * scale, dz * scale
    return 0.5 * ((dx * dx + dy * dy + dz * dz) * scale - target[k])


@kernel_inline
def residuals(kind, A, B, first, last, x, i, target, inverse, gradient, work):  # type: ignore[no-untyped-def]
    """Minus the residuals of rows first:last at x[i] into work, gradients into gradient."""
    for k in range(first, last):
        work[k - first] = -row_gradient(kind, A, B, k, x, i, target, inverse, gradient)


@kernel_inline
def jacobian(first, last, entry, end, entry_row, entry_col, entry_axis, entry_sign, gradient, lu):  # type: ignore[no-untyped-def]
    """Jacobian of the block of rows first:last, entries entry:end, into its rows of `lu`, from the gradients."""
    for k in range(first, last):
        for j in range(last - first):
            lu[k, j] = 0.0
    for e in range(entry, end):
        lu[entry_row[e], entry_col[e]] = entry_sign[e] * gradient[entry_row[e], entry_axis[e]]


@kernel_inline
def newton_step(col, first, last, x, i, work):  # type: ignore[no-untyped-def]
    """Add work[:last-first] to the coordinates of a block in x[i]; returns the largest change."""
    largest = 0.0
    for k in range(last - first):
        x[i, col[first + k]] += work[k]
        largest = max(largest, abs(work[k]))
    return largest


@kernel
def newton_block(plan, b, x, i, target, inverse, lu, pivot, gradient, terms, work, limit):  # type: ignore[no-untyped-def]
    """Newton's method on block b with a fresh Jacobian each step; coordinates of x[i] change in place.

    `limit` (m) bounds a single step of any coordinate. Returns True when the residual is at round-off.
    """
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for _ in range(15):
        residuals(plan.kind, plan.A, plan.B, first, last, x, i, target, inverse, gradient, work)
        if plan.sum_row.size:
            sum_residuals(plan, b, first, x[i], target, terms, work)
        jacobian(first, last, plan.entry_ptr[b], plan.entry_ptr[b + 1], plan.entry_row, plan.entry_col, plan.entry_axis,
                 plan.entry_sign, gradient, lu)  # fmt: skip
        if plan.sum_row.size:
            sum_jacobian(plan, b, terms, lu)
        lu_factor(lu, pivot, first, last - first)
        lu_solve(lu, pivot, first, last - first, work)
        step = 0.0
        for k in range(last - first):
            step = max(step, abs(work[k]))
        if not step < limit:
            return False
        newton_step(plan.col, first, last, x, i, work)
        if step < 1e-10 * limit:
            return True
    return False
