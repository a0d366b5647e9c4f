"""Motor-driven lengths and angles of a simulation: their drives, their inputs, and what is refused."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators import train_of
from kinetruss.actuators.forward import COLUMNS, Drives, drive_model_of, in_currents, inputs_of, kinks, source_of, stored_energy
from kinetruss.dynamics.forward.watch import jumps
from kinetruss.dynamics.motors.structure import StructureBody, motor_places
from kinetruss.errors import InputError
from kinetruss.kernels.solve.kkt import row_along
from kinetruss.kernels.solve.motors import motor_project
from kinetruss.kernels.structure.plan import ANGLE, SUM
from kinetruss.mechanics import System
from kinetruss.model import DOP853, MOTOR_TASKS, DriveLoad, GivenForce, Hold, LengthDrive, StepInput, TableInput

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["Motors", "driven_by_motors", "held_instead", "motors_of", "refuse_method"]

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
    kinked = {t for one in histories for t in kinks(one, DriveLoad(), t_end)} | {t for t in jumps(eq) if 0 < t < t_end}
    masses = [start.mass[j][j] for j in range(len(names))]
    return Motors(
        **inputs_of(models, histories, (0.0, *sorted(kinked), t_end), start.value, masses, lambda _, __: start.thrust),
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
