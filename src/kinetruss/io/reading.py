"""A model from a file, with the files that it names."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from statistics import median
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError, UnitError, shown
from kinetruss.io.csv_tables import Table, read_table
from kinetruss.io.earlier import without_inner_parts
from kinetruss.io.histories import measured_columns, read_measured_table
from kinetruss.io.library_models import library_parameters, on_library_model
from kinetruss.io.records import in_order, of_table, table_of
from kinetruss.io.yaml_text import MAX_SIZE, Tree, locate, plain, refuse
from kinetruss.model import FORMAT, Lost, Model, of_file, rests_on
from kinetruss.model.recipes import Recipe
from kinetruss.units import Tagged, parse as quantity

Place = tuple[str, ...]
Reader = Callable[[Path, Mapping[str, Any], int], dict[str, Any]]
START = "Start with kinetruss: 1, then nodes, bars, ...; `kinetruss examples` shows some."
"""How a model file starts."""


class Reading:
    """The data of a model file while its other files are read; collects removed entries and their faults."""

    def __init__(self, data: dict[str, Any], folder: Path, max_size: int) -> None:
        self.data = data
        self.folder = folder
        self.max_size = max_size
        self.faults: list[Fault] = []
        self.lost: list[Place] = []
        self.tables: dict[Any, dict[str, Any]] = {}
        """Contents of files that were read, by what was read of them."""

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
    readers: dict[str, Reader] = {"trajectories": _tabulated, "loads": _forces, "support_motion": _displacements}
    for kind, read_one in readers.items():
        for name, entry in reading.entries(kind):
            if "file" in entry:
                reading.put(kind, name, _from_file(reading, (kind, name), entry, read_one))
    for name, entry in reading.entries("runs"):
        inline = entry.get("trajectory")
        if isinstance(inline, Mapping) and "file" in inline:
            table = _from_file(reading, ("runs", name, "trajectory"), inline, _tabulated)
            reading.put("runs", name, None if table is None else {**entry, "trajectory": table})
        if isinstance(entry.get("motion"), str):
            _motion(reading, name, entry)


def _from_file(reading: Reading, path: Place, entry: Mapping[str, Any], read: Reader) -> dict[str, Any] | None:
    """The entry with the contents of its file, or None after reporting the faults of the file."""
    file = entry["file"]
    rest = {key: value for key, value in entry.items() if key != "file"}
    if not isinstance(file, str):
        reading.faults.append(Fault((*path, "file"), "does not name a file.", "Write for example file: table.csv."))
        return None
    what = (file, read, str(entry.get("kind")), str(entry.get("largest_gap")))
    try:
        if what not in reading.tables:
            reading.tables[what] = read(reading.folder / file, rest, reading.max_size)
        return rest | reading.tables[what]
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
        largest = quantity(largest, "number")
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


def _vectors(quantity: str, field: str, path: Path, _entry: Mapping[str, Any], max_size: int) -> dict[str, Any]:
    """Columns x, y and perhaps z (or fx, fy, fz) as a list of vectors."""
    names = {"x": "x", "y": "y", "z": "z"} | ({"fx": "x", "fy": "y", "fz": "z"} if quantity == "force" else {})
    table = read_table(path, lambda name: quantity if name in names else None, max_size=max_size)
    found = {names[name]: column.values for name, column in table.columns.items()}
    if missing := [axis for axis in "xy" if axis not in found]:
        raise ModelError([table.fault(f"column {missing[0]!r} is missing.", "Give columns t, x, y and, in space, z.")])
    columns = [found[axis].tolist() for axis in "xyz" if axis in found]
    return {"times": table.times.tolist(), field: [list(row) for row in zip(*columns, strict=True)]}


_forces, _displacements = partial(_vectors, "force", "forces"), partial(_vectors, "length", "displacements")


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


# A model from a file.


def read(path: str | Path, *, max_size: int = MAX_SIZE) -> Model:
    r"""Read a model from a YAML or JSON file.

    Every scalar of a YAML file is text, so ``no`` and ``12:30`` are names like any other; quantities are read with their
    units. ``library: {name: vgt.double_octahedral, bays: 3}`` starts from a library model, which the other keys change name by
    name. Sections, materials, screws, gears and motors that are named but not defined come from the library. ``file:
    table.csv`` in a trajectory (kind spline), a load or a support motion is replaced by the table; paths are relative to the
    model file.

    Parameters
    ----------
    path : file; ``.json`` is read as JSON, anything else as YAML.
    max_size : bytes; a larger file is not read.

    Returns
    -------
    Model, with all runs of the file.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "model.yaml")
    ...     _ = file.write_text("nodes: {A: [0, 0], B: [500 mm, 0]}\nfixed: [A]\nbars: {arm: [A, B]}\nkinetruss: 1\n")
    ...     model = kt.read(file)
    >>> model.nodes["B"].at
    (0.5, 0.0)
    """
    if isinstance(path, Mapping):
        raise InputError("A mapping is no file. Make the model of it: kt.Model(**data).")
    folder = Path(path).parent
    return of_table(Path(path), lambda tree, faults: model_of(plain(tree), faults, folder, max_size), START, max_size, _located)


def placed(path: str | Path, faults: list[Fault], *, max_size: int = MAX_SIZE) -> list[Fault]:
    r"""Faults of the model in a file, with line and column, in the order of the file.

    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> fault = kt.Fault(("bars", "b"), "is too long.", "Shorten it.")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "model.yaml")
    ...     _ = file.write_text("nodes: {A: [0, 0]}\nbars:\n  b: [A, B]\n")
    ...     found = kt.io.placed(file, [fault])
    >>> found[0].line, found[0].column
    (3, 3)
    """
    if not faults:
        return faults
    tree, _ = table_of(Path(path), START, max_size)
    return in_order(_located(fault, tree) for fault in faults)


def model_of(data: dict[str, Any], faults: list[Fault], folder: Path, max_size: int) -> Model:
    """The model of the data, or all its faults after those found already."""
    if data.get("kinetruss", FORMAT) not in (FORMAT, str(FORMAT)):
        # another format: nothing else in the file can be checked
        mend = f"This release reads kinetruss: {FORMAT}."
        raise refuse(f"format version {shown(data['kinetruss'])} is not known here.", mend, path=("kinetruss",))
    lost, file = Lost(), data
    if "library" in data:
        try:
            data = on_library_model(data, folder, max_size)
        except ModelError as error:
            faults = faults + error.faults
            data = {key: value for key, value in data.items() if key != "library"}
            lost.add(())  # all names that may be referred to
    reading = Reading(without_inner_parts(data), folder, max_size)
    with_files(reading)
    faults = faults + reading.faults
    for place in reading.lost:
        lost.add(place)
    try:
        with of_file():
            model = Model(**reading.data)
    except ModelError as error:
        own = [fault for fault in error.faults if not rests_on(fault, lost)]
        if () in lost:
            own = [fault for fault in own if fault.path != ("nodes",)]
        raise ModelError(faults + own) from None
    if faults:
        raise ModelError(faults)
    if "library" not in file:
        return model
    parameters, defaults = library_parameters(file["library"])
    return Recipe("library", partial(_rebuilt, file, folder, max_size), parameters, defaults).noted(model)


def _rebuilt(file: dict[str, Any], folder: Path, max_size: int, parameters: Mapping[str, Any]) -> Model:
    """The model of the data of a file with other parameters of its library model."""
    wanted = file["library"]
    name = wanted if isinstance(wanted, str) else wanted["name"]
    return model_of(file | {"library": {"name": name, **parameters}}, [], folder, max_size)


def _located(fault: Fault, tree: Tree) -> Fault:
    """A fault in library data, located at the entry that names the library."""
    if fault.path and tree.table is not None and str(fault.path[0]) not in tree.table and "library" in tree.table:
        line, column = tree.keys["library"]  # type: ignore[index]
        return fault if fault.line is not None else replace(fault, line=line, column=column)
    return locate(fault, tree)
