"""Small dense LU with partial pivoting, in place, one matrix a block of rows of a common array.

Golub & Van Loan (2013), algorithm 3.4.1, with the reciprocals of the pivots on the diagonal. Sizes here are 2 to about 60;
below that LAPACK calls cost more than they save. Column-oriented solves keep the chains of dependent operations short.
The matrix of size n that starts at row `first` is lu[first:first+n, :n]; no slices are taken, since each costs as much as a
row of the solve. Sizes 2, 3 and 9 (a planar dyad, a node on three bars, half an octahedral bay) are compiled with the size
known, which halves their time.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1

__all__ = ["lu_factor", "lu_solve", "lu_solve_transposed"]

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
def _solve(lu: F2, pivot: I1, first: int, n: int, b: F1) -> None:
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
    # back substitution with U, column by column
    for i in range(n - 1, -1, -1):
        value = b[i] * lu[first + i, i]
        b[i] = value
        for j in range(i):
            b[j] -= lu[first + j, i] * value


@kernel_inline
def _solve_transposed(lu: F2, pivot: I1, first: int, n: int, b: F1) -> None:
    # forward substitution with U^T
    for i in range(n):
        value = b[i] * lu[first + i, i]
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
def lu_solve(lu: F2, pivot: I1, first: int, n: int, b: F1) -> None:
    """Solve A y = b in place, with the factors of `lu_factor`; b[:n]."""
    if n == 9:
        _solve(lu, pivot, first, 9, b)
    elif n == 3:
        _solve(lu, pivot, first, 3, b)
    elif n == 2:
        _solve(lu, pivot, first, 2, b)
    else:
        _solve(lu, pivot, first, n, b)


@kernel_inline
def lu_solve_transposed(lu: F2, pivot: I1, first: int, n: int, b: F1) -> None:
    """Solve A^T y = b in place, with the factors of `lu_factor`; b[:n]."""
    if n == 9:
        _solve_transposed(lu, pivot, first, 9, b)
    elif n == 3:
        _solve_transposed(lu, pivot, first, 3, b)
    elif n == 2:
        _solve_transposed(lu, pivot, first, 2, b)
    else:
        _solve_transposed(lu, pivot, first, n, b)
