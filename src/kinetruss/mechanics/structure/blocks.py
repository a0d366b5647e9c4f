"""Block triangular form: rows and columns of a matrix in blocks, each of which depends on earlier ones only."""

from __future__ import annotations

from heapq import heapify, heappop, heappush
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from kinetruss.mechanics.constraints.matchings import matching

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["block_triangular", "pattern_of"]

Matching = tuple["NDArray[np.int64]", "NDArray[np.int64]"]
"""Rows, and the column that each is matched to."""


def pattern_of(touched: list[list[int]], columns: int, weight: NDArray[np.float64] | None = None) -> csr_array:
    """The matrix whose row k has entries in the columns touched[k]: the weight of the column, by default 1."""
    flat = np.array([c for row in touched for c in row], np.int64)
    start = np.cumsum([0, *map(len, touched)])
    return csr_array((np.ones(len(flat)) if weight is None else weight[flat], flat, start), shape=(len(touched), columns))


def block_triangular(pattern: csr_array, *, light: bool = False) -> list[tuple[list[int], list[int]]] | None:
    """Rows and columns of each block; None if the rows cannot all be matched to columns.

    Rows are matched to columns; the strongly connected components of "row needs the row that has this column" are the blocks
    (Dulmage & Mendelsohn, 1958). An unmatched column joins the first block that has an entry in it; columns without entries
    form a last block without rows. So blocks are square if there are as many rows as columns.
    light : match rows to the columns of least weight; else any matching serves, and with as many rows as columns all
        matchings lead to the same blocks.

    >>> block_triangular(pattern_of([[0, 1], [0], [2, 3]], 4))
    [([1], [0]), ([0], [1]), ([2], [2, 3])]
    """
    found = _light_matching(pattern) if light else _matching(pattern)
    if found is None:
        return None
    count, columns = pattern.shape
    row_of = np.full(columns, -1)
    row_of[found[1]] = found[0]
    source, needed = np.repeat(np.arange(count), np.diff(pattern.indptr)), row_of[pattern.indices]
    matched = needed >= 0
    flat = pattern.indices.tolist()
    touched = [flat[a:b] for a, b in pairwise(pattern.indptr.tolist())]
    free = [True] * columns
    blocks = []
    for rows in _in_order(source[matched], needed[matched], count):
        own = sorted({c for r in rows for c in touched[r] if free[c]})
        for c in own:
            free[c] = False
        blocks.append((rows, own))
    left = [c for c in range(columns) if free[c]]
    return [*blocks, ([], left)] if left else blocks


def _matching(pattern: csr_array) -> Matching | None:
    column = matching(pattern)
    return None if np.any(column < 0) else (np.arange(pattern.shape[0]), column)


def _light_matching(pattern: csr_array) -> Matching | None:
    """The matching whose columns have the least sum of weights: the lightest columns have precedence."""
    weight = np.full(pattern.shape[1], np.inf)
    weight[pattern.indices] = pattern.data
    row = matching(csr_array(pattern.T), np.argsort(weight, kind="stable"))
    columns = np.flatnonzero(row >= 0)
    return (row[columns], columns) if len(columns) == pattern.shape[0] else None


def _in_order(source: NDArray[np.int64], needed: NDArray[np.int64], count: int) -> list[list[int]]:
    """Strongly connected components of the graph "source[k] needs needed[k]" on 0 ... count - 1.

    Each component comes after those it needs. Of several possible ones, that with the smallest first member comes first, so
    that the order of the numbers is kept if it is valid.

    >>> _in_order(np.array([0, 1, 2, 2]), np.array([1, 0, 0, 3]), 4)
    [[0, 1], [3], [2]]
    """
    graph = csr_array((np.ones(len(source)), (source, needed)), shape=(count, count))
    blocks, label = connected_components(graph, directed=True, connection="strong")
    needs: list[set[int]] = [set() for _ in range(blocks)]
    feeds: list[set[int]] = [set() for _ in range(blocks)]
    for a, b in zip(label[source], label[needed], strict=True):
        if a != b:
            needs[a].add(int(b))
            feeds[b].add(int(a))
    members: list[list[int]] = [[] for _ in range(blocks)]
    for one, b in enumerate(label):
        members[b].append(one)
    ready = [(members[b][0], b) for b in range(blocks) if not needs[b]]
    heapify(ready)
    order = []
    while ready:
        _, b = heappop(ready)
        order.append(members[b])
        for later in feeds[b]:
            needs[later].discard(b)
            if not needs[later]:
                heappush(ready, (members[later][0], later))
    return order
