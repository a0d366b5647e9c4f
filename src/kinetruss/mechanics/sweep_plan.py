"""Plans of the null-space solver: rows and coordinates as a sequence of small blocks, some with more coordinates than rows.

Rows are matched to free coordinates, the farthest from the supports first, so that rows near the supports stay independent.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from kinetruss.mechanics.arrangement import block_triangular, entries_of, pattern_of
from kinetruss.mechanics.row_gradients import constraint_jacobian
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray


MOST_PLANS = 4
SMALL = 24
"""Largest number of free coordinates of a single block that is kept as a last resort."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Blocks:
    """One plan: rows and flat coordinates of each block, its cost (about a nanosecond each), its pivot at the start."""

    rows: list[list[int]]
    columns: list[list[int]]
    cost: float
    pivot: float


def sweep_plans(system: System, trials: int = 12, most: float = np.inf) -> list[Blocks]:
    """Useful plans, the cheapest regular one first; none if the rows cannot all be matched, or each costs more than `most`."""
    J, held = constraint_jacobian(system, system.x0), system.prescribed.tolist()
    column, value, start = J.indices.tolist(), J.data.tolist(), J.indptr.tolist()
    # gradient of each row by its free coordinates
    touch = [{column[k]: value[k] for k in range(a, b) if not held[column[k]]} for a, b in pairwise(start)]
    if sum(map(len, touch)) > 20000:
        trials = 2
    depth = _depths(system)
    rng = np.random.default_rng(1)
    found: dict[Any, Blocks] = {}
    # matchings with random weights; the first prefers coordinates far from the supports
    for trial in range(trials):
        spread = 0.01 if trial == 0 else 3.0
        weight = 1.0 + depth.max(initial=0.0) - depth + spread * rng.random(depth.size)
        blocks = _plan(system, touch, weight, most)
        if blocks is None:
            break
        if blocks.cost > most:
            continue
        key = tuple(sorted(tuple(sorted(columns)) for columns in blocks.columns))
        found.setdefault(key, blocks)
    best = sorted(found.values(), key=lambda one: (one.pivot < 0.05, one.cost))
    if not best:
        return []
    plans = [one for one in best if one.cost <= 4.0 * best[0].cost][:MOST_PLANS]
    if plans and len(system.free) <= SMALL and len(plans[0].rows) > 1:
        rows = [list(range(len(touch)))]
        columns = [[int(c) for c in system.free]]
        plans.append(Blocks(rows=rows, columns=columns, cost=_cost(rows, columns), pivot=_pivot(rows, columns, touch)))
    return plans


def _depths(system: System) -> NDArray[np.float64]:
    """Number of rows between the node of each flat coordinate and the supports."""
    n = len(system.nodes)
    p, q = system.p[system.row_member], system.q[system.row_member]
    graph = csr_array((np.ones(len(p)), (p, q)), shape=(n, n))
    axes = system.prescribed.reshape(-1, 3)[:, : system.dim]
    held = np.flatnonzero(axes.any(axis=1))
    # shortest paths along rows from the nodes that are held
    far = dijkstra(graph, directed=False, unweighted=True, indices=held if len(held) else [0], min_only=True)
    far[~np.isfinite(far)] = 0.0
    return np.repeat(far, 3)


def _plan(system: System, touch: list[dict[int, float]], weight: NDArray[np.float64], most: float) -> Blocks | None:
    """The plan of one matching; touch: gradient of each row by its free flat coordinates.

    The pivot of one that costs more than `most` is not computed: its blocks may be as large as the structure.
    """
    free = system.free
    local = np.full(system.x0.size, -1)
    local[free] = np.arange(len(free))
    found = block_triangular(pattern_of([local[list(t)].tolist() for t in touch], len(free), weight[free]), light=True)
    if found is None:
        return None
    rows, columns = [mine for mine, _ in found], [free[mine].tolist() for _, mine in found]
    cost = _cost(rows, columns)
    return Blocks(rows=rows, columns=columns, cost=cost, pivot=_pivot(rows, columns, touch) if cost <= most else 0.0)


def _cost(rows: list[list[int]], columns: list[list[int]]) -> float:
    """Estimated nanoseconds of a factorisation and a solution without the masses."""
    cost, dofs = 0.0, 0
    for block, mine in zip(rows, columns, strict=True):
        n, c = len(block), len(mine)
        dofs += c - n
        # elimination n^2 c, then one solution for each mode and three right-hand sides
        cost += 25.0 + 2.0 * n * c + n * n * c * 0.7 + (dofs + 3) * (6.0 * n + n * n)
    return cost


def _pivot(rows: list[list[int]], columns: list[list[int]], touch: list[dict[int, float]]) -> float:
    """Smallest singular value of the blocks at the start."""
    smallest = 1.0
    for block, mine in zip(rows, columns, strict=True):
        if not block:
            continue
        matrix = np.array([[touch[r].get(flat, 0.0) for flat in mine] for r in block])
        smallest = min(smallest, float(np.linalg.svd(matrix, compute_uv=False)[-1]))
    return smallest


def sweep_arrays(system: System, plans: list[Blocks]) -> dict[str, NDArray[Any]]:
    """The arrays of `Equations` for these plans, one after the other; rows as in the system."""
    count, row_ptr, col_ptr, place, entry_ptr = [0], [0], [0], [0], [0]
    row: list[int] = []
    col: list[int] = []
    entries: list[tuple[int, int, int, float]] = []
    for plan in plans:
        for block, mine in zip(plan.rows, plan.columns, strict=True):
            where = {flat: j for j, flat in enumerate(mine)}
            for i, r in enumerate(block):
                entries += [(place[-1] + i * len(mine) + j, r, axis, sign) for j, axis, sign in entries_of(system, r, where)]
            row += block
            col += mine
            row_ptr.append(len(row))
            col_ptr.append(len(col))
            place.append(place[-1] + len(block) * len(mine))
            entry_ptr.append(len(entries))
        count.append(len(row_ptr) - 1)
    at, of, axis, sign = zip(*entries, strict=True) if entries else ((), (), (), ())
    named = {
        "plans": count,
        "row_ptr": row_ptr,
        "col_ptr": col_ptr,
        "place": place,
        "row": row,
        "col": col,
        "entry_ptr": entry_ptr,
        "entry_at": at,
        "entry_row": of,
        "entry_axis": axis,
    }
    found: dict[str, NDArray[Any]] = {f"sweep_{name}": np.array(value, np.int64) for name, value in named.items()}
    return found | {"sweep_entry_sign": np.array(sign, float)}
