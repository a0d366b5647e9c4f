"""LU in place: small dense matrices with partial pivoting, and sparse ones of large blocks on a pattern found once.

Golub & Van Loan (2013), algorithm 3.4.1, with the reciprocals of the pivots on the diagonal. Sizes here are 2 to about 60;
below that LAPACK calls cost more than they save. Column-oriented solves keep the chains of dependent operations short.
The matrix of size n that starts at row `first` is lu[first:first+n, :n]; no slices are taken, since each costs as much as a
row of the solve. Sizes 2, 3 and 9 (a planar dyad, a node on three bars, half an octahedral bay) are compiled with the size
known, which halves their time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import B2, F1, F2, I1, U1, U2

TINY = 1e-100


@kernel_inline
def _factor(lu: F2, pivot: I1, first: int, n: int) -> float:
    sign = 1.0
    # right-looking elimination, rows swapped to the largest pivot of the column
    for k in range(n):
        # where no entry is a number no row is better: then the pivot counts as zero
        best = -1.0
        at = k
        for i in range(k, n):
            size = abs(lu[first + i, k])
            if size > best:
                best = size
                at = i
        pivot[first + k] = at
        if at != k:
            sign = -sign
            for j in range(n):
                kept = lu[first + k, j]
                lu[first + k, j] = lu[first + at, j]
                lu[first + at, j] = kept
        if not TINY <= best < math.inf:
            lu[first + k, k] = TINY
            sign = 0.0
        inverse = 1.0 / lu[first + k, k]
        if inverse < 0:
            sign = -sign
        lu[first + k, k] = inverse
        for i in range(k + 1, n):
            factor = lu[first + i, k]
            if factor != 0.0:
                factor *= inverse
                lu[first + i, k] = factor
                for j in range(k + 1, n):
                    lu[first + i, j] -= factor * lu[first + k, j]
    return sign


@kernel_inline
def _solve(lu: F2, pivot: I1, first: int, n: int, b: F1) -> float:
    # P b
    for k in range(n):
        at = pivot[first + k]
        kept = b[at]
        b[at] = b[k]
        b[k] = kept
    # forward substitution with unit L, column by column
    for i in range(n - 1):
        value = b[i]
        for j in range(i + 1, n):
            b[j] -= lu[first + j, i] * value
    largest = 0.0
    # back substitution with U, column by column
    for i in range(n - 1, -1, -1):
        inverse = lu[first + i, i]
        largest = max(largest, abs(inverse))
        value = b[i] * inverse
        b[i] = value
        for j in range(i):
            b[j] -= lu[first + j, i] * value
    return largest


@kernel_inline
def _solve_transposed(lu: F2, pivot: I1, first: int, n: int, b: F1) -> float:
    largest = 0.0
    # forward substitution with U^T
    for i in range(n):
        inverse = lu[first + i, i]
        largest = max(largest, abs(inverse))
        value = b[i] * inverse
        b[i] = value
        for j in range(i + 1, n):
            b[j] -= lu[first + i, j] * value
    # back substitution with L^T
    for i in range(n - 1, 0, -1):
        value = b[i]
        for j in range(i):
            b[j] -= lu[first + i, j] * value
    # P^T y
    for k in range(n - 1, -1, -1):
        at = pivot[first + k]
        kept = b[at]
        b[at] = b[k]
        b[k] = kept
    return largest


@kernel_bare
def lu_factor(lu: F2, pivot: I1, first: int, n: int) -> float:
    """Factor the matrix at row `first` in place; row swaps in pivot[first:first+n].

    Returns the sign of the determinant (0 if a pivot is zero or no finite number, which is then replaced).
    """
    if n == 9:
        return _factor(lu, pivot, first, 9)
    if n == 3:
        return _factor(lu, pivot, first, 3)
    if n == 2:
        return _factor(lu, pivot, first, 2)
    return _factor(lu, pivot, first, n)


@kernel_inline
def lu_solve(lu: F2, pivot: I1, first: int, n: int, b: F1) -> float:
    """Solve A y = b in place, with the factors of `lu_factor`; b[:n]. Returns the largest reciprocal of a pivot."""
    if n == 9:
        return _solve(lu, pivot, first, 9, b)
    if n == 3:
        return _solve(lu, pivot, first, 3, b)
    if n == 2:
        return _solve(lu, pivot, first, 2, b)
    return _solve(lu, pivot, first, n, b)


@kernel_inline
def lu_solve_transposed(lu: F2, pivot: I1, first: int, n: int, b: F1) -> float:
    """Solve A^T y = b in place, with the factors of `lu_factor`; b[:n]. Returns the largest reciprocal of a pivot."""
    if n == 9:
        return _solve_transposed(lu, pivot, first, 9, b)
    if n == 3:
        return _solve_transposed(lu, pivot, first, 3, b)
    if n == 2:
        return _solve_transposed(lu, pivot, first, 2, b)
    return _solve_transposed(lu, pivot, first, n, b)


# LU of the sparse matrices of large blocks: which pivots, and where the factors are not zero, is found once and kept.
#
# A platform of seven nodes makes a block of 21 rows of six numbers: in a good order its elimination takes 120
# multiplications, as a full matrix 3,087. The column with the fewest rows left gives the next pivot, among its entries that
# are not small the one with the shortest row (Markowitz, 1957, column by column; Duff, Erisman & Reid, Direct Methods for
# Sparse Matrices, 2017, section 7.2). Other numbers are then eliminated in the same order, as long as no multiplier grows
# beyond LARGEST.
#
# Matrices lie as in sweep.lu: rows first:last of a common array. Rows in `row` and `low` are those of that array, columns
# in `col` and `up` those of the matrix. Both are without sign: a signed index is tested at each use.

FAILED = 2.0
SHARE = 0.25
"""A pivot of an order is at least this share of the largest in its column."""
LARGEST = 40.0
"""Multiplier beyond which an order is given up."""


class Order(NamedTuple):
    """Pivot k stands in row[k], col[k]; below it low[k, :n_low[k]] rows are not zero, beside it up[k, :n_up[k]] columns."""

    row: U1
    col: U1
    low: U2
    up: U2
    n_low: U1
    n_up: U1


@kernel
def new_order(rows: int, width: int) -> Order:
    """Empty orders of elimination for blocks of up to `width` columns, `rows` rows in all."""
    one, count, lists = np.zeros(rows, np.uint32), np.zeros(rows, np.uint32), np.zeros((rows, width), np.uint32)
    return Order(one, one.copy(), lists, lists.copy(), count, count.copy())


@kernel_inline
def _pivot(lu: F2, r: int, c: int) -> tuple[float, float]:
    """Replace the pivot by its reciprocal; returns both its sign (0: it vanished) and the reciprocal."""
    pivot, sign = lu[r, c], 1.0
    if not TINY <= abs(pivot) < math.inf:
        pivot, sign = TINY, 0.0
    inverse = 1.0 / pivot
    lu[r, c] = inverse
    return (-sign if inverse < 0.0 else sign), inverse


@kernel_inline
def _take_off(lu: F2, order: Order, k: int) -> tuple[float, float]:
    """Eliminate with pivot k of an order: multipliers in its column, rank-one update of the rows below.

    Returns the sign of the pivot (0: it vanished), and the largest multiplier.
    """
    r, c, largest = order.row[k], order.col[k], 0.0
    sign, inverse = _pivot(lu, r, c)
    for m in range(order.n_low[k]):
        i = order.low[k, m]
        factor = lu[i, c] * inverse
        lu[i, c] = factor
        largest = larger(largest, abs(factor))
        for s in range(order.n_up[k]):
            j = order.up[k, s]
            lu[i, j] -= factor * lu[r, j]
    return sign, largest


@kernel_bare
def sparse_again(lu: F2, order: Order, first: int, last: int) -> float:
    """Factor in the known order, in place. Returns the product of the pivots' signs, or FAILED with the matrix spoilt."""
    sign = 1.0
    for k in range(first, last):
        one, largest = _take_off(lu, order, k)
        if not largest <= LARGEST:
            return FAILED
        sign *= one
    return sign


