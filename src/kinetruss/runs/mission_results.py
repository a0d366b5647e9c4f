"""The pairs of a mission, its result, and reading it from its folder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import xarray as xr

from kinetruss.display import counted
from kinetruss.display.ranks import place_of_largest
from kinetruss.errors import InputError, StoreError
from kinetruss.model import Model, Run
from kinetruss.model.load_cases import acting_cases
from kinetruss.model.runs import MISSION
from kinetruss.model.table import ReadOnly
from kinetruss.results import Motion, Status, variable
from kinetruss.results.lock import is_locked
from kinetruss.results.store import Store, open_store
from kinetruss.runs.mission_drives import DriveEnvelope, drives_of, train_rows
from kinetruss.runs.quantity_limits import unchecked_rows
from kinetruss.runs.results import RunResult, from_store, load as load_run, model_of
from kinetruss.strength.envelopes import Gathering, extremes_of, verdict_of
from kinetruss.strength.findings import Finding, find

GOVERNING = "pair"
"""Start of the name that a pair has as a run of its own."""

EARLY = "Ends early: "
"""Start of the finding of a pair whose motion does not reach its end."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A motion under a condition and a load case; None: the model as it is, and all loads."""

    number: int
    motion: str
    condition: str | None
    load_case: str | None

    @property
    def label(self) -> str:
        """What people read: motion, condition, load case."""
        return ", ".join(one for one in (self.motion, self.condition, self.load_case) if one)

    def run_of(self, model: Model, mission: Run) -> Run:
        """The pair as a run of its own."""
        cases = None if self.load_case is None else (self.load_case,)
        if self.motion in model.runs:
            return model.runs[self.motion].with_(condition=self.condition, load_cases=cases)
        run = Run(trajectory=self.motion, samples=mission.samples, stations=mission.stations)
        return run.with_(condition=self.condition, load_cases=cases)

    def alone(self, model: Model, mission: Run) -> tuple[Model, str]:
        """A model with the pair as a run, and the name of that run."""
        name = f"{GOVERNING}{self.number + 1}"
        while name in model.runs:
            name += "_"
        run = self.run_of(model, mission)
        if run.analysis == "kinematics.follow":
            run = run.with_(analysis="dynamics.inverse")
        return model.with_(runs={**model.runs, name: run}), name


def pairs_of(model: Model, name: str) -> list[Pair]:
    """All pairs of a mission, motion by motion, then condition by condition.

    Raises
    ------
    InputError : the run is no mission.
    """
    mission = model.runs[name]
    if not mission.motions:
        raise InputError(f"Run {name!r} is no mission. Give it analysis: mission and motions.")
    conditions: tuple[str | None, ...] = mission.conditions or (None,)
    found: list[Pair] = []
    for motion in mission.motions:
        own = model.runs[motion].load_cases if motion in model.runs else None
        cases: tuple[str | None, ...] = acting_cases(model, mission.load_cases or own)
        for condition in conditions:
            for case in cases:
                found.append(Pair(len(found), motion, condition, case))
    return found


# The result of a mission, and reading it from its folder.

