"""Forces along a given motion: J^T N = f - M a, one backward sweep over the blocks a sample.

N is the axial force of a bar (tension positive) or, of an angle row, minus the torque over the length. Where there are
more rows than coordinates, rows outside the blocks are redundant; the force is then shared so that sum w N^2 is least.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.constraints.sums import sum_of, sum_pulls, sum_terms
from kinetruss.kernels.structure.bodies import body_energy, body_forces, body_terms, pair_energy
from kinetruss.kernels.structure.inertia import direction, inertia_forces, member_energy
from kinetruss.kernels.structure.laws import law_energy, pull
from kinetruss.kernels.structure.plan import NONE
from kinetruss.kernels.sweep.blocks import aim, factor, gradients, solve_transposed, workspace
from kinetruss.kernels.sweep.lu import lu_factor, lu_solve

__all__ = ["energies", "forces"]


@kernel_inline
def _add_row(plan, w, k, amount, rest):  # type: ignore[no-untyped-def]
    """rest (3 n,) -= J_k^T amount, of row k but what is a sum in it."""
    a, b = plan.A[k], plan.B[k]
    for c in range(3):
        pull = amount * w.gradient[k, c]
        rest[a + c] += pull
        rest[b + c] -= pull


@kernel_inline
def _sweep_back(plan, w, rest, N):  # type: ignore[no-untyped-def]
    """Solve J^T N = rest over the blocks from last to first; rest keeps what no row carries (prescribed coordinates)."""
    for b in range(plan.ptr.size - 2, -1, -1):
        first, last = plan.ptr[b], plan.ptr[b + 1]
        for k in range(first, last):
            w.work[k - first] = rest[plan.col[k]]
        solve_transposed(plan, w, b, w.work)
        for k in range(first, last):
            N[k] = w.work[k - first]
            _add_row(plan, w, k, N[k], rest)
        for j in range(plan.sum_ptr[b], plan.sum_ptr[b + 1]):
            sum_pulls(plan, j, w.terms, N[plan.sum_row[j]], rest)


@kernel_inline
def _pull_of(plan, w, k, amount, rest):  # type: ignore[no-untyped-def]
    """rest -= J_k^T amount, of any row k."""
    _add_row(plan, w, k, amount, rest)
    j = sum_of(plan.sum_row, k)
    if j >= 0:
        sum_pulls(plan, j, w.terms, amount, rest)


@kernel
def _share(plan, weight, w, rest, N):  # type: ignore[no-untyped-def]
    """Give the redundant rows their share: N = N0 + S z with z from least sum weight N^2."""
    first, rows = plan.ptr[-1], N.size
    m = rows - first
    state, load = np.zeros((m, rows)), np.zeros((m, rest.size))
    matrix, z = np.empty((m, m)), np.zeros(m)
    order = np.empty(m, np.int64)
    for e in range(m):
        N[first + e] = 0.0
        _pull_of(plan, w, first + e, 1.0, load[e])
        _sweep_back(plan, w, load[e], state[e])
        # a unit pull of the redundant row changes the others by minus what they carry of it
        state[e, first + e] = 1.0
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
    for e in range(m):
        for k in range(rows):
            change = state[e, k] * z[e]
            if change != 0.0:
                N[k] += change
                _pull_of(plan, w, k, change, rest)


@kernel_inline
def _member_loads(p, q, two_rods, rods, law, spring, natural, damping, g, x, v, a, i, j, rest, joint, push):  # type: ignore[no-untyped-def]
    """Inertia and weight of all members but bodies, and the pull of elastic ones, taken from rest[i] and written to joint[i].

    v and a are read at row j.
    """
    for m in range(p.size):
        A, B = 3 * p[m], 3 * q[m]
        inertia_forces(two_rods, rods, m, x, v, a, i, j, A, B, g, push)
        if law[m] != NONE:
            L, ux, uy, uz = direction(x, i, A, B)
            Ld = ux * (v[j, B] - v[j, A]) + uy * (v[j, B + 1] - v[j, A + 1]) + uz * (v[j, B + 2] - v[j, A + 2])
            N = pull(law[m], spring[m], natural[m], damping[m], L, Ld)
            push[0], push[1], push[2] = push[0] - N * ux, push[1] - N * uy, push[2] - N * uz
            push[3], push[4], push[5] = push[3] + N * ux, push[4] + N * uy, push[5] + N * uz
        for c in range(3):
            joint[i, m, 0, c] = push[c]
            joint[i, m, 1, c] = push[3 + c]
            rest[i, A + c] -= push[c]
            rest[i, B + c] -= push[3 + c]


@kernel_inline
def _body_loads(bodies, body, length0, p, q, g, a, i, j, rest, joint, push):  # type: ignore[no-untyped-def]
    """Inertia and weight of planar bodies, on top of what was written for their bars, which have no mass of their own."""
    for k in range(bodies.size):
        m = bodies[k]
        A, B = 3 * p[m], 3 * q[m]
        pp, qq, pq, cross = body_terms(body[m, 0], body[m, 1], body[m, 2], body[m, 3], length0[m])
        body_forces(pp, qq, pq, cross, a, j, A, B, g, push)
        for c in range(2):
            joint[i, m, 0, c] += push[c]
            joint[i, m, 1, c] += push[3 + c]
            rest[i, A + c] -= push[c]
            rest[i, B + c] -= push[3 + c]


@kernel_inline
def _pair_loads(pair_p, pair_q, pair_mass, pair_skew, g, a, i, j, rest):  # type: ignore[no-untyped-def]
    """Inertia and weight of bodies carried by nodes, taken from rest[i]; accelerations are read at row j."""
    for k in range(pair_p.size):
        P, Q, m, s = 3 * pair_p[k], 3 * pair_q[k], pair_mass[k], pair_skew[k]
        for c in range(3):
            rest[i, P + c] += m * (g[c] - a[j, Q + c])
        if P != Q:
            for c in range(3):
                rest[i, Q + c] += m * (g[c] - a[j, P + c])
        if s != 0.0:
            rest[i, P] -= s * (g[1] - a[j, Q + 1])
            rest[i, P + 1] += s * (g[0] - a[j, Q])
            rest[i, Q] += s * (g[1] - a[j, P + 1])
            rest[i, Q + 1] -= s * (g[0] - a[j, P])


@kernel_inline
def _given_loads(lump, lump_gravity, load_node, load, a, i, j, rest):  # type: ignore[no-untyped-def]
    """Inertia and weight of lumped masses and forces on nodes into rest[i]; accelerations are read at row j."""
    for k in range(lump.size):
        for c in range(3):
            rest[i, 3 * k + c] = lump[k] * (lump_gravity[k, c] - a[j, 3 * k + c])
    for k in range(load_node.size):
        for c in range(3):
            rest[i, 3 * load_node[k] + c] += load[i, k, c]


@kernel_inline
def _put(plan, w, member, carried, i, N, joint):  # type: ignore[no-untyped-def]
    """What the rows carry into N[i] and onto the joints of their members."""
    for k in range(carried.size):
        N[i, plan.row[k]] = carried[k]
        for c in range(3):
            pull = carried[k] * w.gradient[k, c]
            joint[i, member[k], 0, c] -= pull
            joint[i, member[k], 1, c] += pull


@kernel
def forces(plan, weight, member, p, q, two_rods, rods, law, spring, natural, damping, bodies, body,  # type: ignore[no-untyped-def]
           length0, pair_p, pair_q, pair_mass, pair_skew, lump, lump_gravity, g, load_node, load, values, x, v, a, N, joint,
           rest):  # fmt: skip
    """Fill N (times, rows), joint (times, members, 2, 3) and rest (times, 3 n) for positions, velocities, accelerations.

    N by the rows of the system; weight (rows,) and member (rows,), the member of each, in the plan's order.
    joint : force on each member at its ends. rest : minus the reaction at prescribed coordinates; round-off elsewhere.
    law, spring, natural, damping : as in `_laws`. bodies : members with data in body (m, 4), of length length0.
    pair_p, pair_q, pair_mass, pair_skew : masses of bodies between nodes, see `System`.
    load (times, loads, 3) on load_node.
    v, a : (times, 3 n); for statics one row of zeros, (1, 3 n).
    """
    w = workspace(plan)
    push, carried, blocks = np.empty(6), np.empty(plan.row.size), plan.ptr.size - 1
    for i in range(x.shape[0]):
        now = 0 if v.shape[0] == 1 else i
        _given_loads(lump, lump_gravity, load_node, load, a, i, now, rest)
        _member_loads(p, q, two_rods, rods, law, spring, natural, damping, g, x, v, a, i, now, rest, joint, push)
        _body_loads(bodies, body, length0, p, q, g, a, i, now, rest, joint, push)
        _pair_loads(pair_p, pair_q, pair_mass, pair_skew, g, a, i, now, rest)
        aim(plan, w, values, i)
        for b in range(blocks):
            factor(plan, w, b, x, i)
        _sweep_back(plan, w, rest[i], carried)
        if plan.ptr[-1] < carried.size:
            gradients(plan, w, plan.ptr[-1], carried.size, x, i)
            sum_terms(plan, blocks, x[i], w.terms)
            _share(plan, weight, w, rest[i], carried)
        _put(plan, w, member, carried, i, N, joint)


@kernel
def energies(p, q, two_rods, rods, law, spring, natural, damping, bodies, body, length0, pair_p, pair_q, pair_mass,  # type: ignore[no-untyped-def]
             pair_skew, lump, lump_gravity, g, x, v, a, out):  # fmt: skip
    """Energy (J), its rate (W) and what dampers take (W), of members, bodies and lumped masses, into out (times, 3)."""
    for i in range(x.shape[0]):
        energy, rate, lost = 0.0, 0.0, 0.0
        for m in range(p.size):
            A, B = 3 * p[m], 3 * q[m]
            e, r = member_energy(two_rods, rods, m, x, v, a, i, A, B, g)
            energy += e
            rate += r
            if law[m] != NONE:
                L, ux, uy, uz = direction(x, i, A, B)
                Ld = ux * (v[i, B] - v[i, A]) + uy * (v[i, B + 1] - v[i, A + 1]) + uz * (v[i, B + 2] - v[i, A + 2])
                N0 = pull(law[m], spring[m], natural[m], 0.0, L, 0.0)
                energy += law_energy(law[m], spring[m], natural[m], L)
                rate += N0 * Ld
                lost += (pull(law[m], spring[m], natural[m], damping[m], L, Ld) - N0) * Ld
        for k in range(bodies.size):
            m = bodies[k]
            pp, qq, pq, cross = body_terms(body[m, 0], body[m, 1], body[m, 2], body[m, 3], length0[m])
            e, r = body_energy(pp, qq, pq, cross, x, v, a, i, 3 * p[m], 3 * q[m], g)
            energy += e
            rate += r
        for k in range(pair_p.size):
            e, r = pair_energy(3 * pair_p[k], 3 * pair_q[k], pair_mass[k], pair_skew[k], g, x, v, a, i)
            energy += e
            rate += r
        for j in range(lump.size):
            for c in range(3):
                xc, vc, ac = x[i, 3 * j + c], v[i, 3 * j + c], a[i, 3 * j + c]
                energy += lump[j] * (0.5 * vc * vc - lump_gravity[j, c] * xc)
                rate += lump[j] * vc * (ac - lump_gravity[j, c])
        out[i, 0], out[i, 1], out[i, 2] = energy, rate, lost
