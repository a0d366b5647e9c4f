"""The pattern of the matrix of the implicit methods: an order of nodes and rows, the places of all entries, constant parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import reverse_cuthill_mckee

from kinetruss.mechanics.assembly.matrices import mass_matrix

if TYPE_CHECKING:
    from kinetruss.mechanics import System

__all__ = ["tangent_record"]

Ints = NDArray[np.int64]
REGULAR = 1e-10
"""Regularisation delta of the rows, and of nodes without mass, as a fraction of the largest entry."""


def tangent_record(eq: Any, system: System) -> dict[str, NDArray[Any]]:
    """What `kernels.steps.tangent` needs: pattern of L, places of blocks, constant part of the matrix."""
    place, row_place = _order(eq)
    n = place.size + row_place.size
    mass = mass_matrix(system, system.x0)[eq.free][:, eq.free].tocoo()
    ends = [np.column_stack([eq.law_A, eq.law_B]), np.column_stack([eq.A, eq.B]), np.column_stack([eq.edge_A, eq.edge_B])]
    where = np.full(eq.local.size + 1, -1, np.int64)
    where[eq.free] = place
    members = [where[(pair[:, :, None] + np.arange(3)).reshape(-1, 6)] for pair in ends]
    members[1][eq.sum_row] = -1
    members.append(_pins(eq, where))
    members.append(_springs(eq, where))
    pairs = [_pairs(m) for m in members]
    terms = int(eq.sum_ptr[-1]) if len(eq.sum_ptr) else 0
    sums = where[(eq.term_at[:terms, :3, None] + np.arange(3)).reshape(-1, 9)]
    sum_row = np.repeat(row_place[np.repeat(eq.sum_row, np.diff(eq.sum_ptr))], 9)
    rows = np.repeat(row_place, 6)
    i = np.concatenate([place[mass.row], *(p[0] for p in pairs), rows, sum_row])
    j = np.concatenate([place[mass.col], *(p[1] for p in pairs), members[1].reshape(-1), sums.reshape(-1)])
    ptr, below, target = _pattern(n, i, j)
    find = _finder(ptr, below)
    base = np.zeros(below.size + n + 1)
    # M, the lower triangle, and the small diagonal that keeps pivots off zero
    np.add.at(base, find(place[mass.row], place[mass.col]), np.where(mass.row >= mass.col, mass.data, 0.0))
    scale = max(float(np.abs(mass.data).max(initial=0.0)), 1e-300)
    base[below.size + place] += REGULAR * scale
    base[below.size + row_place] = -REGULAR / scale
    # places of square blocks: bars with a law, rows, edges, pins, springs
    blocks = [find(*pair).reshape(len(m), m.shape[1] ** 2) for m, pair in zip(members, pairs, strict=True)]
    return {
        "ptr": ptr,
        "below": below,
        "target": target,
        "place": place,
        "row_place": row_place,
        "law_at": blocks[0],
        "row_at": blocks[1],
        "sum_at": find(sum_row, sums.reshape(-1)).reshape(-1, 9),
        "gradient_at": find(rows, members[1].reshape(-1)).reshape(-1, 6),
        "base": base,
        "values": np.zeros_like(base),
        "space": np.zeros(n),
        "edge_at": blocks[2],
        "pin_at": blocks[3],
        "spring_at": blocks[4],
    }


def _pins(eq: Any, where: Ints) -> Ints:
    """Places (pairs, 6) of the coordinates of pins with friction and of the two far ends; the ground has none."""
    ends = np.column_stack([eq.pin_P, eq.pin_A, np.where(eq.pin_B == eq.pin_P, -1, eq.pin_B)])
    flat = np.where(ends[:, :, None] < 0, -1, ends[:, :, None] + np.arange(2))
    return where[flat.reshape(-1, 6)]


def _springs(eq: Any, where: Ints) -> Ints:
    """Places (springs, w) of the coordinates of the nodes of springs, ascending; those that have fewer end with -1."""
    nodes = [np.unique(eq.spring_at[eq.spring_ptr[k] : eq.spring_ptr[k + 1], :3]) for k in range(len(eq.spring))]
    found = np.full((len(nodes), max(map(len, nodes), default=0), 3), -1, np.int64)
    for k, own in enumerate(nodes):
        found[k, : len(own)] = where[own[:, None] + np.arange(3)]
    return found.reshape(len(nodes), found.shape[1] * 3)


def _order(eq: Any) -> tuple[Ints, Ints]:
    """Places of free coordinates and of rows: nodes by reverse Cuthill-McKee, each row after the later of its free nodes."""
    nodes = eq.local.size // 3
    one, other = (eq.spring_at[:, [0, 0]].reshape(-1), eq.spring_at[:, 1:3].reshape(-1))
    A = np.concatenate([eq.A, eq.law_A, eq.pair_A, eq.varying_A, eq.edge_A, one]) // 3
    B = np.concatenate([eq.B, eq.law_B, eq.pair_B, eq.varying_B, eq.edge_B, other]) // 3
    graph = csr_array((np.ones(2 * A.size), (np.concatenate([A, B]), np.concatenate([B, A]))), shape=(nodes, nodes))
    rank = np.empty(nodes, np.int64)
    # nodes in a narrow band, each row behind the last of its nodes
    rank[reverse_cuthill_mckee(csr_array(graph), symmetric_mode=True)] = np.arange(nodes)
    has = np.zeros(nodes, np.bool_)
    has[eq.free // 3] = True
    seen = np.where(has, rank, -1)
    last = np.maximum(seen[eq.A // 3], seen[eq.B // 3])
    for j, r in enumerate(eq.sum_row):
        last[r] = seen[eq.term_at[eq.sum_ptr[j] : eq.sum_ptr[j + 1], :3] // 3].max()
    keys = np.concatenate([rank[eq.free // 3] * 2, last * 2 + 1])
    places = np.empty(keys.size, np.int64)
    places[np.argsort(keys, kind="stable")] = np.arange(keys.size)
    return places[: eq.free.size], places[eq.free.size :]


def _pairs(member: Ints) -> tuple[Ints, Ints]:
    """All pairs of places of a member's coordinates, -1 where prescribed."""
    width = member.shape[1]
    return np.repeat(member, width, 1).reshape(-1), np.tile(member, width).reshape(-1)


