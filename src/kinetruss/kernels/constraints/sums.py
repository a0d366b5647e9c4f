"""Rows of a plan that hold a sum of terms (see constraints.terms), in the places where the sweeps take those of two nodes.

A row reads scale (sum - target) = 0, with the difference taken the shortest way where the sum is the same after a period.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_inline
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1, F2, I1
from kinetruss.kernels.constraints.terms import nearest_turn, term_along, term_gradient, term_second, term_value
from kinetruss.kernels.structure.plan import Plan

__all__ = ["sum_first", "sum_jacobian", "sum_known", "sum_of", "add_sum_forces", "sum_residuals", "sum_second", "sum_terms"]


@kernel_late
def sum_terms(plan: Plan, b: int, x: F1, terms: F2) -> None:
    """Gradients of the terms of block b (one behind the last: of redundant rows) at flat positions x into terms (t, 10)."""
    first, last = plan.sum_ptr[b], plan.sum_ptr[b + 1] if b + 1 < plan.sum_ptr.size else plan.sum_row.size
    # gradient g and shares w1, w2 of each term, g times the scale of its constraint
    for j in range(first, last):
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            term_gradient(plan.term_kind, plan.term_at, plan.term_data, t, x, terms[t])
            for c in range(3):
                terms[t, c] *= plan.sum_scale[j]


@kernel_late
def sum_residuals(plan: Plan, b: int, first: int, x: F1, target: F1, terms: F2, work: F1) -> None:
    """Minus the residuals of the sums of block b, whose rows begin at `first`, into work; gradients into terms."""
    sum_terms(plan, b, x, terms)
    # -Phi = -scale (sum of the terms - target)
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        gap = -target[plan.sum_row[j]]
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            gap += term_value(plan.term_kind, plan.term_at, plan.term_data, t, x)
        work[plan.sum_row[j] - first] = -plan.sum_scale[j] * nearest_turn(gap, plan.sum_period[j])


@kernel_late
def sum_jacobian(plan: Plan, b: int, terms: F2, lu: F2) -> None:
    """Rows of the sums of block b in its matrix."""
    # J of the block: component of g, times 1 at P, -w1 at node 1, -w2 at node 2
    for e in range(plan.sum_entry_ptr[b], plan.sum_entry_ptr[b + 1]):
        k, t, place = plan.sum_entry[e, 0], plan.sum_entry[e, 1], plan.sum_entry[e, 2]
        share = 1.0 if place == 0 else -terms[t, 2 + place]
        lu[k, plan.sum_entry[e, 4]] += share * terms[t, plan.sum_entry[e, 3]]


@kernel_inline
def sum_first(plan: Plan, b: int, first: int, work: F1) -> None:
    """Right-hand sides of the sums of block b for velocities, scaled like their rows."""
    # prescribed rate times the scale: the right-hand side of J v
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        work[plan.sum_row[j] - first] *= plan.sum_scale[j]


@kernel_late
def sum_known(plan: Plan, b: int, first: int, y: F1, terms: F2, work: F1) -> None:
    """Take what the gradients of the sums of block b make of y off work."""
    # take J y of the known coordinates off the right-hand side
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            work[plan.sum_row[j] - first] -= term_along(plan.term_at, t, terms[t], y)


@kernel_late
def sum_second(plan: Plan, b: int, first: int, x: F1, v: F1, wanted: F1, work: F1, scratch: F1) -> None:
    """Right-hand sides of the sums of block b for accelerations: what drives ask (drives,) less what v makes; scratch (10,)."""
    # gamma = scale (q'' - J' v)
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        k = plan.sum_row[j]
        total = wanted[plan.drive[k]] if plan.drive[k] >= 0 else 0.0
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            total -= term_second(plan.term_kind, plan.term_at, plan.term_data, t, x, v, scratch)
        work[k - first] = plan.sum_scale[j] * total


@kernel_inline
def sum_of(sum_row: I1, k: int) -> int:
    """Place of row k among the sums, or -1."""
    # linear search: models have few sums
    for j in range(sum_row.size):
        if sum_row[j] == k:
            return j
    return -1


@kernel_late
def add_sum_forces(plan: Plan, j: int, terms: F2, amount: float, rest: F1) -> None:
    """rest -= J^T amount of sum j."""
    # -J^T N of the terms: N g at P, shares w1, w2 back at nodes 1 and 2
    for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
        P, one, two = plan.term_at[t, 0], plan.term_at[t, 1], plan.term_at[t, 2]
        for c in range(3):
            force = amount * terms[t, c]
            rest[P + c] -= force
            rest[one + c] += terms[t, 3] * force
            rest[two + c] += terms[t, 4] * force
