"""A mission from a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from kinetruss.errors import ModelError
from kinetruss.io.formats.text import MAX_SIZE, read_text
from kinetruss.io.formats.tree import Tree, locate, plain, refuse
from kinetruss.io.formats.yaml import parse
from kinetruss.model import Mission, Model, mission_faults, of_file

__all__ = ["read_mission"]

CATALOGUES = (".yaml", ".yml", ".json", ".toml")
"""Suffixes that distinguish a catalogue file from a name; the last one is refused with a fix."""


def read_mission(path: str | Path, model: Model | None = None, *, max_size: int = MAX_SIZE) -> Mission:
    """Read a mission from a YAML or JSON file; paths of catalogues are relative to it.

    Parameters
    ----------
    model : if given, names of runs, load cases and members are checked against it.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model, mission = kt.library.example_files()["double_octahedral_slew"][:2]
    >>> kt.io.read_mission(mission, kt.read(model)).groups["battens"].members
    ('M19', 'M20', 'M21')
    """
    path = Path(path)
    try:
        tree = _parsed(path, max_size)
        try:
            with of_file():
                mission = Mission(**_rebased(plain(tree), path.parent))
            if model is not None and (found := mission_faults(model, mission)):
                raise ModelError(found)
        except ModelError as error:
            located = [locate(fault, tree) for fault in error.faults]
            raise ModelError(sorted(located, key=lambda fault: (fault.line or 0, fault.column or 0))) from None
    except ModelError as error:
        raise ModelError(error.faults, str(path)) from None
    return mission


def _parsed(path: Path, max_size: int) -> Tree:
    tree, faults = parse(path, read_text(path, max_size))
    start = "Start with kinetruss_mission: 1, then runs, groups, catalogues."
    if tree is None:
        raise refuse("is empty.", start, (1, 1))
    if tree.table is None:
        raise refuse("is not a table of names.", start, tree.place)
    if model_keys := [key for key in ("kinetruss", "library", "nodes") if key in tree.table]:
        place = (tree.keys or {}).get(model_keys[0])
        raise refuse("is a model, not a mission.", f"Name the model first, then the mission. {start}", place, (model_keys[0],))
    if faults:
        raise ModelError(faults)
    return tree


def _rebased(data: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Paths of catalogue files relative to the working folder; names of built-in catalogues do not change."""
    found = dict(data)
    if isinstance(found.get("catalogues"), dict):
        found["catalogues"] = {key: _file(value, folder) for key, value in found["catalogues"].items()}
    if isinstance(found.get("groups"), dict):
        found["groups"] = {
            key: value | {"tubes": _file(value["tubes"], folder)} if isinstance(value, dict) and "tubes" in value else value
            for key, value in found["groups"].items()
        }
    return found


def _file(value: Any, folder: Path) -> Any:
    return str(folder / value) if isinstance(value, str) and value.endswith(CATALOGUES) else value
