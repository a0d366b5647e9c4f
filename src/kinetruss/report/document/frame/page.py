"""Puts a report together: head, result, contents, numbered sections, data."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, element, html_page, joined
from kinetruss.report.document.frame.front import PAPERS
from kinetruss.report.document.frame.numbering import Numbers, referred
from kinetruss.report.document.frame.title_block import title_block
from kinetruss.report.document.frame.typeset import typeset

if TYPE_CHECKING:
    from kinetruss.report.document.frame.front import Front

__all__ = ["Part", "framed", "with_pages"]

STYLE = Path(__file__).parents[1] / "style.css"
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
