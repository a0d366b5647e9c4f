"""Loads on nodes and bodies, load cases, moving supports."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import Discriminator, Field, PlainValidator, Tag, WithJsonSchema, model_validator

from kinetruss.model.record import (
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
from kinetruss.model.references import LoadName, NodeName
from kinetruss.model.table import Table
from kinetruss.units import parse

if TYPE_CHECKING:
    from kinetruss.errors import Fault
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
        value, table, times = getattr(self, one), getattr(self, many), getattr(self, "times", None)
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

    def faults(self, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG002
        """What does not fit the model: by default vectors that have not its dimension."""
        from kinetruss.model import load_checks

        return load_checks.vectors(self, dim, path)


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

    def faults(self, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: D102
        from kinetruss.model import load_checks

        return load_checks.on_body(model, self, dim, path)


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

    def faults(self, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: D102
        from kinetruss.model import load_checks

        return load_checks.on_body(model, self, dim, path)


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

    def faults(self, model: ModelData, dim: int, path: tuple[Any, ...]) -> Iterator[Fault]:  # noqa: ARG002, D102
        from kinetruss.model import load_checks

        return load_checks.face(self, dim, path)


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
