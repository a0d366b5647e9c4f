"""Messages for the field errors of pydantic: what, where, got, expected, and the fix."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from difflib import SequenceMatcher, get_close_matches
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, get_args, get_origin

from kinetruss.errors import Fault, one_line, shown
from kinetruss.units import NUMBER

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from pydantic import ValidationError


_OF_FILE = ContextVar("of_file", default=False)
"""True while data of a file are checked: mends are then written as in a file."""

Path = tuple[str | int, ...]
_LONGEST = 200  # characters of a name
_APART = 0.2  # names less similar than the most similar one by more than this are not offered
_PART = 3
"""Least number of characters of a part of a name that is offered."""
_OFFERED = 500  # largest number of faults for which a similar name is searched
_SENTENCE = re.compile(r"\.\s+(?=[A-Z])")

# type of a pydantic error -> (expected, fix)
_SHAPES = {
    "dict_type": ("a table of names", "Write for example {{{entry}}}."),
    "model_type": ("a table of fields", "Write for example {entry}."),
    "model_attributes_type": ("a table of fields", "Write for example {entry}."),
    "tuple_type": ("a list", "Write for example {entry}."),
    "string_type": ("text", 'Write a name or text; a number used as a name needs quotes, e.g. "3".'),
}

# field -> an entry of it; of a table or a list without one: _ENTRIES
_EXAMPLES = {
    "amplitudes": "motor: 30 deg",
    "at": "[0, 100 mm]",
    "bars": "crank: [A, B]",
    "drives": "motor: {kind: angle, bar: crank}",
    "ends": "[A, B]",
    "fixed": "A: xy, D: xy",
    "force": "[0, -100 N]",
    "gravity": "[0, -9.81]",
    "loads": "weight: {node: B, force: [0, -100 N]}",
    "moves": "motor: [0, 90 deg]",
    "nodes": "A: [0, 0], B: [1 m, 0]",
    "rates": "motor: 10",
}
_RECORDS = {
    "beams": "{ends: [A, B]}",
    "links": "{nodes: [A, B, C]}",
    "bodies": "{nodes: [A, B, C], mass: 2 kg}",
    "conditions": "{gravity: [0, -1.62]}",
    "coordinate": "{kind: angle, bar: crank}",
    "couplings": "{terms: [[{kind: angle, bar: crank}, 1], [{kind: angle, bar: rocker}, -2]]}",
    "drives": "{kind: angle, bar: crank}",
    "loads": "{node: B, force: [0, -100 N]}",
    "load_cases": "{loads: {weight: 1.35}}",
    "combinations": "{cases: {dead: 1.35, wind: 1.5}}",
    "material": "{E: 210 GPa, density: 7850}",
    "materials": "{E: 210 GPa, density: 7850}",
    "runs": "{trajectory: {kind: rate, rates: {motor: 10}, duration: 1 s}}",
    "method": "{kind: dop853}",
    "safety": "{yielding: 1.5, buckling: 2}",
    "section": "{kind: rod, diameter: 10 mm}",
    "sections": "{kind: rod, diameter: 10 mm}",
    "springs": "{coordinate: {kind: angle, bar: crank}, stiffness: 5}",
    "tasks": "{kind: hold}",
    "trajectories": "{kind: rate, rates: {motor: 10}, duration: 1 s}",
    "trajectory": "{kind: rate, rates: {motor: 10}, duration: 1 s}",
}
"""Field or table -> a record in it."""
_OTHERS = {
    "duration": "t_end", "end_time": "t_end", "elements": "bars", "members": "bars", "joints": "nodes", "points": "nodes",
    "modulus": "E", "young": "E", "youngs_modulus": "E", "rho": "density", "position": "at",
    "weight": "mass", "fy": "yield_strength", "nu": "poisson",
}  # fmt: skip
"""Words of other programs -> the field that has this meaning here."""
_CLASSES = {
    '"kind": "angle"': "AngleDrive", '"kind": "rod"': "Rod", '"kind": "tube"': "Tube", '"node"': "NodalForce",
    '"kind": "rate"': "ConstantRate", '"trajectory"': "Run", '"E"': "Material",
}  # fmt: skip
"""How a record of the examples begins -> its class."""
SECTIONS = (
    "Give a solid round bar as {kind: rod, diameter: 10 mm} (kt.Rod), a round tube as {kind: tube, outer: 20 mm, inner: 16 mm} "
    "(kt.Tube), others as kind: rectangle or general."
)
"""How to write a section in its place, for those who name one by another word (``circle``, ``pipe``)."""
_ENTRIES = {
    "dict_type": "name: ...",
    "tuple_type": "[a, b]",
    "model_type": "{field: ..}",
    "model_attributes_type": "{kind: ..}",
}

# record that may be given as a list -> the same
_SHORT = {
    "Node": ("a point", "Write for example [0, 100 mm], or {{at: [0, 100 mm], mass: 2 kg}}."),
    "Bar": ("two nodes", "Write for example [A, B], or {{ends: [A, B], mass: 2 kg}}."),
}


def nearest(name: object, known: Iterable[object]) -> str:
    """The fix for an unknown name: the most similar names.

    >>> import kinetruss as kt
    >>> kt.model.nearest("crnk", ["crank", "rocker"])
    "Did you mean 'crank'?"
    """
    names = [str(k) for k in known]
    wanted = name if isinstance(name, str) else shown(name)
    if same := [name for name in names if name.lower() == wanted.lower() and name != wanted]:
        return f"Did you mean {', '.join(map(shown, same[:3]))}?"
    near = get_close_matches(wanted[:_LONGEST], names, n=3, cutoff=0.5)
    if not near and len(wanted) >= _PART:
        near = [name for name in names if wanted.lower() in name.lower()][:3]
    if near:
        best = _alike(wanted, near[0])
        near = [name for name in near if _alike(wanted, name) > best - _APART]
        return f"Did you mean {', '.join(map(shown, near))}?"
    return f"There are: {', '.join(map(one_line, names[:12])) or 'none'}{', ...' if len(names) > 12 else ''}."


def _numeric(given: Any) -> bool:
    """True for a list with a number, or a text that starts like one."""
    entries = given if isinstance(given, (list, tuple)) else (given,)
    return any(isinstance(one, (int, float)) or NUMBER.match(str(one)) for one in entries)


def _alike(one: str, other: str) -> float:
    """Similarity of two names, 0 to 1."""
    return SequenceMatcher(None, one[:_LONGEST], other).ratio()


@contextmanager
def of_file() -> Iterator[None]:
    """Within it data come from a file, and mends are written as in a file.

    >>> with of_file():
    ...     in_python("Write for example {A: xy}.")
    'Write for example {A: xy}.'
    """
    before = _OF_FILE.set(True)
    try:
        yield
    finally:
        _OF_FILE.reset(before)


def in_python(mend: str) -> str:
    """A mend as Python is written; as it is within `of_file`.

    >>> in_python("Write for example {A: xy, D: xy}.")
    'Write for example {"A": "xy", "D": "xy"}.'
    >>> in_python("Make the body kind: straining, or give nodes: {B: {at: [..], mass: 2 kg}}.")
    'Make the body kind="straining", or give nodes={"B": {"at": [...], "mass": "2 kg"}}.'
    """
    if _OF_FILE.get():
        return mend
    depth, pieces, start = 0, [], 0
    for k, sign in enumerate(mend):
        depth += (sign in "{[") - (sign in "}]")
        if sign in "{[" and depth == 1:
            pieces.append(_plain(mend[start:k]))
            start = k
        elif sign in "}]" and depth == 0:
            pieces.append(_literal(mend[start : k + 1]))
            start = k + 1
    return "".join([*pieces, _plain(mend[start:])]) if depth == 0 else mend


def _plain(text: str) -> str:
    """Text between tables: names before them, kinds, and classes that the tables have become."""
    text = re.sub(r"^ \(kt\.\w+\)", "", text)
    return re.sub(r"\bkind: (?!one of)(\w+)", r'kind="\1"', _KEYWORD.sub(r"\1=", text))


def faults_of(error: ValidationError, data: Mapping[str, Any], record: type) -> list[Fault]:
    """The faults in a pydantic error of `record` built from `data`."""
    items = error.errors(include_url=False)
    above = {item["loc"][:k] for item in items for k in range(len(item["loc"]))}
    # pydantic also calls a list too short if only its entries are faulty, which are reported already
    own = [item for item in items if item["type"] != "too_short" or item["loc"] not in above]
    faults = [_fault(item, data, record, known=index < _OFFERED) for index, item in enumerate(own)]
    return list(dict.fromkeys(faults))  # a list that lacks two entries has two errors: report one: report one


def _fault(item: Any, data: Any, record: type, *, known: bool) -> Fault:
    path = _clean(item["loc"], data, item["type"] == "missing")
    kind, given = item["type"], item["input"]
    if kind == "missing" and isinstance(path[-1], int):
        return Fault(path[:-1], f"has {_entries(len(given))}, too few.", "Give one for each place, e.g. [a, b].")
    if kind == "missing":
        return Fault(path, f"{shown(path[-1])} is missing.", "Add it.")
    if kind == "extra_forbidden":
        fields = _fields(record, item["loc"][:-1]) if known else []
        other = _OTHERS.get(str(path[-1]).lower())
        offer = f"Did you mean {other!r}?" if other in fields else nearest(path[-1], fields) if known else "Remove it."
        return Fault(path, f"{shown(path[-1])} is not known here.", offer)
    if kind in _SHAPES:
        expected, mend = _SHORT.get(item.get("ctx", {}).get("class_name"), _SHAPES[kind])
        if callable(given):
            mend = "A motion goes into a table (kt.Spline), forces in time into user_force. Or: " + mend
        what = "is empty" if given is None else "is a function" if callable(given) else f"is {shown(given)}"
        if path[-1:] == ("fixed",):
            expected, mend = "a list or a table of names", "Write for example fixed: [A, D], or fixed: {{A: xy, D: xy}}."
        if path[-1:] == ("clamped",):
            expected, mend = "a list or a table of names", "Write for example clamped: [A, D], or clamped: {{A: BODY}}."
        if path[:1] == ("supports",) and len(path) < 3:
            mend = "Write for example supports: {{A: {{x: held, y: 2 kN/mm}}}}; fixed: [A] holds a node in place."
        if not _OF_FILE.get():
            expected = {
                "a table of names": "a dictionary",
                "a list or a table of names": "a list or a dictionary",
                "a table of fields": "a record",
            }.get(expected, expected)
        return Fault(path, f"{what}; expected {expected}.", mend.format(entry=_example(kind, path)))
    if kind == "union_tag_not_found":
        return Fault(path, "has no kind.", f"Add kind: one of {', '.join(_kinds(record, item['loc']))}.")
    message, mend = _worded(kind, given, item.get("ctx", {})) or _split(item["msg"])
    return Fault(path, message, mend)


_KEYWORD = re.compile(r"\b([a-z_]+): $")
_TOKEN = re.compile(r"[^,{}\[\]:]+")


def _literal(flow: str) -> str:
    """A table or list of a file as a value in Python; a record of the examples as its class."""

    def quoted(token: re.Match[str]) -> str:
        text = token[0].strip()
        known = not text or text.startswith('"') or NUMBER.fullmatch(text)
        words = {"..": "...", "...": "...", "true": "True", "false": "False"}
        return token[0] if known else token[0].replace(text, words.get(text, f'"{text}"'))

    found = _TOKEN.sub(quoted, flow)
    for begin, name in _CLASSES.items():
        record = re.compile(rf"\{{({re.escape(begin)}(?=[:,])(?:[^{{}}]|\{{[^{{}}]*\}})*)\}}")
        found = record.sub(partial(_called, name), found)
    return found


def _called(name: str, table: re.Match[str]) -> str:
    """A call of a class with the fields of a table; those of tables in it stay."""
    fields, depth, named, start = table[1], 0, "", 0
    for k, sign in enumerate(fields + ","):
        depth += (sign in "{[(") - (sign in "}])")
        if sign == "," and depth == 0:
            field, _, value = fields[start:k].strip().partition(": ")
            named += "" if field == '"kind"' else f", {field.strip(chr(34))}={value}"
            start = k + 1
    return f"kt.{name}({named.removeprefix(', ').removeprefix('bar=')})"


def _example(kind: str, path: Path) -> str:
    """An entry of the field at a place, or of the table that the place is in (``moves.motor``)."""
    names = path[-1:] if kind == "dict_type" else path[-1:-3:-1]
    if path[-2:-1] == ("moves",):
        return "[0, 90 deg], the first and the last value"
    if kind.startswith("model"):
        return next((_RECORDS[name] for name in names if name in _RECORDS), _ENTRIES[kind])
    return next((_EXAMPLES[name] for name in names if name in _EXAMPLES), _ENTRIES.get(kind, ""))


def _worded(kind: str, given: Any, context: Any) -> tuple[str, str] | None:
    """Message and fix of pydantic's own errors."""
    if kind == "union_tag_invalid":
        known = re.findall(r"'([^']*)'", context["expected_tags"])
        meant = get_close_matches(context["tag"], known, cutoff=0.7)
        mend = SECTIONS if "tube" in known and not meant else nearest(context["tag"], known)
        return f"kind {shown(context['tag'])} is not known.", mend
    if kind == "literal_error":
        known = re.findall(r"'([^']*)'|(\d+)", context["expected"])
        names = [a or b for a, b in known]
        return f"{shown(given)} is not one of {', '.join(names)}.", nearest(given, names)
    if kind == "invalid_key":
        return "is a name that is no text.", 'Write it as text; a number used as a name needs quotes, e.g. "3".'
    if kind == "string_too_long":
        return f"the name {shown(given)} has {len(given)} characters.", f"Use at most {context['max_length']}."
    if kind in ("string_pattern_mismatch", "string_too_short"):
        message = f"{shown(given)} is no name: it is empty, or has a space, a slash or a control character."
        return message, "Use letters, digits and _ - . : only."
    if kind in ("too_short", "too_long"):
        limit = context.get("min_length") or context.get("max_length")
        bound = "at least" if kind == "too_short" else "at most"
        mend = f"Give {bound} {limit}."
        if kind == "too_long" and not isinstance(given, dict):
            mend += " A decimal comma splits a number in two." * _numeric(given)
        return f"has {_entries(context['actual_length'] or len(given))}; expected {bound} {limit}.", mend
    for rule, words in (("greater_than_equal", "at least"), ("less_than_equal", "at most")):
        if kind == rule:
            return f"{shown(given)} must be {words} {next(iter(context.values())):g}.", "Give a number in that range."
    for rule, words in (("greater_than", "greater than"), ("less_than", "less than")):
        if kind == rule:
            return f"{shown(given)} must be {words} {next(iter(context.values())):g}.", "Give a number in that range."
    return None


