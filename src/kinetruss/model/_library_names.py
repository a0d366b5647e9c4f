"""Adds library records that a model names, but does not define, to its tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kinetruss.errors import shown
from kinetruss.model._words import nearest
from kinetruss.shelves import shelf

__all__ = ["from_library", "with_library_records"]

_TABLES = {
    "section": "sections",
    "material": "materials",
    "screw": "screws",
    "gear": "gears",
    "motor": "motors",
    "amplifier": "amplifiers",
}
_TRAIN = ("screw", "gear", "motor", "amplifier")
_MATTER = ("section", "material")

_FIELDS = {
    "bars": _MATTER,
    "beams": _MATTER,
    "hubs": _MATTER,
    "membranes": ("material",),
    "solids": ("material",),
    "drives": _TRAIN,
    "active": _TRAIN,
}
"""Table of a model -> fields of its records that may hold a name."""


def with_library_records(data: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a model with the library records that it names, but does not define, added to its tables."""
    added: dict[str, dict[str, Any]] = {}
    for field, name in set(_named(data)):
        table = _TABLES[field]
        own = data.get(table)
        if (own is None or (isinstance(own, Mapping) and name not in own)) and name in (records := shelf(table)):
            added.setdefault(table, {})[name] = records[name]
    return dict(data) | {table: {**(data.get(table) or {}), **records} for table, records in added.items()}


def from_library(value: Any, table: str) -> Any:
    """The library's record of this name for a table; other values unchanged."""
    if not isinstance(value, str):
        return value
    if (found := shelf(table).get(value)) is None:
        raise ValueError(f"no {table[:-1]} called {shown(value)} in the library. {nearest(value, shelf(table))}")
    return found


def _named(data: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Field and name of every record that the data name."""
    yield from _names_in(data, _MATTER)
    for table, fields in _FIELDS.items():
        members = data.get(table)
        for member in members.values() if isinstance(members, Mapping) else ():
            yield from _names_in(member, fields)
            if table == "active":
                for side in ("base", "tube"):
                    part = member.get(side) if isinstance(member, Mapping) else getattr(member, side, None)
                    yield from _names_in(part, _MATTER)


def _names_in(part: Any, fields: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    for field in fields:
        name = part.get(field) if isinstance(part, Mapping) else getattr(part, field, None)
        if isinstance(name, str):
            yield field, name
