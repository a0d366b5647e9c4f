"""Tables by columns: one unit for a quantity, one number of decimals in a column; bars in cells as small drawings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from decimal import ROUND_HALF_UP, Decimal
from typing import Any

from kinetruss.display import Markup, Table, quantity, scale

THIN = 0.6
"""Smallest width of a mark; a bar has 100."""
LIMIT = 1.0
"""Utilisation at the limit."""
ROUND_OFF = 1e-9
"""Excess over the limit that counts as none."""


def bar(share: float, most: float = LIMIT) -> Markup:
    """A horizontal bar of a utilisation on an axis from 0 to `most`, with a mark at the limit; above it in another colour."""
    width = 100 * min(max(share, 0.0), most) / most
    kind = "over" if share > LIMIT + ROUND_OFF else "used"
    mark = f'<rect class="limit" x="{100 * LIMIT / most - 1:.2f}" y="0" width="1" height="10"/>'
    return _drawing(f'<rect class="{kind}" x="0" y="2" width="{width:.2f}" height="6"/>{mark}')


def span_bar(low: float, high: float, least: float, most: float) -> Markup:
    """A bar from `low` to `high` on an axis from `least` to `most`, with a mark at zero: compression and tension in two
    colours.

    A very small range is still drawn with a visible width.
    """
    reach = most - least or 1.0
    begin, zero, end = (100 * (value - least) / reach for value in (low, 0.0, high))
    parts = []
    for kind, there, left, right in (
        ("compression", low < 0, begin, min(zero, end)),
        ("tension", high > 0, max(zero, begin), end),
    ):
        if there:
            width = max(right - left, THIN)
            parts.append(f'<rect class="{kind}" x="{min(left, 100 - width):.2f}" y="2" width="{width:.2f}" height="6"/>')
    mark = min(max(zero - THIN / 2, 0.0), 100 - THIN)
    return _drawing("".join(parts) + f'<rect class="zero" x="{mark:.2f}" y="0" width="{THIN}" height="10"/>')


def _drawing(inside: str) -> Markup:
    return Markup(f'<svg class="bar" viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">{inside}</svg>')


# Tables by columns: one unit for a quantity in a table, and one number of decimals in a column.

DIGITS = 4
"""Significant digits of the largest value of a column; the others have as many decimals."""
MOST_DECIMALS = 6


class Columns:
    """A table that is filled column by column.

    >>> table = Columns().words("member", ["M1", "M2"]).measured("force", [1250.0, -3.4], "N")
    >>> table.heads, table.columns[1]
    (['member', 'force (kN)'], ['1.250', '-0.003'])
    """

    def __init__(self) -> None:
        self.heads: list[str] = []
        self.columns: list[list[Any]] = []

    def words(self, head: str, cells: Iterable[Any]) -> Columns:
        """A column of texts or drawings."""
        self.heads.append(head)
        self.columns.append(list(cells))
        return self

    def measured(self, head: str, values: Iterable[float | None], unit: str) -> Columns:
        """A column of numbers in one unit, which stands in its head."""
        return self.together([head], [values], unit)

    def together(
        self, heads: Sequence[str], columns: Sequence[Iterable[float | None]], unit: str, like: Iterable[float | None] = ()
    ) -> Columns:
        """Columns of one quantity: they share their unit and number of decimals. like : values of the same quantity in other
        tables, which share the unit.
        """
        known = [_numbers(one) for one in columns]
        factor, name = _scaled([value for one in (*known, _numbers(like)) for value in one], unit)
        decimals = _decimals([value for one in known for value in one], factor, unit)
        for head, values in zip(heads, known, strict=True):
            self.heads.append(f"{head} ({_solid(name)})" if name else head)
            self.columns.append([_cell(value, factor, decimals, unit) for value in values])
        return self

    def mixed(self, heads: Sequence[str], columns: Sequence[Iterable[float | None]], units: Sequence[str]) -> Columns:
        """Columns whose rows have units of their own: in a table, each quantity has one unit."""
        known = [_numbers(one) for one in columns]
        of = {unit: [k for k, own in enumerate(units) if own == unit] for unit in dict.fromkeys(units)}
        scales = {unit: _scaled([values[k] for values in known for k in rows], unit) for unit, rows in of.items()}
        for head, values in zip(heads, known, strict=True):
            decimals = {unit: _decimals([values[k] for k in rows], scales[unit][0], unit) for unit, rows in of.items()}
            cells = []
            for value, unit in zip(values, units, strict=True):
                factor, name = scales[unit]
                text = _cell(value, factor, decimals[unit], unit)
                cells.append(f"{text} {name}".rstrip() if math.isfinite(value) else text)
            self.words(head, cells)
        return self

    def html(self, caption: str, note: str = "") -> Markup:
        """The table as a figure."""
        return Table(self.heads, zip(*self.columns, strict=True), caption, note).html


def _numbers(values: Iterable[Any]) -> list[float]:
    """Numbers of a record: None is NaN, the text ``Infinity`` infinite."""
    return [math.nan if value is None else float(value) for value in values]


def _scaled(values: Sequence[float], unit: str) -> tuple[float, str]:
    """Factor and name of the unit for the largest of some values."""
    return scale(max((abs(value) for value in values if math.isfinite(value)), default=0.0), unit)


def _decimals(values: Sequence[float], factor: float, unit: str) -> int:
    """Number of decimals for the significant digits of the largest value; less if all of them end in zeros."""
    known = [value for value in values if math.isfinite(value)]
    largest = max(map(abs, known), default=0.0)
    if _nothing(largest, unit):
        return 0
    power = math.floor(math.log10(largest * factor) + 1e-9)
    most = min(max(0, DIGITS - 1 - power), MOST_DECIMALS)
    cells = [_cell(value, factor, most, unit) for value in known]
    return max((len(cell.partition(".")[2].rstrip("0")) for cell in cells), default=0)


def _cell(value: float, factor: float, decimals: int, unit: str) -> str:
    if math.isnan(value):
        return "-"
    if math.isinf(value):
        return "∞" if value > 0 else "-∞"
    if _nothing(value, unit):
        value = 0.0
    shown = Decimal(value * factor).quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP)
    text = f"{shown:f}"
    return text if shown else text.lstrip("-")


def _solid(name: str) -> str:
    """A unit that does not break at the end of a line."""
    return name.replace(" ", "\u00a0")


def _nothing(value: float, unit: str) -> bool:
    """True for 0 and for round-off, by the rules of `kinetruss.display`."""
    return quantity(value, unit).split(" ")[0] == "0"
