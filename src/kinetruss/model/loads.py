"""Loads on nodes and bodies, load cases, moving supports."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import Discriminator, Field, PlainValidator, Tag, WithJsonSchema, model_validator

from kinetruss.errors import Fault
from kinetruss.model.common_faults import components
from kinetruss.model.links import bends, is_sound, is_straight, length_along
from kinetruss.model.record import (
    Distance,
    Flag,
    ForceVector,
    GravityVector,
    Name,
    Number,
    Of,
    Point,
    PositiveLength,
    Record,
    Series,
    Time,
)
from kinetruss.model.references import LoadName, NodeName, Ref
from kinetruss.model.table import Table
from kinetruss.units import parse

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData

Shape = Literal["spline", "monotone"]
"""The interpolation of a table."""


def check_times(times: tuple[float, ...]) -> None:
    """Times must increase; the message names the first that does not."""
    for index, (before, after) in enumerate(pairwise(times), start=1):
        if after <= before:
            raise ValueError(
                f"time goes back or stands still: entry {index + 1} is {after:g} s after {before:g} s. Sort the table by time."
            )


def check_table(times: tuple[float, ...], values: tuple[object, ...], what: str) -> None:
    """A table has one value for each time, and its times increase."""
    if len(times) != len(values):
        raise ValueError(f"{len(times)} times but {len(values)} {what}. Give one of each.")
    check_times(times)


class InTime(Record):
    """A value, or a table of values in time."""

    amount: ClassVar[str] = "force"
    amounts: ClassVar[str] = "forces"
    """Fields of the value, and of the table."""

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        one, many = self.amount, self.amounts
        value, table, times = (getattr(self, name, None) for name in (one, many, "times"))
        if (value is None) == (table is None):
            has = f"neither a {one} nor a table of {many}" if value is None else f"both a {one} and a table of {many}"
            raise ValueError(f"has {has}. Give one: {one}, or times and {many}.")
        if table is not None:
            if times is None or len(times) != len(table):
                raise ValueError(f"has {len(times or ())} times and {len(table)} {many}. Give one of {many} for each time.")
            if len(times) < 2:
                raise ValueError(f"has a table of {len(times)} times. Give at least two, or one constant {one}.")
            check_times(times)
        return self


class NodalForce(InTime):
    """A force on a node: constant, or a table in time.

    node : on which it acts.
    force : constant force, N.
    times, forces : a table, s and N; linear between its points, constant outside.

    >>> import kinetruss as kt
    >>> kt.NodalForce(node="T", force=(0, "-1.5 kN"))
    NodalForce(node='T', force=(0.0, -1500.0))
    """

    node: NodeName
    force: ForceVector | None = None
    times: Annotated[tuple[Time, ...], Series] | None = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None


class LoadCase(Record):
    """Which loads act.

    loads : name of a load -> factor; all loads with factor 1 where not given.
    gravity : m/s^2, if it differs from that of the model.
    """

    loads: Table[LoadName, Number] | None = None
    gravity: GravityVector | None = None


class History(Record):
    """Displacement of a support from its position in the model. A run beyond the table is refused.

    times : s.
    displacements : m, one row a time; a quintic spline goes through them.
    shape : ``spline``, or ``monotone``, which never overshoots the points, as in `Spline`.
    """

    times: Annotated[tuple[Time, ...], Field(min_length=2), Series]
    displacements: Annotated[tuple[Point, ...], Series]
    shape: Shape = "spline"

    @model_validator(mode="after")
    def _table(self) -> History:
        check_table(self.times, self.displacements, "displacements")
        return self


# Loads on bodies: a force at a point, a couple, a pressure; constant or as tables in time.

_Times = Annotated[tuple[Time, ...], Series] | None
_Stress = Annotated[float, Of("stress")]
LineLoad = Annotated[tuple[Annotated[float, Of("force per length")], ...], Field(min_length=2, max_length=3), Series]


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

    amount, amounts = "moment", "moments"
    body: Name
    moment: _Moment | None = None
    times: _Times = None
    moments: Annotated[tuple[_Moment, ...], Series] | None = None
    follows: Flag = False
    member: Name | None = None

    @model_validator(mode="after")
    def _enters(self) -> BodyCouple:
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

    amount, amounts = "pressure", "pressures"
    face: Annotated[tuple[NodeName, ...], Field(min_length=2, max_length=3), Series]
    pressure: _Stress | None = None
    times: _Times = None
    pressures: Annotated[tuple[_Stress, ...], Series] | None = None
    depth: PositiveLength = 1.0


BEYOND = 1e-9


class AlongMember(InTime):
    """What loads along members have in common."""

    member: Annotated[Name, Ref("bar or beam", "bars", "beams", "links")]
    times: _Times = None
    shape: Annotated[tuple[Number, Number], Series] = (1.0, 1.0)
    start: Distance | None = None
    end: PositiveLength | None = None


class MemberLoad(AlongMember):
    """A force along a member, N/m: uniform or trapezoidal, on all of it or on a part.

    force : constant force a length, N/m. Lengths are those of the model: the whole does not change when the member does.
    times, forces : a table in place of `force`, s and N/m.
    member : name of a bar that is rigid, driven or elastic, of an elastic beam, or of a link with section and material.
    shape : factors of the force where it begins and where it ends, linear in between; (0, 1) is a triangle.
    start, end : where it begins and ends, m from the first end of the member; by default at the ends.
    axes : ``global``: it keeps its direction; ``member``: its components are along the axes of the member, with which it turns
        (1 from the first end to the second; the others as in `strength.sections`).

    >>> import kinetruss as kt
    >>> kt.MemberLoad(member="arm", force=(0, "-2 kN/m"), shape=(0, 1)).force
    (0.0, -2000.0)
    """

    force: LineLoad | None = None
    forces: Annotated[tuple[LineLoad, ...], Series] | None = None
    axes: Literal["global", "member"] = "global"


class MemberCouple(AlongMember):
    """A couple along a bar of a planar model, N m/m, counter-clockwise: uniform or trapezoidal, on all of it or on a part.

    moment : constant couple a length, N m/m.
    times, moments : a table in place of `moment`, s and N m/m.
    member : name of a bar that is rigid, driven or elastic.
    shape : factors of the couple where it begins and where it ends, linear in between; their sum is not 0.
    start, end : where it begins and ends, m from the first end of the member; by default at the ends.

    >>> import kinetruss as kt
    >>> kt.MemberCouple(member="crank", moment="30 N m/m", start=0.1).moment
    30.0
    """

    amount, amounts = "moment", "moments"
    moment: Annotated[float, Of("moment per length")] | None = None
    moments: Annotated[tuple[Annotated[float, Of("moment per length")], ...], Series] | None = None

    @model_validator(mode="after")
    def _whole(self) -> MemberCouple:
        if not sum(self.shape):
            raise ValueError(f"has the shape {self.shape}, whose sum is 0. Give two couples, each on its part of the member.")
        return self


def vector_faults(load: Any, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG001
    """Vectors that have not `dim` components."""
    value, table = getattr(load, load.amount), getattr(load, load.amounts)
    given = [((*path, load.amount), value)] if value is not None else []
    given += [((*path, load.amounts, index), vector) for index, vector in enumerate(table or ())]
    for place, vector in given:
        yield from components(vector, dim, place)


def along_faults(load: AlongMember, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:
    """What does not fit the model: the member, or a place beyond its ends."""
    if load.amount == "force":
        yield from vector_faults(load, model, dim, path)
    if load.member in model.links:
        yield from _along_link(load, model, path)
        return
    one = model.bars.get(load.member) or model.beams.get(load.member)
    if one is None or not all(node in model.nodes for node in one.ends):
        return
    about = (("bars", load.member), ("beams", load.member))
    couple, beam = isinstance(load, MemberCouple), load.member in model.beams
    if couple and (beam or dim == 3):
        message = f"is a couple along {'a beam' if beam else 'a bar in space'}."
        yield Fault((*path, "member"), message, "Name a bar of a planar model, or give couples on bodies.", about=about)
    elif one.kind not in (("elastic",) if beam else ("rigid", "driven", "elastic")):
        message = f"acts along the {one.kind} {'beam' if beam else 'bar'} {load.member!r}."
        mend = "Name an elastic beam." if beam else "Name a rigid, driven or elastic bar: others carry nothing across them."
        yield Fault((*path, "member"), message, mend, about=about)
    yield from _beyond(load, math.dist(*(model.nodes[node].at for node in one.ends)), path, about)


def _along_link(load: AlongMember, model: ModelData, path: tuple[Any, ...]) -> Iterator[Fault]:
    link, about = model.links[load.member], (("links", load.member),)
    if isinstance(load, MemberCouple):
        mend = "Name a bar of a planar model, or give couples on bodies."
        yield Fault((*path, "member"), "is a couple along a link.", mend, about=about)
    elif not bends(model, link):
        message = f"acts along the link {load.member!r}, which has no section or no material."
        yield Fault((*path, "member"), message, "Give the link both, or forces at its nodes.", about=about)
    elif getattr(load, "axes", "") == "member" and len(link.nodes) > 2 and not is_straight(model, link):
        message = f"has axes: member, and the link {load.member!r} is bent."
        yield Fault((*path, "axes"), message, "Give the load in global axes.", about=about)
    elif is_sound(model, link):
        yield from _beyond(load, length_along(model, link), path, about)


def _beyond(load: AlongMember, length: float, path: tuple[Any, ...], about: tuple[tuple[str, str], ...]) -> Iterator[Fault]:
    """Places beyond the ends of a member."""
    start, end = load.start or 0.0, length if load.end is None else load.end
    if max(start, end) > (1.0 + BEYOND) * length:
        message = f"is {max(start, end):.6g} m along {load.member!r}, which is {length:.6g} m long."
        key = "end" if end > length else "start"
        yield Fault((*path, key), message, "Stay between its ends: places count from the first.", about=about)
    elif start >= end:
        message = f"is {start:.6g} m, not before the end at {end:.6g} m."
        yield Fault((*path, "start"), message, "Give start a smaller value than end.", about=about)


FAULTS: dict[type, Any] = {NodalForce: vector_faults, MemberLoad: along_faults, MemberCouple: along_faults}
"""What does not fit a model, by kinds; of loads on bodies and faces see `load_checks`."""


def _kind(value: Any) -> str:
    """The type of a load given as a table of fields."""
    if isinstance(value, Record):
        return type(value).__name__
    fields = set(value) if isinstance(value, dict) else set()
    if "member" in fields and "body" not in fields:
        return "MemberCouple" if fields & {"moment", "moments"} else "MemberLoad"
    if fields & {"moment", "moments"}:
        return "BodyCouple"
    if fields & {"face", "pressure", "pressures"}:
        return "Pressure"
    return "BodyForce" if "body" in fields else "NodalForce"


Load = Annotated[
    Annotated[NodalForce, Tag("NodalForce")]
    | Annotated[BodyForce, Tag("BodyForce")]
    | Annotated[BodyCouple, Tag("BodyCouple")]
    | Annotated[Pressure, Tag("Pressure")]
    | Annotated[MemberLoad, Tag("MemberLoad")]
    | Annotated[MemberCouple, Tag("MemberCouple")],
    Discriminator(_kind),
]
