"""A model from a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError, shown
from kinetruss.io.formats.text import MAX_SIZE, read_text
from kinetruss.io.formats.tree import Tree, locate, plain, refuse
from kinetruss.io.formats.yaml import parse
from kinetruss.io.models.files import Reading, with_files
from kinetruss.io.models.library import on_library_model, with_parameters
from kinetruss.model import FORMAT, Lost, Model, of_file, rests_on

__all__ = ["model_of", "placed", "read"]


def read(path: str | Path, *, max_size: int = MAX_SIZE, library: Mapping[str, Any] | None = None) -> Model:
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
    library : parameters of the library model that replace those of the file, e.g. ``{"payload_mass": "40 kg"}``.

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
    path = Path(path)
    try:
        tree, faults = _parsed(path, max_size)
        try:
            data = plain(tree) if not library else with_parameters(plain(tree), library)
            return model_of(data, faults, path.parent, max_size)
        except ModelError as error:
            raise ModelError(_sorted([_located(fault, tree) for fault in error.faults])) from None
    except ModelError as error:
        raise ModelError(error.faults, str(path)) from None


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
    tree, _ = _parsed(Path(path), max_size)
    return _sorted([_located(fault, tree) for fault in faults])


def _parsed(path: Path, max_size: int) -> tuple[Tree, list[Fault]]:
    tree, faults = parse(path, read_text(path, max_size))
    start = "Start with kinetruss: 1, then nodes, bars, ...; `kinetruss examples` shows some."
    if tree is None:
        raise refuse("is empty.", start, (1, 1))
    if tree.table is None:
        raise refuse("is not a table of names.", start, tree.place)
    return tree, faults


def model_of(data: dict[str, Any], faults: list[Fault], folder: Path, max_size: int) -> Model:
    """The model of the data, or all its faults after those found already."""
    if data.get("kinetruss", FORMAT) not in (FORMAT, str(FORMAT)):
        # another format: nothing else in the file can be checked
        mend = f"This release reads kinetruss: {FORMAT}."
        raise refuse(f"format version {shown(data['kinetruss'])} is not known here.", mend, path=("kinetruss",))
    lost = Lost()
    if "library" in data:
        try:
            data = on_library_model(data, folder, max_size)
        except ModelError as error:
            faults = faults + error.faults
            data = {key: value for key, value in data.items() if key != "library"}
            lost.add(())  # all names that may be referred to
    reading = Reading(data, folder, max_size)
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
    return model


def _located(fault: Fault, tree: Tree) -> Fault:
    """A fault in library data, located at the entry that names the library."""
    if fault.path and tree.table is not None and str(fault.path[0]) not in tree.table and "library" in tree.table:
        line, column = tree.keys["library"]  # type: ignore[index]
        return fault if fault.line is not None else replace(fault, line=line, column=column)
    return locate(fault, tree)


def _sorted(faults: list[Fault]) -> list[Fault]:
    """Faults in the order of the file; faults of other files last."""
    return sorted(faults, key=lambda fault: (fault.file or "", fault.line or 0, fault.column or 0))
