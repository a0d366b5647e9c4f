"""Feedback that makes drives follow a trajectory in a simulation."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field, model_validator

from kinetruss.errors import Fault
from kinetruss.model.drives import CoordinateDrive
from kinetruss.model.record import Flag, PositiveForce, PositiveNumber, Record, SpringDamping, SpringStiffness, Whole
from kinetruss.model.references import DriveName
from kinetruss.model.table import Table

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kinetruss.model.data import ModelData


class Tracking(Record):
    """Feedback of drives about the trajectory of a simulation: each drive has the force (N, or torque, N m)

        F = F_ref(t) - K (q - q_ref(t)) - D (q' - q_ref'(t))

    of its coordinate q, within limits. q_ref is the trajectory, and F_ref what it needs by `dynamics.inverse`. K and D are
    given for each drive (`stiffness`, `damping`), or those of least cost (`error_cost` ...) of the structure linearised at
    rest about the reference, which then couple the drives.

    drives : that are fed back; by default all without a task.
    stiffness : K, N/m or N m/rad, of all drives or by name. damping : D, N s/m or N m s/rad.
    error_cost, rate_cost, force_cost : weights of (q - q_ref)^2, (q' - q_ref')^2 and (F - F_ref)^2 in the cost over all time,
        of all drives or by name, in SI units.
    instants : instants of the reference, equally spaced, at which gains of least cost are computed; between them they change
        linearly. 1: at the start alone.
    feedforward : False leaves F_ref out.
    limits : largest magnitude of the force, N or N m, of all drives or by name.
    motor_limits : the force also keeps within what the motor can move steadily against: its peak torque (or current, or that of
        its amplifier) less its friction, through gear and screw.

    >>> import kinetruss as kt
    >>> kt.Tracking(stiffness="2e4 N/m", damping=300.0, limits={"M7": "500 N"}).limits["M7"]
    500.0
    """

    drives: tuple[DriveName, ...] = ()
    stiffness: SpringStiffness | Table[DriveName, SpringStiffness] | None = None
    damping: SpringDamping | Table[DriveName, SpringDamping] | None = None
    error_cost: PositiveNumber | Table[DriveName, PositiveNumber] | None = None
    rate_cost: PositiveNumber | Table[DriveName, PositiveNumber] | None = None
    force_cost: PositiveNumber | Table[DriveName, PositiveNumber] = 1.0
    instants: Annotated[Whole, Field(ge=1, le=1000)] = 1
    feedforward: Flag = True
    limits: PositiveForce | Table[DriveName, PositiveForce] | None = None
    motor_limits: Flag = True

    @model_validator(mode="after")
    def _one_way(self) -> Tracking:
        given, cost = self.stiffness is not None or self.damping is not None, self.error_cost is not None
        if given == cost:
            has = "both gains and error_cost" if given else "neither stiffness nor error_cost"
            raise ValueError(f"has {has}. Give stiffness and damping, or error_cost for gains of least cost.")
        if given and (self.rate_cost is not None or self.instants != 1):
            raise ValueError(
                "has given gains, and rate_cost or instants of gains of least cost. Give error_cost, or drop these."
            )
        return self

    def chosen(self, drives: Mapping[str, Any], tasks: Mapping[str, Any]) -> tuple[str, ...]:
        """The drives that are fed back, of all of a model and beside tasks."""
        return self.drives or tuple(name for name in drives if name not in tasks)


def tracking_rules(model: ModelData, run: Any, path: tuple[Any, ...]) -> Iterator[Fault]:
    """Feedback without a trajectory, of drives with a task, of coordinates of nodes."""
    if run.feedback is None:
        return
    if run.trajectory is None:
        yield Fault((*path, "feedback"), "follows a trajectory, and the run has none.", "Give the run a trajectory.")
    names = run.feedback.chosen(model.all_drives, run.tasks)
    if not names:
        yield Fault((*path, "feedback"), "has no drive: all have a task, or there is none.", "Leave drives without a task.")
    for name in names:
        if name in run.tasks:
            yield Fault((*path, "feedback"), f"feeds back {name!r}, which has a task.", "Remove one of them.")
        if isinstance(model.all_drives.get(name), CoordinateDrive):
            mend = "Name the other drives, and leave it to the trajectory."
            yield Fault((*path, "feedback"), f"cannot act on {name!r}, a coordinate of a node.", mend)
    for field in ("stiffness", "damping", "error_cost", "rate_cost", "force_cost", "limits"):
        table = getattr(run.feedback, field)
        for name in table if isinstance(table, dict) else ():
            if name in model.all_drives and name not in names:
                yield Fault((*path, "feedback", field), f"names {name!r}, which is not fed back.", "Name a drive that is.")
