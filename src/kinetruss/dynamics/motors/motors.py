"""Motor-driven lengths and angles of a simulation: what feeds them, how they accelerate with the structure around them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators import train_of
from kinetruss.actuators.forward import Piece, Plant, gains_of, in_currents, kinks, longest_step, piece_of, plant_of, source_of
from kinetruss.dynamics.forward.watch import jumps
from kinetruss.dynamics.motors.columns import COLUMNS
from kinetruss.errors import InputError
from kinetruss.kernels.solve.kkt import row_along
from kinetruss.kernels.solve.motors import MotorPlaces, MotorResponse, motor_project, motor_response
from kinetruss.kernels.structure.plan import ANGLE, SUM
from kinetruss.mechanics import System
from kinetruss.model import DOP853, MOTOR_TASKS, DriveLoad, GivenForce, Hold, LengthDrive, StepInput, TableInput

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["Motors", "Response", "driven_by_motors", "held_instead", "motor_places", "motors_of", "refuse_method", "unwrapped"]

TURN = 2 * np.pi
OWN = 1e-8
"""Change of other rows, in parts of that of a drive, from which on the drive cannot move by itself."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Motors:
    """names, rows (k,) : of the drives and their rows of the equations. plants : their constants, without a mass of their own.

    period (k,) : after which a position has the same value again, 2 pi of an angle, 0 of a length. start (k,) : values, m, rad.
    edges : times (s) between which nothing jumps; pieces[i][j] : input of motor j from edges[i] on. longest : step, s.
    small (k,) : N m, a torque that is none. stored (k,) : J, in the rotors at the start. stiff : a winding is so quick that an
    implicit method is cheaper.
    """

    names: tuple[str, ...]
    rows: NDArray[np.int64]
    period: NDArray[np.float64]
    start: NDArray[np.float64]
    plants: tuple[Plant, ...]
    edges: tuple[float, ...]
    pieces: tuple[tuple[Piece, ...], ...]
    longest: float
    small: NDArray[np.float64]
    stiff: bool
    stored: NDArray[np.float64]

    @property
    def told(self) -> int:
        """Numbers told of all motors at an instant."""
        return len(COLUMNS) * len(self.names)

    def values(self, extra: NDArray[np.float64]) -> NDArray[np.float64]:
        """Lengths and angles (samples, k), m and rad, by the angles that the motors have turned, from what is told of them."""
        turned = extra.reshape(len(extra), len(self.names), len(COLUMNS))[:, :, list(COLUMNS).index("motor_angle")]
        found: NDArray[np.float64] = self.start + turned / np.array([plant.shaft.speed for plant in self.plants])
        return found


