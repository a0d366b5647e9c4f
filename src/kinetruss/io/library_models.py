"""Library models and cells in model files, and the keys of a file that are merged into them."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault, ModelError
from kinetruss.io.part_tables import read_parts
from kinetruss.io.yaml_text import MAX_SIZE
from kinetruss.model import GROUND, Model, Record

if TYPE_CHECKING:
    from kinetruss.library.cells import Cell


AXES = "xyz"


def fields(record: Record) -> dict[str, Any]:
    """The given fields of a record by name, including its kind; values are not converted."""
    names, own = _fields_of(type(record)), record.model_fields_set
    given = {name: getattr(record, name) for name in names if name in own}
    return {"kind": record.kind, **given} if "kind" in names else given  # type: ignore[attr-defined]


@cache
def _fields_of(kind: type[Record]) -> tuple[str, ...]:
    return tuple(kind.model_fields)


def merged(model: Model, over: Mapping[str, Any]) -> dict[str, Any]:
    """Data of `model`, changed by `over`.

    Tables merge name by name and records field by field, to any depth; the value ~ removes an entry. Any other value
    replaces the old one, and so does a record of another kind. A list under ``fixed`` or ``clamped`` adds its nodes.
    """
    over = dict(over)
    fixed = over.get("fixed")
    if isinstance(fixed, list) and all(isinstance(name, str) for name in fixed):
        over["fixed"] = dict.fromkeys(fixed, AXES[: model.dim])
    clamped = over.get("clamped")
    if isinstance(clamped, list) and all(isinstance(name, str) for name in clamped):
        over["clamped"] = dict.fromkeys(clamped, GROUND)
    base = fields(model)
    return base | {key: _laid(base.get(key), value) for key, value in over.items()}


def _laid(base: Any, over: Any) -> Any:
    if not isinstance(over, Mapping) or base is None:
        return over
    if isinstance(base, Record):
        known = fields(base)
        if over.get("kind", known.get("kind")) != known.get("kind"):
            return over
        return known | {key: _laid(known.get(key), value) for key, value in over.items()}
    if isinstance(base, Mapping):
        laid = {**base, **{key: _laid(base.get(key), value) for key, value in over.items()}}
        return {key: value for key, value in laid.items() if value is not None}
    return over


# Library models in model files: a whole model with parameters.


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


def library_parameters(wanted: str | Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Parameters of a library model as a file has them, and the defaults of the others."""
    wanted = {"name": wanted} if isinstance(wanted, str) else wanted
    record = importlib.import_module("kinetruss.library").builders()[wanted["name"]]
    defaults = {
        key: one.get_default(call_default_factory=True) for key, one in record.model_fields.items() if not one.is_required()
    }
    return {key: value for key, value in wanted.items() if key != "name"}, defaults


def _in_library(fault: Fault, name: str) -> Fault:
    """The path of a parameter's fault, below ``library``; the record of the parameters has the function's name."""
    path = fault.path[1:] if fault.path[:1] == (name.rpartition(".")[2],) else fault.path
    return replace(fault, path=("library", *path))


# Cells from tables: in Python, and in model files.


def read_cell(nodes: str | Path, members: str | Path, *, max_size: int = MAX_SIZE, **fittings: Any) -> Cell:
    r"""A cell of `library.cells` from two CSV files.

    Parameters
    ----------
    nodes : columns ``node``, ``x [mm]``, ``y [mm]``[, ``z [mm]``]; optional ``mass [kg]`` and ``face.base``, ``face.top``,
        ``face.NAME``: the number of the node among the corners of that face, else empty.
    members : columns ``member``, ``from``, ``to``; optional ``kind`` (rigid, active, elastic, cable, free), ``section`` and
        ``material`` (names of the library), ``mass [kg]``.
    max_size : bytes; a larger file is refused before it is read. fittings : as of `library.cells.cell`.

    Raises
    ------
    ModelError : all faults of both tables, each with file and line: columns or units that are missing, cells that are no
        number; faults of the cell.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     nodes, members = Path(folder, "nodes.csv"), Path(folder, "members.csv")
    ...     _ = nodes.write_text("node,x [mm],y [mm]\nA,0,0\nB,1000,0\nC,0,800\n")
    ...     _ = members.write_text("member,from,to,kind\nside,A,C,\nbrace,B,C,active\n")
    ...     cell = kt.io.read_cell(nodes, members)
    >>> cell.nodes["C"].at, cell.bars["brace"].kind
    ((0.0, 0.8), 'driven')
    """
    cells = importlib.import_module("kinetruss.library.cells")
    found: Cell = cells.cell(**_joined(read_parts(Path(nodes), Path(members), max_size), fittings))
    return found


def with_parts(value: Any, folder: Path, max_size: int) -> Any:
    """Parameters of a library model; where ``nodes`` and ``bars`` of a cell are paths from the folder, the tables are read."""
    if isinstance(value, list):
        return [with_parts(one, folder, max_size) for one in value]
    if not isinstance(value, Mapping):
        return value
    nodes, bars = value.get("nodes"), value.get("bars")
    if isinstance(nodes, str) and isinstance(bars, str):
        rest = {key: one for key, one in value.items() if key not in ("nodes", "bars")}
        return _joined(read_parts(folder / nodes, folder / bars, max_size), rest)
    return {key: with_parts(one, folder, max_size) for key, one in value.items()}


def _joined(parts: Mapping[str, Any], more: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of a cell: those of its tables, and more faces and active members. What is no table is left to the checks."""
    found = {**parts, **more}
    if isinstance(faces := more.get("faces") or {}, Mapping):
        found["faces"] = {**parts["faces"], **faces}
    given = more.get("active") or {}
    given = [given] if isinstance(given, str) else given
    if isinstance(given, (list, tuple)) and all(isinstance(one, str) for one in given):
        given = {one: {} for one in given}
    if isinstance(given, Mapping):
        found["active"] = {**{name: {} for name in parts["active"]}, **given}
    return found
