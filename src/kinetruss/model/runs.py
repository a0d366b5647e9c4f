"""Named runs, and the operating conditions under which they are done."""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

from pydantic import Field, model_validator

from kinetruss.limits import MOST_COUNT, MOST_SAMPLES, MOST_STATIONS
from kinetruss.model.drives import CoordinateName
from kinetruss.model.record import (
    Coordinate,
    Flag,
    ForceVector,
    GravityVector,
    Mass,
    Name,
    Number,
    Point,
    PositiveNumber,
    Record,
    Span,
    Spin,
    SpinRate,
    Stiffness,
    Time,
    Whole,
)
from kinetruss.model.references import ConditionName, DriveName, LoadCaseNames, MemberName, MotionName, NodeName
from kinetruss.model.simulation import Event, Method, Task
from kinetruss.model.table import ReadOnly, Table
from kinetruss.model.targets import Combined, Target
from kinetruss.model.tracking import Tracking
from kinetruss.model.trajectories import TrajectoryOrName


class BaseRotation(Record):
    """A base that rotates with everything that stands on it; node motions stay relative to it.

    angular_velocity, angular_acceleration : rad/s, rad/s^2, along the axes of the base, [about z] in the plane; they hold
        during the whole motion. center : m, the point about which the base rotates, by default the origin.
    gravity_turns : gravity, that of load cases too, keeps its direction in space and so turns as seen from the base; as given
        it is the one at 0 s. By default it stays along the axes of the base. With a constant angular velocity only.
    """

    angular_velocity: Spin | None = None
    angular_acceleration: SpinRate | None = None
    center: Point | None = None
    gravity_turns: Flag = False

    @model_validator(mode="after")
    def _rotates(self) -> BaseRotation:
        if self.angular_velocity is None and self.angular_acceleration is None:
            raise ValueError(
                "has neither angular_velocity nor angular_acceleration. Write for example angular_velocity: [0, 0, 2 rad/s], "
                "in the plane [2 rad/s]."
            )
        if self.gravity_turns and any(self.angular_acceleration or ()):
            raise ValueError(
                "has gravity_turns and an angular_acceleration: the way in which the base has turned then is not known. "
                "Give one of them."
            )
        return self


class Condition(Record):
    """A state in which the structure works: weight, payloads, base acceleration, temperature, disturbed actuators.

    gravity : m/s^2, in place of that of the model and of every load case; nodes with a gravity of their own keep it.
    payloads : node -> mass, kg, added there. forces : node -> force, N, added to every load case.
    base_acceleration : m/s^2, of the supports with everything that stands on them, translation; node motions stay relative
        to the base. Weights change to those under gravity minus it (d'Alembert). Of a base that rotates: of its center.
    base_rotation : in place of that of the model; see `BaseRotation`.
    temperature : difference from the temperature of the model's lengths, K, of all members; temperatures : member -> K,
        instead of it. See `Material.thermal_expansion`. Driven lengths stay as commanded, bodies and continua as they are.
    locked : drives held at their value in the model, whatever their commands are.
    released : drives that carry no force.
    failed : members taken out, with their mass.
    """

    gravity: GravityVector | None = None
    payloads: Table[NodeName, Mass] = ReadOnly()
    forces: Table[NodeName, ForceVector] = ReadOnly()
    base_acceleration: GravityVector | None = None
    base_rotation: BaseRotation | None = None
    temperature: Number = 0.0
    temperatures: Table[MemberName, Number] = ReadOnly()
    locked: tuple[DriveName, ...] = ()
    released: tuple[DriveName, ...] = ()
    failed: tuple[MemberName, ...] = ()

    @model_validator(mode="after")
    def _one_fate(self) -> Condition:
        seen: dict[str, str] = {}
        for fate in ("locked", "released", "failed"):
            for name in getattr(self, fate):
                if name in seen:
                    raise ValueError(f"{name!r} is {seen[name]} and {fate}. Name it once.")
                seen[name] = fate
        return self

    @property
    def moves_otherwise(self) -> bool:
        """True if motions under it are others than without it."""
        changed = (self.temperature, self.temperatures, self.locked, self.released, self.failed)
        return any(bool(one) for one in changed)


# Named runs: the analyses of a model.

STANDING = (
    "For a structure that stands still the analysis is statics.linear, statics.equilibrium, or statics.at_poses with poses."
)
"""The fix for a run of a structure that does not move."""

Analysis = Literal[
    "dynamics.inverse",
    "kinematics.follow",
    "dynamics.simulate",
    "statics.linear",
    "statics.equilibrium",
    "statics.at_poses",
    "statics.deflection",
    "flexible.corrected",
    "flexible.frequencies",
    "flexible.vibration",
    "mission",
]

