"""Tasks of a structure: what its nodes and platforms are to do in time, and their cross-checks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, PlainSerializer, TypeAdapter, WithJsonSchema, model_validator

from kinetruss.errors import Fault
from kinetruss.model.attitudes import Attitude
from kinetruss.model.bodies import Frame
from kinetruss.model.common_faults import other_quantity
from kinetruss.model.drives import Direction, turns
from kinetruss.model.record import (
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
from kinetruss.model.references import DriveName, NodeName, Ref, Unread, unknown_names
from kinetruss.model.table import ReadOnly, Table
from kinetruss.model.trajectories import ConstantRate, Cyclic, Quintic, Sine, Spline, StepResponse, Trapezoid

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData
    from kinetruss.model.the_model import Model


Law = Literal["quintic", "trapezoid", "constant", "spline"]
Ramp = Annotated[Number, Field(gt=0, le=0.5)]
Objective = Literal["least_change", "stroke_ends", "least_effort", "conditioning"]
Rates = PositiveRate | Table[DriveName, PositiveRate]
Accelerations = PositiveSecondRate | Table[DriveName, PositiveSecondRate]
Forces = PositiveForce | Table[DriveName, PositiveForce]
"""Of all drives, or by name."""
Nodes = Annotated[tuple[NodeName, ...], Field(min_length=2)]


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
    weights: Table[DriveName, PositiveNumber] = ReadOnly()
    hold: tuple[DriveName, ...] = ()
    within_stroke: Flag = True
    rate: Rates | None = None
    acceleration: Accelerations | None = None
    force: Forces | None = None
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
    node: NodeName | None = None
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
    attitude : in space, in place of the three turns: where the axes of the frame point at the end, in global axes, as a
        rotation vector (rad), a quaternion (w, x, y, z), a rotation matrix (columns are the axes) or the directions of two
        axes, ``{z: .., x: ..}``. The frame gets there by the shortest turn, about one axis, with the `law`.
    path : a `Circle` of the origin, in place of moves of its place.
    """

    COORDINATES = ("x", "y", "z", "roll", "pitch", "yaw")
    kind: Literal["docking"] = "docking"
    platform: Nodes
    frame: Frame | None = None
    attitude: Attitude | None = None
    path: Circle | None = None

    @model_validator(mode="after")
    def _one_attitude(self) -> Docking:
        if self.attitude is not None and (turns := {"roll", "pitch", "yaw"} & {*self.moves, *self.free}):
            raise ValueError(f"has an attitude, and {sorted(turns)[0]!r} is named too. Keep one.")
        return self


class Pointing(_Task):
    """A direction: the normal of `platform`, or the `line` from one node to another.

    It points at the place `at` (m), which moves with ``x``, ``y``, ``z``; without one it has the angles ``beta``, ``gamma`` of
    `Gimbal` in the global axes: the direction (-sin gamma, -sin beta cos gamma, cos beta cos gamma). Or it turns to a
    `direction` in space by the shortest way, with the `law`.

    platform : nodes whose plane has the normal, at least three. line : from the first node to the second.
    at : the place that it points at, m. direction : x, y, z or three numbers, global axes, of any length but 0.
    roll : with a direction, of the platform about its normal: ``free``, or ``held``: it does not turn about its normal, so that
        the whole platform makes the shortest turn.
    """

    COORDINATES = ("beta", "gamma", "x", "y", "z")
    kind: Literal["pointing"] = "pointing"
    platform: Nodes | None = None
    line: tuple[NodeName, NodeName] | None = None
    at: Point | None = None
    direction: Direction | None = None
    roll: Literal["free", "held"] = "free"

    @model_validator(mode="after")
    def _one_direction(self) -> Pointing:
        if (self.platform is None) == (self.line is None):
            raise ValueError("needs one direction. Give platform (its normal) or line (two nodes).")
        if self.direction is not None and (named := [*self.moves, *self.free]):
            raise ValueError(f"turns to a direction, and {named[0]!r} is named too. Keep one.")
        if self.direction is not None and self.at is not None:
            raise ValueError("has a direction and a place `at` to point at. Keep one.")
        if self.roll == "held" and (self.direction is None or self.line is not None):
            raise ValueError("holds its roll, which a platform that turns to a direction can. Give platform and direction.")
        angles = {"beta", "gamma"} & {*self.moves, *self.free}
        if self.at is not None and angles:
            raise ValueError(
                f"points at a place, and {sorted(angles)[0]!r} is named too. Move x, y, z of the place, or drop `at`."
            )
        if self.at is None and (places := {"x", "y", "z"} & {*self.moves, *self.free}):
            raise ValueError(f"moves {sorted(places)[0]!r} of a place that is not given. Give `at`, or move beta and gamma.")
        return self


