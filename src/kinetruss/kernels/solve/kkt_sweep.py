"""[[M, J^T], [J, 0]] by the null space, block after block: for few degrees of freedom and any number of rows.

Each block of rows solves coordinates that no earlier block touches; where it has more coordinates than rows, elimination with
complete pivoting chooses which of them stay independent, anew at every factorisation. One forward sweep gives the motion T of
all coordinates for each independent one, T^T M T a_i = T^T (f - M a_0) their accelerations, one backward sweep the forces.
Several plans may be given: the first whose pivots are good is taken, else the best of them.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1
from kinetruss.kernels.solve.cholesky import cholesky, cholesky_solve
from kinetruss.kernels.solve.elimination import complete_pivots
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import between, dot, mass_times

__all__ = ["sweep_factor", "sweep_solve"]

GOOD = 0.1
"""Pivot of unit gradients from which on a plan is taken as it is."""
LAST = 2e-3
"""Pivot of the best of them from which on the last resort, one block of everything, is not worth its price."""


@kernel_inline
def _invert(lu: F1, at: int) -> float:
    """A block of two rows and two coordinates by its inverse, in place; returns the sine between its rows."""
    a, b, c, d = lu[at], lu[at + 1], lu[at + 2], lu[at + 3]
    det = a * d - b * c
    inverse = 1.0 / det if abs(det) > 1e-14 else 0.0
    lu[at], lu[at + 1], lu[at + 2], lu[at + 3] = d * inverse, -b * inverse, -c * inverse, a * inverse
    return abs(det)


@kernel_inline
def _row(A: I1, B: I1, u: F2, k: int, y: F1) -> float:
    """Row k of J y."""
    return dot((u[0, k], u[1, k], u[2, k]), between(y, A[k], B[k]))


@kernel_bare
def _eliminate(eq: Equations, ws: Workspace, plan: int) -> float:
    """L U of the blocks of a plan with complete pivoting, row-major at lu[place[b]:]; row_at, col_at say what stands where.

    Returns the smallest pivot.
    """
    row_ptr, col_ptr, row, col, place = eq.sweep_row_ptr, eq.sweep_col_ptr, eq.sweep_row, eq.sweep_col, eq.sweep_place
    entry_ptr, entry_at, entry_row = eq.sweep_entry_ptr, eq.sweep_entry_at, eq.sweep_entry_row
    entry_axis, entry_sign, u, lu, row_at, col_at = eq.sweep_entry_axis, eq.sweep_entry_sign, ws.u, ws.lu, ws.row_at, ws.col_at
    smallest, first, last = 1.0, eq.sweep_plans[plan], eq.sweep_plans[plan + 1]
    # P A Q = L U of each block, A its rows of J with respect to its own coordinates
    for b in range(first, last):
        r, c, at = row_ptr[b], col_ptr[b], place[b]
        n, width = row_ptr[b + 1] - r, col_ptr[b + 1] - c
        for i in range(n):
            row_at[r + i] = row[r + i]
        for j in range(width):
            col_at[c + j] = col[c + j]
        for m in range(at, at + n * width):
            lu[m] = 0.0
        for m in range(entry_ptr[b], entry_ptr[b + 1]):
            lu[entry_at[m]] = entry_sign[m] * u[entry_axis[m], entry_row[m]]
        if n == 2 and width == 2:
            best = _invert(lu, at)
            if not best >= smallest:
                smallest = best
            continue
        best = complete_pivots(lu, at, n, width, row_at, r, col_at, c)
        if not best >= smallest:
            smallest = best
    return smallest


@kernel_inline
def _block_solve(lu: F1, at: int, n: int, width: int, z: F1) -> None:
    """The n x n part of a block: solve A z = z."""
    # forward substitution with unit L
    for i in range(1, n):
        value = z[i]
        for j in range(i):
            value -= lu[at + i * width + j] * z[j]
        z[i] = value
    # back substitution with U
    for i in range(n - 1, -1, -1):
        value = z[i]
        for j in range(i + 1, n):
            value -= lu[at + i * width + j] * z[j]
        z[i] = value * lu[at + i * width + i]


@kernel_inline
def _sweep(eq: Equations, ws: Workspace, first: int, last: int, gamma: F1, y: F1) -> None:
    """Forward: J y = gamma with y zero at independent coordinates; y must be zero at coordinates of no block."""
    row_ptr, col_ptr, place, A, B = eq.sweep_row_ptr, eq.sweep_col_ptr, eq.sweep_place, eq.A, eq.B
    u, lu, row_at, col_at, z = ws.u, ws.lu, ws.row_at, ws.col_at, ws.z
    # block b: A y_b = gamma_b - J y of the earlier blocks
    for b in range(first, last):
        r, c, at = row_ptr[b], col_ptr[b], place[b]
        n, width = row_ptr[b + 1] - r, col_ptr[b + 1] - c
        for j in range(width):
            y[col_at[c + j]] = 0.0
        if n == 2 and width == 2:
            k, m = row_at[r], row_at[r + 1]
            first_z, second_z = gamma[k] - _row(A, B, u, k, y), gamma[m] - _row(A, B, u, m, y)
            y[col_at[c]] = lu[at] * first_z + lu[at + 1] * second_z
            y[col_at[c + 1]] = lu[at + 2] * first_z + lu[at + 3] * second_z
            continue
        for i in range(n):
            k = row_at[r + i]
            z[i] = gamma[k] - _row(A, B, u, k, y)
        _block_solve(lu, at, n, width, z)
        for i in range(n):
            y[col_at[c + i]] = z[i]


@kernel_inline
def _modes(eq: Equations, ws: Workspace, first: int, last: int) -> None:
    """T (dof, 3 n): how all coordinates move with each independent one."""
    row_ptr, col_ptr, place, A, B = eq.sweep_row_ptr, eq.sweep_col_ptr, eq.sweep_place, eq.A, eq.B
    u, lu, row_at, col_at, z = ws.u, ws.lu, ws.row_at, ws.col_at, ws.z
    T = ws.T
    dofs = 0
    # T of block b: A T_b = -J T of the earlier blocks, 1 at its own independent coordinates
    for b in range(first, last):
        r, c, at = row_ptr[b], col_ptr[b], place[b]
        n, width = row_ptr[b + 1] - r, col_ptr[b + 1] - c
        known, dofs = dofs, dofs + width - n
        if n == 2 and width == 2:
            k, m = row_at[r], row_at[r + 1]
            for d in range(dofs):
                T[d, col_at[c]], T[d, col_at[c + 1]] = 0.0, 0.0
                first_z, second_z = -_row(A, B, u, k, T[d]), -_row(A, B, u, m, T[d])
                T[d, col_at[c]] = lu[at] * first_z + lu[at + 1] * second_z
                T[d, col_at[c + 1]] = lu[at + 2] * first_z + lu[at + 3] * second_z
            for d in range(dofs, T.shape[0]):
                T[d, col_at[c]], T[d, col_at[c + 1]] = 0.0, 0.0
            continue
        for d in range(dofs):
            for j in range(width):
                T[d, col_at[c + j]] = 0.0
            if d >= known:
                # its own column of the block, already reduced by L
                T[d, col_at[c + n + d - known]] = 1.0
                for i in range(n - 1, -1, -1):
                    value = -lu[at + i * width + n + d - known]
                    for j in range(i + 1, n):
                        value -= lu[at + i * width + j] * z[j]
                    z[i] = value * lu[at + i * width + i]
            else:
                moved = False
                for i in range(n):
                    z[i] = -_row(A, B, u, row_at[r + i], T[d])
                    moved = moved or z[i] != 0.0
                if not moved:
                    continue
                _block_solve(lu, at, n, width, z)
            for i in range(n):
                T[d, col_at[c + i]] = z[i]
        for d in range(dofs, T.shape[0]):
            for j in range(width):
                T[d, col_at[c + j]] = 0.0


@kernel_inline
def _take(A: I1, B: I1, u: F2, k: int, amount: float, rest: F1) -> None:
    """rest -= J_k^T amount."""
    p, q = A[k], B[k]
    # -J_k^T N: -u at A, u at B
    for axis in range(3):
        force = amount * u[axis, k]
        rest[p + axis] += force
        rest[q + axis] -= force


@kernel_inline
def _back(eq: Equations, ws: Workspace, first: int, last: int, rest: F1, N: F1) -> None:
    """Backward: J^T N = rest over the dependent coordinates; rest is used up."""
    row_ptr, col_ptr, place, A, B = eq.sweep_row_ptr, eq.sweep_col_ptr, eq.sweep_place, eq.A, eq.B
    u, lu, row_at, col_at, z = ws.u, ws.lu, ws.row_at, ws.col_at, ws.z
    # A^T N_b = rest of block b, whose J^T N goes off the earlier blocks
    for b in range(last - 1, first - 1, -1):
        r, c, at = row_ptr[b], col_ptr[b], place[b]
        n, width = row_ptr[b + 1] - r, col_ptr[b + 1] - c
        if n == 2 and width == 2:
            k, m = row_at[r], row_at[r + 1]
            first_z, second_z = rest[col_at[c]], rest[col_at[c + 1]]
            N[k] = lu[at] * first_z + lu[at + 2] * second_z
            N[m] = lu[at + 1] * first_z + lu[at + 3] * second_z
            _take(A, B, u, k, N[k], rest)
            _take(A, B, u, m, N[m], rest)
            continue
        for i in range(n):
            value = rest[col_at[c + i]]
            for j in range(i):
                value -= lu[at + j * width + i] * z[j]
            z[i] = value * lu[at + i * width + i]
        for i in range(n - 1, -1, -1):
            value = z[i]
            for j in range(i + 1, n):
                value -= lu[at + j * width + i] * z[j]
            z[i] = value
            k = row_at[r + i]
            N[k] = value
            _take(A, B, u, k, value, rest)


@kernel_inline
def _along(a: F1, b: F1) -> float:
    """Inner product; four sums side by side, as one would wait for itself."""
    p, q, r, s, whole = 0.0, 0.0, 0.0, 0.0, a.size - a.size % 4
    # four partial sums,
    for c in range(0, whole, 4):
        p += a[c] * b[c]
        q += a[c + 1] * b[c + 1]
        r += a[c + 2] * b[c + 2]
        s += a[c + 3] * b[c + 3]
    # and the last entries
    for c in range(whole, a.size):
        p += a[c] * b[c]
    return (p + q) + (r + s)


@kernel_bare
def sweep_factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """Eliminate, sweep the modes T, factor T^T M T. Returns the smallest pivot."""
    plans, taken = eq.sweep_plans, ws.taken
    best, chosen, at_hand = -1.0, 0, 0
    # the first plan with good pivots, else the best
    for plan in range(plans.size - 1):
        if plan > 0 and plans[plan + 1] - plans[plan] == 1 and best >= LAST:
            break
        pivot = _eliminate(eq, ws, plan)
        at_hand = plan
        if pivot > best:
            best, chosen = pivot, plan
        if pivot >= GOOD:
            break
    if chosen != at_hand:
        _eliminate(eq, ws, chosen)
    taken[0] = chosen
    T, MT, R, kept = ws.T, ws.MT, ws.R, ws.x
    _modes(eq, ws, plans[chosen], plans[chosen + 1])
    # the place of the factors, for the products with M(x)
    for c in range(x.size):
        kept[c] = x[c]
    dofs = T.shape[0]
    # T^T M T
    for d in range(dofs):
        mass_times(eq, x, T[d], MT[d])
        for i in range(d + 1):
            R[i, d] = _along(T[i], MT[d])
    if not cholesky(R, dofs):
        return 0.0
    return best


@kernel_bare
def sweep_solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve M a + J^T N = f, J a = gamma with the factors of `sweep_factor`; only free coordinates of a are written."""
    plans, chosen, free = eq.sweep_plans, ws.taken[0], eq.free
    first, last = plans[chosen], plans[chosen + 1]
    T, MT, y, rest, q = ws.T, ws.MT, ws.y, ws.rest, ws.q
    dofs = T.shape[0]
    _sweep(eq, ws, first, last, gamma, y)
    # T^T (f - M a_0), a_0 with zero at the independent coordinates
    for d in range(dofs):
        q[d] = _along(T[d], f) - _along(MT[d], y)
    cholesky_solve(ws.R, dofs, q)
    # a = a_0 + T a_i
    for d in range(dofs):
        for c in range(y.size):
            y[c] += T[d, c] * q[d]
    mass_times(eq, ws.x, y, rest)
    # f - M a, what J^T N must balance
    for c in range(y.size):
        rest[c] = f[c] - rest[c]
    # a of the free coordinates
    for i in range(free.size):
        a[free[i]] = y[free[i]]
    _back(eq, ws, first, last, rest, N)
