"""Patterns of the sparse solver and of the implicit methods: order, elimination tree, place of every entry."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csc_array, csr_array
from scipy.sparse.csgraph import reverse_cuthill_mckee
from scipy.sparse.linalg import spilu

from kinetruss.elements.kinds import present
from kinetruss.kernels.solve.ldl import COORDINATE, ROW, ldl_pattern, ldl_targets
from kinetruss.mechanics.matrices import mass_matrix
from kinetruss.mechanics.system import System


def sparse_arrays(
    system: System,
    masses: dict[str, Any],
    augmented_row: NDArray[np.int64],
    shared: bool,
) -> dict[str, Any]:
    """Arrays of `Equations` for rows as in the system.

    augmented_row : rows that are added to nodes without mass. shared : some are redundant, with places to share their forces.
    """
    nf, r = len(system.free), len(system.row_member)
    local, pairs, sums = _coordinates(system)
    touched = _widened(pairs, system.sums, sums)
    varying, six = _six(local, masses["varying_A"], masses["varying_B"]), pairs[augmented_row]
    i, j, value = _constant(local, masses)
    bars = pairs if shared else np.zeros((0, 6), np.int64)
    apart = [_pairs(touched[system.sums])] if len(sums) and shared else []
    inner = [(i, j), _pairs(varying), _pairs(six), _pairs(bars), *apart]
    pattern = [*inner, _rows(touched, nf)]
    place, ptr, below, skyline = _best_order(touched, inner, pattern, nf, r)
    target = np.zeros(0, np.int64) if skyline else _targets(ptr, below)
    at = _Finder(ptr, below)
    nowhere = len(below) + nf + r
    base = np.zeros(nowhere + 1)
    np.add.at(base, at(place[i], place[j]), value)
    rows = np.where(pairs >= 0, at(place[np.maximum(pairs, 0)], place[nf + np.arange(r)][:, None]), nowhere)
    own = [
        np.where(one >= 0, at(place[np.maximum(one, 0)], place[nf + k]), nowhere)
        for one, k in zip(sums, system.sums, strict=True)
    ]
    sort = np.full(nf + r, COORDINATE, np.int64)
    sort[place[nf:]] = ROW
    return {
        "sparse_ptr": ptr,
        "sparse_below": below,
        "sparse_target": target,
        "sparse_entry": rows.reshape(-1, 6),
        "sparse_block": _block_places(varying, place, at, nowhere),
        "augmented_block": _block_places(six, place, at, nowhere),
        "sparse_bar_block": _block_places(bars, place, at, nowhere),
        "sparse_sort": sort,
        "sparse_place": place[:nf],
        "sparse_row_place": place[nf:],
        "sparse_base": base,
        "sparse_sum_entry": np.concatenate([*own, np.zeros((0, 12), np.int64)]).astype(np.int64),
    }


def _coordinates(system: System) -> tuple[NDArray[np.int64], NDArray[np.int64], list[NDArray[np.int64]]]:
    """Place of every coordinate among the free ones, and places that the rows of node pairs (rows, 6) and the terms of sums
    depend on; -1 if prescribed.
    """
    local = np.full(system.x0.size, -1, np.int64)
    local[system.free] = np.arange(len(system.free))
    A, B = (3 * end[system.row_member].astype(np.int64) for end in (system.p, system.q))
    pairs = _six(local, A, B)
    pairs[system.sums] = -1
    nodes = [system.term_at[range(*system.measure_ptr[m : m + 2])] for m in system.row_measure[system.sums]]
    return local, pairs, [local[(at[:, :, None] + np.arange(3)).reshape(-1, 12)] for at in nodes]


def _best_order(
    touched: NDArray[np.int64], inner: list[Any], pattern: list[Any], nf: int, r: int
) -> tuple[Any, Any, Any, bool]:
    """Places, column pointers and rows of L, and whether it is a skyline: the order with the least estimated time.

    Minimum degree gives the least fill. A skyline (Cuthill & McKee, 1969) has more fill, but no gaps, so that it works on
    adjacent memory.
    """
    i, j = (np.concatenate([p[end] for p in [*inner, _pairs(touched)]]) for end in (0, 1))
    ranks = [_order(i, j, nf), *_narrow(i, j, nf)]
    found = []
    for rank in ranks:
        place = _places(rank, touched, r)
        ptr, below = _symbolic(place, pattern, nf + r)
        wide = np.diff(ptr).astype(float)
        reach = _reach(ptr, below)
        full = (reach - np.arange(nf + r)).astype(float)
        found.append((1.7 * (wide * (wide - 1) / 2).sum() + 5.0 * wide.sum(), False, place, ptr, below))
        found.append((0.35 * (full * (full - 1) / 2).sum() + 6.0 * full.sum(), True, place, ptr, reach))
    _, skyline, place, ptr, below = min(found, key=lambda one: one[0])
    if skyline:
        ptr = np.concatenate([[0], np.cumsum(below - np.arange(nf + r))]).astype(np.int64)
        below = np.arange(ptr[-1]) - np.repeat(ptr[:-1] - np.arange(nf + r) - 1, np.diff(ptr))
    return place, ptr, below, skyline


def _narrow(i: NDArray[np.int64], j: NDArray[np.int64], nf: int) -> list[NDArray[np.float64]]:
    """Ranks of the coordinates by reverse Cuthill-McKee, from either end."""
    graph = csr_array((np.ones(2 * len(i)), (np.concatenate([i, j]), np.concatenate([j, i]))), shape=(nf, nf))
    rank = np.empty(nf)
    rank[reverse_cuthill_mckee(graph, symmetric_mode=True)] = np.arange(nf)
    return [rank, nf - 1 - rank]


def _reach(ptr: NDArray[np.int64], below: NDArray[np.int64]) -> NDArray[np.int64]:
    """The last row of each column of the skyline that holds L."""
    last = np.arange(len(ptr) - 1)
    some = ptr[1:] > ptr[:-1]
    last[some] = below[ptr[1:][some] - 1]
    found: NDArray[np.int64] = np.maximum.accumulate(last)
    return found


def _six(local: NDArray[np.int64], A: NDArray[np.int64], B: NDArray[np.int64]) -> NDArray[np.int64]:
    """Places (k, 6) of the coordinates of two nodes among the free ones, -1 where prescribed."""
    found: NDArray[np.int64] = local[
        np.concatenate([A[:, None] + np.arange(3), B[:, None] + np.arange(3)], axis=1).reshape(-1, 6)
    ]
    return found


def _constant(local: NDArray[np.int64], masses: dict[str, Any]) -> tuple[Any, Any, Any]:
    """Lower triangle of the constant mass among free coordinates, as triplets i >= j; entries may repeat."""
    A, B, mass, lump = masses["pair_A"], masses["pair_B"], masses["pair"], masses["lump"] + masses["share"]
    axis = np.arange(3)
    flat = np.arange(3 * len(lump))
    parts = [(flat, flat, np.repeat(lump, 3))]
    for c in axis:
        parts += [(A + c, A + c, mass[:, 0]), (B + c, B + c, mass[:, 2]), (A + c, B + c, mass[:, 1])]
    skew = np.flatnonzero(mass[:, 3])
    parts += [(A[skew], B[skew] + 1, -mass[skew, 3]), (A[skew] + 1, B[skew], mass[skew, 3])]
    i, j, value = (np.concatenate([part[k] for part in parts]) for k in range(3))
    i, j = local[i.astype(np.int64)], local[j.astype(np.int64)]
    some = (i >= 0) & (j >= 0)
    return np.maximum(i, j)[some], np.minimum(i, j)[some], value[some]


def _widened(pairs: NDArray[np.int64], rows: NDArray[np.int64], sums: list[NDArray[np.int64]]) -> NDArray[np.int64]:
    """Places of the coordinates that rows depend on: those of two nodes, or all those of a sum; -1 if there is none."""
    width = max([6, *(one.size for one in sums)])
    found = np.full((len(pairs), width), -1, np.int64)
    found[:, :6] = pairs
    for r, one in zip(rows, sums, strict=True):
        # each place once: duplicate entries of a row would be counted twice
        own = np.unique(one[one >= 0])
        found[r, : len(own)] = own
    return found


def _pairs(six: NDArray[np.int64]) -> tuple[Any, Any]:
    """All pairs of free coordinates within each block."""
    i, j = np.tril_indices(six.shape[1])
    a, b = six[:, i].reshape(-1), six[:, j].reshape(-1)
    some = (a >= 0) & (b >= 0)
    return np.maximum(a, b)[some], np.minimum(a, b)[some]


def _rows(touched: NDArray[np.int64], nf: int) -> tuple[Any, Any]:
    k = np.repeat(np.arange(len(touched)), touched.shape[1])
    flat = touched.reshape(-1)
    return nf + k[flat >= 0], flat[flat >= 0]


def _order(i: NDArray[np.int64], j: NDArray[np.int64], n: int) -> NDArray[np.float64]:
    """Rank of each coordinate by multiple minimum degree (Liu, 1985), as SuperLU computes it."""
    ones = csc_array((np.ones(2 * len(i)), (np.concatenate([i, j]), np.concatenate([j, i]))), shape=(n, n))
    ones.sum_duplicates()
    ones.data[:] = 1.0
    # any values of this pattern serve: those off a dominant diagonal are dropped, so that only the order costs time
    matrix = ones + csc_array((ones.sum(axis=0) + 1.0, (np.arange(n), np.arange(n))), shape=(n, n))
    kept = {"drop_tol": 1.0, "fill_factor": 1.0, "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    rank: NDArray[np.float64] = spilu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", **kept).perm_c.astype(float)
    return rank


def _places(rank: NDArray[np.float64], touched: NDArray[np.int64], r: int) -> NDArray[np.int64]:
    """Place of each unknown: a row comes after all coordinates that it depends on, so that its pivot is zero only if the
    row depends on the rows before it.
    """
    nf = len(rank)
    behind = np.where(touched >= 0, rank[np.maximum(touched, 0)], -1.0).max(axis=1, initial=-1.0) if nf else np.zeros(r)
    place = np.empty(nf + r, np.int64)
    place[np.argsort(np.concatenate([rank, behind + 0.5]), kind="stable")] = np.arange(nf + r)
    return place


def _symbolic(place: NDArray[np.int64], pattern: list[tuple[Any, Any]], n: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Column pointers and rows of L."""
    i, j = place[np.concatenate([p[0] for p in pattern])], place[np.concatenate([p[1] for p in pattern])]
    high, low = np.maximum(i, j), np.minimum(i, j)
    off = high != low
    upper = csc_array((np.ones(off.sum()), (low[off], high[off])), shape=(n, n))
    upper.sum_duplicates()
    start, rows = upper.indptr.astype(np.int64), upper.indices.astype(np.int64)
    return _columns(n, start, rows)


