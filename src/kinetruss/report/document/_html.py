"""HTML from plain data: whatever is not markup already is escaped, so that no name can become part of the page."""

from __future__ import annotations

import html
from collections.abc import Iterable
from typing import Any

__all__ = ["Markup", "bar", "element", "joined", "span_bar", "table"]

VOID = ("br", "img", "link", "meta")
SHORT = 14
"""Rows up to which a table stays on one printed page."""
THIN = 0.6
"""Least width of a mark in a bar of 100."""
LIMIT = 1.0
"""Utilisation that is full."""


class Markup(str):
    """A text that is HTML already."""

    __slots__ = ()


def element(name: str, *content: Any, **attributes: Any) -> Markup:
    """One element. Attributes: ``class_="x"``, ``data_name="y"``; None and False leave one out, True gives it without value.

    >>> element("p", "a < b ", element("b", "c"), class_="note")
    '<p class="note">a &lt; b <b>c</b></p>'
    """
    words = "".join(_attribute(key, value) for key, value in attributes.items() if value is not None and value is not False)
    return Markup(f"<{name}{words}>" if name in VOID else f"<{name}{words}>{joined(content)}</{name}>")


def _attribute(key: str, value: Any) -> str:
    name = key.rstrip("_").replace("_", "-")
    return f" {name}" if value is True else f' {name}="{html.escape(str(value))}"'


def joined(content: Any) -> Markup:
    """Texts, elements and lists of them, one after the other; None is nothing."""
    if content is None:
        return Markup("")
    if isinstance(content, Markup):
        return content
    if isinstance(content, Iterable) and not isinstance(content, str):
        return Markup("".join(joined(one) for one in content))
    return Markup(html.escape(str(content)))


def table(caption: str, heads: Iterable[str], rows: Iterable[Iterable[Any]], note: Any = None) -> Markup:
    """A table with a caption; columns whose head begins with ``>`` hold numbers and stand to the right.

    Without any head the two columns are names and what they are.
    """
    words = list(heads)
    if not any(words):
        return _pairs(caption, rows)
    kinds = ["number" if head.startswith(">") else "word" for head in words]
    top = [element("th", head.lstrip(">"), class_=kind, scope="col") for head, kind in zip(words, kinds, strict=True)]
    lines = [element("tr", [element("td", cell, class_=kind) for cell, kind in zip(row, kinds, strict=True)]) for row in rows]
    body = element("table", element("thead", element("tr", top)), element("tbody", lines))
    size = "table short" if len(lines) <= SHORT else "table"
    foot = element("p", note, class_="note") if note else None
    return element(
        "figure", element("figcaption", caption), element("div", body, class_="scroll", tabindex="0"), foot, class_=size
    )


def _pairs(caption: str, rows: Iterable[Iterable[Any]]) -> Markup:
    """A table of names and what they are."""
    lines = [element("tr", element("th", name, scope="row"), element("td", words)) for name, words in rows]
    size = "table pairs short" if len(lines) <= SHORT else "table pairs"
    return element("figure", element("figcaption", caption), element("table", element("tbody", lines)), class_=size)


def bar(share: float, most: float = LIMIT) -> Markup:
    """A level bar of a utilisation on an axis from 0 to `most`, with the mark of its limit; beyond it in another colour."""
    width = 100 * min(max(share, 0.0), most) / most
    kind = "over" if share > LIMIT else "used"
    mark = f'<rect class="limit" x="{100 * LIMIT / most - 1:.2f}" y="0" width="1" height="10"/>'
    return _drawing(f'<rect class="{kind}" x="0" y="2" width="{width:.2f}" height="6"/>{mark}')


def span_bar(low: float, high: float, least: float, most: float) -> Markup:
    """From `low` to `high` on an axis from `least` to `most`, with a mark at zero: compression and tension in two colours.

    What hardly changes is still a mark that can be seen.
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
