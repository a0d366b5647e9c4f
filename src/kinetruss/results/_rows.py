"""Utilisation tables as rows, worst first."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Row", "row_text", "rows_of"]

COLUMNS = ("part", "rule", "value", "limit", "unit", "utilisation", "margin", "time", "station", "load_case", "note")


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """One entry of a utilisation table.

    part : bar, active member or its ``.base`` or ``.tube``; member : the member it belongs to. rule : what was checked.
    value, limit : in `unit`. utilisation : value/limit; margin : 1/utilisation - 1 (negative: not enough).
    time : s, of the worst; station : fraction of the part's length from its end towards A, and position : m from end A
    (NaN where no place belongs to it). note : the formula used, or why it was not checked (then the numbers are NaN).
    """

    part: str
    member: str
    rule: str
    value: float
    limit: float
    unit: str
    utilisation: float
    margin: float
    time: float
    station: float = math.nan
    position: float = math.nan
    load_case: str = ""
    note: str = ""

    @property
    def checked(self) -> bool:
        """False for an entry that lacks what its rule needs; `note` says what."""
        return not math.isnan(self.utilisation)


def rows_of(data: xr.Dataset, subject: str, rule: str) -> list[Row]:
    """Rows of a dataset over (subject, rule), highest utilisation first, what was not checked last.

    Entries that do not apply (NaN without a note) are left out.
    """
    members = data.coords["member"].values if "member" in data.coords else data.coords[subject].values
    rows = []
    for i, part in enumerate(data.coords[subject].values):
        for j, name in enumerate(data.coords[rule].values):
            numbers = {key: _number(data, key, i, j) for key in ("value", "limit", "utilisation", "margin", "time_of")}
            note = _text(data, "note", i, j)
            if math.isnan(numbers["utilisation"]) and not note:
                continue
            time = numbers.pop("time_of")
            rows.append(
                Row(
                    part=str(part), member=str(members[i]), rule=str(name), unit=str(data.coords["unit"].values[j]), time=time,
                    station=_number(data, "station", i, j), position=_number(data, "position", i, j),
                    load_case=_text(data, "load_case", i, j), note=note, **numbers,
                )
            )  # fmt: skip
    return sorted(rows, key=_worst_first)


def _worst_first(row: Row) -> tuple[bool, float]:
    return not row.checked, -row.utilisation if row.checked else 0.0


def _number(data: xr.Dataset, key: str, i: int, j: int) -> float:
    return float(data[key].values[i, j]) if key in data else math.nan


def _text(data: xr.Dataset, key: str, i: int, j: int) -> str:
    return str(data[key].values[i, j]) if key in data else ""


def row_text(rows: Iterable[Row], columns: tuple[str, ...] = COLUMNS) -> str:
    """Rows as aligned plain text, one line each, with a head line; numbers with four digits, ``-`` where there is none.

    >>> print(row_text([Row(part="M6", member="M6", rule="yield", value=1.2e6, limit=2.4e8, unit="Pa", utilisation=0.005,
    ...                     margin=199.0, time=0.5, station=1.0)], ("part", "rule", "value", "unit", "margin")))
    part  rule   value    unit  margin
    M6    yield  1.2e+06  Pa    199
    """
    lines = [columns, *(tuple(_cell(getattr(row, name)) for name in columns) for row in rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(columns))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines)


def _cell(value: Any) -> str:
    if isinstance(value, float):
        return "-" if math.isnan(value) else f"{value:.4g}"
    return value or "-"
