"""Named runs: the analyses of a model."""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

from pydantic import Field, field_validator, model_validator

from kinetruss.limits import MOST_COUNT, MOST_SAMPLES, MOST_STATIONS
from kinetruss.model._record import Name, Record, Span, Whole
from kinetruss.model._table import ReadOnly, Table
from kinetruss.model.motion.events import Event
from kinetruss.model.motion.methods import Method
from kinetruss.model.motion.targets import Combined, Target
from kinetruss.model.motion.tasks import Task
from kinetruss.model.motion.trajectories import TrajectoryOrName
from kinetruss.units import shown

__all__ = ["STANDING", "Run"]

_SIMULATED = ("t_end", "tasks", "method", "events")

STANDING = "A structure that stands still is analysed in Python: kt.statics.linear(kt.read(FILE))."
"""The fix for a run of a structure that does not move."""

Analysis = Literal["dynamics.inverse", "kinematics.follow", "dynamics.simulate"]


class Run(Record):
    """A named run of a model.

    analysis : ``dynamics.inverse`` (motion, forces, strength, drives), ``kinematics.follow`` (motion only) or
        ``dynamics.simulate`` (the motion that forces cause, then as ``dynamics.inverse``).
    trajectory : a trajectory or the name of one in the model; or `motion`, a node-history CSV (t, NODE.x, NODE.vx ...); or
        `targets`, a task of the structure (`Gimbal`, `Positioning`, `Docking` ...), which says what the drives must do.
        A simulation needs neither; its trajectory moves the drives that have no task.
    samples : number of equally spaced instants, both ends included.
    load_cases : names; None runs all of the model's, or its plain loads if it has none. A simulation has one at most; None
        takes all loads with factor 1.
    stations : equally spaced sections along each member, both ends included.

    Of a simulation: t_end : s, the start is 0. tasks : what drives do (`Free`, `Hold`, `GivenForce`, an input of the motor, a
    trajectory of that drive alone); a drive without a task follows the trajectory if that moves it, else it is held. method :
    the integration method; by default `Taylor` if the motion has a power series, else `DOP853`. events : events to detect.
    """

    analysis: Analysis = "dynamics.inverse"
    trajectory: TrajectoryOrName | None = None
    motion: str | None = None
    targets: Target | None = None
    samples: Annotated[Whole, Field(ge=2, le=MOST_SAMPLES)] = 201
    load_cases: tuple[Name, ...] | None = None
    stations: Annotated[Whole, Field(ge=2, le=MOST_STATIONS)] = 7
    t_end: Span | None = None
    tasks: Table[Name, Task] = ReadOnly()
    method: Method | None = None
    events: Table[Name, Event] = ReadOnly()

    @field_validator("analysis", mode="before")
    @classmethod
    def _moves(cls, value: Any) -> Any:
        if isinstance(value, str) and value.casefold().startswith("static"):
            known = ", ".join(get_args(Analysis))
            raise ValueError(f"{shown(value)} is no analysis of a run, which moves: {known}. {STANDING}")
        return value

    @model_validator(mode="after")
    def _one_motion(self) -> Run:
        if self.analysis == "dynamics.simulate":
            return self._simulated()
        for name in _SIMULATED:
            if getattr(self, name) != type(self).model_fields[name].default:
                raise ValueError(f"has {name}, which {self.analysis} does not use. Remove it, or simulate: dynamics.simulate.")
        given = [name for name in ("trajectory", "motion", "targets") if getattr(self, name) is not None]
        if self.targets is not None and _timed(self.targets):
            raise ValueError("has targets with a function of time, which no file can hold. Give way points, or a spline.")
        if len(given) != 1:
            has = f"both {' and '.join(given)}" if given else "neither trajectory nor motion"
            standing = "" if given else f" {STANDING}"
            mend = "Give one: trajectory, motion (a node-history CSV), or targets (a task of the structure)."
            raise ValueError(f"has {has}. {mend}{standing}")
        return self

    def _simulated(self) -> Run:
        if self.t_end is None:
            raise ValueError("has no t_end. Say how long to simulate, e.g. t_end: 10 s.")
        step = getattr(self.method, "step", None)
        if step is not None and self.t_end / step > MOST_COUNT:
            raise ValueError(f"{self.t_end:g} s by steps of {step:g} s are {self.t_end / step:.0e} steps. Take longer steps.")
        if self.targets is not None:
            raise ValueError(
                "has targets, which ask for a motion that a simulation computes itself. Remove them, or use dynamics.inverse."
            )
        if self.motion is not None:
            raise ValueError(
                "has a motion from a file, which a simulation computes itself. Remove it, or use dynamics.inverse."
            )
        if self.load_cases is not None and len(self.load_cases) > 1:
            raise ValueError(f"has {len(self.load_cases)} load cases; a simulation has one motion. Make one run for each.")
        return self


def _timed(target: Any) -> bool:
    """True if a task has a course that is a function of time."""
    if isinstance(target, Combined):
        return any(_timed(task) for task in target.tasks)
    return any(callable(course) for course in getattr(target, "moves", {}).values())
