"""The title block of a report: what is known of the document, and lines for what is not."""

from __future__ import annotations

from kinetruss.display import Markup, element
from kinetruss.model import TitleBlock

__all__ = ["filled", "title_block"]

ROWS = (("project", "client"), ("number", "revision"), ("author", "date"), ("checker", "checked"))
WORDS = {"number": "document", "checked": "date of the check"}
SIGNED = ("author", "checker")


def title_block(block: TitleBlock) -> Markup:
    """A table of two columns of entries; empty ones are lines to fill in, and author and checker sign."""
    rows = [element("tr", *(_cells(block, name) for name in pair)) for pair in ROWS]
    signed = [_line(f"signature of the {name}") for name in SIGNED]
    return element("table", element("tbody", rows, element("tr", signed, class_="signed")), class_="block")


def filled(block: TitleBlock | None, own: TitleBlock | None, date: str = "") -> TitleBlock:
    """A title block whose empty entries are those of a model, and its date that of the report."""
    fields = {"date": date}
    for given in (own, block):
        fields |= {} if given is None else {name: value for name, value in given.model_dump().items() if value}
    return TitleBlock(**fields)


def _cells(block: TitleBlock, name: str) -> Markup:
    said = getattr(block, name, "")
    if not said:
        return _line(WORDS.get(name, name))
    return Markup(f"{element('th', WORDS.get(name, name), scope='row')}{element('td', said)}")


def _line(name: str) -> Markup:
    blank = element("td", element("span", class_="fill", role="img", aria_label="to fill in"))
    return Markup(f"{element('th', name, scope='row')}{blank}")
