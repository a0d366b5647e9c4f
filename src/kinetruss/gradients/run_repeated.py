"""The states of a run once more, also from its end to its start, in as much memory as there is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.simulation import stepper_for
from kinetruss.dynamics.simulation_problem import Problem
from kinetruss.errors import AnalysisError
from kinetruss.gradients.run_adjoint import States

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LEAST = 0.25
"""Shortest step that counts, as a share of the median."""
STORED = 400e6
"""Bytes of the states that are held at once."""


def steps_of(noted: Sequence[tuple[float, float]], t_end: float) -> tuple[Floats, Floats]:
    """Instants from the start to the end of a run, and the steps of the method there, from what it noted on its way."""
    t, h = np.array(noted).T
    good = (h > 0) & (np.diff(t, prepend=0.0) > 0)
    t, h = t[good], np.maximum(h[good], LEAST * np.median(h[good]))  # short steps after a break say little
    return np.concatenate([[0.0], t, [max(float(t[-1]), t_end)]]), np.concatenate([h[:1], h, h[-1:]])


@dataclass(frozen=True, eq=False)
class Repeated:
    """A run that can be repeated from its start."""

    problem: Problem
    t_end: float

    def states(self, t: Floats) -> States:
        """The states at instants (s,), ascending."""
        return self._states(self._stepper(), t)

    def backwards(self, edges: Floats, each: int, c: Floats) -> Iterator[tuple[Floats, States]]:
        """From the end to the start, ends of at most so many cells, and the states at these and at the places c between.

        The run is repeated once; if its states take too much room, from places that are stored on the way.
        """
        blocks = [slice(i, min(i + each, len(edges) - 1) + 1) for i in range(0, len(edges) - 1, each)]
        together = max(1, int(STORED / ((len(c) + 1) * (self.problem.x0.size * 4 + 8) * 8 * each)))
        parts = [blocks[i : i + together] for i in range(0, len(blocks), together)]
        work, stored = self._stepper(), []
        for part in parts[:-1]:
            stored.append(work.arrays())
            work.advance(edges[part[-1].stop - 1 : part[-1].stop])
        for part in reversed(parts):
            if len(parts) > 1 and part is not parts[-1]:
                work = self._stepper()
                work.restore(stored.pop())
            own = edges[part[0].start : part[-1].stop]
            inside = own[:-1, None] + np.diff(own)[:, None] * np.concatenate([[0.0], c])
            every, per = self._states(work, np.append(inside.reshape(-1), own[-1])), len(c) + 1
            for block in reversed(part):
                first, last = block.start - part[0].start, block.stop - 1 - part[0].start
                yield edges[block], every.part(slice(first * per, last * per + 1))

    def _stepper(self) -> Any:
        return stepper_for(self.problem.fresh(), self.t_end)

    def _states(self, work: Any, t: Floats) -> States:
        found = work.advance(t)
        if len(found.t) < len(t):
            raise AnalysisError(
                f"The run cannot be repeated beyond t = {found.t[-1]:.6g} s. Run it again with tighter tolerances."
            )
        return States(found.t, found.x, found.v, found.a, np.ascontiguousarray(found.N[:, self.problem.eq.row]))