MISSION = "mission"
STATIC = tuple(name for name in get_args(Analysis) if name.startswith("statics."))
"""Analyses of structures that stand still, or, for the deflection, of small displacements from a motion."""
FLEXIBLE = tuple(name for name in get_args(Analysis) if name.startswith("flexible."))
"""Analyses of elastic members along a motion."""

_MOTION = ("trajectory", "motion", "targets", "samples")
_USED = {
    "dynamics.inverse": _MOTION,
    "kinematics.follow": _MOTION,
    "dynamics.simulate": ("trajectory", "samples", "t_end", "tasks", "feedback", "method", "events"),
    "statics.linear": (),
    "statics.equilibrium": ("tasks",),
    "statics.at_poses": (*_MOTION, "poses"),
    "statics.deflection": _MOTION,
    **dict.fromkeys(FLEXIBLE, (*_MOTION, "elastic")),
    MISSION: ("motions", "conditions", "samples"),
}
"""The fields of each analysis besides load cases, stations and condition."""

_OWN = (
    "trajectory",
    "motion",
    "targets",
    "samples",
    "t_end",
    "tasks",
    "feedback",
    "method",
    "events",
    "poses",
    "motions",
    "conditions",
    "elastic",
)


_ELASTIC = {
    "flexible.corrected": ("at", "drives"),
    "flexible.frequencies": ("modes",),
    "flexible.vibration": ("damping", "rest", "tolerance"),
}
"""The options of each analysis besides stiffness and rigid."""


class Elastic(Record):
    """Options of a run of elastic members along a motion: the arguments of `flexible.corrected` and its neighbours.

    stiffness : member -> N/m, in place of E A/l. rigid : members kept inextensible.
    Of ``flexible.corrected``: at : coordinates that shall have the values of the rigid motion. drives : those that are changed;
    None: all driven lengths. Of ``flexible.frequencies``: modes : number of modes. Of ``flexible.vibration``: damping : ratio
    of the lowest mode; rest : s after the end of a motion that ends at rest, for its residual; tolerance : change of the
    displacements, as a fraction of the largest, at which steps are short enough.
    """

    stiffness: Table[MemberName, Stiffness] = ReadOnly()
    rigid: tuple[MemberName, ...] = ()
    at: tuple[Name, ...] = ()
    drives: tuple[DriveName, ...] | None = None
    modes: Annotated[Whole, Field(ge=1)] = 6
    damping: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    rest: Annotated[Time, Field(ge=0)] = 0.0
    tolerance: PositiveNumber = 1e-3

    def arguments(self, analysis: str) -> dict[str, Any]:
        """The arguments of an analysis."""
        return {name: getattr(self, name) for name in ("stiffness", "rigid", *_ELASTIC[analysis])}


