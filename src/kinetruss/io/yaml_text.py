"""The text of a file as a tree of plain values with their line and column, from YAML or JSON."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import yaml

from kinetruss.errors import Fault, ModelError

MAX_SIZE = 64_000_000
"""Largest size of a file, bytes, unless the caller allows more. A larger file is not read."""


def read_text(path: Path, max_size: int) -> str:
    """UTF-8 text of a file, without a byte-order mark.

    Raises
    ------
    ModelError : the file does not exist, is a folder, cannot be read, is larger than `max_size` bytes, or is not UTF-8.
    """
    if path.is_dir():
        raise refuse("is a folder.", "Name a model file in it, e.g. model.yaml.")
    try:
        size = path.stat().st_size
        if size <= max_size:
            with path.open("rb") as file:
                data = file.read(max_size + 1)  # one byte more: a device or pipe may not report its size
            size = len(data)
    except FileNotFoundError:
        raise refuse("there is no such file.", _offer(path)) from None
    except OSError as error:
        raise refuse(f"cannot be read: {error.strerror}.", "Change its permissions.") from None
    if size > max_size:
        mend = "Raise it with --max-size (max_size=...) if the file is meant."
        raise refuse(f"has {size:,} bytes, more than the limit of {max_size:,} bytes.", mend, (1, 1))
    return _decoded(data)


def _decoded(data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line_start = data.rfind(b"\n", 0, error.start) + 1
        place = data.count(b"\n", 0, error.start) + 1, len(data[line_start : error.start].decode("utf-8-sig")) + 1
        byte = f"byte {error.start} (0x{data[error.start]:02x})"
        looks = " It looks like UTF-16." if data[:2] in (b"\xff\xfe", b"\xfe\xff") else ""
        raise refuse(f"is not UTF-8 text: {byte} is not allowed in it.{looks}", "Save the file as UTF-8.", place) from None


def _offer(path: Path) -> str:
    try:
        names = [item.name for item in path.parent.iterdir()]
    except OSError:
        return f"There is no folder {str(path.parent)!r} either."
    near = get_close_matches(path.name, names, n=1, cutoff=0.5)
    return f"Did you mean {str(path.with_name(near[0]))!r}?" if near else f"Look in {str(path.parent)!r}."


# A parsed file: plain values with their line and column.

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


# Parses YAML and JSON to a `Tree`. JSON is read as YAML in which plain scalars are numbers, true, false or null.
#
# In YAML every scalar is text: no type is guessed, so ``no`` and ``12:30`` stay text. Only an empty value, ``~`` and
# ``null`` without quotes mean 'not given'.

_LOADER: Any = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
_ABSENT = ("", "~", "null")

_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?")
_WORDS = {"true": True, "false": False, "null": None}
_DIGITS = 300  # a longer whole number is read as a float: it is too large for any quantity
_PAIR = re.compile(r"(?<!\\)((?:\\\\)*)\\u([dD][89abAB][0-9a-fA-F]{2})\\u([dD][c-fC-F][0-9a-fA-F]{2})")
LONGEST_NAME = 1000
"""Characters of a name in JSON, escapes included: the parser of YAML looks no farther for the colon behind it."""
_STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"(\s*:)?')

# problem as the parser names it -> fix
_MENDS = {
    "mapping values are not allowed": "A line holds one 'key: value'; put quotes round a text with ': ' in it.",
    "cannot start any token": "Indent with spaces, not tabs; put quotes round a text that starts with @, ` or %.",
    "could not find expected ':'": "Write 'key: value', with a space after the colon.",
    "did not find expected ',' or ']'": "Close the list with ], and put commas between its entries.",
    "did not find expected ',' or '}'": "Close the table with }, and put commas between its entries.",
    "did not find expected key": "Give all keys of one table the same indentation.",
    "did not find expected '-' indicator": "Give all entries of one list the same indentation.",
    "unexpected end of stream": "Close the quotes.",
    "undefined alias": "Write &name before the value that *name repeats.",
    "another document": "Keep one document in a file; remove the second '---'.",
}


def parse(path: Path, text: str) -> tuple[Tree | None, list[Fault]]:
    """The tree of a file by its suffix: ``.json`` is JSON, anything else but ``.toml`` YAML; see `parse_yaml`."""
    if path.suffix.lower() == ".toml":
        mend = "Write it as YAML: 'name = value' becomes 'name: value', a [table] its name with a colon, its lines indented."
        raise refuse("is TOML, which is not read.", mend, (1, 1))
    return parse_json(text) if path.suffix.lower() == ".json" else parse_yaml(text)


def parse_yaml(text: str) -> tuple[Tree | None, list[Fault]]:
    """The tree of a text (None if it is empty), and the faults that do not stop parsing, such as double keys.

    Raises
    ------
    ModelError : it is not YAML; the fault has line and column.
    """
    return _parsed(text, _Builder(_text), "YAML")


def parse_json(text: str) -> tuple[Tree | None, list[Fault]]:
    """The same for JSON; comments and a comma after the last entry are allowed."""
    for found in _STRING.finditer(text):  # string by string: what lies between two of them is no name
        if found[1] and (size := len(found[0]) - len(found[1]) - 2) > LONGEST_NAME:
            raise refuse(f"has a name of {size} characters.", f"Write at most {LONGEST_NAME}.", _place_of(text, found.start()))
    return _parsed(_PAIR.sub(_joined, text), _Builder(_json), "JSON")


def _joined(found: re.Match[str]) -> str:
    """A surrogate pair of JSON (a character above U+FFFF) in the notation of YAML."""
    high, low = int(found[2], 16), int(found[3], 16)
    return f"{found[1]}\\U{0x10000 + ((high - 0xD800) << 10) + low - 0xDC00:08X}"


def _parsed(text: str, builder: _Builder, form: str) -> tuple[Tree | None, list[Fault]]:
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            builder.take(event)
    except yaml.MarkedYAMLError as error:
        raise _refused(error, len(text), form) from None
    except yaml.reader.ReaderError as error:
        place = _place_of(text, error.position)
        raise refuse(
            "is not text: there is a control character here.", "Remove it; save the file as plain UTF-8.", place
        ) from None
    return builder.root, rooted(builder.faults, builder.root)


def _text(event: Any) -> Any:
    """A scalar of YAML."""
    return None if event.implicit[0] and not event.style and event.value in _ABSENT else event.value


def _json(event: Any) -> Any:
    """A scalar of JSON."""
    text = event.value
    if event.style == '"':
        return text
    if found := _NUMBER.fullmatch(text):
        return int(text) if not found[1] and not found[2] and len(text) < _DIGITS else float(text)
    if not event.style and text in _WORDS:
        return _WORDS[text]
    problem = f"{text[:40]!r} is not a value" if text else "a value is missing"
    mend = 'Write a number, text in double quotes, true, false, null, [..] or {"name": value}.'
    raise refuse(f"is not JSON: {problem}.", mend, _place(event))


def _refused(error: Any, length: int, form: str) -> Exception:
    """The error at the position where parsing stopped; at the end of the file, where the unclosed element begins."""
    begun = error.context_mark
    mark = error.problem_mark or begun
    if begun is not None and mark.index >= length:
        mark = begun
    since = f" ({error.context} from line {begun.line + 1} on)" if begun and error.context else ""
    mend = next((mend for words, mend in _MENDS.items() if words in error.problem), "Correct the line, or the one above it.")
    return refuse(f"is not {form}: {error.problem}{since}.", mend, (mark.line + 1, mark.column + 1))


def _place_of(text: str, position: int) -> Place:
    before = text[:position]
    return before.count("\n") + 1, position - (before.rfind("\n") + 1) + 1


class _Builder:
    """Builds trees from events, with an explicit stack, so that a deeply nested file cannot overflow the call stack."""

    def __init__(self, scalar: Callable[[Any], Any]) -> None:
        self._read = scalar
        self.root: Tree | None = None
        self.faults: list[tuple[Tree, Fault]] = []
        # open lists and tables with their entries (for tables: keys and values alternately) and anchors
        self._stack: list[tuple[Tree, list[Tree], str | None]] = []
        self._anchors: dict[str, Tree | None] = {}
        self._count = 0

    def take(self, event: Any) -> None:
        """The next event of the parser."""
        if isinstance(event, yaml.ScalarEvent):
            self._add(self._scalar(event), event.anchor)
        elif isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
            self._open(event)
        elif isinstance(event, (yaml.MappingEndEvent, yaml.SequenceEndEvent)):
            self._close()
        elif isinstance(event, yaml.AliasEvent):
            self._add(self._alias(event), None)
        elif isinstance(event, yaml.DocumentStartEvent) and self.root is not None:
            raise refuse("holds another document.", "Keep one document in a file; remove the second '---'.", _place(event))

    def _scalar(self, event: Any) -> Tree:
        _untagged(event)
        return Tree(_place(event), self._read(event))

    def _open(self, event: Any) -> None:
        _untagged(event)
        if len(self._stack) == DEEPEST:
            raise refuse(
                f"is nested more than {DEEPEST} levels deep.", "Close brackets; a model needs few levels.", _place(event)
            )
        tree = Tree(_place(event), items=[] if isinstance(event, yaml.SequenceStartEvent) else None)
        if event.anchor:
            self._anchors[event.anchor] = None  # an anchor must not be repeated inside itself
        self._stack.append((tree, [], event.anchor))

    def _close(self) -> None:
        tree, entries, anchor = self._stack.pop()
        tree.size = 1 + sum(entry.size for entry in entries)
        too_large(tree.size, tree.place)
        if tree.items is None:
            self.faults += [(tree, fault) for fault in tree.fill(entries[::2], entries[1::2])]
        else:
            tree.items = entries
        self._add(tree, anchor)

    def _alias(self, event: Any) -> Tree:
        if event.anchor not in self._anchors:
            raise refuse(
                f"*{event.anchor} repeats nothing.", f"Write &{event.anchor} before the value it repeats.", _place(event)
            )
        if (tree := self._anchors[event.anchor]) is None:
            raise refuse(f"*{event.anchor} repeats itself.", "Remove it.", _place(event))
        return tree

    def _add(self, tree: Tree, anchor: str | None) -> None:
        if anchor:
            self._anchors[anchor] = tree
        if self._stack:
            self._stack[-1][1].append(tree)
            self._count += 1
            too_large(self._count, tree.place)
        else:
            self.root = tree


def _untagged(event: Any) -> None:
    if event.tag and event.tag != "!":
        raise refuse(f"has the tag {event.tag!r}.", "Remove it; values need no tags here.", _place(event))


def _place(event: Any) -> Place:
    return event.start_mark.line + 1, event.start_mark.column + 1
