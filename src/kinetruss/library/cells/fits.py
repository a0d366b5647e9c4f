"""Do two faces fit on each other? Frames of faces, and the faults of those that do not fit."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinetruss.errors import Fault, ModelError
from kinetruss.library.cells.mirroring import reversed_face
from kinetruss.library.cells.records import Cell, Face

__all__ = ["check_fit", "closing_fault", "corners_of", "fitting_turn", "frame_of", "heading", "is_base"]

Floats = NDArray[np.float64]


def corners_of(name: str, face: Face, *, outside: bool) -> tuple[str, ...]:
    """Nodes of a face, counter-clockwise seen from outside its cell, or from inside. A base is drawn as seen from inside."""
    return face.nodes if is_base(name) != outside else reversed_face(face).nodes


def is_base(name: str) -> bool:
    """True for ``base``, and for ``CELL.base`` of a cell that was joined from others."""
    return name.rpartition(".")[2] == "base"


def frame_of(places: Floats) -> tuple[Floats, Floats]:
    """Centroid (dim,) and axes (dim, dim, as columns) of a face: x along its first edge, the last one normal to the face.

    The normal is that of the vector area; nodes run counter-clockwise about it. In the plane it is the left normal.
    """
    origin, x = places.mean(axis=0), places[1] - places[0]
    if places.shape[1] == 2:
        x /= math.hypot(*x)
        return origin, np.array([[x[0], -x[1]], [x[1], x[0]]])
    arms = places - origin
    z = np.cross(arms, np.roll(arms, -1, axis=0)).sum(axis=0)
    z /= math.sqrt(float(z @ z))
    x -= (x @ z) * z
    x /= math.sqrt(float(x @ x))
    return origin, np.stack([x, np.cross(z, x), z], axis=1)


def heading(cell: Cell) -> Floats:
    """Axes of a cell that stands on no other: its last axis along `towards`, turned there by the shortest way."""
    up = np.eye(cell.dim)[-1]
    if cell.towards is None:
        return np.eye(cell.dim)
    way = np.array(cell.towards) / math.hypot(*cell.towards)
    if cell.dim == 2:
        return np.array([[way[1], way[0]], [-way[0], way[1]]])
    if up @ way < -1 + 1e-12:
        return np.diag([1.0, -1.0, -1.0])
    middle = (up + way) / math.sqrt(float((up + way) @ (up + way)))
    return (np.eye(3) - 2.0 * np.outer(middle, middle)) @ np.diag([1.0, 1.0, -1.0])


def check_fit(
    path: tuple[str, ...], names: tuple[str, str], places: tuple[Floats, Floats], turn: int, tolerance: float
) -> None:
    """Refuse to put a face on another that has another number of corners, or other distances between them.

    names, places : of the face below and of the face above.

    Raises
    ------
    ModelError : they do not fit; the mend says which turn does, if one does.
    """
    below, above = (np.asarray(one) for one in places)
    (low, high), n = names, len(below)
    if len(above) != n:
        mend = "Join faces of the same number of corners."
        raise ModelError([Fault(path, f"{high} has {len(above)} corners, {low} has {n}.", mend)])
    for face, name in ((below, low), (above, high)):
        if _flat(face):
            raise ModelError([Fault(path, f"the corners of {name} lie on one line.", "Join by faces that have an area.")])
    off = _misfit(below, np.roll(above, turn, axis=0))
    if off[0] <= tolerance * off[1]:
        return
    _, wanted, got = off
    turns = [k for k in range(n) if (found := _misfit(below, np.roll(above, k, axis=0)))[0] <= tolerance * found[1]]
    mend = f"Give turn: {turns[0]}." if turns else f"Make its edges {wanted:.6g} m, or taper the cell below."
    raise ModelError(
        [Fault(path, f"{high} does not fit on {low}: two of its corners are {got:.6g} m apart, expected {wanted:.6g} m.", mend)]
    )


def fitting_turn(below: Floats, above: Floats, tolerance: float) -> int | None:
    """By how many corners `below` starts later than `above` where both have the same places; None if they have not."""
    if len(below) != len(above):
        return None
    size = tolerance * float(np.linalg.norm(below[1] - below[0]))
    for turn in range(len(below)):
        if np.linalg.norm(np.roll(below, -turn, axis=0) - above, axis=1).max() <= size:
            return turn
    return None


def closing_fault(path: tuple[str, ...], names: tuple[str, str], above: Floats, below: Floats) -> Fault:
    """The fault of two faces that should lie on each other and do not."""
    first, second = names
    if len(above) != len(below):
        return Fault(
            path, f"{first} has {len(above)} corners, {second} has {len(below)}.", "Join faces of the same number of corners."
        )
    gap = min(float(np.linalg.norm(np.roll(below, -k, axis=0) - above, axis=1).max()) for k in range(len(below)))
    one, other = frame_of(above)[1], frame_of(below)[1]
    angle = math.degrees(math.acos(min(1.0, max(-1.0, float(one[:, -1] @ other[:, -1])))))
    apart = f"up to {gap:.4g} m apart, and the faces make {angle:.4g} deg"
    text = f"corners of {first} and {second} do not meet: they are {apart}."
    return Fault(path, text, "Change the number of cells or their tilt: the tilts of a plane ring add up to 360 deg.")


def _misfit(below: Floats, above: Floats) -> tuple[float, float, float]:
    """Largest difference of two corners' distance, and that distance in both faces, m."""
    worst = (-1.0, 0.0, 0.0)
    for i in range(len(below)):
        for j in range(i):
            wanted, got = (float(np.linalg.norm(face[i] - face[j])) for face in (below, above))
            worst = max(worst, (abs(wanted - got), wanted, got))
    return worst


def _flat(face: Floats) -> bool:
    """True if the corners are on one line; two ends of an edge, if they are one point."""
    spread = np.linalg.svd(face - face.mean(axis=0), compute_uv=False)
    return bool(spread[min(1, face.shape[1] - 2)] <= 1e-9 * max(float(spread[0]), 1e-30))
