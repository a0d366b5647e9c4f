"""[[M, J^T], [J, 0]] = L D L^T on a pattern that is found once; the numbers are refreshed without a search.

The order comes from approximate minimum degree, with each row put behind all coordinates it touches, so that no pivot is zero
where the rows are independent. Values stand in one array: entries below the diagonal column by column, then the diagonal,
then one place that nobody reads. A row whose pivot is below 1e-11 of what the coordinates give to it depends on rows before it
and is dropped. Where rows are redundant, the forces N_0 that are found without them are shared: N = W^-1 J y with
J^T W^-1 J y = J^T N_0, the forces of the same push that make sum w N^2 least, on the same pattern.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_inner
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.parts import grid, integers, matrix, stretch, vector
from kinetruss.kernels.constraints.rows import add_pulls, along_rows
from kinetruss.kernels.constraints.sum_rows import sum_along, sum_entries, sum_pulls_off
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.mass import blocks_of

__all__ = ["NODE", "OWN", "SPARE", "sparse_factor", "sparse_solve", "sparse_step", "sparse_targets", "sparse_tree"]

NODE, OWN, SPARE = 2, 0, 1
"""What stands at a place: a coordinate, a row, a redundant row."""
DROP = 1e-11
EASE = 1e-12
"""Stiffness of motions that no bar resists, as a share of that of the stiffest bar."""
REFINED = 1e-13
MOST = 6


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
def _assemble(eq, ws, x, u, value):  # type: ignore[no-untyped-def]
    """The matrix at x into value: constant masses, gradients, changing masses."""
    base, entry, block = vector(eq, e.SPARSE_BASE), grid(eq, e.SPARSE_ENTRY), grid(eq, e.SPARSE_BLOCK)
    var_A, var_B, var = integers(eq, e.VAR_A), integers(eq, e.VAR_B), matrix(eq, e.VAR)
    for i in range(base.size):
        value[i] = base[i]
    for k in range(entry.shape[0]):
        for c in range(3):
            value[entry[k, c]] = -u[c, k]
            value[entry[k, 3 + c]] = u[c, k]
    if integers(eq, e.SUM_ROW).size:
        sum_entries(ws, grid(eq, e.SPARSE_SUM_ENTRY), value)
    for j in range(var_A.size):
        a, b = var_A[j], var_B[j]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L = math.sqrt(dx * dx + dy * dy + dz * dz)
        s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(var, j, L)
        _put_block(block, j, value, dx / L, dy / L, dz / L, s_AA, r_AA, s_AB, r_AB, s_BB, r_BB)


@kernel_inner
def _stiffen(eq, u, value):  # type: ignore[no-untyped-def]
    """Rows added to nodes without mass."""
    stiff_row, stiff_block = integers(eq, e.SPARSE_STIFF_ROW), grid(eq, e.SPARSE_STIFF_BLOCK)
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
    _assemble(eq, ws, x, matrix(ws, e.U), value)
    _stiffen(eq, matrix(ws, e.U), value)
    kept = vector(ws, e.X)
    for c in range(x.size):
        kept[c] = x[c]
    setup = integers(eq, e.SETUP)
    if setup[3] and not setup[2]:
        _factor_share(eq, ws, vector(ws, e.VALUES_SHARE), gain)
    return _eliminate(sort, ptr, below, target, value, gain)


@kernel_inner
def sparse_step(eq, ws, x, alpha, law_s, law_r, bar_s):  # type: ignore[no-untyped-def]
    """Factor alpha M + blocks s 1 + r u u^T of laws and s 1 of bars. Returns the smallest scaled pivot, 0 if not positive."""
    value, gain, sort = vector(ws, e.VALUES), vector(ws, e.GAIN), integers(eq, e.SPARSE_SORT)
    ptr, below, target = integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), integers(eq, e.SPARSE_TARGET)
    law_A, law_B, law_block = integers(eq, e.LAW_A), integers(eq, e.LAW_B), grid(eq, e.SPARSE_LAW_BLOCK)
    bar_block, u = grid(eq, e.SPARSE_BAR_BLOCK), matrix(ws, e.U)
    _assemble(eq, ws, x, u, value)
    for j in range(sort.size):
        value[below.size + j] *= alpha
        for a in range(ptr[j], ptr[j + 1]):
            if sort[j] == NODE and sort[below[a]] == NODE:
                value[a] *= alpha
    _stiffen(eq, u, value)
    for k in range(law_A.size):
        a, b = law_A[k], law_B[k]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L, s, r = math.sqrt(dx * dx + dy * dy + dz * dz), law_s[k], law_r[k]
        _put_block(law_block, k, value, dx / L, dy / L, dz / L, s, r, -s, -r, s, r)
    for k in range(bar_s.size):
        _put_block(bar_block, k, value, 0.0, 0.0, 0.0, bar_s[k], 0.0, -bar_s[k], 0.0, bar_s[k], 0.0)
    return _eliminate(sort, ptr, below, target, value, gain)


@kernel_inner
def _pivot(j, sort, d, gain, smallest):  # type: ignore[no-untyped-def]
    """Reciprocal of the pivot at place j, 0 where it is dropped, and the smallest scaled pivot so far."""
    if sort[j] == NODE:
        return (1.0 / d, smallest) if 0.0 < d < math.inf else (0.0, 0.0)
    share = -d / gain[j] if gain[j] > 0.0 else 0.0
    if sort[j] == OWN and not share >= smallest:
        smallest = share if share > 0.0 else 0.0
    return (1.0 / d if DROP < share < math.inf else 0.0), smallest


@kernel_inner
def _eliminate(sort, ptr, below, target, value, gain):  # type: ignore[no-untyped-def]
    """L D L^T of the values in place, right-looking; the reciprocals of D are left in its place.

    Without targets, the columns reach without a gap as far as they reach (a skyline), and products go side by side.
    """
    n, entries, at = sort.size, below.size, 0
    smallest, skyline = 1.0, target.size == 0
    for j in range(n):
        gain[j] = 0.0
    for j in range(n):
        inverse, smallest = _pivot(j, sort, value[entries + j], gain, smallest)
        value[entries + j] = inverse
        first, last = ptr[j], ptr[j + 1]
        for a in range(first, last):
            y = value[a]
            factor = y * inverse
            value[a] = factor
            i = below[a]
            change = factor * y
            value[entries + i] -= change
            if sort[j] == NODE:
                gain[i] += change
            if skyline:
                if factor != 0.0:
                    more = last - a - 1
                    to, rest = stretch(value, ptr[i], more), stretch(value, a + 1, more)
                    for b in range(more):
                        to[b] -= factor * rest[b]
            else:
                for b in range(a + 1, last):
                    value[target[at]] -= factor * value[b]
                    at += 1
    return math.sqrt(smallest)


@kernel_inner
def _solve(ptr, below, target, value, b):  # type: ignore[no-untyped-def]
    """L D L^T y = b in place."""
    n, entries = ptr.size - 1, below.size
    if target.size == 0:
        _solve_skyline(ptr, entries, value, b)
        return
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
def _solve_skyline(ptr, entries, value, b):  # type: ignore[no-untyped-def]
    """The same where columns have no gaps."""
    n = ptr.size - 1
    for j in range(n):
        count, y = ptr[j + 1] - ptr[j], b[j]
        column, rest = stretch(value, ptr[j], count), stretch(b, j + 1, count)
        for a in range(count):
            rest[a] -= column[a] * y
    for j in range(n - 1, -1, -1):
        count = ptr[j + 1] - ptr[j]
        column, rest = stretch(value, ptr[j], count), stretch(b, j + 1, count)
        # four sums side by side: one would wait for itself
        p, q, r, s = 0.0, 0.0, 0.0, 0.0
        whole = count - count % 4
        for a in range(0, whole, 4):
            p += column[a] * rest[a]
            q += column[a + 1] * rest[a + 1]
            r += column[a + 2] * rest[a + 2]
            s += column[a + 3] * rest[a + 3]
        for a in range(whole, count):
            p += column[a] * rest[a]
        b[j] = b[j] * value[entries + j] - ((p + q) + (r + s))


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
    _solve(integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), integers(eq, e.SPARSE_TARGET), vector(ws, e.VALUES), b)


@kernel_inner
def _factor_share(eq, ws, value, gain):  # type: ignore[no-untyped-def]
    """Factor J^T W^-1 J over the coordinates, barely stiffened where motions are free."""
    ptr, below, target = integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), integers(eq, e.SPARSE_TARGET)
    sort, block, weight, u = integers(eq, e.SPARSE_SORT), grid(eq, e.SPARSE_BAR_BLOCK), vector(eq, e.WEIGHT), matrix(ws, e.U)
    typical = 0.0
    for k in range(weight.size):
        typical = max(typical, 1.0 / weight[k])
    for i in range(value.size):
        value[i] = 0.0
    for j in range(sort.size):
        value[below.size + j] = EASE * typical if sort[j] == NODE else 0.0
    for k in range(weight.size):
        c = 1.0 / weight[k]
        _put_block(block, k, value, u[0, k], u[1, k], u[2, k], 0.0, c, 0.0, -c, 0.0, c)
    _eliminate(sort, ptr, below, target, value, gain)


@kernel_inner
def _share(eq, ws, N):  # type: ignore[no-untyped-def]
    """Replace N by the forces of the same push J^T N with the least sum w N^2."""
    free, place, sort = integers(eq, e.FREE), integers(eq, e.SPARSE_PLACE), integers(eq, e.SPARSE_SORT)
    A, B, u, weight = integers(eq, e.A_), integers(eq, e.B_), matrix(ws, e.U), vector(eq, e.WEIGHT)
    b, y, rest, left = vector(ws, e.GAIN), vector(ws, e.Y), vector(ws, e.REST), vector(ws, e.RHS)
    ptr, below, target = integers(eq, e.SPARSE_PTR), integers(eq, e.SPARSE_BELOW), integers(eq, e.SPARSE_TARGET)
    sums = integers(eq, e.SUM_ROW).size > 0
    for c in range(rest.size):
        rest[c] = 0.0
    for k in range(N.size):
        left[k] = -N[k]
        N[k] = 0.0
    for _ in range(MOST):
        # rest is what N lacks of the push
        add_pulls(A, B, u, left, rest)
        if sums:
            sum_pulls_off(eq, ws, left, rest)
        for j in range(sort.size):
            b[j] = 0.0
        for i in range(free.size):
            b[place[i]] = rest[free[i]]
        _solve(ptr, below, target, vector(ws, e.VALUES_SHARE), b)
        for i in range(free.size):
            y[free[i]] = b[place[i]]
        along_rows(A, B, u, y, left)
        if sums:
            sum_along(eq, ws, y, left)
        largest, size = 0.0, 0.0
        for k in range(N.size):
            left[k] /= weight[k]
            N[k] += left[k]
            largest, size = larger(largest, abs(left[k])), larger(size, abs(N[k]))
        if not largest > REFINED * size:
            return


@kernel_inner
def sparse_solve(eq, ws, f, gamma, a, N):  # type: ignore[no-untyped-def]
    """Solve M a + J^T N = f, J a = gamma with the factors of `sparse_factor`; only free coordinates of a are written."""
    free, place, row_place = integers(eq, e.FREE), integers(eq, e.SPARSE_PLACE), integers(eq, e.SPARSE_ROW_PLACE)
    b, setup = vector(ws, e.GAIN), integers(eq, e.SETUP)
    _once(eq, ws, f, gamma, b)
    for i in range(free.size):
        a[free[i]] = b[place[i]]
    for k in range(row_place.size):
        N[k] = b[row_place[k]]
    if setup[3] and not setup[2]:
        _share(eq, ws, N)