def _coordinates(model: ModelData) -> list[str]:
    """Every coordinate of a structure by name."""
    known = {*model.all_drives, *model.members, *(f"{member}.length" for member in model.members)}
    known |= {f"{node}.{axis}" for node in model.nodes for axis in "xyz"[: model.dim]}
    known |= {f"{pose}.{part}" for pose in model.poses for part in ("beta", "gamma", "height")}
    known |= {f"{member}.angle" for member in model.members} if model.dim == 2 else set()
    return sorted(known)


class Coordinates(_Task):
    """Any coordinates by name: ``N8.x``, ``follower.angle``, ``M7`` (a length), ``bay.beta`` of a pose, a drive.

    Only those that are named in `moves` are prescribed.
    """

    kind: Literal["coordinates"] = "coordinates"
    moves: Table[Annotated[Name, Ref("coordinate", "drives", "bars", "active", known=_coordinates)], Course] = ReadOnly()

    @model_validator(mode="after")
    def _some(self) -> Coordinates:
        if not self.moves:
            raise ValueError("moves nothing. Name coordinates, e.g. moves={'N8.x': 0.2}.")
        return self


_One = Gimbal | Positioning | Reflecting | Docking | Pointing | Coordinates
_Trajectory = Annotated[Quintic | Trapezoid | ConstantRate | Sine | Cyclic | StepResponse | Spline, Unread()]
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


# Faults of tasks of a structure: names that the model does not have, and tasks that contradict it or themselves.

Place = tuple[Any, ...]
ANGLES = ("beta", "gamma", "roll", "pitch", "yaw", "angle")
"""Coordinates that are angles, by the end of their names."""
SPATIAL = ("gimbal", "pointing", "reflecting")


def target_faults(model: Model, target: Any, path: Place = ("targets",)) -> Iterator[Fault]:
    """Faults of a task, or of tasks that are combined, against a model.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> lift = kt.Positioning(node="C", moves={"y": 2.0})
    >>> [fault.message for fault in kt.model.target_faults(model, lift)]
    ["no node called 'C'."]
    """
    if isinstance(target, TARGETS):  # trajectories move coordinates of nodes here
        yield from unknown_names(model.whole, target, path)
    yield from target_rules(model.whole, target, path)


def target_rules(model: ModelData, target: Any, path: Place) -> Iterator[Fault]:
    """Tasks that contradict the model or themselves."""
    if isinstance(target, TARGETS) and model.all_drives and set(target.hold) >= set(model.all_drives):
        yield Fault((*path, "hold"), "holds all drives, so nothing can move.", "Hold fewer.")
    if not isinstance(target, Combined):
        yield from _single(model, target, path)
        return
    asked: dict[Any, int] = {}
    for k, task in enumerate(target.tasks):
        yield from _single(model, task, (*path, "tasks", k))
        for one in _asked(model, task):
            if one in asked:
                of, mend = one[0], "Ask for it once; or leave it free in one of them."
                of = of if isinstance(of, str) else ", ".join(of)
                yield Fault((*path, "tasks", k), f"asks for {one[-1]!r} of {of}, as task {asked[one] + 1} does.", mend)
                break
            asked[one] = k


