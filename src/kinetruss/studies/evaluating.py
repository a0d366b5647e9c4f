"""One variant of a study after the other, in one process: the model, its run, and of it only the numbers that are kept."""

from __future__ import annotations

import math
import pickle
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from threading import Lock
from typing import Any

from kinetruss.errors import InfeasibleError, KinetrussError, plain
from kinetruss.io import MAX_SIZE
from kinetruss.model import Model
from kinetruss.runs.variant_sets import Base
from kinetruss.studies.brief_runs import LEVELS, brief
from kinetruss.studies.kept_numbers import Kept
from kinetruss.studies.optima import Numbers, Tasks, optimum_of
from kinetruss.studies.side_by_side import Copies

REFUSED, FAILED, DIED = "REFUSED", "FAILED", "DIED"
"""Status of a variant without a run: the model does not allow its values; it raised an error; its process died."""
INFEASIBLE, UNCERTIFIED = "INFEASIBLE", "UNCERTIFIED"
"""Status of an optimum: no design keeps all limits, which is a result; its numbers are kept, but are no optimum."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a variant. status : name of a `Status`, or one of those above. numbers : results by name, only of a run
    that is complete; units : their units, SI. seconds : of processor time, which other programs do not change.
    """

    row: int
    status: str
    message: str = ""
    seconds: float = 0.0
    numbers: Mapping[str, float] | None = None
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Task:
    """All that a process needs for the variants of a study. model : a model as JSON; built : as pickled, if a parameter from
    which it is built is a variable. results : name -> text. level : how much of a run these need (`brief_runs`). optimum : the
    text of a task, of which each variant is an optimum in place of a run.
    """

    model: str
    run: str
    results: tuple[tuple[str, str], ...]
    built: bytes = b""
    level: str = LEVELS[0]
    optimum: str = ""
    max_size: int = MAX_SIZE


Rows = Sequence[tuple[int, Mapping[str, Any]]]
"""Rows of a study with their values, path -> value."""

LEAST = 8
"""Rows from which on copies are worth their making."""
CLOSE = 1e-9
"""Largest relative difference of variants together from those alone."""
_alone = Lock()
"""One variant at a time in a process, whatever threads ask for them."""


def evaluate(task: Task, rows: Rows) -> list[Outcome]:
    """The outcomes of some rows. An error of a variant is its outcome."""
    with _alone:
        base, kept, copies = ready(task, rows)
        if copies is None:
            return [evaluated(base, task, kept, row, values) for row, values in rows]
        found = []
        for first in range(0, len(rows), copies.count):
            found += _together(base, task, kept, copies, rows[first : first + copies.count])
        return found


def ready(task: Task, rows: Rows) -> tuple[Base, Kept, Copies | None]:
    """What a process keeps for the rows of a study; copies of the model beside each other for many rows, if they are good."""
    base, kept = _prepared(task)
    together = len(rows) >= LEAST and not task.optimum and task.level == LEVELS[0] and not kept.judged
    return base, kept, _copies(task, tuple(rows[0][1])) if together else None


@lru_cache(maxsize=4)
def _copies(task: Task, paths: tuple[str, ...]) -> Copies | None:
    """Copies of the model beside each other, if they are good for it: the first two have the numbers that they have alone."""
    base, kept = _prepared(task)
    model = base.with_({})
    try:
        copies = Copies(model, task.run, paths)
        pair = copies.runs([model, model])
    except KinetrussError:
        return None
    alone = outcome_of(model, task, kept, 0, 0.0).numbers
    if pair is None or alone is None:
        return None
    both = [kept(run, {"mass": mass}) for run, mass in pair]
    return copies if all(_close(one, alone) for one in both) else None


def _close(one: Mapping[str, float], other: Mapping[str, float]) -> bool:
    pairs = [(one[name], other[name]) for name in other]
    return all(abs(a - b) <= CLOSE * abs(b) or (math.isnan(a) and math.isnan(b)) for a, b in pairs)


def _together(base: Base, task: Task, kept: Kept, copies: Copies, rows: Rows) -> list[Outcome]:
    """The outcomes of rows whose runs are done together; one after the other where one of them is not complete."""
    started, found, models = time.thread_time(), list[Outcome](), dict[int, Model]()
    for row, values in rows:
        try:
            models[row] = base.with_(values)
        except KinetrussError as error:
            found.append(Outcome(row, REFUSED, plain(str(error))))
    try:
        runs = copies.runs(list(models.values()))
    except KinetrussError:
        runs = None
    if runs is None:
        return [*found, *(outcome_of(model, task, kept, row, time.thread_time()) for row, model in models.items())]
    numbers = [kept(run, {"mass": mass}) for run, mass in runs]
    seconds = (time.thread_time() - started) / len(rows)
    done = [Outcome(row, "COMPLETED", "", seconds, one, kept.units) for row, one in zip(models, numbers, strict=True)]
    return found + done


@lru_cache(maxsize=4)
def _prepared(task: Task) -> tuple[Any, Any]:
    """The base of the variants, and what keeps the numbers."""
    base = Base(pickle.loads(task.built) if task.built else Model.model_validate_json(task.model), task.max_size)
    if not task.optimum:
        return base, Kept(dict(task.results))
    tasks = Tasks(base, task.optimum)
    return tasks, Numbers(tasks.task, dict(task.results))


def evaluated(base: Base | Tasks, task: Task, kept: Kept | Numbers, row: int, values: Mapping[str, Any]) -> Outcome:
    """The outcome of one row."""
    started = time.thread_time()
    try:
        model = base.with_(values)
    except KinetrussError as error:
        return Outcome(row, REFUSED, plain(str(error)), time.thread_time() - started)
    return outcome_of(model, task, kept, row, started)


def outcome_of(model: Any, task: Task, kept: Kept | Numbers, row: int, started: float) -> Outcome:
    """The outcome of the run of a model; of a model and a task, of their optimum."""
    status, message, numbers = FAILED, "", None
    try:
        if isinstance(kept, Numbers):
            best, message = optimum_of(model)
            status = "COMPLETED" if best.certified else UNCERTIFIED
            return Outcome(row, status, plain(message), time.thread_time() - started, kept(best), kept.units)
        found = brief(model, task.run, task.level, kept.judged)
        early = found.partial
        status, message = found.status.name, " ".join(filter(None, (early and f"{early}.", found.message)))
        # what ends early, and a mission without some of its pairs, has no numbers
        numbers = None if early else kept(found)
    except InfeasibleError as error:
        status, message = INFEASIBLE, str(error)
    except KinetrussError as error:
        status, message = FAILED, str(error)
    except Exception as error:  # noqa: BLE001 - whatever a model raises is told of that model, and the study goes on
        status, message = FAILED, f"{type(error).__name__}: {error}"
    return Outcome(row, status, plain(message), time.thread_time() - started, numbers, kept.units)
