"""Forces along a given motion: J^T N = f - M a, one backward sweep over the blocks a sample.

N is the axial force of a bar (tension positive) or, of an angle row, minus the torque over the length. Where there are
more rows than coordinates, rows outside the blocks are redundant; the force is then shared so that sum w N^2 is least.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Floats, Vector
from kinetruss.kernels.structure.element_table import element_balances, element_forces
from kinetruss.kernels.structure.laws import law_energy, law_tension, length_rate
from kinetruss.kernels.structure.mass import at, direction, pair_times, varying_energy, varying_forces, varying_times
from kinetruss.kernels.structure.structure import EndForces, NodalLoads, Plan, States, Structure
from kinetruss.kernels.structure.sums import add_sum_force, sum_of, sum_terms
from kinetruss.kernels.sweep.blocks import (
    Workspace,
    factor,
    gradients,
    set_targets,
    solve_transposed,
    workspace,
)
from kinetruss.kernels.sweep.lu import lu_factor, lu_solve

__all__ = ["applied", "energies", "forces", "shares"]

shares = Apart("plan.shares[{}]")
"""Kernels of plans with redundant rows."""


@kernel_inline
def _add_row(plan: Plan, w: Workspace, k: int, amount: float, rest: F1) -> None:
    """rest (3 n,) -= J_k^T amount, of row k but what is a sum in it."""
    a, b = plan.A[k], plan.B[k]
    # -J_k^T N: N g at A, -N g at B
    for c in range(3):
        force = amount * w.gradient[k, c]
        rest[a + c] += force
        rest[b + c] -= force


@kernel_inline
def _sweep_back(plan: Plan, w: Workspace, rest: F1, N: F1) -> float:
    """Solve J^T N = rest over the blocks from last to first; rest keeps what no row carries (prescribed coordinates).

    Returns the largest reciprocal of a pivot.
    """
    largest = 1.0
    # A^T N_b = rest of block b; its J^T N goes off the coordinates of earlier blocks
    for b in range(plan.ptr.size - 2, -1, -1):
        first, last = plan.ptr[b], plan.ptr[b + 1]
        for k in range(first, last):
            w.work[k - first] = rest[plan.col[k]]
        largest = max(largest, solve_transposed(plan, w, b, w.work))
        for k in range(first, last):
            N[k] = w.work[k - first]
            _add_row(plan, w, k, N[k], rest)
        for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
            add_sum_force(plan, j, w.terms, N[plan.sum_row[j]], rest)
    return largest


@kernel_inline
def _force_of(plan: Plan, w: Workspace, k: int, amount: float, rest: F1) -> None:
    """rest -= J_k^T amount, of any row k."""
    _add_row(plan, w, k, amount, rest)
    j = sum_of(plan.sum_row, k)
    if j >= 0:
        add_sum_force(plan, j, w.terms, amount, rest)


@shares(allocates=True)
def _share(plan: Plan, weight: F1, w: Workspace, rest: F1, N: F1) -> None:
    """Give the redundant rows their share: N = N0 + S z with z from least sum weight N^2."""
    first, rows = plan.ptr[-1], N.size
    m = rows - first
    state, load = np.zeros((m, rows)), np.zeros((m, rest.size))
    matrix, z = np.empty((m, m)), np.zeros(m)
    order = np.empty(m, np.int64)
    # state of self-stress of each redundant row: one there, and what balances it in the blocks
    for e in range(m):
        N[first + e] = 0.0
        _force_of(plan, w, first + e, 1.0, load[e])
        _sweep_back(plan, w, load[e], state[e])
        # a unit force of the redundant row changes the others by minus what they carry of it
        state[e, first + e] = 1.0
    # normal equations of min sum w (N_0 + S z)^2
    for e in range(m):
        for k in range(rows):
            z[e] -= state[e, k] * weight[k] * N[k]
        for f in range(m):
            total = 0.0
            for k in range(rows):
                total += state[e, k] * weight[k] * state[f, k]
            matrix[e, f] = total
    lu_factor(matrix, order, 0, m)
    lu_solve(matrix, order, 0, m, z)
    # N_0 + S z, and what it changes at prescribed coordinates
    for e in range(m):
        for k in range(rows):
            change = state[e, k] * z[e]
            if change != 0.0:
                N[k] += change
                _force_of(plan, w, k, change, rest)


@kernel_inline
def _add_element(joint: Floats, rest: F2, i: int, member: int, A: int, B: int, qA: Vector, qB: Vector) -> None:
    """An element needs q_A and q_B at its ends: taken from the nodes, and where it is a member's, put onto its joints."""
    # q_A, q_B taken off f at the nodes; the member's share is its joint force
    for c in range(3):
        rest[i, A + c] -= qA[c]
        rest[i, B + c] -= qB[c]
        if member >= 0:
            joint[i, member, 0, c] += qA[c]
            joint[i, member, 1, c] += qB[c]