class _Finder:
    """Place of an entry of the matrix in the array of values."""

    def __init__(self, ptr: NDArray[np.int64], below: NDArray[np.int64]) -> None:
        self.entries, n = len(below), len(ptr) - 1
        # columns one after the other, rows rising in each: the keys rise
        self.keys = np.repeat(np.arange(n), np.diff(ptr)) * n + below
        self.n = n

    def __call__(self, a: NDArray[np.int64], b: NDArray[np.int64]) -> NDArray[np.int64]:
        high, low = np.maximum(a, b), np.minimum(a, b)
        found = np.searchsorted(self.keys, low * self.n + high)
        return np.where(high == low, self.entries + high, found)


def _block_places(six: NDArray[np.int64], place: NDArray[np.int64], at: _Finder, nowhere: int) -> NDArray[np.int64]:
    """Places (k, 36) of the lower triangles of 6 x 6 blocks."""
    out = np.full((len(six), 36), nowhere, np.int64)
    for c in range(6):
        for d in range(c + 1):
            a, b = six[:, c], six[:, d]
            some = (a >= 0) & (b >= 0)
            out[some, 6 * c + d] = at(place[a[some]], place[b[some]])
    return out


# The pattern of the matrix of the implicit methods: an order of nodes and rows, the places of all entries, constant parts.

