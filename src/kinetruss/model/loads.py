"""Loads on nodes and bodies, moving supports."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Discriminator, Field, Tag, model_validator

from kinetruss.model.in_time import InTime, MomentOf, Shape, Times, check_table, vector_faults
from kinetruss.model.loads_along import MemberCouple, MemberLoad, MemberPointCouple, MemberPointForce, along_faults
from kinetruss.model.record import (
    Flag,
    ForceVector,
    Name,
    Of,
    Point,
    PositiveLength,
    Record,
    Series,
    Time,
)
from kinetruss.model.references import NodeName


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
    times: Times = None
    forces: Annotated[tuple[ForceVector, ...], Series] | None = None


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

_Stress = Annotated[float, Of("stress")]
Moment = Annotated[Any, MomentOf("torque")]


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
    times: Times = None
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
    moment: Moment | None = None
    times: Times = None
    moments: Annotated[tuple[Moment, ...], Series] | None = None
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
    times: Times = None
    pressures: Annotated[tuple[_Stress, ...], Series] | None = None
    depth: PositiveLength = 1.0


ALONG = (MemberLoad, MemberCouple, MemberPointForce, MemberPointCouple)
"""Kinds of loads between the ends of members."""

FAULTS: dict[type, Any] = {NodalForce: vector_faults, **dict.fromkeys(ALONG, along_faults)}
"""What does not fit a model, by kinds; of loads on bodies and faces see `load_checks`."""


def _kind(value: Any) -> str:
    """The type of a load given as a table of fields."""
    if isinstance(value, Record):
        return type(value).__name__
    fields = set(value) if isinstance(value, dict) else set()
    if "member" in fields and "body" not in fields:
        what = "Couple" if fields & {"moment", "moments"} else "Force" if "at" in fields else "Load"
        return f"Member{'Point' if 'at' in fields else ''}{what}"
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
    | Annotated[MemberCouple, Tag("MemberCouple")]
    | Annotated[MemberPointForce, Tag("MemberPointForce")]
    | Annotated[MemberPointCouple, Tag("MemberPointCouple")],
    Discriminator(_kind),
]
