"""Forces along a given motion: J^T N = f - M a, one backward sweep over the blocks a sample.

N is the axial force of a bar (tension positive) or, of an angle row, minus the torque over the length. Where there are
more rows than coordinates, rows outside the blocks are redundant; the force is then shared so that sum w N^2 is least.
"""

from __future__ import annotations

import numba
import numpy as np

from kinetruss.kernels._blocks import block_jacobian, row_gradient, row_value
from kinetruss.kernels._inertia import direction_rates, energy_of, inertia_forces
from kinetruss.kernels._lu import lu_factor, lu_solve, lu_solve_transposed

__all__ = ["energies", "forces"]


@numba.njit(cache=True, inline="always")
def _add_row(plan, r, gradient, amount, rest):  # type: ignore[no-untyped-def]
    """rest -= J_r^T amount."""
    p, q = 3 * plan.p[r], 3 * plan.q[r]
    for c in range(3):
        rest[p + c] += amount * gradient[r, c]
        rest[q + c] -= amount * gradient[r, c]


@numba.njit(cache=True)
def _sweep_back(plan, lu, pivot, gradient, rest, N, work):  # type: ignore[no-untyped-def]
    """Solve J^T N = rest over the blocks from last to first; `rest` keeps what no row carries (at prescribed coordinates)."""
    for b in range(plan.ptr.size - 2, -1, -1):
        first = plan.ptr[b]
        n = plan.ptr[b + 1] - first
        for k in range(n):
            work[k] = rest[plan.col[first + k]]
        lu_solve_transposed(lu, pivot[first:], plan.lu_ptr[b], n, work)
        for k in range(n):
            r = plan.row[first + k]
            N[r] = work[k]
            _add_row(plan, r, gradient, work[k], rest)


@numba.njit(cache=True)
def _share(plan, extra, weight, lu, pivot, gradient, rest, N, work):  # type: ignore[no-untyped-def]
    """Give the redundant rows `extra` their share: N = N0 + S z with z from least sum weight N^2."""
    m = extra.size
    state = np.zeros((m, N.size))
    load = np.zeros(rest.size)
    for e in range(m):
        load[:] = 0.0
        _add_row(plan, extra[e], gradient, 1.0, load)
        _sweep_back(plan, lu, pivot, gradient, load, state[e], work)
        state[e, extra[e]] = 1.0
    matrix = np.empty(m * m)
    z = np.zeros(m)
    for e in range(m):
        for r in range(N.size):
            z[e] -= state[e, r] * weight[r] * N[r]
        for f in range(m):
            total = 0.0
            for r in range(N.size):
                total += state[e, r] * weight[r] * state[f, r]
            matrix[e * m + f] = total
    order = np.empty(m, np.int64)
    lu_factor(matrix, order, 0, m)
    lu_solve(matrix, order, 0, m, z)
    for e in range(m):
        for r in range(N.size):
            change = state[e, r] * z[e]
            if change != 0.0:
                N[r] += change
                _add_row(plan, r, gradient, change, rest)


@numba.njit(cache=True)
def _member_loads(p, q, two_rods, rods, spring, natural, g, x, v, a, k, rest, joint):  # type: ignore[no-untyped-def]
    """Inertia and weight of all members, and the pull of elastic ones, taken from `rest` and written to `joint`."""
    for m in range(p.size):
        A, B = 3 * p[m], 3 * q[m]
        direction_rates(x[A:A + 3], x[B:B + 3], v[A:A + 3], v[B:B + 3], a[A:A + 3], a[B:B + 3], k)
        ax, ay, az, bx, by, bz = inertia_forces(two_rods[m], rods[m], k, a[A:A + 3], a[B:B + 3], g)
        if spring[m] > 0.0:
            N = spring[m] * (k[0] - natural[m])
            ax, ay, az = ax - N * k[3], ay - N * k[4], az - N * k[5]
            bx, by, bz = bx + N * k[3], by + N * k[4], bz + N * k[5]
        joint[m, 0, 0], joint[m, 0, 1], joint[m, 0, 2] = ax, ay, az
        joint[m, 1, 0], joint[m, 1, 1], joint[m, 1, 2] = bx, by, bz
        rest[A] -= ax
        rest[A + 1] -= ay
        rest[A + 2] -= az
        rest[B] -= bx
        rest[B + 1] -= by
        rest[B + 2] -= bz


