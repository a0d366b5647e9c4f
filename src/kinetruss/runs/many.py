"""One run of many variants of a model, in parallel processes, each in its own folder."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.io import MAX_SIZE
from kinetruss.model import Model
from kinetruss.model.table import missing, read_only
from kinetruss.results import Row, Status
from kinetruss.results.folder import check_target, clear, is_store, read_ledger
from kinetruss.results.lock import check_unlocked, holding
from kinetruss.results.store import key, store_whole
from kinetruss.runs.blocks import blocks
from kinetruss.runs.instants import DERIVED
from kinetruss.runs.joining import notes_of
from kinetruss.runs.plans import SIMULATED, Block, Plan, plan
from kinetruss.runs.processes import beside
from kinetruss.runs.results import RunResult, load
from kinetruss.runs.running import ledger_of, run
from kinetruss.runs.variant_sets import Settings, Variant, spread
from kinetruss.strength.findings import demands, find
from kinetruss.strength.verdict import highest

Progress = Callable[[int, int], None]


@dataclass(frozen=True, kw_only=True, eq=False)
class VariantRuns(Mapping[str, RunResult]):
    """Runs by the name of their variant; those in folders are opened on first access.

    settings : name -> the values that were set, by path. refused : name -> why there is no run.
    status : name -> how its run ended; whole : name -> True if every requested sample is good.
    worst : name -> part, rule, utilisation and time of the highest utilisation (None: nothing was checked).
    said : name -> the verdict of its run in words, of members and drives (`RunResult.finding`).
    paths : name -> folder; empty if the runs were not written.
    """

    settings: Mapping[str, Mapping[str, str]]
    refused: Mapping[str, str]
    status: Mapping[str, Status]
    whole: Mapping[str, bool]
    worst: Mapping[str, tuple[str, str, float, float] | None]
    paths: Mapping[str, Path]
    kept: Mapping[str, RunResult] = field(default_factory=dict, repr=False)
    said: Mapping[str, str] = field(default_factory=dict)

    def __getitem__(self, name: str) -> RunResult:
        if name not in self.status:
            raise missing(name, self.status)
        return load(self.paths[name]) if name in self.paths else self.kept[name]

    def __post_init__(self) -> None:
        read_only(self)

    def __iter__(self) -> Iterator[str]:
        return iter(self.status)

    def __len__(self) -> int:
        return len(self.status)


def run_variants(
    model: Model | str | Path,
    settings: Settings,
    name: str | None = None,
    out: str | Path | None = None,
    *,
    overwrite: bool = False,
    progress: Progress | None = None,
    max_size: int = MAX_SIZE,
) -> VariantRuns:
    """Do a named run of all combinations of some settings.

    Parameters
    ----------
    model, settings : as for `variants`. name : a run of the model; may be omitted if there is only one.
    out : folder; each variant becomes a run folder in it, or the folder itself if there is only one combination.
        None keeps everything in memory.
    overwrite : replace the run, or the variants, in `out`.
    progress : called with (variants done, variants) after each.
    max_size : largest size of a model file, bytes.

    Returns
    -------
    VariantRuns. A path that ends early raises no exception (see `run`). A variant that cannot be computed, e.g. with lengths
    out of reach, is in ``refused`` if others can be computed.

    Raises
    ------
    ModelError, InputError : see `variants`; no such run; an output folder that would lose data. Nothing was computed.
    InputError : no variant can be computed. StoreError : a folder cannot be written, or another process writes it.

    Notes
    -----
    On Linux, variants that are written are computed on all processors in parallel. A short run (one block) is stored in one
    file, without results that follow from its motion and forces (the same poses at rest, section forces, motor demands):
    these are computed on first access.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> found = kt.runs.run_variants(model, {"nodes.C.mass": [0.5, 1.0]}, "turn")
    >>> {name: run.status.name for name, run in found.items()}
    {'mass=0.5': 'COMPLETED', 'mass=1.0': 'COMPLETED'}
    """
    found = spread(model, settings, max_size)
    jobs = [replace(plan(variant.model, name), full=False) for variant in found]
    target = None if out is None else Path(out)
    several = len(found) > 1
    paths = [None if target is None else target / one.name if several else target for one in found]
    work = _Work(found, jobs, paths, target, overwrite)
    done: dict[int, _Done] = {}
    with nullcontext() if target is None else _claimed(target, [path for path in paths if path is not None], overwrite):
        for k, one in _all(work, target is not None):
            done[k] = one
            if progress is not None:
                progress(len(done), len(found))
    return _variant_runs([done[k] for k in range(len(found))], found, paths)


def _all(work: _Work, written: bool) -> Iterator[tuple[int, _Done]]:
    """Do every variant. Old runs are removed after the first variant is computed; runs kept in memory are done in this
    process.
    """
    count = len(work.found)
    refused = None
    for k in range(count):
        try:
            one = work(k, raising=True)
        except InputError as error:
            refused = refused or error
            yield k, _Done(refused=str(error))
            continue
        yield k, one
        rest = range(k + 1, count)
        yield from beside(work, rest) if written else ((other, work(other)) for other in rest)
        return
    if refused is not None:
        raise refused


@dataclass(frozen=True, kw_only=True, eq=False)
class _Done:
    """The outcome of a variant, or the reason why it was not computed."""

    refused: str = ""
    status: Status = Status.COMPLETED
    whole: bool = False
    worst: tuple[str, str, float, float] | None = None
    said: str = ""
    kept: RunResult | None = None


class _Work:
    """Computes and stores variants by number."""

    def __init__(
        self, found: list[Variant], jobs: list[Plan], paths: Sequence[Path | None], target: Path | None, overwrite: bool
    ) -> None:
        self.found, self.jobs, self.paths, self.target, self.overwrite = found, jobs, paths, target, overwrite
        self._room = False
        self._last: Model | None = None

    def __call__(self, k: int, raising: bool = False) -> _Done:
        """Do one variant; an error of the variant is stored or raised."""
        try:
            return self._one(self.found[k], self.jobs[k], self.paths[k])
        except InputError as error:
            if raising:
                raise
            return _Done(refused=str(error))

    def _one(self, variant: Variant, job: Plan, path: Path | None) -> _Done:
        if path is None:
            result = run(variant.model, job.name, settings=variant.settings)
            return replace(_done(result), kept=result)
        if job.run.analysis == SIMULATED:
            from kinetruss.runs.simulated import stepper_of

            stepper_of(job)  # a refusal comes before anything in the folder is touched
            self._remove_old(path)
            result = run(variant.model, job.name, path, overwrite=self.overwrite, settings=variant.settings)
            return _done(result)
        started = time.perf_counter()
        computed = blocks(self._shared(job))
        first = next(computed)  # a refusal comes before anything in the folder is touched
        self._remove_old(path)
        if len(job.times) > job.block:
            result = run(variant.model, job.name, path, overwrite=self.overwrite, settings=variant.settings)
            return _done(result)
        status = first.motion.status
        ledger = ledger_of(job, variant.settings)
        ledger = replace(
            ledger,
            committed=int(first.motion.whole.sizes["time"]),
            state="finished",
            status=status.name,
            message=" ".join(notes_of(first)),
            options={**ledger.options, "derived": DERIVED},
            wall_time=time.perf_counter() - started,
        )
        store_whole(path, ledger, variant.model.model_dump_json(), _datasets(first), overwrite=self.overwrite)
        return _done(
            RunResult(
                model=job.model, given=variant.model, name=job.name, motion=first.motion, forces=first.forces, status=status,
                verdict=first.verdict, demand=first.demand, statics=first.statics, samples=ledger.samples,
            )
        )  # fmt: skip

    def _shared(self, job: Plan) -> Plan:
        """The same plan on the model of the previous variant, if they differ only in their motion.

        So the model is compiled only once; compiling takes as long as the forces of some hundred samples.
        """
        if job.condition is not None:
            return job
        moving: dict[str, Any] = {"runs": {}, "trajectories": {}, "title": ""}
        if self._last is None or self._last.with_(**moving) != job.model.with_(**moving):
            self._last = job.model
        return replace(job, model=self._last)

    def _remove_old(self, path: Path) -> None:
        """Remove the runs of an earlier command from the folders of the variants, after the first variant is computed."""
        if self._room or self.target in (None, path):
            return
        self._room = True
        for old in [self.target] if is_store(self.target) else _finished(self.target):
            with nullcontext() if old == self.target else holding(old):
                clear(old)
            if old not in (self.target, path):
                with suppress(OSError):  # keep other files in it
                    old.rmdir()


def _done(run: RunResult) -> _Done:
    done = _Done(status=run.status, whole=run.whole)
    if run.verdict is None and not run.demand:
        return done
    found = find(run.verdict, demands(run.demand), partial=run.partial)
    return replace(done, worst=_worst(found.members), said=found.text)


def _variant_runs(done: Sequence[_Done], found: Sequence[Variant], paths: Sequence[Path | None]) -> VariantRuns:
    good = [(one, variant.name, path) for one, variant, path in zip(done, found, paths, strict=True) if not one.refused]
    return VariantRuns(
        settings={variant.name: variant.settings for variant in found},
        refused={variant.name: one.refused for one, variant in zip(done, found, strict=True) if one.refused},
        status={name: one.status for one, name, _ in good},
        whole={name: one.whole for one, name, _ in good},
        worst={name: one.worst for one, name, _ in good},
        said={name: one.said for one, name, _ in good},
        paths={name: path for _, name, path in good if path is not None},
        kept={name: one.kept for one, name, _ in good if one.kept is not None},
    )


def _datasets(block: Block) -> dict[str, Any]:
    """The stored datasets of a run of one block, by path in the store."""
    found = {"motion": block.motion.whole}
    found |= {f"forces/{key(case)}/total": forces.whole for case, forces in block.forces.items()}
    return found if block.verdict is None else found | {"verdict": block.verdict.data}


def _worst(rows: Sequence[Row]) -> tuple[str, str, float, float] | None:
    """Part, rule, utilisation and time of the highest utilisation."""
    if math.isnan(highest(rows)):
        return None  # nothing was checked, or no checked entry has a demand and some entries were not checked
    return rows[0].part, rows[0].rule, rows[0].utilisation, rows[0].time


@contextmanager
def _claimed(target: Path, paths: Sequence[Path], overwrite: bool) -> Iterator[None]:
    """Lock the folder of several variants for this command; the folder of a single one is locked by its run.

    Raises
    ------
    InputError : it would lose data; the rules are those of a single run.
    StoreError : another process writes it, or a run in it; or it cannot be written.
    """
    check_unlocked(target)
    _check_target(target, paths, overwrite)
    if paths == [target]:
        yield
        return
    with holding(target):
        _check_target(target, paths, overwrite)  # another process may have been faster
        yield


def _check_target(target: Path, paths: Sequence[Path], overwrite: bool) -> None:
    if paths == [target] or not _finished(target):
        check_target(target, overwrite)
        return
    if not overwrite:
        raise InputError(f"{target} holds runs already. Name another folder, or replace them: --overwrite (overwrite=True).")
    for path in dict.fromkeys([*paths, *_finished(target)]):
        check_unlocked(path)
        check_target(path, overwrite)


def _finished(target: Path) -> list[Path]:
    """Variants of an earlier command in a folder."""
    if is_store(target) or not target.is_dir():
        return []
    return [path for path in sorted(target.iterdir()) if is_store(path) and read_ledger(path)["options"].get("settings")]
