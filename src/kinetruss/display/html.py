"""HTML from plain data and tables of text and numbers: all text that is not `Markup` is escaped."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import Any

from rich.cells import cell_len

from kinetruss.display.numbers import DIGIT, POINT, aligned

POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:"
"""Content security policy of pages: the browser sends no request."""
VOID = ("br", "img", "link", "meta")


class Markup(str):
    """A text that is already HTML."""

    __slots__ = ()


def element(name: str, *content: Any, **attributes: Any) -> Markup:
    """One element. Attributes: ``class_="x"``, ``data_name="y"``; None and False omit one, True gives it without a value.

    >>> element("p", "a < b ", element("b", "c"), class_="note")
    '<p class="note">a &lt; b <b>c</b></p>'
    """
    words = "".join(_attribute(key, value) for key, value in attributes.items() if value is not None and value is not False)
    return Markup(f"<{name}{words}>" if name in VOID else f"<{name}{words}>{joined(content)}</{name}>")


def _attribute(key: str, value: Any) -> str:
    name = key.rstrip("_").replace("_", "-")
    return f" {name}" if value is True else f' {name}="{html.escape(str(value))}"'


def joined(content: Any) -> Markup:
    """Texts, elements and lists of them, joined in order; None is empty."""
    if content is None:
        return Markup("")
    if isinstance(content, Markup):
        return content
    if isinstance(content, Iterable) and not isinstance(content, str):
        return Markup("".join(joined(one) for one in content))
    return Markup(html.escape(str(content)))


def html_page(title: str, head: str, body: str, policy: str = POLICY) -> str:
    """A whole page. head, body : HTML of the body, and of the head in addition to what every page has."""
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<link rel="icon" href="data:,">
<title>{html.escape(title)}</title>
{head}</head>
<body>
{body}
</body>
</html>
"""


# Tables of text and numbers, as plain text and as HTML.

SHORT = 14
"""Number of rows up to which a table is kept on one printed page."""

PLAIN = str.maketrans({DIGIT: " ", POINT: " "})


class Table:
    """Rows of cells below a head: text is left-aligned; columns of numbers, found from their cells, are right-aligned.

    A column of quantities has one unit and one number of decimals (`aligned`).

    Parameters
    ----------
    head : names of the columns; if empty, the two columns are names and descriptions. rows : texts, one per column; in HTML
    also `Markup`. caption, note : above and below it.

    Examples
    --------
    >>> print(Table(("member", "force"), [("M1", "58.3 N"), ("M19", "-12.5 N")]).text)
    member    force
    M1       58.3 N
    M19     -12.5 N
    """

    def __init__(self, head: Sequence[str], rows: Iterable[Sequence[Any]], caption: str = "", note: str = "") -> None:
        self.head, self.caption, self.note = tuple(head), caption, note
        found = [tuple(cell if isinstance(cell, str) else str(cell) for cell in row) for row in rows]
        self.rows = list(zip(*map(aligned, zip(*found, strict=True)), strict=True)) if found and any(self.head) else found

    @property
    def text(self) -> str:
        """The table as lines of text; wide characters count as two columns."""
        lines = [
            [str(cell).translate(PLAIN) for cell in row] for row in ((self.head, *self.rows) if any(self.head) else self.rows)
        ]
        widths = [max(map(cell_len, column)) for column in zip(*lines, strict=True)]
        right = self._numeric()
        found = [self.caption] if self.caption else []
        for line in lines:
            cells = []
            for cell, width, numeric in zip(line, widths, right, strict=True):
                space = " " * (width - cell_len(cell))
                cells.append(space + cell if numeric else cell + space)
            found.append("  ".join(cells).rstrip())
        return "\n".join([*found, self.note] if self.note else found)

    @property
    def html(self) -> Markup:
        """A figure with its caption; cells escaped."""
        if any(self.head):
            kinds = ["number" if numeric else "word" for numeric in self._numeric()]
            top = [element("th", head, class_=kind, scope="col") for head, kind in zip(self.head, kinds, strict=True)]
            lines = [[element("td", cell, class_=kind) for cell, kind in zip(row, kinds, strict=True)] for row in self.rows]
            body = element("table", element("thead", element("tr", top)), element("tbody", [element("tr", x) for x in lines]))
            whole, kind = element("div", body, class_="scroll", tabindex="0"), "table"
        else:
            pairs = [element("tr", element("th", name, scope="row"), element("td", words)) for name, words in self.rows]
            whole, kind = element("table", element("tbody", pairs)), "table pairs"
        foot = element("p", self.note, class_="note") if self.note else None
        size = f"{kind} short" if len(self.rows) <= SHORT else kind
        return element("figure", element("figcaption", self.caption), whole, foot, class_=size)

    def _numeric(self) -> list[bool]:
        """Mask of the columns that hold numbers; none if the table has no head."""
        if not any(self.head):
            return [False] * len(self.head)
        columns = list(zip(*self.rows, strict=True)) if self.rows else [()] * len(self.head)
        return [_is_numeric([str(cell) for cell in column]) for column in columns]


def _is_numeric(cells: list[str]) -> bool:
    filled = [cell for cell in cells if cell not in ("", "-")]
    return bool(filled) and all(cell[0].isdigit() or cell[0] in "+-−.∞>" for cell in filled)
