"""Writes a report: the page, and a PDF if a browser can print it."""

from __future__ import annotations

import html
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from kinetruss.report.document._document import document_page
from kinetruss.report.document._print import print_page
from kinetruss.results.store import whole_file

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["Written", "write_document"]

PAGE, PAPER = "report.html", "report.pdf"


@dataclass(frozen=True, slots=True)
class Written:
    """Paths of a report: `page`, and `paper` or None; `note` then gives the reason."""

    page: Path
    paper: Path | None = None
    note: str = ""


def write_document(run: RunResult, folder: str | Path, *, view: str = "", date: str = "", pdf: bool = True) -> Written:
    """Write ``folder/report.html``, and if Chromium is installed ``folder/report.pdf`` (A4).

    Each file appears completely or not at all. An old report.pdf is removed if no new one replaces it.

    Parameters
    ----------
    view, date : as of `document_page`. pdf : False writes no PDF.

    Raises
    ------
    StoreError : the folder cannot be written.
    """
    place = Path(folder)
    page, paper = place / PAGE, place / PAPER
    text = document_page(run, view, date).html
    with whole_file(page) as draft:
        paper.unlink(missing_ok=True)
        draft.write_text(text, encoding="utf-8")
    if not pdf:
        return Written(page)
    # without the view, which paper does not show
    note = _printed(text.replace(f' srcdoc="{html.escape(view)}"', "", 1), paper)
    return Written(page, None if note else paper, note)


def _printed(text: str, paper: Path) -> str:
    """Print a page to PDF. Returns the reason of a failure, or an empty text."""
    with TemporaryDirectory(prefix="kinetruss-") as scratch:
        source, drawn = Path(scratch) / PAGE, Path(scratch) / PAPER
        source.write_text(text, encoding="utf-8")
        note = print_page(source, drawn, Path(scratch) / "browser")
        if note:
            return note
        with whole_file(paper) as draft:
            draft.write_bytes(drawn.read_bytes())
    return ""
