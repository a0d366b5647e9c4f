"""A cell: the unit that a truss is assembled from."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal, TypeVar

from pydantic import Field, model_validator

from kinetruss.errors import Fault, ModelError, shown
from kinetruss.model import (
    Active,
    Bar,
    Filled,
    Gear,
    GimbalPose,
    LeadScrew,
    Length,
    Material,
    Motor,
    Name,
    Node,
    ReadOnly,
    Record,
    Series,
    Table,
    Whole,
    nearest,
    short_form,
)
from kinetruss.model.sections import Section

Triple = Annotated[tuple[Length, ...], Field(min_length=2, max_length=3), Series]
Axis = Literal["x", "y", "z"]
EMPTY: ReadOnly[Any, Any] = ReadOnly()


class Face(Record):
    """The ordered nodes by which cells are joined: corners of a face, in the plane the two ends of an edge.

    Seen from outside the cell they run counter-clockwise (in the plane: the cell is to the right of first -> second); those of
    ``base``, on which the cell stands, are seen from inside. A plain list of nodes is enough.

    origin, axes : frame of the face in closed form, m: a point, and the axes as columns of a matrix (rows are given). By
        default it is measured: centroid, the direction from the first node to the second, normal.
    """

    nodes: Annotated[tuple[Name, ...], Field(min_length=2), Series]
    origin: Triple | None = None
    axes: Annotated[tuple[Triple, ...], Field(min_length=2, max_length=3), Series] | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_nodes(cls, value: Any) -> Any:
        return short_form(value, "nodes")


class Cell(Record):
    """A unit of a truss, drawn in a frame of its own: nodes, members, and the faces by which it is joined to others.

    nodes, bars, active, sections, materials, screws, gears, motors, poses : as of a `Model`, with names of the cell itself.
    faces : by name. A cell stands on its ``base``; the next one of a stack stands on its ``top``.
    on : the face of another cell on which it stands in an assembly, ``CELL.FACE``; the face ``top`` need not be named.
    by : its own face that it stands by. turn : number of corners by which it is turned on the face below.
    at, towards : place of its origin (m) and direction of its z axis (in the plane: y axis), if it stands on no other cell.
    """

    nodes: Filled[Name, Node]
    bars: Table[Name, Bar] = ReadOnly()
    active: Table[Name, Active] = ReadOnly()
    faces: Table[Name, Face] = ReadOnly()
    sections: Table[Name, Section] = ReadOnly()
    materials: Table[Name, Material] = ReadOnly()
    screws: Table[Name, LeadScrew] = ReadOnly()
    gears: Table[Name, Gear] = ReadOnly()
    motors: Table[Name, Motor] = ReadOnly()
    poses: Table[Name, GimbalPose] = ReadOnly()
    on: Name | None = None
    by: Name = "base"
    turn: Whole = 0
    at: Triple | None = None
    towards: Triple | None = None

    @property
    def dim(self) -> int:
        """2 or 3."""
        return len(next(iter(self.nodes.values())).at)

    @property
    def members(self) -> dict[str, Bar | Active]:
        """Bars, then active members."""
        return {**self.bars, **self.active}

    @model_validator(mode="after")
    def _consistent(self) -> Cell:
        if found := [*_member_faults(self), *_face_faults(self), *_place_faults(self)]:
            raise ModelError(found)
        return self


R = TypeVar("R", bound=Record)


def changed(record: R, **changes: Any) -> R:
    """A record with some fields changed; fields that were not given stay so."""
    return type(record)(**{name: getattr(record, name) for name in record.model_fields_set} | changes)


def _member_faults(cell: Cell) -> Iterator[Fault]:
    for table in ("bars", "active"):
        for name, member in getattr(cell, table).items():
            for node in (*member.ends, *(() if member.orientation is None else (member.orientation,))):
                if node not in cell.nodes:
                    yield Fault((table, name), f"there is no node {shown(node)} in the cell.", nearest(node, cell.nodes))
    for name in (one for one in cell.active if one in cell.bars):
        yield Fault(("active", name), "is the name of a bar as well.", "Rename one of the two.")


def _face_faults(cell: Cell) -> Iterator[Fault]:
    for name, face in cell.faces.items():
        if unknown := [node for node in face.nodes if node not in cell.nodes]:
            yield Fault(("faces", name), f"there is no node {shown(unknown[0])} in the cell.", nearest(unknown[0], cell.nodes))
        elif len(set(face.nodes)) < len(face.nodes):
            yield Fault(("faces", name), f"names a node twice: {', '.join(face.nodes)}.", "Name each corner once.")
        elif (len(face.nodes) == 2) != (cell.dim == 2):
            expected = "the two ends of an edge" if cell.dim == 2 else "three nodes or more"
            yield Fault(("faces", name), f"has {len(face.nodes)} nodes; expected {expected}.", "Name its corners.")
    if cell.by != "base" and cell.by not in cell.faces:
        yield Fault(("by",), f"the cell has no face {shown(cell.by)}.", nearest(cell.by, cell.faces))


def _place_faults(cell: Cell) -> Iterator[Fault]:
    for name, node in cell.nodes.items():
        if len(node.at) != cell.dim:
            mend = "Give all nodes of a cell two coordinates, or all three."
            yield Fault(("nodes", name), f"has {len(node.at)} coordinates, the first node {cell.dim}.", mend)
    for key in ("at", "towards"):
        value = getattr(cell, key)
        if value is not None and len(value) != cell.dim:
            yield Fault((key,), f"has {len(value)} components; the cell has {cell.dim}.", f"Give {cell.dim}.")
        elif value is not None and cell.on is not None:
            mend = f"Leave {key} away, or leave `on` away."
            yield Fault((key,), f"is given, but the cell stands on {shown(cell.on)}, which gives its place.", mend)
    if cell.towards is not None and not any(cell.towards):
        yield Fault(("towards",), "is no direction: all components are 0.", "Give for example (0, 0, 1).")
