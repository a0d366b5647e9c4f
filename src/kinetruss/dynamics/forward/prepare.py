"""One simulation run many times: set up once, run without records."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.forward.kernel_stepper import KernelStepper
from kinetruss.dynamics.forward.problem import Problem
from kinetruss.dynamics.forward.set_up import Options, problem_of
from kinetruss.dynamics.forward.simulate import wanted_times
from kinetruss.dynamics.forward.stepper import Stepper
from kinetruss.dynamics.forward.steppers import stepper_for
from kinetruss.errors import InputError
from kinetruss.kinematics.path import refined
from kinetruss.mechanics.assembly import refuse_turns
from kinetruss.model import Model
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Histories", "Prepared", "prepare"]


class Histories(NamedTuple):
    """Good samples of a run as plain arrays.

    t (s,) s; position, velocity, acceleration (s, n_nodes, 3) m, m/s, m/s^2 (z is 0 in the plane); row_force (s, rows) N:
    tension of each rigid and driven member, in the order of the model's members, then of angle drives. status, message : how
    the run ended. steps, rejected, evaluations : counts.
    """

    t: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    row_force: NDArray[np.float64]
    status: Status
    message: str
    steps: int
    rejected: int
    evaluations: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Prepared:
    """A simulation that is set up; each `run` starts from the beginning. longest : largest end time, s, for which the drives'
    motions are prepared.
    """

    problem: Problem
    longest: float
    _works: dict[float, Stepper] = field(default_factory=dict, repr=False)
    _spaced: dict[tuple[float, int], NDArray[np.float64]] = field(default_factory=dict, repr=False)

    def run(self, t_end: float, *, samples: int = 2, times: ArrayLike | None = None) -> Histories:
        """Run from the start to t_end (s), with equally spaced samples or samples at `times`. An early end raises no exception.

        Raises
        ------
        InputError : times outside the run, an end beyond `longest`. AnalysisError : a spring that turns too far.
        """
        t = self._times(t_end, samples) if times is None else wanted_times(t_end, samples, times)
        if t_end > self.longest * (1 + 1e-12):
            raise InputError(f"The simulation is prepared for {self.longest:g} s. Prepare it with t_end={t_end:g}.")
        work = self._work(float(t_end))
        trace, system = work.advance(t), self.problem.system
        if system.springs:
            whole = refined(trace.t, trace.x, trace.v, trace.a, work.passed)
            refuse_turns(system, whole.t, whole.x, whole.v)
        shape = (len(trace.t), trace.x.shape[1] // 3, 3)
        counts = (work.memory.steps, work.memory.rejected, work.memory.evaluations)
        return Histories(
            trace.t,
            trace.x.reshape(shape),
            trace.v.reshape(shape),
            trace.a.reshape(shape),
            trace.N,
            work.status,
            work.message,
            *counts,
        )

    def _times(self, t_end: float, samples: int) -> NDArray[np.float64]:
        """Equally spaced times; those of the last run are reused."""
        if (t_end, samples) not in self._spaced:
            self._spaced.clear()
            self._spaced[t_end, samples] = wanted_times(t_end, samples, None)
        return self._spaced[t_end, samples]

    def _work(self, t_end: float) -> Stepper:
        """The integration at its start; the one of the last run is reset and reused."""
        if isinstance(work := self._works.get(t_end), KernelStepper):
            work.rewind()
            return work
        self._works.clear()
        return self._works.setdefault(t_end, stepper_for(self.problem, t_end))


def prepare(model: Model, t_end: float, **options: Any) -> Prepared:
    """Set up a simulation of at most t_end (s) that can be run many times without the cost of records.

    Options and errors as those of `simulate`: method, tasks, trajectory, load_case, velocities, positions, user_force, events.

    >>> import kinetruss as kt
    >>> pendulum = kt.Model(nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1)}, fixed=["O"], bars={"rod": ("O", "A")},
    ...                     gravity=(0, -9.81))
    >>> fall = prepare(pendulum, 1.0)
    >>> print(f"{fall.run(0.5).position[-1, 1, 1]:.6f}")
    -0.920370
    """
    return Prepared(problem=problem_of(model, t_end, Options(**options)), longest=float(t_end))
