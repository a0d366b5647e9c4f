"""[[M, J^T], [J, -delta]] = L D L^T on a pattern that is found once; the numbers are refreshed without a search.

The order comes from approximate minimum degree, with each row put behind all coordinates it touches, so that no pivot is zero
where the rows are independent. Values stand in one array: entries below the diagonal column by column, then the diagonal,
then one place that nobody reads. Redundant rows get delta = 1e-6 of their compliance times their weight, and the solution is refined
against the matrix without it, which leaves the forces that make sum w N^2 least.
"""

from __future__ import annotations

import math

from kinetruss.kernels import _equations as e
from kinetruss.kernels._jit import kernel, kernel_inner
from kinetruss.kernels._mass import blocks_of, mass_of
from kinetruss.kernels._parts import grid, integers, matrix, vector
from kinetruss.kernels._rows import add_pulls, along_rows

__all__ = ["NODE", "OWN", "SPARE", "sparse_factor", "sparse_solve", "sparse_targets", "sparse_tree"]

NODE, OWN, SPARE = 2, 0, 1
"""What stands at a place: a coordinate, a row, a redundant row."""
DROP = 1e-11
REFINED = 1e-15
MOST = 8


@kernel
def sparse_tree(n, upper_ptr, upper_row, parent, flag, count, below):  # type: ignore[no-untyped-def]
    """Elimination tree and, in two passes, the pattern of L: with empty `below` the column counts, else the rows.

    upper_ptr, upper_row : rows above the diagonal of each column. Davis (2006), Direct Methods, section 4.1.
    """
    fill = below.size > 0
    for k in range(n):
        flag[k] = k
        if not fill:
            parent[k] = -1
        for at in range(upper_ptr[k], upper_ptr[k + 1]):
            i = upper_row[at]
            while flag[i] != k:
                if not fill and parent[i] == -1:
                    parent[i] = k
                if fill:
                    below[count[i]] = k
                count[i] += 1
                flag[i] = k
                i = parent[i]


@kernel
def sparse_targets(ptr, below, target):  # type: ignore[no-untyped-def]
    """Where each product of two entries of a column goes, in the order in which `sparse_factor` makes them."""
    at = 0
    for j in range(ptr.size - 1):
        for a in range(ptr[j], ptr[j + 1]):
            p = ptr[below[a]]
            for b in range(a + 1, ptr[j + 1]):
                while below[p] != below[b]:
                    p += 1
                if at < target.size:
                    target[at] = p
                at += 1
    return at


@kernel_inner
def _put_block(at, k, value, ux, uy, uz, s_AA, r_AA, s_AB, r_AB, s_BB, r_BB):  # type: ignore[no-untyped-def]
    """Add the blocks s 1 + r u u^T of two nodes to their places at[k] (36,), row by row, lower triangle."""
    for i in range(6):
        for j in range(i + 1):
            if i < 3:
                s, r = s_AA, r_AA
            elif j < 3:
                s, r = s_AB, r_AB
            else:
                s, r = s_BB, r_BB
            c, d = i % 3, j % 3
            uc = ux if c == 0 else (uy if c == 1 else uz)
            ud = ux if d == 0 else (uy if d == 1 else uz)
            value[at[k, 6 * i + j]] += r * uc * ud + (s if c == d else 0.0)


@kernel_inner
def _assemble(eq, x, u, value):  # type: ignore[no-untyped-def]
    """The matrix at x into value: constant masses and delta, gradients, changing masses, rows added to nodes without mass."""
    base, entry, block = vector(eq, e.SPARSE_BASE), grid(eq, e.SPARSE_ENTRY), grid(eq, e.SPARSE_BLOCK)
    var_A, var_B, var = integers(eq, e.VAR_A), integers(eq, e.VAR_B), matrix(eq, e.VAR)
    stiff_row, stiff_block = integers(eq, e.SPARSE_STIFF_ROW), grid(eq, e.SPARSE_STIFF_BLOCK)
    for i in range(base.size):
        value[i] = base[i]
    for k in range(entry.shape[0]):
        for c in range(3):
            value[entry[k, c]] = -u[c, k]
            value[entry[k, 3 + c]] = u[c, k]
    for j in range(var_A.size):
        a, b = var_A[j], var_B[j]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L = math.sqrt(dx * dx + dy * dy + dz * dz)
        s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(var, j, L)
        _put_block(block, j, value, dx / L, dy / L, dz / L, s_AA, r_AA, s_AB, r_AB, s_BB, r_BB)
    stiff = vector(eq, e.SPARSE_STIFF)[0]
    for j in range(stiff_row.size):
        k = stiff_row[j]
        _put_block(stiff_block, j, value, u[0, k], u[1, k], u[2, k], 0.0, stiff, 0.0, -stiff, 0.0, stiff)