def _entries(count: int) -> str:
    return "1 entry" if count == 1 else f"{count} entries"


def _split(text: str) -> tuple[str, str]:
    """Message and fix of a text: the fix is everything after its first sentence."""
    text = text.removeprefix("Value error, ")
    message, *mend = _SENTENCE.split(text, maxsplit=1)
    return (f"{message}.", mend[0]) if mend else (text, "Mend the value.")


def _clean(loc: Path, data: Any, missing: bool) -> Path:
    """The place without the tags of unions that pydantic inserts between the names."""
    path: list[str | int] = []
    here = data
    for index, part in enumerate(loc):
        if part == "[key]" and index == len(loc) - 1:
            continue
        if isinstance(here, dict) and part == here.get("kind") and index < len(loc) - 1:
            continue  # the kind is a tag here, even if a field has the same name
        found, below = _step(here, part)
        if found:
            path.append(part)
            here = below
        elif (missing and index == len(loc) - 1) or _shorthand(here, part):
            path.append(part)
    return tuple(path)


def _step(here: Any, part: str | int) -> tuple[bool, Any]:
    if isinstance(here, dict) and part in here:
        return True, here[part]
    if isinstance(part, int) and hasattr(here, "__getitem__") and not isinstance(here, (dict, str)):
        return True, here[part] if part < len(here) else None
    if isinstance(part, str) and part in getattr(type(here), "model_fields", {}):
        return True, getattr(here, part)
    return False, None