RULES = ("", "", "", "yield", "buckling", "beam-column")
NUMBERS = ("utilisation", "subject", "rule", "time", "samples")
NOTHING = Motion(data=xr.Dataset(coords={"time": variable(("time",), np.zeros(0), "s", "time")}))
"""A mission has no motion of its own."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MissionRun(RunResult):
    """The envelope of a mission.

    pairs : over pair: ``label`` (motion, condition, load case), ``utilisation`` (highest), its ``part``, ``rule`` and ``time``,
        ``samples``, and ``finding``: why the pair cannot be, or what to know of it.
    verdict : of all pairs; ``load_case`` is the label of the governing one, ``pair`` its number.
    extremes : over (part, quantity): tension, compression, bending.
    drives : over (drive, quantity): largest force, rate, power, rms force, energy given, holding force.
    trains : over (active, quantity), or None.
    """

    pairs: xr.Dataset = field(default_factory=xr.Dataset)
    extremes: xr.Dataset = field(default_factory=xr.Dataset)
    drives: xr.Dataset = field(default_factory=xr.Dataset)
    trains: xr.Dataset | None = None

    counts: ClassVar[str] = "pairs"
    holds: ClassVar[tuple[str, ...]] = ("verdict",)

    @cached_property
    def finding(self) -> Finding:
        """What the mission says of all its pairs."""
        drives = [] if self.trains is None else train_rows(self.trains)
        lacking = unchecked_rows(self.model, "a mission has no histories; take the run of a pair (runs.governing)")
        return find(self.verdict, drives, partial=self.partial, doubts=self.doubts, quantities=lacking)

    @property
    def partial(self) -> str:
        """Why the envelope does not hold all that was asked for: pairs that are not done, cannot be, or end early."""
        lost = int((self.pairs["samples"].values == 0).sum())
        early = sum(text.startswith(EARLY) for text in self.findings.values())
        short = [
            f"{k} of {counted(self.samples, 'pair')} {what}" for k, what in ((lost, "cannot be"), (early, "end early")) if k
        ]
        return super().partial or ", ".join(short)

    @property
    def doubts(self) -> tuple[str, ...]:
        """What to know of the pairs, each sentence once."""
        found: dict[str, list[str]] = {}
        for label, words in self.findings.items():
            found.setdefault(words, []).append(label)
        return tuple(
            f"{'all pairs' if len(labels) == self.good > 1 else '; '.join(labels)}: {words}" for words, labels in found.items()
        )

    @property
    def good(self) -> int:
        """Number of pairs that are done."""
        return int(self.pairs.sizes["pair"])

    @property
    def findings(self) -> dict[str, str]:
        """Label of a pair -> why it cannot be, or what to know of it."""
        labels, texts = (self.pairs[name].values.astype(str).tolist() for name in ("label", "finding"))
        return ReadOnly({label: text for label, text in zip(labels, texts, strict=True) if text})

    @property
    def governing(self) -> int | None:
        """Number of the pair with the highest utilisation; None where nothing was checked."""
        values = self.pairs["utilisation"].values
        return None if not len(values) or np.isnan(values).all() else place_of_largest(values)


class Envelope:
    """What is kept while pairs pass: it does not grow with the samples, and by one row a pair."""

    def __init__(self, model: Model, name: str) -> None:
        self.model, self.name, self.pairs = model, name, pairs_of(model, name)
        self.members, self.drives = Gathering(model), DriveEnvelope(model)
        self.rows: list[tuple[float, ...]] = []
        self.findings: list[str] = []

    def arrays(self) -> dict[str, Any]:
        """All of it as plain arrays."""
        return {
            "rods": self.members.rods,
            "members": self.members.members,
            "beams": self.members.beams,
            "drives": self.drives.drives,
            "trains": self.drives.trains,
            "rows": np.array(self.rows, float).reshape(len(self.rows), len(NUMBERS)),
            "findings": np.array(self.findings, dtype=object).astype(str),
        }

    def restore(self, arrays: Mapping[str, Any]) -> None:
        """The same from its arrays."""
        self.members.rods, self.members.members = np.array(arrays["rods"]), np.array(arrays["members"])
        if "beams" in arrays:
            kept = np.array(arrays["beams"])  # of earlier versions without the last quantities
            self.members.beams[: len(kept)] = kept
        self.drives.drives, self.drives.trains = np.array(arrays["drives"]), np.array(arrays["trains"])
        self.rows = [tuple(row) for row in np.asarray(arrays["rows"]).tolist()]
        self.findings = [str(text) for text in arrays["findings"]]

    def dataset(self) -> xr.Dataset:
        """The same as a dataset."""
        dims = {
            "rods": ("measure", "rod", "column"),
            "members": ("rule", "whole", "column"),
            "beams": ("of_beam", "beam", "column"),
            "drives": ("drive", "quantity", "of_drive"),
            "trains": ("active", "of_train", "of_drive"),
            "rows": ("pair", "number"),
            "findings": ("pair",),
        }
        return xr.Dataset({name: (dims[name], values) for name, values in self.arrays().items()})

    def table(self) -> xr.Dataset:
        """The pairs that are done."""
        done: list[Pair] = self.pairs[: len(self.rows)]
        rows = np.array(self.rows, float).reshape(len(done), len(NUMBERS))
        parts, members = list(self.members.part_names), list(self.members.member_names)
        subject = [_subject(row, parts, members) for row in self.rows]

        def text(values: list[str], words: str) -> Any:
            return variable(("pair",), np.array(values, dtype=object).astype(str), "", words)

        data = {
            "label": text([one.label for one in done], "motion, condition, load case"),
            "utilisation": variable(("pair",), rows[:, 0], "", "highest utilisation of the pair"),
            "part": text(subject, "where it is reached"),
            "rule": text([RULES[int(row[2])] if row[0] >= 0 else "" for row in self.rows], "by which rule"),
            "time": variable(("pair",), rows[:, 3], "s", "when, in the motion of the pair"),
            "samples": variable(("pair",), rows[:, 4], "", "good samples"),
            "finding": text(self.findings, "why it cannot be, or what to know of it"),
        }
        for name in ("motion", "condition", "load_case"):
            data[name] = text([getattr(one, name) or "" for one in done], name.replace("_", " "))
        return xr.Dataset(data, coords={"pair": np.arange(len(done))}, attrs={"kind": "pairs"})


def _subject(row: tuple[float, ...], parts: list[str], members: list[str]) -> str:
    if not row[0] >= 0:
        return ""
    return (parts if int(row[2]) == 3 else members)[int(row[1])]


def check_histories(run: RunResult) -> None:
    """Refuse a run without histories to show: a mission, and a run without a good sample."""
    name = run.path or run.name
    if isinstance(run, MissionRun):
        raise InputError(f"{name} is a mission: it has an envelope, and no histories. Take the run of a pair (runs.governing).")
    if not run.good:
        raise InputError(f"{name} has no good sample to show.")


def mission_of(found: Envelope, **others: Any) -> MissionRun:
    """The record of what was gathered."""
    labels = [one.label for one in found.pairs]
    model = found.model
    tables = drives_of(model, found.drives, labels)
    return MissionRun(
        model=model,
        name=found.name,
        motion=NOTHING,
        verdict=verdict_of(model, found.members, labels, [one.load_case or "all" for one in found.pairs]),
        pairs=found.table(),
        extremes=extremes_of(model, found.members, labels),
        drives=tables["drives"],
        trains=tables.get("trains"),
        samples=len(found.pairs),
        **others,
    )


def mission_from_store(store: Store) -> MissionRun:
    """The record of an opened store; of a mission that has not ended, of the pairs so far."""
    ledger = store.ledger
    found = Envelope(model_of(store), ledger.run)
    if ledger.state == "finished":
        data = store.read("envelope")
        found.restore({str(name): data[name].values for name in data.data_vars})
        state, status = "finished", Status[ledger.status]
    else:
        if arrays := store.state():
            found.restore(arrays)
        state = "running" if is_locked(store.path) else "incomplete"
        status = Status.RUNNING if state == "running" else Status.INTERRUPTED
    return mission_of(
        found,
        status=status,
        message=ledger.message,
        state=state,
        path=store.path,
        provenance=dict(ledger.provenance),
        wall_time=ledger.wall_time,
        settings=dict(ledger.options.get("settings", {})),
    )


def load(path: str | Path) -> RunResult:
    """Open a run folder; arrays are read when they are used. Of a mission, a `MissionRun`.

    Raises
    ------
    StoreError : no run folder, a damaged one, or one without a single good sample.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = kt.run(model, out=f"{folder}/turn")
    ...     kt.runs.load(f"{folder}/turn").status.name
    'COMPLETED'
    """
    store = open_store(Path(path))
    if store.ledger.options.get("analysis") != MISSION:
        return from_store(store) if "motion" in store.groups else load_run(path)
    if not store.ledger.committed:
        raise StoreError(f"{path} has no pair that is done yet. Continue with: kinetruss run --resume {path}")
    return mission_from_store(store)
