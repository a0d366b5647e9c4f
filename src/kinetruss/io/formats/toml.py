"""TOML to a `Tree`: the standard library judges the text, a second walk finds where everything stands."""

from __future__ import annotations

import re
import tomllib

from kinetruss.errors import Fault
from kinetruss.io.formats.tree import Place, Tree, refuse

__all__ = ["parse_toml"]

_AT = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)")
_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_SCALAR = re.compile(r"[^\s,\]}#]+(?: \d\d:[^\s,\]}#]+)?")  # a date may be parted from its time by a space
_STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}(?!")|'
    r"'''.*?'{3,5}(?!')|"
    r'"(?:\\.|[^"\\\n])*"|'
    r"'[^'\n]*'",
    re.DOTALL,
)


def parse_toml(text: str) -> tuple[Tree, list[Fault]]:
    """The tree of a text; there are no faults that let the rest stand.

    Raises
    ------
    ModelError : it is not TOML; the fault has line and column.
    """
    try:
        tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        found = _AT.search(str(error))
        lines = text.rstrip().split("\n")
        place = (int(found[1]), int(found[2])) if found and found[1] else (len(lines), len(lines[-1]) + 1)
        raise refuse(f"is not TOML: {_AT.sub('', str(error))}.", 'Write name = "value" in each line.', place) from None
    return _Walk(text.replace("\r\n", "\n")).root, []


class _Walk:
    """Walks through text that is known to be right."""

    def __init__(self, text: str) -> None:
        self.text, self.at = text, 0
        self.root = _table((1, 1))
        here = self.root
        self._blank()
        while self.at < len(text):
            if text.startswith("[", self.at):
                here = self._header()
            else:
                self._pair(here)
            self._blank()

    def _place(self) -> Place:
        start = self.text.rfind("\n", 0, self.at) + 1
        return self.text.count("\n", 0, self.at) + 1, self.at - start + 1

    def _blank(self) -> None:
        found = _BLANK.match(self.text, self.at)
        self.at = found.end() if found else self.at

    def _skip(self, length: int) -> None:
        self.at += length
        self._blank()

    def _header(self) -> Tree:
        """The table that a header opens."""
        listed = self.text.startswith("[[", self.at)
        self._skip(2 if listed else 1)
        *path, (name, place) = self._path()
        self._skip(2 if listed else 1)
        here = self._down(self.root, path)
        if not listed:
            return self._down(here, [(name, place)])
        new = _table(place)
        there = _entries(here).get(name)
        if there is not None and there.items is not None:
            there.items.append(new)
        else:
            _put(here, name, place, Tree(place, items=[new]))
        return new

    def _pair(self, here: Tree) -> None:
        *path, (name, place) = self._path()
        self._skip(1)
        _put(self._down(here, path), name, place, self._value())

    def _path(self) -> list[tuple[str, Place]]:
        """The parts of a dotted key, up to the sign behind it."""
        parts = []
        while True:
            place = self._place()
            found = _STRING.match(self.text, self.at) or _BARE_KEY.match(self.text, self.at)
            assert found is not None  # noqa: S101 - the text has been read as TOML
            text = found[0]
            parts.append((tomllib.loads(f"v = {text}")["v"] if text[0] in "\"'" else text, place))
            self._skip(len(text))
            if not self.text.startswith(".", self.at):
                return parts
            self._skip(1)

    @staticmethod
    def _down(here: Tree, path: list[tuple[str, Place]]) -> Tree:
        """The table at a path; of a list of tables the last."""
        for name, place in path:
            below = _entries(here).get(name)
            if below is None:
                below = _table(place)
                _put(here, name, place, below)
            here = below.items[-1] if below.items else below
        return here

    def _value(self) -> Tree:
        place, sign = self._place(), self.text[self.at]
        if sign == "[":
            self._skip(1)
            items = []
            while self.text[self.at] != "]":
                items.append(self._value())
                self._comma()
            self._skip(1)
            return Tree(place, items=items)
        if sign == "{":
            self._skip(1)
            tree = _table(place)
            while self.text[self.at] != "}":
                self._pair(tree)
                self._comma()
            self._skip(1)
            return tree
        found = _STRING.match(self.text, self.at) or _SCALAR.match(self.text, self.at)
        assert found is not None  # noqa: S101 - the text has been read as TOML
        self._skip(len(found[0]))
        return Tree(place, tomllib.loads(f"v = {found[0]}")["v"])

    def _comma(self) -> None:
        if self.text[self.at] == ",":
            self._skip(1)


def _table(place: Place) -> Tree:
    return Tree(place, table={}, keys={})


def _entries(tree: Tree) -> dict[str, Tree]:
    return {} if tree.table is None else tree.table


def _put(here: Tree, name: str, place: Place, value: Tree) -> None:
    assert here.table is not None and here.keys is not None  # noqa: S101 - told to mypy
    here.table[name], here.keys[name] = value, place
