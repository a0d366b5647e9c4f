"""The mirror image of a cell."""

from __future__ import annotations

from kinetruss.errors import ArgumentError, shown
from kinetruss.library.cells.records import Axis, Cell, Face, changed

__all__ = ["mirror", "reversed_face"]

SWAPPED = {"base": "top", "top": "base"}


def mirror(cell: Cell, axis: Axis = "z") -> Cell:
    """The mirror image of a cell, along an axis of its own frame.

    Along the axis in which it is stacked (z; in the plane y) it stands on its head: ``base`` and ``top`` change places. So
    ``stack([cell, mirror(cell)])`` is symmetric about the face between the two. Across it (x, y; in the plane x), left and
    right change; gimbal poses are then dropped, as their frame is not mirrored.

    Mirrored twice, a cell is the same again.

    Raises
    ------
    ArgumentError : no axis of the cell.

    Examples
    --------
    >>> from kinetruss.library import cells
    >>> one = cells.triangle(left=1.2)
    >>> cells.mirror(cells.mirror(one, "x"), "x") == one
    True
    """
    if axis not in (axes := "xyz"[: cell.dim]):
        raise ArgumentError(f"mirror: {shown(axis)} is no axis of this cell. Give one of {', '.join(axes)}.")
    k = axes.index(axis)
    along = k == cell.dim - 1
    faces = {}
    for name, face in cell.faces.items():
        if along and name in SWAPPED:
            faces[SWAPPED[name]] = _kept(face, k)
        else:
            faces[name] = reversed_face(face)
    return changed(
        cell,
        nodes={name: changed(node, at=_turned(node.at, k)) for name, node in cell.nodes.items()},
        faces=faces,
        poses=cell.poses if along else {},
    )


def reversed_face(face: Face) -> Face:
    """The face seen from its other side; the first node stays the first."""
    first, *rest = face.nodes
    return Face(nodes=(first, *rest[::-1]) if len(face.nodes) > 2 else face.nodes[::-1])


def _kept(face: Face, k: int) -> Face:
    """The face mirrored along the axis of the stack, nodes in the same order; its normal points up again."""
    if face.origin is None or face.axes is None:
        return face
    axes = [list(row) for row in face.axes]
    axes[k] = [-value for value in axes[k]]
    return changed(face, origin=_turned(face.origin, k), axes=[[*row[:-1], -row[-1]] for row in axes])


def _turned(at: tuple[float, ...], k: int) -> tuple[float, ...]:
    return (*at[:k], -at[k] if at[k] else at[k], *at[k + 1 :])
