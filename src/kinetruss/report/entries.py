"""What a page says: a list of sentences, tables and figures, written once and rendered as text and as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from kinetruss.display import Markup, Table, element, joined


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """Drawings above each other with their caption; in pages only. rows : they have the same width."""

    panels: Sequence[Markup]
    caption: str
    rows: bool = False

    def html(self, label: Markup | None = None, key: str | None = None) -> Markup:
        """The figure. label : before its caption. key : name of links to it."""
        shown = [element("div", one, class_="scroll", tabindex="0") for one in self.panels]
        kind = f"picture{' panels' if len(self.panels) > 1 else ''}{' rows' if self.rows else ''}"
        return element("figure", shown, element("figcaption", label, self.caption), class_=kind, id=key)


Entry = str | Table | Figure
"""A sentence, several lines of text, a table or a figure; `Markup`, such as a list, is in pages only."""


@dataclass(frozen=True, slots=True)
class Section:
    """Part of a document: key of its links, name, sentence that introduces it, content; without content it is left out."""

    key: str
    name: str
    words: str
    content: Sequence[Entry] = field(default_factory=tuple)


def as_text(entries: Iterable[Entry]) -> str:
    """Entries as text, with a line between them."""
    shown = (one.text if isinstance(one, Table) else one for one in entries if one and not isinstance(one, (Markup, Figure)))
    return "\n\n".join(shown)


WORDS = {"table": "Table", "picture": "Figure"}


class Numbers:
    """Counts the figures and tables of a document in their order."""

    def __init__(self) -> None:
        self.found = {"table": 0, "picture": 0}

    def html(self, entries: Iterable[Entry]) -> tuple[Markup, Markup]:
        """Entries as HTML with numbers before their captions, and links to them: "Tables 2 to 4; Figure 1"."""
        before = dict(self.found)
        inside = joined(self._html(one) for one in entries if one)
        links = (_referred(kind, before[kind], last) for kind, last in self.found.items())
        return inside, Markup("; ".join(filter(None, links)))

    def _html(self, one: Entry) -> Markup:
        if isinstance(one, str):
            return one if isinstance(one, Markup) else element("p", one, class_="lines")
        kind = "table" if isinstance(one, Table) else "picture"
        self.found[kind] += 1
        number = self.found[kind]
        return one.html(element("span", f"{WORDS[kind]} {number}. ", class_="label"), f"{kind}-{number}")


def _referred(kind: str, before: int, last: int) -> str:
    if last == before:
        return ""
    first, final = (element("a", str(number), href=f"#{kind}-{number}") for number in (before + 1, last))
    if last == before + 1:
        return f"{WORDS[kind]} {first}"
    return f"{WORDS[kind]}s {first}{' and ' if last == before + 2 else ' to '}{final}"
