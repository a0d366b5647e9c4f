"""The plan of a run: its instants, load cases, condition and block size; the results of a block of samples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators, kinematics, strength
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kinematics import conditions
from kinetruss.kinematics.time_tables import check_supports
from kinetruss.limits import whole
from kinetruss.mechanics import compile
from kinetruss.mechanics.rigid_motions import floats
from kinetruss.model import Condition, Free, Hold, Model, Quintic, Run
from kinetruss.model.load_cases import acting_cases
from kinetruss.model.runs import FLEXIBLE, MISSION, STANDING
from kinetruss.results import Demand, Forces, Motion, Result, Sections, Simulation, Verdict

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, kw_only=True, eq=False)
class Block:
    """Results of consecutive samples, by load case; `verdict` over all cases.

    statics : of static analyses, with a time axis.
    simulation : for a simulated motion; `state` is the state of its integration after the block. last : nothing follows.
    """

    motion: Motion
    forces: dict[str, Forces]
    sections: dict[str, Sections]
    demand: dict[str, Demand]
    verdict: Verdict | None
    statics: Mapping[str, Result] = field(default_factory=dict)
    simulation: Simulation | None = None
    state: Mapping[str, NDArray[Any]] | None = None
    last: bool = False

    def with_(self, **changes: Any) -> Block:
        """The block with some fields changed."""
        return replace(self, **changes)


def judged(plan: Plan, motion: Motion, forces: dict[str, Forces]) -> Block:
    """Results that follow from the forces: sections, utilisation, motor demands."""
    model, stations = plan.model, plan.run.stations
    if plan.bare or not forces:
        return Block(motion=motion, forces=forces, sections={}, demand={}, verdict=None)
    if not plan.full:
        return Block(motion=motion, forces=forces, sections={}, demand={}, verdict=strength.check(model, forces))
    return Block(
        motion=motion,
        forces=forces,
        sections={case: strength.sections(model, one, stations=stations) for case, one in forces.items()},
        demand={case: actuators.evaluate(model, motion, one) for case, one in forces.items()} if model.actuators else {},
        verdict=strength.check(model, forces),
    )


# The plan of a run: its instants, load cases and block size.

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
    cases: tuple[str | None, ...] = acting_cases(model, run.load_cases)
    given, origin = None, model
    model, run, condition = conditioned(model, run)
    if run.analysis in (SIMULATED, "statics.equilibrium"):
        cases = (None,) if run.load_cases is None else cases
    if run.analysis == SIMULATED:
        times = np.linspace(0.0, run.t_end or 0.0, run.samples)
    elif run.motion is not None:
        # a run may be resumed from another working folder
        run = run.with_(motion=str(Path(run.motion).absolute()))
        origin = origin.with_(runs={**origin.runs, chosen: origin.runs[chosen].with_(motion=run.motion)})
        given = kinematics.from_csv(model, str(run.motion))
        times = given.whole["time"].values
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
        if floats(compile(model)) is not None:  # where it is depends on all that was before
            if cases != (None,):
                raise InputError(
                    f"Run {chosen!r} moves a structure that floats, and every load case moves it otherwise. Simulate it under "
                    f"each by a run of its own: analysis: dynamics.simulate, t_end: {times[-1]:g} s, load_cases: [{cases[0]}], "
                    "with the same trajectory."
                )
            given = followed((origin, model), condition, run.trajectory, times, raising=False)
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


# Runs under an operating condition: the model and the drives as they are then.

SIMULATED, TASKED = "dynamics.simulate", ("dynamics.simulate", "statics.equilibrium")


def conditioned(model: Model, run: Run) -> tuple[Model, Run, Condition | None]:
    """The model under the condition of a run, the run as done on it, and the condition.

    Where drives have tasks, locked ones are held and released ones free; elsewhere released ones are taken out.

    Raises
    ------
    ModelError, InputError : as `conditions.under`; node histories under a condition that changes them.
    """
    run = run.with_(trajectory=model.trajectory_of(run))
    if run.condition is None:
        return model, run, None
    condition = conditions.named_condition(model, run.condition)
    if run.motion is not None and condition.moves_otherwise:
        raise InputError(
            f"The motion is given by node histories, which do not know what {run.condition!r} changes. Give a trajectory, or a "
            "condition without temperature and without locked, released or failed parts."
        )
    if run.analysis not in TASKED:
        return conditions.under(model, run.condition), run, condition
    fates = dict.fromkeys(condition.locked, Hold()) | dict.fromkeys(condition.released, Free())
    trajectory = run.trajectory if run.analysis == SIMULATED else None
    run = run.with_(tasks={**run.tasks, **fates}, trajectory=trajectory)
    return conditions.under(model, condition.with_(locked=(), released=())), run, condition


def followed(
    models: tuple[Model, Model],
    condition: Condition | None,
    trajectory: Any,
    times: NDArray[Any],
    start: ArrayLike | None = None,
    *,
    raising: bool = True,
) -> Motion:
    """The motion of a trajectory; models : as given, and under the condition. As `kinematics.follow`."""
    given, changed = models
    if condition is None or not condition.moves_otherwise:
        return kinematics.follow(changed, trajectory, times=times, start=start, raise_on_failure=raising)
    motion = conditions.commanded(given, changed, condition, trajectory, times, start=start)
    if raising and not motion.status.ok:
        raise AnalysisError(f"{motion.status.value} {motion.message}", motion)
    return motion


def poses_under(model: Model, condition: Condition | None, poses: Mapping[str, Mapping[str, float]]) -> dict[str, Any]:
    """Listed poses as commands of the drives that are left; locked ones stay."""
    if condition is None or not condition.moves_otherwise:
        return {name: dict(pose) for name, pose in poses.items()}
    gone = {*condition.released, *condition.locked}
    gone |= {name for name, drive in model.all_drives.items() if getattr(drive, "bar", None) in condition.failed}
    found = {}
    for name, pose in poses.items():
        commands = {}
        if pose:
            standing = Quintic(moves={one: (value, value) for one, value in pose.items()}, duration=1.0)
            value = kinematics.sample(model, standing, [0.0]).value[0]
            commands = dict(zip(model.all_drives, value.tolist(), strict=True))
        found[name] = {one: value for one, value in commands.items() if one not in gone}
    return found
