"""The same run of many variants of a model, each in a folder of its own."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.io._text import MAX_SIZE
from kinetruss.model import Model
from kinetruss.results import Status
from kinetruss.results._folder import check_target, clear, is_store
from kinetruss.results._packed import pack
from kinetruss.results._store import key, open_store
from kinetruss.runs._blocks import Block, Plan, blocks, plan
from kinetruss.runs._join import notes_of
from kinetruss.runs._result import RunResult, load
from kinetruss.runs._run import ledger_of, run
from kinetruss.runs._variants import Settings, Variant, spread

__all__ = ["VariantRuns", "run_variants"]

Progress = Callable[[int, int], None]


@dataclass(frozen=True, kw_only=True, eq=False)
class VariantRuns(Mapping[str, RunResult]):
    """Runs by the name of their variant; those in folders are opened when they are asked for.

    settings : name -> what was set, path -> value. refused : name -> why there is no run of it.
    status : name -> how its run ended; whole : name -> whether every sample asked for is good.
    worst : name -> part, rule, utilisation and time of the highest utilisation (None: nothing was judged).
    paths : name -> folder; empty where the runs were not written.
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
    model, settings : as for `variants`. name : a run of the model; may be left out where there is only one.
    out : folder; each variant becomes a run folder in it, or the folder itself where there is only one combination.
        None keeps everything in memory.
    overwrite : replace the run, or the variants, in `out`.
    progress : called with (variants done, variants) after each.
    max_size : bytes, of a model file.

    Returns
    -------
    VariantRuns. A path that ends early is no exception (see `run`), nor is a variant that cannot be computed while others
    can, e.g. lengths out of reach: it is in ``refused``.

    Raises
    ------
    ModelError, InputError : see `variants`; no such run; an output folder that would lose something. Nothing was computed.
    InputError : no variant can be computed. StoreError : a folder cannot be written.

    Notes
    -----
    A short run (one block) is stored in one file, without its section forces, which are computed when they are asked for.
    """
    found = spread(model, settings, max_size)
    jobs = [replace(plan(variant.model, name), sections=False) for variant in found]
    target = None if out is None else Path(out)
    paths = [None] * len(found) if target is None else _paths(target, found)
    if target is not None:
        _check_target(target, [path for path in paths if path is not None], overwrite)
    gathered = _Gathered()
    for k, (variant, job, path) in enumerate(zip(found, jobs, paths, strict=True)):
        try:
            _one(gathered, variant, job, path, overwrite, target)
        except InputError as error:
            gathered.refused[variant.name] = str(error)
            if len(gathered.refused) == len(found):
                raise
        if progress is not None:
            progress(k + 1, len(found))
    return VariantRuns(settings={variant.name: variant.settings for variant in found}, **vars(gathered))


class _Gathered:
    """What is known of the variants done so far."""

    def __init__(self) -> None:
        self.refused: dict[str, str] = {}
        self.status: dict[str, Status] = {}
        self.whole: dict[str, bool] = {}
        self.worst: dict[str, tuple[str, str, float, float] | None] = {}
        self.paths: dict[str, Path] = {}
        self.kept: dict[str, RunResult] = {}

    def add(self, name: str, status: Status, whole: bool, verdict: Any, path: Path | None) -> None:
        """One more variant."""
        self.status[name], self.whole[name] = status, whole
        self.worst[name] = None if verdict is None else _worst(verdict.data)
        if path is not None:
            self.paths[name] = path


def _one(gathered: _Gathered, variant: Variant, job: Plan, path: Path | None, overwrite: bool, target: Path | None) -> None:
    """Compute and store one variant."""
    started = time.perf_counter()
    if path is None or len(job.times) > job.block:
        if path is not None and path != target:
            _make_room(gathered, path, target)
        result = run(variant.model, job.name, path, overwrite=overwrite, settings=variant.settings)
        gathered.add(variant.name, result.status, result.whole, result.verdict, path)
        if path is None:
            gathered.kept[variant.name] = result
        return
    block = next(blocks(job))
    if path != target:
        _make_room(gathered, path, target)
    status = block.motion.status
    ledger = replace(
        ledger_of(job, variant.settings), committed=int(block.motion.data.sizes["time"]), state="finished",
        status=status.name, message=" ".join(notes_of(block)), wall_time=time.perf_counter() - started,
    )  # fmt: skip
    options = {**ledger.options, "derived": ["sections"]}
    pack(path, replace(ledger, options=options), variant.model.model_dump_json(), _datasets(block), overwrite=overwrite)
    gathered.add(variant.name, status, status.ok and ledger.whole, block.verdict, path)


def _datasets(block: Block) -> dict[str, Any]:
    """Everything known of a run of one block, by its place in the store."""
    found = {"motion": block.motion.data}
    for case, forces in block.forces.items():
        found[f"forces/{key(case)}/total"] = forces.data
        if forces.static is not None:
            found[f"forces/{key(case)}/static"] = forces.static.data
    found |= {f"demand/{key(case)}": one.data for case, one in block.demand.items()}
    return found if block.verdict is None else found | {"verdict": block.verdict.data}


def _worst(data: Any) -> tuple[str, str, float, float] | None:
    """Part, rule, utilisation and time of the highest utilisation."""
    values = data["utilisation"].values
    if np.isnan(values).all():
        return None
    i, j = np.unravel_index(np.nanargmax(values), values.shape)
    value = values[i, j]
    return str(data["part"].values[i]), str(data["rule"].values[j]), float(value), float(data["time_of"].values[i, j])


def _paths(target: Path, found: Sequence[Variant]) -> list[Path | None]:
    return [target] if len(found) == 1 else [target / variant.name for variant in found]


def _check_target(target: Path, paths: Sequence[Path], overwrite: bool) -> None:
    """Refuse an output folder that would lose something; what counts as lost is as for a single run."""
    if paths == [target] or not _held(target):
        check_target(target, overwrite)
        return
    if not overwrite:
        raise InputError(f"{target} holds runs already. Name another folder, or replace them: --overwrite (overwrite=True).")
    for path in paths:
        check_target(path, overwrite)


def _held(target: Path) -> list[Path]:
    """Variants in a folder that an earlier command has put there."""
    if is_store(target) or not target.is_dir():
        return []
    return [path for path in sorted(target.iterdir()) if is_store(path) and open_store(path).ledger.options.get("settings")]


def _make_room(gathered: _Gathered, path: Path, target: Path | None) -> None:
    """Take away what an earlier command has put where the variants go, once the first of them is computed."""
    if gathered.paths or target is None:
        return
    for old in [target] if is_store(target) else _held(target):
        clear(old)
        if old not in (target, path):
            with suppress(OSError):  # other files in it stay
                old.rmdir()
