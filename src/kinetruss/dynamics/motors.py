"""Motors coupled with a structure: their modes, friction, histories."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import mul
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators import train_of
from kinetruss.actuators.drive_model import COLUMNS, ENERGIES, drive_model_of, stored_energy
from kinetruss.actuators.inputs import edges_of, in_currents, inputs_of, kinks, source_of
from kinetruss.actuators.modes import Drives, unwrapped
from kinetruss.dynamics.integrators import jumps
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.solve.kkt import kinetic, prepare_rows, row_along
from kinetruss.kernels.solve.motors import MotorPlaces, MotorResponse, motor_project, motor_response
from kinetruss.kernels.structure.structure import ANGLE, SUM
from kinetruss.mechanics import System
from kinetruss.model import DOP853, MOTOR_TASKS, DriveLoad, GivenForce, Hold, LengthDrive, StepInput, TableInput
from kinetruss.results import Column, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.equations import Equations, Workspace

    Floats = NDArray[np.float64]


TURN = 2 * np.pi
OWN = 1e-8
"""Change of other rows, in parts of that of a drive, from which on the drive cannot move by itself."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Motors(Drives):
    """The motors of a simulation. rows (k,) : of the equations. stored (k,) : J, in the rotors at the start."""

    rows: NDArray[np.int64]
    stored: NDArray[np.float64]

    @property
    def recorded(self) -> int:
        """Numbers recorded of all motors at an instant."""
        return len(COLUMNS) * len(self.names)

    def values(self, extra: NDArray[np.float64]) -> NDArray[np.float64]:
        """Lengths and angles (samples, k), m and rad, by the angles that the motors have turned, from what is recorded."""
        turned = extra.reshape(len(extra), len(self.names), len(COLUMNS))[:, :, list(COLUMNS).index("motor_angle")]
        found: NDArray[np.float64] = self.start + turned / np.array([model.shaft.speed for model in self.models])
        return found


def driven_by_motors(model: Any, tasks: Mapping[str, Any]) -> list[str]:
    """Drives whose task is one of their motor: an input or position loop, or of a member a torque of its motor."""

    def of_motor(name: str, task: Any) -> bool:
        torque = isinstance(task, GivenForce) and task.turns and isinstance(model.all_drives[name], LengthDrive)
        return torque or isinstance(task, MOTOR_TASKS)

    return [name for name, task in tasks.items() if of_motor(name, task)]


def refuse_method(model: Any, tasks: Mapping[str, Any], method: Any) -> None:
    """InputError where a method does not simulate the motors of a run."""
    if driven_by_motors(model, tasks) and (not isinstance(method, DOP853) or method.step is not None):
        raise InputError("Motors are simulated with steps chosen by the error. Take the method DOP853 without a step.")


def with_motors_fixed(model: Any, tasks: Mapping[str, Any]) -> dict[str, Any]:
    """The tasks with motor-driven coordinates held: the equations then have their rows."""
    return dict(tasks) | dict.fromkeys(driven_by_motors(model, tasks), Hold())


def motors_of(
    system: System,
    eq: Equations,
    ws: Workspace,
    user: Any,
    tasks: Mapping[str, Any],
    x: NDArray[np.float64],
    v: NDArray[np.float64],
    t_end: float,
) -> Motors | None:
    """The motors of a simulation that starts at x, v (3 n,); None where no task is one of a motor.

    v is brought onto the constraints, with the rates of the motor-driven coordinates as they are. The poles of a
    position loop are placed for the mass that its motor sees at the start, the other drives at rest.

    Raises
    ------
    InputError : a drive that redundant members hold, data of a drive train with which no motion can be computed.
    """
    names = driven_by_motors(system.model, tasks)
    if not names:
        return None
    drive = [system.drives.index(name) for name in names]
    rows = np.array([int(np.flatnonzero(system.row_drive[eq.row] == d)[0]) for d in drive], np.int64)
    kind = eq.kind[rows]
    measure = np.where(kind == SUM, system.drive_measure[drive], 0)
    period = np.where(kind == SUM, np.append(system.measure_period, 0.0)[measure], np.where(kind == ANGLE, TURN, 0.0))
    motor_project(eq, ws, 0.0, x, v, motor_places(rows, x.size), 1e-13)
    start = StructureBody(eq, ws, user, rows, period, x).evaluate(0.0, x, v, system.drive_start[drive])
    _refuse_redundant(names, start)
    given = [_trained(system.model, name, tasks[name]) for name in names]
    models = [drive_model_of(train, source_of(history)) for train, history in given]
    histories = [history for _, history in given]
    edges = edges_of({*jumps(eq), *(t for one in histories for t in kinks(one, DriveLoad()))}, t_end)
    masses = [start.mass[j][j] for j in range(len(names))]
    return Motors(
        **inputs_of(models, histories, edges, start.value, masses, lambda _, __: start.thrust),
        names=tuple(names),
        rows=rows,
        period=period,
        stored=np.array([stored_energy(model, rate, 0.0) for model, rate in zip(models, start.rate, strict=True)]),
    )


