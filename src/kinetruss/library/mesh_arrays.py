"""Meshes of triangles and tetrahedra by plain arrays, with a name for each node."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.library.building import own_arguments
from kinetruss.model import Membrane, Node, Solid

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


FLIPPED = {3: (0, 2, 1), 4: (0, 2, 1, 3), 6: (0, 2, 1, 5, 4, 3)}
"""A permutation of the nodes of an element that reverses its orientation."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """points (n, 2 or 3) m, elements (k, 3, 4 or 6) rows of their numbers, names (n,) of the nodes they become in a model.

    >>> import kinetruss as kt
    >>> plate = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=2, rows=1)
    >>> model = kt.Model(nodes=plate.nodes, fixed=plate.at(x=0.0), material=kt.Material(E=70e9, density=2700.0),
    ...                  membranes={"plate": plate.membrane(thickness=0.01)})
    >>> len(model.nodes), len(model.membranes["plate"].elements)
    (6, 4)
    """

    points: NDArray[np.float64]
    elements: NDArray[np.int64]
    names: tuple[str, ...]

    @property
    def nodes(self) -> dict[str, Node]:
        """Nodes of a model by name."""
        return {name: Node(at=tuple(point)) for name, point in zip(self.names, self.points.tolist(), strict=True)}

    def at(self, **where: float) -> tuple[str, ...]:
        """Names of the nodes on x, y and z of these values (m), within 1e-9 of the size of the mesh; in the mesh's order."""
        size = float(np.ptp(self.points, axis=0).max())
        good = np.ones(len(self.points), bool)
        for axis, value in where.items():
            good &= np.abs(self.points[:, "xyz".index(axis)] - value) <= 1e-9 * size
        return tuple(self.names[k] for k in np.flatnonzero(good))

    def nearest(self, point: ArrayLike) -> str:
        """Name of the node nearest to a point, m."""
        return self.names[int(np.argmin(np.linalg.norm(self.points - np.asarray(point, float), axis=1)))]

    def renamed(self, names: Mapping[str, str]) -> Mesh:
        """The mesh with some nodes renamed, e.g. to coincide with nodes of bars."""
        return replace(self, names=tuple(names.get(name, name) for name in self.names))

    def moved(self, by: ArrayLike) -> Mesh:
        """The mesh moved by a vector, m."""
        return replace(self, points=self.points + np.asarray(by, float))

    def membrane(self, **fields: Any) -> Membrane:
        """The membrane of its triangles; `fields` are those of `Membrane` (thickness, material, ...)."""
        return Membrane(nodes=self.names, elements=self.elements, **fields)

    def solid(self, **fields: Any) -> Solid:
        """The solid of its tetrahedra; `fields` are those of `Solid`."""
        return Solid(nodes=self.names, elements=self.elements, **fields)


@own_arguments
def mesh(points: ArrayLike, elements: ArrayLike, *, prefix: str = "n") -> Mesh:
    """A mesh of plain arrays: points (n, 2 or 3) m, elements (k, 3, 4 or 6) of point numbers from 0.

    Inverted elements are reversed, and points without elements are left out; nodes are called ``n0``, ``n1``, ... by `prefix`.

    Raises
    ------
    InputError : another shape, or point numbers out of range.

    Examples
    --------
    >>> from kinetruss.library import meshes
    >>> square = meshes.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])
    >>> square.names, square.elements.tolist()
    (('n0', 'n1', 'n2', 'n3'), [[0, 1, 2], [0, 2, 3]])
    """
    x: Any = np.array(points, float)
    rows: Any = np.array(elements, np.int64)
    if x.ndim != 2 or x.shape[1] not in (2, 3) or rows.ndim != 2 or rows.shape[1] not in FLIPPED or not len(rows):
        raise InputError(
            f"points have shape {x.shape}, elements {rows.shape}. Give points (n, 2 or 3), and 3, 4 or 6 point numbers a row."
        )
    if rows.min() < 0 or rows.max() >= len(x):
        raise InputError(f"elements name point {rows.max() if rows.min() >= 0 else rows.min()}; there are 0 to {len(x) - 1}.")
    used, place = np.unique(rows, return_inverse=True)
    x, rows = x[used], place.reshape(rows.shape)
    if rows.shape[1] == 4 or x.shape[1] == 2:
        corners = x[rows[:, : x.shape[1] + 1]]
        turned = np.linalg.det(corners[:, 1:] - corners[:, :1]) < 0
        rows[turned] = rows[turned][:, FLIPPED[rows.shape[1]]]
    return Mesh(points=x, elements=rows, names=tuple(f"{prefix}{k}" for k in range(len(x))))
