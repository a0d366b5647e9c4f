"""[[M, J^T], [J, 0]] for small systems: dense Schur complement with a Cholesky factorisation that drops redundant rows.

S = J M^-1 J^T = R^T R; rows that others determine are dropped (_drop_cholesky), their forces are first zero and then shared
so that sum w N^2 is least over the states of self-stress. Where the mass is constant and
regular, M^-1 is known beforehand and every entry of S is a fixed quadratic form of two gradients; else M is assembled and
factored, with rows added to it, M + c J^T J, where nodes without mass leave it singular (the solution stays the same).
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Vector
from kinetruss.kernels.solve.cholesky import cholesky, cholesky_solve, drop_cholesky, share
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import blocks_of, direction
from kinetruss.kernels.structure.structure import Structure
from kinetruss.kernels.structure.sums import augment_sum, sum_columns, sum_of, sum_vector, sums_of_solution

__all__ = ["ASSEMBLED", "COUPLED", "SEPARATE", "dense_factor", "dense_solve"]

SEPARATE, COUPLED, ASSEMBLED = 0, 1, 2


@kernel_bare
def _block(D: F2, local: I1, a: int, b: int, s: float, r: float, g: Vector) -> None:
    """D += s 1 + r g g^T between the nodes at a and b, where both coordinates are free; g : three numbers."""
    x, y, z = g
    # s on the diagonal of the block, r u u^T on all of it
    for c, u in ((0, x), (1, y), (2, z)):
        i = local[a + c]
        if i < 0:
            continue
        if local[b + c] >= 0:
            D[i, local[b + c]] += s
        if r != 0.0:
            for d, w in ((0, x), (1, y), (2, z)):
                if local[b + d] >= 0:
                    D[i, local[b + d]] += r * u * w


@kernel_bare
def _varying_mass(local: I1, s: Structure, x: F1, D: F2) -> None:
    """D += mass of the members whose mass changes, both triangles."""
    # M_AA, M_AB, M_BB of each member of varying inertia
    for k in range(s.varying_A.size):
        a, b = s.varying_A[k], s.varying_B[k]
        L, u = direction(x, a, b)
        s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(s.varying, k, L)
        _block(D, local, a, a, s_AA, r_AA, u)
        _block(D, local, a, b, s_AB, r_AB, u)
        _block(D, local, b, a, s_AB, r_AB, u)
        _block(D, local, b, b, s_BB, r_BB, u)


@kernel_bare
def _quadratic_forms(mode: int, pair: F2, u: F2, S: F2) -> None:
    """Upper triangle of S from the fixed forms pair (3 or 4 times r, r)."""
    n = S.shape[0]
    # S_ij = u_i^T H_ij u_j, H_ij the constant 3 x 3 form of two constraints
    for i in range(n):
        x, y, z = u[0, i], u[1, i], u[2, i]
        if mode == SEPARATE:
            for j in range(i, n):
                S[i, j] = x * pair[i, j] * u[0, j] + y * pair[n + i, j] * u[1, j] + z * pair[2 * n + i, j] * u[2, j]
        else:
            for j in range(i, n):
                S[i, j] = (x * pair[i, j] + y * pair[2 * n + i, j]) * u[0, j] + (
                    x * pair[n + i, j] + y * pair[3 * n + i, j]
                ) * u[1, j]


@kernel_bare
def _columns(local: I1, A: I1, B: I1, u: F2, W: F2, S: F2) -> None:
    """J^T of the rows between two nodes into W (nf, r); S of zeros (upper triangle)."""
    nf, r = W.shape
    for i in range(nf):
        for k in range(r):
            W[i, k] = 0.0
    # column k of J^T: -u at A, u at B
    for k in range(r):
        for k2 in range(k, r):
            S[k, k2] = 0.0
        for c in range(3):
            i, j = local[A[k] + c], local[B[k] + c]
            if i >= 0:
                W[i, k] -= u[c, k]
            if j >= 0:
                W[j, k] += u[c, k]


@kernel_bare
def _schur(D: F2, W: F2, S: F2) -> None:
    """W = R^-T J^T from J^T in W (nf, r), S += W^T W (upper triangle), with D = R^T R."""
    nf, r = W.shape
    # forward substitution on the columns of J^T, and the outer products of W row by row
    for i in range(nf):
        inverse = D[i, i]
        for k in range(r):
            W[i, k] *= inverse
        for j in range(i + 1, nf):
            factor = D[i, j]
            if factor != 0.0:
                for k in range(r):
                    W[j, k] -= factor * W[i, k]
        for k in range(r):
            factor = W[i, k]
            if factor != 0.0:
                for m in range(k, r):
                    S[k, m] += factor * W[i, m]


@kernel_bare
def _drop(eq: Equations, ws: Workspace) -> float:
    """Factor ws.S. Returns the smallest scaled pivot."""
    return drop_cholesky(ws.S, ws.diagonal, eq.redundant_row, eq.sure != 0, ws.dependent, ws.order)


@kernel_bare
def dense_factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """Factor at x with the gradients in ws. Returns the smallest scaled pivot."""
    if eq.mode == ASSEMBLED:
        _masses(eq, ws, x)
        return _eliminate(eq, ws)
    S = ws.S
    _quadratic_forms(eq.mode, eq.dense_pair, ws.u, S)
    return _drop(eq, ws)


@kernel_bare
def _masses(eq: Equations, ws: Workspace, x: F1) -> None:
    """M(x), with the rows that are added to nodes without mass, into ws.D."""
    u = ws.u
    local, A, B, D = eq.local, eq.A, eq.B, ws.D
    fixed, augmented_row, augmentation = eq.dense_mass, eq.augmented_row, eq.augmentation[0]
    nf, sums = D.shape[0], eq.sum_row.size > 0
    # constant part of M (upper triangle)
    for i in range(nf):
        for j in range(i, nf):
            D[i, j] = fixed[i, j]
    _varying_mass(local, eq, x, D)
    # M + c J^T J for nodes without mass
    for j in range(augmented_row.size):
        k = augmented_row[j]
        a, b, g = A[k], B[k], (u[0, k], u[1, k], u[2, k])
        if sums:
            augment_sum(eq, ws, k, augmentation, D)
        _block(D, local, a, a, 0.0, augmentation, g)
        _block(D, local, a, b, 0.0, -augmentation, g)
        _block(D, local, b, a, 0.0, -augmentation, g)
        _block(D, local, b, b, 0.0, augmentation, g)


@kernel_bare
def _eliminate(eq: Equations, ws: Workspace) -> float:
    """Factor ws.D, form and factor the Schur complement."""
    D, S = ws.D, ws.S
    if not cholesky(D, D.shape[0]):
        return 0.0
    W = ws.W
    _columns(eq.local, eq.A, eq.B, ws.u, W, S)
    if eq.sum_row.size:
        sum_columns(eq, ws, W)
    _schur(D, W, S)
    return _drop(eq, ws)


@kernel_bare
def _inverse_mass(mode: int, inverse: F2, D: F2, b: F1, out: F1) -> None:
    """out = M^-1 b over the free coordinates."""
    nf = b.size
    if mode == ASSEMBLED:
        for i in range(nf):
            out[i] = b[i]
        cholesky_solve(D, nf, out)
        return
    # M^-1 is known:
    for i in range(nf):
        out[i] = 0.0
    # its product with b, column by column
    for i in range(nf):
        value = b[i]
        for j in range(nf):
            out[j] += inverse[i, j] * value


@kernel_bare
def _add_row_force(local: I1, a: int, b: int, ux: float, uy: float, uz: float, amount: float, out: F1) -> None:
    """out += J_k^T amount over the free coordinates, for the row between the nodes at a and b."""
    # J_k^T: -u at A, u at B
    for c, u in ((0, ux), (1, uy), (2, uz)):
        i, j = local[a + c], local[b + c]
        if i >= 0:
            out[i] -= amount * u
        if j >= 0:
            out[j] += amount * u


@kernel_bare
def dense_solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve M a + J^T N = f, J a = gamma with the factors of `dense_factor`; only free coordinates of a are written."""
    mode, inverse = eq.mode, eq.dense_inverse
    free, local, A, B = eq.free, eq.local, eq.A, eq.B
    augmented_row, augmentation = eq.augmented_row, eq.augmentation[0]
    u, D, S = ws.u, ws.D, ws.S
    b, y, rhs, dependent, order = ws.b, ws.c, ws.rhs, ws.dependent, ws.order
    n, sums, sum_row = A.size, eq.sum_row.size > 0, eq.sum_row
    # f of the free coordinates
    for i in range(free.size):
        b[i] = f[free[i]]
    # f + c J^T gamma for the constraints added to M
    for j in range(augmented_row.size):
        k = augmented_row[j]
        _add_row_force(local, A[k], B[k], u[0, k], u[1, k], u[2, k], augmentation * gamma[k], b)
        if sums and sum_of(eq.sum_row, k) >= 0:
            sum_vector(eq, ws, sum_of(eq.sum_row, k), augmentation * gamma[k], b)
    _inverse_mass(mode, inverse, D, b, y)
    # J M^-1 f - gamma
    for k in range(n):
        total = -gamma[k]
        for c in range(3):
            i, j = local[A[k] + c], local[B[k] + c]
            if i >= 0:
                total -= u[c, k] * y[i]
            if j >= 0:
                total += u[c, k] * y[j]
        N[k] = total
    if sums:
        sums_of_solution(eq, ws, gamma, y, N)
    missing = False
    # in the order of the pivots
    for k in range(n):
        rhs[k] = N[order[k]]
        missing = missing or dependent[k] != 0
    cholesky_solve(S, n, rhs)
    if missing:
        share(ws, eq.weight, rhs)
    # N from (J M^-1 J^T) N = J M^-1 f - gamma
    for k in range(n):
        N[order[k]] = rhs[k]
    # f - J^T N of lengths and angles
    for k in range(n):
        _add_row_force(local, A[k], B[k], u[0, k], u[1, k], u[2, k], -N[k], b)
    # and of sums
    for j in range(sum_row.size):
        sum_vector(eq, ws, j, -N[sum_row[j]], b)
    _inverse_mass(mode, inverse, D, b, y)
    # a = M^-1 (f - J^T N)
    for i in range(free.size):
        a[free[i]] = y[i]
