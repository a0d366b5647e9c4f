"""Puts a report together: head, result, contents, numbered sections, true signs and powers in its text."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, html_page, joined
from kinetruss.report.document.title_block import PAPERS, Numbers, referred, title_block
from kinetruss.report.document.worked import shown

if TYPE_CHECKING:
    from kinetruss.report.document.sheets import Sheet
    from kinetruss.report.document.title_block import Front


def summary_parts(
    result: Sequence[Markup], figure: Sequence[Markup], sheets: Sequence[Sheet], assumed: Sequence[Markup], more: str = ""
) -> list[Part]:
    """Result, figure, the calculation of the highest utilisation, and assumptions. more : what the figure shows besides."""
    words = "The structure with its supports and loads"
    return [
        Part("result", "Result", "", result),
        Part("structure", "Structure and loads", more or words, figure),
        Part("worked", "Governing calculation", "The check of the highest utilisation", shown(sheets[:1])),
        Part("assumed", "Assumptions, and what was not checked", "What the results rest on", assumed),
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

STYLE = Path(__file__).with_name("style.css")
END = "End of the report."
LONGEST = 90
"""Characters of the footer."""


@dataclass(frozen=True, slots=True)
class Part:
    """A section: key of its links, name, sentence that introduces it, content; without content it is left out."""

    key: str
    name: str
    words: str
    content: Sequence[Markup] = field(default_factory=tuple)


def framed(
    title: str,
    front: Front,
    lines: Sequence[str],
    parts: Sequence[Part],
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
    shown = [part for part in parts if part.content]
    logo = element("img", alt="Logo", src=front.logo, class_="logo") if front.logo else None
    kind = f"{kicker}: summary" if front.summary else kicker
    head = element(
        "header", logo, element("p", kind, class_="kicker"), element("h1", title), element("p", quiet, class_="quiet")
    )
    sections = list(_sections(shown, lines))
    contents = [] if front.summary else [_contents(shown)]
    body = [head, title_block(front.block), *above, sections[0], *contents, *sections[1:]]
    words = "End of the summary. The full report has all checks, data, methods and the model." if front.summary else END
    end = element("p", words, class_="note end", id="end")
    data = json.dumps(record, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    kept = element("script", Markup(data), type="application/json", id="kinetruss-report")
    style = f"{STYLE.read_text('utf-8')}{_sheet(foot, front.paper)}"
    top = f'<meta name="color-scheme" content="light dark">\n<style>{style}</style>\n'
    name = "summary" if front.summary else "report"
    main = element("main", "\n", body, end, "\n", class_="short" if front.summary else None)
    return html_page(f"{title}{mark}: {name}", top, typeset(f"{main}\n{kept}"))


def _sections(parts: Sequence[Part], lines: Sequence[str]) -> Iterator[Markup]:
    numbers = Numbers()
    for k, part in enumerate(parts, 1):
        inside, found = numbers.numbered(joined(part.content))
        links = referred(found)
        words = [part.words, " (" if part.words else "", links, ")." if part.words else "."] if links else [part.words, "."]
        said = element("p", words, class_="intro") if part.words or links else None
        first = [element("p", line, class_="line") for line in lines] if k == 1 else None
        name = element("h2", element("span", f"{k} ", class_="count"), part.name)
        yield element("section", name, first, said, inside, id=part.key)


def _contents(parts: Sequence[Part]) -> Markup:
    rows = [
        element(
            "li",
            element("a", f"{k} {part.name}", href=f"#{part.key}"),
            element("span", class_="page", data_key=part.key),
        )
        for k, part in enumerate(parts, 1)
    ]
    # the last link has no words: it makes the browser tell the place of the end
    last = element("a", href="#end", class_="endmark", aria_hidden="true", tabindex="-1")
    return element("nav", element("h2", "Contents"), element("ul", rows), last, aria_label="Contents")


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
