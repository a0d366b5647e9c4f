"""Visible faces of bodies, membranes and solids: triangles between nodes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model

__all__ = ["TRIANGLES", "Skin", "body_faces", "skin_of"]

TRIANGLES: dict[int, tuple[tuple[int, ...], ...]] = {
    3: ((0, 1, 2),),
    4: ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)),
    6: ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
}
"""Faces of elements by their number of nodes; those of six nodes in the order of their stresses."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Skin:
    """Triangles of membranes and of the surface of solids.

    nodes : (f, 3). part : (f,) which of `names`; kinds : ``membrane`` or ``solid``. element : (f,) row in the table of its
    part. corner : (f,) which of the triangles of its element.
    """

    nodes: NDArray[np.int64]
    part: NDArray[np.int64]
    element: NDArray[np.int64]
    corner: NDArray[np.int64]
    names: tuple[str, ...]
    kinds: tuple[str, ...]


def skin_of(model: Model) -> Skin:
    """The elements of membranes; of solids the faces that belong to one element only."""
    index = {name: k for k, name in enumerate(model.nodes)}
    records: list[tuple[str, Any]] = [*model.membranes.items(), *model.solids.items()]
    columns: list[NDArray[np.int64]] = [np.zeros((0, 6), np.int64)]
    for k, (_, part) in enumerate(records):
        rows = np.array([index[node] for node in part.nodes], np.int64)[np.array(part.elements, np.int64)]
        pattern = TRIANGLES[rows.shape[1]]
        count, each = len(rows), len(pattern)
        which = [np.full(count * each, k), np.repeat(np.arange(count), each), np.tile(np.arange(each), count)]
        columns.append(np.column_stack([rows[:, np.array(pattern)].reshape(-1, 3), *which]))
    rows = np.concatenate(columns)
    solid = rows[:, 3] >= len(model.membranes)
    if solid.any():
        _, first, times = np.unique(np.sort(rows[solid, :3], axis=1), axis=0, return_index=True, return_counts=True)
        outside = np.sort(first[times == 1])  # a face between two elements is not visible
        rows = np.concatenate([rows[~solid], rows[solid][outside]])
    return Skin(
        nodes=rows[:, :3],
        part=rows[:, 3],
        element=rows[:, 4],
        corner=rows[:, 5],
        names=tuple(name for name, _ in records),
        kinds=("membrane",) * len(model.membranes) + ("solid",) * len(model.solids),
    )


def body_faces(model: Model, x0: NDArray[np.float64]) -> list[list[int]]:
    """Nodes of the triangles that a body of three nodes or more is drawn with: its hull in the start configuration (n, dim)."""
    if not model.bodies:
        return []
    from scipy.spatial import ConvexHull

    index = {name: k for k, name in enumerate(model.nodes)}
    found: list[list[int]] = []
    for body in model.bodies.values():
        nodes = np.array([index[name] for name in body.nodes])
        if len(nodes) < 3:
            continue
        flat = x0[nodes] - x0[nodes].mean(axis=0)
        sizes, axes = np.linalg.svd(flat, full_matrices=False)[1:]
        rank = int((sizes > 1e-6 * sizes[0]).sum())
        if rank == 3:
            found += nodes[ConvexHull(flat).simplices].tolist()
        elif rank == 2:
            ring = nodes[ConvexHull(flat @ axes[:2].T).vertices].tolist()
            found += [[ring[0], ring[k], ring[k + 1]] for k in range(1, len(ring) - 1)]
    return found
