"""Small dense LU with partial pivoting, in place on a slice of one flat array.

Golub & Van Loan (2013), algorithm 3.4.1, with the reciprocals of the pivots on the diagonal. Sizes here are 2 to about 60;
below that LAPACK calls cost more than they save. Column-oriented solves keep the chains of dependent operations short.
"""

from __future__ import annotations

from kinetruss.kernels._jit import kernel

__all__ = ["lu_factor", "lu_solve", "lu_solve_transposed"]

TINY = 1e-100


@kernel
def lu_factor(a, pivot, o, first, n):  # type: ignore[no-untyped-def]
    """Factor the n x n matrix a[o:o+n*n] (row-major) in place; row swaps in pivot[first:first+n].

    Returns the sign of the determinant (0 if a pivot is zero, which is then replaced so that solves stay finite).
    """
    A = a[o : o + n * n].reshape(n, n)
    sign = 1.0
    for k in range(n):
        best = abs(A[k, k])
        at = k
        for i in range(k + 1, n):
            size = abs(A[i, k])
            if size > best:
                best = size
                at = i
        pivot[first + k] = at
        if at != k:
            sign = -sign
            for j in range(n):
                kept = A[k, j]
                A[k, j] = A[at, j]
                A[at, j] = kept
        if best < TINY:
            A[k, k] = TINY
            sign = 0.0
        inverse = 1.0 / A[k, k]
        if inverse < 0:
            sign = -sign
        A[k, k] = inverse
        for i in range(k + 1, n):
            factor = A[i, k]
            if factor != 0.0:
                factor *= inverse
                A[i, k] = factor
                for j in range(k + 1, n):
                    A[i, j] -= factor * A[k, j]
    return sign


@kernel
def lu_solve(a, pivot, o, first, n, b):  # type: ignore[no-untyped-def]
    """Solve A y = b in place, with the factors of `lu_factor`; b[:n]."""
    A = a[o : o + n * n].reshape(n, n)
    for k in range(n):
        at = pivot[first + k]
        kept = b[at]
        b[at] = b[k]
        b[k] = kept
    for i in range(n - 1):
        value = b[i]
        for j in range(i + 1, n):
            b[j] -= A[j, i] * value
    for i in range(n - 1, -1, -1):
        value = b[i] * A[i, i]
        b[i] = value
        for j in range(i):
            b[j] -= A[j, i] * value


@kernel
def lu_solve_transposed(a, pivot, o, first, n, b):  # type: ignore[no-untyped-def]
    """Solve A^T y = b in place, with the factors of `lu_factor`; b[:n]."""
    A = a[o : o + n * n].reshape(n, n)
    for i in range(n):
        value = b[i] * A[i, i]
        b[i] = value
        for j in range(i + 1, n):
            b[j] -= A[i, j] * value
    for i in range(n - 1, 0, -1):
        value = b[i]
        for j in range(i):
            b[j] -= A[i, j] * value
    for k in range(n - 1, -1, -1):
        at = pivot[first + k]
        kept = b[at]
        b[at] = b[k]
        b[k] = kept