def _single(model: ModelData, task: Any, path: Place) -> Iterator[Fault]:
    if not isinstance(task, TARGETS) or isinstance(task, Combined):
        return
    for field in ("node", "nodes", "platform", "base", "line"):
        given = getattr(task, field, None)
        names = (given,) if isinstance(given, str) else given or ()
        yield from _group(model, task, field, names, path)
    if task.kind in SPATIAL and model.dim == 2:
        yield Fault(path, f"{task.kind} is a task in space; the model is planar.", "Use coordinates, positioning or docking.")
    if model.dim == 2 and (odd := [n for n in (*task.moves, *task.free) if n in ("z", "roll", "pitch")]):
        yield Fault((*path, "moves"), f"{odd[0]!r} is no coordinate in the plane.", "Use x, y, yaw.")
    if model.dim == 2 and getattr(task, "attitude", None) is not None:
        yield Fault((*path, "attitude"), "is one in space; the model is planar.", "Move yaw.")
    if isinstance(task, Gimbal) and task.division != "exact" and not model.poses:
        yield Fault(
            (*path, "division"),
            "the model has no poses, so there are no bays.",
            "Give the poses of the bays, or division: exact.",
        )
    if isinstance(task, Coordinates):
        for name in task.moves:
            node, _, axis = name.rpartition(".")
            if node in model.nodes and axis in model.fixed.get(node, ""):
                mend = "Name another coordinate, or release the support."
                yield Fault((*path, "moves", name), "is fixed and cannot move.", mend)
    for name, course in task.moves.items():
        yield from _course_faults(model, task, name, course, (*path, "moves", name))


def _course_faults(model: ModelData, task: Any, name: str, course: Any, path: Place) -> Iterator[Fault]:
    """Values in units of another kind, and way points after the end."""
    last = name.rpartition(".")[2]
    drive = model.all_drives.get(name) if isinstance(task, Coordinates) else None
    kind = "angle" if last in ANGLES or (drive is not None and turns(drive)) else "length"
    values = course.values if isinstance(course, Way) else course if isinstance(course, tuple) else (course,)
    other = [given for value in values if (given := getattr(value, "quantity", None)) not in (None, kind)]
    if other:
        yield other_quantity(path, "moves", other[0], kind)
    if not isinstance(course, Way):
        return
    last_time = course.times[-1] if course.times is not None else course.end
    if last_time is not None and last_time > task.duration * (1 + 1e-9):
        yield Fault(
            path,
            f"ends at {last_time:g} s, but the task at {task.duration:g} s, so the last way point is not reached.",
            f"Give duration: {last_time:g}, or earlier times.",
        )


def _group(model: ModelData, task: Any, field: str, names: Sequence[str], path: Place) -> Iterator[Fault]:
    """Nodes that are to carry a plane or a frame."""
    if field == "node" and names:
        yield from _held(model, task, names[0], (*path, field))
    if field in ("node", "line") or not names:
        return
    plain = task.kind == "positioning" and task.point is None
    least = 1 if plain else model.dim
    if len(set(names)) != len(names):
        yield Fault((*path, field), "names a node twice.", "Name each once.")
    elif len(names) < least:
        yield Fault((*path, field), f"has {len(names)} nodes; a platform has {least} at least.", "Name more.")
    elif field in ("platform", "nodes") and all(name in model.fixed and len(model.fixed[name]) == model.dim for name in names):
        yield Fault((*path, field), "all its nodes are fixed, so it cannot move.", "Name nodes that move.")


def _held(model: ModelData, task: Any, node: str, path: Place) -> Iterator[Fault]:
    """Coordinates of a node that supports hold."""
    axes = [axis for axis in "xyz" if axis in model.fixed.get(node, "") and axis not in task.free]
    if moved := [axis for axis in axes if axis in task.moves]:
        yield Fault(path, f"{node!r} is fixed in {moved[0]} and cannot move there.", "Name a node that moves.")
    elif axes:
        text = f"{node!r} is fixed in {axes[0]}, so there is nothing for the drives to hold."
        yield Fault(path, text, f"Give free: [{', '.join(axes)}].")


def _asked(model: ModelData, task: Any) -> list[Any]:
    """What a task asks for, so that the same is not asked for twice."""
    if not isinstance(task, TARGETS):
        return []
    if isinstance(task, Coordinates):
        return [("coordinates", name) for name in task.moves]
    what = (
        task.node
        if task.kind == "positioning" and task.node
        else getattr(task, "platform", None) or getattr(task, "nodes", None)
    )
    if isinstance(task, Pointing) and task.line is not None:
        what = task.line
    names = [name for name in task.COORDINATES if name not in task.free]
    if task.kind == "positioning":
        if task.node is not None:
            return [("coordinates", f"{task.node}.{axis}") for axis in "xyz"[: model.dim] if axis in names]
        return [(what, task.point, name) for name in names]
    return [(what, task.kind if task.kind != "docking" else "", name) for name in names]
