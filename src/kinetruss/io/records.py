"""A record from a file of its own, with all faults at their line and column."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from kinetruss.errors import Fault, ModelError
from kinetruss.io.yaml_text import Tree, locate, parse, plain, read_text, refuse
from kinetruss.model import of_file

R = TypeVar("R")
MODEL_KEYS = ("kinetruss", "library", "nodes")
"""Keys that only a model has."""


def record_of_file(
    path: Path, build: Callable[[dict[str, Any]], R], start: str, what: str, others: Mapping[str, str], max_size: int
) -> R:
    """What `build` makes of the table in a file.

    start : how such a file starts. what : it is. others : what else it may be by mistake, a model or a mission -> the fix.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.
    """

    def checked(tree: Tree, faults: list[Fault]) -> R:
        for key in (*MODEL_KEYS, "kinetruss_mission"):
            other = "model" if key in MODEL_KEYS else "mission"
            if other in others and tree.keys and key in tree.keys:
                raise refuse(f"is a {other}, not {what}.", f"{others[other]} {start}", tree.keys[key], (key,))
        if faults:
            raise ModelError(faults)
        with of_file():
            return build(plain(tree))

    return of_table(path, checked, start, max_size)


def of_table(
    path: Path,
    build: Callable[[Tree, list[Fault]], R],
    start: str,
    max_size: int,
    located: Callable[[Fault, Tree], Fault] = locate,
) -> R:
    """What `build` makes of the table in a file and of the faults in its text. located : a fault of it in the file."""
    try:
        tree, faults = table_of(path, start, max_size)
        try:
            return build(tree, faults)
        except ModelError as error:
            raise ModelError(in_order(located(fault, tree) for fault in error.faults)) from None
    except ModelError as error:
        raise ModelError(error.faults, str(path)) from None


def table_of(path: Path, start: str, max_size: int) -> tuple[Tree, list[Fault]]:
    """The table in a file, and the faults of its text. start : how such a file starts, for one that has no table."""
    tree, faults = parse(path, read_text(path, max_size))
    if tree is None:
        raise refuse("is empty.", start, (1, 1))
    if tree.table is None:
        raise refuse("is not a table of names.", start, tree.place)
    return tree, faults


def in_order(faults: Iterable[Fault]) -> list[Fault]:
    """Faults in the order of the file; those of other files last."""
    return sorted(faults, key=lambda fault: (fault.file or "", fault.line or 0, fault.column or 0))
