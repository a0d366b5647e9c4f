"""The state of an integration: its problem, the memory of its kernels, and the events so far."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.integrate.state import Memory
from kinetruss.kernels.solve.kkt import prepare_rows
from kinetruss.kinematics.turns import Passed
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.simulation_problem import Problem
    from kinetruss.mechanics import System


class Integration:
    """A `Problem` between its start and `t_end` (s).

    status, message : the state of the run; `ended` is True after the last sample. angles (3, drives) : values and rates of
    drive coordinates at the last sample, and its time, so that angles count whole turns. worst (3,) : largest change of the
    energy at a sample (J), its time (s), largest kinetic energy (J). lost (3,) : largest relative error
    of a force near a singular position, its time (s), the pivot there. passed : states between samples.
    """

    memory: Memory

    def __init__(self, problem: Problem, t_end: float) -> None:
        self.problem, self.t_end = problem, t_end
        self._clear()

    def _clear(self) -> None:
        problem = self.problem
        self._passed = Passed.none(problem.x0.size)
        self._unread: list[NDArray[np.float64]] = []
        self.angles, self.worst, self.lost = angles_at_start(problem.system), np.zeros(3), np.zeros(3)
        self.status, self.message, self.ended = Status.COMPLETED, " ".join(problem.notes), False

    @property
    def passed(self) -> Passed:
        """The states between samples so far."""
        if not self._unread:
            return self._passed
        problem, free, rows = self.problem, self.problem.eq.free, np.concatenate(self._unread)
        x, v = np.tile(problem.x0, (len(rows), 1)), np.tile(problem.v0, (len(rows), 1))
        x[:, free], v[:, free] = rows[:, 1 : 1 + len(free)], rows[:, 1 + len(free) : 1 + 2 * len(free)]
        for row, place, speed in zip(rows, x, v, strict=True):
            prepare_rows(problem.eq, problem.ws, float(row[0]), place, speed)  # sets prescribed coordinates
        self._passed, self._unread = Passed.joined([self._passed, Passed(t=rows[:, 0], x=x, v=v)]), []
        return self._passed

    def _pass(self, rows: NDArray[np.float64]) -> None:
        """Store states between samples: rows of time, free positions, free velocities, and extra states."""
        self._unread.append(rows[:, : 1 + 2 * len(self.problem.eq.free)].copy())

    @property
    def _last(self) -> float:
        """Last time (s) of the run so far: a step may end after the end of the run, or after an event that stops it."""
        return min(self.t_end, float(self.memory.stop)) if self.memory.started else self.t_end

    def passages(self) -> NDArray[np.float64]:
        """Passages (k, 3) of singular positions so far."""
        passages = self.memory.passages[: self.memory.passages_met]
        return passages[passages[:, 0] <= self._last]

    def happened(self) -> dict[str, Any]:
        """Events (k, 4) and passages (k, 3) so far, and the names and units of all events."""
        events = self.memory.events[: self.memory.events_met]
        return {
            "events": events[events[:, 1] <= self._last].copy(),
            "passages": self.passages().copy(),
            "event_names": np.array(list(self.problem.events), str),
            "event_units": np.array([one.unit for one in self.problem.events.values()], str),
        }


def angles_at_start(system: System) -> NDArray[np.float64]:
    """`Integration.angles` before the first sample; rates and time are not known there."""
    angles = np.full((3, len(system.drives)), np.nan)
    angles[0] = system.drive_start
    return angles
