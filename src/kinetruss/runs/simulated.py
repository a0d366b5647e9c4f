"""Blocks of a simulation: each continues from the state of the integration after the previous one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from kinetruss.dynamics.simulation import stepper_for
from kinetruss.dynamics.simulation_records import simulation_of
from kinetruss.dynamics.simulation_setup import Options, problem_of
from kinetruss.dynamics.stepping import Stepper
from kinetruss.errors import AnalysisError, StoreError
from kinetruss.results import Simulation, Status
from kinetruss.runs.plans import Block, Plan, judged

if TYPE_CHECKING:
    from numpy.typing import NDArray


PATIENCE = 5.0
"""Seconds of work per block, which is the largest loss by a kill."""


def stepper_of(plan: Plan) -> Stepper:
    """The integration of a run, at its start.

    Raises
    ------
    InputError : the simulation cannot be started.
    """
    run, t_end = plan.run, float(plan.times[-1])
    options = Options(
        trajectory=run.trajectory,
        tasks=run.tasks,
        method=run.method,
        events=run.events,
        load_case=plan.cases[0],
        feedback=run.feedback,
    )
    return stepper_for(problem_of(plan.model, t_end, options), t_end)


def simulated(
    plan: Plan, first: int = 0, state: Mapping[str, NDArray[Any]] | None = None, *, fitted: bool = True
) -> Iterator[Block]:
    """Results block by block from sample `first` on; `state` is the state of the integration before it.

    fitted : the first block ends after `PATIENCE` seconds, and the others have as many samples. Stops after the block in which
    the motion ends early; its status gives the reason. Each block has the state after it.
    """
    work = stepper_of(plan)
    if state is not None:
        work.restore(state)
    elif first:
        raise StoreError("The state of the integration is not in the run folder. Run it again with --overwrite.")
    size = plan.block
    while first < len(plan.times):
        last = min(first + size, len(plan.times))
        trace = work.advance(plan.times[first:last], patience=PATIENCE if fitted and not first else None)
        if work.status is Status.INTERRUPTED:
            raise KeyboardInterrupt  # a block is complete or not written
        simulation = simulation_of(work, trace)
        count = len(trace.t)
        if count:
            found = judged(plan, simulation.motion, {simulation.forces.load_case: simulation.forces})
        else:
            found = Block(motion=simulation.motion, forces={}, sections={}, demand={}, verdict=None)
        yield found.with_(simulation=simulation, state=work.arrays(), last=work.ended or last == len(plan.times))
        if work.ended:
            return
        if not first:
            size = count
        first += count


def simulated_at(plan: Plan, t: NDArray[Any]) -> Simulation:
    """A simulated run at the instants t (s), increasing.

    Raises
    ------
    AnalysisError : the run ended before the last instant.
    """
    work = stepper_of(plan)
    found = simulation_of(work, work.advance(t))
    if found.whole.sizes["time"] < len(t):
        raise AnalysisError(f"Run {plan.name!r} ended early. {found.message or found.status.value}", found)
    return found
