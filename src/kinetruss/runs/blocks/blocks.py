"""A run in blocks of samples: each is computed on its own, so that memory stays bounded and a run can go on later."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators, dynamics, kinematics, strength
from kinetruss.errors import InputError
from kinetruss.kinematics.given.support import check_supports
from kinetruss.limits import whole
from kinetruss.model import Model, Run
from kinetruss.model.motion.runs import STANDING
from kinetruss.results import Demand, Forces, Motion, Sections, Simulation, Status, Verdict

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SIMULATED", "Block", "Plan", "block_size", "blocks", "judged", "plan"]

SIMULATED = "dynamics.simulate"
LARGEST_BLOCK, SMALLEST_BLOCK, MEMBER_SAMPLES = 2000, 50, 100_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Plan:
    """What to compute.

    times : (samples,) s. cases : load cases (None: all loads of the model). given : motion from a file.
    full : False leaves out what utilisation does not need: forces at rest, section forces, motor demands.
    """

    model: Model
    name: str
    run: Run
    times: NDArray[np.float64]
    cases: tuple[str | None, ...]
    block: int
    given: Motion | None = None
    full: bool = True


@dataclass(frozen=True, kw_only=True, eq=False)
class Block:
    """Results of some consecutive samples, by load case; `verdict` over the cases.

    simulation : of a simulated motion, and `state`, where its integration stands behind the block.
    """

    motion: Motion
    forces: dict[str, Forces]
    sections: dict[str, Sections]
    demand: dict[str, Demand]
    verdict: Verdict | None
    simulation: Simulation | None = None
    state: Mapping[str, NDArray[Any]] | None = None

    def with_(self, **changes: Any) -> Block:
        """The block with some fields changed."""
        return replace(self, **changes)


def plan(model: Model, name: str | None, block: int | None = None) -> Plan:
    """Choose the run of a model and lay out its instants.

    Raises
    ------
    InputError : no run of that name, or several and none named.
    """
    chosen = _choose(model, name)
    run = model.runs[chosen]
    cases: tuple[str | None, ...] = run.load_cases if run.load_cases is not None else tuple(model.load_cases) or (None,)
    given = None
    if run.analysis == SIMULATED:
        cases = run.load_cases or (None,)
        times = np.linspace(0.0, run.t_end or 0.0, run.samples)
    elif run.motion is not None:
        # a run that is resumed may be resumed from another folder
        run = run.with_(motion=str(Path(run.motion).absolute()))
        model = model.with_(runs={**model.runs, chosen: run})
        given = kinematics.from_csv(model, str(run.motion))
        times = given.data["time"].values
    else:
        times = np.linspace(0.0, model.trajectory_of(run).duration, run.samples)
        check_supports(model, 0.0, float(times[-1]))
    block = block_size(model) if block is None else whole(block, "block")
    return Plan(model=model, name=chosen, run=run, times=times, cases=cases, block=block, given=given)


def block_size(model: Model) -> int:
    """Samples a block: fewer for large models, so that a block of all results stays near 100 MB."""
    return max(SMALLEST_BLOCK, min(LARGEST_BLOCK, MEMBER_SAMPLES // max(1, len(model.members))))


def blocks(
    plan: Plan,
    first: int = 0,
    position: NDArray[np.float64] | None = None,
    state: Mapping[str, NDArray[Any]] | None = None,
    *,
    fitted: bool = False,
) -> Iterator[Block]:
    """Results block by block from sample `first` on; `position` (n_nodes, dim) is the pose at sample ``first - 1``.

    Stops after the block in which the path ends early; its status says why. Of a simulation, `state` is where it stood, and
    `fitted` lets its first block say how many samples the others have.
    """
    if plan.run.analysis == SIMULATED:
        from kinetruss.runs.blocks.simulated import simulated

        yield from simulated(plan, first, state, fitted=fitted)
        return
    while first < len(plan.times):
        motion = _motion(plan, first, position)
        if motion.data.sizes["time"] == 0:
            yield Block(motion=motion, forces={}, sections={}, demand={}, verdict=None)
            return
        yield _analysed(plan, motion)
        if not motion.status.ok:
            return
        first += plan.block
        position = motion.data["position"].values[-1]


def _choose(model: Model, name: str | None) -> str:
    if not model.runs:
        wanted = "No run to compute" if name is None else f"No run called {name!r}"
        raise InputError(f"{wanted}: the model has none. Add one under runs: with a trajectory or a simulation. {STANDING}")
    offer = f"There are: {', '.join(model.runs)}."
    if name is None and len(model.runs) == 1:
        return next(iter(model.runs))
    if name is None:
        raise InputError(f"The model has {len(model.runs)} runs; name one. {offer}")
    if name not in model.runs:
        raise InputError(f"The model has no run called {name!r}. {offer}")
    return name


def _motion(plan: Plan, first: int, position: NDArray[np.float64] | None) -> Motion:
    """Motion of the samples of one block, started from the sample before it."""
    last = min(first + plan.block, len(plan.times))
    if plan.given is not None:
        return plan.given.with_(data=plan.given.data.isel(time=slice(first, last)))
    lead = 0 if position is None else 1
    trajectory = plan.model.trajectory_of(plan.run)
    try:
        motion = kinematics.follow(
            plan.model, trajectory, times=plan.times[first - lead : last], start=position, raise_on_failure=False
        )
    except InputError as error:
        if first == 0:
            raise
        # found while working, behind good samples: data, not a refusal
        return _nothing(plan, first, position).with_(status=Status.INCONSISTENT, message=str(error))
    return motion.with_(data=motion.data.isel(time=slice(lead, None)))


def _nothing(plan: Plan, first: int, position: NDArray[np.float64] | None) -> Motion:
    """A motion without samples."""
    trajectory = plan.model.trajectory_of(plan.run)
    before = kinematics.follow(plan.model, trajectory, times=plan.times[first - 1 : first], start=position)
    return before.with_(data=before.data.isel(time=slice(0, 0)))


def _analysed(plan: Plan, motion: Motion) -> Block:
    """Everything asked about a motion, load case by load case."""
    if plan.run.analysis == "kinematics.follow":
        return Block(motion=motion, forces={}, sections={}, demand={}, verdict=None)
    found = [dynamics.inverse(plan.model, motion, case, static=plan.full) for case in plan.cases]
    return judged(plan, motion, {forces.load_case: forces for forces in found})


def judged(plan: Plan, motion: Motion, forces: dict[str, Forces]) -> Block:
    """What follows from the forces: sections, utilisation, motor demands."""
    model, stations = plan.model, plan.run.stations
    if not plan.full:
        return Block(motion=motion, forces=forces, sections={}, demand={}, verdict=strength.check(model, forces))
    return Block(
        motion=motion,
        forces=forces,
        sections={case: strength.sections(model, one, stations=stations) for case, one in forces.items()},
        demand={case: actuators.evaluate(model, motion, one) for case, one in forces.items()} if model.actuators else {},
        verdict=strength.check(model, forces),
    )
