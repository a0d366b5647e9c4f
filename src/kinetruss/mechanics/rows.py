"""Rows that hold a structure, with their derivatives along a motion, what they allow, and sparse factors."""

from __future__ import annotations

from collections import deque
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csc_array, csr_array
from scipy.sparse.linalg import splu

from kinetruss.elements.local_axes import turned
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics.measures import measure_turning
from kinetruss.mechanics.row_gradients import (
    RANK_TOLERANCE,
    assembled,
    constraint_jacobian,
    direction_rates,
    row_ends,
    row_scales,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


SYMMETRIC: dict[str, Any] = {"options": {"SymmetricMode": True}}
"""Options of SuperLU for matrices with a symmetric pattern: pivots on the diagonal are tried first."""


def factors_of(matrix: Any, **options: Any) -> Any:
    """Factors by SuperLU (Demmel et al., 1999), with `solve`, `U` and permutations; None if the matrix is singular.

    A matrix whose rows and columns cannot be matched is refused first: in symmetric mode SuperLU reads and writes outside
    its memory if a column has no entries left.
    """
    square = csc_array(matrix)
    if not matched(square, symmetric=options.get("options") == SYMMETRIC["options"]):
        return None
    try:
        return splu(square, **options)
    except RuntimeError:
        return None


def diagonal_factors(matrix: Any) -> Any:
    """`factors_of` a matrix with a symmetric pattern, pivots on the diagonal, in an order of minimum degree."""
    return factors_of(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, **SYMMETRIC)


def matched(square: Any, *, symmetric: bool) -> bool:
    """Whether every row of a square matrix has a column of its own in which it has an entry.

    With a symmetric pattern, rows with a diagonal entry need no search. If all other rows are matched, the matching
    consists of cycles and of paths that end at such a row. The rows of a path with an even number are matched in pairs; of
    a path with an odd number, in pairs and by the diagonal entry at its end. This takes a hundredth of the work for the
    matrices of statics.
    """
    if not symmetric:
        return structural_rank(square) == int(square.shape[0])
    bare = square.diagonal() == 0.0
    return bool(not bare.any() or structural_rank(square.tocsr()[bare]) == bare.sum())


# Matchings of rows and columns of a sparse pattern.
#
# SciPy's `maximum_bipartite_matching`, and `structural_rank` by it, follow dead ends again and again: their time doubles with
# every bay of some chains. Here each dead end is followed once.


def matching(pattern: csr_array, order: NDArray[np.int64] | None = None) -> NDArray[np.int64]:
    """The column (rows,) that each row is matched to, -1 where there is none; as many rows as possible are matched.

    Sets of rows that can be matched are the independent sets of a matroid (Edmonds & Fulkerson, 1965): each row, in the given
    order, is taken where a path of exchanges leads to a column that is free, so that the first rows have precedence. A search
    without success has reached columns whose rows all keep theirs, so no later one enters them.

    >>> matching(csr_array([[1, 1, 0], [1, 0, 0], [1, 1, 0]])).tolist()
    [1, 0, -1]
    """
    rows, columns = pattern.shape
    flat = pattern.indices.tolist()
    columns_of = [flat[a:b] for a, b in pairwise(pattern.indptr.tolist())]
    row_of, found, closed = [-1] * columns, [-1] * rows, [False] * columns
    for row in range(rows) if order is None else order.tolist():
        end = next((column for column in columns_of[row] if row_of[column] < 0 and not closed[column]), -1)
        reached = {end: row} if end >= 0 else {}  # column, and the row from which it was reached
        waiting = deque([row])
        while waiting and end < 0:
            at = waiting.popleft()  # the shortest path: it stays near the row
            for column in columns_of[at]:
                if closed[column] or column in reached:
                    continue
                reached[column] = at
                if row_of[column] < 0:
                    end = column
                    break
                waiting.append(row_of[column])
        if end < 0:
            for column in reached:
                closed[column] = True
        while end >= 0:
            at = reached[end]
            before, found[at], row_of[end] = found[at], end, at
            end = before
    return np.array(found, np.int64)


def structural_rank(pattern: Any) -> int:
    """The largest rank of matrices with this pattern."""
    pattern = csr_array(pattern)
    narrow = pattern if pattern.shape[0] <= pattern.shape[1] else csr_array(pattern.T)
    return _rank(narrow.shape, narrow.indptr.tobytes(), narrow.indices.tobytes(), narrow.indices.dtype.char)


@lru_cache(maxsize=8)
def _rank(shape: tuple[int, int], start: bytes, flat: bytes, kind: str) -> int:
    """`structural_rank` by the arrays of the pattern: a matrix is factored many times with other values."""
    indices, indptr = np.frombuffer(flat, kind), np.frombuffer(start, kind)
    return int(np.sum(matching(csr_array((np.ones(len(indices)), indices, indptr), shape=shape)) >= 0))


# What rows allow to change, as an orthonormal basis by singular values.


def null_basis(J: Any, tolerance: float = RANK_TOLERANCE) -> NDArray[np.float64]:
    """Orthonormal basis (f, k) of the changes that sparse J (rows, f) allows.

    Singular values up to `tolerance` times the largest count as zero.
    """
    from scipy.linalg import svd

    if not J.shape[0]:
        return np.eye(J.shape[1])
    dense = J.toarray()
    try:
        _, sizes, right = svd(dense)
    except np.linalg.LinAlgError:  # divide and conquer does not always converge
        _, sizes, right = svd(dense, lapack_driver="gesvd")
    rank = int(np.sum(sizes > tolerance * sizes.max(initial=0.0)))
    return np.asarray(right[rank:].T)


# Rows that hold a structure, with their first and second derivatives along a motion.
#
# A coordinate s of a member (length or angle) with end difference d keeps g . dd = r ds for small changes at one instant, and
# along a motion
#
#     g . dd'  = r ds'  + r' ds - g' . dd
#     g . dd'' = r ds'' + 2 r' ds' + r'' ds - 2 g' . dd' - g'' . dd,
#
# with g = d/L, g' = d'/L, r = 1 of a length (from the quadratic form |d|^2 = s^2, whose Hessian is constant), and
# g = n, g' = -w u, r = L of an angle (from n(s) . d = 0; w, w' its rates). Exact to first order in the change, for any motion.


class Derivatives(NamedTuple):
    """Rows g, g', g'' (k, 3 n) sparse, and r, r', r'' (k, 3) of k coordinates."""

    g: tuple[Any, Any, Any]
    r: NDArray[np.float64]


def row_derivatives(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None, a: NDArray[np.float64] | None = None
) -> Derivatives:
    """Derivatives of all rows of a system at x, v, a (n, 3); those of sums times their scale: gradients are of one size."""
    first, r = constraint_jacobian(system, x), np.zeros((len(system.row_member), 3))
    r[:, 0] = row_scales(system, x)
    if v is None and a is None:
        still = csr_array(first.shape)
        return Derivatives(g=(first, still, still), r=r)
    # of lengths: g' = d'/L, r' = L'/L
    d, dv, da = (np.zeros((len(r), 3)) if y is None else row_ends(system, y) for y in (x, v, a))
    (L, Ld, Ldd), (u, ud, udd) = direction_rates(d, dv, da)
    g1, g2 = dv / L, da / L
    r[:, 1:] = np.hstack([Ld, Ldd]) / L
    if (angle := system.row_kind == ANGLE).any():
        # of angles: g' = -w u, r'' = L'' + L w^2
        w, wd = (np.sum(turned(u) * one, axis=1, keepdims=True) for one in (ud, udd))
        g1[angle], g2[angle] = (-w * u)[angle], (-wd * u)[angle]
        r[angle, 1:] = np.hstack([Ld, Ldd + L * w**2])[angle]
    # of sums: H v and its rate
    measures = system.row_measure[system.sums]
    r[system.sums, 1:] = 0.0
    turning = [[system.measure_scale[m] * one for one in measure_turning(system, m, x, v, a)] for m in measures]
    later = [assembled(system, g, [both[k] for both in turning]) for k, g in enumerate((g1, g2))]
    return Derivatives(g=(first, later[0], later[1]), r=r)