@numba.njit(cache=True, nogil=True)
def forces(plan, extra, weight, row_member, p, q, two_rods, rods, spring, natural, lump, lump_gravity, g,
           load_node, load, still, values, x, v, a, N, joint, rest):  # type: ignore[no-untyped-def]  # fmt: skip
    """Fill N (times, rows), joint (times, members, 2, 3) and rest (times, 3 n) for positions, velocities, accelerations.

    joint : force on each member at its ends. rest : minus the reaction at prescribed coordinates; round-off elsewhere.
    spring, natural : E A/l0 (N/m; 0: not elastic) and l0 (m). load (times, loads, 3) on load_node. still : statics.
    """
    n_rows = plan.row.size
    lu = np.empty(plan.lu_ptr[-1])
    pivot = np.empty(n_rows + 1, np.int64)
    gradient = np.empty((plan.p.size, 3))
    work = np.empty(n_rows + 1)
    k = np.empty(12)
    zero = np.zeros(x.shape[1])
    for i in range(x.shape[0]):
        vi = zero if still else v[i]
        ai = zero if still else a[i]
        ri = rest[i]
        for j in range(lump.size):
            for c in range(3):
                ri[3 * j + c] = lump[j] * (lump_gravity[j, c] - ai[3 * j + c])
        for j in range(load_node.size):
            for c in range(3):
                ri[3 * load_node[j] + c] += load[i, j, c]
        _member_loads(p, q, two_rods, rods, spring, natural, g, x[i], vi, ai, k, ri, joint[i])
        for b in range(plan.ptr.size - 1):
            block_jacobian(plan, b, x[i], values[i], lu, gradient)
            lu_factor(lu, pivot[plan.ptr[b]:], plan.lu_ptr[b], plan.ptr[b + 1] - plan.ptr[b])
        _sweep_back(plan, lu, pivot, gradient, ri, N[i], work)
        if extra.size > 0:
            for e in range(extra.size):
                r = extra[e]
                _, gx, gy, gz = row_gradient(plan, r, x[i], row_value(plan, r, values[i]))
                gradient[r, 0], gradient[r, 1], gradient[r, 2] = gx, gy, gz
            _share(plan, extra, weight, lu, pivot, gradient, ri, N[i], work)
        for r in range(plan.p.size):
            m = row_member[r]
            for c in range(3):
                pull = N[i, r] * gradient[r, c]
                joint[i, m, 0, c] -= pull
                joint[i, m, 1, c] += pull


@numba.njit(cache=True, nogil=True)
def energies(p, q, two_rods, rods, spring, natural, lump, lump_gravity, g, x, v, a, out):  # type: ignore[no-untyped-def]
    """Energy (J) and its rate (W) of members, springs and lumped masses into out (times, 2)."""
    k = np.empty(12)
    for i in range(x.shape[0]):
        energy, rate = 0.0, 0.0
        for m in range(p.size):
            A, B = 3 * p[m], 3 * q[m]
            xA, xB, vA, vB = x[i, A:A + 3], x[i, B:B + 3], v[i, A:A + 3], v[i, B:B + 3]
            aA, aB = a[i, A:A + 3], a[i, B:B + 3]
            direction_rates(xA, xB, vA, vB, aA, aB, k)
            e, r = energy_of(two_rods[m], rods[m], k, xA, xB, vA, vB, aA, aB, g)
            stretch = k[0] - natural[m]
            energy += e + 0.5 * spring[m] * stretch * stretch
            rate += r + spring[m] * stretch * k[1]
        for j in range(lump.size):
            for c in range(3):
                xc, vc, ac = x[i, 3 * j + c], v[i, 3 * j + c], a[i, 3 * j + c]
                energy += lump[j] * (0.5 * vc * vc - lump_gravity[j, c] * xc)
                rate += lump[j] * vc * (ac - lump_gravity[j, c])
        out[i, 0], out[i, 1] = energy, rate
