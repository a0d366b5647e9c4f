"""[[M, J^T], [J, 0]] = L D L^T on a pattern that is found once; the numbers are refreshed without a search.

The order comes from approximate minimum degree, with each row put behind all coordinates it touches, so that no pivot is zero
where the rows are independent; rows that depend on others are dropped (solve.ldl). Behind the diagonal is one place that nobody
reads. Where rows are redundant, the forces N_0 that are found without them are shared: N = W^-1 J y with
J^T W^-1 J y = J^T N_0, the forces of the same load J^T N that make sum w N^2 least, on the same pattern.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I2, Vector
from kinetruss.kernels.solve.ldl import COORDINATE, ldl_dropped, ldl_solve
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import blocks_of, direction
from kinetruss.kernels.structure.rows import add_row_forces, along_rows
from kinetruss.kernels.structure.sums import add_sum_forces, sum_along, sum_entries

__all__ = ["sparse_factor", "sparse_solve"]

EASE = 1e-12
"""Stiffness of motions that no bar resists, as a share of that of the stiffest bar."""
REFINED = 1e-13
MOST = 6


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


@kernel_bare
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
    return ldl_dropped(ptr, below, target, value, sort, gain)


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
    ldl_solve(eq.sparse_ptr, eq.sparse_below, eq.sparse_target, ws.values, b)


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
        value[below.size + j] = EASE * typical if sort[j] == COORDINATE else 0.0
    # J^T W^-1 J: bars of stiffness 1/w
    for k in range(weight.size):
        _put_augmented(block, k, value, u, k, 1.0 / weight[k])
    ldl_dropped(ptr, below, target, value, sort, gain)


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
        ldl_solve(ptr, below, target, ws.values_share, b)
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


@kernel_bare
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
