"""Small dense LU with partial pivoting, in place on a slice of one flat array.

Golub & Van Loan (2013), algorithm 3.4.1. Sizes here are 2 to about 60; below that LAPACK calls cost more than they save.
"""

from __future__ import annotations

import numba
import numpy as np

__all__ = ["lu_factor", "lu_solve", "lu_solve_transposed"]

TINY = 1e-300


@numba.njit(cache=True, inline="never")
def lu_factor(a, pivot, o, n):  # type: ignore[no-untyped-def]
    """Factor the n x n matrix a[o:o+n*n] (row-major) in place; row swaps in pivot[:n].

    Returns the sign of the determinant (0 if a pivot is zero, which is then replaced so that solves stay finite).
    """
    sign = 1.0
    singular = False
    for k in range(n):
        row_k = o + k * n
        best = abs(a[row_k + k])
        at = k
        for i in range(k + 1, n):
            size = abs(a[o + i * n + k])
            if size > best:
                best = size
                at = i
        pivot[k] = at
        if at != k:
            sign = -sign
            row_at = o + at * n
            for j in range(n):
                kept = a[row_k + j]
                a[row_k + j] = a[row_at + j]
                a[row_at + j] = kept
        if best < TINY:
            singular = True
            a[row_k + k] = 1e-30
        if a[row_k + k] < 0:
            sign = -sign
        inverse = 1.0 / a[row_k + k]
        for i in range(k + 1, n):
            row_i = o + i * n
            factor = a[row_i + k]
            if factor != 0.0:
                factor *= inverse
                a[row_i + k] = factor
                for j in range(k + 1, n):
                    a[row_i + j] -= factor * a[row_k + j]
    return 0.0 if singular else sign


@numba.njit(cache=True, inline="never")
def lu_solve(a, pivot, o, n, b):  # type: ignore[no-untyped-def]
    """Solve A y = b in place, with the factors of `lu_factor`; b has length >= n."""
    for k in range(n):
        at = pivot[k]
        if at != k:
            kept = b[k]
            b[k] = b[at]
            b[at] = kept
    for i in range(1, n):
        row = o + i * n
        total = b[i]
        for j in range(i):
            total -= a[row + j] * b[j]
        b[i] = total
    for i in range(n - 1, -1, -1):
        row = o + i * n
        total = b[i]
        for j in range(i + 1, n):
            total -= a[row + j] * b[j]
        b[i] = total / a[row + i]


@numba.njit(cache=True, inline="never")
def lu_solve_transposed(a, pivot, o, n, b):  # type: ignore[no-untyped-def]
    """Solve A^T y = b in place, with the factors of `lu_factor`; b has length >= n."""
    for i in range(n):
        row = o + i * n
        value = b[i] / a[row + i]
        b[i] = value
        for j in range(i + 1, n):
            b[j] -= a[row + j] * value
    for i in range(n - 1, 0, -1):
        row = o + i * n
        value = b[i]
        for j in range(i):
            b[j] -= a[row + j] * value
    for k in range(n - 1, -1, -1):
        at = pivot[k]
        if at != k:
            kept = b[k]
            b[k] = b[at]
            b[at] = kept


def dense(a: np.ndarray) -> np.ndarray:
    """A copy of a square matrix as the flat array these functions work on."""
    return np.ascontiguousarray(a, dtype=np.float64).reshape(-1).copy()
