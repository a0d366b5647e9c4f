"""One block of the block triangular form: its rows, Jacobian, factors and Newton step; first-order transfer along the blocks.

Row of a bar, d = x_B - x_A: residual (|d|^2/L - L)/2, gradient d/L; of an angle: n . d with n = (-sin, cos), gradient n.
Scaled like this, all gradients are unit vectors at the solution, and pivots can be compared. Sums: see structure.sums.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import B2, F1, F2, I1, Floats
from kinetruss.kernels.structure.mass import between, dot
from kinetruss.kernels.structure.rows import row_gradient, row_residual, unit_gradient
from kinetruss.kernels.structure.structure import LENGTH, SMALL, Plan
from kinetruss.kernels.structure.sums import sum_jacobian, sum_known, sum_residuals, sum_terms
from kinetruss.kernels.sweep.lu import (
    FAILED,
    Order,
    lu_factor,
    lu_solve,
    lu_solve_transposed,
    new_order,
    sparse_again,
    sparse_first,
    sparse_solve,
    sparse_solve_transposed,
)

NEW, SPARSE, FULL = 0, 1, 2
large = Apart("plan.large[{}]")
"""Kernels of blocks of more than `SMALL` rows."""


class Workspace(NamedTuple):
    """What the sweeps over the blocks of a plan write, by rows of the plan.

    target (rows,) m or rad: what rows are held to; inverse (rows,): its reciprocal for lengths.
    gradient (rows, 3): of the residual by the position of B; terms (terms, 24): gradients in sums.
    lu (rows, width), pivot (rows,): factors of the blocks; order, parity (blocks,), state (blocks,): of large ones.
    work, scratch : right-hand sides and solutions of one block. full (width, width), left (2, width): to look for an order.
    """

    target: F1
    inverse: F1
    gradient: F2
    terms: F2
    lu: F2
    pivot: I1
    order: Order
    parity: F1
    state: I1
    work: F1
    scratch: F1
    full: B2
    left: B2


@kernel
def workspace(plan: Plan) -> Workspace:
    """Workspace of a plan; targets of constant rows are filled in."""
    n, target, width = plan.row.size, plan.value.copy(), plan.width
    inverse = np.ones(n)
    # 1/L of constant lengths
    for k in range(n):
        if plan.kind[k] == LENGTH and target[k] > 0.0:
            inverse[k] = 1.0 / target[k]
    return Workspace(
        target,
        inverse,
        np.empty((n, 3)),
        np.empty((plan.term_form.shape[0], 24)),
        np.empty((n, width)),
        np.zeros(n + 1, np.int64),  # within bounds also where nothing was factored
        new_order(n if width > SMALL else 0, width),
        np.ones(plan.ptr.size),
        np.zeros(plan.ptr.size, np.int64),
        np.empty(n + 1),
        np.empty(max(n, 24)),  # a term has so many numbers
        np.empty((width, width), np.bool_),
        np.empty((2, width), np.bool_),
    )


@kernel_inline
def set_targets(plan: Plan, w: Workspace, values: F2, i: int) -> None:
    """Set the targets of driven rows to sample i of the drives' values (times, drives)."""
    # target of each driven constraint, and 1/L
    for d in range(plan.driven.size):
        k = plan.driven[d]
        w.target[k] = values[i, plan.drive[k]]
        w.inverse[k] = 1.0 / w.target[k]


@kernel_inline
def _row(plan: Plan, w: Workspace, k: int, x: F2, i: int) -> float:
    """Residual of row k at x[i]; its gradient with respect to the position of B into w.gradient[k]."""
    d, gradient = between(x[i], plan.A[k], plan.B[k]), w.gradient
    g = row_gradient(plan.kind[k], d, w.target[k], w.inverse[k])
    gradient[k, 0], gradient[k, 1], gradient[k, 2] = g
    return row_residual(plan.kind[k], g, d, w.target[k])


@kernel_inline
def gradients(plan: Plan, w: Workspace, first: int, last: int, x: F2, i: int) -> None:
    """Gradients of rows first:last at x[i], but those of sums."""
    for k in range(first, last):
        _row(plan, w, k, x, i)


@kernel_inline
def residuals(plan: Plan, w: Workspace, b: int, x: F2, i: int) -> None:
    """Minus the residuals of block b at x[i] into w.work, gradients of all rows but sums into w.gradient."""
    first = plan.ptr[b]
    # -Phi, the right-hand side of Newton's method
    for k in range(first, plan.ptr[b + 1]):
        w.work[k - first] = -_row(plan, w, k, x, i)
    if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
        sum_residuals(plan, b, first, x[i], w.target, w.work)


