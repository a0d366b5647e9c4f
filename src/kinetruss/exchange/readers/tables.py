"""A model from two CSV files: nodes and members."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.exchange._imported import Imported
from kinetruss.exchange.readers.trusses import held
from kinetruss.exchange.robots import LeftOut
from kinetruss.io.tables import read_parts
from kinetruss.model import Model

__all__ = ["tables"]


def tables(path: Path, *, max_size: int, members: str | Path | None = None, fixed: Sequence[str] = ()) -> Imported:
    """The model of a table of nodes (``node, x [mm], y [mm], z [mm], mass [kg]``) and one of members (``member, from, to, kind,
    section, material, mass [kg]``), as `io.read_cell` reads them. fixed : names of nodes, with the axes if not all: ``E:y``.
    """
    if members is None:
        raise InputError(f"{path} holds the nodes. Name the table of members too: --members FILE (members=...).")
    parts: dict[str, Any] = read_parts(path, Path(members), max_size)
    bars = {name: bar | ({"kind": "driven"} if name in parts["active"] else {}) for name, bar in parts["bars"].items()}
    model = Model(nodes=parts["nodes"], bars=bars, fixed=_supports(fixed, parts["nodes"], str(path)))
    left = [LeftOut("face", f"{path}: face.{name}", "faces belong to cells of the library") for name in parts["faces"]]
    return Imported(model=model, source=str(path), left_out=left)


def _supports(fixed: Sequence[str], nodes: Mapping[str, Any], source: str) -> dict[str, str]:
    """Axes in which nodes are held: all, or those after a colon."""
    every = "xyz"[: len(next(iter(nodes.values()))["at"])] if nodes else ""
    found: dict[str, str] = {}
    for text in fixed:
        name, colon, axes = text.rpartition(":")
        if not colon or not axes or set(axes) - set(every) or text in nodes:
            name, axes = text, every
        found |= dict.fromkeys(held([name], nodes, source), axes)
    return found
