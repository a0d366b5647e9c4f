"""One variant of a study after the other, in one process: the model, its run, and of it only the numbers that are kept."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from threading import Lock
from typing import Any

from kinetruss.errors import KinetrussError, plain
from kinetruss.io import MAX_SIZE
from kinetruss.model import Model
from kinetruss.model.runs import MISSION
from kinetruss.runs.blocks import blocks
from kinetruss.runs.joining import Accumulator, in_memory, notes_of
from kinetruss.runs.missions import run_mission
from kinetruss.runs.plans import SIMULATED, Plan, chosen_run, plan
from kinetruss.runs.results import RunResult
from kinetruss.runs.running import run
from kinetruss.runs.variant_sets import Base
from kinetruss.studies.kept_numbers import Kept
from kinetruss.threads import one_thread

REFUSED, FAILED, DIED = "REFUSED", "FAILED", "DIED"
"""Status of a variant without a run: the model does not allow its values; it raised an error; its process died."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a variant. status : name of a `Status`, or one of those above. numbers : results by name, only of a run
    that is complete; units : their units, SI.
    """

    row: int
    status: str
    message: str = ""
    seconds: float = 0.0
    numbers: Mapping[str, float] | None = None
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Task:
    """All that a process needs for the variants of a study. model : a model as JSON, or the path of its file, if a parameter of
    its library is a variable. results : name -> text. full : these need section forces or motor demands.
    """

    model: str
    run: str
    results: tuple[tuple[str, str], ...]
    path: str = ""
    full: bool = False
    max_size: int = MAX_SIZE


Rows = Sequence[tuple[int, Mapping[str, Any]]]
"""Rows of a study with their values, path -> value."""

_alone = Lock()
"""One variant at a time in a process, whatever threads ask for them."""


def evaluate(task: Task, rows: Rows) -> list[Outcome]:
    """The outcomes of some rows. An error of a variant is its outcome."""
    with _alone:
        base, kept = _prepared(task)
        return [evaluated(base, task, kept, row, values) for row, values in rows]


@lru_cache(maxsize=4)
def _prepared(task: Task) -> tuple[Base, Kept]:
    model = task.path or Model.model_validate_json(task.model)
    return Base(model, task.max_size), Kept(dict(task.results))


def evaluated(base: Base, task: Task, kept: Kept, row: int, values: Mapping[str, Any]) -> Outcome:
    """The outcome of one row."""
    started = time.perf_counter()
    try:
        model = base.with_(values)
    except KinetrussError as error:
        return Outcome(row, REFUSED, plain(str(error)), time.perf_counter() - started)
    return outcome_of(model, task, kept, row, started)


def outcome_of(model: Model, task: Task, kept: Kept, row: int, started: float) -> Outcome:
    """The outcome of the run of a model."""
    status, message, numbers = FAILED, "", None
    try:
        found = run(model, task.run) if task.full else brief(model, task.run, kept.judged)
        status, message = found.status.name, found.partial or found.message
        # what ends early, and a mission without some of its pairs, has no numbers
        numbers = None if found.partial else kept(found)
    except KinetrussError as error:
        status, message = FAILED, str(error)
    except Exception as error:  # noqa: BLE001 - whatever a model raises is told of that model, and the study goes on
        status, message = FAILED, f"{type(error).__name__}: {error}"
    return Outcome(row, status, plain(message), time.perf_counter() - started, numbers, kept.units)


@one_thread
def brief(model: Model, name: str, judged: bool = True) -> RunResult:
    """A run in memory with motion and forces alone, and with the strength check; equal to these of `runs.run`.

    So it leaves out the same poses at rest, section forces and motor demands, which take most of the time of a small run.
    """
    name = chosen_run(model, name)
    if model.runs[name].analysis == MISSION:
        return run_mission(model, name)
    job = replace(plan(model, name), full=False, bare=not judged)
    computed = blocks(job)
    first = next(computed)
    if not first.last or job.run.analysis == SIMULATED:
        return _joined(job, [first, *computed])
    return RunResult(
        model=job.model,
        given=job.origin,
        name=job.name,
        motion=first.motion,
        forces=first.forces,
        statics=first.statics,
        verdict=first.verdict,
        status=first.motion.status,
        message=" ".join(notes_of(first)),
        samples=len(job.times),
    )


def _joined(job: Plan, found: Iterable[Any]) -> RunResult:
    accumulated, every = Accumulator(job.model), list(found)
    for block in every:
        accumulated.add(block)
    return in_memory(job, every, accumulated, 0.0)