Ints = NDArray[np.int64]
REGULAR = 1e-10
"""Regularisation delta of the rows, and of nodes without mass, as a fraction of the largest entry."""


def tangent_record(eq: Any, system: System) -> dict[str, NDArray[Any]]:
    """What `kernels.integrate.tangent` needs: pattern of L, places of blocks, constant part of the matrix."""
    place, row_place = _tangent_order(eq, system)
    n = place.size + row_place.size
    mass = mass_matrix(system, system.x0)[eq.free][:, eq.free].tocoo()
    ends = [np.column_stack([eq.law_A, eq.law_B]), np.column_stack([eq.A, eq.B])]
    where = np.full(eq.local.size + 1, -1, np.int64)
    where[eq.free] = place
    members = [where[(pair[:, :, None] + np.arange(3)).reshape(-1, 6)] for pair in ends]
    members[1][eq.sum_row] = -1
    members += [where[one.coordinates(record)] for one, record in present(system)]
    pairs = [_tangent_pairs(m) for m in members]
    terms = int(eq.sum_ptr[-1]) if len(eq.sum_ptr) else 0
    sums = where[(eq.term_at[:terms, :, None] + np.arange(3)).reshape(-1, 12)]
    sum_row = np.repeat(row_place[np.repeat(eq.sum_row, np.diff(eq.sum_ptr))], 12)
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
    # places of square blocks: bars with a law, rows, elements
    blocks = [find(*pair).reshape(len(m), m.shape[1] ** 2) for m, pair in zip(members, pairs, strict=True)]
    return {
        "ptr": ptr,
        "below": below,
        "target": target,
        "place": place,
        "row_place": row_place,
        "law_at": blocks[0],
        "row_at": blocks[1],
        "sum_at": find(sum_row, sums.reshape(-1)).reshape(-1, 12),
        "gradient_at": find(rows, members[1].reshape(-1)).reshape(-1, 6),
        "base": base,
        "values": np.zeros_like(base),
        "space": np.zeros(n),
        "element_at": np.concatenate([*(one.reshape(-1) for one in blocks[2:]), np.zeros(0, np.int64)]),
        "element_ptr": np.array(_places_of(blocks[2:])).reshape(-1, 3),
    }


