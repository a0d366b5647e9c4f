"""What tasks ask for, as further rows of the equations of a motion: c(x) = 0 in node places and parameters given in time.

Drives follow from the places then: those of a motion that tasks lead are measured, and their rows prescribe nothing.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.kernels.coordinates.tape import Tape, forward, tape_of
from kinetruss.kernels.structure.structure import ANGLE, States
from kinetruss.kinematics.positions import own_start
from kinetruss.kinematics.task_courses import parameters_of
from kinetruss.kinematics.task_motions import divided
from kinetruss.kinematics.task_programs import tasks_of
from kinetruss.mechanics import System
from kinetruss.mechanics.positions import drive_values

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

TURN = 2 * math.pi


class TaskRows(NamedTuple):
    """The program of tasks, and Taylor coefficients (3, s, p) of its parameters at the instants."""

    tape: Tape
    parameters: Floats

    @property
    def tasks(self) -> int:
        """Number of tasks."""
        return int(self.tape.tasks)

    def tiled(self, count: int) -> TaskRows:
        """The same so many times, one after the other."""
        return self._replace(parameters=np.tile(self.parameters, (1, count, 1)))

    def residuals(self, states: States) -> tuple[Floats, Floats, Floats]:
        """c and its two rates (s, tasks), m and s, at states (s, 3 n)."""
        value, rate, half = self._series(np.stack([states.x, states.v, 0.5 * states.a]), self.parameters)
        return value, rate, 2.0 * half

    def gradients(self, i: int, x: Floats, free: NDArray[np.int64]) -> Floats:
        """dc/dx (tasks, free) at place x (3 n,) of instant i: the rates of c along each coordinate alone."""
        series = np.zeros((3, len(free), x.size))
        series[0] = x
        series[1][np.arange(len(free)), free] = 1.0
        still = np.zeros((3, len(free), self.parameters.shape[2]))
        still[0] = self.parameters[0, i]
        return np.asarray(self._series(series, still)[1].T)

    def _series(self, x: Floats, parameters: Floats) -> Floats:
        """Taylor coefficients (3, s, tasks) from those of places (3, s, 3 n)."""
        found = np.zeros((3, x.shape[1], self.tasks))
        room, out = np.zeros((3, len(self.tape.op))), self.tape.out[: self.tasks]
        for i in range(x.shape[1]):
            own, given = np.ascontiguousarray(x[:, i]), np.ascontiguousarray(parameters[:, i])
            for k in range(3):
                forward(self.tape, own, given, k, room)
            found[:, i] = room[:, out]
        return found


def task_rows(system: System, targets: Any, t: Floats) -> TaskRows:
    """The rows of tasks at instants t (s,) s."""
    tasks = tasks_of(system, divided(system, targets)[0])
    start = tasks.start(own_start(system).reshape(-1))
    return TaskRows(tape_of(tasks.program, len(tasks.labels)), parameters_of(tasks, start, t))


def drives_at(system: System, states: States, near: Floats) -> tuple[Floats, Floats, Floats]:
    """Values, rates and second rates of drives (s, drives) at states (s, 3 n); angles in the turn of the values `near`."""
    value, rate, second = drive_values(system, *(y.reshape(len(y), -1, 3) for y in states))
    period = np.zeros(len(system.drives))
    rows = np.flatnonzero(system.row_drive >= 0)
    measure = system.row_measure[rows]
    of_sums = system.measure_period[measure] if len(system.measures) else 0.0
    period[system.row_drive[rows]] = np.where(measure >= 0, of_sums, np.where(system.row_kind[rows] == ANGLE, TURN, 0.0))
    turns = np.rint((near - value) / np.where(period > 0, period, 1.0)) * period
    return value + turns, rate, second