@kernel_inline
def _time(loads: NodalLoads, i: int) -> float:
    """Of sample i, s."""
    t: float = loads.t[min(i, loads.t.size - 1)]
    return t


@kernel_inline
def _nodes(s: Structure, loads: NodalLoads, a: F1, i: int, rest: F2) -> None:
    """Inertia and weight of masses at single nodes and forces on nodes into rest[i]; a (3 n,)."""
    g = loads.gravity
    # m (g - a) of lumped masses and of the shares of bodies
    for k in range(s.lump.size):
        for c in range(3):
            own, place = s.lump[k], 3 * k + c
            rest[i, place] = own * (loads.lump_gravity[k, c] - a[place]) + s.share[k] * (g[c] - a[place])
    # nodal loads
    for k in range(loads.node.size):
        for c in range(3):
            rest[i, 3 * loads.node[k] + c] += loads.force[i, k, c]


@kernel_inline
def _elements(s: Structure, loads: NodalLoads, x: F1, v: F1, a: F1, i: int, out: EndForces) -> None:
    """Inertia forces, weights and tensions of all elements: M a less convective terms and weight, and the laws of bars."""
    joint, rest, g = out.joint, out.rest, loads.gravity
    # M (a - g) of constant masses between two nodes
    for k in range(s.pair_A.size):
        A, B = s.pair_A[k], s.pair_B[k]
        (ax, ay, az), (bx, by, bz) = at(a, A), at(a, B)
        qA, qB = pair_times(s.pair, k, (ax - g[0], ay - g[1], az - g[2]), (bx - g[0], by - g[1], bz - g[2]))
        _add_element(joint, rest, i, s.pair_member[k], A, B, qA, qB)
    # M a + convective terms - weight of members of varying inertia
    for j in range(s.varying_A.size):
        A, B = s.varying_A[j], s.varying_B[j]
        L, u = direction(x, A, B)
        mA, mB = varying_times(s.varying, j, L, u, at(a, A), at(a, B))
        fA, fB = varying_forces(s.varying, j, g, L, u, (v[B] - v[A], v[B + 1] - v[A + 1], v[B + 2] - v[A + 2]))
        qA, qB = (mA[0] - fA[0], mA[1] - fA[1], mA[2] - fA[2]), (mB[0] - fB[0], mB[1] - fB[1], mB[2] - fB[2])
        _add_element(joint, rest, i, s.varying_member[j], A, B, qA, qB)
    # tension N u of bars with a law
    for k in range(s.law_A.size):
        A, B = s.law_A[k], s.law_B[k]
        L, (ux, uy, uz), Ld = length_rate(x, v, A, B)
        N = law_tension(s, k, L, Ld)
        _add_element(joint, rest, i, s.law_member[k], A, B, (-N * ux, -N * uy, -N * uz), (N * ux, N * uy, N * uz))
    element_forces(s, _time(loads, i), x, v, rest[i])


@kernel_inline
def _gathered(s: Structure, loads: NodalLoads, states: States, i: int, out: EndForces) -> None:
    """f - M a of sample i into rest[i], and what the elements of each member ask of its ends into joint[i]."""
    now = 0 if states.v.shape[0] == 1 else i
    x, v, a, joint = states.x[i], states.v[now], states.a[now], out.joint
    for m in range(joint.shape[1]):
        for c in range(3):
            joint[i, m, 0, c] = joint[i, m, 1, c] = 0.0
    _nodes(s, loads, a, i, out.rest)
    _elements(s, loads, x, v, a, i, out)


@kernel_inline
def _put(plan: Plan, w: Workspace, row_force: F1, i: int, N: F2, joint: Floats) -> None:
    """What the rows carry into N[i] and onto the joints of their members."""
    # N in the order of the system; N g at both joints of the member
    for k in range(row_force.size):
        N[i, plan.row[k]] = row_force[k]
        for c in range(3):
            force = row_force[k] * w.gradient[k, c]
            joint[i, plan.member[k], 0, c] -= force
            joint[i, plan.member[k], 1, c] += force


@kernel
def applied(structure: Structure, loads: NodalLoads, states: States, out: EndForces) -> None:
    """Fill rest with f - M a and joint with what inertia, weight and elastic bars ask of the ends of members."""
    for i in range(states.x.shape[0]):
        _gathered(structure, loads, states, i, out)


