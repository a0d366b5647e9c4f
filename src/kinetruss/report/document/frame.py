"""Puts a report together: head, result, contents, numbered sections, data."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, html_page, joined
from kinetruss.report.document.title_block import PAPERS, ROWS, SIGNED, TITLE_WORDS
from kinetruss.report.document.worked import shown
from kinetruss.report.entries import Numbers, Section
from kinetruss.report.typesetting import STYLE, typeset

if TYPE_CHECKING:
    from jinja2 import Template

    from kinetruss.report.document.sheets import Sheet
    from kinetruss.report.document.title_block import Front
    from kinetruss.report.entries import Entry


def summary_parts(
    result: Sequence[Entry], figure: Sequence[Entry], sheets: Sequence[Sheet], assumed: Sequence[Entry], more: str = ""
) -> list[Section]:
    """Result, figure, the calculation of the highest utilisation, and assumptions. more : what the figure shows besides."""
    words = "The structure with its supports and loads"
    return [
        Section("result", "Result", "", result),
        Section("structure", "Structure and loads", more or words, figure),
        Section("worked", "Governing calculation", "The check of the highest utilisation", shown(sheets[:1])),
        Section("assumed", "Assumptions, and what was not checked", "What the results rest on", assumed),
    ]


FRAME = Path(__file__).with_name("report.html.j2")
LONGEST = 90
"""Characters of the footer."""


def framed(
    title: str,
    front: Front,
    lines: Sequence[str],
    parts: Sequence[Section],
    *,
    kicker: str,
    quiet: str,
    above: Sequence[Markup] = (),
    record: Mapping[str, Any],
    foot: str,
    mark: str = "",
) -> str:
    """A whole page; of a summary without contents.

    Parameters
    ----------
    lines : the result in its first lines; the first part follows them. parts : sections in their order. kicker, quiet : above
    and below the title. above : before the result. record : data of the page, JSON can hold it. foot : of printed pages.
    mark : after the title in the window's name.
    """
    numbers, short = Numbers(), front.summary
    shown = []
    for part in parts:
        inside, links = numbers.html(part.content)
        if inside:
            shown.append({"key": part.key, "name": part.name, "words": part.words, "links": links, "inside": inside})
    main = page_template().render(
        front=front,
        block=front.block.model_dump(),
        short=short,
        kicker=kicker,
        title=title,
        quiet=quiet,
        rows=ROWS,
        names=TITLE_WORDS,
        signed=SIGNED,
        above=joined(above),
        parts=shown,
        lines=lines,
    )
    data = json.dumps(record, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    kept = element("script", Markup(data), type="application/json", id="kinetruss-report")
    style = f"{STYLE.read_text('utf-8')}{_sheet(foot, front.paper)}"
    top = f'<meta name="color-scheme" content="light dark">\n<style>{style}</style>\n'
    return html_page(f"{title}{mark}: {'summary' if short else 'report'}", top, typeset(f"{main}\n{kept}"))


@lru_cache(maxsize=1)
def page_template() -> Template:
    """The frame of a report; all text that is not `Markup` is escaped."""
    from jinja2 import Environment, StrictUndefined

    return Environment(autoescape=True, undefined=StrictUndefined).from_string(FRAME.read_text("utf-8"))


def with_pages(page: str, pages: Mapping[str, int]) -> str:
    """The page with the numbers of the printed pages in its contents."""

    def put_in(match: re.Match[str]) -> str:
        number = pages.get(match[1])
        return match[0] if number is None else f'<span class="page" data-key="{match[1]}">{number}</span>'

    return re.sub(r'<span class="page" data-key="([^"]*)">\d*</span>', put_in, page)


def _sheet(words: str, paper: str) -> str:
    """Size of the paper and footer of printed pages; every character of the title is escaped."""
    shown = words if len(words) <= LONGEST else f"{words[: LONGEST - 1].rstrip()}…"
    text = "".join(sign if sign.isascii() and sign.isalnum() else f"\\{ord(sign):x} " for sign in shown)
    return f'@page {{ size: {PAPERS[paper]}; @bottom-left {{ content: "{text}"; }} }}\n'
