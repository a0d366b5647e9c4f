"""One variant of a study after the other, in one process: the model, its run, and of it only the numbers that are kept."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from threading import Lock
from typing import Any

from kinetruss.errors import KinetrussError, plain
from kinetruss.io import MAX_SIZE
from kinetruss.model import Model
from kinetruss.runs.variant_sets import Base
from kinetruss.studies.brief_runs import LEVELS, brief
from kinetruss.studies.kept_numbers import Kept

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
    its library is a variable. results : name -> text. level : how much
    of a run these need (`brief_runs`).
    """

    model: str
    run: str
    results: tuple[tuple[str, str], ...]
    path: str = ""
    level: str = LEVELS[0]
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
        found = brief(model, task.run, task.level, kept.judged)
        status, message = found.status.name, found.partial or found.message
        # what ends early, and a mission without some of its pairs, has no numbers
        numbers = None if found.partial else kept(found)
    except KinetrussError as error:
        status, message = FAILED, str(error)
    except Exception as error:  # noqa: BLE001 - whatever a model raises is told of that model, and the study goes on
        status, message = FAILED, f"{type(error).__name__}: {error}"
    return Outcome(row, status, plain(message), time.perf_counter() - started, numbers, kept.units)
