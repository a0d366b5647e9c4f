"""Nodes and members of a cell from two CSV files.

Nodes: ``node``, ``x [mm]``, ``y [mm]``[, ``z [mm]``], then if wanted ``mass [kg]`` and ``face.NAME``: the number of the node
among the corners of a face, empty for other nodes. Members: ``member``, ``from``, ``to``, then if wanted ``kind`` (rigid,
driven, active, elastic, cable, free), ``section``, ``material``, ``mass [kg]``. Lengths and masses have units in the header.
Columns stand in any order. Cells are separated by commas, semicolons or tabs, as the header says; with semicolons and tabs
numbers may have decimal commas.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from kinetruss.display import counted
from kinetruss.errors import Fault, ModelError, UnitError, shown
from kinetruss.io.yaml_text import MAX_SIZE, read_text
from kinetruss.model import nearest
from kinetruss.units import parse, unit_of

_HEADER = re.compile(r"(.*?)\s*(?:\[(.*)\]|\((.*)\))?")
_LINE = re.compile(r"\r\n|\r|\n")
_NODES = {"x": "length", "y": "length", "z": "length", "mass": "mass"}
_MEMBERS = {"mass": "mass"}
_KINDS = ("rigid", "driven", "active", "elastic", "cable", "free")
_MOST = 20


def _blank(line: str) -> bool:
    """True of a line between rows that is empty or a comment."""
    return not line.strip() or line.lstrip().startswith("#")


class _Sheet:
    """A CSV file of names: cells as text by column, faults collected."""

    def __init__(
        self, path: Path, max_size: int, columns: tuple[str, ...], more: tuple[str, ...], units: Mapping[str, str]
    ) -> None:
        self.path, self.units = str(path), units
        self.faults: list[Fault] = []
        self.rows: list[tuple[int, dict[str, str]]] = []
        try:
            text = read_text(path, max_size)
        except ModelError as error:
            raise ModelError([replace(fault, file=self.path) for fault in error.faults]) from None
        self.unit: dict[str, str] = {}
        self._between = ","
        rows = list(self._split(text))
        head = self._head(rows[0][0], rows[0][2], columns, more) if rows else []
        if len(rows) < 2 and not self.faults:
            line = rows[0][0] if rows else 1
            self.fault("has no rows.", f"Give a header ({', '.join(columns)}) and one row for each.", line)
        for number, last, cells in rows[1:]:
            if len(cells) != len(head):
                mend = "Give one cell per column. (A decimal comma splits a number in two; then use semicolons between cells.)"
                if last > number:
                    mend = f"A quote that opens here is closed in line {last}, or nowhere: close it where its cell ends."
                self.fault(f"has {counted(len(cells), 'cell')}; the header has {len(head)}.", mend, number)
            else:
                self.rows.append((number, dict(zip(head, cells, strict=True))))

    def _split(self, text: str) -> Iterator[tuple[int, int, list[str]]]:
        """First line, last line and cells of each row; comments and empty lines between rows are none."""
        lines = _LINE.split(text)
        header = next((line for line in lines if not _blank(line)), "")
        self._between = next((mark for mark in ";\t" if mark in header), ",")
        number, first = 0, 0  # the line that is read; that where the row began, 0 between rows

        def read() -> Iterator[str]:
            nonlocal number, first
            for number, line in enumerate(lines, start=1):
                if first or not _blank(line):
                    first = first or number
                    yield line + "\n"

        reader = csv.reader(read(), delimiter=self._between)
        while True:
            first = 0
            try:
                cells = next(reader)
            except StopIteration:
                return
            except csv.Error as error:
                long = "field larger" in str(error)
                said = f"a cell has more than {csv.field_size_limit():,} characters." if long else f"cannot be read: {error}."
                self.fault(said, "Shorten the cell, or close the quote that opens in it.", first or number)
                return
            yield first, number, [cell.strip() for cell in cells]

    def fault(self, message: str, mend: str, line: int) -> None:
        """Collect a fault of a line."""
        if len(self.faults) < _MOST:
            self.faults.append(Fault((), message, mend, line, 1, file=self.path))

    def value(self, line: int, row: Mapping[str, str], name: str) -> str:
        """A quantity as text with the unit of its column, checked."""
        number = row[name]
        if self._between != "," and number.count(",") == 1 and "." not in number:
            number = number.replace(",", ".")
        text = f"{number} {self.unit.get(name, '')}".strip()
        try:
            parse(text, self.units[name])
        except UnitError:
            self.fault(f"{shown(row[name])} is not a number, in column {shown(name)}.", "Give a number.", line)
        return text

    def _head(self, number: int, cells: list[str], columns: tuple[str, ...], more: tuple[str, ...]) -> list[str]:
        found = []
        for text in cells:
            match = _HEADER.fullmatch(text)
            name, unit = (match[1], match[2] or match[3]) if match else (text, None)
            known = (*columns, *more)
            name = name.lower() if name.lower() in known else name
            if name not in known and not (name.startswith("face.") and "face.base" in more):
                self.fault(f"column {shown(name)} is not known here.", nearest(name, known), number)
            elif name in found:
                self.fault(f"column {shown(name)} is given twice.", "Rename one, or remove it.", number)
            if quantity := self.units.get(name):
                self._unit(name, unit, quantity, number)
            found.append(name)
        for name in columns:
            if name not in found:
                self.fault(
                    f"column {shown(name)} is missing.", f"Add it; the header starts with: {', '.join(columns)}.", number
                )
        return found

    def _unit(self, name: str, unit: str | None, quantity: str, number: int) -> None:
        example = unit_of(quantity)
        if unit is None:
            self.fault(f"column {shown(name)} has no unit.", f"Write it in the header, e.g. {name} [{example}].", number)
            return
        try:
            parse(f"1 {unit}", quantity)
            self.unit[name] = unit
        except UnitError:
            self.fault(
                f"column {shown(name)} has the unit [{unit}], no unit of {quantity}.", f"Write e.g. [{example}].", number
            )


def read_parts(nodes: Path, members: Path, max_size: int = MAX_SIZE) -> dict[str, Any]:
    """Parameters ``nodes``, ``bars``, ``faces``, ``active`` of `library.cells.cell` from two tables.

    Raises
    ------
    ModelError : all faults of both tables, each with file and line.
    """
    first = _Sheet(nodes, max_size, ("node", "x", "y"), ("z", "mass", "face.base", "face.top"), _NODES)
    second = _Sheet(members, max_size, ("member", "from", "to"), ("kind", "section", "material", "mass"), _MEMBERS)
    if not first.faults:
        places, faces = _nodes(first)
    if not second.faults:
        bars, active = _members(second)
    if faults := first.faults + second.faults:
        raise ModelError(faults)
    return {"nodes": places, "bars": bars, "faces": faces, "active": active}


def _nodes(sheet: _Sheet) -> tuple[dict[str, Any], dict[str, list[str]]]:
    found: dict[str, Any] = {}
    corners: dict[str, dict[int, str]] = {}
    for line, row in sheet.rows:
        name = row["node"]
        _new(sheet, line, name, found, "node")
        found[name] = {"at": [sheet.value(line, row, axis) for axis in "xyz" if axis in row]}
        if row.get("mass"):
            found[name]["mass"] = sheet.value(line, row, "mass")
        for column, text in row.items():
            if column.startswith("face.") and text:
                face = corners.setdefault(column.removeprefix("face."), {})
                if not (text.isdecimal() and len(text) < 10) or int(text) in face:
                    sheet.fault(
                        f"{shown(text)} is no free number of a corner, in column {column}.", "Number the corners 1, 2, 3.", line
                    )
                else:
                    face[int(text)] = name
    return found, {face: [known[k] for k in sorted(known)] for face, known in corners.items()}


def _members(sheet: _Sheet) -> tuple[dict[str, Any], list[str]]:
    found: dict[str, Any] = {}
    active = []
    for line, row in sheet.rows:
        name, kind = row["member"], row.get("kind") or "rigid"
        _new(sheet, line, name, found, "member")
        if kind not in _KINDS:
            sheet.fault(f"kind {shown(kind)} is not known.", nearest(kind, _KINDS), line)
        if kind in ("active", "driven"):
            active.append(name)
        found[name] = {"ends": [row["from"], row["to"]]} | ({} if kind in ("rigid", "active", "driven") else {"kind": kind})
        found[name] |= {key: row[key] for key in ("section", "material") if row.get(key)}
        if row.get("mass"):
            found[name]["mass"] = sheet.value(line, row, "mass")
    return found, active


def _new(sheet: _Sheet, line: int, name: str, found: Mapping[str, Any], what: str) -> None:
    if not name or name in found:
        sheet.fault(f"{shown(name)} is no new name of a {what}.", "Give every row a name of its own.", line)
