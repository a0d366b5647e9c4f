"""Writes a report: the page, and a PDF if a browser can print it, whose pages are read back."""

from __future__ import annotations

import html
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kinetruss.display.browser import INSTALL, PAPER as PRINTING, Browser, BrowserError, chromium
from kinetruss.report.document.frame import with_pages
from kinetruss.report.document.run_report import document_page
from kinetruss.results.folder import whole_file

if TYPE_CHECKING:
    from kinetruss.model import TitleBlock
    from kinetruss.report.page import Page
    from kinetruss.runs import RunResult


# Reads from a printed report on which pages its sections begin, and how far its last page is filled.
#
# Chromium writes the destinations of links as plain objects: ``/Dests`` names them, and each is an array of a page, ``/XYZ``
# and a place in points from the lower left corner (PDF 32000-1:2008, 12.3.2).


@dataclass(frozen=True, slots=True)
class Paper:
    """pages : number of them. starts : name of a destination -> number of its page, from 1. left : height below the end of
    the text on the last page, of the page; 0 if it is not known.
    """

    pages: int = 0
    starts: dict[str, int] = field(default_factory=dict)
    left: float = 0.0


def read_paper(data: bytes, end: str = "end") -> Paper:
    """What a printed file says of its pages; empty if it is written in another way."""
    objects = {int(number): body for number, body in re.findall(rb"(?:^|\n)(\d+) 0 obj\n(.*?)\nendobj", data, re.DOTALL)}
    order = _pages(objects)
    starts: dict[str, int] = {}
    left = 0.0
    for name, page, place in _destinations(objects):
        if page in order:
            starts[name] = order.index(page) + 1
            if name == end and starts[name] == len(order):
                left = place / _height(objects[page])
    return Paper(len(order), starts, left)


def _pages(objects: dict[int, bytes]) -> list[int]:
    """Numbers of the page objects in their order."""
    root = next((number for number, body in objects.items() if b"/Type /Catalog" in body), None)
    found: list[int] = []
    if root is None or not (first := re.search(rb"/Pages (\d+) 0 R", objects[root])):
        return found
    waiting = [int(first[1])]
    while waiting:
        number = waiting.pop(0)
        body = objects.get(number, b"")
        kids = re.search(rb"/Kids \[(.*?)\]", body, re.DOTALL)
        if kids:
            waiting = [int(one) for one in re.findall(rb"(\d+) 0 R", kids[1])] + waiting
        elif b"/Type /Page" in body:
            found.append(number)
    return found


def _destinations(objects: dict[int, bytes]) -> list[tuple[str, int, float]]:
    """Name, page object and height, points, of every destination."""
    for body in objects.values():
        if b"/Type /Catalog" in body and (place := re.search(rb"/Dests (\d+) 0 R", body)):
            listed = objects.get(int(place[1]), b"")
            found = re.findall(rb"/([^\s/\[]+) \[(\d+) 0 R\s*/XYZ \S+ (\S+) ", listed)
            return [(name.decode("latin-1"), int(page), float(height)) for name, page, height in found]
    return []


def _height(page: bytes) -> float:
    box = re.search(rb"/MediaBox \[\s*\S+ \S+ \S+ (\S+?)\s*\]", page)
    return float(box[1]) if box else 842.0


# Writes a report: the page, and a PDF if a browser can print it.

REPORT, SUMMARY = "report", "summary"
PAGE = "page.html"
SHORT = 2
"""Sheets of a summary."""
EMPTY = 0.6
"""Share of the last page that may stay below its text; above it the text is set a little smaller or larger."""
FITS = (1.0, 0.975, 1.025, 0.95, 1.05)
"""Factors of the size of letters that are tried, in this order."""
TIGHT = (0.96, 0.92, 0.88, 0.84)
"""The same for a summary of more than its sheets."""


@dataclass(frozen=True, slots=True)
class Written:
    """Paths of a report: `page`, and `paper` or None; `note` then gives the reason."""

    page: Path
    paper: Path | None = None
    note: str = ""


def write_document(
    run: RunResult,
    folder: str | Path,
    *,
    view: str = "",
    date: str = "",
    pdf: bool = True,
    block: TitleBlock | None = None,
    paper: str = "a4",
    logo: str | Path | None = None,
    summary: bool = False,
) -> Written:
    """Write ``folder/report.html``, and if Chromium is installed ``folder/report.pdf``; ``summary.html``, ``summary.pdf``.

    Each file appears completely or not at all. An old PDF is removed if no new one replaces it.

    Parameters
    ----------
    view, date, block, paper, logo, summary : as of `document_page`. pdf : False writes no PDF.

    Raises
    ------
    StoreError : the folder cannot be written. InputError : unknown paper; a logo that cannot be used.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.write_document(kt.run(model), folder, pdf=False).page.name
    'report.html'
    """
    page = document_page(run, view, date, block, paper, logo=logo, summary=summary)
    return write_page(page, folder, view=view, pdf=pdf, summary=summary)


def write_page(found: Page, folder: str | Path, *, view: str = "", pdf: bool = True, summary: bool = False) -> Written:
    """Write a report that is a page already; view : that which it includes. summary : it is one.

    >>> import kinetruss as kt
    >>> import tempfile
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> page = kt.report.document_page(kt.run(model))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.write_page(page, folder, pdf=False).page.name
    'report.html'
    """
    place = Path(folder)
    name = SUMMARY if summary else REPORT
    page, paper = place / f"{name}.html", place / f"{name}.pdf"
    text = found.html
    with whole_file(page) as draft:
        paper.unlink(missing_ok=True)
        draft.write_text(text, encoding="utf-8")
    if not pdf:
        return Written(page)
    # without the view, which paper does not show
    bare = text.replace(f' srcdoc="{html.escape(view)}"', "", 1) if view else text
    note = _printed(bare, paper, SHORT if summary else 0)
    return Written(page, None if note else paper, note)


def _printed(text: str, paper: Path, most: int = 0) -> str:
    """Print a page to PDF. Returns the reason of a failure, or an empty text.

    most : number of sheets that are kept if letters of a readable size permit it; 0: any.
    """
    program = chromium()
    if program is None:
        return f"No PDF: no Chromium was found. {INSTALL}, or print the page from a browser."
    try:
        with TemporaryDirectory(prefix="kinetruss-") as scratch, Browser(program, PRINTING) as browser:
            source = Path(scratch) / PAGE

            def proof(text: str) -> bytes:
                source.write_text(text, encoding="utf-8")
                return browser.paper(source)

            last = _fitted(text, proof, most)
    except BrowserError as error:
        return f"No PDF: {error} Print the page from a browser."
    with whole_file(paper) as draft:
        draft.write_bytes(last)
    return ""


def _fitted(text: str, proof: Callable[[str], bytes], most: int) -> bytes:
    """The printed file, after some proofs: the first without numbers in its contents, then with letters of a size that leaves
    no last page of a few lines, then with the numbers.
    """
    last = first = proof(text)
    fitted, measured = text, read_paper(first)
    for fit in TIGHT if most else FITS[1:]:
        if measured.pages <= most if most else measured.left <= EMPTY:
            break
        resized = text.replace("<main", f'<main style="--fit: {fit}"', 1)
        last = proof(resized)
        if most or read_paper(last).left < measured.left:
            fitted, measured = resized, read_paper(last)
    if measured.starts and (not most or fitted != text):
        last = proof(with_pages(fitted, measured.starts))
    return last
