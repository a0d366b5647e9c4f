"""[[M, J^T], [J, 0]] = L D L^T on a pattern that is found once; the numbers are refreshed without a search.

The order comes from approximate minimum degree, with each row put behind all coordinates it touches, so that no pivot is zero
where the rows are independent. Values stand in one array: entries below the diagonal column by column, then the diagonal,
then one place that nobody reads. A row whose pivot is below 1e-11 of what the coordinates give to it depends on rows before it
and is dropped. Where rows are redundant, the forces N_0 that are found without them are shared: N = W^-1 J y with
J^T W^-1 J y = J^T N_0, the forces of the same load J^T N that make sum w N^2 least, on the same pattern.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Vector
from kinetruss.kernels.compiled.words import view
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import blocks_of, direction
from kinetruss.kernels.structure.rows import add_row_forces, along_rows
from kinetruss.kernels.structure.sums import add_sum_forces, sum_along, sum_entries

__all__ = ["NODE", "OWN", "REDUNDANT", "sparse_factor", "sparse_solve", "sparse_targets", "sparse_tree"]

NODE, OWN, REDUNDANT = 2, 0, 1
"""What stands at a place: a coordinate, a row, a redundant row."""
DROP = 1e-11
EASE = 1e-12
"""Stiffness of motions that no bar resists, as a share of that of the stiffest bar."""
REFINED = 1e-13
MOST = 6


@kernel
def sparse_tree(n: int, upper_ptr: I1, upper_row: I1, parent: I1, flag: I1, count: I1, below: I1) -> None:
    """Elimination tree and, in two passes, the pattern of L: with empty `below` the column counts, else the rows.

    upper_ptr, upper_row : rows above the diagonal of each column. Davis (2006), Direct Methods, section 4.1.
    """
    fill = below.size > 0
    # row k of L: paths in the elimination tree from the entries of row k of the matrix up to k
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
def sparse_targets(ptr: I1, below: I1, target: I1) -> int:
    """Where each product of two entries of a column goes, in the order in which `sparse_factor` makes them."""
    at = 0
    # column j updates entry (below[b], below[a]) of column below[a]
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


@kernel_bare
def _put_block(at: I2, k: int, value: F1, u: Vector, blocks: tuple[float, ...]) -> None:
    """Add the blocks s 1 + r u u^T of two nodes to their places at[k] (36,), row by row, lower triangle.

    u : three numbers. blocks : s and r of AA, AB, BB, as `blocks_of` gives them.
    """
    (ux, uy, uz), (s_AA, r_AA, s_AB, r_AB, s_BB, r_BB) = u, blocks
    # lower triangle of [[AA, AB], [AB, BB]]
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


@kernel_bare
def _put_augmented(at: I2, j: int, value: F1, u: F2, k: int, augmentation: float) -> None:
    """Add the blocks of augmentation J_k^T J_k to their places at[j], with the gradients u (3, r) of rows between two nodes."""
    _put_block(at, j, value, (u[0, k], u[1, k], u[2, k]), (0.0, augmentation, 0.0, -augmentation, 0.0, augmentation))


@kernel_bare
def _assemble(eq: Equations, ws: Workspace, x: F1, u: F2, value: F1) -> None:
    """The matrix at x into value: constant masses, gradients, varying masses."""
    base, entry, block = eq.sparse_base, eq.sparse_entry, eq.sparse_block
    # entries that do not depend on x
    for i in range(base.size):
        value[i] = base[i]
    # J: -u at A, u at B
    for k in range(entry.shape[0]):
        for c in range(3):
            value[entry[k, c]] = -u[c, k]
            value[entry[k, 3 + c]] = u[c, k]
    if eq.sum_row.size:
        sum_entries(ws, eq.sparse_sum_entry, value)
    # mass of members of varying inertia
    for j in range(eq.varying_A.size):
        L, along = direction(x, eq.varying_A[j], eq.varying_B[j])
        _put_block(block, j, value, along, blocks_of(eq.varying, j, L))


@kernel_bare
def _augment(eq: Equations, u: F2, value: F1) -> None:
    """Rows added to nodes without mass."""
    augmented_row, augmented_block = eq.augmented_row, eq.augmented_block
    augmentation = eq.augmentation[0]
    # c J^T J
    for j in range(augmented_row.size):
        _put_augmented(augmented_block, j, value, u, augmented_row[j], augmentation)


@kernel_late
def sparse_factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """Assemble and factor at x. Returns the smallest scaled pivot of rows that are not redundant.

    The pivot of a row is compared with `gain`, what the coordinates give to it.
    """
    value, gain, sort = ws.values, ws.gain, eq.sparse_sort
    ptr, below, target = eq.sparse_ptr, eq.sparse_below, eq.sparse_target
    _assemble(eq, ws, x, ws.u, value)
    _augment(eq, ws.u, value)
    kept = ws.x
    # the place of the factors, for the products with M(x)
    for c in range(x.size):
        kept[c] = x[c]
    if eq.shared:
        _factor_share(eq, ws, ws.values_share, gain)
    return _eliminate(sort, ptr, below, target, value, gain)


@kernel_bare
def _pivot(j: int, sort: I1, d: float, gain: F1, smallest: float) -> tuple[float, float]:
    """Reciprocal of the pivot at place j, 0 where it is dropped, and the smallest scaled pivot so far."""
    if sort[j] == NODE:
        return (1.0 / d, smallest) if 0.0 < d < math.inf else (0.0, 0.0)
    share = -d / gain[j] if gain[j] > 0.0 else 0.0
    if sort[j] == OWN and not share >= smallest:
        smallest = share if share > 0.0 else 0.0
    return (1.0 / d if DROP < share < math.inf else 0.0), smallest


@kernel_bare
def _eliminate(sort: I1, ptr: I1, below: I1, target: I1, value: F1, gain: F1) -> float:
    """L D L^T of the values in place, right-looking; the reciprocals of D are left in its place.

    Without targets, the columns reach without a gap as far as they reach (a skyline), and products go side by side.
    """
    n, entries, at = sort.size, below.size, 0
    smallest, skyline = 1.0, target.size == 0
    # gain: diagonal of J M^-1 J^T, summed as the coordinates are eliminated
    for j in range(n):
        gain[j] = 0.0
    # right-looking: column j scaled by its pivot, its outer product taken off the columns behind
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
                    to, rest = view(value, ptr[i], more), view(value, a + 1, more)
                    for b in range(more):
                        to[b] -= factor * rest[b]
            else:
                for b in range(a + 1, last):
                    value[target[at]] -= factor * value[b]
                    at += 1
    return math.sqrt(smallest)


@kernel_bare
def _solve(ptr: I1, below: I1, target: I1, value: F1, b: F1) -> None:
    """L D L^T y = b in place."""
    n, entries = ptr.size - 1, below.size
    if target.size == 0:
        _solve_skyline(ptr, entries, value, b)
        return
    # forward substitution L z = b
    for j in range(n):
        y = b[j]
        for a in range(ptr[j], ptr[j + 1]):
            b[below[a]] -= value[a] * y
    # D^-1 and back substitution L^T y = D^-1 z
    for j in range(n - 1, -1, -1):
        y = b[j] * value[entries + j]
        for a in range(ptr[j], ptr[j + 1]):
            y -= value[a] * b[below[a]]
        b[j] = y


@kernel_bare
def _solve_skyline(ptr: I1, entries: int, value: F1, b: F1) -> None:
    """The same where columns have no gaps."""
    n = ptr.size - 1
    # forward substitution L z = b
    for j in range(n):
        count, y = ptr[j + 1] - ptr[j], b[j]
        column, rest = view(value, ptr[j], count), view(b, j + 1, count)
        for a in range(count):
            rest[a] -= column[a] * y
    # D^-1 and back substitution L^T y = D^-1 z
    for j in range(n - 1, -1, -1):
        count = ptr[j + 1] - ptr[j]
        column, rest = view(value, ptr[j], count), view(b, j + 1, count)
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


@kernel_bare
def _once(eq: Equations, ws: Workspace, f: F1, gamma: F1, b: F1) -> None:
    """Solution for f (3 n,), gamma (r,) with the factors at hand, into b by place."""
    free, local, place, row_place = (
        eq.free,
        eq.local,
        eq.sparse_place,
        eq.sparse_row_place,
    )
    A, B, u = eq.A, eq.B, ws.u
    augmented_row, augmentation = eq.augmented_row, eq.augmentation[0]
    # f of the free coordinates, in the order of elimination
    for i in range(free.size):
        b[place[i]] = f[free[i]]
    # gamma of the constraints
    for k in range(row_place.size):
        b[row_place[k]] = gamma[k]
    # f + c J^T gamma for the constraints added to M
    for j in range(augmented_row.size):
        k = augmented_row[j]
        for c in range(3):
            force = augmentation * u[c, k] * gamma[k]
            p, q = local[A[k] + c], local[B[k] + c]
            if p >= 0:
                b[place[p]] -= force
            if q >= 0:
                b[place[q]] += force
    _solve(eq.sparse_ptr, eq.sparse_below, eq.sparse_target, ws.values, b)


@kernel_bare
def _factor_share(eq: Equations, ws: Workspace, value: F1, gain: F1) -> None:
    """Factor J^T W^-1 J over the coordinates, barely stiffened where motions are free."""
    ptr, below, target = eq.sparse_ptr, eq.sparse_below, eq.sparse_target
    sort, block, weight, u = eq.sparse_sort, eq.sparse_bar_block, eq.weight, ws.u
    typical = 0.0
    # largest 1/w, the scale of the regularisation
    for k in range(weight.size):
        typical = max(typical, 1.0 / weight[k])
    for i in range(value.size):
        value[i] = 0.0
    # a small diagonal where the coordinates are free to move
    for j in range(sort.size):
        value[below.size + j] = EASE * typical if sort[j] == NODE else 0.0
    # J^T W^-1 J: bars of stiffness 1/w
    for k in range(weight.size):
        _put_augmented(block, k, value, u, k, 1.0 / weight[k])
    _eliminate(sort, ptr, below, target, value, gain)


@kernel_bare
def _share(eq: Equations, ws: Workspace, N: F1) -> None:
    """Replace N by the forces of the same load J^T N with the least sum w N^2."""
    free, place, sort = eq.free, eq.sparse_place, eq.sparse_sort
    A, B, u, weight = eq.A, eq.B, ws.u, eq.weight
    b, y, rest, left = ws.gain, ws.y, ws.rest, ws.rhs
    ptr, below, target = eq.sparse_ptr, eq.sparse_below, eq.sparse_target
    sums = eq.sum_row.size > 0
    for c in range(rest.size):
        rest[c] = 0.0
    for k in range(N.size):
        left[k] = -N[k]
        N[k] = 0.0
    # iterative refinement: J^T W^-1 J y = J^T (N_0 - N), N += W^-1 J y
    for _ in range(MOST):
        # rest is what N lacks of the load
        add_row_forces(A, B, u, left, rest)
        if sums:
            add_sum_forces(eq, ws, left, rest)
        for j in range(sort.size):
            b[j] = 0.0
        for i in range(free.size):
            b[place[i]] = rest[free[i]]
        _solve(ptr, below, target, ws.values_share, b)
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


@kernel_late
def sparse_solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve M a + J^T N = f, J a = gamma with the factors of `sparse_factor`; only free coordinates of a are written."""
    free, place, row_place = eq.free, eq.sparse_place, eq.sparse_row_place
    b = ws.gain
    _once(eq, ws, f, gamma, b)
    # a of the free coordinates
    for i in range(free.size):
        a[free[i]] = b[place[i]]
    # multipliers N
    for k in range(row_place.size):
        N[k] = b[row_place[k]]
    if eq.shared:
        _share(eq, ws, N)
