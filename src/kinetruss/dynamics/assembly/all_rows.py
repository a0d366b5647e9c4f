"""Forces of all rows of a system: those of the equations, and those of released drives."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.model import GivenForce

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["all_rows"]


def all_rows(problem: Problem, t: NDArray[np.float64], x: NDArray[np.float64], N: NDArray[np.float64]) -> NDArray[np.float64]:
    """N (s, rows of the system) from N of the rows of the equations (s, rows), at times t (s,) and positions x (s, 3 n).

    The row of a drive with a given force F has N = -F; of one with a given torque minus the torque over the length.
    """
    system, row = problem.system, problem.eq.row
    found = np.zeros((len(N), len(system.row_member)))
    found[:, row] = N
    given = system.row_drive >= 0
    given[row] = False
    for r in np.flatnonzero(given):
        task = problem.tasks[system.drives[system.row_drive[r]]]
        if isinstance(task, GivenForce):
            found[:, r] = -_amount(task, t)
            if (m := system.row_measure[r]) >= 0:
                found[:, r] /= system.measure_scale[m]
            if system.row_kind[r] == ANGLE:
                i, y = system.row_member[r], x.reshape(len(x), len(system.nodes), 3)
                found[:, r] /= np.sqrt(((y[:, system.q[i]] - y[:, system.p[i]]) ** 2).sum(axis=1))
    return found


def _amount(task: GivenForce, t: NDArray[np.float64]) -> NDArray[np.float64]:
    if task.times is None or task.table is None:
        return np.full(len(t), task.constant)
    return np.interp(t, task.times, task.table)
