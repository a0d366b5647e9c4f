"""The folder of an optimum: its task, every analysis that was computed, and the result at the end.

OUT/optimum.json        which task this is (`task`, a hash), what it asks, its state, and the result, or why there is none
OUT/evaluations.jsonl   objective, excess and gradients at every point, a line as soon as it is known
OUT/given.json          the model as it was given
OUT/optimum.yaml        the model with the values found
OUT/listed.yaml         the same with parts of the catalogues of a mission
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.design.optimum.evaluations import history_of
from kinetruss.errors import AnalysisError, InfeasibleError, InputError, StoreError
from kinetruss.io import read, write
from kinetruss.model import Model
from kinetruss.results.folder import atomic, remove
from kinetruss.results.lock import LOCK, cannot_write, check_unlocked, holding

if TYPE_CHECKING:
    from kinetruss.design.optimum_result import Optimum
    from kinetruss.model import OptimumTask

STATE, EVALUATIONS, GIVEN, FOUND = "optimum.json", "evaluations.jsonl", "given.json", "optimum.yaml"
LISTED = "listed.yaml"
FORMAT = 1


class OptimumFolder:
    """A folder that is locked for one search."""

    def __init__(self, path: Path, hashed: str, question: Mapping[str, Any]) -> None:
        self.path, self.hashed, self.question = path, hashed, question

    @property
    def evaluations(self) -> Path:
        """The file of all analyses."""
        return self.path / EVALUATIONS

    def note(self, state: str, more: dict[str, Any]) -> None:
        """Replace the state in one step."""
        record = {"kinetruss_optimum_run": FORMAT, "task": self.hashed, "question": self.question, "state": state, **more}
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
def opened(
    path: Path, model: Model, task: OptimumTask, question: Mapping[str, Any], *, overwrite: bool
) -> Iterator[OptimumFolder]:
    """Lock a folder for a task: an empty one, or that of the same task, which goes on. question : what it asks, plain data.

    An error of the search is noted: its state is then ``infeasible`` or ``failed``.

    Raises
    ------
    InputError : another task's folder (without `overwrite`), or one that is not empty and no optimum's.
    StoreError : another process writes it; it cannot be written.
    """
    bare = task.with_(title="", model=None, mission=None, seconds=1.0)
    asked = f"{model.model_dump_json()} {bare.model_dump_json()}"
    if model.recipe is not None and any(name in asked for name in ('"library.', '"parameters.')):
        asked += model.recipe.source  # a function may give the same model, and other ones beside it
    hashed = hashlib.blake2b(asked.encode(), digest_size=16).hexdigest()
    _check(path, hashed, overwrite)
    check_unlocked(path)
    with holding(path):
        same = _check(path, hashed, overwrite)
        try:
            if not same:
                for name in (EVALUATIONS, STATE, GIVEN, FOUND, LISTED):
                    remove(path / name)
                atomic(path / GIVEN, model.model_dump_json())
            folder = OptimumFolder(path, hashed, question)
            folder.note("searching", {})
        except OSError as error:
            raise cannot_write(path, error) from error
        try:
            yield folder
        except AnalysisError as error:
            folder.note("infeasible" if isinstance(error, InfeasibleError) else "failed", {"message": str(error)})
            raise


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


@dataclass(frozen=True, kw_only=True)
class KeptOptimum:
    """What the folder of an optimum holds.

    state : ``finished``, ``interrupted``, ``searching`` (it is being done, or was killed), ``infeasible``, ``failed``.
    question : what is asked (`optimum_result.question`). given : the model; model : that with the values found, or None.
    result : `Optimum.record`, or None; message : why there is none. history : [analyses, objective, largest excess] of every
    analysis that was computed, the last None if nothing is limited.
    """

    path: Path
    state: str
    question: Mapping[str, Any]
    given: Model
    model: Model | None
    result: Mapping[str, Any] | None
    message: str
    history: Sequence[Sequence[float | None]]


def load_optimum(path: str | Path) -> KeptOptimum:
    """Read the folder of an optimum, also of one that is being searched.

    Raises
    ------
    StoreError : no optimum, or one that cannot be read.

    Examples
    --------
    >>> import tempfile
    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter=0.02), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = kt.design.optimise(
    ...         rod, {"d": {"of": "section.diameter", "between": ("4 mm", "40 mm")}}, "mass",
    ...         {"stress": {"of": "axial_stress", "at_most": "100 MPa"}}, arguments={"weight": False}, out=folder + "/lightest",
    ...     )
    ...     found = kt.design.load_optimum(folder + "/lightest")
    >>> found.state, round(found.result["values"]["d"], 6)  # sqrt(4 F/(pi sigma)), m
    ('finished', 0.009441)
    """
    folder = Path(path)
    try:
        found = json.loads((folder / STATE).read_text("utf-8"))
        state, result = str(found["state"]), found.get("result")
        return KeptOptimum(
            path=folder, state=state, question=found["question"], message=found.get("message", ""), result=result,
            given=Model.model_validate_json((folder / GIVEN).read_text("utf-8")),
            model=None if result is None else read(folder / FOUND),
            history=history_of(folder / EVALUATIONS) if result is None else result["history"],
        )  # fmt: skip
    except (OSError, ValueError, KeyError, AttributeError) as error:
        mend = "Make one: kinetruss optimise FILE -o OUT; one of an older release is searched again with --overwrite."
        raise StoreError(f"{folder} holds no optimum that can be read ({type(error).__name__}: {error}). {mend}") from error
