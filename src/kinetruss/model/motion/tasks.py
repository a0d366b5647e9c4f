"""Tasks of drives in a simulation: released, held, a given force, an input of the motor, or a prescribed motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, cast, get_args

from pydantic import Discriminator, Field, Tag, model_validator

from kinetruss.model._record import Force, Record, Series, SignedTorque, Time
from kinetruss.model.motion.inputs import ExponentialInput, PositionLoop, SineInput, StepInput, TableInput
from kinetruss.model.motion.trajectories import Trajectory
from kinetruss.model.parts.loads import check_table

__all__ = ["MOTOR_TASKS", "TRAJECTORY_TASKS", "Free", "GivenForce", "Hold", "Task"]


class Free(Record):
    """The drive is released: it carries no force."""

    kind: Literal["free"] = "free"


class Hold(Record):
    """The drive keeps its start value."""

    kind: Literal["hold"] = "hold"


class GivenForce(Record):
    """The drive exerts a given force (N) or, on an angle, a given torque (N m): constant, or a table over `times` (s).

    On the coordinate of a scalar it may be either. Positive lengthens the member, moves the coordinate up, or turns the bar
    counter-clockwise. A table is linear between its times and constant outside. A torque on an angle acts on the output side
    of any gear; for a torque of its motor, use an input with `torque` (`StepInput`). For an active member with screw and
    motor, a torque is that of its motor: it acts through the gear and the friction of the screw, within the limits of the
    motor.

    force : constant, N. torque : constant, N m. times : of a table, s. forces, torques : at these times, N or N m.
    """

    _positional: ClassVar = ("force",)
    kind: Literal["force"] = "force"
    force: Force | None = None
    torque: SignedTorque | None = None
    times: Annotated[tuple[Time, ...], Field(min_length=2), Series] | None = None
    forces: Annotated[tuple[Force, ...], Series] | None = None
    torques: Annotated[tuple[SignedTorque, ...], Series] | None = None

    if TYPE_CHECKING:

        def __init__(
            self,
            force: float | str | None = None,
            *,
            torque: float | str | None = None,
            times: Any = None,
            forces: Any = None,
            torques: Any = None,
        ) -> None: ...

    @model_validator(mode="after")
    def _one_form(self) -> GivenForce:
        given = [name for name in ("force", "torque", "forces", "torques") if getattr(self, name) is not None]
        if len(given) != 1:
            has = f"has {' and '.join(given)}" if given else "has no force"
            raise ValueError(f"{has}. Give one of force, torque, or times with forces or torques.")
        if (self.times is None) == (self.table is not None):
            raise ValueError(
                "a table needs times and forces (or torques), a constant force no times. Give both, or one number."
            )
        if self.times is not None and self.table is not None:
            check_table(self.times, self.table, given[0])
        return self

    @property
    def table(self) -> tuple[float, ...] | None:
        """Forces (N) or torques (N m) at `times`, or None if the force is constant."""
        return self.forces if self.forces is not None else self.torques

    @property
    def constant(self) -> float | None:
        """The constant force (N) or torque (N m), or None if there is a table."""
        return self.force if self.force is not None else self.torque

    @property
    def turns(self) -> bool:
        """True for a torque."""
        return self.torque is not None or self.torques is not None


MOTOR_TASKS = (StepInput, ExponentialInput, SineInput, TableInput, PositionLoop)
TRAJECTORY_TASKS: tuple[type, ...] = get_args(get_args(Trajectory)[0])
_MOVING = {cast("type[Record]", one).model_fields["kind"].default for one in TRAJECTORY_TASKS}


def _sort(value: Any) -> str:
    """The union of a task; a sine is a motion if it has amplitudes, a voltage or current otherwise."""
    if isinstance(value, TRAJECTORY_TASKS):
        return "trajectory"
    if not isinstance(value, dict) or value.get("kind") not in list(_MOVING):  # a faulty kind may not be hashable
        return "task"
    return "task" if value["kind"] == "sine" and "amplitudes" not in value else "trajectory"


_Own = Annotated[
    Free | Hold | GivenForce | StepInput | ExponentialInput | SineInput | TableInput | PositionLoop, Field(discriminator="kind")
]
Task = Annotated[Annotated[_Own, Tag("task")] | Annotated[Trajectory, Tag("trajectory")], Discriminator(_sort)]
