"""Tasks of a structure: what its nodes and platforms are to do in time, whatever the drives must do for it."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, PlainSerializer, TypeAdapter, WithJsonSchema, model_validator

from kinetruss.model._record import (
    Coordinate,
    Flag,
    Name,
    Number,
    Point,
    PositiveForce,
    PositiveNumber,
    PositiveRate,
    PositiveSecondRate,
    PositiveTime,
    Record,
    Time,
)
from kinetruss.model._table import ReadOnly, Table
from kinetruss.model.motion.drives import Direction
from kinetruss.model.motion.trajectories import ConstantRate, Cyclic, Quintic, Sine, Spline, StepResponse, Trapezoid
from kinetruss.model.parts.bodies import Frame

__all__ = [
    "Circle",
    "Combined",
    "Coordinates",
    "Course",
    "Docking",
    "Gimbal",
    "Pointing",
    "Positioning",
    "Reflecting",
    "TARGETS",
    "Target",
    "Way",
]

Law = Literal["quintic", "trapezoid", "constant", "spline"]
Ramp = Annotated[Number, Field(gt=0, le=0.5)]
Objective = Literal["least_change", "stroke_ends", "least_effort", "conditioning"]
Nodes = Annotated[tuple[Name, ...], Field(min_length=2)]


class Way(Record):
    """One coordinate through way points, with timing of its own.

    values : way points, the first at the start of the motion; one value alone is where to go from the present place.
    times : s, one for each; by default equal legs from `start` to `end` (by default 0 and the duration of the task).
    law : of each leg: `quintic` (at rest at way points), `trapezoid` (the same, with `ramp`), `constant` (rates jump at way
        points); or `spline`: one quintic spline through all, which does not stop. dwell : rest at inner way points, s.
    """

    kind: Literal["way"] = "way"
    values: Annotated[tuple[Coordinate, ...], Field(min_length=1)]
    times: tuple[Time, ...] | None = None
    law: Law | None = None
    ramp: Ramp | None = None
    dwell: Time | None = None
    start: Time | None = None
    end: Time | None = None

    @model_validator(mode="after")
    def _times(self) -> Way:
        if self.times is None:
            return self
        if len(self.times) != len(self.values):
            raise ValueError(f"{len(self.values)} way points have {len(self.times)} times. Give one for each.")
        if any(b <= a for a, b in zip(self.times[:-1], self.times[1:], strict=True)):
            raise ValueError("times of way points must increase. Sort them, and drop those that are there twice.")
        if self.start is not None or self.end is not None or self.dwell is not None:
            raise ValueError("has times and also start, end or dwell. Give the times alone, or leave them out.")
        return self


_Timed = Annotated[
    Way | Quintic | Trapezoid | ConstantRate | Sine | Cyclic | StepResponse | Spline, Field(discriminator="kind")
]
_WAY_OR_TRAJECTORY: Any = TypeAdapter(_Timed)
_NUMBER: Any = TypeAdapter(Coordinate)
_NUMBERS: Any = TypeAdapter(Annotated[tuple[Coordinate, ...], Field(min_length=1)])


def _course(value: Any) -> Any:
    """A number, way points, a record with timing of its own, or a function of time."""
    if isinstance(value, Record) or callable(value):
        return value
    if isinstance(value, dict):
        return _WAY_OR_TRAJECTORY.validate_python({"kind": "way"} | value)
    value = value.tolist() if hasattr(value, "tolist") else value
    return (_NUMBERS if isinstance(value, (list, tuple)) else _NUMBER).validate_python(value)


def _plain(value: Any) -> Any:
    return value.model_dump() if isinstance(value, Record) else value


_SCHEMA = {"anyOf": [{"type": "number"}, {"type": "string"}, {"type": "array", "minItems": 1}, {"type": "object"}]}
Course = Annotated[Any, BeforeValidator(_course), PlainSerializer(_plain), WithJsonSchema(_SCHEMA)]
"""The motion of one coordinate: where to go; way points; a `Way` or a trajectory record; in Python a function of time (s) that
returns the value, or value, rate and second rate."""


class Circle(Record):
    """A path of the point of a task, from where it starts: an arc, a circle, a helix.

    centre : a point on its axis, m. axis : direction that the turns are about, right-handed.
    turns : about the axis; negative ones go the other way. rise : along the axis over the whole path, m.
    """

    kind: Literal["circle"] = "circle"
    centre: Point
    axis: Direction = (0.0, 0.0, 1.0)
    turns: Number = 1.0
    rise: Coordinate = 0.0


class _Resolved(Record):
    """How drives are chosen where a task leaves some free, and the drives that take no part.

    objective : ``least_change`` of the drives from where they start (the default); ``stroke_ends``: far from the ends of their
        strokes; ``least_effort``: small drive forces under gravity and loads; ``conditioning``: far from singular positions.
    weights : of drives in the objective, 1 by default. hold : drives that stand still.
    within_stroke : drives keep to their `limits`.
    rate, acceleration : largest magnitudes, of all drives or by name, m/s or rad/s, m/s^2 or rad/s^2; the largest speed of a
        motor limits the rate too. The motion says which limit is not kept.
    force : largest drive force at rest, of all drives or by name, N or N m.
    within_rates : redundant drives are chosen so that all keep these limits; False leaves them where the objective wants them.
    """

    objective: Objective = "least_change"
    weights: Table[Name, PositiveNumber] = ReadOnly()
    hold: tuple[Name, ...] = ()
    within_stroke: Flag = True
    rate: PositiveRate | Table[Name, PositiveRate] | None = None
    acceleration: PositiveSecondRate | Table[Name, PositiveSecondRate] | None = None
    force: PositiveForce | Table[Name, PositiveForce] | None = None
    within_rates: Flag = True


class _Task(_Resolved):
    """Timing and coordinates that all tasks have.

    moves : coordinate -> where it goes (see `Course`); those not named stay as they are at the start.
    free : coordinates that may do anything. duration : s, of moves that have no timing of their own (see `Way`).
    law, ramp : of each leg of such moves (see `Way`). dwell : rest at their inner way points, s.
    """

    COORDINATES: ClassVar[tuple[str, ...]] = ()
    moves: Table[Name, Course] = ReadOnly()
    duration: PositiveTime = 1.0
    law: Law = "quintic"
    ramp: Ramp = 0.25
    dwell: Time = 0.0
    free: tuple[Name, ...] = ()

    @model_validator(mode="after")
    def _names(self) -> _Task:
        known = self.COORDINATES
        for field, names in (("moves", self.moves), ("free", self.free)):
            if known and (odd := [name for name in names if name not in known]):
                raise ValueError(
                    f"{field} has {odd[0]!r}; the coordinates of this task are {', '.join(known)}. Name one of them."
                )
        if both := [name for name in self.free if name in self.moves]:
            raise ValueError(f"{both[0]!r} is free and moves. Keep one.")
        if known and len(self.free) == len(known):
            raise ValueError("leaves all its coordinates free. Keep at least one, or drop the task.")
        return self


class Gimbal(_Task):
    """Gimbal angles ``beta``, ``gamma`` (rad) of the plane of `platform`, seen from that of `base` (by default the global
    axes), as `kinematics.platform` measures them.

    division : ``exact``: the angles reach their ends; ``even``: they do, and every bay of the chain of poses turns by the same
        angles at its own height; ``equal``: every bay turns by an equal share of the angles (Lacy, 1991, chapter 6), which
        reaches other angles: the message says which.
    platform : nodes of the plane, at least three. base : nodes of the plane from which the angles count.
    """

    COORDINATES = ("beta", "gamma")
    kind: Literal["gimbal"] = "gimbal"
    platform: Nodes
    base: Nodes | None = None
    division: Literal["exact", "even", "equal"] = "exact"


class Positioning(_Task):
    """Place ``x``, ``y``, ``z`` (m) of a point: a `node`, the centroid of `nodes`, or a `point` of the platform of `nodes`.

    node : the point. nodes : their centroid is the point, or they carry it.
    point : fixed in the platform of `nodes`, m, in the model's own configuration.
    path : a `Circle` of the point, in place of `moves`.
    """

    COORDINATES = ("x", "y", "z")
    kind: Literal["positioning"] = "positioning"
    node: Name | None = None
    nodes: Nodes | None = None
    point: Point | None = None
    path: Circle | None = None

    @model_validator(mode="after")
    def _one_point(self) -> Positioning:
        if (self.node is None) == (self.nodes is None):
            raise ValueError("needs one point. Give a node, or nodes (their centroid, or with `point` a point fixed in them).")
        if self.point is not None and self.nodes is None:
            raise ValueError("has a point, but no nodes that carry it. Give nodes: the platform that it is fixed in.")
        return self


class Reflecting(_Task):
    """Place ``x``, ``y``, ``z`` (m) of the centroid of `platform`, whose normal halves the angle between the directions to
    `source` and to `target` (points, m): a mirror that throws light from one to the other.

    With coordinates ``source.x`` ... ``target.z`` these points move too. The direction is two coordinates; with the place
    free in one of its three directions there are four.

    platform : nodes of the mirror, at least three. source : where the light comes from, m. target : where it goes, m.
    path : a `Circle` of the centroid, in place of moves of its place.
    """

    COORDINATES = ("x", "y", "z", "source.x", "source.y", "source.z", "target.x", "target.y", "target.z")
    kind: Literal["reflecting"] = "reflecting"
    platform: Nodes
    source: Point
    target: Point
    path: Circle | None = None


class Docking(_Task):
    """Place ``x``, ``y``, ``z`` (m) and turns ``roll``, ``pitch``, ``yaw`` (rad; R = Rz(yaw) Ry(pitch) Rx(roll)) of a frame
    fixed in `platform`; as `kinematics.pose` measures them. In the plane ``x``, ``y``, ``yaw``.

    platform : nodes that carry the frame.
    frame : origin and axes in the model's own configuration; by default the centroid and the global axes.
    path : a `Circle` of the origin, in place of moves of its place.
    """

    COORDINATES = ("x", "y", "z", "roll", "pitch", "yaw")
    kind: Literal["docking"] = "docking"
    platform: Nodes
    frame: Frame | None = None
    path: Circle | None = None


class Pointing(_Task):
    """A direction: the normal of `platform`, or the `line` from one node to another.

    It points at the place `at` (m), which moves with ``x``, ``y``, ``z``; without one it has the angles ``beta``, ``gamma`` of
    `Gimbal` in the global axes: the direction (-sin gamma, -sin beta cos gamma, cos beta cos gamma).

    platform : nodes whose plane has the normal, at least three. line : from the first node to the second.
    at : the place that it points at, m.
    """

    COORDINATES = ("beta", "gamma", "x", "y", "z")
    kind: Literal["pointing"] = "pointing"
    platform: Nodes | None = None
    line: tuple[Name, Name] | None = None
    at: Point | None = None

    @model_validator(mode="after")
    def _one_direction(self) -> Pointing:
        if (self.platform is None) == (self.line is None):
            raise ValueError("needs one direction. Give platform (its normal) or line (two nodes).")
        angles = {"beta", "gamma"} & {*self.moves, *self.free}
        if self.at is not None and angles:
            raise ValueError(
                f"points at a place, and {sorted(angles)[0]!r} is named too. Move x, y, z of the place, or drop `at`."
            )
        if self.at is None and (places := {"x", "y", "z"} & {*self.moves, *self.free}):
            raise ValueError(f"moves {sorted(places)[0]!r} of a place that is not given. Give `at`, or move beta and gamma.")
        return self


class Coordinates(_Task):
    """Any coordinates by name: ``N8.x``, ``follower.angle``, ``M7`` (a length), ``bay.beta`` of a pose, a drive.

    Only those that are named in `moves` are prescribed.
    """

    kind: Literal["coordinates"] = "coordinates"

    @model_validator(mode="after")
    def _some(self) -> Coordinates:
        if not self.moves:
            raise ValueError("moves nothing. Name coordinates, e.g. moves={'N8.x': 0.2}.")
        return self


_One = Gimbal | Positioning | Reflecting | Docking | Pointing | Coordinates
_Trajectory = Quintic | Trapezoid | ConstantRate | Sine | Cyclic | StepResponse | Spline
_Single = Annotated[_One | _Trajectory, Field(discriminator="kind")]


class Combined(_Resolved):
    """Several tasks at once, each with its own timing; the duration is the longest. Drives are chosen for all together, by the
    objective given here.

    tasks : tasks, and trajectories of coordinates, without an objective of their own.
    """

    kind: Literal["combined"] = "combined"
    tasks: Annotated[tuple[_Single, ...], Field(min_length=1)]

    @property
    def duration(self) -> float:
        """s."""
        return max(task.duration for task in self.tasks)

    @model_validator(mode="after")
    def _one_choice(self) -> Combined:
        for k, task in enumerate(self.tasks):
            own = [name for name in _Resolved.model_fields if getattr(task, name, _Resolved.model_fields[name].default)
                   != _Resolved.model_fields[name].default]  # fmt: skip
            if own:
                raise ValueError(f"task {k + 1} has {own[0]} of its own, but drives are chosen for all together. Give it here.")
        return self


Target = Annotated[_One | Combined | _Trajectory, Field(discriminator="kind")]
"""What a run's `targets` holds: a task, or a trajectory of node coordinates."""
TARGETS = (Gimbal, Positioning, Reflecting, Docking, Pointing, Coordinates, Combined)
