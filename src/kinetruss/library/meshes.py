"""Meshes for membranes and solids: uniform ones, plain arrays, files of meshio."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.late import listed
from kinetruss.library.building import own_arguments
from kinetruss.library.mesh_arrays import Mesh, mesh
from kinetruss.limits import MOST_ENTRIES, hold, whole

__all__ = ["Mesh", "box", "mesh", "read", "rectangle"]

__dir__ = listed(__name__)


@own_arguments
def rectangle(*, width: float, height: float, columns: int, rows: int, six_nodes: bool = False, prefix: str = "n") -> Mesh:
    """A rectangle from the origin, width along x and height along y (m), of columns x rows cells with two triangles each.

    Diagonals alternate. six_nodes : triangles with nodes in the middles of their sides.

    >>> from kinetruss.library import meshes
    >>> plate = meshes.rectangle(width=2.0, height=1.0, columns=2, rows=1)
    >>> len(plate.names), len(plate.elements)
    (6, 4)
    """
    step = 2 if six_nodes else 1
    _fits({"columns": columns, "rows": rows}, step)
    across, up = step * columns + 1, step * rows + 1
    x, y = np.meshgrid(np.linspace(0, width, across), np.linspace(0, height, up))
    number = np.arange(across * up).reshape(up, across)
    found = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = ((j, i), (j, i + 1), (j + 1, i + 1), (j + 1, i))
            two = ((a, b, c), (a, c, d)) if (i + j) % 2 else ((a, b, d), (b, c, d))
            for corners in two:
                grid = [(step * p, step * q) for p, q in corners]
                if six_nodes:
                    grid += [((grid[k][0] + grid[k - 2][0]) // 2, (grid[k][1] + grid[k - 2][1]) // 2) for k in (0, 1, 2)]
                found.append([number[at] for at in grid])
    return mesh(np.stack([x.reshape(-1), y.reshape(-1)], axis=1), found, prefix=prefix)


@own_arguments
def box(*, size: Sequence[float], cells: Sequence[int], prefix: str = "n") -> Mesh:
    """A box from the origin, size (x, y, z) m, with this number of cells along each axis and six tetrahedra in each cell.

    All cells are split in the same way, along the diagonal from their lowest to their highest corner (Kuhn), so neighbours
    match.

    >>> from kinetruss.library import meshes
    >>> block = meshes.box(size=(2.0, 1.0, 1.0), cells=(2, 1, 1))
    >>> len(block.names), len(block.elements)  # 3 x 2 x 2 nodes, six tetrahedra in each of two cells
    (12, 12)
    """
    _fits(dict(zip(("cells along x", "cells along y", "cells along z"), cells, strict=True)))
    counts = np.array(cells, np.int64)
    axes = [np.linspace(0, length, count + 1) for length, count in zip(size, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    stride = np.array([(counts[1] + 1) * (counts[2] + 1), counts[2] + 1, 1])
    lowest = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(-1, 3) @ stride
    ways = np.array([np.cumsum([0, *stride[list(order)]]) for order in permutations(range(3))])
    return mesh(points, (lowest[:, None, None] + ways).reshape(-1, 4), prefix=prefix)


def _fits(cells: Mapping[str, int], step: int = 1) -> None:
    """Refuse a grid with more nodes than a model may have; `step` nodes along each side of a cell."""
    count = math.prod(step * whole(many, name) + 1 for name, many in cells.items())
    hold(count, "A mesh of so many cells", "Take fewer cells.", most=MOST_ENTRIES, of="nodes")


@own_arguments
def read(source: Any, *, dim: int | None = None, prefix: str = "n") -> Mesh:
    """The triangles, six-node triangles or tetrahedra of a meshio mesh, or of a file that meshio reads (vtu, msh, inp, ...).

    Parameters
    ----------
    source : path, or a mesh with `points` and `cells_dict` like those of meshio. dim : 2 drops z; by default 2 if all
        triangles lie in z = 0. prefix : of the names of the nodes.

    Raises
    ------
    InputError : meshio is not installed, or the mesh has cells of none of these kinds, or of several.

    Tetrahedra with triangles are accepted: the triangles are their surface.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> import numpy as np
    >>> from kinetruss.library import meshes
    >>> points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    >>> given = SimpleNamespace(points=points, cells_dict={"triangle": np.array([[0, 1, 2]])})
    >>> meshes.read(given).points.tolist()  # all in z = 0: a mesh of the plane
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
    """
    found = _opened(Path(source)) if isinstance(source, str | Path) else source
    cells = {kind: np.asarray(rows) for kind, rows in found.cells_dict.items()}
    points = np.asarray(found.points, float)
    kinds = [kind for kind in ("tetra", "triangle6", "triangle") if kind in cells]
    if not kinds or (kinds[0] != "tetra" and len(kinds) > 1):
        raise InputError(
            f"The mesh has cells of the kinds {', '.join(cells) or 'none'}. Give triangle, triangle6 or tetra cells."
        )
    rows = cells[kinds[0]]
    if points.shape[1] == 3 and kinds[0] != "tetra" and (dim == 2 or (dim is None and not points[rows, 2].any())):
        points = points[:, :2]
    return mesh(points, rows, prefix=prefix)


def _opened(path: Path) -> Any:
    try:
        import meshio
    except ImportError:
        raise InputError("Mesh files are read by meshio. Install it: pip install 'kinetruss[mesh]'.") from None
    if not path.is_file():
        raise InputError(f"There is no mesh file {path}. Check the name.")
    return meshio.read(path)
