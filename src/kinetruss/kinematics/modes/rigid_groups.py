"""Nodes that rigid bars join to bodies, and every node as a linear function of few unknowns."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics import RIGID, System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Group", "rigid_groups"]

FLAT = 1e-6
"""Nodes of a group within this fraction of its size from a plane count as lying in it."""


@dataclass(frozen=True, eq=False)
class Group:
    """Nodes of one body. basis : nodes with unknown positions; maps (nodes, 3, 3 basis) : position of each node from them, or
    NaN for nodes out of the plane of three basis nodes, which follow from the handedness of the body.
    """

    nodes: tuple[int, ...]
    basis: tuple[int, ...]
    maps: NDArray[np.float64]


def rigid_groups(system: System, outside: NDArray[np.bool_]) -> list[Group]:
    """Groups that start as triangles of rigid bars and grow by nodes joined to three of their nodes (two in the plane).

    outside (n,) : nodes that are used outside their group (by other bars, supports, drives).
    """
    near = _neighbours(system)
    found: list[set[int]] = []
    for i, j, k in _triangles(near):
        if any({i, j, k} <= group for group in found) or _size(system, (i, j, k))[1] < 1e-6:
            continue
        found.append(_grown(system, near, {i, j, k}))
    return [one for one in (_group(system, group, outside) for group in found) if one is not None]


def _neighbours(system: System) -> list[set[int]]:
    near: list[set[int]] = [set() for _ in system.nodes]
    for m in np.flatnonzero(system.kind == RIGID):
        near[system.p[m]].add(int(system.q[m]))
        near[system.q[m]].add(int(system.p[m]))
    return near


def _triangles(near: list[set[int]]) -> list[tuple[int, int, int]]:
    return [
        (i, j, k) for i in range(len(near)) for j, k in combinations(sorted(n for n in near[i] if n > i), 2) if k in near[j]
    ]


def _grown(system: System, near: list[set[int]], group: set[int]) -> set[int]:
    """The group with all nodes that are joined to `dim` of its nodes, not on one line."""
    while True:
        hung = [n for n in range(len(near)) if n not in group and _hangs(system, near[n] & group)]
        if not hung:
            return group
        group = group | set(hung)


def _hangs(system: System, others: set[int]) -> bool:
    """True if distances from these nodes fix a position up to a reflection."""
    return any(_size(system, some)[system.dim - 2] > 1e-6 for some in combinations(sorted(others), system.dim))


def _size(system: System, nodes: Any) -> NDArray[np.float64]:
    """Singular values of the nodes' places about their middle, over the largest; three of them."""
    at = system.x0[list(nodes)]
    values = np.linalg.svd(at - at.mean(axis=0), compute_uv=False)
    full = np.zeros(3)
    full[: len(values)] = values[:3]
    return np.asarray(full / max(full[0], 1e-300))


def _group(system: System, group: set[int], outside: NDArray[np.bool_]) -> Group | None:
    """Basis and maps of a group; None if its nodes are on one line."""
    nodes = tuple(sorted(group))
    needed = [n for n in nodes if outside[n]] or list(nodes)
    count = 2 if system.dim == 2 else 3
    if system.dim == 3 and len(needed) > 3 and _size(system, needed)[2] > FLAT:
        count = 4
    pool = needed if len(needed) >= count else list(nodes)
    basis = max(combinations(pool, count), key=lambda some: (_volume(system, some), -sum(some)))
    if _volume(system, basis) < 1e-6:
        return None
    return Group(nodes, basis, np.array([_map(system, n, basis) for n in nodes]))


def _volume(system: System, nodes: tuple[int, ...]) -> float:
    """Product of the singular values of the edges from the first node, over the size to that power."""
    edges = system.x0[list(nodes[1:])] - system.x0[nodes[0]]
    values = np.linalg.svd(edges, compute_uv=False)
    return float(np.prod(values / max(values[0], 1e-300)))


def _map(system: System, node: int, basis: tuple[int, ...]) -> NDArray[np.float64]:
    """Linear map (3, 3 k) from the positions of the basis to that of a node; NaN if the node is not in their span."""
    k, at = len(basis), system.x0[list(basis)]
    if system.dim == 2:  # a similarity of the plane: p + a d + b J d
        d, r = at[1] - at[0], system.x0[node] - at[0]
        a, b = (d @ r) / (d @ d), (d[0] * r[1] - d[1] * r[0]) / (d @ d)
        turn = np.array([[a, -b, 0], [b, a, 0], [0, 0, a]])
        return np.hstack([np.eye(3) - turn, turn])
    A = np.vstack([at.T, np.ones(k)])
    share, *_ = np.linalg.lstsq(A, np.append(system.x0[node], 1.0), rcond=None)
    if np.linalg.norm(A @ share - np.append(system.x0[node], 1.0)) > FLAT * np.linalg.norm(at - at[0]):
        return np.full((3, 3 * k), np.nan)
    return np.asarray(np.kron(share, np.eye(3)), float)