def _shorthand(here: Any, part: str | int) -> bool:
    """Drop the field from the place of a node or bar that is given as a list."""
    return part in ("at", "ends") and isinstance(here, (list, tuple))


def _records(record: type, loc: Path) -> list[Any]:
    """The possible record types at a place, found by following the annotations."""
    types: list[Any] = [record]
    for part in loc:
        types = [below for one in types for below in _below(one, part)] or types
    return [one for one in types if hasattr(one, "model_fields")]


def _fields(record: type, loc: Path) -> list[str]:
    return list(dict.fromkeys(name for one in _records(record, loc) for name in one.model_fields))


def _kinds(record: type, loc: Path) -> list[str]:
    return [one.model_fields["kind"].default for one in _records(record, loc) if "kind" in one.model_fields]


def _below(one: Any, part: str | int) -> Iterator[Any]:
    if fields := getattr(one, "model_fields", None):
        if part in fields:
            yield from _leaves(fields[part].annotation)
        elif part == one.__name__ or ("kind" in fields and fields["kind"].default == part):
            yield one
    elif get_origin(one) is dict:
        yield from _leaves(get_args(one)[1])
    elif get_origin(one) is tuple and isinstance(part, int):
        entries = get_args(one)
        yield from _leaves(entries[min(part, len(entries) - 1 - (Ellipsis in entries))])


def _leaves(annotation: Any) -> Iterator[Any]:
    """Records and containers of a type, without unions and annotations."""
    if isinstance(annotation, type) or get_origin(annotation) in (dict, tuple):
        yield annotation
    elif get_origin(annotation) is Annotated:
        yield from _leaves(get_args(annotation)[0])
    else:
        for part in get_args(annotation):
            yield from _leaves(part)
