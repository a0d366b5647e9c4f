"""JSON to a `Tree`, with the place of every value."""

from __future__ import annotations

import json
import re
from bisect import bisect_right
from typing import Any

from kinetruss.errors import Fault
from kinetruss.io.formats.tree import DEEPEST, Place, Tree, refuse, rooted, too_large

__all__ = ["parse_json"]

_SPACE = re.compile(r"[ \t\r\n]*")
_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?")
_WORD = re.compile(r"[^\s,:\[\]{}\"]*")
_WORDS = {"true": True, "false": False, "null": None}
_DIGITS = 300  # a longer whole number is read as a float: it is too large for any quantity


def parse_json(text: str) -> tuple[Tree | None, list[Fault]]:
    """The tree of a text (None where it is empty), and the faults that let the rest stand, such as double keys.

    Raises
    ------
    ModelError : it is not JSON; the fault has line and column.
    """
    if not text.strip(" \t\r\n"):
        return None, []
    parser = _Parser(text)
    root = parser.value(0)
    if parser.look():
        raise parser.refuse("something follows the end", "Remove it, or put all into one { }")
    return root, rooted(parser.faults, root)


class _Parser:
    """Reads one text from left to right."""

    def __init__(self, text: str) -> None:
        self.faults: list[tuple[Tree, Fault]] = []
        self._text = text
        self._at = 0
        self._count = 0
        self._lines = [0, *(match.end() for match in re.finditer("\n", text))]

    def look(self) -> str:
        """The next character that is no space; empty at the end."""
        match = _SPACE.match(self._text, self._at)
        self._at = match.end() if match else self._at
        return self._text[self._at : self._at + 1]

    def refuse(self, problem: str, mend: str) -> Exception:
        """The error of a text that is not JSON here."""
        return refuse(f"is not JSON: {problem}.", f"{mend}.", self._place())

    def value(self, depth: int) -> Tree:
        """The value that starts here."""
        start = self.look()
        if depth == DEEPEST:
            raise self.refuse(f"nested more than {DEEPEST} levels deep", "Close brackets; a model needs few levels")
        tree = Tree(self._place())
        self._count += 1
        too_large(self._count, tree.place)
        if start == "{":
            self._table(tree, depth)
        elif start == "[":
            self._list(tree, depth)
        elif start == '"':
            tree.value = self._string()
        else:
            tree.value = self._scalar()
        return tree

    def _place(self) -> Place:
        line = bisect_right(self._lines, self._at)
        return line, self._at - self._lines[line - 1] + 1

    def _take(self, wanted: str) -> None:
        if self.look() != wanted:
            raise self.refuse(f"expected {wanted!r}", f"Write {wanted!r} here, or mend what stands before it")
        self._at += 1

    def _table(self, tree: Tree, depth: int) -> None:
        keys: list[Tree] = []
        values: list[Tree] = []
        self._take("{")
        while self.look() != "}":
            if keys:
                self._take(",")
            if self.look() != '"':
                raise self.refuse("expected a name in double quotes", 'Write {"name": value}, without a comma after the last')
            keys.append(Tree(self._place(), self._string()))
            self._take(":")
            values.append(self.value(depth + 1))
        self._at += 1
        self.faults += [(tree, fault) for fault in tree.fill(keys, values)]

    def _list(self, tree: Tree, depth: int) -> None:
        tree.items = []
        self._take("[")
        while self.look() != "]":
            if tree.items:
                self._take(",")
            tree.items.append(self.value(depth + 1))
        self._at += 1

    def _string(self) -> str:
        try:
            value, self._at = json.decoder.scanstring(self._text, self._at + 1)  # type: ignore[attr-defined]
        except json.JSONDecodeError as error:
            self._at = error.pos
            raise self.refuse(error.msg[0].lower() + error.msg[1:], "Close the quotes; write \\n for a new line") from None
        return str(value)

    def _scalar(self) -> Any:
        if match := _NUMBER.match(self._text, self._at):
            after = match.end()
            if not _WORD.match(self._text, after)[0]:  # type: ignore[index]
                self._at = after
                whole = not match[1] and not match[2] and len(match[0]) < _DIGITS
                return int(match[0]) if whole else float(match[0])
        word = _WORD.match(self._text, self._at)[0]  # type: ignore[index]
        if word in _WORDS:
            self._at += len(word)
            return _WORDS[word]
        problem = f"{word[:40]!r} is no value" if word else "a value is missing"
        raise self.refuse(problem, "Write a number, text in double quotes, true, false, null, [..] or {..}")
