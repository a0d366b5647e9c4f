"""Files named in a model file: tables of trajectories, forces and supports, and motions."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from statistics import median
from typing import Any

from kinetruss.errors import Fault, ModelError, UnitError
from kinetruss.io.tables.measured import measured_columns, read_measured_table
from kinetruss.io.tables.table import Table, read_table
from kinetruss.units import Tagged, parse

__all__ = ["Reading", "with_files"]

Place = tuple[str, ...]
Reader = Callable[[Path, Mapping[str, Any], int], dict[str, Any]]


class Reading:
    """The data of a model file while its other files are read; collects removed entries and their faults."""

    def __init__(self, data: dict[str, Any], folder: Path, max_size: int) -> None:
        self.data = data
        self.folder = folder
        self.max_size = max_size
        self.faults: list[Fault] = []
        self.lost: list[Place] = []

    def entries(self, table: str) -> list[tuple[str, Any]]:
        """The entries of one table that are themselves tables."""
        found = self.data.get(table)
        entries = found.items() if isinstance(found, Mapping) else ()
        return [(key, value) for key, value in entries if isinstance(value, Mapping)]

    def put(self, table: str, name: str, entry: Any) -> None:
        """Replace an entry; None removes it."""
        rest = dict(self.data[table])
        if entry is None:
            del rest[name]
            self.lost.append((table, name))
        else:
            rest[name] = entry
        self.data = self.data | {table: rest}


def with_files(reading: Reading) -> None:
    """Replace ``file:`` by the table; entries with a faulty table are removed and reported."""
    for name, entry in reading.entries("trajectories"):
        _put(reading, ("trajectories", name), entry, _tabulated)
    for name, entry in reading.entries("loads"):
        _put(reading, ("loads", name), entry, _forces)
    for name, entry in reading.entries("support_motion"):
        _put(reading, ("support_motion", name), entry, _displacements)
    for name, entry in reading.entries("runs"):
        inline = entry.get("trajectory")
        if isinstance(inline, Mapping) and "file" in inline:
            table = _from_file(reading, ("runs", name, "trajectory"), inline, _tabulated)
            reading.put("runs", name, None if table is None else {**entry, "trajectory": table})
        if isinstance(entry.get("motion"), str):
            _motion(reading, name, entry)


def _put(reading: Reading, path: tuple[str, str], entry: Mapping[str, Any], read: Reader) -> None:
    if "file" in entry:
        reading.put(*path, _from_file(reading, path, entry, read))


def _from_file(reading: Reading, path: Place, entry: Mapping[str, Any], read: Reader) -> dict[str, Any] | None:
    """The entry with the contents of its file, or None after reporting the faults of the file."""
    file = entry["file"]
    rest = {key: value for key, value in entry.items() if key != "file"}
    if not isinstance(file, str):
        reading.faults.append(Fault((*path, "file"), "does not name a file.", "Write for example file: table.csv."))
        return None
    try:
        return rest | read(reading.folder / file, rest, reading.max_size)
    except ModelError as error:
        reading.faults += [_named(fault, path, file) for fault in error.faults]
        return None


def _named(fault: Fault, path: Place, file: str) -> Fault:
    """A fault of a table under the path of the entry; a missing table is a fault of the entry."""
    if fault.line is None:
        return Fault((*path, "file"), f"{file} cannot be used: {fault.message}", fault.mend)
    return replace(fault, path=(*path, *fault.path))


def _tabulated(path: Path, entry: Mapping[str, Any], max_size: int) -> dict[str, Any]:
    if entry.get("kind") == "measured":
        table = read_measured_table(path, max_size)
        columns = measured_columns(table)
        if faults := _gaps(table, entry.get("largest_gap", 10.0)):
            raise ModelError(faults)
        return {"times": table.times.tolist(), **columns}
    table = read_table(path, lambda _: "coordinate", max_size=max_size, least_rows=4)
    if faults := _gaps(table, entry.get("largest_gap", 10.0)):
        raise ModelError(faults)
    values = {name: [Tagged(v, one.quantity) for v in one.values.tolist()] for name, one in table.columns.items()}
    return {"times": table.times.tolist(), "values": values}


def _gaps(table: Table, largest: Any) -> list[Fault]:
    """Pauses longer than `largest` times the median step."""
    if not table.columns:
        return [table.fault("has no column but t.", "Give one column for each moving coordinate.")]
    try:
        largest = parse(largest, "number")
    except UnitError:
        return []  # reported with the other fields
    steps = [b - a for a, b in pairwise(table.times.tolist())]
    usual = median(steps)
    mend = "Fill it, or raise largest_gap if the gap is intended."
    return [
        table.fault(f"gap of {step:g} s before this row; the median step is {usual:g} s.", mend, line)
        for step, line in zip(steps, table.lines[1:], strict=True)
        if step > largest * usual
    ]


def _forces(path: Path, entry: Mapping[str, Any], max_size: int) -> dict[str, Any]:
    del entry
    return _vectors(path, "force", "forces", max_size)


def _displacements(path: Path, entry: Mapping[str, Any], max_size: int) -> dict[str, Any]:
    del entry
    return _vectors(path, "length", "displacements", max_size)


def _vectors(path: Path, quantity: str, field: str, max_size: int) -> dict[str, Any]:
    """Columns x, y and perhaps z (or fx, fy, fz) as a list of vectors."""
    names = {"x": "x", "y": "y", "z": "z"} | ({"fx": "x", "fy": "y", "fz": "z"} if quantity == "force" else {})
    table = read_table(path, lambda name: quantity if name in names else None, max_size=max_size)
    found = {names[name]: column.values for name, column in table.columns.items()}
    if missing := [axis for axis in "xy" if axis not in found]:
        raise ModelError([table.fault(f"column {missing[0]!r} is missing.", "Give columns t, x, y and, in space, z.")])
    columns = [found[axis].tolist() for axis in "xyz" if axis in found]
    return {"times": table.times.tolist(), field: [list(row) for row in zip(*columns, strict=True)]}


def _motion(reading: Reading, name: str, entry: Mapping[str, Any]) -> None:
    """A relative path in the file is relative to the model file; in the model it is relative to the working folder."""
    given = Path(entry["motion"])
    path = given if given.is_absolute() else Path(os.path.normpath(reading.folder / given))
    if not given.is_absolute() and path.is_absolute() and path.is_relative_to(Path.cwd()):
        path = path.relative_to(Path.cwd())
    reading.put("runs", name, {**entry, "motion": str(path)})
    if not path.is_file():
        mend = "Name a node-history CSV; the path is relative to the model file."
        reading.faults.append(Fault(("runs", name, "motion"), f"there is no file {str(given)!r}.", mend))
