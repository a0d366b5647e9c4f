"""Matchings of rows and columns of a sparse pattern.

SciPy's `maximum_bipartite_matching`, and `structural_rank` by it, follow dead ends again and again: their time doubles with
every bay of some chains. Here each dead end is followed once.
"""

from __future__ import annotations

from collections import deque
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["matching", "structural_rank"]


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
