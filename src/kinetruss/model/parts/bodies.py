"""Bodies: mass in space or in the plane, carried by a few nodes."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, PlainValidator, WithJsonSchema, model_validator

from kinetruss.model._record import Flag, Mass, Name, Number, Point, Record, Series, short_form
from kinetruss.units import parse, shown

__all__ = ["Body", "Frame", "InertiaTensor"]

_KIND = "moment of inertia"


def _tensor(value: Any) -> Any:
    """One number, three principal moments, or the rows of a matrix."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, (list, tuple)):
        return parse(value, _KIND)
    rows = [isinstance(row, (list, tuple)) for row in value]
    if all(rows) and len(value) in (2, 3) and all(len(row) == len(value) for row in value):
        return tuple(tuple(parse(entry, _KIND) for entry in row) for row in value)
    if any(rows) or len(value) != 3:
        raise ValueError(f"{shown(value)} is no inertia. Give one number (plane), three principal moments, or a 3 x 3 matrix.")
    return tuple(parse(entry, _KIND) for entry in value)


_ONE: dict[str, Any] = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_ROW = {"type": "array", "items": _ONE, "minItems": 2, "maxItems": 3}
_SCHEMA = {
    "anyOf": [
        *_ONE["anyOf"],
        {"type": "array", "items": _ONE, "minItems": 3, "maxItems": 3},
        {"type": "array", "items": _ROW, "minItems": 2, "maxItems": 3},
    ],
    "description": "moment of inertia: a number in kg m^2 or text with a unit; three of them; or a matrix",
    "x-unit": "kg m^2",
}
InertiaTensor = Annotated[Any, PlainValidator(_tensor), WithJsonSchema(_SCHEMA)]
"""kg m^2: one number (plane), principal moments about the axes of a frame, or a matrix in it."""

_Axis = Annotated[tuple[Number, ...], Field(min_length=2, max_length=3), Series]


class Frame(Record):
    """Axes fixed in a body, given in the start configuration.

    origin : m, in global axes; 0 if not given. axes : one row each, the unit vectors of the frame in global axes, a right-
    handed set; the global axes if not given.
    """

    origin: Point | None = None
    axes: Annotated[tuple[_Axis, ...], Field(min_length=2, max_length=3), Series] | None = None


class Body(Record):
    """A body with mass, carried by nodes.

    frame : axes fixed in the body in which `center` and `inertia` are given; by default the global axes.
    nodes : the nodes of the body; other bodies and bars share them (joints).
    mass : kg. center : its centre, m, and inertia : about the centre, kg m^2, both in `frame`: one number in the plane;
        in space the three moments about the axes of the frame, or a 3 x 3 matrix. Without them the mass is distributed evenly
        over the line, triangle or tetrahedron of the carriers.
    carriers : the mass-carrying nodes, by default the first three (plane) or four (space) of `nodes`: a tetrahedron, a
        triangle (flat in space), a line.
    kind : ``rigid``, or ``straining``: the body strains evenly with its carriers, which bars may lengthen (in the plane and
        with two carriers: by similarity).
    brace : add the missing rigid bars between the nodes; they have no mass and are called ``BODY.N1-N2``.

    The mass matrix of the nodes' coordinates is constant: m_ij times the unit matrix with m_ij = int L_i L_j dm over the body,
    L_i the barycentric coordinates of the carriers; in the plane two carriers represent the whole body as in `PlanarBody`.
    The concept: J. P. Meijaard and V. van der Wijk, Multibody System Dynamics 48 (2020) 259-282.

    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> list(kt.Model(nodes=corners, bodies={"b": kt.Body(nodes=("O", "X", "Y", "Z"), mass=2.0)}).bars)
    ['b.O-X', 'b.O-Y', 'b.O-Z', 'b.X-Y', 'b.X-Z', 'b.Y-Z']
    """

    nodes: Annotated[tuple[Name, ...], Field(min_length=1), Series]
    mass: Mass = 0.0
    center: Point | None = None
    inertia: InertiaTensor | None = None
    frame: Frame | None = None
    carriers: Annotated[tuple[Name, ...], Field(min_length=1), Series] | None = None
    kind: Literal["rigid", "straining"] = "rigid"
    brace: Flag = True

    @model_validator(mode="before")
    @classmethod
    def _from_nodes(cls, value: Any) -> Any:
        return short_form(value, "nodes")

    def carried_by(self, dim: int) -> tuple[str, ...]:
        """The mass-carrying nodes in a model of dimension 2 or 3."""
        return self.nodes[: dim + 1] if self.carriers is None else self.carriers
