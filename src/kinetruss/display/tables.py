"""Tables: columns that say how they read, over rows of what is known; as plain text and as HTML.

A column of words shows them as they are. A measured one has one unit and one number of decimals for all its rows, or for all
rows of equal unit; columns of one group share both. The unit stands in the cells of a text and in the heads of a page. A
drawn column has small pictures, and is in pages only. A column in which nothing is known is left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rich.cells import cell_len

from kinetruss.display.html import Markup, element
from kinetruss.display.numbers import DIGIT, POINT, aligned, column
from kinetruss.display.ranks import largest_first

SHORT = 14
"""Number of rows up to which a table is kept on one printed page."""
MOST = 12, 40
"""Largest number of rows of a result in a text and in a page; the data of the page have all."""
PLAIN = str.maketrans({DIGIT: " ", POINT: " "})

Of = str | int | tuple[str | int, ...] | Callable[[Any], Any]
"""Key of a row, keys one in the other, or a function of the row."""
Line = tuple[str, list[Any]]  # head, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """A column of a table.

    of : its value in a row. unit : of the values (SI); None: words. mixed : ``unit`` is the key of the unit of
    each row. fixed : the unit has no prefixes. group : columns of one quantity have equal ones, and share unit and decimals.
    idle : a column whose cells are all equal to it says nothing, and is left out. only : ``pages`` or ``texts``, if not both.
    """

    head: str
    of: Of
    unit: Of | None = None
    mixed: bool = False
    fixed: bool = False
    group: str = ""
    idle: str = ""
    only: str = ""

    def values(self, rows: Sequence[Any]) -> list[Any]:
        """The values of the rows: NaN for what is not known."""
        found = [_of(row, self.of) for row in rows]
        return found if self.unit is None else [math.nan if one is None else float(one) for one in found]

    def units(self, rows: Sequence[Any]) -> list[str]:
        """The SI unit of each row."""
        return [str(_of(row, self.unit)) if self.mixed else str(self.unit) for row in rows]


def _of(row: Any, key: Any) -> Any:
    if callable(key):
        return key(row)
    if isinstance(key, tuple):
        for one in key:
            row = row.get(one) if isinstance(row, Mapping) else None if row is None else row[one]
        return row
    return row[key] if isinstance(row, (Mapping, Sequence)) else getattr(row, key)


def words(head: str, of: Of | None = None, *, idle: str = "", only: str = "") -> Column:
    """A column of texts; its key is its head by default."""
    return Column(head=head, of=head if of is None else of, idle=idle, only=only)


def drawn(of: Of, head: str = "") -> Column:
    """A column of small drawings (`bar`, `span_bar`)."""
    return Column(head=head, of=of, only="pages")


def measured(head: str, of: Of | None = None, unit: str = "", *, group: str = "", fixed: bool = False) -> Column:
    """A column of values (SI) in one unit; its key is its head by default."""
    return Column(head=head, of=head if of is None else of, unit=unit, group=group, fixed=fixed)


def mixed(head: str, of: Of, unit: Of = "unit", *, group: str = "") -> Column:
    """A column whose rows have units of their own. unit : key of it. Columns of a group share units, but not decimals."""
    return Column(head=head, of=of, unit=unit, mixed=True, group=group)


def together(unit: str, columns: Mapping[str, Of]) -> list[Column]:
    """Columns of one quantity, which share their unit and decimals: their heads and keys."""
    return [measured(head, of, unit, group="/".join(columns)) for head, of in columns.items()]


def seconds(head: str, of: Of | None = None, group: str = "") -> Column:
    """A column of times of a history, always in seconds, as on the axes of pictures."""
    return measured(head, of, "s", group=group, fixed=True)


class Table:
    """Rows below a head.

    Words stand to the left, numbers to the right.

    Parameters
    ----------
    columns : columns, or names of columns whose cells are those of the rows in turn; if all are empty, the two are names and
    what they are. rows : mappings, records, or texts in the order of the columns (in HTML also `Markup`). caption, note : above
    and below it. foot : below it, in pages only. most : rows that a text and a page show; rank : of more, those of the largest
    rank are shown. rest : what a text says of those that are left out. among : rows of other tables with which the
    values share units. style : class of its own in a page.

    Examples
    --------
    >>> print(Table(("member", "force"), [("M1", "58.3 N"), ("M19", "-12.5 N")]).text)
    member    force
    M1       58.3 N
    M19     -12.5 N
    >>> loads = [{"member": "M1", "force": 1250.0}, {"member": "M2", "force": -3.4}]
    >>> table = Table([words("member"), measured("force", "force", "N")], loads)
    >>> print(table.text)
    member      force
    M1       1.250 kN
    M2      -0.003 kN
    >>> "force (kN)" in table.html().replace("\u00a0", " ")
    True
    """

    def __init__(
        self,
        columns: Sequence[str | Column],
        rows: Iterable[Any],
        caption: str = "",
        note: str = "",
        *,
        foot: str = "",
        most: tuple[int, int] | None = None,
        rank: Callable[[Any], Any] | None = None,
        rest: Callable[[Sequence[Any]], str] | None = None,
        among: Sequence[Any] = (),
        style: str = "",
    ) -> None:
        self.paired = not any(columns)
        self.columns = [words(one, k) if isinstance(one, str) else one for k, one in enumerate(columns)]
        self.rows, self.caption, self.note, self.foot = list(rows), caption, note, foot
        self.most, self.rank, self.rest, self.among, self.style = most, rank, rest, among, style

    def __bool__(self) -> bool:
        return bool(self.rows)

    @property
    def text(self) -> str:
        """The table as lines of text; wide characters count as two columns."""
        rows, left = self._shown(0)
        shown = self._lines(rows, pages=False)
        right = [_is_numeric(cells) and not self.paired for _, cells in shown]
        columns = [[*([] if self.paired else [head]), *(str(cell) for cell in cells)] for head, cells in shown]
        columns = [[cell.translate(PLAIN) for cell in cells] for cells in columns]
        widths = [max(map(cell_len, cells), default=0) for cells in columns]
        lines = [self.caption] if self.caption else []
        for line in zip(*columns, strict=True):
            cells = []
            for cell, width, numeric in zip(line, widths, right, strict=True):
                space = " " * (width - cell_len(cell))
                cells.append(space + cell if numeric else cell + space)
            lines.append("  ".join(cells).rstrip())
        if left:
            lines.append(f"and {len(left)} more{self.rest(left) if self.rest else ''}")
        return "\n".join([*lines, self.note] if self.note else lines)

    def html(self, label: Markup | None = None, key: str | None = None) -> Markup:
        """A figure with its caption; cells escaped. label : before the caption. key : name of links to it."""
        rows, left = self._shown(1)
        shown = self._lines(rows, pages=True)
        if self.paired:
            pairs = [element("tr", element("th", name, scope="row"), element("td", what)) for name, what in self.rows]
            whole, kind = element("table", element("tbody", pairs)), "table pairs"
        else:
            kinds = ["number" if _is_numeric(cells) else "word" for _, cells in shown]
            top = [element("th", head, class_=one, scope="col") for (head, _), one in zip(shown, kinds, strict=True)]
            body = zip(*(cells for _, cells in shown), strict=True)
            lines = [
                element("tr", [element("td", cell, class_=one) for cell, one in zip(row, kinds, strict=True)]) for row in body
            ]
            body_ = element("table", element("thead", element("tr", top)), element("tbody", lines))
            whole, kind = element("div", body_, class_="scroll", tabindex="0"), "table"
        more = f"{len(left)} more are in the data of this page." if left else ""
        said = " ".join(one for one in (more, self.note, self.foot) if one)
        foot = element("p", said, class_="note") if said else None
        kind = " ".join(one for one in (kind, self.style, "short" if len(rows) <= SHORT else "") if one)
        caption = element("figcaption", label, self.caption) if self.caption or label else None
        return element("figure", caption, whole, foot, class_=kind, id=key)

    def _shown(self, place: int) -> tuple[list[Any], list[Any]]:
        """The rows that are shown, in their order or by rank, and the others."""
        if self.most is None or len(self.rows) <= self.most[place]:
            return self.rows, []
        rows = self.rows if self.rank is None else largest_first(self.rows, self.rank)
        return rows[: self.most[place]], rows[self.most[place] :]

    def _lines(self, rows: list[Any], *, pages: bool) -> list[Line]:
        """Head and cells of the columns that say something."""
        found = []
        for one in self.columns:
            if one.only == ("texts" if pages else "pages"):
                continue
            if one.unit is not None:
                head, cells = self._measured(one, rows, pages=pages)
            else:
                head, cells = one.head, [cell if isinstance(cell, str) else str(cell) for cell in one.values(rows)]
                cells = cells if self.paired else aligned(cells)
            if isinstance(one.of, int) or not cells or not set(cells) <= {"", "-", one.idle}:
                found.append((head, cells))
        return found

    def _measured(self, own: Column, rows: list[Any], *, pages: bool) -> Line:
        """Head and cells of a column of values."""
        group = [one for one in self.columns if own.group and one.group == own.group] or [own]
        units, values = own.units(rows), own.values(rows)
        beside = [pair for one in group for pair in zip(one.units(rows), one.values(rows), strict=True)]
        among = [pair for one in group for pair in zip(one.units(self.among), one.values(self.among), strict=True)]
        cells, names = [""] * len(rows), {}
        for unit in dict.fromkeys(units):
            mine = [k for k, one in enumerate(units) if one == unit]
            shared, scaled = ([value for one, value in pairs if one == unit] for pairs in (beside, among))
            every = [values[k] for k in mine] + ([] if own.mixed else shared)
            texts, name = column(every, "" if own.fixed else unit, like=shared + scaled)
            names[unit] = unit if own.fixed else name
            for k, text in zip(mine, texts, strict=False):
                cells[k] = text
        if pages and len(names) == 1:
            (name,) = names.values()
            return f"{own.head} ({name.replace(' ', chr(160))})" if name else own.head, cells
        named = zip(cells, units, values, strict=True)
        return own.head, [f"{text} {names[unit]}".rstrip(" ") if math.isfinite(value) else text for text, unit, value in named]


def _is_numeric(cells: Sequence[Any]) -> bool:
    filled = [cell for cell in map(str, cells) if cell not in ("", "-")]
    return bool(filled) and all(cell[0].isdigit() or cell[0] in "+-−.∞>" for cell in filled)


# Small drawings in cells.

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
