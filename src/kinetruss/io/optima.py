"""Tasks of optima from files."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from glob import escape
from pathlib import Path

from kinetruss.errors import Fault, InputError
from kinetruss.io.records import MODEL_KEYS, record_of_file
from kinetruss.io.yaml_text import MAX_SIZE, locate, parse, read_text
from kinetruss.model import OptimumTask

START = "Start with kinetruss_optimum: 1, then model, least, variables, limits."


def read_optimum(path: str | Path, *, max_size: int = MAX_SIZE) -> OptimumTask:
    r"""Read the task of an optimum from a YAML or JSON file; the paths of its model and mission are relative to it.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> text = "kinetruss_optimum: 1\nvariables: {area: {of: bars.*.section.area, between: [1 cm^2, 9 cm^2]}}\n"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "lightest.yaml")
    ...     _ = file.write_text(text)
    ...     task = kt.io.read_optimum(file)
    >>> task.least, task.variables["area"].of
    ('mass', ('bars.*.section.area',))
    """
    path = Path(path)
    others = {"model": "A task names it: model: FILE.", "mission": "Size it by kinetruss size."}
    task = record_of_file(path, lambda data: OptimumTask(**data), START, "the task of an optimum", others, max_size)
    return task.with_(
        **{one: str(path.parent / own) for one in ("model", "mission") if (own := getattr(task, one)) is not None}
    )


def optimum_file(path: Path, max_size: int = MAX_SIZE) -> Path:
    """The file of a task: the one that is given, or if that is a model NAME.yaml, the one beside it, NAME.optimum.yaml.

    Raises
    ------
    InputError : none stands beside the model, or several do (NAME.WHAT.optimum.yaml). ModelError : no file, no YAML.
    """
    tree, _ = parse(path, read_text(path, max_size))
    if tree is None or not any(key in (tree.table or {}) for key in MODEL_KEYS):
        return path
    found = [one for one in sorted(path.parent.glob(f"{escape(path.stem)}.*")) if one.suffixes[-2:-1] == [".optimum"]]
    if len(found) == 1:
        return found[0]
    if not found:
        raise InputError(f"{path} is a model, and no task stands beside it as {path.stem}.optimum.yaml. Write one. {START}")
    raise InputError(f"{path} is a model with {len(found)} tasks beside it: {', '.join(one.name for one in found)}. Name one.")


def placed_in(path: str | Path, faults: Iterable[Fault]) -> list[Fault]:
    """Faults of a task with their line and column in its file."""
    tree, _ = parse(Path(path), read_text(Path(path), MAX_SIZE))
    return [fault if tree is None or fault.file else replace(locate(fault, tree), file=str(path)) for fault in faults]
