"""A drive alone through its modes: it sticks, slips, saturates, runs at its speed limit."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.forward.drive_model import Mode
from kinetruss.actuators.forward.ends import watch
from kinetruss.actuators.forward.steps import Tolerances, method_from, step_of
from kinetruss.errors import AnalysisError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.forward.events import Interpolant, ModeEvent
    from kinetruss.actuators.forward.modes import Instant, MotorModes

    Floats = NDArray[np.float64]

__all__ = ["Phase", "phases_of"]

MOST_CHANGES = 5000


@dataclass(frozen=True, slots=True, eq=False)
class Phase:
    """A time in one mode, from `begin` to `end` (s), within an interval without jumps. table : of the modes.

    ends (steps,) : s, of the steps; parts : their interpolants.
    """

    begin: float
    end: float
    interval: int
    table: Floats
    ends: list[float]
    parts: list[Interpolant]

    @property
    def mode(self) -> Mode:
        """The mode of its drive."""
        return Mode.of(self.table[0].tolist())

    def at(self, t: float) -> Floats:
        """The state."""
        return self.parts[min(bisect_left(self.ends, t), len(self.parts) - 1)](t)

    def instant(self, modes: MotorModes, t: float, y: Floats) -> Instant:
        """Evaluate the drive in the mode of this phase."""
        modes.table = self.table
        return modes.instant(t, self.interval, y)


def phases_of(modes: MotorModes, start: Sequence[float], rtol: float) -> list[Phase]:
    """All phases of a run from a value and its rate; the last ends early where the stroke does."""
    drives, found = modes.drives, list[Phase]()
    y = np.zeros(modes.size)
    y[:2] = start
    given = Tolerances(rtol, modes.tolerances(1e-3 * rtol, 1e-3 * rtol))
    for interval, (t, until) in enumerate(pairwise(drives.edges)):
        y = modes.settled(t, interval, y) if interval else modes.begin(y)
        while t < until:
            direction = modes.modes[0].direction
            if direction and direction * (drives.limits[direction > 0] - y[0]) <= 0:
                return found
            phase, event = _phase(modes, interval, (t, until), y, given)
            found.append(phase)
            t, y = phase.end, phase.at(phase.end)
            if event is not None and event.name == "end of stroke":
                return found
            y, _ = modes.projected(t, interval, y, (0,) if event is not None and event.name == "stop" else ())
            if event is not None:
                y = modes.changed(t, interval, y, event)
            if len(found) > MOST_CHANGES:
                raise AnalysisError(
                    f"The drive changed its mode {MOST_CHANGES} times before t = {t:.6g} s. Its loop chatters: lower its gains."
                )
    return found


def _phase(
    modes: MotorModes, interval: int, span: tuple[float, float], y: Floats, given: Tolerances
) -> tuple[Phase, ModeEvent | None]:
    """Integrate until a mode ends; the event that ends it, or None at the end of the span."""
    solver, watched, steps = method_from(modes, interval, span[0], y, span[1], given), watch(modes, interval), []
    while solver.status == "running":
        step = step_of(solver, watched)
        if step is None:
            raise AnalysisError(f"The drive could not be integrated beyond t = {solver.t:.6g} s: its step became too small.")
        steps.append(step)
        if step.event is not None:
            break
    ends, parts = [one.at.t_max for one in steps], [one.at for one in steps]
    return Phase(span[0], steps[-1].end, interval, modes.table, ends, parts), steps[-1].event
