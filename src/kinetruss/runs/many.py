"""One run of many variants of a model, in parallel processes, each in its own folder."""

from __future__ import annotations

import ctypes
import gc
import itertools
import math
import multiprocessing
import os
import re
import signal
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from kinetruss.errors import InputError, ModelError
from kinetruss.io import MAX_SIZE, read, set_values
from kinetruss.io.values import given
from kinetruss.limits import MOST_VARIANTS, hold
from kinetruss.model import Model
from kinetruss.results import Status
from kinetruss.results.folder import check_target, clear, is_store, read_ledger
from kinetruss.results.lock import check_unlocked, holding
from kinetruss.results.packed import pack
from kinetruss.results.store import key
from kinetruss.results.wide_tables import NOT_CHECKED, most_used
from kinetruss.runs.blocks import blocks
from kinetruss.runs.instants import DERIVED
from kinetruss.runs.joining import notes_of
from kinetruss.runs.plans import SIMULATED, Block, Plan, plan
from kinetruss.runs.results import RunResult, load
from kinetruss.runs.running import ledger_of, run

T = TypeVar("T")
LEAST = 4
"""Smallest number of tasks for which processes are started."""
PARENT_DEATH = 1
"""The constant PR_SET_PDEATHSIG of prctl(2)."""


def processors() -> int:
    """Number of processors of this process; 1 if the system cannot fork a process with its loaded data."""
    if not sys.platform.startswith("linux"):
        return 1
    return len(os.sched_getaffinity(0))


def beside(work: Callable[[int], T], pieces: Sequence[int], workers: int | None = None) -> Iterator[tuple[int, T]]:
    """Yields (k, ``work(k)``) for each task k as it is done; by forked copies of this process if there are several processors.

    The copies already have all data in memory: compiled kernels are not loaded again. Tasks of a copy that dies are done in
    this process. Errors of the package are raised in this process too.
    """
    count = min(processors() if workers is None else workers, len(pieces))
    left = dict.fromkeys(pieces)
    if count > 1 and len(pieces) >= LEAST:
        for k, found in _gathered(work, pieces, count):
            del left[k]
            yield k, found
    for k in left:
        yield k, work(k)


def _gathered(work: Callable[[int], T], pieces: Sequence[int], count: int) -> Iterator[tuple[int, T]]:
    """The results of the copies; those of a copy that died are missing."""
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("fork"), _begin, (work, os.getpid()))
    try:
        with warnings.catch_warnings():
            # other threads (of a progress bar, of linear algebra) are not copied, and the copies do not need them
            warnings.simplefilter("ignore", DeprecationWarning)
            asked = {pool.submit(_piece, k): k for k in pieces}
        for future in as_completed(asked):
            if not isinstance(future.exception(), BrokenProcessPool):
                yield asked[future], future.result()
    except BaseException:
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()  # their results are no longer needed
        raise
    finally:
        pool.shutdown(cancel_futures=True)


_mine: list[Callable[[int], Any]] = []
"""The work of a copy, set in the copy."""


def _begin(work: Callable[[int], Any], parent: int) -> None:
    """Start of a copy. It ends silently with its parent, and after Ctrl-C."""
    gc.freeze()  # exclude inherited objects from garbage collection, which would copy their memory pages
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PARENT_DEATH, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    _mine[:] = [work]


def _piece(k: int) -> Any:
    return _mine[0](k)


# Variants of a model: all combinations of values, set by path.

Settings = Mapping[str, Sequence[Any]]

LONGEST = 100
"""Largest number of characters in a variant's name, which is the name of a folder."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One combination of values. name : also the name of its folder. settings : path -> value as text."""

    name: str
    settings: Mapping[str, str]
    model: Model


def variants(model: Model | str | Path, settings: Settings) -> dict[str, Model]:
    """All combinations of values for some settings, each as a model.

    Parameters
    ----------
    model : a model, or a model file. ``library.NAME``, a parameter of the library model in a file, can be set only for a
    file: a model does not store the parameters from which it was built.
    settings : dotted path -> values, as for `io.set_value`, e.g. ``{"runs.extend.trajectory.duration": [3, "5 s"]}``.

    Returns
    -------
    Name -> model, the last path varying fastest. A name has the values of the paths with several values, e.g.
    ``duration=3_payload_mass=10kg``; each path is shortened to its shortest unique end.

    Raises
    ------
    ModelError : an unknown path (the message offers the nearest names); a value that does not fit, with its fix.
    InputError : a path without values, or a value given twice.

    Examples
    --------
    >>> import kinetruss as kt
    >>> found = variants(kt.library.vgt.triangular(), {"nodes.B.mass": ["10 kg", "40 kg"], "gravity": ["~"]})
    >>> [(name, one.nodes["B"].mass, one.gravity) for name, one in found.items()]
    [('mass=10kg', 10.0, None), ('mass=40kg', 40.0, None)]
    """
    return {variant.name: variant.model for variant in spread(model, settings)}