def _trained(model: Any, name: str, task: Any) -> tuple[Any, Any]:
    """Drive train and input; a torque is the current that gives it, past the amplifier."""
    drive = model.all_drives[name]
    train = train_of(model, drive.bar if isinstance(drive, LengthDrive) else name)
    if isinstance(task, GivenForce):
        task = StepInput(torque=task.torque) if task.times is None else TableInput(times=task.times, torques=task.torques)
    return in_currents(train, task)


def _refuse_redundant(names: list[str], start: StructureBody) -> None:
    moved = np.zeros(len(start.eq.A))
    for j, name in enumerate(names):
        row_along(start.eq, start.ws, start.da[j], moved)
        moved[start.rows[j]] -= start.scale[j]
        if not np.abs(moved).max(initial=0.0) < OWN * start.scale[j]:
            held = "angle" if start.period[j] else "length"
            raise InputError(
                f"Drive {name!r} cannot move by itself: rigid members or other drives hold its {held}. Let one of them go, "
                "or make it elastic."
            )


# The structure as the body of its motors: how it answers to the accelerations of the coordinates that they drive.


TOLERANCE = 1e-13
"""Of projections, in parts of a length."""
CLOSE = 1e-14
"""Change of accelerations that counts as none, relative to the largest."""
REST = 1e-12
"""Of the largest velocity: below this share a coordinate is at rest at the start."""


