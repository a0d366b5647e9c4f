"""Elimination of the rows of a matrix that is mostly zero, those that depend on others left out: P A Q = L U on the rest.

A row is reduced by the pivot rows before it. Where its largest entry that is left is small, it waits; in the end the rows that
waited are taken by their largest entry, and those that keep none depend on the others (Duff, Erisman & Reid, Direct Methods for
Sparse Matrices, 2017, section 5.2). Of a row, the first entry that is not small is the pivot: columns stand in an order that
keeps few entries.

The reduced rows lie in place of the matrix, multipliers L at the pivot columns before that of the row, U at the others.

Small full blocks with more columns than rows are eliminated with complete pivoting: the columns left over are independent.
"""

from __future__ import annotations

from typing import NamedTuple

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1, I2

__all__ = ["Reduced", "complete_pivots", "reduce_rows", "solve_columns", "solve_rows"]

SHARE = 0.25
"""A pivot is at least this share of the largest entry of its row."""
WAIT = 0.1
"""A row of unit size whose largest entry is smaller waits."""
NOTHING = 1e-9
"""A row whose largest entry is smaller depends on the others."""


class Reduced(NamedTuple):
    """Pivot k stands in row[k], col[k], with inverse[k] of its value; found[0] pivots.

    a (rows, columns) : reduced. at (columns,) : pivot of a column, -1 none. low[k, :n_low[k]] : pivots with a multiplier in the
    row of pivot k. up[k, :n_up[k]] : columns of its other entries. done (rows,) : pivots that have reduced a row.
    """

    a: F2
    row: I1
    col: I1
    inverse: F1
    at: I1
    low: I2
    up: I2
    n_low: I1
    n_up: I1
    done: I1
    found: I1


@kernel_bare
def _reduce(one: Reduced, i: int) -> tuple[int, float]:
    """Reduce row i by the pivots found since it was reduced last. Returns the first column with a large entry, and the largest
    entry.
    """
    a, col, n = one.a, one.col, one.found[0]
    # a_i -= a_ic / a_rc a_r, r and c of each pivot in turn
    for k in range(one.done[i], n):
        factor = a[i, col[k]]
        if factor != 0.0:
            factor *= one.inverse[k]
            a[i, col[k]] = factor
            r = one.row[k]
            for s in range(one.n_up[k]):
                j = one.up[k, s]
                a[i, j] -= factor * a[r, j]
    one.done[i] = n
    largest = 0.0
    # largest entry in columns without a pivot
    for j in range(a.shape[1]):
        if one.at[j] < 0 and abs(a[i, j]) > largest:
            largest = abs(a[i, j])
    for j in range(a.shape[1]):
        if one.at[j] < 0 and largest > 0.0 and abs(a[i, j]) >= SHARE * largest:
            return j, largest
    return -1, largest


@kernel_bare
def _take(one: Reduced, i: int, c: int) -> None:
    """Make column c of row i the next pivot, and list the entries of the row."""
    k, below, beside = one.found[0], 0, 0
    # multipliers at the pivots before, U at columns without one
    for j in range(one.a.shape[1]):
        if one.a[i, j] != 0.0 and j != c:
            if one.at[j] >= 0:
                one.low[k, below] = one.at[j]
                below += 1
            else:
                one.up[k, beside] = j
                beside += 1
    one.row[k], one.col[k], one.inverse[k] = i, c, 1.0 / one.a[i, c]
    one.n_low[k], one.n_up[k], one.at[c] = below, beside, k
    one.found[0] = k + 1


