"""Forward dynamics: the motion under given forces and all forces along it, once, or many times without records."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.dynamics.simulation_problem import Problem
from kinetruss.dynamics.simulation_records import simulation_of
from kinetruss.dynamics.simulation_setup import Options, problem_of, seconds
from kinetruss.dynamics.stepping import KernelStepper, Stepper
from kinetruss.errors import AnalysisError, InputError, Interrupted
from kinetruss.kinematics.motions import instants
from kinetruss.kinematics.turns import refined
from kinetruss.mechanics.elements import refuse_turns
from kinetruss.model import Model, Tracking
from kinetruss.results import Simulation, Status
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@one_thread
def simulate(
    model: Model,
    t_end: float | str | None = None,
    *,
    samples: int = 201,
    times: ArrayLike | None = None,
    method: Any = None,
    tasks: Mapping[str, Any] | None = None,
    trajectory: Any = None,
    load_case: str | None = None,
    velocities: Mapping[str, Sequence[float]] | ArrayLike | None = None,
    positions: ArrayLike | None = None,
    user_force: Any = None,
    events: Mapping[str, Any] | None = None,
    feedback: Tracking | None = None,
    progress: Callable[[int, int], None] | None = None,
    raise_on_failure: bool = True,
) -> Simulation:
    """Forward dynamics: the motion that forces cause, and the forces in all members along it.

    Parameters
    ----------
    t_end : s, or text with a unit; the start is at 0. samples : equally spaced instants from 0 to t_end; `times` : the
        instants instead, s, increasing. They choose the reported samples, not the steps of the method.
    method : `Taylor`, `DOP853` or, for stiff runs, `Radau` (steps chosen by the error), `EnergyMomentum`, `GeneralizedAlpha`,
        `Rattle`; None: `Taylor` if the motion has a power series, else `DOP853`.
    tasks : drive -> what it does: `Free`, `Hold`, `GivenForce`, an input of its motor, or a trajectory of that drive alone. A
        drive without a task follows `trajectory` (a record, or the name of one) if that moves it, else it is held.
    load_case : name of a load case; None takes all loads with factor 1.
    velocities : node -> vector, or (n_nodes, dim), m/s; by default those of the model. positions : (n_nodes, dim), m; by
        default the model's own. Nodes that are not named are at rest if the constraints allow it, else they move with those
        named. Both are projected onto the constraints of bars, drives and supports; changes are reported.
    user_force : f(t, x, v) -> node -> force (N), or (n_nodes, dim), with x, v (n_nodes, dim) in m, m/s; or a compiled function
        f(t, x, v, out) over flat vectors (3 n_nodes,) that adds to out.
    events : name -> `Event`.
    feedback : a `Tracking`: drives without a task follow `trajectory` by forces, with gains and limits, instead of exactly.
    progress : called with (samples done, samples asked for) a few times a second.
    raise_on_failure : False returns the good samples with a status instead of an exception.

    Returns
    -------
    Simulation. ``motion`` and ``forces`` are those of `kinematics.follow` and `dynamics.inverse`; ``data`` has energy,
    kinetic_energy, potential_energy (J), momentum (kg m/s), angular_momentum about the origin (kg m^2/s), step_size (s),
    smallest_pivot, constraint_error, steps, rejected, evaluations over time; ``events`` and ``passages`` list the events and
    the singular positions passed.

    Raises
    ------
    InputError : unusable times, tasks or names, a start that cannot be closed, nodes without mass that no constraint
    determines. Nothing was computed.
    AnalysisError : the run ended early; `result` is the Simulation up to there, its status gives the reason.
    Interrupted : Ctrl-C; a KeyboardInterrupt with `result`.

    Notes
    -----
    M(x) a + J^T N = f(t, x, v), J a = gamma, in Cartesian coordinates of the nodes; positions and velocities are projected onto
    the constraints. The forces of members, supports and drives are those of `dynamics.inverse` along the same motion.

    Examples
    --------
    >>> import kinetruss as kt
    >>> ball = kt.Model(nodes={"A": kt.Node(at=(0, 5), mass=1.0)}, gravity=(0, -10))
    >>> fall = kt.dynamics.simulate(ball, 1.0, samples=3)
    >>> fall.motion.position.sel(node="A", axis="y").values.round(6).tolist()  # m: 5 - g t^2/2
    [5.0, 3.75, 0.0]
    """
    t = wanted_times(t_end, samples, times, model)
    last = float(t[-1]) if t_end is None else seconds(t_end)
    options = Options(
        method=method,
        tasks=tasks,
        trajectory=trajectory,
        load_case=load_case,
        velocities=velocities,
        positions=positions,
        user_force=user_force,
        events=events,
        feedback=feedback,
    )
    work = stepper_for(problem_of(model, last, options), last)
    callback = None if progress is None else lambda done: progress(done, len(t))
    found = simulation_of(work, work.advance(t, progress=callback))
    if found.status is Status.INTERRUPTED and raise_on_failure:
        raise Interrupted(found.message, found)
    if raise_on_failure and not found.status.ok:
        raise AnalysisError(f"{found.status.value} {found.message}".strip(), found)
    return found


def wanted_times(
    t_end: float | str | None, samples: int, times: ArrayLike | None, model: Model | None = None
) -> NDArray[np.float64]:
    """The instants of the samples, s.

    Raises
    ------
    InputError : an end that is not after the start at 0, instants outside, too few samples.
    """
    if t_end is None and times is None:
        raise InputError("Give the end of the simulation, t_end (s), or times.")
    if t_end is not None:
        t_end = seconds(t_end)
    t = instants(float(t_end or 0.0), samples, times, model)
    if times is not None:
        last = t[-1] if t_end is None else float(t_end)
        if t[0] < 0 or t[-1] > last * (1 + 1e-12) or not last > 0:
            raise InputError(f"times from {t[0]:g} s to {t[-1]:g} s go outside the run, 0 s to {last:g} s. Stay inside.")
    return t


# One simulation run many times: set up once, run without records.


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
        if system.force_elements:
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


@one_thread
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


def stepper_for(problem: Problem, t_end: float) -> Stepper:
    """The integration of a problem until t_end (s): with motors step by step between input changes, else in one kernel."""
    if problem.motors is None:
        return KernelStepper(problem, t_end)
    from kinetruss.dynamics.motor_stepping import MotorStepper  # SciPy's integrators, which other simulations do not need

    return MotorStepper(problem, t_end)