class Response:
    """Accelerations and forces at an instant, as straight lines over the accelerations w (k,) of the coordinates of `rows`.

    a = a0 + w da, N = N0 + w dN. value, rate, scale (k,) : of the coordinates (m, rad, ...) and of their rows. thrust, mass :
    (k,), (k, k), F = thrust + mass w, N or N m.
    """

    def __init__(self, eq: Equations, ws: Workspace, user: Any, rows: NDArray[np.int64], period: NDArray[np.float64]) -> None:
        k, size, count = len(rows), eq.local.size, len(eq.A)
        self.eq, self.ws, self.user, self.rows, self.period = eq, ws, user, rows, period
        self._room = made = MotorResponse.zeros(
            {
                "rows": (k,),
                "value": (k,),
                "rate": (k,),
                "scale": (k,),
                "a": (size,),
                "N": (count,),
                "da": (k, size),
                "dN": (k, count),
            }
        )
        made.rows[:] = rows
        self.value, self.rate, self.scale, self.a0, self.N0 = made.value, made.rate, made.scale, made.a, made.N
        self.da, self.dN, self.thrust, self.mass, self.pivot = made.da, made.dN, np.zeros(k), np.zeros((k, k)), 0.0

    def at(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64], near: NDArray[np.float64]) -> Response:
        """Evaluate; prescribed coordinates of x and v are set. Angles are counted on from the turn that `near` (k,) is in."""
        self.pivot = motor_response(self.eq, self.ws, self.user.call, t, x, v, self._room)
        self.value = unwrapped(self._room.value, near, self.period)
        self.thrust = -self.scale * self.N0[self.rows]
        self.mass = -self.scale[:, None] * self.dN[:, self.rows].T
        return self

    def found(self, w: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """a (3 n,) and N (r,) with these accelerations of the coordinates."""
        return self.a0 + w @ self.da, self.N0 + w @ self.dN


def motor_places(rows: NDArray[np.int64], size: int) -> MotorPlaces:
    """Workspace to project motor-driven rows beside `size` coordinates; none is stuck."""
    k = len(rows)
    made = MotorPlaces.zeros({"rows": (k,), "stuck": (k,), "value": (k,), "rate": (k,), "scratch": (size,)})
    made.rows[:] = rows
    return made


def unwrapped(value: NDArray[np.float64], near: NDArray[np.float64], period: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (..., k) in the turn nearest to others; where the period (k,) is 0 as they are."""
    turns = np.rint(np.divide(near - value, period, out=np.zeros_like(value), where=period > 0))
    found: NDArray[np.float64] = value + turns * period
    return found


def driven_by_motors(model: Any, tasks: Mapping[str, Any]) -> list[str]:
    """Drives that are fed through their motors: by an input or position loop, or of a member by a torque of its motor."""

    def fed(name: str, task: Any) -> bool:
        torque = isinstance(task, GivenForce) and task.turns and isinstance(model.all_drives[name], LengthDrive)
        return torque or isinstance(task, MOTOR_TASKS)

    return [name for name, task in tasks.items() if fed(name, task)]


def refuse_method(model: Any, tasks: Mapping[str, Any], method: Any) -> None:
    """InputError where a method does not simulate the motors of a run."""
    if driven_by_motors(model, tasks) and (not isinstance(method, DOP853) or method.step is not None):
        raise InputError("Motors are simulated with steps chosen by the error. Take the method DOP853 without a step.")


def held_instead(model: Any, tasks: Mapping[str, Any]) -> dict[str, Any]:
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
    """The motors of a simulation that starts at x, v (3 n,); None where nothing is fed through a motor.

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
    start = Response(eq, ws, user, rows, period).at(0.0, x, v, system.drive_start[drive])
    _refuse_redundant(names, start)
    fed = [_fed(system.model, name, tasks[name]) for name in names]
    plants = tuple(plant_of(train, source_of(history), 0.0) for train, history in fed)
    histories = [history for _, history in fed]
    kinked = {t for one in histories for t in kinks(one, DriveLoad(), t_end)} | {t for t in jumps(eq) if 0 < t < t_end}
    edges = (0.0, *sorted(kinked), t_end)
    pieces = _pieces(plants, histories, edges, start)
    return Motors(
        names=tuple(names),
        rows=rows,
        period=period,
        start=start.value.copy(),
        plants=plants,
        edges=edges,
        pieces=pieces,
        longest=min(longest_step(one, t_end) for one in histories),
        small=_small(plants, pieces, edges, start),
        stiff=_stiff(plants, t_end),
        stored=np.array([_rotor(*one) for one in zip(plants, start.rate, strict=True)]),
    )


def _pieces(
    plants: tuple[Plant, ...], histories: list[Any], edges: tuple[float, ...], start: Response
) -> tuple[tuple[Piece, ...], ...]:
    """Inputs between two edges."""
    gains = [
        gains_of(replace(plant, mass=float(start.mass[j, j])), one) if one.kind == "position_loop" else None
        for j, (plant, one) in enumerate(zip(plants, histories, strict=True))
    ]
    return tuple(
        tuple(piece_of(one, gain, DriveLoad(), a, b) for one, gain in zip(histories, gains, strict=True))
        for a, b in pairwise(edges)
    )


def _fed(model: Any, name: str, task: Any) -> tuple[Any, Any]:
    """Drive train and input; a torque is the current that gives it, past the amplifier."""
    drive = model.all_drives[name]
    train = train_of(model, drive.bar if isinstance(drive, LengthDrive) else name)
    if isinstance(task, GivenForce):
        task = StepInput(torque=task.torque) if task.times is None else TableInput(times=task.times, torques=task.torques)
    return in_currents(train, task)


def _refuse_redundant(names: list[str], start: Response) -> None:
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


def _small(plants: tuple[Plant, ...], pieces: Any, edges: tuple[float, ...], start: Response) -> NDArray[np.float64]:
    """Torques (N m) that are none beside those that occur; as `simulate_drive` has it."""
    from kinetruss.actuators.forward import feed

    found = []
    for j, plant in enumerate(plants):
        size = max(plant.shaft.friction, abs(start.thrust[j]) * plant.shaft.rest_up)
        for (a, b), inputs in zip(pairwise(edges), pieces, strict=True):
            for t in np.linspace(a, b, 5):
                given = feed(plant, inputs[j], float(t), start.value[j], 0.0, 0.0)
                current = given.driving / plant.resistance if plant.inductive and plant.resistance else given.current
                size = max(size, plant.torque_constant * abs(current))
        found.append(1e-11 * size + 1e-18)
    return np.array(found)


def _rotor(plant: Plant, rate: float) -> float:
    return 0.5 * plant.shaft.inertia * (plant.shaft.speed * float(rate)) ** 2


def _stiff(plants: tuple[Plant, ...], t_end: float) -> bool:
    from kinetruss.actuators.forward import STIFF

    return any(t_end * plant.resistance / plant.inductance > STIFF for plant in plants if plant.inductive)