def spread(model: Model | str | Path, settings: Settings, max_size: int = MAX_SIZE) -> list[Variant]:
    """The combinations of `variants`, with the values set in each."""
    for path, values in settings.items():
        if isinstance(values, str) or not len(values):
            raise InputError(f"{path} has no list of values. Give for example {path}=3,5,10.")
        if len(set(map(str, values))) < len(values):
            raise InputError(f"{path} has a value twice: {', '.join(map(str, values))}. Leave one out.")
    count = math.prod(len(values) for values in settings.values())
    hold(count, "This grid of settings", "Give fewer values.", most=MOST_VARIANTS, of="variants")
    base = _Base(model, max_size)
    chosen = [dict(zip(settings, values, strict=True)) for values in itertools.product(*settings.values())]
    names = _names(settings, chosen)
    return [
        Variant(name=name, settings={path: str(value) for path, value in values.items()}, model=base.with_(values))
        for name, values in zip(names, chosen, strict=True)
    ]


class _Base:
    """The base of the variants; each set of library parameters is built once."""

    def __init__(self, model: Model | str | Path, max_size: int) -> None:
        self._file = None if isinstance(model, Model) else Path(model)
        self._max_size = max_size
        # report faults of the file itself before anything is set
        self._built: dict[tuple[str, ...], Model] = {(): model if isinstance(model, Model) else read(model, max_size=max_size)}

    def with_(self, values: Mapping[str, Any]) -> Model:
        """The model with these values."""
        try:
            return self._changed(values)
        except ModelError as error:
            raise _blamed(error, values, self._changed) from None

    def _changed(self, values: Mapping[str, Any]) -> Model:
        own = {path: value for path, value in values.items() if not path.startswith("library.")}
        parameters = {path.removeprefix("library."): value for path, value in values.items() if path not in own}
        if parameters and self._file is None:
            raise InputError(f"library.{next(iter(parameters))} can be set only for a model file, not for a model.")
        key = tuple(map(str, itertools.chain(*parameters.items())))
        if key not in self._built:
            library = {name: given(value) for name, value in parameters.items()}
            self._built[key] = read(self._file or "", max_size=self._max_size, library=library)
        base = self._built[key]
        return set_values(base, own) if own else base


def _blamed(error: ModelError, values: Mapping[str, Any], change: Any) -> ModelError:
    """The faults, assigned to the setting that causes them by itself, or to all settings."""
    for path, value in values.items():
        try:
            change({path: value})
        except ModelError as alone:
            return _with_setting(alone, f"{path}={value}")
    return _with_setting(error, ", ".join(f"{path}={value}" for path, value in values.items()))


def _with_setting(error: ModelError, setting: str) -> ModelError:
    # no position in the file: the file has another value there
    return ModelError([replace(fault, line=None, column=None, file=None) for fault in error.faults], setting)


def _names(settings: Settings, chosen: Sequence[Mapping[str, Any]]) -> list[str]:
    """A name for each combination: valid as a folder, and unique also on file systems that ignore case."""
    several = [path for path, values in settings.items() if len(values) > 1] or list(settings)
    keys = short_paths(several)
    found: list[str] = []
    taken: set[str] = set()
    for values in chosen:
        name = stem = "_".join(f"{_safe(keys[path])}={_safe(str(values[path]))}" for path in several)[:LONGEST]
        count = 1
        while name.casefold() in taken:
            count += 1
            name = f"{stem}~{count}"
        taken.add(name.casefold())
        found.append(name)
    return found


def short_paths(paths: Sequence[str]) -> dict[str, str]:
    """For each path its shortest end that is not only a number and that no other path has.

    >>> short_paths(["nodes.B.mass", "nodes.C.mass", "runs.a.trajectory.duration", "nodes.B.at.0"])
    {'nodes.B.mass': 'B.mass', 'nodes.C.mass': 'C.mass', 'runs.a.trajectory.duration': 'duration', 'nodes.B.at.0': 'at.0'}
    """
    found = {}
    for path in paths:
        parts = path.split(".")
        others = [other.split(".") for other in paths if other != path]
        for count in range(1, len(parts) + 1):
            end = parts[-count:]
            if not end[0].isdecimal() and all(other[-count:] != end for other in others):
                break
        found[path] = ".".join(end)
    return found


def _safe(text: str) -> str:
    """A text as part of a folder name: letters, digits, signs, dots, commas; no special character of a shell or file system."""
    return re.sub(r"[^\w.,+-]+", "-", re.sub(r"\s+", "", text).strip("[]{}~")).rstrip("-.") or "none"


# One run of many variants of a model, each in its own folder.

Progress = Callable[[int, int], None]


