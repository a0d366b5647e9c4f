"""Forward dynamics: the motion under given forces, and all forces along it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.forward.record import simulation_of
from kinetruss.dynamics.forward.set_up import Options, problem_of, seconds
from kinetruss.dynamics.forward.steppers import stepper_for
from kinetruss.errors import AnalysisError, InputError, Interrupted
from kinetruss.kinematics.path import instants
from kinetruss.model import Model
from kinetruss.results import Simulation, Status

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["simulate", "wanted_times"]


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