@kernel
def reduce_rows(one: Reduced, order: I1, waiting: I1) -> float:
    """Reduce the rows of `order`; returns the largest entry of a row that depends on the others.

    waiting : as long as order, scratch.
    """
    count = 0
    # rows with a large entry at once
    for i in order:
        c, largest = _reduce(one, i)
        if largest >= WAIT:
            _take(one, i, c)
        else:
            waiting[count] = i
            count += 1
    # the others by their largest entry
    while count:
        best, which, where = 0.0, -1, -1
        for k in range(count):
            c, largest = _reduce(one, waiting[k])
            if largest > best:
                best, which, where = largest, k, c
        if best < NOTHING:
            return best
        _take(one, waiting[which], where)
        count -= 1
        waiting[which] = waiting[count]
    return 0.0


@kernel
def solve_columns(one: Reduced, count: int, b: F2, y: F2) -> None:
    """Solve sum_j A_ij y_j = b_i in the rows i of the first `count` pivots, one right side a row of b (s, pivots) and y.

    y (s, columns) : holds the given values of the other columns; b is spoilt.
    """
    for t in range(b.shape[0]):
        # forward substitution with unit L
        for k in range(count):
            for m in range(one.n_low[k]):
                b[t, k] -= one.a[one.row[k], one.col[one.low[k, m]]] * b[t, one.low[k, m]]
        # back substitution with U
        for k in range(count - 1, -1, -1):
            value = b[t, k]
            for s in range(one.n_up[k]):
                j = one.up[k, s]
                value -= one.a[one.row[k], j] * y[t, j]
            y[t, one.col[k]] = value * one.inverse[k]


@kernel
def solve_rows(one: Reduced, count: int, b: F2, share: F2) -> None:
    """Add to share (s, pivots) the shares z of the first `count` pivot rows in rows b (s, columns): z A = b at their columns.

    b is spoilt.
    """
    for t in range(b.shape[0]):
        # forward substitution with U^T
        for k in range(count):
            value = b[t, one.col[k]] * one.inverse[k]
            b[t, one.col[k]] = value
            if value != 0.0:
                for s in range(one.n_up[k]):
                    j = one.up[k, s]
                    b[t, j] -= value * one.a[one.row[k], j]
        # back substitution with L^T
        for k in range(count - 1, -1, -1):
            value = b[t, one.col[k]]
            share[t, k] += value
            if value != 0.0:
                for m in range(one.n_low[k]):
                    c = one.col[one.low[k, m]]
                    b[t, c] -= value * one.a[one.row[k], c]


@kernel_inline
def complete_pivots(lu: F1, at: int, n: int, width: int, row_at: I1, r: int, col_at: I1, c: int) -> float:
    """P A Q = L U of a full block (n, width) in place, row-major at lu[at:]; returns the smallest pivot.

    row_at[r:], col_at[c:] : what stands at its rows and columns, swapped with them. Reciprocals of pivots on the diagonal, 0 of
    those that vanish.
    """
    smallest = 1.0
    # the largest entry left is the next pivot
    for k in range(n):
        best, i_best, j_best = -1.0, k, k
        for i in range(k, n):
            for j in range(k, width):
                size = abs(lu[at + i * width + j])
                if size > best:
                    best, i_best, j_best = size, i, j
        if i_best != k:
            row_at[r + k], row_at[r + i_best] = row_at[r + i_best], row_at[r + k]
            for j in range(width):
                lu[at + k * width + j], lu[at + i_best * width + j] = lu[at + i_best * width + j], lu[at + k * width + j]
        if j_best != k:
            col_at[c + k], col_at[c + j_best] = col_at[c + j_best], col_at[c + k]
            for i in range(n):
                lu[at + i * width + k], lu[at + i * width + j_best] = lu[at + i * width + j_best], lu[at + i * width + k]
        if not best >= smallest:
            smallest = best
        inverse = 1.0 / lu[at + k * width + k] if best > 1e-14 else 0.0
        lu[at + k * width + k] = inverse
        for i in range(k + 1, n):
            factor = lu[at + i * width + k] * inverse
            if factor != 0.0:
                lu[at + i * width + k] = factor
                for j in range(k + 1, width):
                    lu[at + i * width + j] -= factor * lu[at + k * width + j]
    return smallest
