"""Where an integration stands: its problem, the memory of its kernels, and what has happened so far."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kinematics.path import Passed
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem
    from kinetruss.kernels.integrate.state import Memory
    from kinetruss.mechanics import System

__all__ = ["Integration", "angles_at_start"]


class Integration:
    """A `Problem` between its start and `t_end` (s).

    status, message : how it stands; `ended` is True once nothing more comes. angles (3, drives) : values and rates of drive
    coordinates at the last sample, and its time, so that angles go on by whole turns. worst (3,) : largest change of the
    energy at a sample (J), its time (s), largest kinetic energy (J). passed : states between samples.
    """

    memory: Memory

    def __init__(self, problem: Problem, t_end: float) -> None:
        self.problem, self.t_end = problem, t_end
        self._clear()

    def _clear(self) -> None:
        problem = self.problem
        self._passed = [Passed.none(problem.x0.size)]
        self.angles, self.worst = angles_at_start(problem.system), np.zeros(3)
        self.status, self.message, self.ended = Status.COMPLETED, " ".join(problem.notes), False

    @property
    def passed(self) -> Passed:
        """States between samples so far. They are joined when asked for: a run may keep thousands of parts."""
        self._passed = [Passed.joined(self._passed)]
        return self._passed[0]

    def happened(self) -> dict[str, Any]:
        """Events (k, 4) and passages (k, 3) so far, and the names of all events."""
        memory = self.memory
        # a step may end behind the end of the run, or behind an event that stops it
        last = min(self.t_end, float(memory.stop)) if self.memory.started else self.t_end
        events, passages = memory.events[: self.memory.events_met], memory.passages[: self.memory.passages_met]
        return {
            "events": events[events[:, 1] <= last].copy(),
            "passages": passages[passages[:, 0] <= last].copy(),
            "event_names": np.array(list(self.problem.events), str),
        }


def angles_at_start(system: System) -> NDArray[np.float64]:
    """`Integration.angles` before the first sample: its rates and time are not known."""
    angles = np.full((3, len(system.drives)), np.nan)
    angles[0] = system.drive_start
    return angles
