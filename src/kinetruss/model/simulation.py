"""Simulations: integration methods, tasks of drives, events."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, cast, get_args

from pydantic import Discriminator, Field, Tag, ValidationInfo, WithJsonSchema, field_validator, model_validator

from kinetruss.model.drives import Measured as MeasuredCoordinate, turns
from kinetruss.model.in_time import check_table
from kinetruss.model.inputs import ExponentialInput, PositionLoop, SineInput, StepInput, TableInput
from kinetruss.model.record import (
    Count,
    Flag,
    Force,
    Name,
    Number,
    PositiveNumber,
    PositiveTime,
    Record,
    Series,
    SignedTorque,
    Span,
    Time,
)
from kinetruss.model.references import MemberName
from kinetruss.model.trajectories import Trajectory
from kinetruss.units import parse

Solver = Literal["auto", "sweep", "dense", "sparse"]
"""Solver for accelerations and forces: block sweeps, a dense Schur complement, sparse L D L^T, or the fastest of them."""

_Tolerance = Annotated[Number, Field(gt=0, lt=1)]


class DOP853(Record):
    """Explicit Runge-Kutta method of order 8 with error control, projected onto the constraints after every step.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). max_steps : largest number of steps,
        accepted and rejected. first_step : s; found from the equations by default. step : s, all steps alike and no error
        control, to study convergence. solver : of accelerations and forces; the fastest by default.

    Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., 1993, section II.10.
    """

    kind: Literal["dop853"] = "dop853"
    rtol: _Tolerance = 1e-10
    atol: PositiveNumber = 1e-11
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


class EnergyMomentum(Record):
    """Implicit midpoint rule with discrete gradients: fixed steps (s) that keep energy and momentum. For long and stiff runs.

    tolerance : of the equations of a step, relative. solver : of the equations; the fastest by default.

    Source: O. Gonzalez, Physica D 132 (1999) 165-174.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["energy_momentum"] = "energy_momentum"
    step: Span
    tolerance: _Tolerance = 1e-11
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(self, step: float | str, *, tolerance: float = 1e-11, solver: Solver = "auto") -> None: ...


class GeneralizedAlpha(Record):
    """Implicit method with numerical damping of high frequencies; fixed steps (s).

    rho : spectral radius at infinite frequency, 0 to 1: the amplitude of the highest frequencies that remains after a step.
        tolerance : of the equations of a step, relative. solver : of the equations; the fastest by default.

    Source: J. Chung, G. M. Hulbert, Journal of Applied Mechanics 60 (1993) 371-375.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["generalized_alpha"] = "generalized_alpha"
    step: Span
    rho: Annotated[Number, Field(ge=0, le=1)] = 0.85
    tolerance: _Tolerance = 1e-11
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(
            self, step: float | str, *, rho: float = 0.85, tolerance: float = 1e-11, solver: Solver = "auto"
        ) -> None: ...


class Radau(Record):
    """Implicit Runge-Kutta method Radau IIA of order 5 with error control, projected onto the constraints after every step.

    For stiff runs: steps follow the motion, not the fastest vibration or damper of an elastic bar, once that has died down. It
    damps vibrations that are faster than its steps. The stiffness of elastic bars, dampers, membranes, solids and friction
    about pins is in its matrices; that of user forces and of loads that turn is not.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). max_steps : at most. first_step : s;
    found from the equations by default. step : s, all steps alike and no error control, to study convergence.
    solver : of accelerations and forces; the fastest by default.

    Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., 1996, section IV.8.
    """

    kind: Literal["radau"] = "radau"
    rtol: _Tolerance = 1e-8
    atol: PositiveNumber = 1e-9
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


class Rattle(Record):
    """RATTLE: leapfrog with constraints on positions and velocities; fixed steps (s), symplectic.

    tolerance : of the constraints of a step, relative. solver : of the equations; the fastest by default.

    Source: H. C. Andersen, Journal of Computational Physics 52 (1983) 24-34.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["rattle"] = "rattle"
    step: Span
    tolerance: _Tolerance = 1e-12
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(self, step: float | str, *, tolerance: float = 1e-12, solver: Solver = "auto") -> None: ...


