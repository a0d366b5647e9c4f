"""The cases as data: ``cases.yaml`` of every group, and the numbers that its functions compute.

A file has `references`, which later groups may use too, each with `class` (a key of `CLAIMS`), `source` and, where
needed, `note` and `inferred`; `exact`, values with which functions compare whole histories; and `cases`, a list of records:

id : of each case; ``{name}`` stands for the name of a value, ``{given}`` for the first argument.
compute : ``module.function`` of the group; given : its arguments; each : first arguments, with cases for each of them.
reference, tolerance : common to all values of the record; scale : see `Case`.
values : name -> expected; or ``[expected, scale]``; or ``{x: .., y: ..}``, components of a vector, whose scale is the largest.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping
from functools import cache
from importlib.resources import files
from typing import Any

import yaml

from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["GROUPS", "cases", "numbers", "stored"]

GROUPS = ("thesis", "drive_trains", "structures", "forward", "solids", "mechanisms", "flexible", "members", "tasks")
_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@cache
def stored(group: str) -> dict[str, Any]:
    """The data file of a group, read once and never changed."""
    text = (files("kinetruss.verification") / group / "cases.yaml").read_text(encoding="utf-8")
    data: dict[str, Any] = yaml.load(text, Loader=_LOADER)
    return data


def cases() -> Iterator[Case]:
    """All cases, before any computation."""
    references: dict[str, Reference] = {}
    for group in GROUPS:
        data = stored(group)
        references |= {
            name: Reference(one["class"], one["source"], one.get("note", ""), tuple(one.get("inferred", ())))
            for name, one in data["references"].items()
        }
        for record in data["cases"]:
            for first in record.get("each", [None]):
                arguments = tuple(record.get("given", ())) if first is None else (first, *record.get("given", ()))
                for name, expected, scale in _values(record["values"], float(record.get("scale", 0))):
                    yield Case(
                        record["id"].format(name=name, given=arguments[0] if arguments else ""),
                        references[record["reference"]],
                        expected,
                        float(record["tolerance"]),
                        f"{group}.{record['compute']}",
                        arguments,
                        name,
                        scale,
                    )


def _values(values: Mapping[str, Any], scale: float) -> Iterator[tuple[str, float, float]]:
    """Name, expected value and scale of each."""
    for name, value in values.items():
        if isinstance(value, dict):
            largest = max(abs(float(one)) for one in value.values())
            yield from ((f"{name}.{part}" if name else part, float(one), largest) for part, one in value.items())
        elif isinstance(value, list):
            yield name, float(value[0]), float(value[1])
        else:
            yield name, float(value), scale


def numbers(make: str, arguments: tuple[Any, ...]) -> dict[str, float]:
    """The results of a function, by dotted names."""
    module, function = make.rsplit(".", 1)
    return dict(_flat(getattr(importlib.import_module(f"kinetruss.verification.{module}"), function)(*arguments)))


def _flat(found: Any, name: str = "") -> Iterator[tuple[str, float]]:
    """Numbers by dotted names; x, y, z are the components of an array."""
    if isinstance(found, Mapping):
        for key, value in found.items():
            yield from _flat(value, f"{name}.{key}" if name else str(key))
    elif getattr(found, "ndim", 0) == 1:
        for axis, value in zip("xyz", found, strict=False):
            yield f"{name}.{axis}" if name else axis, float(value)
    else:
        yield name, float(found)
