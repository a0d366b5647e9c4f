"""The block triangular form of a compiled model, and an independent set of its rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from heapq import heapify, heappop, heappush
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from kinetruss.display import moment
from kinetruss.elements.caching import cached
from kinetruss.errors import few
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SMALL, SUM, Plan
from kinetruss.mechanics.measures import flats_of, sum_arrays
from kinetruss.mechanics.rigid_parts import part_arrays, rigid_parts
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE, constraint_gradients, jacobian
from kinetruss.mechanics.rows import matching

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.elimination import Elimination
    from kinetruss.mechanics.system import System


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


# Finds the block triangular form of a compiled model, and keeps an independent set of rows if it is not square.
#
# Rows (prescribed lengths and angles) and free coordinates make the blocks. A redundant structure keeps an independent set of
# rows in them, rigid bars first, and the rest as `redundant`.

FEW, MOST = 40, 1500
"""Rows and columns from which on, and up to which, an elimination is faster than singular values."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Arrangement:
    """Independent and redundant rows of a system, and their blocks.

    plan : blocks of independent rows, or None where some coordinate is not determined (fewer rows than freedoms).
    redundant : redundant rows (indices). not_unique : mask of rows that take part in a state of self-stress.
    weight : (rows,) weights of the least-norm forces of redundant rows: l/(E A) over its mean, or 1; stiff : mask
        of the former.
    """

    plan: Plan | None
    redundant: NDArray[np.int64]
    not_unique: NDArray[np.bool_]
    weight: NDArray[np.float64]
    stiff: NDArray[np.bool_]


def not_unique_note(names: Sequence[str]) -> str:
    """The sentence of a message on members whose force is not unique; empty without any."""
    return f"The force of these members is not unique (redundant structure): {few(names, 8)}." if names else ""


def not_unique_at_notes(at: Mapping[str, Sequence[float]], poses: Sequence[str]) -> list[str]:
    """Sentences of a message on singular positions; at : by member the times, or numbers of poses, at which its force is not
    unique. poses : names of poses at rest.
    """
    found: dict[tuple[float, ...], list[str]] = {}
    for name, times in at.items():
        found.setdefault(tuple(times), []).append(name)
    return [
        f"Singular position at {few([moment(time, poses) for time in times], 3)}: the force of these members is not unique "
        f"there: {few(names, 8)}."
        for times, names in found.items()
    ]


@cached()
def arrange(system: System) -> Arrangement:
    """The arrangement of a system at its start configuration."""
    rows = np.arange(len(system.row_member))
    plan = plan_of(system, rows)
    if plan is not None:
        none = np.zeros(len(rows), np.bool_)
        return Arrangement(plan=plan, redundant=np.zeros(0, np.int64), not_unique=none, weight=np.ones(len(rows)), stiff=none)
    return rearrange(system, system.x0, None)


def rearrange(system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None) -> Arrangement:
    """Choose independent rows by rank at a configuration, for systems whose Jacobian is not square or not regular."""
    found = eliminated(system, x, system.drive_start if values is None else values)
    if found is not None:
        independent, redundant, states = found.independent, found.redundant, found.self_stress
    else:
        J = jacobian(system, x, values)
        independent = _independent(J, system.row_drive >= 0)
        redundant = np.setdiff1d(np.arange(len(J)), independent)
        states = _self_stress(J, independent, redundant)
    plan = plan_of(system, independent) if len(independent) == len(system.free) else None
    not_unique, (weight, stiff) = np.any(np.abs(states) > 1e-9, axis=0), _weights(system, states)
    return Arrangement(plan=plan, redundant=redundant, not_unique=not_unique, weight=weight, stiff=stiff)


def eliminated(system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None = None) -> Elimination | None:
    """The elimination of the Jacobian at positions x (n, 3), those of drives last, angles at drive `values` if given.

    None for a small system, for a very large one, and where its rank is in doubt.
    """
    if not FEW < max(len(system.row_member), len(system.free)) <= MOST:
        return None
    angles = values is not None and (system.row_kind == ANGLE).any()
    return _eliminated(system, x.tobytes(), values.tobytes() if values is not None and angles else b"")


