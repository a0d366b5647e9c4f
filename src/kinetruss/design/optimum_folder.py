"""The folder of an optimum: its task, every analysis that was computed, and the result at the end.

OUT/optimum.json        which task this is (`task`, a hash), its state, and the result
OUT/evaluations.jsonl   objective, excess and gradients at every point, a line as soon as it is known
OUT/given.json          the model as it was given
OUT/optimum.yaml        the model with the values found
OUT/listed.yaml         the same with parts of the catalogues of a mission
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.io import write
from kinetruss.results.folder import atomic, remove
from kinetruss.results.lock import LOCK, cannot_write, check_unlocked, holding

if TYPE_CHECKING:
    from kinetruss.design.optimum_result import Optimum
    from kinetruss.model import Model, OptimumTask

STATE, EVALUATIONS, GIVEN, FOUND = "optimum.json", "evaluations.jsonl", "given.json", "optimum.yaml"
LISTED = "listed.yaml"
FORMAT = 1


class OptimumFolder:
    """A folder that is locked for one search."""

    def __init__(self, path: Path, hashed: str) -> None:
        self.path, self.hashed = path, hashed

    @property
    def evaluations(self) -> Path:
        """The file of all analyses."""
        return self.path / EVALUATIONS

    def note(self, state: str, more: dict[str, Any]) -> None:
        """Replace the state in one step."""
        record = {"kinetruss_optimum_run": FORMAT, "task": self.hashed, "state": state, **more}
        atomic(self.path / STATE, json.dumps(record, indent=1, allow_nan=False))

    def finish(self, result: Optimum) -> None:
        """Write the result, and the model with it."""
        write(result.model, self.path / FOUND)
        if result.listed is not None:
            write(result.listed.sizing.model, self.path / LISTED)
        self.note(result.state or "finished", {"result": result.record})


def is_optimum(path: Path) -> bool:
    """True for the folder of an optimum."""
    try:
        return bool(json.loads((path / STATE).read_text("utf-8")).get("kinetruss_optimum_run"))
    except (OSError, ValueError, AttributeError):
        return False


@contextmanager
def opened(path: Path, model: Model, task: OptimumTask, *, overwrite: bool) -> Iterator[OptimumFolder]:
    """Lock a folder for a task: an empty one, or that of the same task, which goes on.

    Raises
    ------
    InputError : another task's folder (without `overwrite`), or one that is not empty and no optimum's.
    StoreError : another process writes it; it cannot be written.
    """
    hashed = hashlib.blake2b(f"{model.model_dump_json()} {_dumped(task)}".encode(), digest_size=16).hexdigest()
    _check(path, hashed, overwrite)
    check_unlocked(path)
    with holding(path):
        same = _check(path, hashed, overwrite)
        try:
            if not same:
                for name in (EVALUATIONS, STATE, GIVEN, FOUND, LISTED):
                    remove(path / name)
                atomic(path / GIVEN, model.model_dump_json())
            folder = OptimumFolder(path, hashed)
            folder.note("searching", {})
        except OSError as error:
            raise cannot_write(path, error) from error
        yield folder


def _check(path: Path, hashed: str, overwrite: bool) -> bool:
    """Whether a folder holds the same task."""
    if not path.exists():
        return False
    if not path.is_dir():
        raise InputError(f"{path} is a file. Name a folder for the optimum.")
    if all(item.name == LOCK for item in path.iterdir()):
        return False
    if not is_optimum(path):
        raise InputError(f"{path} is not empty and holds no optimum, so it is never overwritten. Name another folder.")
    same: bool = json.loads((path / STATE).read_text("utf-8"))["task"] == hashed
    if not same and not overwrite:
        mend = "Name another folder, or replace it with --overwrite (overwrite=True)."
        raise InputError(f"{path} holds the search of another model or task. {mend}")
    return same


def _dumped(task: OptimumTask) -> str:
    return task.with_(title="", model=None, mission=None, seconds=1.0).model_dump_json()
