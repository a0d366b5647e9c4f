"""A run in blocks of samples, computed one by one, so that memory is bounded and a run can be resumed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import dynamics
from kinetruss.errors import InputError
from kinetruss.model.runs import FLEXIBLE, STATIC
from kinetruss.results import Motion, Status
from kinetruss.runs.at_rest import along, standing
from kinetruss.runs.joining import BETWEEN
from kinetruss.runs.plans import SIMULATED, Block, Plan, followed, judged
from kinetruss.runs.results import RunResult
from kinetruss.runs.simulated import simulated

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray


def stored_blocks(plan: Plan, run: RunResult) -> Iterator[Block]:
    """The committed blocks of a run, one at a time."""
    for first in range(0, run.good, plan.block):
        part = slice(first, min(first + plan.block, run.good))
        motion = _cut(run.motion, part)
        if BETWEEN in motion.whole.dims and plan.run.analysis != SIMULATED:  # a simulation tells all of them so far
            motion = motion.with_(data=_instants(run.motion.whole, part.start, part.stop).load())
        elif plan.run.analysis != SIMULATED:
            # states between samples are in the store only at the end; earlier versions had no state of them
            before = run.motion.arrays["position"].values[first - 1] if first else None
            motion = motion.with_(data=motion.whole.assign(_between(_motion(plan, first, before))))
        forces = {
            case: _cut(one, part).with_(motion=motion, static=None if one.static is None else _cut(one.static, part))
            for case, one in run.forces.items()
        }
        yield judged(plan, motion, forces)


def _between(motion: Motion) -> dict[str, xr.DataArray]:
    """The states of a motion between its samples."""
    return {str(name): one for name, one in motion.whole.data_vars.items() if BETWEEN in one.dims}


def _cut(result: Any, part: slice) -> Any:
    # the interruption after the blocks is not a status of the blocks
    return result.with_(data=result.whole.isel(time=part).load(), status=Status.COMPLETED, message="")


# A run in blocks of samples, computed one by one, so that memory is bounded and a run can be resumed.


def blocks(
    plan: Plan,
    first: int = 0,
    position: NDArray[np.float64] | None = None,
    state: Mapping[str, NDArray[Any]] | None = None,
    *,
    fitted: bool = False,
) -> Iterator[Block]:
    """Results block by block from sample `first` on; `position` (n_nodes, dim) is the pose at sample ``first - 1``.

    Stops after the block in which the path ends early; its status gives the reason. For a simulation, `state` is the state to
    continue from; with `fitted` the first block determines the number of samples in the others.
    """
    if plan.run.analysis == SIMULATED:
        yield from simulated(plan, first, state, fitted=fitted)
        return
    if plan.given is None and plan.run.trajectory is None:
        yield standing(plan).with_(last=True)
        return
    while first < len(plan.times):
        motion = _motion(plan, first, position)
        if not len(motion.arrays["time"].values):
            yield Block(motion=motion, forces={}, sections={}, demand={}, verdict=None, last=True)
            return
        first += plan.block
        last = not motion.status.ok or first >= len(plan.times)
        yield _analysed(plan, motion).with_(last=last)
        if last:
            return
        position = motion.arrays["position"].values[-1]


def _motion(plan: Plan, first: int, position: NDArray[np.float64] | None) -> Motion:
    """Motion of the samples of one block, started from the sample before it."""
    last = min(first + plan.block, len(plan.times))
    if plan.given is not None:
        part = plan.given.with_(data=_instants(plan.given.whole, first, last))
        early = last < len(plan.given.arrays["time"].values)
        return part.with_(status=Status.COMPLETED, message="") if early else part
    lead = 0 if position is None else 1
    try:
        motion = _followed(plan, plan.times[first - lead : last], position, raising=False)
    except InputError as error:
        if first == 0:
            raise
        # an error after good samples is part of the result, not an exception
        return _nothing(plan, first, position).with_(status=Status.INCONSISTENT, message=str(error))
    return motion.with_(data=motion.whole.isel(time=slice(lead, None))) if lead else motion


def _instants(data: xr.Dataset, first: int, last: int) -> xr.Dataset:
    """Samples `first` to `last` of a motion, and the states between them and after the sample before."""
    part = data.isel(time=slice(first, last))
    if BETWEEN not in data.dims:
        return part
    times, t = data["time"].values, data["between_time"].values
    begin = times[first - 1] if first else -np.inf
    return part.isel({BETWEEN: (t > begin) & (t < times[min(last, len(times)) - 1])})


def _followed(plan: Plan, times: NDArray[np.float64], start: NDArray[np.float64] | None, *, raising: bool) -> Motion:
    return followed((plan.origin, plan.model), plan.condition, plan.run.trajectory, times, start, raising=raising)


def _nothing(plan: Plan, first: int, position: NDArray[np.float64] | None) -> Motion:
    """A motion without samples."""
    before = _followed(plan, plan.times[first - 1 : first], position, raising=True)
    return before.with_(data=before.whole.isel(time=slice(0, 0)))


def _analysed(plan: Plan, motion: Motion) -> Block:
    """All requested results of a motion, load case by load case."""
    if plan.run.analysis == "kinematics.follow":
        return Block(motion=motion, forces={}, sections={}, demand={}, verdict=None)
    if plan.run.analysis in (*STATIC, *FLEXIBLE):
        return along(plan, motion)
    found = [dynamics.inverse(plan.model, motion, case, static=plan.full) for case in plan.cases]
    return judged(plan, motion, {forces.load_case: forces for forces in found})
