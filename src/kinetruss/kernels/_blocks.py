"""One block of the block triangular form: its rows, its Jacobian, its Newton step.

Row of a bar, d = x_q - x_p: residual (|d|^2 - L^2)/(2 L), gradient d/L; of an angle: n . d with n = (-sin, cos), gradient n.
Scaled like this, all gradients are unit vectors at the solution, and pivots can be compared.
"""

from __future__ import annotations

import math

import numba

from kinetruss.kernels._lu import lu_factor, lu_solve
from kinetruss.kernels._plan import ANGLE

__all__ = ["block_jacobian", "block_residual", "newton_block", "row_value"]


@numba.njit(cache=True, inline="always")
def row_value(plan, r, values):  # type: ignore[no-untyped-def]
    """Prescribed length (m) or angle (rad) of row r; `values` are the drives' values."""
    drive = plan.drive[r]
    return values[drive] if drive >= 0 else plan.value[r]


@numba.njit(cache=True, inline="always")
def row_gradient(plan, r, x, value):  # type: ignore[no-untyped-def]
    """Residual of row r and its gradient with respect to the position of q (minus that of p)."""
    p, q = 3 * plan.p[r], 3 * plan.q[r]
    dx, dy, dz = x[q] - x[p], x[q + 1] - x[p + 1], x[q + 2] - x[p + 2]
    if plan.kind[r] == ANGLE:
        gx, gy = -math.sin(value), math.cos(value)
        return gx * dx + gy * dy, gx, gy, 0.0
    inverse = 1.0 / value
    return 0.5 * (dx * dx + dy * dy + dz * dz - value * value) * inverse, dx * inverse, dy * inverse, dz * inverse


@numba.njit(cache=True)
def block_residual(plan, b, x, values, out):  # type: ignore[no-untyped-def]
    """Residuals of block b into out, negated (right-hand side of Newton); returns the largest magnitude."""
    largest = 0.0
    first = plan.ptr[b]
    for k in range(first, plan.ptr[b + 1]):
        r = plan.row[k]
        residual, _, _, _ = row_gradient(plan, r, x, row_value(plan, r, values))
        out[k - first] = -residual
        largest = max(largest, abs(residual))
    return largest


@numba.njit(cache=True)
def block_jacobian(plan, b, x, values, lu, gradient):  # type: ignore[no-untyped-def]
    """Jacobian of block b into its slice of `lu`; unit gradients of its rows into gradient (rows, 3)."""
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    o = plan.lu_ptr[b]
    for i in range(o, o + n * n):
        lu[i] = 0.0
    for k in range(first, first + n):
        r = plan.row[k]
        _, gx, gy, gz = row_gradient(plan, r, x, row_value(plan, r, values))
        gradient[r, 0], gradient[r, 1], gradient[r, 2] = gx, gy, gz
        at = o + (k - first) * n
        for e in range(plan.entry_ptr[k], plan.entry_ptr[k + 1]):
            lu[at + plan.entry_col[e]] = plan.entry_sign[e] * gradient[r, plan.entry_axis[e]]


@numba.njit(cache=True)
def newton_block(plan, b, x, values, lu, pivot, gradient, work, limit):  # type: ignore[no-untyped-def]
    """Newton's method on block b with a fresh Jacobian each step; coordinates of x change in place.

    `limit` (m) bounds a single step of any coordinate. Returns True when the residual is at round-off.
    """
    first = plan.ptr[b]
    n = plan.ptr[b + 1] - first
    o = plan.lu_ptr[b]
    for _ in range(15):
        block_residual(plan, b, x, values, work)
        block_jacobian(plan, b, x, values, lu, gradient)
        lu_factor(lu, pivot[first:], o, n)
        lu_solve(lu, pivot[first:], o, n, work)
        step = 0.0
        for k in range(n):
            step = max(step, abs(work[k]))
        if not step < limit:
            return False
        for k in range(n):
            x[plan.col[first + k]] += work[k]
        if step < 1e-11 * limit:
            return True
    return False