def _pattern(n: int, i: Ints, j: Ints) -> tuple[Ints, Ints, Ints]:
    """Columns of L below the diagonal, and where each product of two entries of a column goes."""
    from kinetruss.kernels.solve.kkt_sparse import sparse_targets, sparse_tree

    good = (i >= 0) & (j >= 0) & (i != j)
    low, high = np.minimum(i, j)[good], np.maximum(i, j)[good]
    upper = csr_array(coo_array((np.ones(low.size), (high, low)), shape=(n, n)))
    upper.sort_indices()
    ptr, row = upper.indptr.astype(np.int64), upper.indices.astype(np.int64)
    parent, flag, count = np.zeros(n, np.int64), np.zeros(n, np.int64), np.zeros(n, np.int64)
    # two passes: column counts of L, then its rows
    sparse_tree(n, ptr, row, parent, flag, count, np.zeros(0, np.int64))
    starts = np.concatenate([[0], np.cumsum(count)]).astype(np.int64)
    below = np.zeros(int(starts[-1]), np.int64)
    sparse_tree(n, ptr, row, parent, flag, starts[:-1].copy(), below)
    target = np.zeros(int(np.sum(count * (count - 1) // 2)), np.int64)
    sparse_targets(starts, below, target)
    return starts, below, target


def _finder(ptr: Ints, below: Ints) -> Any:
    """A function from two places to the place of their entry: below or on the diagonal, or a place that is never read."""
    n = ptr.size - 1
    keys = np.repeat(np.arange(n), np.diff(ptr)) * n + below

    def find(i: Ints, j: Ints) -> Ints:
        low, high = np.minimum(i, j), np.maximum(i, j)
        at = np.searchsorted(keys, low * n + high)
        at = np.where(low == high, below.size + high, np.minimum(at, max(keys.size - 1, 0)))
        return np.where(low < 0, below.size + n, at)

    return find