class StructureBody:
    """Accelerations and forces at an instant, as straight lines over the accelerations w (k,) of the coordinates of `rows`.

    a = a0 + w da, N = N0 + w dN; see `kinetruss.actuators.modes.Body`. Its own numbers in a state are free positions and
    velocities. stand (3 n,) : positions at the start, of coordinates that are not free.
    """

    places: Sequence[tuple[int, int]] | None = None

    def __init__(self, eq: Equations, ws: Workspace, user: Any, rows: NDArray[np.int64], period: Floats, stand: Floats) -> None:
        k, size, count = len(rows), eq.local.size, len(eq.A)
        self.eq, self.ws, self.user, self.rows, self.period, self.stand = eq, ws, user, rows, period, stand
        shapes: dict[str, Any] = dict.fromkeys(("rows", "value", "rate", "scale", "w"), (k,))
        shapes |= {"a": (size,), "N": (count,), "da": (k, size), "dN": (k, count)}
        self._response = made = MotorResponse.zeros(shapes)
        made.rows[:] = rows
        self._stuck, self.count = motor_places(rows, size), 2 * len(eq.free)
        self.scale, self.a0, self.N0, self.da, self.dN = made.scale, made.a, made.N, made.da, made.dN
        self.pivot, self.value, self.rate, self.thrust = 0.0, list[float](), list[float](), list[float]()
        self.mass = list[list[float]]()

    def state(self, y: Floats) -> tuple[Floats, Floats]:
        """Positions and velocities (3 n,); prescribed coordinates as at the start."""
        free, x, v = self.eq.free, self.stand.copy(), np.zeros_like(self.stand)
        x[free], v[free] = y[: len(free)], y[len(free) : 2 * len(free)]
        return x, v

    def evaluate(self, t: float, x: Floats, v: Floats, near: Any, w: Sequence[float] = ()) -> StructureBody:
        """Evaluate; prescribed coordinates of x and v are set. Angles are counted on from the turn that `near` (k,) is in.

        w : the accelerations (k,) whose friction of bearings counts, by default none.
        """
        self._last, self._response.w[:] = (t, x, v, near), w or 0.0
        self.pivot = motor_response(self.eq, self.ws, self.user.call, t, x, v, self._response)
        self.value = unwrapped(self._response.value, near, self.period).tolist()
        self.rate = self._response.rate.tolist()
        self.thrust = (-self.scale * self.N0[self.rows]).tolist()
        self.mass = (-self.scale[:, None] * self.dN[:, self.rows].T).tolist()
        return self

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:  # noqa: ARG002 - the equations know their jumps
        """Evaluate at t (s) of a state."""
        self.evaluate(t, *self.state(y), near)

    def bends(self, w: list[float]) -> bool:
        """True if the straight lines were not those at these accelerations of the coordinates; they are now.

        The friction of bearings follows from joint forces, and so from w.
        """
        own = self._response.w
        if not self.eq.bearing_ints.size or np.abs(own - w).max() <= CLOSE * np.abs(w).max():
            return False
        t, x, v, near = self._last
        self.evaluate(t, x, v, near, w)
        return True

    def found(self, w: list[float]) -> tuple[Floats, Floats]:
        """a (3 n,) and N (r,) with these accelerations of the coordinates."""
        return self.a0 + np.dot(w, self.da), self.N0 + np.dot(w, self.dN)

    def pushed(self, w: list[float]) -> list[float]:
        """Thrusts (k,), N, with these accelerations of the coordinates."""
        return [f + sum(map(mul, row, w)) for f, row in zip(self.thrust, self.mass, strict=True)]

    def rates(self, y: Floats, w: list[float]) -> list[float]:
        """Velocities and accelerations of the free coordinates."""
        free: list[float] = self.found(w)[0][self.eq.free].tolist()
        return [*y[len(free) : 2 * len(free)].tolist(), *free]

    def observed(self, t: float, y: Floats, w: list[float]) -> tuple[Floats, Floats, Floats, Floats]:
        """x, v, a (3 n,), N (r,) where `at` was called last, prescribed coordinates included."""
        x, v = self.state(y)
        a, N = self.found(w)
        prepare_rows(self.eq, self.ws, t, x, v)
        return x, v, a, N

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:
        """Bring a state onto the constraints, coordinates that stick at rest."""
        x, v = self.state(y)
        own, free = self._stuck, self.eq.free
        own.stuck[:], own.value[:] = stuck, places
        good, moved = motor_project(self.eq, self.ws, t, x, v, own, TOLERANCE)
        if not good:
            raise AnalysisError(f"The lengths of the bars could not be closed at t = {t:.6g} s.")
        y[: len(free)], y[len(free) : 2 * len(free)] = x[free], v[free]
        return own.value, moved

    def moving(self, y: Floats) -> list[bool]:
        """Which coordinates (k,) move, where `at` was called last."""
        least = REST * np.abs(y[len(self.eq.free) : self.count]).max(initial=0.0)
        found: list[bool] = (np.abs(self._response.rate * self.scale) > least).tolist()
        return found

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""
        return float(kinetic(self.eq, self.ws, *self.state(y)))


def motor_places(rows: NDArray[np.int64], size: int) -> MotorPlaces:
    """Workspace to project motor-driven rows beside `size` coordinates; none is stuck."""
    k = len(rows)
    made = MotorPlaces.zeros({"rows": (k,), "stuck": (k,), "value": (k,), "rate": (k,), "scratch": (size,)})
    made.rows[:] = rows
    return made


# Histories of the motors of a simulation.


def motor_names(motors: Motors) -> dict[str, Column]:
    """The axis of the motors."""
    return {"motor": variable(("motor",), np.array(motors.names, str), "", "motor-driven drive")}


def motor_histories(motors: Motors, extra: NDArray[np.float64]) -> dict[str, Column]:
    """Histories (time, motor) from the columns (time, motors x histories)."""
    table = extra.reshape(len(extra), len(motors.names), len(COLUMNS))
    both = ("time", "motor")
    found = {name: variable(both, table[:, :, k].copy(), *words) for k, (name, words) in enumerate(COLUMNS.items())}
    spent = sum(table[:, :, list(COLUMNS).index(name)] for name in ENERGIES[1:])
    balance = table[:, :, list(COLUMNS).index("electrical_energy")] - spent - table[:, :, -1] + motors.stored
    found["motor_energy_balance"] = variable(both, balance, "J", "electrical energy minus all it went to")
    return found
