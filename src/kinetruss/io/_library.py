"""What a model file takes from the library: a whole model with parameters, and records by name."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from kinetruss.errors import Fault, ModelError
from kinetruss.io._merge import merged
from kinetruss.model import nearest

__all__ = ["TABLES", "filled", "offers", "on_library_model", "with_parameters"]

TABLES = {
    "sections": ("sections", "SECTIONS"),
    "materials": ("materials", "MATERIALS"),
    "screws": ("drives", "SCREWS"),
    "gears": ("drives", "GEARS"),
    "motors": ("drives", "MOTORS"),
    "amplifiers": ("drives", "AMPLIFIERS"),
}
"""Table of a model -> module of the library and its table."""

_FIELDS = {
    "section": "sections", "material": "materials", "screw": "screws", "gear": "gears", "motor": "motors",
    "amplifier": "amplifiers",
}  # fmt: skip


def on_library_model(data: dict[str, Any]) -> dict[str, Any]:
    """The data of a file laid over the library model it names under ``library``.

    Raises
    ------
    ModelError : unknown library model or parameter; paths start with ``library``.
    """
    wanted = data["library"]
    own = {key: value for key, value in data.items() if key != "library"}
    if isinstance(wanted, str):
        wanted = {"name": wanted}
    if not isinstance(wanted, Mapping) or not isinstance(wanted.get("name"), str):
        mend = "Write for example library: {name: vgt.double_octahedral, bays: 3}."
        raise ModelError([Fault(("library",), "names no library model.", mend)])
    library = importlib.import_module("kinetruss.library")
    try:
        model = library.build(wanted["name"], {key: value for key, value in wanted.items() if key != "name"})
    except ModelError as error:
        raise ModelError([_in_library(fault, wanted["name"]) for fault in error.faults]) from None
    return merged(model, own)


def with_parameters(data: dict[str, Any], parameters: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a file with other parameters of its library model; a dotted name leads into a parameter given as a table.

    Raises
    ------
    ModelError : the file names no library model, or the parameter before a dot is no table in it.
    """
    wanted = data.get("library")
    if wanted is None:
        mend = "Set a value of the model itself, e.g. nodes.B.mass."
        raise ModelError([Fault(("library",), "the file names no library model.", mend)])
    changed: dict[str, Any] = {"name": wanted} if isinstance(wanted, str) else dict(wanted)
    for name, value in parameters.items():
        *tables, last = name.split(".")
        here = changed
        for k, table in enumerate(tables):
            if not isinstance(here.get(table), Mapping):
                path = ("library", *tables[: k + 1])
                raise ModelError([Fault(path, "is no table in the file.", f"Set it as a whole: {'.'.join(path)}={{...}}.")])
            here[table] = dict(here[table])
            here = here[table]
        here[last] = value
    return data | {"library": changed}


def _in_library(fault: Fault, name: str) -> Fault:
    """The path of a parameter's fault, below ``library``; the record of the parameters carries the function's name."""
    path = fault.path[1:] if fault.path[:1] == (name.rpartition(".")[2],) else fault.path
    return replace(fault, path=("library", *path))


def filled(data: dict[str, Any]) -> dict[str, Any]:
    """The data with those library records added to its tables that it names and does not have."""
    added: dict[str, dict[str, Any]] = {}
    for table, name in _named(data):
        own = data.get(table, {})
        if isinstance(own, Mapping) and name not in own and name in (shelf := _shelf(table)):
            added.setdefault(table, {})[name] = shelf[name]
    return data | {table: {**data.get(table, {}), **records} for table, records in added.items()}


def offers(fault: Fault, data: Mapping[str, Any]) -> Fault:
    """The fault of a name that is not there, offering the library's names too."""
    if len(fault.about) != 1 or fault.about[0][0] not in TABLES or not fault.message.startswith("no "):
        return fault
    table, name = fault.about[0]
    own = data.get(table)
    return replace(fault, mend=nearest(name, [*(own if isinstance(own, Mapping) else ()), *_shelf(table)]))


def _shelf(table: str) -> Mapping[str, Any]:
    module, shelf = TABLES[table]
    found: Mapping[str, Any] = getattr(importlib.import_module(f"kinetruss.library.{module}"), shelf)
    return found


def _named(data: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Table and name of every record that the data name."""
    for part in _parts(data):
        for field, table in _FIELDS.items():
            name = part.get(field) if isinstance(part, Mapping) else getattr(part, field, None)
            if isinstance(name, str):
                yield table, name


def _parts(data: Mapping[str, Any]) -> Iterator[Any]:
    """Whatever may name a section, a material or a part of a drive train."""
    yield data
    for table in ("bars", "active", "drives"):
        members = data.get(table)
        for member in members.values() if isinstance(members, Mapping) else ():
            yield member
            for side in ("base", "tube"):
                part = member.get(side) if isinstance(member, Mapping) else getattr(member, side, None)
                if part is not None:
                    yield part
