"""Does the pairs of a mission one after another, keeps the envelope, and stores it after every pair."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.model import Model
from kinetruss.model.runs import MISSION
from kinetruss.results import Motion, Status, model_hash, provenance
from kinetruss.results.folder import Ledger, claimed
from kinetruss.results.lock import holding
from kinetruss.results.store import End, Writer, create, open_store, reopen
from kinetruss.runs.blocks import blocks
from kinetruss.runs.joining import concatenated, notes_of
from kinetruss.runs.mission_drives import PairDrives
from kinetruss.runs.mission_results import EARLY, Envelope, MissionRun, Pair, mission_of
from kinetruss.runs.plans import Block, Plan, plan
from kinetruss.runs.results import model_of

Progress = Callable[[int, int], None]
OWN = ("statics.at_poses", "statics.equilibrium", "dynamics.simulate")
"""Analyses that find their places or motion themselves; of all others the forces along the motion are taken."""
HELD = 4e6
"""Numbers of a motion that are kept for its other load cases and conditions; longer motions are followed again."""


def run_mission(
    model: Model,
    name: str,
    out: str | Path | None = None,
    *,
    overwrite: bool = False,
    progress: Progress | None = None,
    settings: Mapping[str, str] | None = None,
) -> MissionRun:
    """Do a mission; see `run`. A pair that cannot be is a finding, and the mission goes on.

    Raises
    ------
    InputError : an output folder that is not empty. StoreError : it cannot be written; pairs that are done stay.
    """
    started, found = time.perf_counter(), Envelope(model, name)
    if out is None:
        _stream(found, None, progress, started)
        return mission_of(
            found, wall_time=time.perf_counter() - started, provenance=provenance(model, run=name), **_ended(found)
        )
    path = Path(out)
    with claimed(path, overwrite) as held:
        options = {"analysis": MISSION, "stations": model.runs[name].stations, "load_cases": []}
        ledger = Ledger(
            run=name,
            samples=len(found.pairs),
            block=1,
            model_hash=model_hash(model),
            options=options | ({"settings": dict(settings)} if settings else {}),
            provenance=provenance(model, run=name),
        )
        writer = create(path, ledger, model.model_dump_json(), overwrite=overwrite, held=held)
        _stream(found, writer, progress, started)
    return _stored(found, writer, path)


def resume_mission(path: Path, *, progress: Progress | None = None) -> MissionRun:
    """Go on with a mission after its last pair that is done.

    Raises
    ------
    StoreError : another process is writing it, or its state is damaged.
    """
    started = time.perf_counter()
    with holding(path) as held:
        store = open_store(path)
        found = Envelope(model_of(store), store.ledger.run)
        if arrays := store.state():
            found.restore(arrays)
        writer = reopen(path, store.ledger, held)
        _stream(found, writer, progress, started - store.ledger.wall_time)
    return _stored(found, writer, path)


def _stored(found: Envelope, writer: Writer, path: Path) -> MissionRun:
    ledger = writer.ledger
    others = {"path": path, "wall_time": ledger.wall_time, "provenance": dict(ledger.provenance)}
    return mission_of(found, settings=dict(ledger.options.get("settings", {})), **others, **_ended(found))


def _ended(found: Envelope) -> dict[str, Any]:
    """Status and message of a mission."""
    lost = [k for k, row in enumerate(found.rows) if not row[4]]
    if not lost:
        return {"status": Status.COMPLETED, "message": ""}
    first = f"{found.pairs[lost[0]].label}: {found.findings[lost[0]]}"
    return {"status": Status.COMPLETED, "message": f"{len(lost)} of {len(found.pairs)} pairs cannot be. The first, {first}"}


def _stream(found: Envelope, writer: Writer | None, progress: Progress | None, started: float) -> None:
    """Do the pairs that are left."""
    try:
        for _ in _pairs(found):
            if writer is not None:
                data = xr.Dataset({"utilisation": (("time",), np.array([found.rows[-1][0]]))})
                writer.append({"pairs": data}, time.perf_counter() - started, found.arrays())
            if progress is not None:
                progress(len(found.rows), len(found.pairs))
        if writer is not None:
            ended = _ended(found)
            end = End(ended["status"].name, ended["message"], {"envelope": found.dataset()})
            writer.append({}, time.perf_counter() - started, end=end)
    except KeyboardInterrupt:
        if writer is not None:
            writer.pause(Status.INTERRUPTED.name, "", time.perf_counter() - started)
        raise
    finally:
        if writer is not None:
            writer.release()


def _pairs(found: Envelope) -> Iterator[Pair]:
    """Do one pair after another; each is in the envelope when it is yielded."""
    known = _Known(found)
    for pair in found.pairs[len(found.rows) :]:
        drives, samples, said = None, 0, ""
        found.members.begin()
        try:
            job = known.plan(pair)
            drives = PairDrives(job.model)
            for block in known.blocks(pair, job):
                ended = block.motion.status
                said = " ".join(notes_of(block) if ended.ok else filter(None, (EARLY + ended.value, block.motion.message)))
                for forces in block.forces.values():
                    samples += int(forces.arrays["time"].values.size)
                    found.members.add(job.model, forces, pair.number)
                    drives.add(forces)
        except (InputError, ModelError, AnalysisError) as error:
            said = str(error)
        if drives is not None and samples:
            found.drives.add(drives, pair.number)
        top, subject, rule, when = found.members.top
        utilisation = top if top >= 0 else math.nan
        found.rows.append((float(utilisation), float(subject), float(rule), float(when), float(samples)))
        found.findings.append(said)
        yield pair


class _Known:
    """Plans and motions that pairs share: one motion is followed once for all load cases, and for all conditions that leave
    it as it is.
    """

    def __init__(self, found: Envelope) -> None:
        mission, model = found.model.runs[found.name], found.model
        runs = {}
        for pair in found.pairs:
            run = pair.run_of(model, mission)
            analysis = run.analysis if run.analysis in OWN else "dynamics.inverse"
            runs[_key(pair)] = run.with_(analysis=analysis, load_cases=None)
        self._model = model.with_(runs=runs)  # one model, which is compiled once for all motions
        self._plan: tuple[str, Plan] | None = None
        self._motion: tuple[tuple[str, str | None], Motion] | None = None

    def plan(self, pair: Pair) -> Plan:
        """The plan of a pair: that of its motion and condition, with its load case."""
        if self._plan is None or self._plan[0] != _key(pair):
            self._plan = _key(pair), replace(plan(self._model, _key(pair)), full=False, bare=True)
        return replace(self._plan[1], cases=(pair.load_case,))

    def blocks(self, pair: Pair, job: Plan) -> Iterator[Block]:
        """Motion and forces, block by block."""
        if job.given is not None or job.run.trajectory is None:
            return blocks(job)
        same = job.condition is None or not job.condition.moves_otherwise
        key = (pair.motion, None if same else pair.condition)
        if self._motion is None or self._motion[0] != key:
            if len(job.times) * (9 * len(job.model.whole.nodes) + 3 * len(job.model.whole.members)) > HELD:
                return blocks(job)
            whole = replace(job, run=job.run.with_(analysis="kinematics.follow"))
            parts = [block.motion for block in blocks(whole)]
            motion = parts[-1].with_(data=concatenated([part.whole for part in parts])) if len(parts) > 1 else parts[0]
            if not motion.status.ok:
                return blocks(job)
            self._motion = key, motion
        return blocks(replace(job, given=self._motion[1]))


def _key(pair: Pair) -> str:
    """Name of the run of a motion under a condition."""
    return f"{pair.motion}:{pair.condition or ''}"
