"""The result of a run, and reading it from its folder."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.io.earlier import without_inner_parts
from kinetruss.kinematics.turns import Passed
from kinetruss.mechanics import compile
from kinetruss.model import Event, Model, Run
from kinetruss.model.table import read_only
from kinetruss.results import Demand, Forces, Motion, Result, Sections, Simulation, Status, Verdict
from kinetruss.results.dynamic_records import happened
from kinetruss.results.lock import is_locked
from kinetruss.results.store import Store, key, open_store
from kinetruss.results.user_parts import marked
from kinetruss.runs.doubts import doubts, poses_of
from kinetruss.runs.instants import derived
from kinetruss.runs.plans import conditioned
from kinetruss.runs.quantity_limits import deflection_rows, limit_rows, quantities_of
from kinetruss.strength.findings import Finding, demands, find

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.results.arrays import Column
    from kinetruss.results.wide_tables import Row


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class RunResult:
    """The results of one run.

    model : the model of the results: that which was given (`origin`) under the condition of the run. name : name of the run
    in it. motion : positions, velocities, accelerations.
    forces : load case -> Forces (``.static`` for the same poses at rest). sections : load case -> Sections.
    verdict : utilisation of every part by every rule, over all load cases. demand : load case -> Demand.
    statics : load case -> what a static analysis finds besides forces (displacements, energies, stability), over time or poses.
    quantities : load case -> the quantities that the model defines, with their rates.
    simulation : for a simulated motion, energies, events and diagnostics; else None.
    status, message : how it ended (RUNNING or INTERRUPTED if it has not ended); it contains only good samples.
    samples : number of requested samples; ``len(run.motion.time)`` of them are good.
    settings : for a variant, dotted path -> value that was set.
    path : the run folder, or None. state : ``finished``, ``running`` or ``incomplete`` (it was killed, or the disk filled).
    """

    model: Model
    name: str
    motion: Motion
    given: Model | None = None
    forces: Mapping[str, Forces] = field(default_factory=dict)
    sections: Mapping[str, Sections] = field(default_factory=dict)
    verdict: Verdict | None = None
    demand: Mapping[str, Demand] = field(default_factory=dict)
    statics: Mapping[str, Result] = field(default_factory=dict)
    simulation: Simulation | None = None
    status: Status = Status.COMPLETED
    message: str = ""
    samples: int = 0
    path: Path | None = None
    state: str = "finished"
    provenance: Mapping[str, Any] = field(default_factory=dict)
    wall_time: float = 0.0
    settings: Mapping[str, str] = field(default_factory=dict)

    counts: ClassVar[str] = "samples"
    holds: ClassVar[tuple[str, ...]] = ("motion", "forces", "sections", "verdict", "demand", "statics", "simulation")

    def __post_init__(self) -> None:
        read_only(self)

    def __repr__(self) -> str:
        """The name, how it ended, the verdict, and what it holds."""
        lines = [f"<Run {self.name!r} of {self.model.title or 'a model'!r}: {self.status.value} {self.message}".rstrip()]
        if self.verdict is not None or self.demand:
            lines.append(f"  {self.finding.sentence}")
        lines += [f"  warning: {one}" for one in self.finding.doubts]
        cases = f", load cases: {', '.join(map(str, self.forces))}" if self.forces else ""
        held = [name for name in self.holds if getattr(self, name)]
        lines.append(f"  {self.good} of {self.samples} {self.counts}{cases}; it has {', '.join(held)}>")
        return "\n".join(lines)

    @property
    def origin(self) -> Model:
        """The model that was given, without the condition of the run."""
        return self.model if self.given is None else self.given

    @property
    def definition(self) -> Run:
        """The run as the model describes it, with its trajectory in place of a name."""
        run = self.origin.runs[self.name]
        return run.with_(trajectory=self.origin.trajectory_of(run))

    @property
    def good(self) -> int:
        """Number of good samples."""
        return int(self.motion.whole.sizes["time"])

    @cached_property
    def finding(self) -> Finding:
        """What the run says: whether limits are kept, what governs, what was not checked and why, what is unsure."""
        return find(
            self.verdict,
            self._posed(demands(self.demand)),
            partial=self.partial,
            doubts=self.doubts,
            timed=self.timed,
            quantities=self._posed([*limit_rows(self.model, self.quantities), *self.deflections]),
        )

    @cached_property
    def deflections(self) -> tuple[Row, ...]:
        """The checks of the deflections to which the model gives limits, as of `strength.deflections`, in every load case; not
        checked where they are not known, as along motions.
        """
        run = self.origin.runs.get(self.name)
        # of drives that tasks move the positions are not those of loads alone
        return tuple(deflection_rows(self, moved=run is not None and bool(run.tasks)))

    def _posed(self, rows: Iterable[Row]) -> list[Row]:
        """The rows; of a run of poses, whose times are their numbers, with the pose in which each value is."""
        names = poses_of(self)
        return [replace(row, pose=names[round(row.time)]) if names and math.isfinite(row.time) else row for row in rows]

    @cached_property
    def quantities(self) -> dict[str, xr.Dataset]:
        """Load case -> the quantities that the model defines, as of `kinematics.quantities`: of statics under the loads of
        each case; else those of the motion, under ``all``. Empty if there are none.
        """
        return quantities_of(self)

    @property
    def doubts(self) -> tuple[str, ...]:
        """Sentences on what makes the numbers unsure."""
        return tuple(doubts(self))

    @property
    def partial(self) -> str:
        """Why the run is not that which was asked for; empty if it is."""
        if self.whole:
            return ""
        if self.state == "finished" and self.good == self.samples:
            return self.status.value.rstrip(".")
        return f"Not complete ({self.good} of {self.samples} {self.counts})"

    @property
    def timed(self) -> bool:
        """False for one pose at rest, whose time, rates and powers say nothing."""
        return self.good > 1 or not self.statics

    @property
    def whole(self) -> bool:
        """True if the run ended and every requested sample is good, or an event stopped it as requested."""
        return self.state == "finished" and self.status.ok and (self.good == self.samples or self.status is Status.EVENT)


def load(path: str | Path) -> RunResult:
    """Open a run folder; arrays are read when they are used.

    Raises
    ------
    StoreError : no run folder, a damaged one, or one without a single good sample.
    """
    folder = Path(path)
    store = open_store(folder)
    if "motion" not in store.groups:
        raise StoreError(f"{folder} has no good sample yet ({_state(store)}). Run it again with --overwrite.")
    return from_store(store)


def from_store(store: Store) -> RunResult:
    """The record of an opened store."""
    ledger = store.ledger
    status, message = _ending(store)
    common: dict[str, Any] = {"status": status, "message": message, "provenance": dict(ledger.provenance)}
    origin = model_of(store)
    model = conditioned(origin, origin.runs[ledger.run])[0]
    motion = Motion(data=_read(store, model, "motion").assign(_passed(store, model)), **common)
    forces: Mapping[str, Forces] = {case: _forces(store, model, case, motion, common) for case in _cases(store, "forces")}
    sections: Mapping[str, Sections] = {
        case: Sections(data=store.read(f"sections/{key(case)}"), **common) for case in _cases(store, "sections")
    }
    demand: Mapping[str, Demand] = {
        case: Demand(data=store.read(f"demand/{key(case)}"), **common) for case in _cases(store, "demand")
    }
    if ledger.options.get("derived"):
        forces, sections, demand = derived(model, motion, forces, int(ledger.options["stations"]))
    return RunResult(
        model=model,
        given=origin,
        name=ledger.run,
        motion=motion,
        forces=forces,
        sections=sections,
        demand=demand,
        verdict=Verdict(data=store.read("verdict"), **common) if "verdict" in store.groups else None,
        statics={
            case: Result(data=_read(store, model, f"statics/{key(case)}", motion), **common)
            for case in _cases(store, "statics")
        },
        simulation=_simulation(store, origin.runs[ledger.run].events, motion, forces, common),
        samples=ledger.samples,
        path=store.path,
        state=_state(store),
        wall_time=ledger.wall_time,
        settings=dict(ledger.options.get("settings", {})),
        **common | {"message": ledger.message},
    )


def model_of(store: Store) -> Model:
    """The model of a run.

    Raises
    ------
    StoreError : its file is damaged.
    """
    try:
        if '"director":' in store.model_text:  # of an earlier version
            return Model.model_validate(without_inner_parts(json.loads(store.model_text)))
        return Model.model_validate_json(store.model_text)
    except ValueError as error:
        raise StoreError(f"{store.path} is damaged: model.json holds no model. Run it again with --overwrite.") from error


def _ending(store: Store) -> tuple[Status, str]:
    """Status of a run, also for its parts. If the run did not end, the message says how far it came, so that no part looks
    complete by itself.
    """
    ledger, state = store.ledger, _state(store)
    if state == "finished":
        return Status[ledger.status], ledger.message
    count = f"{ledger.committed} of {ledger.samples} samples are good."
    return Status.RUNNING if state == "running" else Status.INTERRUPTED, " ".join(filter(None, [count, ledger.message]))


def _read(store: Store, model: Model, group: str, motion: Motion | None = None) -> xr.Dataset:
    """A dataset over the parts of a model, which may have inner ones."""
    data = store.read(group, whole=True)
    if not model.whole.inner.nodes:
        return data
    return marked(compile(model), data, data["position"] if motion is None else motion.whole["position"])


def _passed(store: Store, model: Model) -> dict[str, Column]:
    """The states between the samples of a run that has not ended; they are in its state."""
    if store.ledger.state == "finished":
        return {}
    with suppress(StoreError):  # a damaged state is reported when the run is resumed
        if "passed_t" in (state := store.state() or {}):
            return Passed(*(state[f"passed_{name}"] for name in ("t", "x", "v"))).variables(compile(model))
    return {}


def _forces(store: Store, model: Model, case: str, motion: Motion, common: dict[str, Any]) -> Forces:
    static, place = None, f"forces/{key(case)}"
    if f"{place}/static" in store.groups:
        static = Forces(data=_read(store, model, f"{place}/static", motion), motion=motion, load_case=case, **common)
    return Forces(data=_read(store, model, f"{place}/total", motion), motion=motion, static=static, load_case=case, **common)


def _simulation(
    store: Store, events: Mapping[str, Event], motion: Motion, forces: Mapping[str, Forces], common: dict[str, Any]
) -> Simulation | None:
    if "simulation" not in store.groups or not forces:
        return None
    data = store.read("simulation")
    if store.ledger.state != "finished":
        with suppress(StoreError):  # events are in the state; a damaged state is reported when the run is resumed
            state = store.state() or {}
            if "event_names" in state and "event_units" not in state:  # written by a version before the units of events
                state |= {"event_units": np.array([events[str(name)].unit for name in state["event_names"]], str)}
            data = data.assign(happened(state))
    return Simulation(data=data, motion=motion, forces=next(iter(forces.values())), **common)


def _cases(store: Store, kind: str) -> list[str]:
    """Load cases of one kind of result, in the order of the run."""
    found = {name.split("/")[1] for name in store.groups if name.startswith(kind + "/")}
    return [case for case in store.ledger.options.get("load_cases", []) if key(case) in found]


def _state(store: Store) -> str:
    if store.ledger.state == "finished":
        return "finished"
    return "running" if is_locked(store.path) else "incomplete"
