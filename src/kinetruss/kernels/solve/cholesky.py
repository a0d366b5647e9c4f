"""Cholesky factorisation of small dense matrices, and solving with it."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2

__all__ = ["cholesky", "cholesky_solve", "eliminate"]


@kernel_inline
def eliminate(D: F2, n: int, k: int, inverse: float) -> None:
    """Row k of R from row k of what is left, `inverse` the reciprocal of its pivot's root, and what it leaves below."""
    # row k of R
    for j in range(k + 1, n):
        D[k, j] *= inverse
    # rank-one update of the trailing matrix
    for i in range(k + 1, n):
        factor = D[k, i]
        if factor != 0.0:
            for j in range(i, n):
                D[i, j] -= factor * D[k, j]


@kernel_bare
def cholesky(D: F2, n: int) -> bool:
    """D = R^T R in the upper triangle of D[:n, :n], reciprocals of R's diagonal on its diagonal. False if not positive."""
    good = True
    # row by row, outer-product form
    for k in range(n):
        if not 0.0 < D[k, k] < math.inf:
            good = False
            D[k, k] = 1e-300
        inverse = 1.0 / math.sqrt(D[k, k])
        D[k, k] = inverse
        eliminate(D, n, k, inverse)
    return good


@kernel_bare
def cholesky_solve(D: F2, n: int, b: F1) -> None:
    """R^T R y = b in place, with the factor of `cholesky`."""
    # forward substitution R^T z = b
    for i in range(n):
        value = b[i] * D[i, i]
        b[i] = value
        for j in range(i + 1, n):
            b[j] -= D[i, j] * value
    # back substitution R y = z
    for i in range(n - 1, -1, -1):
        value = b[i]
        for j in range(i + 1, n):
            value -= D[i, j] * b[j]
        b[i] = value * D[i, i]
