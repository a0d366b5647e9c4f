"""A model as plain data in the shortest form that a file allows, and plain data as YAML or JSON text."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal
from functools import cache
from typing import Any, get_args

from kinetruss.model import Bar, Membrane, Model, Node, Of, Record, Restraint, Solid
from kinetruss.units import EITHER, Tagged

_UNITS = {quantity: dict(zip(("length", "angle"), units.split(", or "), strict=False)) for quantity, units in EITHER.items()}
"""By quantity the units of the values of a length and of an angle."""
_SHORT = {Node: "at", Bar: "ends", Restraint: "stiffness"}
"""Records that are written as the value of one field if they have no other field."""

LISTED = 20
"""Largest number of mesh elements written as a list; more are written as one text, which is read a hundred times faster."""


def plain_model(model: Model) -> dict[str, Any]:
    """The model without its defaults. Numbers are in SI; those with a known quantity include the unit as text, ``0.5 rad``."""
    return {"kinetruss": model.kinetruss, **plain_record(model)}


def plain_record(record: Record) -> Any:
    """A record as `plain_model` has it."""
    quantities = _quantities(type(record))
    given: dict[str, Any] = {"kind": record.kind} if _has_kind(record) else {}  # type: ignore[attr-defined]
    for name, field in type(record).model_fields.items():
        value = getattr(record, name)
        if field.is_required() or value != field.get_default():
            given[name] = _value(value, quantities.get(name, ""))
    if isinstance(record, Membrane | Solid) and len(record.elements) > LISTED:
        given["elements"] = "; ".join(" ".join(map(str, row)) for row in record.elements)
    if not given and isinstance(record, Restraint):
        return "held"
    if list(given) == [_SHORT.get(type(record))]:
        return next(iter(given.values()))
    return given


def _has_kind(record: Record) -> bool:
    """True if ``kind`` distinguishes records; the kind of a bar is an ordinary field."""
    return "kind" in type(record).model_fields and not isinstance(record, Bar)


@cache
def _quantities(record: type[Record]) -> dict[str, str]:
    """The fields of a record whose numbers are of a length or of an angle, with what they are."""
    found = {name: [*_either(field.annotation), *_either(*field.metadata)] for name, field in record.model_fields.items()}
    return {name: own[0] for name, own in found.items() if own}


def _either(*annotations: Any) -> Iterator[str]:
    for one in annotations:
        if isinstance(one, Of) and one.quantity in EITHER:
            yield one.quantity
        yield from _either(*get_args(one))


def _value(value: Any, quantity: str) -> Any:
    if isinstance(value, Record):
        return plain_record(value)
    if isinstance(value, Mapping):
        return {key: _value(item, quantity) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_value(item, quantity) for item in value]
    if isinstance(value, Tagged):
        number, units = float(value), _UNITS[quantity or "coordinate"]
        return f"{number!r} {units.get(value.quantity, value.quantity)}" if value.quantity else number
    return value


# Plain data as YAML or JSON text: tables over several lines, small entries in brackets.

WIDTH = 120
_PLAIN = re.compile(
    r"[A-Za-z_][A-Za-z0-9_.\-]*|[A-Za-z_][A-Za-z0-9_.\-/() ]*[A-Za-z0-9_.\-/()]|-?[0-9][0-9.e+\-]* [a-z]+(/s)?", re.ASCII
)
_WORDS = ("y", "n", "yes", "no", "on", "off", "true", "false", "null")  # texts that other YAML readers do not read as text
_UNPRINTED = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff]")

Scalar = Callable[[Any], str]


def to_yaml(data: dict[str, Any]) -> str:
    """YAML text of a table; `Tree` reads it back unchanged."""
    return "".join(f"{line}\n" for key, value in data.items() for line in entry_lines(key, value, 0))


def to_json(data: dict[str, Any]) -> str:
    """JSON text of a table."""
    return "{\n" + ",\n".join(_entry(key, value, 2) for key, value in data.items()) + "\n}\n"


def entry_lines(key: str, value: Any, indent: int) -> Iterator[str]:
    """YAML lines of one entry: one line if it fits; the tables of a model always one line per name."""
    head = f"{' ' * indent}{scalar_text(key)}:"
    line = f"{head} {_flow(value, scalar_text)}"
    if value and isinstance(value, dict) and (len(line) > WIDTH or (indent == 0 and not _small(value))):
        yield head
        for name, item in value.items():
            yield from entry_lines(name, item, indent + 2)
    elif value and isinstance(value, list) and len(line) > WIDTH:
        yield from _wrapped(f"{head} [", value, indent + 2, scalar_text)
    else:
        yield line


def _wrapped(head: str, items: list[Any], indent: int, scalar: Scalar) -> Iterator[str]:
    """A long list over several lines."""
    line, pad = head, " " * indent
    for index, item in enumerate(items):
        text = _flow(item, scalar) + (", " if index < len(items) - 1 else "]")
        if len(line) + len(text) > WIDTH and line.strip():
            yield line.rstrip()
            line = pad
        line += text
    yield line


def _entry(key: str, value: Any, indent: int) -> str:
    """One entry of a JSON table."""
    pad = " " * indent
    head = f"{pad}{_json_scalar(key)}: "
    line = head + _flow(value, _json_scalar)
    if value and isinstance(value, dict) and (len(line) > WIDTH or (indent == 2 and not _small(value))):
        return f"{head}{{\n" + ",\n".join(_entry(name, item, indent + 2) for name, item in value.items()) + f"\n{pad}}}"
    if value and isinstance(value, list) and len(line) > WIDTH:
        return "\n".join(_wrapped(f"{head}[", value, indent + 2, _json_scalar))
    return line


def _small(table: dict[str, Any]) -> bool:
    """A record or a short list of texts, not a table of records."""
    return not any(isinstance(value, (dict, list)) for value in table.values())


def _flow(value: Any, scalar: Scalar) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{scalar(key)}: {_flow(item, scalar)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(_flow(item, scalar) for item in value) + "]"
    return scalar(value)


def scalar_text(value: Any) -> str:
    """A text, number or truth value in YAML; quoted where it must be."""
    if isinstance(value, str) and _PLAIN.fullmatch(value) and value.lower() not in _WORDS:
        return value
    return _json_scalar(value)


def _json_scalar(value: Any) -> str:
    if isinstance(value, str):
        return _UNPRINTED.sub(lambda match: f"\\u{ord(match[0]):04x}", json.dumps(value, ensure_ascii=False))
    if isinstance(value, float):
        return _number(value)
    return json.dumps(value)


def _number(value: float) -> str:
    """The shortest text that reads back as the same float."""
    if value == 0:
        return "-0.0" if str(value)[0] == "-" else "0"
    exact = Decimal(repr(value)).normalize()
    fixed, scientific = f"{exact:f}", f"{exact:e}"
    return fixed if len(fixed) <= max(len(scientific), 8) and abs(value) < 1e15 else scientific