@cached(4)
def _eliminated(system: System, x: bytes, values: bytes) -> Elimination | None:
    place = np.frombuffer(x).reshape(1, -1, 3)
    J = constraint_gradients(system, place, np.frombuffer(values)[None] if values else None)[0][:, system.free]
    from kinetruss.mechanics.elimination import Elimination  # it has compiled kernels

    found = Elimination(J, system.row_drive >= 0)
    return found if found.sure else None


def _independent(J: NDArray[np.float64], driven: NDArray[np.bool_]) -> NDArray[np.int64]:
    """A largest set of independent rows, rows that are not driven first."""
    from scipy.linalg import qr

    chosen: list[int] = []
    basis = np.zeros((J.shape[1], 0))
    for group in (np.flatnonzero(~driven), np.flatnonzero(driven)):
        if len(group) == 0 or J.shape[1] == 0:
            continue
        # rows of the group less what the rows chosen before span, then rank by pivoted QR
        left = J[group].T - basis @ (basis.T @ J[group].T)
        Q, R, order = qr(left, mode="economic", pivoting=True)
        rank = int(np.sum(np.abs(np.diag(R)) > RANK_TOLERANCE))
        chosen += [int(group[k]) for k in order[:rank]]
        basis = np.hstack([basis, Q[:, :rank]])
    return np.array(sorted(chosen), np.int64)


def _self_stress(J: NDArray[np.float64], independent: NDArray[np.int64], redundant: NDArray[np.int64]) -> NDArray[np.float64]:
    """States of self-stress (states, rows): one for each redundant row, unit there and zero at the other redundant rows."""
    states = np.zeros((len(redundant), len(J)))
    if len(redundant):
        # J_e^T = J_i^T s: the redundant row as a combination of independent ones
        shares, *_ = np.linalg.lstsq(J[independent].T, J[redundant].T, rcond=None)
        states[:, independent] = -shares.T
        states[np.arange(len(redundant)), redundant] = 1.0
    return states


def _weights(system: System, states: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """l/(E A) if every bar in a state of self-stress has E and A, else 1 (least norm of N); and the mask of the former."""
    weight, stiff = np.ones(len(system.row_member)), np.zeros(len(system.row_member), np.bool_)
    if not len(states):
        return weight, stiff
    soft = system.compliance[system.row_member] * system.length0[system.row_member] + system.yielding[system.row_member]
    soft[system.row_kind != LENGTH] = np.nan
    # states of self-stress that share bars belong together: nodes of a graph, first of the states, then of the bars
    state, bar = np.nonzero(np.abs(states) > 1e-9)
    size = sum(states.shape)
    graph = csr_array((np.ones(len(bar)), (state, len(states) + bar)), shape=(size, size))
    bars = np.unique(bar)
    group = connected_components(graph, directed=False)[1][len(states) + bars]
    # w = l/(E A), scaled to a mean of 1, where all bars of the group have one
    mean = (np.bincount(group, soft[bars]) / np.maximum(np.bincount(group), 1))[group]
    known = np.isfinite(mean)
    weight[bars[known]], stiff[bars[known]] = (soft[bars] / mean)[known], True
    return weight, stiff


def plan_of(system: System, rows: NDArray[np.int64]) -> Plan | None:
    """Blocks of the given rows, or None if they do not match the free coordinates one to one."""
    if len(rows) != len(system.free):
        return None
    if len(system.sums) or system.model.support_motion:
        return _planned(system, rows)
    plan = _planned_once(Topology(system, rows))
    return plan and plan.with_(value=system.row_value[plan.row])


class Topology:
    """Rows, their nodes and rigid parts as a key of caches: a plan without sums depends on them alone, not on places."""

    def __init__(self, system: System, rows: NDArray[np.int64]) -> None:
        self.system, self.rows = system, rows
        arrays = (
            rows, system.p, system.q, system.row_member, system.row_kind, system.row_drive, system.prescribed,
            system.coordinate_drive,
        )  # fmt: skip
        parts = tuple((one.nodes, one.used, one.hands) for one in rigid_parts(system))
        self.key = (*((array.shape, array.tobytes()) for array in arrays), parts)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Topology) and self.key == other.key


@lru_cache(maxsize=32)
def _planned_once(one: Topology) -> Plan | None:
    return _planned(one.system, one.rows)


