"""Puts a report together: head, result, contents, numbered sections, data."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, html_page, joined
from kinetruss.errors import InputError
from kinetruss.report.document.frame.numbering import Numbers, referred
from kinetruss.report.document.frame.title_block import title_block
from kinetruss.report.document.frame.typeset import typeset

if TYPE_CHECKING:
    from kinetruss.model import TitleBlock

__all__ = ["PAPERS", "Part", "framed", "known_paper", "with_pages"]

STYLE = Path(__file__).parents[1] / "style.css"
PAPERS = {"a4": "A4", "letter": "letter"}
"""Sizes of paper by name, as CSS names them."""
LONGEST = 90
"""Characters of the footer."""


@dataclass(frozen=True, slots=True)
class Part:
    """A section: key of its links, name, sentence that introduces it, content; without content it is left out."""

    key: str
    name: str
    words: str
    content: Sequence[Markup] = field(default_factory=tuple)


def known_paper(paper: str) -> str:
    """The name of a paper, if it is known.

    Raises
    ------
    InputError : it is not.
    """
    if paper not in PAPERS:
        raise InputError(f"No paper called {paper!r}. Give one of {', '.join(PAPERS)}.")
    return paper


def framed(
    title: str,
    block: TitleBlock,
    lines: Sequence[str],
    parts: Sequence[Part],
    *,
    kicker: str,
    quiet: str,
    above: Sequence[Markup] = (),
    record: Mapping[str, Any],
    foot: str,
    paper: str = "a4",
    mark: str = "",
) -> str:
    """A whole page.

    Parameters
    ----------
    lines : the result in its first lines; the first part follows them. parts : sections in their order. kicker, quiet : above
    and below the title. above : before the result. record : data of the page, JSON can hold it. foot : of printed pages.
    paper : one of `PAPERS`. mark : after the title in the window's name.
    """
    shown = [part for part in parts if part.content]
    head = element("header", element("p", kicker, class_="kicker"), element("h1", title), element("p", quiet, class_="quiet"))
    sections = list(_sections(shown, lines))
    body = [head, title_block(block), *above, sections[0], _contents(shown), *sections[1:]]
    end = element("p", "End of the report.", class_="note end", id="end")
    data = json.dumps(record, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    kept = element("script", Markup(data), type="application/json", id="kinetruss-report")
    style = f"{STYLE.read_text('utf-8')}{_sheet(foot, paper)}"
    top = f'<meta name="color-scheme" content="light dark">\n<style>{style}</style>\n'
    return html_page(f"{title}{mark}: report", top, typeset(f"<main>\n{joined([*body, end])}\n</main>\n{kept}"))


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