@kernel_inline
def _jacobian(plan: Plan, w: Workspace, b: int) -> None:
    """Jacobian of block b from the gradients, into its rows of w.lu."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    for k in range(first, last):
        for j in range(last - first):
            w.lu[k, j] = 0.0
    # J of lengths and angles: +g at B, -g at A
    for e in range(plan.entry_ptr[b], plan.entry_ptr[b + 1]):
        k = plan.entry_row[e]
        w.lu[k, plan.entry_col[e]] = plan.entry_sign[e] * w.gradient[k, plan.entry_axis[e]]
    if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
        sum_jacobian(plan, b, w.terms, w.lu)


@kernel_inline
def factor_gradients(plan: Plan, w: Workspace, b: int) -> float:
    """Factor the Jacobian that belongs to the gradients of block b; returns the sign of its determinant (0: singular)."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    _jacobian(plan, w, b)
    if last - first <= SMALL:
        return lu_factor(w.lu, w.pivot, first, last - first)
    return _factor_large(plan, w, b)


@large
def _factor_large(plan: Plan, w: Workspace, b: int) -> float:
    """Factor the Jacobian of a large block, in the order of elimination found for it while that is good."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    n = last - first
    if w.state[b] == SPARSE:
        sign = sparse_again(w.lu, w.order, first, last)
        if sign != FAILED:
            return w.parity[b] * sign
        _jacobian(plan, w, b)
    if w.state[b] != FULL:
        _mark(plan, w, b)
        w.parity[b], sign, count = sparse_first(w.lu, w.full, w.left, w.order, first, n)
        # one multiplication by lists takes as long as four of a full matrix, which has n^3/3 of them
        w.state[b] = SPARSE if 12 * count < n * n * n else FULL
        if w.state[b] == SPARSE:
            return w.parity[b] * sign
        _jacobian(plan, w, b)
    return lu_factor(w.lu, w.pivot, first, n)


@kernel_inline
def _mark(plan: Plan, w: Workspace, b: int) -> None:
    """Where the Jacobian of block b may differ from 0, into w.full."""
    first = plan.ptr[b]
    for i in range(w.full.shape[0]):
        for j in range(w.full.shape[1]):
            w.full[i, j] = False
    # entries of lengths and angles
    for e in range(plan.entry_ptr[b], plan.entry_ptr[b + 1]):
        w.full[plan.entry_row[e] - first, plan.entry_col[e]] = True
    # entries of sums
    for e in range(plan.sum_entry_ptr[b], plan.sum_entry_ptr[b + 1]):
        w.full[plan.sum_entry[e, 0] - first, plan.sum_entry[e, 3]] = True


@large
def _solve_large(plan: Plan, w: Workspace, first: int, last: int, y: F1) -> float:  # noqa: ARG001 - plan has its address
    return sparse_solve(w.lu, w.order, first, last, y, w.scratch)


@large
def _solve_large_transposed(plan: Plan, w: Workspace, first: int, last: int, y: F1) -> float:  # noqa: ARG001
    return sparse_solve_transposed(w.lu, w.order, first, last, y, w.scratch)


@kernel_inline
def factor(plan: Plan, w: Workspace, b: int, x: F2, i: int) -> float:
    """Gradients of block b at x[i], and the factors of its Jacobian; returns the sign of its determinant (0: singular)."""
    gradients(plan, w, plan.ptr[b], plan.ptr[b + 1], x, i)
    return _factored(plan, w, b, x, i)


@kernel_inline
def _factored(plan: Plan, w: Workspace, b: int, x: F2, i: int) -> float:
    """The same with the gradients of all rows but sums at hand."""
    if plan.sum_ptr[b] < plan.sum_ptr[b + 1]:
        sum_terms(plan, b, x[i], w.terms)
    return factor_gradients(plan, w, b)


@kernel_inline
def solve(plan: Plan, w: Workspace, b: int, y: F1) -> float:
    """Solve with the factors of block b in place, y[:rows of the block].

    Returns the largest reciprocal of a pivot: endless in a singular position, where rows have unit length.
    """
    first, last = plan.ptr[b], plan.ptr[b + 1]
    if w.state[b] == SPARSE:
        return _solve_large(plan, w, first, last, y)
    return lu_solve(w.lu, w.pivot, first, last - first, y)


@kernel_inline
def solve_transposed(plan: Plan, w: Workspace, b: int, y: F1) -> float:
    """`solve` with the transposed factors."""
    first, last = plan.ptr[b], plan.ptr[b + 1]
    if w.state[b] == SPARSE:
        return _solve_large_transposed(plan, w, first, last, y)
    return lu_solve_transposed(w.lu, w.pivot, first, last - first, y)


@kernel_inline
def known(plan: Plan, w: Workspace, k: int, y: F2, i: int) -> float:
    """What earlier blocks and supports contribute to row k of y (coordinates of its own block are zero)."""
    return dot(w.gradient[k], between(y[i], plan.A[k], plan.B[k]))


@kernel_inline
def newton_step(plan: Plan, w: Workspace, b: int, x: F2, i: int) -> float:
    """Add w.work to the coordinates of block b in x[i]; returns the largest change."""
    first, largest = plan.ptr[b], 0.0
    # correction dx of the coordinates of the block
    for k in range(plan.ptr[b + 1] - first):
        x[i, plan.col[first + k]] += w.work[k]
        largest = larger(largest, abs(w.work[k]))
    return largest


@kernel_bare
def newton_block(plan: Plan, w: Workspace, b: int, x: F2, i: int, limit: float) -> bool:
    """Newton's method on block b with a fresh Jacobian each step; coordinates of x[i] change in place.

    `limit` (m) bounds a single step of any coordinate. Returns True when the residual is at round-off.
    """
    # Newton's method: J dx = -Phi
    for _ in range(15):
        residuals(plan, w, b, x, i)
        _factored(plan, w, b, x, i)
        solve(plan, w, b, w.work)
        step = 0.0
        for k in range(plan.ptr[b + 1] - plan.ptr[b]):
            step = larger(step, abs(w.work[k]))
        if not step < limit:
            return False
        newton_step(plan, w, b, x, i)
        if step < 1e-10 * limit:
            return True
    return False


# First-order geometric transfer: how far every coordinate goes when the rows change by given amounts, J y = r.
#
# One forward sweep over the blocks of the block triangular form for each right-hand side, with the same factors. Gradients
# are taken from the positions themselves, so that it does not matter whether they meet the prescribed values to round-off.


@kernel_inline
def _gradients(plan: Plan, w: Workspace, x: F2, i: int) -> None:
    """Unit gradients of the rows of all blocks at x[i]."""
    # rows of J: u, or n of an angle
    for k in range(plan.ptr[-1]):
        g = unit_gradient(plan.kind[k], between(x[i], plan.A[k], plan.B[k]))
        w.gradient[k, 0], w.gradient[k, 1], w.gradient[k, 2] = g


@kernel_inline
def _changes(plan: Plan, w: Workspace, rhs: Floats, y: Floats, i: int, s: int) -> float:
    """Solve for y[i, s] with the factors at sample i. Returns the largest reciprocal of a pivot."""
    largest = 1.0
    # block b: A y_b = r_b - J y of the earlier blocks
    for b in range(plan.ptr.size - 1):
        first = plan.ptr[b]
        for k in range(first, plan.ptr[b + 1]):
            w.work[k - first] = rhs[i, s, k] - known(plan, w, k, y[i], s)
        if plan.sums.size:
            sum_known(plan, b, first, y[i, s], w.terms, w.work)
        largest = max(largest, solve(plan, w, b, w.work))
        for k in range(first, plan.ptr[b + 1]):
            y[i, s, plan.col[k]] = w.work[k - first]
    return largest


@kernel
def transfer(plan: Plan, x: F2, rhs: Floats, y: Floats, pivot: F1) -> None:
    """Solve J y = rhs at every sample; redundant rows are left out.

    x (times, 3 n) m; rhs (times, k, rows) in the plan's order of rows: change of length, m, of angle times length, m,
    or of a sum times its scale.
    y (times, k, 3 n): holds the changes of prescribed coordinates, m, and zeros; receives those of the free ones.
    pivot (times,): receives the smallest pivots.
    """
    w = workspace(plan)
    # factors once a sample, one forward sweep for each right-hand side
    for i in range(x.shape[0]):
        _gradients(plan, w, x, i)
        largest = 1.0
        for b in range(plan.ptr.size - 1):
            if plan.sums.size:
                sum_terms(plan, b, x[i], w.terms)
            factor_gradients(plan, w, b)
        for s in range(rhs.shape[1]):
            largest = _changes(plan, w, rhs, y, i, s)
        pivot[i] = 1.0 / largest