class Taylor(Record):
    """Taylor series of the motion, of high order, each from one factorisation. The fastest method if all forces are smooth.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). order : of the series of the
    velocities; chosen from rtol by default. max_steps : largest number of steps. first_step : s; the scale of time of the
    first series, found from the equations by default. step : s, all steps alike and no error control, to study convergence.
    solver : of accelerations and forces; the fastest by default.

    Rigid, driven and elastic bars of constant mass, planar bodies, drives, hinges, couplings, linear springs on coordinates,
    supports that move, given forces. Not for active members, cables, springs with friction, play or a table, loads that turn
    with bodies, membranes, solids, user forces and motors: use `DOP853` for these.

    Source: A. Jorba, M. Zou, Experimental Mathematics 14 (2005) 99-117; J. D. Pryce, Numerical Algorithms 19 (1998) 195-211.
    """

    kind: Literal["taylor"] = "taylor"
    rtol: _Tolerance = 1e-10
    atol: PositiveNumber = 1e-11
    order: Annotated[Count, Field(ge=4, le=40)] | None = None
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


ERROR_CONTROLLED = DOP853 | Radau | Taylor
"""Methods whose steps are chosen by the error."""

Method = Annotated[DOP853 | EnergyMomentum | GeneralizedAlpha | Radau | Rattle | Taylor, Field(discriminator="kind")]


# Tasks of drives in a simulation: released, held, a given force, an input of the motor, or a prescribed motion.


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


# Events of a simulation: a length, a coordinate or a force that reaches a value.

_VALUE = {"anyOf": [{"type": "number"}, {"type": "string"}], "description": "m, of a force N; a number, or text with a unit"}


WATCHED = ("length", "coordinate", "terms", "force")
"""Fields of an event of which one says what it watches."""


def _turned(coordinate: Any, terms: Any) -> bool:
    """Whether an event watches an angle, or a sum that begins with one; a text names a coordinate of a node."""
    first = coordinate if not terms else terms[0][0]
    return isinstance(first, Record) and turns(first)


class Event(Record):
    """The instant at which a length (of a member, m), a coordinate or a mean axial force (of a member, N) arrives at a value.

    length : of this member, m. coordinate : ``NODE.x``, m, or any other, given as the drive that would move it: the angle of a
        hinge (rad, on every turn), a length, an offset. terms : a sum of coordinates in its place, pairs of coordinate and
        factor, as of a `Coupling`. force : mean axial one of this member, N. Give one of them.
    direction : from below (``rising``), from above (``falling``) or ``both``. A quantity that touches its value and turns back
        counts once; one that has this value at the start does not count. stop : end the run there; False only records the
        event.
    """

    length: MemberName | None = None
    coordinate: Name | MeasuredCoordinate | None = None
    terms: Annotated[tuple[tuple[MeasuredCoordinate, Number], ...], Field(min_length=1)] | None = None
    force: MemberName | None = None
    value: Annotated[float, WithJsonSchema(_VALUE)]
    direction: Literal["rising", "falling", "both"] = "both"
    stop: Flag = True

    @field_validator("value", mode="plain")
    @classmethod
    def _in_its_unit(cls, value: Any, info: ValidationInfo) -> float:
        angle = _turned(info.data.get("coordinate"), info.data.get("terms"))
        return parse(value, "force" if info.data.get("force") is not None else "angle" if angle else "length")

    @model_validator(mode="after")
    def _one_quantity(self) -> Event:
        given = [name for name in WATCHED if getattr(self, name) is not None]
        if len(given) != 1:
            has = f"has {' and '.join(given)}" if given else "watches nothing"
            raise ValueError(f"{has}. Give one of length (a member), coordinate (NODE.x) or force (a member).")
        return self

    @property
    def unit(self) -> str:
        """SI unit of the quantity, and of `value`: m, rad or N."""
        return "N" if self.force is not None else "rad" if _turned(self.coordinate, self.terms) else "m"
