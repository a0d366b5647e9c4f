"""Tasks of optima from files."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from kinetruss.errors import Fault, ModelError
from kinetruss.io.yaml_text import MAX_SIZE, locate, parse, plain, read_text, refuse
from kinetruss.model import OptimumTask, of_file

START = "Start with kinetruss_optimum: 1, then model, least, variables, limits."


def read_optimum(path: str | Path, *, max_size: int = MAX_SIZE) -> OptimumTask:
    r"""Read the task of an optimum from a YAML or JSON file; the path of its model is relative to it.

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
    try:
        tree, faults = parse(path, read_text(path, max_size))
        if tree is None:
            raise refuse("is empty.", START, (1, 1))
        if tree.table is None:
            raise refuse("is not a table of names.", START, tree.place)
        if keys := [key for key in ("kinetruss", "library", "nodes", "kinetruss_mission") if key in tree.table]:
            what = "a mission" if keys[0] == "kinetruss_mission" else "a model"
            place = (tree.keys or {}).get(keys[0])
            raise refuse(f"is {what}, not the task of an optimum.", START, place, (keys[0],))
        if faults:
            raise ModelError(faults)
        try:
            with of_file():
                task = OptimumTask(**plain(tree))
        except ModelError as error:
            located = [locate(fault, tree) for fault in error.faults]
            raise ModelError(sorted(located, key=lambda fault: (fault.line or 0, fault.column or 0))) from None
    except ModelError as error:
        raise ModelError([replace(fault, file=fault.file or str(path)) for fault in error.faults], str(path)) from None
    return task if task.model is None else task.with_(model=str(path.parent / task.model))


def placed_in(path: str | Path, faults: Iterable[Fault]) -> list[Fault]:
    """Faults of a task with their line and column in its file."""
    tree, _ = parse(Path(path), read_text(Path(path), MAX_SIZE))
    return [fault if tree is None or fault.file else replace(locate(fault, tree), file=str(path)) for fault in faults]
