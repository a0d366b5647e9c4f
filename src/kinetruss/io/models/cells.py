"""Cells from tables: in Python, and in model files."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.io.formats.text import MAX_SIZE
from kinetruss.io.tables.parts import read_parts

if TYPE_CHECKING:
    from kinetruss.library.cells import Cell

__all__ = ["read_cell", "with_parts"]


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
