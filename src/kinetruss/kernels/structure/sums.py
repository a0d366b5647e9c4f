"""Rows that hold a sum of terms (structure.terms): in the plan of the sweeps, and in the equations of motion.

A row reads scale (sum - target) = 0, with the difference taken the shortest way where the sum is the same after a period.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I1, I2
from kinetruss.kernels.structure.equations import SUM_FORCE, Equations, Workspace
from kinetruss.kernels.structure.structure import Plan
from kinetruss.kernels.structure.tables import entry_at
from kinetruss.kernels.structure.terms import add_term, nearest_turn, term_along, term_gradient, term_second, term_value

of_plan = Apart("plan.sums[{}]")
"""Kernels of plans with such rows."""
of_equations = Apart("eq.sums[{}]")
"""Kernels of equations with such rows, or with torques on sums."""


@of_plan
def sum_terms(plan: Plan, b: int, x: F1, terms: F2) -> None:
    """Gradients of the terms of block b (one behind the last: of redundant rows) at flat positions x into terms (t, 24)."""
    first, last = plan.sum_ptr[b], plan.sum_ptr[b + 1] if b + 1 < plan.sum_ptr.size else plan.sum_row.size
    # gradient of each term by its nodes, times the scale of its constraint
    for j in range(first, last):
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            term_gradient(plan.term_form, plan.term_at, plan.term_data, t, x, terms[t])
            for c in range(12):
                terms[t, c] *= plan.sum_scale[j]


@of_plan
def sum_residuals(plan: Plan, b: int, first: int, x: F1, target: F1, work: F1) -> None:
    """Minus the residuals of the sums of block b, whose rows begin at `first`, into work."""
    # -Phi = -scale (sum of the terms - target)
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        gap = -target[plan.sum_row[j]]
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            gap += term_value(plan.term_form, plan.term_at, plan.term_data, t, x)
        work[plan.sum_row[j] - first] = -plan.sum_scale[j] * nearest_turn(gap, plan.sum_period[j])


@of_plan
def sum_jacobian(plan: Plan, b: int, terms: F2, lu: F2) -> None:
    """Rows of the sums of block b in its matrix."""
    # J of the block: entry c of the gradient of term t
    for e in range(plan.sum_entry_ptr[b], plan.sum_entry_ptr[b + 1]):
        k, t, c = plan.sum_entry[e, 0], plan.sum_entry[e, 1], plan.sum_entry[e, 2]
        lu[k, plan.sum_entry[e, 3]] += terms[t, c]


@kernel_inline
def sum_first(plan: Plan, b: int, first: int, work: F1) -> None:
    """Right-hand sides of the sums of block b for velocities, scaled like their rows."""
    # prescribed rate times the scale: the right-hand side of J v
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        work[plan.sum_row[j] - first] *= plan.sum_scale[j]


@of_plan
def sum_known(plan: Plan, b: int, first: int, y: F1, terms: F2, work: F1) -> None:
    """Take what the gradients of the sums of block b make of y off work."""
    # take J y of the known coordinates off the right-hand side
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            work[plan.sum_row[j] - first] -= term_along(plan.term_at, t, terms[t], y)


@of_plan
def sum_second(plan: Plan, b: int, first: int, x: F1, v: F1, wanted: F1, work: F1, scratch: F1) -> None:
    """Right-hand sides of the sums of block b for accelerations: what drives ask (drives,) less what v makes; scratch (24,)."""
    # gamma = scale (q'' - J' v)
    for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
        k = plan.sum_row[j]
        total = wanted[plan.drive[k]] if plan.drive[k] >= 0 else 0.0
        for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
            total -= term_second(plan.term_form, plan.term_at, plan.term_data, t, x, v, scratch)
        work[k - first] = plan.sum_scale[j] * total


@kernel_inline
def sum_of(sum_row: I1, k: int) -> int:
    """Place of row k among the sums, or -1."""
    # linear search: models have few sums
    for j in range(sum_row.size):
        if sum_row[j] == k:
            return j
    return -1


@of_plan
def add_sum_force(plan: Plan, j: int, terms: F2, amount: float, rest: F1) -> None:
    """rest -= J^T amount of sum j."""
    # -J^T N of the terms
    for t in range(plan.term_ptr[j], plan.term_ptr[j + 1]):
        add_term(plan.term_at, t, terms[t], -amount, rest)


# Rows of the equations of motion; structure.rows has those between two nodes.
#
# A row reads scale (sum - value) = 0. Gradients of the terms, scale and factor in them, stand in ws.terms; u of such a row is
# 0.


@of_equations(allocates=True)
def sum_gradients(eq: Equations, ws: Workspace, x: F1) -> None:
    """Gradients of all sums at x into ws.terms."""
    terms, ptr, scale = ws.terms, eq.sum_ptr, eq.sum_scale
    form, at, data = eq.term_form, eq.term_at, eq.term_data
    # gradient of each term by its nodes, times the scale of its constraint
    for j in range(scale.size):
        for t in range(ptr[j], ptr[j + 1]):
            term_gradient(form, at, data, t, x, terms[t])
            for c in range(12):
                terms[t, c] *= scale[j]


@of_equations(allocates=True)
def sum_along(eq: Equations, ws: Workspace, y: F1, out: F1) -> None:
    """J y of the sums into their places of out (r,)."""
    terms, ptr, row, at = ws.terms, eq.sum_ptr, eq.sum_row, eq.term_at
    # J y: sum over the terms of their gradients times y
    for j in range(row.size):
        total = 0.0
        for t in range(ptr[j], ptr[j + 1]):
            total += term_along(at, t, terms[t], y)
        out[row[j]] = total


@of_equations(allocates=True)
def add_sum_forces(eq: Equations, ws: Workspace, N: F1, f: F1) -> None:
    """f -= J^T N of the sums."""
    terms, ptr, row, at = ws.terms, eq.sum_ptr, eq.sum_row, eq.term_at
    # -J^T N
    for j in range(row.size):
        for t in range(ptr[j], ptr[j + 1]):
            add_term(at, t, terms[t], -N[row[j]], f)


@of_equations(allocates=True)
def sum_gaps(eq: Equations, x: F1, target: F2, out: F1, largest: float) -> float:
    """Residuals of the sums at x into out (r,); returns the largest share of a length so far (an angle counts as it is)."""
    ptr, row, scale, period = (
        eq.sum_ptr,
        eq.sum_row,
        eq.sum_scale,
        eq.sum_period,
    )
    form, at, data = eq.term_form, eq.term_at, eq.term_data
    size = eq.sum_size
    # Phi = scale (sum of the terms - target), by the shortest way round where the sum is periodic
    for j in range(row.size):
        gap = -target[0, row[j]]
        for t in range(ptr[j], ptr[j + 1]):
            gap += term_value(form, at, data, t, x)
        out[row[j]] = scale[j] * nearest_turn(gap, period[j])
        share = abs(out[row[j]]) / (size[j] * (1.0 + abs(target[0, row[j]])))
        largest = larger(largest, share)
    return largest


@of_equations(allocates=True)
def sum_rate_gaps(eq: Equations, ws: Workspace, v: F1, target: F2, out: F1, largest: float) -> float:
    """J v minus the wanted rates of the sums into out (r,); returns the largest so far (m/s)."""
    sum_along(eq, ws, v, out)
    row, scale = eq.sum_row, eq.sum_scale
    # Phi' = J v - scale (prescribed rate)
    for j in range(row.size):
        out[row[j]] -= scale[j] * target[1, row[j]]
        largest = larger(largest, abs(out[row[j]]))
    return largest


@of_equations(allocates=True)
def sum_gammas(eq: Equations, ws: Workspace, x: F1, v: F1, gamma: F1) -> None:
    """Right-hand sides of J a = gamma of the sums; what their motions ask stands in gamma already, unscaled."""
    ptr, row, scale = eq.sum_ptr, eq.sum_row, eq.sum_scale
    form, at, data, scratch = eq.term_form, eq.term_at, eq.term_data, ws.term_work
    # gamma = scale (q'' - J' v): prescribed acceleration less the convective terms
    for j in range(row.size):
        total = gamma[row[j]]
        for t in range(ptr[j], ptr[j + 1]):
            total -= term_second(form, at, data, t, x, v, scratch)
        gamma[row[j]] = scale[j] * total


@kernel
def sum_vector(eq: Equations, ws: Workspace, j: int, amount: float, out: F1) -> None:
    """out += J_j^T amount over the free coordinates, of sum j."""
    terms, ptr, at, local = ws.terms, eq.sum_ptr, eq.term_at, eq.local
    # J_j^T times the amount
    for t in range(ptr[j], ptr[j + 1]):
        for n in range(4):
            for c in range(3):
                i = local[at[t, n] + c]
                if i >= 0:
                    out[i] += amount * terms[t, 3 * n + c]


@of_equations(allocates=True)
def sum_columns(eq: Equations, ws: Workspace, W: F2) -> None:
    """W += J^T in the columns of the sums, W (nf, r)."""
    row = eq.sum_row
    # one column of J^T for each sum
    for j in range(row.size):
        sum_vector(eq, ws, j, 1.0, W[:, row[j]])


@of_equations(allocates=True)
def augment_sum(eq: Equations, ws: Workspace, k: int, augmentation: float, D: F2) -> None:
    """D += augmentation J_k^T J_k, where row k is a sum."""
    j, row = sum_of(eq.sum_row, k), ws.c
    if j < 0:
        return
    # J_k as a dense vector
    for i in range(row.size):
        row[i] = 0.0
    sum_vector(eq, ws, j, 1.0, row)
    # rank-one term c J_k^T J_k
    for i in range(row.size):
        if row[i] != 0.0:
            for m in range(row.size):
                D[i, m] += augmentation * row[i] * row[m]


@of_equations(allocates=True)
def sums_of_solution(eq: Equations, ws: Workspace, gamma: F1, y: F1, rhs: F1) -> None:
    """rhs = J y - gamma of the sums, y (nf,) by free coordinates."""
    terms, ptr, row, at = ws.terms, eq.sum_ptr, eq.sum_row, eq.term_at
    local = eq.local
    # J y - gamma with the gradients of each term at its four nodes
    for j in range(row.size):
        total = -gamma[row[j]]
        for t in range(ptr[j], ptr[j + 1]):
            for n in range(4):
                for c in range(3):
                    i = local[at[t, n] + c]
                    if i >= 0:
                        total += terms[t, 3 * n + c] * y[i]
        rhs[row[j]] = total


@kernel_bare
def sum_entries(ws: Workspace, entry: I2, value: F1) -> None:
    """Gradients of the sums added to their places (t, 12) in the values of a sparse matrix."""
    terms = ws.terms
    # entries of J at the four nodes of each term
    for t in range(entry.shape[0]):
        for c in range(12):
            value[entry[t, c]] += terms[t, c]


# Given torques on sums: couples that follow the bodies.


@kernel
def _add_torque(eq: Equations, first: int, last: int, amount: float, x: F1, f: F1, scratch: F1) -> None:
    """f += amount times the gradient of terms first:last: a couple that follows the bodies."""
    form, at, data = eq.term_form, eq.term_at, eq.term_data
    # T dq/dx
    for k in range(first, last):
        term_gradient(form, at, data, k, x, scratch)
        add_term(at, k, scratch, amount, f)


@of_equations(allocates=True)
def sum_torques(eq: Equations, t: float, x: F1, f: F1) -> None:
    """Given torques on sums of terms."""
    kind, A, B, ptr = (
        eq.force_kind,
        eq.force_A,
        eq.force_B,
        eq.force_ptr,
    )
    time, value, scratch = eq.force_time, eq.force_value, np.empty(24)
    # torques on sums alone
    for g in range(kind.size):
        if kind[g] == SUM_FORCE:
            _add_torque(eq, A[g], B[g], entry_at(time, value, ptr[g], ptr[g + 1], t), x, f, scratch)
