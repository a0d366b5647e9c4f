"""Cells joined face to face: places, one set of nodes and members, names, mirror images, faces that fit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.errors import ArgumentError, Fault, ModelError, shown
from kinetruss.library.cells.records import Axis, Cell, Face, changed
from kinetruss.model import Active, Bar, GimbalPose, Model, Node, nearest

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


# The mirror image of a cell.

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
            faces[SWAPPED[name]] = _mirrored(face, k)
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


def _mirrored(face: Face, k: int) -> Face:
    """The face mirrored along the axis of the stack, nodes in the same order; its normal points up again."""
    if face.origin is None or face.axes is None:
        return face
    axes = [list(row) for row in face.axes]
    axes[k] = [-value for value in axes[k]]
    return changed(face, origin=_turned(face.origin, k), axes=[[*row[:-1], -row[-1]] for row in axes])


def _turned(at: tuple[float, ...], k: int) -> tuple[float, ...]:
    return (*at[:k], -at[k] if at[k] else at[k], *at[k + 1 :])


# Cells joined face to face: places, one set of nodes and members, names with the cell before the dot.

Members = dict[str, Bar] | dict[str, Active]
TABLES = ("sections", "materials", "screws", "gears", "motors")
NAMED = {"section": "sections", "material": "materials", "screw": "screws", "gear": "gears", "motor": "motors"}


@dataclass
class Joined:
    """Cells in their places: tables of the whole by name, and what is known of each cell."""

    cells: Mapping[str, Cell]
    on: Mapping[str, str]
    """Cell -> the face that it stands on; the others stand on none."""
    nodes: dict[str, str] = field(default_factory=dict)
    """Name of a node as ``CELL.NODE`` -> its name in the whole, which is that of the cell that had it first."""
    places: dict[str, Floats] = field(default_factory=dict)
    frames: dict[str, tuple[Floats, Floats]] = field(default_factory=dict)

    def prefix(self, cell: str) -> str:
        """What stands before the names of a cell: nothing if it has the empty name."""
        return f"{cell}." if cell else ""

    def corners(self, cell: str, names: tuple[str, ...]) -> list[str]:
        """Names in the whole of nodes of a cell."""
        return [self.nodes[self.prefix(cell) + name] for name in names]

    def at(self, names: list[str]) -> Floats:
        """Places of nodes of the whole, (n, dim), m."""
        return np.array([self.places[name] for name in names])

    def roots(self) -> list[str]:
        """Cells that stand on no other."""
        return [name for name in self.cells if name not in self.on]

    def face(self, given: str, path: tuple[str, ...], placed: Any = None) -> tuple[str, str]:
        """Cell and face of ``CELL.FACE``, or of ``CELL``, which stands for its top.

        Raises
        ------
        ModelError : no such cell before this one, or no such face.
        """
        known = self.cells if placed is None else placed
        places = [len(given), *(k for k in range(len(given) - 1, 0, -1) if given[k] == "."), 0]
        for name, face in ((given[:k], given[k:].removeprefix(".") or "top") for k in places):
            if name in known and face in self.cells[name].faces:
                return name, face
        ends = [self.prefix(name) + face for name in known for face in self.cells[name].faces]
        raise ModelError([Fault(path, f"there is no face {shown(given)} among the cells before.", nearest(given, ends))])

    def tables(self) -> dict[str, Any]:
        """Fields of a `Model` by name."""
        return _Merging(self).tables()

    def cell(self) -> Cell:
        """The whole as a cell: faces ``base`` of the first and ``top`` of the last cell, ``CELL.FACE`` of all others."""
        first, last = next(iter(self.cells)), list(self.cells)[-1]
        faces = {}
        for name, cell in self.cells.items():
            for key, face in cell.faces.items():
                whole = Face(nodes=self.corners(name, face.nodes), **self._framed(name, face))
                faces[self.prefix(name) + key] = whole
                if (name, key) in ((first, "base"), (last, "top")):
                    faces[key] = whole
        return Cell(**self.tables(), faces=faces)

    def model(self, **fields: Any) -> Model:
        """The whole as a model with more fields, e.g. ``gravity``."""
        return Model(**self.tables(), **fields)

    def _framed(self, name: str, face: Face) -> dict[str, Any]:
        if face.origin is None or face.axes is None:
            return {}
        origin, axes = self.frames[name]
        return {"origin": origin + axes @ np.array(face.origin), "axes": (axes @ np.array(face.axes)).tolist()}


def joined(
    cells: Mapping[str, Cell],
    *,
    on: Mapping[str, str] | None = None,
    close: Mapping[str, str] | None = None,
    tolerance: float = 1e-6,
) -> Joined:
    """The cells in their places, in the given order.

    on : cell -> face that it stands on, for cells that name none themselves.
    close : faces of two cells that lie on each other when all are in place, as the last and the first of a ring.
    tolerance : largest difference of two edges that are joined, and gap of two faces that meet, as a fraction of the edge.

    Raises
    ------
    ModelError : cells that do not fit, with where, got, expected, and the mend.
    """
    whole = Joined(cells, {**(on or {}), **{name: cell.on for name, cell in cells.items() if cell.on is not None}})
    dim = next(iter(cells.values())).dim
    for name, cell in cells.items():
        if cell.dim != dim:
            text = f"has {cell.dim} dimensions; the first cell has {dim}."
            raise ModelError([Fault(("cells", name), text, "Join cells of the plane, or cells of space.")])
        _place(whole, name, cell, tolerance)
    for first, second in (close or {}).items():
        _close(whole, first, second, tolerance)
    return whole


def _place(whole: Joined, name: str, cell: Cell, tolerance: float) -> None:
    """Give one cell its place and its nodes their names."""
    shared: dict[str, str] = {}
    if name in whole.on:
        origin, axes, shared = _stood(whole, name, cell, tolerance)
    else:
        origin, axes = np.zeros(cell.dim) if cell.at is None else np.array(cell.at), heading(cell)
    whole.frames[name] = origin, axes
    prefix = whole.prefix(name)
    free = [node for node in cell.nodes if node not in shared]
    drawn = np.array([cell.nodes[node].at for node in free]).reshape(-1, cell.dim)
    for node, place in zip(free, origin + drawn @ axes.T, strict=True):
        if prefix + node in whole.places:
            text = f"there would be two nodes called {shown(prefix + node)}."
            raise ModelError([Fault(("cells", name), text, "Rename the cell.")])
        whole.nodes[prefix + node] = prefix + node
        whole.places[prefix + node] = place
    whole.nodes |= {prefix + node: there for node, there in shared.items()}


def _stood(whole: Joined, name: str, cell: Cell, tolerance: float) -> tuple[Floats, Floats, dict[str, str]]:
    """Origin and axes of a cell on the face that it stands on, and its nodes -> those of the face, by name."""
    path = ("cells", name)
    below, key = whole.face(whole.on[name], path, whole.frames)
    under, mine = whole.cells[below].faces[key], cell.faces.get(cell.by)
    if mine is None:
        raise ModelError([Fault(path, f"has no face {shown(cell.by)} to stand by.", nearest(cell.by, cell.faces))])
    corners = whole.corners(below, corners_of(key, under, outside=True))
    ours = corners_of(cell.by, mine, outside=False)
    low, high = whole.at(corners), np.array([cell.nodes[node].at for node in ours])
    check_fit(path, (whole.prefix(below) + key, f"{name}.{cell.by}"), (low, high), cell.turn, tolerance)
    turned = -cell.turn % len(ours)
    ours, high = ours[turned:] + ours[:turned], np.roll(high, -turned, axis=0)
    there = None if is_base(key) else _standing(whole, below, under)
    here = (np.array(mine.origin), np.array(mine.axes)) if mine.axes and is_base(cell.by) and not turned else None
    if there is None or here is None:
        there, here = frame_of(low), frame_of(high)
    axes = there[1] @ here[1].T
    return there[0] - axes @ here[0], axes, dict(zip(ours, corners, strict=True))


def _standing(whole: Joined, cell: str, face: Face) -> tuple[Floats, Floats] | None:
    """The frame of a face in the whole, if it is known in closed form."""
    if face.origin is None or face.axes is None:
        return None
    origin, axes = whole.frames[cell]
    return origin + axes @ np.array(face.origin), axes @ np.array(face.axes)


def _close(whole: Joined, first: str, second: str, tolerance: float) -> None:
    """Let two faces that lie on each other have the same nodes: those of the second."""
    path = ("close", first)
    (one, key), (other, face) = whole.face(first, path), whole.face(second, path)
    ours = whole.corners(one, corners_of(key, whole.cells[one].faces[key], outside=True))
    theirs = whole.corners(other, corners_of(face, whole.cells[other].faces[face], outside=False))
    turn = fitting_turn(whole.at(theirs), whole.at(ours), tolerance)
    if turn is None:
        raise ModelError([closing_fault(path, (first, second), whole.at(ours), whole.at(theirs))])
    alias = dict(zip(ours, theirs[turn:] + theirs[:turn], strict=True))
    whole.nodes = {node: alias.get(name, name) for node, name in whole.nodes.items()}
    for gone, kept in alias.items():
        if gone != kept:
            del whole.places[gone]


class _Merging:
    """Collects the tables of all cells under their names in the whole."""

    def __init__(self, whole: Joined) -> None:
        self.whole = whole
        self.found: dict[str, dict[str, Any]] = {key: {} for key in ("nodes", "bars", "active", *TABLES, "poses")}
        self.between: dict[frozenset[str], tuple[str, str]] = {}
        """Two nodes -> the cell whose member joins them, and that member."""

    def tables(self) -> dict[str, Any]:
        for name, cell in self.whole.cells.items():
            self._nodes(name, cell)
            renamed = {table: self._records(name, table, getattr(cell, table)) for table in TABLES}
            members = self._members(name, cell, renamed)
            self._poses(name, cell, members)
        return {key: table for key, table in self.found.items() if table}

    def _nodes(self, name: str, cell: Cell) -> None:
        prefix, nodes = self.whole.prefix(name), self.found["nodes"]
        for node, record in cell.nodes.items():
            known = self.whole.nodes[prefix + node]
            if known not in nodes:
                nodes[known] = changed(record, at=tuple(self.whole.places[known].tolist()))
            elif record.mass:
                nodes[known] = _heavier(nodes[known], record, ("cells", name, "nodes", node))

    def _records(self, name: str, table: str, own: Mapping[str, Any]) -> dict[str, str]:
        """New names of records of a cell: equal ones are shared, others get the name of the cell before theirs."""
        found, names = self.found[table], {}
        for key, record in own.items():
            if found.setdefault(key, record) != record:
                names[key] = self.whole.prefix(name) + key
                found[names[key]] = record
        return names

    def _members(self, name: str, cell: Cell, renamed: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
        prefix, names = self.whole.prefix(name), {}
        for table in ("bars", "active"):
            for key, member in getattr(cell, table).items():
                first, second, *third = self.whole.corners(name, (*member.ends, *filter(None, (member.orientation,))))
                pair = frozenset((first, second))
                owner, known = self.between.get(pair, (name, ""))
                if owner != name:  # the cell that was there first has this member
                    self._not_lost(name, table, key, known)
                    names[key] = known
                    continue
                names[key] = prefix + key
                self._free(names[key], ("cells", name, table, key))
                self.between[pair] = name, names[key]
                self.found[table][names[key]] = _renamed(member, (first, second), third, renamed)
        return names

    def _not_lost(self, name: str, table: str, key: str, known: str) -> None:
        moves = [table == "active" or self.whole.cells[name].bars[key].kind == "driven"]
        moves += [known in self.found["active"] or self.found["bars"][known].kind == "driven"]
        if moves[0] and not moves[1]:
            text = f"is active, but lies on {known}, which is not and stays."
            raise ModelError([Fault(("cells", name, table, key), text, f"Make {known} active instead.")])

    def _free(self, name: str, path: tuple[str, ...]) -> None:
        if name in self.found["bars"] or name in self.found["active"]:
            raise ModelError([Fault(path, f"there would be two members called {shown(name)}.", "Rename the cell.")])

    def _poses(self, name: str, cell: Cell, members: Mapping[str, str]) -> None:
        for key, pose in cell.poses.items():
            called = key if not name else name if len(cell.poses) == 1 else self.whole.prefix(name) + key
            drives = tuple(members[drive] for drive in pose.drives)
            self.found["poses"][called] = GimbalPose(base=pose.base, longeron=pose.longeron, drives=drives)


def _renamed(member: Bar | Active, ends: tuple[str, str], third: list[str], renamed: Mapping[str, Mapping[str, str]]) -> Any:
    """A member with the names of the whole."""
    changes: dict[str, Any] = {"ends": ends} | ({"orientation": third[0]} if third else {})
    if any(renamed.values()):
        changes |= _names(member, renamed)
    if isinstance(member, Active) and any(renamed.values()):
        for part in ("base", "tube"):
            if names := _names(getattr(member, part), renamed):
                changes[part] = changed(getattr(member, part), **names)
    return changed(member, **changes)


def _names(record: Any, renamed: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
    """Fields of a record that name another one whose name is different in the whole."""
    found = {}
    for key, table in NAMED.items():
        given = getattr(record, key, None)
        if isinstance(given, str) and given in renamed[table]:
            found[key] = renamed[table][given]
    return found


def _heavier(node: Node, more: Node, path: tuple[str, ...]) -> Node:
    """A node that has the masses of two cells."""
    if node.mass and node.gravity != more.gravity:
        raise ModelError([Fault(path, "has a mass with another gravity than the cell below.", "Give both the same gravity.")])
    return changed(node, mass=node.mass + more.mass, gravity=more.gravity)