@kernel_bare
def sparse_first(lu: F2, full: B2, left: B2, order: Order, first: int, n: int) -> tuple[float, float, int]:
    """Find the order for a matrix whose numbers may differ from 0 where full (n, n) says so (spoilt) and factor it.

    left (2, n or more) : which rows and columns have had no pivot; written.
    Returns the parity of the order, the product of the pivots' signs, and the number of multiplications of an elimination.
    """
    row, col, low, up, n_low, n_up = order
    sign, work = 1.0, 0
    # no row and no column has had its pivot
    for k in range(n):
        left[0, k] = left[1, k] = True
    # pivot by pivot: pattern of its row and column, fill-in, then the elimination itself
    for k in range(first, first + n):
        r, c = _choose(lu, full, left, first, n)
        left[0, r] = left[1, c] = False
        row[k], col[k] = first + r, c
        below, beside = 0, 0
        for j in range(n):
            if left[1, j] and full[r, j]:
                up[k, beside] = j
                beside += 1
        for i in range(n):
            if left[0, i] and full[i, c]:
                low[k, below] = first + i
                below += 1
                for s in range(beside):
                    full[i, up[k, s]] = True
        n_low[k], n_up[k] = below, beside
        work += below * beside
        sign *= _take_off(lu, order, k)[0]
    return _parity(row, col, first, first + n), sign, work


