"""Measured records of drives or pose coordinates, with or without their rates and accelerations."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from kinetruss.errors import ModelError
from kinetruss.io.formats.text import MAX_SIZE
from kinetruss.io.tables.table import Table, read_table
from kinetruss.model import Measured
from kinetruss.units import Tagged

__all__ = ["measured_columns", "read_measured", "read_measured_table"]

_KINDS = {"rate": ("rates", "rate"), "acceleration": ("accelerations", "second rate")}


def read_measured(path: str | Path, *, max_size: int = MAX_SIZE, **options: Any) -> Measured:
    """Read a measured record of lengths, angles or pose coordinates.

    Parameters
    ----------
    path : CSV: ``t``, a column for each coordinate (``M7 [mm]``), and, where they were measured too, ``M7.rate [mm/s]`` and
    ``M7.acceleration [mm/s^2]``; SI without a unit. max_size : bytes; a larger file is not read. options : other fields of
    `kt.Measured`, e.g. ``outliers="replace"``.

    Raises
    ------
    ModelError : faults of the table, each with file, line and column; accelerations without rates, rates without values.

    Examples
    --------
    >>> import kinetruss as kt
    >>> record = kt.io.read_measured(kt.library.example_files()["measured_slew"][1], outliers="replace")
    >>> list(record.values), float(record.values["M7"][0])  # m
    (['M7', 'M9', 'M11'], 1.24146)
    """
    table = read_measured_table(Path(path), max_size)
    return Measured(times=tuple(table.times), **measured_columns(table), **options)


def read_measured_table(path: Path, max_size: int) -> Table:
    """The table with the quantity of every column."""
    return read_table(path, lambda name: _split(name)[2], max_size=max_size, least_rows=4)


def measured_columns(table: Table) -> dict[str, Any]:
    """Fields of a `Measured` from the columns of a table.

    Raises
    ------
    ModelError : a rate or acceleration without the column that it belongs to.
    """
    fields: dict[str, dict[str, Any]] = {"values": {}, "rates": {}, "accelerations": {}}
    for name, column in table.columns.items():
        of, field, _ = _split(name)
        fields[field][of] = [Tagged(value, column.quantity) for value in column.values.tolist()]
    lacking = [(name, f"{name}.rate") for name in fields["rates"] if name not in fields["values"]]
    lacking += [(f"{name}.rate", f"{name}.acceleration") for name in fields["accelerations"] if name not in fields["rates"]]
    if lacking:
        raise ModelError(
            [
                table.fault(
                    f"column {need!r} is missing; {whole!r} needs it.",
                    f"Add the column {need}, or remove {whole}.",
                    column=table.columns[whole].at,
                )
                for need, whole in lacking
            ]
        )
    if not fields["values"]:
        raise ModelError([table.fault("has no column but t.", "Give one column for each moving coordinate, e.g. M7 [mm].")])
    return {field: columns for field, columns in fields.items() if columns}


def _split(column: str) -> tuple[str, str, str]:
    """Coordinate, field of the record, and quantity of a column."""
    name, _, last = column.rpartition(".")
    return (name, *_KINDS[last]) if name and last in _KINDS else (column, "values", "coordinate")