@kernel_inner
def sparse_factor(eq, ws, x):  # type: ignore[no-untyped-def]
    """Assemble and factor at x. Returns the smallest scaled pivot of rows that are not spare.

    The pivot of a row is compared with `gain`, what the coordinates give to it.
    """
    value, gain, sort = vector(ws, e.VALUES), vector(ws, e.GAIN), integers(eq, e.SPARSE_SORT)
    ptr, below, target = integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), integers(eq, e.SPARSE_TARGET)
    _assemble(eq, x, matrix(ws, e.U), value)
    kept = vector(ws, e.X)
    for c in range(x.size):
        kept[c] = x[c]
    n, entries, at = sort.size, below.size, 0
    smallest = 1.0
    for j in range(n):
        gain[j] = 0.0
    for j in range(n):
        d = value[entries + j]
        node = sort[j] == NODE
        if node:
            inverse = 1.0 / d if d > 0.0 else 0.0
            smallest = smallest if d > 0.0 else 0.0
        else:
            share = -d / gain[j] if gain[j] > 0.0 else 0.0
            if sort[j] == OWN and not share >= smallest:
                smallest = max(share, 0.0)
            inverse = 1.0 / d if share > DROP else 0.0
        value[entries + j] = inverse
        last = ptr[j + 1]
        for a in range(ptr[j], last):
            y = value[a]
            factor = y * inverse
            value[a] = factor
            i = below[a]
            change = factor * y
            value[entries + i] -= change
            if node:
                gain[i] += change
            for b in range(a + 1, last):
                value[target[at]] -= factor * value[b]
                at += 1
    return math.sqrt(smallest)


@kernel_inner
def _solve(ptr, below, value, b):  # type: ignore[no-untyped-def]
    """L D L^T y = b in place."""
    n, entries = ptr.size - 1, below.size
    for j in range(n):
        y = b[j]
        for a in range(ptr[j], ptr[j + 1]):
            b[below[a]] -= value[a] * y
    for j in range(n - 1, -1, -1):
        y = b[j] * value[entries + j]
        for a in range(ptr[j], ptr[j + 1]):
            y -= value[a] * b[below[a]]
        b[j] = y


@kernel_inner
def _once(eq, ws, f, gamma, b):  # type: ignore[no-untyped-def]
    """Solution for f (3 n,), gamma (r,) with the factors at hand, into b by place."""
    free, local, place, row_place = (
        integers(eq, e.FREE), integers(eq, e.LOCAL), integers(eq, e.SPARSE_PLACE), integers(eq, e.SPARSE_ROW_PLACE),
    )  # fmt: skip
    A, B, u = integers(eq, e.A_), integers(eq, e.B_), matrix(ws, e.U)
    stiff_row, stiff = integers(eq, e.SPARSE_STIFF_ROW), vector(eq, e.SPARSE_STIFF)[0]
    for i in range(free.size):
        b[place[i]] = f[free[i]]
    for k in range(row_place.size):
        b[row_place[k]] = gamma[k]
    for j in range(stiff_row.size):
        k = stiff_row[j]
        for c in range(3):
            push = stiff * u[c, k] * gamma[k]
            p, q = local[A[k] + c], local[B[k] + c]
            if p >= 0:
                b[place[p]] -= push
            if q >= 0:
                b[place[q]] += push
    _solve(integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), vector(ws, e.VALUES), b)


@kernel_inner
def _residual(eq, ws, f, gamma, y, N, rest, left):  # type: ignore[no-untyped-def]
    """f - M y - J^T N into rest, gamma - J y into left; returns how large they are beside f and gamma."""
    A, B, u, free = integers(eq, e.A_), integers(eq, e.B_), matrix(ws, e.U), integers(eq, e.FREE)
    mass_of(eq, vector(ws, e.X), y, rest)
    largest, size, off, known = 0.0, 1e-300, 0.0, 1e-300
    for c in range(rest.size):
        rest[c] = f[c] - rest[c]
    add_pulls(A, B, u, N, rest)
    for i in range(free.size):
        largest, size = max(largest, abs(rest[free[i]])), max(size, abs(f[free[i]]))
    along_rows(A, B, u, y, left)
    for k in range(left.size):
        size = max(size, abs(N[k]))
        left[k] = gamma[k] - left[k]
        off, known = max(off, abs(left[k])), max(known, abs(gamma[k]))
    for i in range(free.size):
        known = max(known, abs(y[free[i]]))
    return max(largest / size, off / known)


@kernel_inner
def sparse_solve(eq, ws, f, gamma, a, N):  # type: ignore[no-untyped-def]
    """Solve M a + J^T N = f, J a = gamma with the factors of `sparse_factor`; only free coordinates of a are written.

    With redundant rows the solution is refined until the residual is at round-off or no longer falls.
    """
    free, place, row_place, sort = (
        integers(eq, e.FREE), integers(eq, e.SPARSE_PLACE), integers(eq, e.SPARSE_ROW_PLACE), integers(eq, e.SPARSE_SORT),
    )  # fmt: skip
    b = vector(ws, e.GAIN)
    _once(eq, ws, f, gamma, b)
    for i in range(free.size):
        a[free[i]] = b[place[i]]
    for k in range(row_place.size):
        N[k] = b[row_place[k]]
    spare = False
    for j in range(sort.size):
        spare = spare or sort[j] == SPARE
    if not spare:
        return
    y, rest, left, before = vector(ws, e.Y), vector(ws, e.REST), vector(ws, e.RHS), 1e300
    for _ in range(MOST):
        for i in range(free.size):
            y[free[i]] = a[free[i]]
        now = _residual(eq, ws, f, gamma, y, N, rest, left)
        if now <= REFINED or not now < 0.5 * before:
            return
        before = now
        _once(eq, ws, rest, left, b)
        for i in range(free.size):
            a[free[i]] += b[place[i]]
        for k in range(row_place.size):
            N[k] += b[row_place[k]]
