"""A record from a file of its own, with all faults at their line and column."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from kinetruss.errors import ModelError
from kinetruss.io.yaml_text import Tree, locate, parse, plain, read_text, refuse
from kinetruss.model import of_file

R = TypeVar("R")
MODEL_KEYS = ("kinetruss", "library", "nodes")
"""Keys that only a model has."""


def record_of_file(
    path: Path,
    build: Callable[[dict[str, Any]], R],
    start: str,
    others: Mapping[str, tuple[str, str]],
    max_size: int,
) -> R:
    """What `build` makes of the table in a file.

    start : how such a file starts. others : keys that only other files have -> the message on them, and its fix.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.
    """
    try:
        tree = _table(path, start, others, max_size)
        try:
            with of_file():
                return build(plain(tree))
        except ModelError as error:
            located = [locate(fault, tree) for fault in error.faults]
            raise ModelError(sorted(located, key=lambda fault: (fault.line or 0, fault.column or 0))) from None
    except ModelError as error:
        raise ModelError(error.faults, str(path)) from None


def _table(path: Path, start: str, others: Mapping[str, tuple[str, str]], max_size: int) -> Tree:
    tree, faults = parse(path, read_text(path, max_size))
    if tree is None:
        raise refuse("is empty.", start, (1, 1))
    if tree.table is None:
        raise refuse("is not a table of names.", start, tree.place)
    for key, (message, mend) in others.items():
        if key in tree.table:
            raise refuse(message, f"{mend} {start}", (tree.keys or {}).get(key), (key,))
    if faults:
        raise ModelError(faults)
    return tree
