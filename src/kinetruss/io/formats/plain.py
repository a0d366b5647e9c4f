"""A model as dicts, lists, texts and numbers, in the shortest form that a file allows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinetruss.model import Bar, ConstantRate, Membrane, Model, Node, Record, Solid
from kinetruss.units import Tagged

__all__ = ["plain_model"]

_UNITS = {"length": "m", "angle": "rad"}
_SHORT = {Node: "at", Bar: "ends"}
"""Records that are written as the list of one field if they have no other field."""

LISTED = 20
"""Largest number of mesh elements written as a list; more are written as one text, which is read a hundred times faster."""


def plain_model(model: Model) -> dict[str, Any]:
    """The model without its defaults. Numbers are in SI; those with a known quantity include the unit as text, ``0.5 rad``."""
    return {"kinetruss": model.kinetruss, **_record(model)}


def _record(record: Record) -> Any:
    rate = "/s" if isinstance(record, ConstantRate) else ""
    given: dict[str, Any] = {"kind": record.kind} if _has_kind(record) else {}  # type: ignore[attr-defined]
    for name, field in type(record).model_fields.items():
        value = getattr(record, name)
        if field.is_required() or value != field.get_default():
            given[name] = _value(value, rate)
    if isinstance(record, Membrane | Solid) and len(record.elements) > LISTED:
        given["elements"] = "; ".join(" ".join(map(str, row)) for row in record.elements)
    if list(given) == [_SHORT.get(type(record))]:
        return next(iter(given.values()))
    return given


def _has_kind(record: Record) -> bool:
    """True if ``kind`` distinguishes records; the kind of a bar is an ordinary field."""
    return "kind" in type(record).model_fields and not isinstance(record, Bar)


def _value(value: Any, rate: str) -> Any:
    if isinstance(value, Record):
        return _record(value)
    if isinstance(value, Mapping):
        return {key: _value(item, rate) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_value(item, rate) for item in value]
    if isinstance(value, Tagged):
        number = float(value)
        return f"{number!r} {_UNITS[value.quantity]}{rate}" if value.quantity else number
    return value
