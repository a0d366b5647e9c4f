"""Utilisation tables as rows, worst first."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from kinetruss.display import Table, margin, number, quantity

if TYPE_CHECKING:
    import xarray as xr

    from kinetruss.results.records.arrays import Columns

__all__ = ["NOT_CHECKED", "Row", "most_used", "row_text", "rows_of"]

_NUMBERS = ("value", "limit", "utilisation", "margin", "time_of", "station", "position")
COLUMNS = ("part", "rule", "value", "limit", "utilisation", "margin", "time", "station", "load_case", "note")
_UNITS = {"value": "", "limit": "", "utilisation": "%", "position": "m"}

NOT_CHECKED = "not checked: "
"""Start of the note of an entry that lacks data for its rule."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """One entry of a utilisation table.

    part : bar, active member or its ``.base`` or ``.tube``; member : the member it belongs to. rule : what was checked.
    value, limit : in `unit`. utilisation : value/limit; margin : 1/utilisation - 1 (negative: not enough). Infinite, and -1,
    for a beam-column whose compression reaches Euler's load; `note` says so.
    time : s, of the worst instant; station : fraction of the part's length from its end towards A, and position : m from end
    A (NaN if the entry has no place). pose : name of the worst pose, for forces of poses at rest.
    note : the formula used, or why it was not checked (then the numbers are NaN).
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
    pose: str = ""
    note: str = ""

    @property
    def checked(self) -> bool:
        """False for an entry that lacks data for its rule; `note` says which."""
        return not math.isnan(self.utilisation)

    @property
    def text(self) -> str:
        """``crank, yield: 3.6 % (8.451 MPa of 235 MPa)``; of an entry not checked its note."""
        if not self.checked:
            return f"{self.part}, {self.rule}: {self.note}"
        if math.isinf(self.utilisation) and self.note:
            return f"{self.part}, {self.rule}: {self.note}"
        given = f"{self.part}, {self.rule}: {quantity(self.utilisation, '%')}"
        return f"{given} ({quantity(self.value, self.unit)} of {quantity(self.limit, self.unit)})" if self.unit else given

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.text}>"


def rows_of(data: xr.Dataset | Columns, subject: str, rule: str) -> list[Row]:
    """Rows from arrays over (subject, rule), highest utilisation first, entries not checked last. An infinite one, of a
    beam-column beyond Euler's load, follows the finite one of its part that says by how much the limit is exceeded.

    Entries that do not apply (NaN without a note) are omitted.

    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> rows = kt.results.rows_of(kt.strength.check(model, forces).data, "part", "rule")
    >>> [(row.part, row.rule) for row in rows[:2]]
    [('strut', 'buckling'), ('strut', 'beam-column')]
    """
    parts, rules = data[subject].values.tolist(), [str(name) for name in data[rule].values]
    count = len(parts)
    members = data["member"].values.tolist() if "member" in data else parts
    units = data["unit"].values.tolist()
    # read whole arrays: reading single values from a dataset takes a hundred times as long
    numbers = {key: _column(data, key, count, len(rules), math.nan) for key in _NUMBERS}
    texts = {key: _column(data, key, count, len(rules), "") for key in ("note", "load_case", "pose")}
    rows = []
    for i, j in itertools.product(range(count), range(len(rules))):
        note = str(texts["note"][i][j])
        if math.isnan(numbers["utilisation"][i][j]) and not note:
            continue
        found = {key: float(column[i][j]) for key, column in numbers.items()}
        time = found.pop("time_of")
        rows.append(
            Row(
                part=str(parts[i]),
                member=str(members[i]),
                rule=rules[j],
                unit=str(units[j]),
                time=time,
                load_case=str(texts["load_case"][i][j]),
                pose=str(texts["pose"][i][j]),
                note=note,
                **found,
            )
        )
    of: dict[str, list[float]] = {}
    for row in rows:
        of.setdefault(row.part, []).append(row.utilisation)
    most = {part: most_used(values) for part, values in of.items()}
    infinite = {row.part for row in rows if math.isinf(row.utilisation)}

    def worst_first(row: Row) -> tuple[bool, float, str, bool]:
        beyond = math.isinf(row.utilisation)
        used = most[row.part] if beyond else row.utilisation if row.checked else 0.0
        # rows of one part stay together where one of them is infinite
        return not row.checked, -used, row.part if row.part in infinite and used == most[row.part] else "", beyond

    return sorted(rows, key=worst_first)


def most_used(values: Iterable[float]) -> float:
    """The highest of the utilisations of a part, NaN if none is known. An infinite one, of a beam-column beyond Euler's load,
    gives way to a finite one from 1 on: that of buckling says by how much.

    >>> most_used([0.3, math.inf, 1.29]), most_used([0.3, math.inf]), most_used([math.nan])
    (1.29, inf, nan)
    """
    known = [value for value in values if not math.isnan(value)]
    finite = max((value for value in known if math.isfinite(value)), default=math.nan)
    return finite if finite >= 1 or not known else max(known)


def _column(data: xr.Dataset | Columns, key: str, count: int, rules: int, missing: Any) -> Any:
    """Values over (subject, rule) as lists."""
    return data[key].values.tolist() if key in data else [[missing] * rules] * count


def row_text(rows: Iterable[Row], columns: tuple[str, ...] = COLUMNS) -> str:
    """Rows as plain text, one line each, below a head line; ``-`` if there is no value.

    >>> print(row_text([Row(part="M6", member="M6", rule="yield", value=1.2e6, limit=2.4e8, unit="Pa", utilisation=0.005,
    ...                     margin=199.0, time=0.5, station=1.0)], ("part", "rule", "value", "utilisation", "margin")))
    part  rule     value  utilisation  margin
    M6    yield  1.2 MPa        0.5 %   > 100
    """
    return Table(columns, [[_cell(row, name) for name in columns] for row in rows]).text


def _cell(row: Row, column: str) -> str:
    value = getattr(row, column)
    if column in _UNITS:
        return quantity(value, _UNITS[column] or row.unit)
    if column == "margin":
        return margin(value)
    return number(value) if isinstance(value, float) else value or "-"