def _planned(system: System, rows: NDArray[np.int64]) -> Plan | None:
    free = system.free
    local = np.full(system.x0.size, -1)
    local[free] = np.arange(len(free))
    # incidence of rows and free coordinates, then its block triangular form
    pattern = pattern_of([[c for c in local[flats_of(system, r)].tolist() if c >= 0] for r in rows], len(free))
    blocks = block_triangular(pattern)
    if blocks is None:
        return None
    redundant = np.setdiff1d(np.arange(len(system.row_member)), rows)
    return _assemble(system, [([int(rows[k]) for k in mine], free[columns].tolist()) for mine, columns in blocks], redundant)


def _assemble(system: System, blocks: list[tuple[list[int], list[int]]], redundant: NDArray[np.int64]) -> Plan:
    """The arrays of a plan from the rows and flat coordinates of its blocks."""
    order: list[int] = []
    col: list[int] = []
    entries: list[tuple[int, int, int, float]] = []
    ptr, entry_ptr = [0], [0]
    # rows, columns and entries of J block by block
    for rows, columns in blocks:
        place = {flat: k for k, flat in enumerate(columns)}
        for r in rows:
            entries += [(len(order), *e) for e in entries_of(system, r, place)]
            order.append(r)
        entry_ptr.append(len(entries))
        col += columns
        ptr.append(len(order))
    row = np.array([*order, *redundant], np.int64)
    sums = sum_arrays(system, row, np.array(ptr, np.int64), np.array(col, np.int64))
    width = max((len(rows) for rows, _ in blocks), default=0)
    member = system.row_member[row]
    entry_row, entry_col, axis, sign = zip(*entries, strict=True) if entries else ((), (), (), ())
    return Plan.of(
        dict(
            A=3 * system.p[member].astype(np.int64),
            B=3 * system.q[member].astype(np.int64),
            kind=system.row_kind[row],
            drive=system.row_drive[row].astype(np.int64),
            value=system.row_value[row],
            row=row,
            member=member,
            driven=np.flatnonzero(system.row_drive[row] >= 0),
            ptr=np.array(ptr, np.int64),
            col=np.array(col, np.int64),
            width=width,
            **_apart(width, len(redundant) > 0),
            entry_ptr=np.array(entry_ptr, np.int64),
            entry_row=np.array(entry_row, np.int64),
            entry_col=np.array(entry_col, np.int64),
            entry_axis=np.array(axis, np.int64),
            entry_sign=np.array(sign, np.float64),
            moving=_moving(system),
            **sums,
            **part_arrays(system, row, np.array(ptr, np.int64), np.array(col, np.int64)),
        )
    )


def _apart(width: int, redundant: bool) -> dict[str, NDArray[np.int64]]:
    """Addresses of what only plans with large blocks, and only such with redundant rows, need."""
    found = {"large": np.zeros(0, np.int64), "shares": np.zeros(0, np.int64)}
    # kernels that other plans do not need
    if width > SMALL:
        from kinetruss.kernels.sweep.blocks import large

        found["large"] = large.addresses()
    if redundant:
        from kinetruss.kernels.sweep.forces import shares

        found["shares"] = shares.addresses()
    return found


def entries_of(system: System, r: int, place: dict[int, int]) -> list[tuple[int, int, float]]:
    """Column in the block's matrix, axis and sign of each of a row's own coordinates."""
    if system.row_kind[r] == SUM:
        return []
    i = system.row_member[r]
    axes = 2 if system.row_kind[r] == ANGLE else 3
    return [
        (place[3 * node + axis], axis, sign)
        for node, sign in ((int(system.p[i]), -1.0), (int(system.q[i]), 1.0))
        for axis in range(axes)
        if 3 * node + axis in place
    ]


def _moving(system: System) -> NDArray[np.int64]:
    """Prescribed coordinates with a motion: those of coordinate drives, then those of supports with a history."""
    flats = [int(flat) for flat, _ in system.coordinate_drive]
    for node in system.model.support_motion:
        i = system.node_index(node)
        flats += [3 * i + "xyz".index(axis) for axis in system.model.fixed[node]]
    return np.array(flats, np.int64)
