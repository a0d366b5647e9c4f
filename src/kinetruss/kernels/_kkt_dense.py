"""[[M, J^T], [J, 0]] for small systems: dense Schur complement with a Cholesky factorisation that drops redundant rows.

S = J M^-1 J^T = R^T R; a pivot below 1e-11 of its diagonal marks a row that the rows before it determine: it is dropped, its
force is first zero and then shared so that sum w N^2 is least over the states of self-stress. Where the mass is constant and
regular, M^-1 is known beforehand and every entry of S is a fixed quadratic form of two gradients; else M is assembled and
factored, with rows added to it, M + c J^T J, where nodes without mass leave it singular (the solution stays the same).
"""

from __future__ import annotations

import math

from kinetruss.kernels._jit import kernel, kernel_inner
from kinetruss.kernels._lu import lu_factor, lu_solve
from kinetruss.kernels._mass import blocks_of

__all__ = [
    "ASSEMBLED", "COUPLED", "SEPARATE", "assemble_mass", "cholesky", "dense_factor", "dense_solve", "drop_cholesky",
]  # fmt: skip

SEPARATE, COUPLED, ASSEMBLED, STIFFENED = 0, 1, 2, 3
DROP = 1e-11


@kernel_inner
def drop_cholesky(S, n, diagonal, spare, dropped):  # type: ignore[no-untyped-def]
    """S = R^T R in the upper triangle of S[:n, :n], reciprocals of R's diagonal in `diagonal`; dropped rows are marked.

    Returns the square root of the smallest ratio of a pivot to its diagonal, over rows that are not spare.
    """
    smallest = 1.0
    for k in range(n):
        diagonal[k] = S[k, k]
    for k in range(n):
        share = S[k, k] / diagonal[k] if diagonal[k] > 0.0 else 0.0
        if not spare[k] and not share >= smallest:
            smallest = max(share, 0.0)
        dropped[k] = not share > DROP
        if dropped[k]:
            diagonal[k] = 0.0
            continue
        inverse = 1.0 / math.sqrt(S[k, k])
        diagonal[k] = inverse
        for j in range(k + 1, n):
            S[k, j] *= inverse
        for i in range(k + 1, n):
            factor = S[k, i]
            if factor != 0.0:
                for j in range(i, n):
                    S[i, j] -= factor * S[k, j]
    return math.sqrt(smallest)


@kernel_inner
def _forward(S, n, diagonal, b):  # type: ignore[no-untyped-def]
    """R^T y = b in place; zero at dropped rows."""
    for k in range(n):
        value = b[k] * diagonal[k]
        b[k] = value
        if value != 0.0:
            for j in range(k + 1, n):
                b[j] -= S[k, j] * value


@kernel_inner
def _backward(S, n, diagonal, b):  # type: ignore[no-untyped-def]
    """R y = b in place; zero at dropped rows."""
    for k in range(n - 1, -1, -1):
        value = b[k]
        if diagonal[k] != 0.0:
            for j in range(k + 1, n):
                value -= S[k, j] * b[j]
        b[k] = value * diagonal[k]


@kernel_inner
def cholesky(D, n):  # type: ignore[no-untyped-def]
    """D = R^T R in the upper triangle of D[:n, :n], reciprocals of R's diagonal on its diagonal. False if not positive."""
    good = True
    for k in range(n):
        if not D[k, k] > 0.0:
            good = False
            D[k, k] = 1e-300
        inverse = 1.0 / math.sqrt(D[k, k])
        D[k, k] = inverse
        for j in range(k + 1, n):
            D[k, j] *= inverse
        for i in range(k + 1, n):
            factor = D[k, i]
            if factor != 0.0:
                for j in range(i, n):
                    D[i, j] -= factor * D[k, j]
    return good


@kernel_inner
def _block(D, local, a, b, s, r, ux, uy, uz):  # type: ignore[no-untyped-def]
    """D += s 1 + r u u^T between the nodes at a and b, where both coordinates are free, upper triangle or both."""
    for c, u in ((0, ux), (1, uy), (2, uz)):
        i = local[a + c]
        if i < 0:
            continue
        if local[b + c] >= 0:
            D[i, local[b + c]] += s
        if r != 0.0:
            for d, w in ((0, ux), (1, uy), (2, uz)):
                if local[b + d] >= 0:
                    D[i, local[b + d]] += r * u * w