@kernel
def forces(
    plan: Plan,
    weight: F1,
    structure: Structure,
    loads: NodalLoads,
    values: F2,
    states: States,
    N: F2,
    out: EndForces,
    pivot: F1,
) -> None:
    """Fill N (times, rows), joint and rest for positions, velocities, accelerations.

    N by the rows of the system; weight (rows,) of the redundant share, in the plan's order. values (times, drives).
    joint : force on each member at its ends. rest : minus the reaction at prescribed coordinates; round-off elsewhere.
    pivot (times,) : the smallest of the factors, rows of unit length.
    """
    w, x, rest = workspace(plan), states.x, out.rest
    row_force, blocks = np.empty(plan.row.size), plan.ptr.size - 1
    # f - M a, factors of J at this sample, back substitution, redundant share
    for i in range(x.shape[0]):
        _gathered(structure, loads, states, i, out)
        set_targets(plan, w, values, i)
        for b in range(blocks):
            factor(plan, w, b, x, i)
        pivot[i] = 1.0 / _sweep_back(plan, w, rest[i], row_force)
        if plan.ptr[-1] < row_force.size:
            gradients(plan, w, plan.ptr[-1], row_force.size, x, i)
            if plan.sums.size:
                sum_terms(plan, blocks, x[i], w.terms)
            _share(plan, weight, w, rest[i], row_force)
        _put(plan, w, row_force, i, N, out.joint)


@kernel_inline
def _law_energy(s: Structure, k: int, x: F1, v: F1) -> Vector:
    """Strain energy of a bar (J), its rate and what its damper takes (W)."""
    L, _, Ld = length_rate(x, v, s.law_A[k], s.law_B[k])
    kept = law_tension(s, k, L, 0.0)
    return law_energy(s.law_kind[k], s.law[k, 0], s.law[k, 1], L), kept * Ld, (law_tension(s, k, L, Ld) - kept) * Ld


@kernel_inline
def _pair_energy(s: Structure, k: int, g: F1, x: F1, v: F1, a: F1) -> tuple[float, float]:
    """Kinetic and potential energy of a mass pair (J) and its rate (W): v M v/2 - g M x and v M (a - g)."""
    A, B = s.pair_A[k], s.pair_B[k]
    vA, vB, energy, rate = at(v, A), at(v, B), 0.0, 0.0
    (pA, pB), (rA, rB) = pair_times(s.pair, k, vA, vB), pair_times(s.pair, k, at(a, A), at(a, B))
    wA, wB = pair_times(s.pair, k, (g[0], g[1], g[2]), (g[0], g[1], g[2]))
    # v M v/2 - x M g, and its rate
    for c in range(3):
        energy += 0.5 * (vA[c] * pA[c] + vB[c] * pB[c]) - x[A + c] * wA[c] - x[B + c] * wB[c]
        rate += vA[c] * (rA[c] - wA[c]) + vB[c] * (rB[c] - wB[c])
    return energy, rate


@kernel
def energies(s: Structure, loads: NodalLoads, states: States, out: F2) -> None:
    """Energy (J), its rate (W) and what dampers take (W), of all elements and masses, into out (times, 3)."""
    g = loads.gravity
    # elements of each kind: constant masses, varying inertia, laws, masses at nodes
    for i in range(states.x.shape[0]):
        x, v, a = states.x[i], states.v[i], states.a[i]
        energy, rate, lost = 0.0, 0.0, 0.0
        for k in range(s.pair_A.size):
            e, r = _pair_energy(s, k, g, x, v, a)
            energy, rate = energy + e, rate + r
        for j in range(s.varying_A.size):
            e, r = varying_energy(s.varying, j, g, s.varying_A[j], s.varying_B[j], states, i)
            energy, rate = energy + e, rate + r
        for k in range(s.law_A.size):
            e, r, taken = _law_energy(s, k, x, v)
            energy, rate, lost = energy + e, rate + r, lost + taken
        for j in range(s.lump.size):
            for c in range(3):
                xc, vc, ac, mass = x[3 * j + c], v[3 * j + c], a[3 * j + c], s.lump[j] + s.share[j]
                weight = s.lump[j] * loads.lump_gravity[j, c] + s.share[j] * g[c]
                energy += 0.5 * mass * vc * vc - weight * xc
                rate += vc * (mass * ac - weight)
        out[i, 0], out[i, 1], out[i, 2] = energy, rate, lost
        element_balances(s, _time(loads, i), x, v, out[i])
