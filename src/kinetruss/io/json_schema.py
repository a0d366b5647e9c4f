"""JSON Schema of model files, for editors that complete and check them during typing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from kinetruss.model import Model, Record, field_texts
from kinetruss.shelves import shelves

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_LIBRARY = {
    "description": "A library model and its parameters; the other keys change it, name by name.",
    "anyOf": [{"type": "string"}, {"type": "object", "properties": {"name": {"type": "string"}}, "required": ["name"]}],
}
_FILE = {"type": "string", "description": "CSV table, relative to this file, in place of times and values"}
_FROM_FILE = {
    "Spline": ("times", "values"),
    "Measured": ("times", "values"),
    "NodalForce": (),
    "History": ("times", "displacements"),
}
"""Records that ``file`` may fill -> the fields that it gives."""


def schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of model files, made from the records; the shipped file holds the same.

    It allows what `read` allows in form: text with units, plain lists for nodes, bars and beams, a list under ``fixed`` and
    ``clamped``, ``file`` in place of a table, ``library``. Of a text that names an entry ``x-names`` lists the tables of such
    entries, ``x-also`` other words for them. References and units are checked by `check`.

    Examples
    --------
    >>> schema()["title"]
    'kinetruss model file'
    """
    made = _tidy(Model.model_json_schema())
    records = made["$defs"]
    _describe(records, {one.__name__: one for one in _all(Record)})
    for name in {name for union in _unions(made) for name in union}:
        records[name]["required"] = ["kind", *records[name].get("required", [])]
    for name, fields in _FROM_FILE.items():
        _allow_file(records[name], fields)
    records["Node"] = {"anyOf": [records["Node"], records["Node"]["properties"]["at"]]}
    for name in ("Bar", "Beam"):
        records[name] = {"anyOf": [records[name], records[name]["properties"]["ends"]]}
    records["Link"] = {"anyOf": [records["Link"], records["Link"]["properties"]["nodes"]]}
    records["Combination"] = {"anyOf": [records["Combination"], records["Combination"]["properties"]["cases"]]}
    records["Quantity"] = {"anyOf": [records["Quantity"], records["Quantity"]["properties"]["value"]]}
    held = records["Restraint"]
    records["Restraint"] = {"anyOf": [held, {"enum": ["held", "free"]}, held["properties"]["stiffness"]["anyOf"][0]]}
    properties = made["properties"]
    listed = {"type": "array", "items": {"type": "string", **properties["nodes"]["propertyNames"]}}
    for name in ("fixed", "clamped"):
        properties[name] = {"anyOf": [properties[name], listed]}
    codes = properties["combinations"]["additionalProperties"]["oneOf"][1:]
    properties["combinations"] = {"anyOf": [properties["combinations"], *codes]}
    overlay = {name: _partial(one) for name, one in properties.items()}
    return {
        "$schema": _DIALECT,
        "title": "kinetruss model file",
        "description": f"Sections, materials and drive trains named in {', '.join(shelves())} may come from the library.",
        "type": "object",
        "if": {"required": ["library"]},
        "then": {"properties": {"library": _LIBRARY, **overlay}, "additionalProperties": False},
        "else": {"properties": properties, "required": made["required"], "additionalProperties": False},
        "$defs": records,
    }


def _all(record: type[Record]) -> Iterator[type[Record]]:
    for one in record.__subclasses__():
        yield one
        yield from _all(one)


def _describe(records: dict[str, Any], known: Mapping[str, type[Record]]) -> None:
    """Give every field the words of its record's docstring, before those of its quantity."""
    for name, one in records.items():
        for field, text in field_texts(known[name]).items() if name in known else ():
            if (own := one.get("properties", {}).get(field)) is not None:
                given = own.get("description", "")
                own["description"] = f"{text} {given[:1].upper()}{given[1:]}".strip()


def schema_file() -> Path:
    """The JSON Schema that is shipped with the package.

    >>> import kinetruss as kt
    >>> import json
    >>> json.loads(kt.io.schema_file().read_text(encoding="utf-8"))["type"]
    'object'
    """
    return Path(__file__).with_name("kinetruss.schema.json")


def _tidy(part: Any) -> Any:
    """The schema without titles and discriminators that only repeat names, and without examples in Python."""
    if isinstance(part, dict):
        named = "properties" in part or "$defs" in part
        if "patternProperties" in part:
            part = _table(part)
        drop = () if not named and not {"type", "anyOf", "oneOf", "$ref", "enum", "const"} & part.keys() else ("title",)
        mapped = ("discriminator",) if isinstance(part.get("discriminator"), dict) else ()
        return {key: _tidy(value) for key, value in part.items() if key not in (*drop, *mapped)} | _kinds(part)
    if isinstance(part, list):
        return [_tidy(item) for item in part]
    return part.split("\n\n>>> ")[0] if isinstance(part, str) else part


def _table(part: dict[str, Any]) -> dict[str, Any]:
    """A table whose keys are names: any other key is refused."""
    (pattern, entry), *_ = part["patternProperties"].items()
    rest = {key: value for key, value in part.items() if key != "patternProperties"}
    return rest | {"propertyNames": {**part["propertyNames"], "pattern": pattern}, "additionalProperties": entry}


def _kinds(part: dict[str, Any]) -> dict[str, Any]:
    """Store which records a discriminator chooses from."""
    chosen = part.get("discriminator")
    return {"x-kinds": [ref.rpartition("/")[2] for ref in chosen["mapping"].values()]} if isinstance(chosen, dict) else {}


def _unions(part: Any) -> list[list[str]]:
    """Remove the entries that `_kinds` stored."""
    found = []
    if isinstance(part, dict):
        if "x-kinds" in part:
            found.append(part.pop("x-kinds"))
        for value in part.values():
            found += _unions(value)
    elif isinstance(part, list):
        for item in part:
            found += _unions(item)
    return found


def _allow_file(record: dict[str, Any], fields: tuple[str, ...]) -> None:
    record["properties"]["file"] = _FILE
    if fields:
        record["required"] = [name for name in record["required"] if name not in fields]
        record["anyOf"] = [{"required": list(fields)}, {"required": ["file"]}]


def _partial(one: dict[str, Any]) -> dict[str, Any]:
    """An entry in a file on a library model: a whole entry, some of its fields, or null."""
    if "propertyNames" not in one:
        return one
    entry = {"anyOf": [one["additionalProperties"], {"type": ["object", "null"]}]}
    return {key: value for key, value in one.items() if key != "minProperties"} | {"additionalProperties": entry}