@kernel
def assemble_mass(local, mass_A, mass_B, mass, lump, var_A, var_B, var, x, nf, D):  # type: ignore[no-untyped-def]
    """M(x) of the free coordinates into D[:nf, :nf], both triangles."""
    for i in range(nf):
        for j in range(nf):
            D[i, j] = 0.0
    for a in range(0, local.size, 3):
        _block(D, local, a, a, lump[a // 3], 0.0, 0.0, 0.0, 0.0)
    for k in range(mass_A.size):
        a, b, skew = mass_A[k], mass_B[k], mass[k, 3]
        _block(D, local, a, a, mass[k, 0], 0.0, 0.0, 0.0, 0.0)
        _block(D, local, a, b, mass[k, 1], 0.0, 0.0, 0.0, 0.0)
        _block(D, local, b, a, mass[k, 1], 0.0, 0.0, 0.0, 0.0)
        _block(D, local, b, b, mass[k, 2], 0.0, 0.0, 0.0, 0.0)
        if skew != 0.0:
            for i, j, value in ((local[a], local[b + 1], -skew), (local[a + 1], local[b], skew)):
                if i >= 0 and j >= 0:
                    D[i, j] += value
                    D[j, i] += value
    for k in range(var_A.size):
        a, b = var_A[k], var_B[k]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L = math.sqrt(dx * dx + dy * dy + dz * dz)
        ux, uy, uz = dx / L, dy / L, dz / L
        s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(var, k, L)
        _block(D, local, a, a, s_AA, r_AA, ux, uy, uz)
        _block(D, local, a, b, s_AB, r_AB, ux, uy, uz)
        _block(D, local, b, a, s_AB, r_AB, ux, uy, uz)
        _block(D, local, b, b, s_BB, r_BB, ux, uy, uz)


@kernel_inner
def _quadratic_forms(mode, pair, u, n, S):  # type: ignore[no-untyped-def]
    """Upper triangle of S from the fixed forms pair (3 or 4, r, r)."""
    if mode == SEPARATE:
        for i in range(n):
            x, y, z = u[0, i], u[1, i], u[2, i]
            for j in range(i, n):
                S[i, j] = x * pair[0, i, j] * u[0, j] + y * pair[1, i, j] * u[1, j] + z * pair[2, i, j] * u[2, j]
        return
    for i in range(n):
        x, y = u[0, i], u[1, i]
        for j in range(i, n):
            S[i, j] = (x * pair[0, i, j] + y * pair[2, i, j]) * u[0, j] + (x * pair[1, i, j] + y * pair[3, i, j]) * u[1, j]


@kernel_inner
def _rows_over(local, A, B, u, nf, W):  # type: ignore[no-untyped-def]
    """J over the free coordinates into W (r, nf)."""
    for k in range(A.size):
        for j in range(nf):
            W[k, j] = 0.0
        for c in range(3):
            i, j = local[A[k] + c], local[B[k] + c]
            if i >= 0:
                W[k, i] -= u[c, k]
            if j >= 0:
                W[k, j] += u[c, k]


@kernel_inner
def _schur(D, W, n, nf, S):  # type: ignore[no-untyped-def]
    """W = J R^-1 row by row, S = W W^T (upper triangle), with D = R^T R."""
    for k in range(n):
        for i in range(nf):
            value = W[k, i]
            if value != 0.0:
                value *= D[i, i]
                W[k, i] = value
                for j in range(i + 1, nf):
                    W[k, j] -= D[i, j] * value
        for m in range(k + 1):
            total = 0.0
            for j in range(nf):
                total += W[m, j] * W[k, j]
            S[m, k] = total


@kernel_inner
def dense_factor(mode, stiff, local, A, B, mass_A, mass_B, mass, lump, var_A, var_B, var, pair, spare, x, u,  # type: ignore[no-untyped-def]
                 nf, D, W, S, diagonal, dropped):  # fmt: skip
    """Factor at x with gradients u (3, r); stiff is c of M + c J^T J. Returns the smallest scaled pivot."""
    n = A.size
    if mode <= COUPLED:
        _quadratic_forms(mode, pair, u, n, S)
        return drop_cholesky(S, n, diagonal, spare, dropped)
    assemble_mass(local, mass_A, mass_B, mass, lump, var_A, var_B, var, x, nf, D)
    _rows_over(local, A, B, u, nf, W)
    if stiff > 0.0:
        for k in range(n):
            for i in range(nf):
                value = stiff * W[k, i]
                if value != 0.0:
                    for j in range(nf):
                        D[i, j] += value * W[k, j]
    if not cholesky(D, nf):
        return 0.0
    _schur(D, W, n, nf, S)
    return drop_cholesky(S, n, diagonal, spare, dropped)


@kernel_inner
def _inverse_mass(mode, inverse, D, nf, b, out):  # type: ignore[no-untyped-def]
    """out = M^-1 b over the free coordinates; b is overwritten."""
    if mode <= COUPLED:
        for i in range(nf):
            out[i] = 0.0
        for i in range(nf):
            value = b[i]
            for j in range(nf):
                out[j] += inverse[i, j] * value
        return
    for i in range(nf):
        value = b[i] * D[i, i]
        b[i] = value
        for j in range(i + 1, nf):
            b[j] -= D[i, j] * value
    for i in range(nf - 1, -1, -1):
        value = b[i]
        for j in range(i + 1, nf):
            value -= D[i, j] * out[j]
        out[i] = value * D[i, i]


@kernel_inner
def _share(S, n, diagonal, dropped, weight, N, states, matrix, order, z):  # type: ignore[no-untyped-def]
    """Share N over the states of self-stress: one for each dropped row, one there and -R^-1 R_k at the kept rows."""
    count = 0
    for e in range(n):
        if dropped[e]:
            for k in range(n):
                states[count, k] = -S[k, e] if k < e and not dropped[k] else 0.0
            _backward(S, e, diagonal, states[count])
            states[count, e] = 1.0
            count += 1
    for e in range(count):
        z[e] = 0.0
        for k in range(n):
            z[e] -= states[e, k] * weight[k] * N[k]
        for f in range(count):
            matrix[e, f] = 0.0
            for k in range(n):
                matrix[e, f] += states[e, k] * weight[k] * states[f, k]
    lu_factor(matrix, order, 0, count)
    lu_solve(matrix, order, 0, count, z)
    for e in range(count):
        for k in range(n):
            N[k] += states[e, k] * z[e]


@kernel_inner
def dense_solve(mode, stiff, free, local, A, B, weight, inverse, u, nf, f, gamma, D, S, diagonal, dropped, y, b, rhs, N, a,  # type: ignore[no-untyped-def]
                states, matrix, order, z):  # fmt: skip
    """Solve M a + J^T N = f, J a = gamma with the factors of `dense_factor`; only free coordinates of f and a are touched."""
    n = A.size
    _to_free(free, local, A, B, u, stiff, gamma, f, b)
    _inverse_mass(mode, inverse, D, nf, b, y)
    for k in range(n):
        total = -gamma[k]
        for c in range(3):
            i, j = local[A[k] + c], local[B[k] + c]
            if i >= 0:
                total -= u[c, k] * y[i]
            if j >= 0:
                total += u[c, k] * y[j]
        rhs[k] = total
    _forward(S, n, diagonal, rhs)
    _backward(S, n, diagonal, rhs)
    missing = False
    for k in range(n):
        N[k] = rhs[k]
        missing = missing or dropped[k]
    if missing:
        _share(S, n, diagonal, dropped, weight, N, states, matrix, order, z)
    for k in range(n):
        rhs[k] = stiff * gamma[k] - N[k]
    _to_free(free, local, A, B, u, 1.0, rhs, f, b)
    _inverse_mass(mode, inverse, D, nf, b, y)
    for i in range(nf):
        a[free[i]] = y[i]


@kernel_inner
def _to_free(free, local, A, B, u, factor, N, f, b):  # type: ignore[no-untyped-def]
    """f + factor J^T N over the free coordinates into b (nf,)."""
    for i in range(free.size):
        b[i] = f[free[i]]
    if factor == 0.0:
        return
    for k in range(A.size):
        value = factor * N[k]
        for c in range(3):
            i, j = local[A[k] + c], local[B[k] + c]
            if i >= 0:
                b[i] -= value * u[c, k]
            if j >= 0:
                b[j] += value * u[c, k]