@dataclass(frozen=True, kw_only=True, eq=False)
class VariantRuns(Mapping[str, RunResult]):
    """Runs by the name of their variant; those in folders are opened on first access.

    settings : name -> the values that were set, by path. refused : name -> why there is no run.
    status : name -> how its run ended; whole : name -> True if every requested sample is good.
    worst : name -> part, rule, utilisation and time of the highest utilisation (None: nothing was checked).
    paths : name -> folder; empty if the runs were not written.
    """

    settings: Mapping[str, Mapping[str, str]]
    refused: Mapping[str, str]
    status: Mapping[str, Status]
    whole: Mapping[str, bool]
    worst: Mapping[str, tuple[str, str, float, float] | None]
    paths: Mapping[str, Path]
    kept: Mapping[str, RunResult] = field(default_factory=dict, repr=False)

    def __getitem__(self, name: str) -> RunResult:
        return load(self.paths[name]) if name in self.paths else self.kept[name]

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
    paths = [None] * len(found) if target is None else _paths(target, found)
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
            return replace(_done(result.status, result.whole, result.verdict), kept=result)
        if job.run.analysis == SIMULATED:
            from kinetruss.runs.instants import stepper_of

            stepper_of(job)  # a refusal comes before anything in the folder is touched
            self._remove_old(path)
            result = run(variant.model, job.name, path, overwrite=self.overwrite, settings=variant.settings)
            return _done(result.status, result.whole, result.verdict)
        started = time.perf_counter()
        computed = blocks(self._shared(job))
        first = next(computed)  # a refusal comes before anything in the folder is touched
        self._remove_old(path)
        if len(job.times) > job.block:
            result = run(variant.model, job.name, path, overwrite=self.overwrite, settings=variant.settings)
            return _done(result.status, result.whole, result.verdict)
        status = first.motion.status
        ledger = ledger_of(job, variant.settings)
        ledger = replace(
            ledger,
            committed=int(first.motion.data.sizes["time"]),
            state="finished",
            status=status.name,
            message=" ".join(notes_of(first)),
            options={**ledger.options, "derived": DERIVED},
            wall_time=time.perf_counter() - started,
        )
        pack(path, ledger, variant.model.model_dump_json(), _datasets(first), overwrite=self.overwrite)
        return _done(status, status.ok and ledger.whole, first.verdict)

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
        for old in [self.target] if is_store(self.target) else _held(self.target):
            with nullcontext() if old == self.target else holding(old):
                clear(old)
            if old not in (self.target, path):
                with suppress(OSError):  # keep other files in it
                    old.rmdir()


def _done(status: Status, whole: bool, verdict: Any) -> _Done:
    return _Done(status=status, whole=whole, worst=None if verdict is None else _worst(verdict.data))


def _variant_runs(done: Sequence[_Done], found: Sequence[Variant], paths: Sequence[Path | None]) -> VariantRuns:
    good = [(one, variant.name, path) for one, variant, path in zip(done, found, paths, strict=True) if not one.refused]
    return VariantRuns(
        settings={variant.name: variant.settings for variant in found},
        refused={variant.name: one.refused for one, variant in zip(done, found, strict=True) if one.refused},
        status={name: one.status for one, name, _ in good},
        whole={name: one.whole for one, name, _ in good},
        worst={name: one.worst for one, name, _ in good},
        paths={name: path for _, name, path in good if path is not None},
        kept={name: one.kept for one, name, _ in good if one.kept is not None},
    )


def _datasets(block: Block) -> dict[str, Any]:
    """The stored datasets of a run of one block, by path in the store."""
    found = {"motion": block.motion.data}
    found |= {f"forces/{key(case)}/total": forces.data for case, forces in block.forces.items()}
    return found if block.verdict is None else found | {"verdict": block.verdict.data}


def _worst(data: Any) -> tuple[str, str, float, float] | None:
    """Part, rule, utilisation and time of the highest utilisation."""
    values = data["utilisation"].values
    if np.isnan(values).all():
        return None
    value = max(map(most_used, values.tolist()), key=lambda one: -1.0 if math.isnan(one) else one)
    i, j = (int(k[0]) for k in np.nonzero(values == value))
    if value == 0 and any(str(note).startswith(NOT_CHECKED) for note in data["note"].values.flat):
        return None  # no checked entry has a demand, and some entries were not checked
    return str(data["part"].values[i]), str(data["rule"].values[j]), float(value), float(data["time_of"].values[i, j])


def _paths(target: Path, found: Sequence[Variant]) -> list[Path | None]:
    return [target] if len(found) == 1 else [target / variant.name for variant in found]


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
    if paths == [target] or not _held(target):
        check_target(target, overwrite)
        return
    if not overwrite:
        raise InputError(f"{target} holds runs already. Name another folder, or replace them: --overwrite (overwrite=True).")
    for path in {*paths, *_held(target)}:
        check_unlocked(path)
        check_target(path, overwrite)


def _held(target: Path) -> list[Path]:
    """Variants of an earlier command in a folder."""
    if is_store(target) or not target.is_dir():
        return []
    return [path for path in sorted(target.iterdir()) if is_store(path) and read_ledger(path)["options"].get("settings")]
