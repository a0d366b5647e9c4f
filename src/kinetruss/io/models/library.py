"""Library models in model files: a whole model with parameters."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from kinetruss.errors import Fault, ModelError
from kinetruss.io.models.cells import with_parts
from kinetruss.io.models.merge import merged

__all__ = ["on_library_model", "with_parameters"]


def on_library_model(data: dict[str, Any], folder: Path, max_size: int) -> dict[str, Any]:
    """The data of the library model named under ``library``, changed by the data of the file.

    folder : of the file, where the tables of its cells are. max_size : of a table, bytes.

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
        raise ModelError([Fault(("library",), "does not name a library model.", mend)])
    library = importlib.import_module("kinetruss.library")
    try:
        given = with_parts({key: value for key, value in wanted.items() if key != "name"}, folder, max_size)
        model = library.build(wanted["name"], given)
    except ModelError as error:
        raise ModelError([_in_library(fault, wanted["name"]) for fault in error.faults]) from None
    return merged(model, own)


def with_parameters(data: dict[str, Any], parameters: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a file with other parameters of its library model; a dotted name is a path into a parameter given as a table.

    Raises
    ------
    ModelError : the file names no library model, or the parameter before a dot is not a table in it.
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
                raise ModelError([Fault(path, "is not a table in the file.", f"Set it as a whole: {'.'.join(path)}={{...}}.")])
            here[table] = dict(here[table])
            here = here[table]
        here[last] = value
    return data | {"library": changed}


def _in_library(fault: Fault, name: str) -> Fault:
    """The path of a parameter's fault, below ``library``; the record of the parameters has the function's name."""
    path = fault.path[1:] if fault.path[:1] == (name.rpartition(".")[2],) else fault.path
    return replace(fault, path=("library", *path))
