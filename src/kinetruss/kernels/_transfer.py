"""First-order geometric transfer: how far every coordinate goes when the rows change by given amounts, J y = r.

One forward sweep over the blocks of the block triangular form for each right-hand side, with the same factors. Gradients
are taken from the positions themselves, so that it does not matter whether they meet the prescribed values to round-off.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels._blocks import jacobian
from kinetruss.kernels._jit import kernel
from kinetruss.kernels._lu import lu_factor, lu_solve
from kinetruss.kernels._plan import ANGLE, SUM
from kinetruss.kernels._sums import sum_jacobian, sum_known, sum_terms

__all__ = ["transfer"]


@kernel
def transfer(plan, x, rhs, y):  # type: ignore[no-untyped-def]
    """Solve J y = rhs at every sample; redundant rows are left out.

    x (times, 3 n) m; rhs (times, k, rows) in the plan's order of rows: change of length, m, of angle times length, m,
    or of a sum times its scale.
    y (times, k, 3 n): holds the changes of prescribed coordinates, m, and zeros; receives those of the free ones.
    """
    A, B, kind, ptr, col = plan.A, plan.B, plan.kind, plan.ptr, plan.col
    rows, blocks = ptr[-1], ptr.size - 1
    lu = np.empty((rows, plan.width))
    pivot = np.empty(rows + 1, np.int64)
    gradient = np.empty((rows, 3))
    terms = np.empty((plan.term_kind.size, 10))
    work = np.empty(rows + 1)
    for i in range(x.shape[0]):
        for k in range(rows):
            a, b = A[k], B[k]
            dx, dy, dz = x[i, b] - x[i, a], x[i, b + 1] - x[i, a + 1], x[i, b + 2] - x[i, a + 2]
            scale = 1.0 / (dx * dx + dy * dy + dz * dz) ** 0.5
            if kind[k] == ANGLE:
                dx, dy, dz = -dy, dx, 0.0
            if kind[k] == SUM:
                scale = 0.0
            gradient[k, 0], gradient[k, 1], gradient[k, 2] = dx * scale, dy * scale, dz * scale
        for b in range(blocks):
            first, last = ptr[b], ptr[b + 1]
            jacobian(first, last, plan.entry_ptr[b], plan.entry_ptr[b + 1], plan.entry_row, plan.entry_col, plan.entry_axis,
                     plan.entry_sign, gradient, lu)  # fmt: skip
            if plan.sum_row.size:
                sum_terms(plan, b, x[i], terms)
                sum_jacobian(plan, b, terms, lu)
            lu_factor(lu, pivot, first, last - first)
        for s in range(rhs.shape[1]):
            for b in range(blocks):
                first, last = ptr[b], ptr[b + 1]
                for k in range(first, last):
                    known = 0.0
                    for c in range(3):
                        known += gradient[k, c] * (y[i, s, B[k] + c] - y[i, s, A[k] + c])
                    work[k - first] = rhs[i, s, k] - known
                if plan.sum_row.size:
                    sum_known(plan, b, first, y[i, s], terms, work)
                lu_solve(lu, pivot, first, last - first, work)
                for k in range(first, last):
                    y[i, s, col[k]] = work[k - first]
