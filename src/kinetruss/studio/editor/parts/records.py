"""Forms of all records of a model file for the page, made from the schema: fields with unit, choices and library names."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from kinetruss.io import schema

__all__ = ["forms"]

Spec = dict[str, Any]

SHORT = {"nodes": "Node", "bars": "Bar", "beams": "Beam"}
"""Tables whose entries may be plain lists -> their record."""


@cache
def forms() -> dict[str, Any]:
    """What the page needs to show any entry.

    tables : name -> about, spec of an entry. records : name -> about, kind, fields: name -> spec, with ``needed``.
    A spec has a ``type``: value (unit), choice (of, free: other texts too), flag, text, list (of, count), table (of), record
    (of: names of records, named: a name of the library or of a table may stand for it), any (YAML text).
    """
    made = schema()
    tables = {}
    for name, one in made["else"]["properties"].items():
        entry = one.get("additionalProperties")
        if isinstance(entry, dict):
            spec = {"type": "record", "of": [SHORT[name]], "named": False} if name in SHORT else _spec(entry)
            tables[name] = {"about": one.get("description", ""), **spec}
    return {"tables": tables, "records": {name: _record(one) for name, one in made["$defs"].items()}}


def _record(one: dict[str, Any]) -> dict[str, Any]:
    one = next(part for part in (one, *one.get("anyOf", ())) if "properties" in part)
    needed = set(one.get("required", ()))
    fields = {name: _spec(part) | {"needed": name in needed} for name, part in one["properties"].items()}
    kind = one["properties"].get("kind", {}).get("const")
    if kind is not None:
        del fields["kind"]
    return {"about": one.get("description", ""), "kind": kind, "fields": fields}


def _spec(part: dict[str, Any]) -> Spec:
    """The form of one field."""
    extra = {"default": part["default"]} if part.get("default") not in (None, [], {}) else {}
    ways = _ways(part)
    records = [way["$ref"].rpartition("/")[2] for way in ways if "$ref" in way]
    chosen = next((way["enum"] for way in ways if "enum" in way), None)
    if records:
        return {"type": "record", "of": records, "named": any(way.get("type") == "string" for way in ways)} | extra
    if chosen is not None:
        if any(one is True for one in chosen):
            return {"type": "flag"} | extra
        return {"type": "choice", "of": chosen, "free": len(ways) > 1} | extra
    if len(ways) != 1:
        return {"type": "any"} | extra
    return _plain(ways[0]) | extra


def _plain(way: dict[str, Any]) -> Spec:
    if "x-unit" in way and way.get("type") != "array":
        said = re.search(r"a number in (.*?),? or text", way.get("description", ""))
        return {"type": "value", "unit": said[1] if said else way["x-unit"]}
    if way.get("type") == "array":
        items = way.get("prefixItems")
        return {"type": "list", "of": _spec(items[0] if items else way.get("items", {})), "count": len(items or ()) or None}
    if way.get("type") == "object" and isinstance(way.get("additionalProperties"), dict):
        return {"type": "table", "of": _spec(way["additionalProperties"])}
    return {"type": "text" if way.get("type") == "string" else "any"}


def _ways(part: dict[str, Any]) -> list[dict[str, Any]]:
    """The forms that a value may have, without 'not given'."""
    if "x-unit" in part:
        return [part]
    if "anyOf" in part or "oneOf" in part:
        return [way for one in part.get("anyOf") or part["oneOf"] for way in _ways(one)]
    return [] if part.get("type") == "null" else [part]
