"""Missions and catalogues from files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

from kinetruss.errors import Fault, ModelError
from kinetruss.io.records import of_table, record_of_file
from kinetruss.io.yaml_text import MAX_SIZE, Tree, plain
from kinetruss.model import Catalogue, Gear, Mission, Model, Motor, Of, ScrewStock, TubeStock, mission_faults, of_file
from kinetruss.units import NUMBER, unit_of

_TABLES: dict[str, Any] = {"tubes": TubeStock, "screws": ScrewStock, "gears": Gear, "motors": Motor}
_EXAMPLES = {"m": "25 mm", "m/rad": "3 mm/rev", "rad": "15 deg", "rad/s": "3000 rpm", "kg m^2": "6.76e-6 kg m^2"}


def read_catalogue(path: str | Path, *, max_size: int = MAX_SIZE) -> Catalogue:
    r"""Read a catalogue of tubes, lead screws, gears or motors from a YAML or JSON file.

    A quantity needs its unit here: printed catalogues use millimetres and inches, and a bare 25 would be read as metres.

    Returns
    -------
    Catalogue, with its material as a record.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "tubes.yaml")
    ...     _ = file.write_text("source: our stock\nmaterial: steel_s235\ntubes: {20x2: {outer: 20 mm, wall: 2 mm}}\n")
    ...     catalogue = kt.io.read_catalogue(file)
    >>> catalogue.tubes["20x2"].outer, catalogue.material.E
    (0.02, 210000000000.0)
    """
    start = "Start with title and source, then tubes, screws, gears or motors."
    try:
        return of_table(Path(path), _catalogue, start, max_size)
    except ModelError as error:
        raise ModelError([replace(fault, file=error.source) for fault in error.faults], error.source) from None


def _catalogue(tree: Tree, faults: list[Fault]) -> Catalogue:
    data = plain(tree)
    found = [*faults, *_unitless(data)]
    try:
        with of_file():
            catalogue = Catalogue(**data)
    except ModelError as error:
        accused = {fault.path[:2] for fault in found}
        found += [fault for fault in error.faults if fault.path[:2] not in accused]
    if found:
        raise ModelError(found)
    return catalogue


def _unitless(data: Mapping[str, Any]) -> Iterator[Fault]:
    """Faults of numbers without a unit; zero needs none."""
    for table, record in _TABLES.items():
        entries = data.get(table)
        for name, entry in entries.items() if isinstance(entries, Mapping) else ():
            for field, value in entry.items() if isinstance(entry, Mapping) else ():
                unit = _unit(record, field)
                bare = isinstance(value, (int, float)) or (isinstance(value, str) and NUMBER.fullmatch(value.strip()))
                if unit and bare and not isinstance(value, bool) and float(value) != 0:
                    example = _EXAMPLES.get(unit, f"{value} {unit}")
                    yield Fault((table, name, field), f"{value} has no unit.", f"Write for example '{example}'.")


def _unit(record: Any, field: str) -> str:
    """SI unit of a field; empty if it has none."""
    if field not in record.model_fields:
        return ""
    info = record.model_fields[field]
    metadata = [*info.metadata, *(one for part in get_args(info.annotation) for one in getattr(part, "__metadata__", ()))]
    return next((unit_of(one.quantity) for one in metadata if isinstance(one, Of)), "")


# A mission from a file.

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

    def build(data: dict[str, Any]) -> Mission:
        mission = Mission(**_rebased(data, path.parent))
        if model is not None and (found := mission_faults(model, mission)):
            raise ModelError(found)
        return mission

    start = "Start with kinetruss_mission: 1, then runs, groups, catalogues."
    return record_of_file(path, build, start, "a mission", {"model": "Name the model first, then the mission."}, max_size)


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