@kernel_bare
def _choose(lu: F2, full: B2, left: B2, first: int, n: int) -> tuple[int, int]:
    """Row and column of the next pivot: the emptiest column left, and in it the emptiest row whose entry is not small."""
    c, fewest = -1, n + 1
    # column with the fewest entries left
    for j in range(n):
        if left[1, j]:
            count = 0
            for i in range(n):
                count += left[0, i] and full[i, j]
            if count < fewest:
                c, fewest = j, count
    largest, r, fewest = 0.0, -1, n + 1
    # largest entry of the column
    for i in range(n):
        if left[0, i] and abs(lu[first + i, c]) > largest:
            largest = abs(lu[first + i, c])
        if left[0, i] and r < 0:
            r = i  # stays where no entry compares, as NaN does not
    # shortest row among entries that are not small
    for i in range(n):
        if left[0, i] and abs(lu[first + i, c]) >= SHARE * largest:
            count = 0
            for j in range(n):
                count += left[1, j] and full[i, j]
            if count < fewest or (count == fewest and abs(lu[first + i, c]) > abs(lu[first + r, c])):
                r, fewest = i, count
    return r, c


@kernel_bare
def _parity(row: U1, col: U1, first: int, last: int) -> float:
    """Sign of the permutation that takes rows to columns."""
    sign = 1.0
    # count of inversions
    for k in range(first, last):
        for m in range(first, k):
            if (row[m] > row[k]) != (col[m] > col[k]):
                sign = -sign
    return sign


@kernel_bare
def sparse_solve(lu: F2, order: Order, first: int, last: int, b: F1, scratch: F1) -> float:
    """Solve A y = b in place, b[:last-first], with the factors in this order. Returns the largest reciprocal of a pivot."""
    row, col, low, up, n_low, n_up = order
    largest = 0.0
    # forward substitution with unit L
    for k in range(first, last):
        value, c = b[row[k] - first], col[k]
        for m in range(n_low[k]):
            i = low[k, m]
            b[i - first] -= lu[i, c] * value
    # back substitution with U
    for k in range(last - 1, first - 1, -1):
        r, c = row[k], col[k]
        value = b[r - first]
        for s in range(n_up[k]):
            j = up[k, s]
            value -= lu[r, j] * scratch[j]
        scratch[c] = value * lu[r, c]
        largest = max(largest, abs(lu[r, c]))
    # solution back to b
    for k in range(last - first):
        b[k] = scratch[k]
    return largest


@kernel_bare
def sparse_solve_transposed(lu: F2, order: Order, first: int, last: int, b: F1, scratch: F1) -> float:
    """Solve A^T y = b in place, b[:last-first], with the factors in this order. Returns the largest reciprocal of a pivot."""
    row, col, low, up, n_low, n_up = order
    largest = 0.0
    # forward substitution with U^T
    for k in range(first, last):
        r, c = row[k], col[k]
        value = b[c] * lu[r, c]
        largest = max(largest, abs(lu[r, c]))
        scratch[r - first] = value
        for s in range(n_up[k]):
            j = up[k, s]
            b[j] -= lu[r, j] * value
    # back substitution with L^T
    for k in range(last - 1, first - 1, -1):
        r, c = row[k], col[k]
        value = scratch[r - first]
        for m in range(n_low[k]):
            i = low[k, m]
            value -= lu[i, c] * scratch[i - first]
        scratch[r - first] = value
    # solution back to b
    for k in range(last - first):
        b[k] = scratch[k]
    return largest
