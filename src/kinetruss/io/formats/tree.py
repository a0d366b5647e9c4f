"""A parsed file: plain values with their line and column."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from kinetruss.errors import Fault, ModelError

__all__ = ["DEEPEST", "Place", "Tree", "locate", "plain", "refuse", "rooted", "too_large"]

DEEPEST = 50  # levels of nesting; a model needs less than ten
LARGEST = 2_000_000  # values, aliases followed; a model of 100,000 members has about a million

Place = tuple[int, int]
"""Line and column, from 1."""


@dataclass(slots=True, eq=False)
class Tree:
    """A scalar, list or table of a file.

    value : text, number, true/false or None for a scalar; None for others.
    items : entries of a list. table : entries by key; keys : position of each key.
    size : number of scalars in it, aliases followed.
    """

    place: Place
    value: Any = None
    items: list[Tree] | None = None
    table: dict[str, Tree] | None = None
    keys: dict[str, Place] | None = None
    size: int = 1

    def fill(self, keys: list[Tree], values: list[Tree]) -> Iterator[Fault]:
        """Put keys and values into the table; yields the faults of keys. For a double key the first value is kept."""
        self.table, self.keys = {}, {}
        for key, value in zip(keys, values, strict=True):
            name = key.value
            if not isinstance(name, str):
                mend = 'Write a name before the colon, in quotes where needed: "null".'
                yield Fault((), "a key is not a name.", mend, *key.place)
            elif name in self.table:
                first = self.keys[name][0]
                message = f"{name!r} is given twice; first at line {first}."
                yield Fault((name,), message, "Rename one, or remove it.", *key.place)
            else:
                self.table[name], self.keys[name] = value, key.place


def refuse(message: str, mend: str, place: Place | None = None, path: tuple[str, ...] = ()) -> ModelError:
    """The error for a file that cannot be parsed at all."""
    line, column = place or (None, None)
    return ModelError([Fault(path, message, mend, line, column)])


def too_large(count: int, place: Place) -> None:
    """Raise an error if there are more values than a model can have, before they fill the memory."""
    if count > LARGEST:
        mend = "Write it without aliases, or in smaller parts; tables belong in a CSV file."
        raise refuse(f"holds more than {LARGEST:,} values (aliases followed).", mend, place)


def rooted(found: list[tuple[Tree, Fault]], root: Tree | None) -> list[Fault]:
    """Faults inside tables, with the paths of the tables added in front."""
    if not found or root is None:
        return [fault for _, fault in found]
    paths: dict[int, tuple[str | int, ...]] = {}
    left: list[tuple[Tree, tuple[str | int, ...]]] = [(root, ())]
    while left:
        tree, path = left.pop()
        if id(tree) not in paths:
            paths[id(tree)] = path
            left += [(child, (*path, key)) for key, child in (tree.table or {}).items()]
            left += [(child, (*path, index)) for index, child in enumerate(tree.items or ())]
    return [replace(fault, path=paths.get(id(tree), ()) + fault.path) for tree, fault in found]


def plain(tree: Tree) -> Any:
    """Dicts, lists and scalars without their positions."""
    if tree.table is not None:
        return {key: plain(child) for key, child in tree.table.items()}
    if tree.items is not None:
        return [plain(child) for child in tree.items]
    return tree.value


def locate(fault: Fault, tree: Tree) -> Fault:
    """The fault with the line and column of the deepest part of its path that the file has.

    Parts that the file omits (`at` of a node written as a list) are skipped. A name in a list is its own key
    (``fixed: [A, B]``).
    """
    if fault.line is not None or fault.file is not None:
        return fault
    place = tree.place
    for index, part in enumerate(fault.path):
        if tree.table is not None and str(part) in tree.table:
            key, tree = tree.keys[str(part)], tree.table[str(part)]  # type: ignore[index]
            # a table or list in block style starts below its key
            place = key if tree.value is None or _unknown(fault, index) else tree.place
        elif tree.items is not None and isinstance(part, int) and part < len(tree.items):
            tree = tree.items[part]
            place = tree.place
        elif tree.items is not None and (named := [item for item in tree.items if item.value == part]):
            tree = named[0]
            place = tree.place
    return replace(fault, line=place[0], column=place[1])


def _unknown(fault: Fault, index: int) -> bool:
    """True if the fault is in the key itself, not in its value."""
    return index == len(fault.path) - 1 and "not known here" in fault.message
