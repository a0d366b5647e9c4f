"""Joins the blocks of a run along time, with the worst entry of each rule; gauge readings of a run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import actuators, strength
from kinetruss.kinematics.turns import Passed
from kinetruss.mechanics import compile
from kinetruss.model import Model
from kinetruss.results import Demand, Forces, Motion, Simulation, Status, Verdict
from kinetruss.results.store import key
from kinetruss.runs.instants import forces_at
from kinetruss.runs.plans import Block, Plan, plan
from kinetruss.runs.results import RunResult
from kinetruss.strength.gauge_records import inside

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kinetruss.io import StrainHistory


def gauge_strains(
    model: Model, name: str | None = None, *, load_case: str | None = None, measured: StrainHistory | None = None
) -> xr.Dataset:
    """Readings of a model's gauges along a named run; see `strength.gauges`.

    Parameters
    ----------
    name : a run of the model; may be omitted if there is only one. load_case : by default the run's first.
    measured : the run is also computed exactly at the times of this record.

    Raises
    ------
    InputError : no such run or load case, no gauges, `measured` is no record. ModelError : measured times outside the run.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["strain_gauges"][0])
    >>> strains = kt.runs.gauge_strains(model, "experiment_1")
    >>> dict(strains.strain.sizes)
    {'time': 110, 'gauge': 3}
    """
    job = plan(model, name)
    times = job.times
    if measured is not None:
        inside(measured, float(times[0]), float(times[-1]))
        times = _also(times, measured.times)
    zero = model.gauge_zero
    if zero is not None and zero.time is not None and times[0] <= zero.time <= times[-1]:
        times = _also(times, np.array([zero.time]))
    return strength.gauges(job.model, forces_at(model, name, times, load_case=load_case), zero_of=job.origin)


def _also(times: np.ndarray, more: np.ndarray) -> np.ndarray:
    """The times of both, without duplicates up to round-off."""
    inner = np.clip(more, times[0], times[-1])
    new = [t for t in inner if np.abs(times - t).min() > 1e-9 * (times[-1] - times[0])]
    return np.unique(np.concatenate([times, new]))


# Joins blocks: histories along time, and the worst entry of each rule over all blocks.

BETWEEN = "between"
"""Dimension of the states of a motion that lie between its samples."""


@dataclass(eq=False)
class Accumulator:
    """Results accumulated from block to block: the number of samples, and the worst entries so far."""

    model: Model
    count: int = 0
    status: Status = Status.COMPLETED
    message: str = ""
    verdict: Verdict | None = None
    demand: dict[str, DemandAccumulator] = field(default_factory=dict)
    simulation: xr.Dataset | None = None
    between: list[xr.Dataset] = field(default_factory=list)

    def add(self, block: Block) -> None:
        """Take one more block into account."""
        self.count += int(block.motion.whole.sizes["time"])
        self.status = block.motion.status
        left = [] if block.demand or not block.motion.unchecked else [block.motion.unchecked]
        self.message = " ".join([*notes_of(block), *left]) or self.message
        if BETWEEN in block.motion.whole.dims:
            # a simulation tells all of them so far
            before = [] if block.simulation is not None else self.between
            self.between = [*before, block.motion.whole.drop_dims("time").drop_dims(["member", "drive"])]
        if block.simulation is not None:
            self.simulation = block.simulation.whole.drop_dims("time")
        if block.verdict is not None:
            self.verdict = block.verdict if self.verdict is None else worse(self.verdict, block.verdict)
        for case, demand in block.demand.items():
            self.demand.setdefault(case, DemandAccumulator()).add(self.model, demand)

    @property
    def state(self) -> dict[str, NDArray[np.float64]] | None:
        """The states between samples so far, which the store holds as variables only at the end; None without any."""
        if not self.between:
            return None
        passed = Passed.of(compile(self.model), Motion(data=concatenated(self.between, BETWEEN)))
        return {f"passed_{name}": values for name, values in vars(passed).items()}


def notes_of(block: Block) -> list[str]:
    """The notes of a block."""
    # the message of forces starts with that of their motion
    messages = [block.motion.message] if block.simulation is None else [block.simulation.message]
    found = [forces.message for forces in block.forces.values()] or messages
    return [text for text in dict.fromkeys(found) if text]


def worse(a: Verdict, b: Verdict) -> Verdict:
    """For every entry the row with the higher utilisation, with all its values."""
    return a.with_(data=_worse(a.whole, b.whole))


def _worse(a: xr.Dataset, b: xr.Dataset) -> xr.Dataset:
    # an entry without a limit has no utilisation: the largest value counts
    first, second = (one["utilisation"].fillna(one["value"]).fillna(-1.0) for one in (a, b))
    return a.where(first >= second, b).assign_attrs(a.attrs)


@dataclass(eq=False)
class DemandAccumulator:
    """Peaks, energies and mean torque over consecutive blocks, including the interval between blocks."""

    last: xr.Dataset | None = None
    summary: xr.Dataset | None = None
    duration: float = 0.0

    def add(self, model: Model, demand: Demand) -> None:
        """Take one more block into account."""
        histories = timed(demand.data)
        joined = histories if self.last is None else concatenated([self.last, histories])
        found = actuators.summarise(model, demand.with_(data=joined)).data
        found = found.drop_dims("time")
        length = float(joined["time"][-1] - joined["time"][0])
        if self.summary is not None:
            found = actuators.merge_summaries(self.summary, found, (self.duration, length))
        self.summary, self.duration = found, self.duration + length
        self.last = histories.isel(time=slice(-1, None))


def groups_of(block: Block) -> dict[str, xr.Dataset]:
    """Datasets of a block with a time axis, by their path in the store."""
    found = {"motion": block.motion.whole}
    if block.simulation is not None:
        found["simulation"] = block.simulation.whole
    for case, forces in block.forces.items():
        found[f"forces/{key(case)}/total"] = forces.whole
        if forces.static is not None:
            found[f"forces/{key(case)}/static"] = forces.static.whole
    found |= {f"statics/{key(case)}": one.whole for case, one in block.statics.items()}
    found |= {f"sections/{key(case)}": one.whole for case, one in block.sections.items()}
    found |= {f"demand/{key(case)}": one.whole for case, one in block.demand.items()}
    return {name: timed(data) for name, data in found.items()}


def timed(data: xr.Dataset) -> xr.Dataset:
    """The variables with a time axis; the others are known only at the end."""
    return data.drop_vars([name for name, variable in data.data_vars.items() if "time" not in variable.dims])


def tail_groups(accumulated: Accumulator) -> dict[str, xr.Dataset]:
    """The datasets known only at the end."""
    found = {} if accumulated.verdict is None else {"verdict": accumulated.verdict.data}
    if accumulated.simulation is not None:
        found["simulation"] = accumulated.simulation
    if accumulated.between:
        found["motion"] = concatenated(accumulated.between, BETWEEN)
    return found | {f"demand/{key(case)}": one.summary for case, one in accumulated.demand.items() if one.summary is not None}


def in_memory(plan: Plan, kept: list[Block], accumulated: Accumulator, wall_time: float) -> RunResult:
    """The result of a run in memory."""
    motion = _whole_motion([block.motion for block in kept], accumulated)
    full = [block for block in kept if block.forces]
    forces = {case: _forces([block.forces[case] for block in full], motion) for case in kept[0].forces}
    return RunResult(
        model=plan.model,
        given=plan.origin,
        name=plan.name,
        motion=motion,
        forces=forces,
        simulation=_simulation(kept, motion, forces),
        statics={case: _along_time([block.statics[case] for block in kept if block.statics]) for case in kept[0].statics},
        sections={case: _along_time([block.sections[case] for block in full]) for case in kept[0].sections},
        verdict=accumulated.verdict,
        demand={case: _demand([block.demand[case] for block in full], accumulated.demand[case]) for case in kept[0].demand},
        status=accumulated.status,
        message=accumulated.message,
        samples=len(plan.times),
        provenance=motion.provenance,
        wall_time=wall_time,
    )


def _whole_motion(parts: list[Motion], accumulated: Accumulator) -> Motion:
    """The motion of all blocks, with the states between its samples."""
    if len(parts) == 1 or not accumulated.between:
        return _along_time(parts)  # type: ignore[no-any-return]
    found: Motion = _along_time([part.with_(data=part.whole.drop_dims(BETWEEN, errors="ignore")) for part in parts])
    between = concatenated(accumulated.between, BETWEEN)
    return found.with_(data=found.whole.assign({name: between[name].variable for name in between.data_vars}))


def _forces(parts: list[Forces], motion: Motion) -> Forces:
    statics = [part.static for part in parts if part.static is not None]
    static = _along_time(statics).with_(motion=motion) if statics else None
    whole: Forces = _along_time(parts)
    at: dict[str, list[float]] = {}
    for part in parts:
        for name, times in part.attrs.get("not_unique_at", {}).items():
            at[name] = [*at.get(name, ()), *times]
    if at:
        whole.whole.attrs["not_unique_at"] = at
    return whole.with_(motion=motion, static=static)


def _simulation(kept: list[Block], motion: Motion, forces: Mapping[str, Forces]) -> Simulation | None:
    parts = [block.simulation for block in kept if block.simulation is not None]
    if not parts:
        return None
    found = parts[-1].whole.drop_dims("time")  # events and passages so far
    data = parts[0].whole if len(parts) == 1 else concatenated([timed(part.whole) for part in parts]).merge(found)
    one = next(iter(forces.values()), parts[-1].forces)
    return parts[-1].with_(data=data, motion=motion, forces=one)


def _demand(parts: list[Demand], accumulated: DemandAccumulator) -> Demand:
    if len(parts) == 1:
        return parts[0]
    histories: Demand = _along_time([part.with_(data=timed(part.whole)) for part in parts])
    summary = parts[0].whole.drop_dims("time") if accumulated.summary is None else accumulated.summary
    return histories.with_(data=histories.data.merge(summary, compat="override", join="override"))


def _along_time(parts: list[Any]) -> Any:
    """One result from consecutive ones, with status and message of the last one."""
    return parts[0] if len(parts) == 1 else parts[-1].with_(data=concatenated([part.whole for part in parts]))


def concatenated(datasets: list[xr.Dataset], along: str = "time") -> xr.Dataset:
    """Datasets of consecutive samples as one."""
    import xarray as xr

    return xr.concat(datasets, along, data_vars="minimal", coords="minimal", compat="override", join="override")
