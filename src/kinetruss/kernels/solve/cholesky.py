"""Cholesky factorisation of dense matrices: small ones, and Schur complements some of whose rows depend on others."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, I1
from kinetruss.kernels.structure.equations import Workspace


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
def forward(R: F2, n: int, b: F1) -> None:
    """R^T y = b in place, with the factors of `cholesky` or `drop_cholesky`; zero at dependent rows."""
    for k in range(n):
        value = b[k] * R[k, k]
        b[k] = value
        if value != 0.0:
            for j in range(k + 1, n):
                b[j] -= R[k, j] * value


@kernel_bare
def backward(R: F2, n: int, b: F1) -> None:
    """R y = b in place, first n rows; zero at dependent rows."""
    for k in range(n - 1, -1, -1):
        value = b[k]
        if R[k, k] != 0.0:
            for j in range(k + 1, n):
                value -= R[k, j] * b[j]
        b[k] = value * R[k, k]


@kernel_bare
def cholesky_solve(R: F2, n: int, b: F1) -> None:
    """R^T R y = b in place."""
    forward(R, n, b)
    backward(R, n, b)


# S = R^T R of a Schur complement S = J M^-1 J^T some of whose rows depend on others.
#
# Overconstrained loops (Bennett, Bricard) have rows that others determine only where the loop is closed: a deviation e of the
# stages of an integrator, or of an iterate of Newton's method, leaves them a pivot of the order e^2, and what they ask for at
# second order differs by as much. Such a row must be dropped whatever its pivot is. How many rows are redundant is known from
# the start; which, no choice made once can tell: along the motion the rows kept may come to depend on each other while the
# whole set keeps its rank. So the largest pivot left goes first, until as many rows are kept as are independent.

DROP = 1e-11
"""Pivot, as a share of its diagonal, below which a row depends on those before it."""


@kernel_bare
def drop_cholesky(S: F2, diagonal: F1, redundant: I1, sure: bool, dependent: I1, order: I1) -> float:
    """S = R^T R in the upper triangle of S (n, n), reciprocals of R's diagonal on its diagonal; dependent rows are marked.

    diagonal (n,) : scratch. redundant : as many rows are redundant as are marked here; sure : wherever the motion leads, so
    that no more are kept. order (n,) : the row at each place of R. Returns the square root of the smallest ratio of a pivot to
    its diagonal, over rows that are not redundant.
    """
    n, smallest, wanted = S.shape[0], 1.0, S.shape[0]
    # diagonal of S before elimination, and the number of independent rows
    for k in range(n):
        diagonal[k] = S[k, k]
        order[k] = k
        wanted -= redundant[k]
    # outer-product form with diagonal pivoting; a dependent row gets a zero pivot
    for k in range(n):
        if wanted < n:
            _bring_largest(S, diagonal, order, k)
        ratio = S[k, k] / diagonal[k] if diagonal[k] > 0.0 else 0.0
        if k < wanted and not ratio >= smallest:
            smallest = ratio if ratio > 0.0 else 0.0
        if not ratio > DROP or (sure and k >= wanted):
            dependent[k] = 1
            S[k, k] = 0.0
            continue
        dependent[k] = 0
        inverse = 1.0 / math.sqrt(S[k, k])
        S[k, k] = inverse
        eliminate(S, n, k, inverse)
    return math.sqrt(smallest)


@kernel_bare
def _bring_largest(S: F2, diagonal: F1, order: I1, k: int) -> None:
    """Swap the row with the largest share of its diagonal left to place k; the first of equal ones."""
    n, best, most = S.shape[0], k, -1.0
    # largest pivot in parts of its original diagonal
    for j in range(k, n):
        ratio = S[j, j] / diagonal[j] if diagonal[j] > 0.0 else 0.0
        if ratio > most * (1.0 + 1e-9):
            best, most = j, ratio
    if best == k:
        return
    order[k], order[best] = order[best], order[k]
    diagonal[k], diagonal[best] = diagonal[best], diagonal[k]
    S[k, k], S[best, best] = S[best, best], S[k, k]
    # symmetric swap of rows and columns k and best in the upper triangle: above both,
    for i in range(k):
        S[i, k], S[i, best] = S[i, best], S[i, k]
    # between them,
    for i in range(k + 1, best):
        S[k, i], S[i, best] = S[i, best], S[k, i]
    # and to the right of both
    for j in range(best + 1, n):
        S[k, j], S[best, j] = S[best, j], S[k, j]


@kernel_bare
def share(ws: Workspace, weight: F1, N: F1) -> None:
    """Share N, by place, over the states of self-stress: for each dependent row one, 1 there and -R^-1 R_k at the kept rows."""
    S, dependent, order = ws.S, ws.dependent, ws.order
    states, square, z = ws.states, ws.matrix, ws.z
    n, count = S.shape[0], 0
    # null vectors of J^T by dependent rows: states of self-stress
    for k in range(n):
        if dependent[k]:
            for j in range(n):
                states[count, j] = -S[j, k] if j < k and not dependent[j] else 0.0
            backward(S, k, states[count])
            states[count, k] = 1.0
            count += 1
    # normal equations of min sum w (N + S z)^2: (S^T W S) z = -S^T W N
    for i in range(count):
        z[i] = 0.0
        for k in range(n):
            z[i] -= states[i, k] * weight[order[k]] * N[k]
        for j in range(count):
            square[i, j] = 0.0
            for k in range(n):
                square[i, j] += states[i, k] * weight[order[k]] * states[j, k]
    cholesky(square, count)
    cholesky_solve(square, count, z)
    # N + S z
    for i in range(count):
        for k in range(n):
            N[k] += states[i, k] * z[i]
