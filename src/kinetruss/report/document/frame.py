"""Puts a report together: head, result, contents, numbered sections, true signs and powers in its text."""

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


# The last pass over the text of a page: true minus signs, powers of ten, raised exponents, dashes for empty cells.

KEPT = re.compile(r"(<(script|style|pre|code)\b.*?</\2>|<[^>]*>)", re.DOTALL)
"""Parts of a page that are not prose: elements whose text is data, and tags with their attributes."""
MINUS = re.compile(r"(?:(?<![\w.)\]-])|(?<=\d[eE]))-(?=[\d∞.])")
"""A hyphen before a number, and not within a word, a date or a name; or in the exponent of a number."""

TEN = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e(−?\d{1,3})(?![\w…]|\.\d)")
"""A number with an exponent."""
SQUARE = re.compile(r"(?<=[A-Za-z])\^(-?\d)(?!\d)")
"""A unit with an exponent."""
OHM = re.compile(r"(?<=\d)([ \u00a0][nµmkM]?)ohm\b")
RAISED = str.maketrans("−-0123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def typeset(page: str) -> str:
    """The page with minus signs in place of hyphens before numbers, powers of ten, raised exponents of units, and Ω; model text
    and data stay as they are.

    >>> typeset("<td>-3 N</td><td>-</td><p>7e-15, EN 1999-1-1, 2026-11-21</p><code>-3</code>")
    '<td>−3 N</td><td>–</td><p>7·10⁻¹⁵, EN 1999-1-1, 2026-11-21</p><code>-3</code>'
    >>> typeset("<p>1e6 kN/m^3, 2 ohm</p>")
    '<p>1·10⁶ kN/m³, 2 Ω</p>'
    """
    parts = KEPT.split(page)
    # the pattern has two groups: text, an element or tag, its name, text, ..
    for k in range(0, len(parts), 3):
        parts[k] = "–" if parts[k] == "-" else _prose(parts[k])
    return "".join(text for k, text in enumerate(parts) if k % 3 != 2 and text is not None)


def _prose(text: str) -> str:
    text = MINUS.sub("−", text)
    text = TEN.sub(lambda found: f"{found[1]}·10{found[2].translate(RAISED)}", text)
    return OHM.sub(r"\1Ω", SQUARE.sub(lambda found: found[1].translate(RAISED), text))


# Puts a report together: head, result, contents, numbered sections, data.

FRAME, STYLE = (Path(__file__).with_name(name) for name in ("report.html.j2", "style.css"))
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


def bare_page(entries: Sequence[Entry]) -> str:
    """A page of entries alone; its title is the first line of the first one."""
    title = next((one.partition("\n")[0] for one in entries if isinstance(one, str)), "kinetruss")
    main = element("main", Numbers().html(entries)[0])
    return html_page(title, f"<style>{STYLE.read_text('utf-8')}</style>\n", typeset(main))


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
