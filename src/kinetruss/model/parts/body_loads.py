"""Loads on bodies: a force at a point, a couple, a pressure; constant or as tables in time."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Discriminator, Field, PlainValidator, Tag, WithJsonSchema, model_validator

from kinetruss.model._record import Flag, ForceVector, Name, Of, Point, PositiveLength, Record, Series, Time
from kinetruss.model.parts.loads import InTime, NodalForce
from kinetruss.units import parse

__all__ = ["BodyCouple", "BodyForce", "Load", "Pressure"]

_Times = Annotated[tuple[Time, ...], Series] | None
_Stress = Annotated[float, Of("stress")]


def _moment(value: Any) -> Any:
    """A number (plane) or three."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, (list, tuple)):
        return parse(value, "torque")
    if len(value) != 3:
        raise ValueError(f"has {len(value)} components. Give one number in a planar model, three in space.")
    return tuple(parse(entry, "torque") for entry in value)


_NUMBER: dict[str, Any] = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_SCHEMA = {
    "anyOf": [*_NUMBER["anyOf"], {"type": "array", "items": _NUMBER, "minItems": 3, "maxItems": 3}],
    "description": "torque: a number in N m or text with a unit; in space three",
    "x-unit": "N m",
}
_Moment = Annotated[Any, PlainValidator(_moment), WithJsonSchema(_SCHEMA)]


class BodyForce(InTime):
    """A force at a point of a body: constant (`force`, N), or a table in time (`times` s, `forces` N; linear between).

    force : constant force, N.
    times, forces : a table in place of `force`, s and N.
    body : name of a body, or of a bar of a planar model that moves as a body.
    at : for a body, the point in the start configuration, global axes, m, by default the centre of mass; for a bar (along,
        left), m along it from its first end and to its left, by default its middle.
    follows : the force turns with the body; else it keeps its direction. Given in global axes of the start configuration.

    Nodal forces L_i(P) F with the barycentric coordinates L_i of the point among the nodes that carry the body; in the plane
    with two nodes, those of a similarity.
    """

    body: Name
    at: Point | None = None
    force: ForceVector | None = None
    times: _Times = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None
    follows: Flag = False

    @model_validator(mode="after")
    def _form(self) -> BodyForce:
        self._one_form("force", "forces")
        return self


class BodyCouple(InTime):
    """A couple on a body, or on a bar of a planar model: `moment`, N m (plane: one number, counter-clockwise), or a table.

    body : name of a body, or of a bar of a planar model that moves as a body.
    moment : constant moment, N m; in the plane one number, counter-clockwise.
    times, moments : a table in place of `moment`, s and N m.
    follows : the moment turns with the body; else it keeps its direction. Given in global axes of the start configuration.
    member : where the body is that of a hub in space (``NODE.hub``, or a hub on the ground), the member through whose joint the
        couple enters. It twists and bends the arm of this member, and its component along the member twists the member.

    Nodal forces f_i = a x (r_i - mean r) with (sum |d|^2 1 - d d^T) a = M: the smallest forces equivalent to the couple.
    """

    body: Name
    moment: _Moment | None = None
    times: _Times = None
    moments: Annotated[tuple[_Moment, ...], Series] | None = None
    follows: Flag = False
    member: Name | None = None

    @model_validator(mode="after")
    def _form(self) -> BodyCouple:
        self._one_form("moment", "moments")
        if self.member is not None and self.follows:
            raise ValueError(
                "enters through a member and follows its body. Leave out follows: give moments in time, global axes."
            )
        return self


class Pressure(InTime):
    """A pressure, Pa, on the face between three nodes, counter-clockwise seen from where it acts; follows the face.

    In the plane on the edge from the first node to the second, to its left, over the `depth`, m. Each node takes an equal part
    of p times the present area.

    face : names of its three nodes in space, of the two of an edge in the plane.
    pressure : constant pressure, Pa.
    times, pressures : a table in place of `pressure`, s and Pa.
    depth : of the structure across the plane, m.
    """

    face: Annotated[tuple[Name, ...], Field(min_length=2, max_length=3), Series]
    pressure: _Stress | None = None
    times: _Times = None
    pressures: Annotated[tuple[_Stress, ...], Series] | None = None
    depth: PositiveLength = 1.0

    @model_validator(mode="after")
    def _form(self) -> Pressure:
        self._one_form("pressure", "pressures")
        return self


def _kind(value: Any) -> str:
    """The type of a load given as a table of fields."""
    if isinstance(value, Record):
        return type(value).__name__
    fields = set(value) if isinstance(value, dict) else set()
    if fields & {"moment", "moments"}:
        return "BodyCouple"
    if fields & {"face", "pressure", "pressures"}:
        return "Pressure"
    return "BodyForce" if "body" in fields else "NodalForce"


Load = Annotated[
    Annotated[NodalForce, Tag("NodalForce")]
    | Annotated[BodyForce, Tag("BodyForce")]
    | Annotated[BodyCouple, Tag("BodyCouple")]
    | Annotated[Pressure, Tag("Pressure")],
    Discriminator(_kind),
]
