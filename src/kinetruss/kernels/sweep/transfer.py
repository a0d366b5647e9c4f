"""First-order geometric transfer: how far every coordinate goes when the rows change by given amounts, J y = r.

One forward sweep over the blocks of the block triangular form for each right-hand side, with the same factors. Gradients
are taken from the positions themselves, so that it does not matter whether they meet the prescribed values to round-off.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F2, Floats
from kinetruss.kernels.constraints.rows import unit_gradient
from kinetruss.kernels.constraints.sums import sum_known, sum_terms
from kinetruss.kernels.structure.mass import between
from kinetruss.kernels.structure.plan import Plan
from kinetruss.kernels.sweep.blocks import Workspace, factor_gradients, known, solve, workspace

__all__ = ["transfer"]


@kernel_inline
def _gradients(plan: Plan, w: Workspace, x: F2, i: int) -> None:
    """Unit gradients of the rows of all blocks at x[i]."""
    # rows of J: u, or n of an angle
    for k in range(plan.ptr[-1]):
        g = unit_gradient(plan.kind[k], between(x[i], plan.A[k], plan.B[k]))
        w.gradient[k, 0], w.gradient[k, 1], w.gradient[k, 2] = g


@kernel_inline
def _changes(plan: Plan, w: Workspace, rhs: Floats, y: Floats, i: int, s: int) -> None:
    """Solve for y[i, s] with the factors at sample i."""
    # block b: A y_b = r_b - J y of the earlier blocks
    for b in range(plan.ptr.size - 1):
        first = plan.ptr[b]
        for k in range(first, plan.ptr[b + 1]):
            w.work[k - first] = rhs[i, s, k] - known(plan, w, k, y[i], s)
        sum_known(plan, b, first, y[i, s], w.terms, w.work)
        solve(plan, w, b, w.work)
        for k in range(first, plan.ptr[b + 1]):
            y[i, s, plan.col[k]] = w.work[k - first]


@kernel
def transfer(plan: Plan, x: F2, rhs: Floats, y: Floats) -> None:
    """Solve J y = rhs at every sample; redundant rows are left out.

    x (times, 3 n) m; rhs (times, k, rows) in the plan's order of rows: change of length, m, of angle times length, m,
    or of a sum times its scale.
    y (times, k, 3 n): holds the changes of prescribed coordinates, m, and zeros; receives those of the free ones.
    """
    w = workspace(plan)
    # factors once a sample, one forward sweep for each right-hand side
    for i in range(x.shape[0]):
        _gradients(plan, w, x, i)
        for b in range(plan.ptr.size - 1):
            sum_terms(plan, b, x[i], w.terms)
            factor_gradients(plan, w, b)
        for s in range(rhs.shape[1]):
            _changes(plan, w, rhs, y, i, s)
