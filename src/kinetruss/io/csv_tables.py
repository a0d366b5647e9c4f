"""Tables in CSV files: a header, then one row per instant.

The first column is ``t`` (or ``time``), s. A header may carry a unit, ``M7 [mm]``; without one the column is SI. Columns are
separated by commas, numbers have decimal points; empty lines and lines that start with ``#`` are skipped.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import Fault, ModelError, UnitError, shown
from kinetruss.io.yaml_text import read_text
from kinetruss.units import NUMBER, Tagged, parse, unit_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray


MOST_FAULTS = 20
_HEADER = re.compile(r"(.*?)\s*(?:\[(.*)\])?")


@dataclass(frozen=True, slots=True, eq=False)
class Column:
    """A column in SI: `values` (n_rows,), the quantity of its unit (``length``, ``angle``; None without a unit)."""

    values: NDArray[np.float64]
    quantity: str | None
    at: int
    """Position of its header in the line, from 1."""


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """A table in SI: `times` (n_rows,) s, columns by name, and the line of each row and of the header."""

    path: str
    times: NDArray[np.float64]
    columns: dict[str, Column]
    lines: list[int]
    header: int

    def fault(self, message: str, mend: str, line: int | None = None, column: int = 1) -> Fault:
        """A fault of this table, at its header unless a line is given."""
        return Fault((), message, mend, self.header if line is None else line, column, file=self.path)


def read_table(
    path: Path,
    quantity_of: Callable[[str], str | tuple[str, ...] | None],
    *,
    max_size: int,
    least_rows: int = 2,
    repeats: bool = False,
) -> Table:
    """Read a table.

    Parameters
    ----------
    path : CSV file, UTF-8.
    quantity_of : quantity of a column by its name, or several of which its unit chooses; None for an unknown column.
    max_size : bytes. least_rows : smallest number of rows. repeats : times may be repeated.

    Raises
    ------
    ModelError : all faults of the table, each with file, line and column: missing or unknown columns, cells that are not a
    number, times that do not increase.
    """
    reader = _Reader(str(path), quantity_of, repeats)
    try:
        text = read_text(path, max_size)
    except ModelError as error:
        raise ModelError([replace(fault, file=str(path)) for fault in error.faults]) from None
    for number, line in enumerate(text.splitlines(), start=1):
        if line.strip() and not line.lstrip().startswith("#"):
            reader.take(number, line)
    return reader.table(least_rows)


class _Reader:
    """Reads the lines of a table one by one and collects their faults."""

    def __init__(self, path: str, quantity_of: Callable[[str], str | tuple[str, ...] | None], repeats: bool) -> None:
        self._path = path
        self._repeats = repeats
        self._quantity_of = quantity_of
        self._faults: list[Fault] = []
        self._names: list[str] = []
        self._scales: list[float] = []
        self._at: list[int] = []
        self._header = 0
        self._lost = False
        self._rows: list[list[float]] = []
        self._lines: list[int] = []

    def take(self, number: int, line: str) -> None:
        """Read the next line that is not empty."""
        if not self._names:
            self._head(number, line)
        elif not self._lost and len(self._faults) < MOST_FAULTS:
            self._row(number, line)

    def table(self, least_rows: int) -> Table:
        """The table; ModelError with all faults."""
        if not self._names:
            self._fault("is empty.", "Give a header (t, names) and one row per instant.", 1, 1)
        elif not self._faults and len(self._rows) < least_rows:
            last = self._lines[-1] if self._lines else self._header
            self._fault(f"has {len(self._rows)} rows.", f"Give at least {least_rows}.", last, 1)
        if self._faults:
            raise ModelError(self._faults)
        values = np.array(self._rows) * np.array([float(scale) for scale in self._scales])
        columns = {
            name: Column(values[:, k], getattr(self._scales[k], "quantity", None), self._at[k])
            for k, name in enumerate(self._names)
            if k > 0
        }
        return Table(self._path, values[:, 0], columns, self._lines, self._header)

    def _fault(self, message: str, mend: str, line: int, column: int) -> None:
        self._faults.append(Fault((), message, mend, line, column, file=self._path))

    def _head(self, number: int, line: str) -> None:
        self._header = number
        cells = _cells(line)
        if len(cells) == 1 and (";" in line or "\t" in line):
            self._fault("has one column only.", "Separate columns by commas and write decimal points.", number, 1)
            self._names, self._lost = [line], True
            return
        for at, text in cells:
            match = _HEADER.fullmatch(text.strip('"'))
            name, unit = (match[1], match[2]) if match else (text, None)
            self._column(name.strip(), unit, number, at)

    def _column(self, name: str, unit: str | None, line: int, at: int) -> None:
        first = not self._names
        known = "time" if first else self._quantity_of(name)
        quantity, several = (known, False) if known is None or isinstance(known, str) else (_meant(unit, known), True)
        if first and name not in ("t", "time"):
            mend = "Give a header such as: t, M7 [mm]." if NUMBER.fullmatch(name) else "Call it t."
            self._fault(f"the first column is called {shown(name)}; expected t.", mend, line, at)
        elif quantity is None:
            self._fault(f"column {shown(name)} is not known here.", "Remove it, or correct its name.", line, at)
        elif name in self._names:
            self._fault(f"column {shown(name)} is given twice.", "Rename one, or remove it.", line, at)
        scale = 1.0
        if unit is not None and quantity is not None:
            try:
                scale = parse(f"1 {unit}", quantity)
            except UnitError:
                mend = f"Write for example [{unit_of(quantity)}], or no unit for SI."
                self._fault(f"column {shown(name)} has the unit [{unit}], which is not a unit of {quantity}.", mend, line, at)
        if several:
            scale = Tagged(scale, quantity)
        self._names.append(name)
        self._scales.append(scale if unit is not None or several else 1.0)
        self._at.append(at)

    def _row(self, number: int, line: str) -> None:
        cells = _cells(line)
        if len(cells) != len(self._names):
            mend = "Give one cell per column. (A decimal comma splits a number in two.)"
            self._fault(f"has {len(cells)} cells; the header has {len(self._names)}.", mend, number, 1)
            return
        row = []
        for (at, text), name in zip(cells, self._names, strict=True):
            value = float(text) if NUMBER.fullmatch(text) else np.nan
            if not np.isfinite(value):
                what = f"{shown(text)} is not a number" if text else "the cell is empty"
                self._fault(f"{what}, in column {shown(name)}.", "Give a number; fill gaps.", number, at)
            row.append(value)
        if self._rows and (row[0] < self._rows[-1][0] or (row[0] == self._rows[-1][0] and not self._repeats)):
            message = f"time does not increase: {row[0]:g} after {self._rows[-1][0]:g} in line {self._lines[-1]}."
            self._fault(message, "Sort the table by time, and keep one row for each instant.", number, cells[0][0])
        self._rows.append(row)
        self._lines.append(number)


def _meant(unit: str | None, known: tuple[str, ...]) -> str:
    """The quantity that has the unit, of some; without a unit, or if none has it, the first."""
    for quantity in known if unit is not None else ():
        try:
            parse(f"1 {unit}", quantity)
        except UnitError:
            continue
        return quantity
    return known[0]


def _cells(line: str) -> list[tuple[int, str]]:
    """Column (from 1) and text of each cell."""
    found, start = [], 0
    for part in line.split(","):
        text = part.strip()
        found.append((start + part.find(text) + 1, text))
        start += len(part) + 1
    return found
