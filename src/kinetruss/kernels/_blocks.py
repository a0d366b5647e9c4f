"""One block of the block triangular form: its rows, its Jacobian, its Newton step.

Row of a bar, d = x_B - x_A: residual (|d|^2/L - L)/2, gradient d/L; of an angle: n . d with n = (-sin, cos), gradient n.
Scaled like this, all gradients are unit vectors at the solution, and pivots can be compared.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels._jit import kernel, kernel_inline
from kinetruss.kernels._lu import lu_factor, lu_solve
from kinetruss.kernels._plan import ANGLE

__all__ = ["aim", "jacobian", "newton_block", "newton_step", "residuals", "row_gradient", "targets"]


@kernel
def targets(plan):  # type: ignore[no-untyped-def]
    """Room for what rows are held to: target (rows,) m or rad, and its reciprocal; constant rows are filled in."""
    target = plan.value.copy()
    inverse = np.ones(target.size)
    for k in range(target.size):
        if plan.kind[k] != ANGLE and target[k] > 0.0:
            inverse[k] = 1.0 / target[k]
    return target, inverse


@kernel_inline
def aim(plan, values, i, target, inverse):  # type: ignore[no-untyped-def]
    """Set the targets of driven rows to sample i of the drives' values (times, drives)."""
    for d in range(plan.driven.size):
        k = plan.driven[d]
        target[k] = values[i, plan.drive[k]]
        inverse[k] = 1.0 / target[k]


@kernel_inline
def row_gradient(plan, k, x, i, target, inverse, gradient):  # type: ignore[no-untyped-def]
    """Residual of row k at x[i]; its gradient with respect to the position of B into gradient[k]."""
    A, B = plan.A[k], plan.B[k]
    dx, dy, dz = x[i, B] - x[i, A], x[i, B + 1] - x[i, A + 1], x[i, B + 2] - x[i, A + 2]
    if plan.kind[k] == ANGLE:
        gx, gy = -math.sin(target[k]), math.cos(target[k])
        gradient[k, 0], gradient[k, 1], gradient[k, 2] = gx, gy, 0.0
        return gx * dx + gy * dy
    scale = inverse[k]
    gradient[k, 0], gradient[k, 1], gradient[k, 2] = dx * scale, dy * scale, dz * scale
    return 0.5 * ((dx * dx + dy * dy + dz * dz) * scale - target[k])


@kernel_inline
def residuals(plan, b, x, i, target, inverse, gradient, work):  # type: ignore[no-untyped-def]
    """Minus the residuals of block b at x[i] into work, gradients into gradient."""
    first = plan.ptr[b]
    for k in range(plan.ptr[b + 1] - first):
        work[k] = -row_gradient(plan, first + k, x, i, target, inverse, gradient)


@kernel_inline
def jacobian(plan, b, x, i, target, inverse, lu, gradient, work):  # type: ignore[no-untyped-def]
    """Jacobian of block b at x[i] into its slice of `lu`; gradients and minus residuals as in `residuals`."""
    o = plan.lu_ptr[b]
    for at in range(o, plan.lu_ptr[b + 1]):
        lu[at] = 0.0
    residuals(plan, b, x, i, target, inverse, gradient, work)
    for k in range(plan.ptr[b], plan.ptr[b + 1]):
        for e in range(plan.entry_ptr[k], plan.entry_ptr[k + 1]):
            lu[o + plan.entry_at[e]] = plan.entry_sign[e] * gradient[k, plan.entry_axis[e]]


@kernel_inline
def newton_step(plan, b, x, i, work):  # type: ignore[no-untyped-def]
    """Add work[:n] to the coordinates of block b in x[i]; returns the largest change."""
    first = plan.ptr[b]
    largest = 0.0
    for k in range(plan.ptr[b + 1] - first):
        x[i, plan.col[first + k]] += work[k]
        largest = max(largest, abs(work[k]))
    return largest


@kernel
def newton_block(plan, b, x, i, target, inverse, lu, pivot, gradient, work, limit):  # type: ignore[no-untyped-def]
    """Newton's method on block b with a fresh Jacobian each step; coordinates of x[i] change in place.

    `limit` (m) bounds a single step of any coordinate. Returns True when the residual is at round-off.
    """
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    for _ in range(15):
        jacobian(plan, b, x, i, target, inverse, lu, gradient, work)
        lu_factor(lu, pivot, plan.lu_ptr[b], first, n)
        lu_solve(lu, pivot, plan.lu_ptr[b], first, n, work)
        step = 0.0
        for k in range(n):
            step = max(step, abs(work[k]))
        if not step < limit:
            return False
        newton_step(plan, b, x, i, work)
        if step < 1e-10 * limit:
            return True
    return False
