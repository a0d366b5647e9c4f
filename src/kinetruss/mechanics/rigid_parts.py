"""Rigid parts: nodes whose distances rigid bars keep, and what of them counts in the singularity measure.

A part grows from a triangle of rigid bars, or from the supports, by nodes that rigid bars join to two of its nodes (three in
space). Its shape is constant, so that how slim it is says nothing about the motion: in the measure a part has one length, its
size, as a bar has.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.kernels.coordinates.forms import PRODUCT
from kinetruss.kernels.structure.structure import ALONE, LENGTH, RIGID_SHAPE, SIZE, SUM

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


FLAT = 1e-9
"""Height of a triangle or a tetrahedron over its longest side below which rounding does not let it hold its apex."""
WELL = 0.1
"""The same, from which on a base serves as well as a higher one: so that it does not change with every place."""


@dataclass(frozen=True, eq=False)
class RigidPart:
    """Nodes of one rigid part; used : those that anything else depends on; ground : it does not move.

    hands : nodes (a, b, c) or, in space, (a, b, c, d): the last one keeps its side of the line or plane of the others.
    """

    nodes: frozenset[int]
    used: frozenset[int]
    ground: bool
    hands: tuple[tuple[int, ...], ...]


@cached()
def rigid_parts(system: System) -> tuple[RigidPart, ...]:
    """The rigid parts of three nodes or more, and the supports with what rigid bars fix to them."""
    near, places = _joined(system), system.x0.tolist()
    ground = _ground(system)
    found = [_grown(places, near, ground, system.dim)] if len(ground) >= system.dim else []
    for i, around in enumerate(near):
        for j, k in combinations(sorted(n for n in around if n > i), 2):
            if k in near[j] and not any({i, j, k} <= nodes for nodes, _ in found) and _height(places, (i, j), k) > FLAT:
                start = _grown(places, near, {i, j, k}, system.dim)
                found.append((start[0], [*([(i, j, k)] if system.dim == 2 else []), *start[1]]))
    found = _merged(found, system.dim)
    parts = []
    for (nodes, hands), used in zip(found, _used(system, found), strict=True):
        if len(nodes) > 2:
            seen = frozenset(used if len(used) >= system.dim else nodes)
            parts.append(RigidPart(frozenset(nodes), seen, bool(ground) and ground <= nodes, tuple(hands)))
    return tuple(parts)


Places = list[list[float]]
Grown = tuple[set[int], list[tuple[int, ...]]]


def _joined(system: System) -> list[set[int]]:
    """The nodes at a constant distance from each node."""
    near: list[set[int]] = [set() for _ in system.nodes]
    for touched, constant in zip(_touched(system), _constant(system).tolist(), strict=True):
        for one in touched if constant else ():
            near[one] |= touched - {one}
    return near


def _constant(system: System) -> NDArray[np.bool_]:
    """Rows that keep distances: of bars, and those of products of edges, which keep the shape of a beam (beam_shapes)."""
    keeps = system.row_kind == LENGTH
    keeps[system.sums] = system.term_kind[system.measure_ptr[system.row_measure[system.sums]]] == PRODUCT
    return np.asarray(keeps & (system.row_drive < 0))


def _ground(system: System) -> set[int]:
    """Nodes of which no coordinate moves."""
    still = system.prescribed.copy()
    still[system.coordinate_drive[:, 0]] = False
    found = np.flatnonzero(still.reshape(-1, 3).all(axis=1)).tolist()
    return {n for n in found if system.nodes[n] not in system.model.support_motion}


def _grown(places: Places, near: list[set[int]], start: set[int], dim: int) -> Grown:
    """The nodes with all that rigid bars join to `dim` of them, and the sides on which these stand."""
    nodes, hands = set(start), []
    ahead = deque(sorted({n for one in nodes for n in near[one]} - nodes))
    while ahead:
        n = ahead.popleft()
        held = sorted(near[n] & nodes)
        if n in nodes or len(held) < dim:
            continue
        base, height = _base(places, combinations(held[:8], dim), n)
        if height > FLAT:
            nodes.add(n)
            hands.append((*base, n))
            ahead.extend(sorted(near[n] - nodes))
    return nodes, hands


def _base(places: Places, bases: Iterable[tuple[int, ...]], node: int) -> tuple[tuple[int, ...], float]:
    """The first base over which a node stands well, else that over which it stands highest, and the height."""
    best: tuple[int, ...] = ()
    highest = -1.0
    for base in bases:
        if (height := _height(places, base, node)) > highest:
            best, highest = base, height
        if highest > WELL:
            break
    return best, highest


def _height(places: Places, base: tuple[int, ...], node: int) -> float:
    """Least singular value of the edges from a node to a base, over the largest: 0 on its line or plane."""
    if len(base) > 2:
        values = np.linalg.svd(np.subtract([places[n] for n in base], places[node]), compute_uv=False)
        return float(values[-1] / max(values[0], 1e-300))
    at, one, two = (places[n] for n in (node, *base))
    a, b, c, d, e, f = one[0] - at[0], one[1] - at[1], one[2] - at[2], two[0] - at[0], two[1] - at[1], two[2] - at[2]
    # the area is the product of both singular values, and the mean that of their squares
    area, mean = math.hypot(b * f - c * e, c * d - a * f, a * e - b * d), (a * a + b * b + c * c + d * d + e * e + f * f) / 2
    return area / max(mean + math.sqrt(max(mean * mean - area * area, 0.0)), 1e-300)


def _merged(found: list[Grown], shared: int) -> list[Grown]:
    """Parts that share two nodes (three in space) are one."""
    merged: list[Grown] = []
    for nodes, hands in found:
        while same := next((one for one in merged if len(one[0] & nodes) >= shared), None):
            merged.remove(same)
            nodes, hands = nodes | same[0], [*same[1], *hands]
        merged.append((nodes, hands))
    return merged


def _used(system: System, found: list[Grown]) -> list[set[int]]:
    """The nodes of each part that supports, or rows other than its own bars, depend on."""
    used: list[set[int]] = [set() for _ in found]
    of: dict[int, list[int]] = {}
    held = set(np.flatnonzero(system.prescribed.reshape(-1, 3)[:, : system.dim].any(axis=1)).tolist())
    for k, (nodes, _) in enumerate(found):
        used[k] |= nodes & held
        for n in nodes:
            of.setdefault(n, []).append(k)
    for touched, constant in zip(_touched(system), _constant(system).tolist(), strict=True):
        for n in touched:
            for k in of.get(n, ()):
                if not (constant and found[k][0] >= touched):
                    used[k].add(n)
    return used


def _touched(system: System) -> list[set[int]]:
    """The nodes that each row depends on."""
    ends = (which[system.row_member].tolist() for which in (system.p, system.q))
    found = [{p, q} for p, q in zip(*ends, strict=True)]
    for r in np.flatnonzero(system.row_kind == SUM):
        first, last = system.measure_ptr[system.row_measure[r] : system.row_measure[r] + 2]
        found[r] = {int(flat) // 3 for flat in system.term_at[first:last].ravel()}
    return found


def part_arrays(system: System, row: NDArray[np.int64], ptr: NDArray[np.int64], col: NDArray[np.int64]) -> dict[str, Any]:
    """The fields of a `Plan` for rigid parts, from rows in the order of the plan, pointers of its blocks and their columns."""
    parts, constant = rigid_parts(system), _constant(system)
    counts, seen = np.full(len(row), ALONE, np.int64), np.ones(len(col))
    hidden = {n for one in parts for n in one.nodes - one.used}
    seen[[k for k, flat in enumerate(col) if int(flat) // 3 in hidden]] = 0.0
    touched = _touched(system)
    ends = [touched[r] if constant[r] else set() for r in row]
    sizes, size_ptr, hands, hand_ptr = list[tuple[int, int]](), [0], list[tuple[int, ...]](), [0]
    block_ptr = [0]
    for b in range(len(ptr) - 1):
        own, open_ = (set(col[ptr[b] : end].tolist()) for end in (ptr[b + 1], None))
        for part in parts:
            mine = [k for k in range(ptr[b], ptr[b + 1]) if ends[k] and ends[k] <= part.nodes]
            known = sum(3 * n + axis not in open_ for n in part.nodes for axis in range(system.dim))
            # a part of which more is known than all but one of the freedoms of a similarity keeps its size
            free = bool(mine) and not part.ground and known < (4 if system.dim == 2 else 7)
            counts[mine] = RIGID_SHAPE
            if free:
                # products of the edges of an undeformed beam stay as they are when the part grows
                bars = [k for k in mine if system.row_kind[row[k]] == LENGTH]
                counts[bars] = SIZE
                scale = [k for k in bars if ends[k] <= part.used] or bars
                sizes += [(k, int(k in scale)) for k in bars]
                size_ptr.append(len(sizes))
            hands += [
                (*(3 * n for n in hand), *[-1] * (4 - len(hand)))
                for hand in part.hands
                if all(3 * hand[-1] + axis in own for axis in range(system.dim))
            ]
        block_ptr.append(len(size_ptr) - 1)
        hand_ptr.append(len(hands))
    return {
        "counts": counts,
        "seen": seen,
        "sized_ptr": np.array(block_ptr, np.int64),
        "size_ptr": np.array(size_ptr, np.int64),
        "size_row": np.array(sizes, np.int64).reshape(-1, 2),
        "hand_ptr": np.array(hand_ptr, np.int64),
        "hand": np.array(hands, np.int64).reshape(-1, 4),
    }