class Run(Record):
    """A named run of a model.

    motion : a file of the motion of all nodes, in place of a trajectory: CSV with columns t, NODE.x, NODE.vx ...
    targets : a task of the structure, in place of a trajectory.
    analysis : ``dynamics.inverse`` (motion, forces, strength, drives), ``kinematics.follow`` (motion only),
        ``dynamics.simulate`` (the motion that forces cause, then as ``dynamics.inverse``); at rest ``statics.linear`` (small
        displacements), ``statics.equilibrium`` (large ones), ``statics.at_poses`` (forces in poses) and ``statics.deflection``
        (of elastic members along a motion, besides all of ``dynamics.inverse``); with elastic members likewise
        ``flexible.corrected``, ``flexible.frequencies`` and ``flexible.vibration``; or ``mission``.
    trajectory : a trajectory or the name of one in the model; or `motion`, a node-history CSV (t, NODE.x, NODE.vx ...); or
        `targets`, a task of the structure (`Gimbal`, `Positioning`, `Docking` ...), which says what the drives must do.
        A simulation needs neither; its trajectory moves the drives that have no task.
    samples : number of equally spaced instants, both ends included.
    load_cases : names, also of combinations; None runs all combinations of the model, all of its load cases if it has none, or
        its plain loads. A simulation or an equilibrium has one at most; None takes all loads with factor 1.
    stations : equally spaced sections along each member, both ends included.
    condition : name of one of the model's `conditions`, under which the run is done; None: the model as it is.

    Of a simulation: t_end : s, the start is 0. tasks : what drives do (`Free`, `Hold`, `GivenForce`, an input of the motor, a
    trajectory of that drive alone); a drive without a task follows the trajectory if that moves it, else it is held. feedback :
    drives without a task follow the trajectory by forces, with gains and limits (`Tracking`), instead of exactly. method : the
    integration method; by default `Taylor` if the motion has a power series, else `DOP853`. events : events to detect.
    An equilibrium has tasks too (`Free`, `Hold`, `GivenForce`).

    Of ``statics.at_poses``: poses : name of a pose -> drive or pose coordinate -> value, m or rad (what is not named stands as
    in the model); or a trajectory, whose samples are the poses.

    Of ``flexible.*``: elastic : an `Elastic`, its options.
    Of a mission: motions : names of other runs and of trajectories (with `samples` each). conditions : names; None: the model
    as it is. Every motion is done under every condition and every load case.
    """

    analysis: Analysis = "dynamics.inverse"
    trajectory: TrajectoryOrName | None = None
    motion: str | None = None
    targets: Target | None = None
    samples: Annotated[Whole, Field(ge=2, le=MOST_SAMPLES)] = 201
    load_cases: tuple[LoadCaseNames, ...] | None = None
    stations: Annotated[Whole, Field(ge=2, le=MOST_STATIONS)] = 7
    condition: ConditionName | None = None
    t_end: Span | None = None
    tasks: Table[DriveName, Task] = ReadOnly()
    feedback: Tracking | None = None
    method: Method | None = None
    events: Table[Name, Event] = ReadOnly()
    poses: Table[Name, Table[CoordinateName, Coordinate]] = ReadOnly()
    motions: tuple[MotionName, ...] = ()
    conditions: tuple[ConditionName, ...] | None = None
    elastic: Elastic = Elastic()

    @model_validator(mode="after")
    def _fitting(self) -> Run:
        for name in _OWN:
            if name not in _USED[self.analysis] and getattr(self, name) != type(self).model_fields[name].default:
                users = [one for one, used in _USED.items() if name in used]
                raise ValueError(f"has {name}, which {self.analysis} does not use. Remove it, or change analysis: {users[-1]}.")
        if self.analysis == "dynamics.simulate":
            return self._simulated()
        if self.targets is not None and _timed(self.targets):
            raise ValueError("has targets with a function of time, which no file can hold. Give way points, or a spline.")
        if self.analysis == MISSION:
            return self._mission()
        if self.analysis == "statics.equilibrium":
            self._one_case()
        if "motion" in _USED[self.analysis]:
            self._one_motion()
        if self.analysis in FLEXIBLE:
            self._elastic()
        return self

    def _elastic(self) -> None:
        own = _ELASTIC[self.analysis]
        for analysis, names in _ELASTIC.items():
            for name in names:
                if name not in own and getattr(self.elastic, name) != Elastic.model_fields[name].default:
                    raise ValueError(
                        f"has elastic.{name}, which {self.analysis} does not use. Remove it, or change analysis: {analysis}."
                    )
        if "at" in own and not self.elastic.at:
            raise ValueError(
                "has no elastic.at: what shall have the values of the rigid motion. Write for example elastic: {at: [N8.z]}."
            )

    def _one_motion(self) -> None:
        given = [name for name in ("trajectory", "motion", "targets", "poses") if getattr(self, name)]
        if len(given) == 1:
            return
        if self.analysis == "statics.at_poses":
            has = " and ".join(given) or "no poses"
            raise ValueError(f"has {has}. Give one: poses: {{stowed: {{M7: 1.2 m}}}}, a trajectory, motion (a CSV) or targets.")
        has = f"both {' and '.join(given)}" if given else "neither trajectory nor motion"
        standing = "" if given else f" {STANDING}"
        mend = "Give one: trajectory, motion (a node-history CSV), or targets (a task of the structure)."
        raise ValueError(f"has {has}. {mend}{standing}")

    def _mission(self) -> Run:
        if not self.motions:
            raise ValueError(
                "names no motions, so the mission is empty. Add motions: [RUN, ...], names of runs or trajectories."
            )
        for field in ("motions", "load_cases", "conditions"):
            if (names := getattr(self, field)) is None:
                continue
            if not names:
                raise ValueError(f"{field} is empty, so there is nothing to do. Name some, or leave it out.")
            if twice := [name for k, name in enumerate(names) if name in names[:k]]:
                raise ValueError(f"{field} names {twice[0]!r} twice. Name it once.")
        if self.condition is not None:
            raise ValueError("has condition, which belongs to one run. Write conditions: [...] for a mission.")
        return self

    def _simulated(self) -> Run:
        if self.t_end is None:
            raise ValueError("has no t_end. Say how long to simulate, e.g. t_end: 10 s.")
        step = getattr(self.method, "step", None)
        if step is not None and self.t_end / step > MOST_COUNT:
            raise ValueError(f"{self.t_end:g} s by steps of {step:g} s are {self.t_end / step:.0e} steps. Take longer steps.")
        self._one_case()
        return self

    def _one_case(self) -> None:
        if self.load_cases is not None and len(self.load_cases) > 1:
            what = "an equilibrium has one place" if self.analysis == "statics.equilibrium" else "a simulation has one motion"
            raise ValueError(f"has {len(self.load_cases)} load cases; {what}. Make one run for each.")


def _timed(target: Any) -> bool:
    """True if a task has a course that is a function of time."""
    if isinstance(target, Combined):
        return any(_timed(task) for task in target.tasks)
    return any(callable(course) for course in getattr(target, "moves", {}).values())
