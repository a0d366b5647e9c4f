"""Writes a report: the page, and a PDF if a browser can print it."""

from __future__ import annotations

import html
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kinetruss.report.document._document import document_page
from kinetruss.report.document._paper import read_paper
from kinetruss.report.document._print import print_page
from kinetruss.report.document.frame import with_pages
from kinetruss.results.store import whole_file

if TYPE_CHECKING:
    from kinetruss.model import TitleBlock
    from kinetruss.report._page import Page
    from kinetruss.runs import RunResult

__all__ = ["Written", "write_document", "write_page"]

REPORT, SUMMARY = "report", "summary"
PAGE, PAPER = "page.html", "page.pdf"
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
    with TemporaryDirectory(prefix="kinetruss-") as scratch:
        last: bytes | str = ""
        for last in _proofs(text, Path(scratch), most):
            if isinstance(last, str):
                return last
        with whole_file(paper) as draft:
            draft.write_bytes(last if isinstance(last, bytes) else b"")
    return ""


def _proofs(text: str, scratch: Path, most: int) -> Iterator[bytes | str]:
    """Printed files, better and better, or the reason why there is none: the first without numbers in its contents, then with
    letters of a size that leaves no last page of a few lines, then with the numbers.
    """
    first = _print(text, scratch)
    yield first
    if isinstance(first, str):
        return
    fitted, measured = text, read_paper(first)
    for fit in TIGHT if most else FITS[1:]:
        if measured.pages <= most if most else measured.left <= EMPTY:
            break
        resized = text.replace("<main", f'<main style="--fit: {fit}"', 1)
        again = _print(resized, scratch)
        if isinstance(again, str):
            break
        if most or read_paper(again).left < measured.left:
            fitted, measured = resized, read_paper(again)
    if measured.starts and (not most or fitted != text):
        yield _print(with_pages(fitted, measured.starts), scratch)


def _print(text: str, scratch: Path) -> bytes | str:
    source, drawn = scratch / PAGE, scratch / PAPER
    source.write_text(text, encoding="utf-8")
    drawn.unlink(missing_ok=True)
    return print_page(source, drawn, scratch / "browser") or drawn.read_bytes()
