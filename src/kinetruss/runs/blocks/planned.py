"""The plan of a run: its instants, load cases and block size."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss import kinematics
from kinetruss.errors import InputError
from kinetruss.kinematics.given import check_supports
from kinetruss.limits import whole
from kinetruss.model import Condition, Model, Run
from kinetruss.model.motion import FLEXIBLE, MISSION, STANDING, STATIC
from kinetruss.results import Motion
from kinetruss.runs.blocks.conditioned import SIMULATED, conditioned

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["FLEXIBLE", "SIMULATED", "STATIC", "Plan", "block_size", "chosen_run", "plan"]

LARGEST_BLOCK, SMALLEST_BLOCK, MEMBER_SAMPLES = 2000, 50, 100_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Plan:
    """The results to compute.

    model : under the condition of the run; origin : as it was given. times : (samples,) s.
    cases : load cases (None: all loads of the model). given : motion from a file or for a task, or known before.
    full : False omits results that utilisation does not need: forces at rest, section forces, motor demands.
    bare : only motion and forces.
    """

    model: Model
    origin: Model
    name: str
    run: Run
    times: NDArray[np.float64]
    cases: tuple[str | None, ...]
    block: int
    given: Motion | None = None
    condition: Condition | None = None
    full: bool = True
    bare: bool = False


def plan(model: Model, name: str | None, block: int | None = None) -> Plan:
    """Select a run of a model and determine its instants.

    Raises
    ------
    InputError : no run of that name, or several and none named; a mission.
    """
    chosen = chosen_run(model, name)
    run = model.runs[chosen]
    if run.analysis == MISSION:
        raise InputError(
            f"Run {chosen!r} is a mission: it has an envelope, and no history of its own. Name one of its motions that is a "
            f"run ({', '.join(run.motions)}), or take the run of a pair (runs.governing)."
        )
    cases: tuple[str | None, ...] = run.load_cases if run.load_cases is not None else tuple(model.load_cases) or (None,)
    given, origin = None, model
    model, run, condition = conditioned(model, run)
    if run.analysis in (SIMULATED, "statics.equilibrium"):
        cases = run.load_cases or (None,)
    if run.analysis == SIMULATED:
        times = np.linspace(0.0, run.t_end or 0.0, run.samples)
    elif run.motion is not None:
        # a run may be resumed from another working folder
        run = run.with_(motion=str(Path(run.motion).absolute()))
        origin = origin.with_(runs={**origin.runs, chosen: origin.runs[chosen].with_(motion=run.motion)})
        given = kinematics.from_csv(model, str(run.motion))
        times = given.data["time"].values
    elif run.targets is not None:
        times = np.linspace(0.0, run.targets.duration, run.samples)
        check_supports(model, 0.0, float(times[-1]))
        given = kinematics.inverse(model, run.targets, times=times, raise_on_failure=False)
    elif run.trajectory is None:  # poses at rest, which are counted
        times = np.arange(max(1, len(run.poses)), dtype=float)
        block = len(times)
    else:
        times = np.linspace(0.0, run.trajectory.duration, run.samples)  # type: ignore[union-attr]
        check_supports(model, 0.0, float(times[-1]))
    if run.analysis in FLEXIBLE:  # modes are followed, and a vibration goes on, from sample to sample
        block = len(times)
    block = block_size(model) if block is None else whole(block, "block")
    return Plan(
        model=model,
        origin=origin,
        name=chosen,
        run=run,
        times=times,
        cases=cases,
        block=block,
        given=given,
        condition=condition,
    )


def block_size(model: Model) -> int:
    """Samples per block: fewer for large models, so that all results of a block take about 100 MB."""
    return max(SMALLEST_BLOCK, min(LARGEST_BLOCK, MEMBER_SAMPLES // max(1, len(model.members))))


def chosen_run(model: Model, name: str | None) -> str:
    """The name of a run, or of the only one.

    Raises
    ------
    InputError : no run of that name, or several and none named.
    """
    if not model.runs:
        wanted = "No run to compute" if name is None else f"No run called {name!r}"
        raise InputError(f"{wanted}: the model has none. Add one to its runs, with a trajectory or as a simulation. {STANDING}")
    offer = f"There are: {', '.join(model.runs)}."
    if name is None and len(model.runs) == 1:
        return next(iter(model.runs))
    if name is None:
        raise InputError(f"The model has {len(model.runs)} runs; name one. {offer}")
    if name not in model.runs:
        raise InputError(f"The model has no run called {name!r}. {offer}")
    return name
