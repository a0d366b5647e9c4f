"""Blocks of a graph of needs, in an order in which each needs earlier ones only."""

from __future__ import annotations

from heapq import heapify, heappop, heappush
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["blocks_in_order"]


def blocks_in_order(source: NDArray[np.int64], needed: NDArray[np.int64], count: int) -> list[list[int]]:
    """Strongly connected components of the graph "source[k] needs needed[k]" on 0 ... count - 1.

    Each comes after those it needs; among those that may come, the one with the smallest first member comes first, so that
    the order is that of the numbers where they already fit.

    >>> blocks_in_order(np.array([0, 1, 2, 2]), np.array([1, 0, 0, 3]), 4)
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