def _places_of(blocks: Sequence[Ints]) -> list[tuple[int, int, int]]:
    """Where the places of each kind of elements begin, and their shape."""
    first = np.cumsum([0, *(one.size for one in blocks)]).tolist()
    return [(begin, *one.shape) for begin, one in zip(first, blocks, strict=False)]


def _neighbours(system: System) -> tuple[Ints, Ints]:
    """Flat first coordinates of every two nodes of an element."""
    found = [np.zeros((0, 2), np.int64)]
    for one, record in present(system):
        nodes = one.coordinates(record)[:, ::3]
        found += [nodes[:, [i, j]] for i, j in combinations(range(nodes.shape[1]), 2)]
    pairs = np.concatenate(found)
    pairs = pairs[(pairs >= 0).all(axis=1)]
    return pairs[:, 0], pairs[:, 1]


def _tangent_order(eq: Any, system: System) -> tuple[Ints, Ints]:
    """Places of free coordinates and of rows: nodes by reverse Cuthill-McKee, each row after the later of its free nodes."""
    nodes = eq.local.size // 3
    one, other = _neighbours(system)
    A = np.concatenate([eq.A, eq.law_A, eq.pair_A, eq.varying_A, one]) // 3
    B = np.concatenate([eq.B, eq.law_B, eq.pair_B, eq.varying_B, other]) // 3
    graph = csr_array((np.ones(2 * A.size), (np.concatenate([A, B]), np.concatenate([B, A]))), shape=(nodes, nodes))
    rank = np.empty(nodes, np.int64)
    # nodes in a narrow band, each row behind the last of its nodes
    rank[reverse_cuthill_mckee(csr_array(graph), symmetric_mode=True)] = np.arange(nodes)
    has = np.zeros(nodes, np.bool_)
    has[eq.free // 3] = True
    seen = np.where(has, rank, -1)
    last = np.maximum(seen[eq.A // 3], seen[eq.B // 3])
    for j, r in enumerate(eq.sum_row):
        last[r] = seen[eq.term_at[eq.sum_ptr[j] : eq.sum_ptr[j + 1]] // 3].max()
    keys = np.concatenate([rank[eq.free // 3] * 2, last * 2 + 1])
    places = np.empty(keys.size, np.int64)
    places[np.argsort(keys, kind="stable")] = np.arange(keys.size)
    return places[: eq.free.size], places[eq.free.size :]


def _tangent_pairs(member: Ints) -> tuple[Ints, Ints]:
    """All pairs of places of a member's coordinates, -1 where prescribed."""
    width = member.shape[1]
    return np.repeat(member, width, 1).reshape(-1), np.tile(member, width).reshape(-1)


def _pattern(n: int, i: Ints, j: Ints) -> tuple[Ints, Ints, Ints]:
    """Columns of L below the diagonal, and where each product of two entries of a column goes."""
    good = (i >= 0) & (j >= 0) & (i != j)
    low, high = np.minimum(i, j)[good], np.maximum(i, j)[good]
    upper = csr_array(coo_array((np.ones(low.size), (high, low)), shape=(n, n)))
    upper.sort_indices()
    ptr, row = upper.indptr.astype(np.int64), upper.indices.astype(np.int64)
    starts, below = _columns(n, ptr, row)
    return starts, below, _targets(starts, below)


def _columns(n: int, upper_ptr: Ints, upper_row: Ints) -> tuple[Ints, Ints]:
    """Columns of L below the diagonal: two passes, first how long they are, then their rows."""
    parent, flag, count = np.zeros(n, np.int64), np.zeros(n, np.int64), np.zeros(n, np.int64)
    ldl_pattern(n, upper_ptr, upper_row, parent, flag, count, np.zeros(0, np.int64))
    ptr = np.concatenate([[0], np.cumsum(count)]).astype(np.int64)
    below = np.zeros(int(ptr[-1]), np.int64)
    if len(below):
        ldl_pattern(n, upper_ptr, upper_row, parent, flag, ptr[:-1].copy(), below)
    return ptr, below


def _targets(ptr: Ints, below: Ints) -> Ints:
    """Where each product of two entries of a column goes; never empty, which would mean a skyline."""
    target = np.zeros(max(1, ldl_targets(ptr, below, np.zeros(0, np.int64))), np.int64)
    ldl_targets(ptr, below, target)
    return target


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
