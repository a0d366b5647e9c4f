"""What a reader asks of a report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kinetruss.errors import InputError
from kinetruss.model import TitleBlock
from kinetruss.report.document.frame.logo import read_logo
from kinetruss.report.document.frame.title_block import filled

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["PAPERS", "Front", "front_of"]

PAPERS = {"a4": "A4", "letter": "letter"}
"""Sizes of paper by name, as CSS names them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Front:
    """block : title block. logo : a ``data:`` address, or empty. paper : one of `PAPERS`. view : a page in three dimensions, or
    empty. summary : only result, figure, governing calculation and assumptions.
    """

    block: TitleBlock
    logo: str = ""
    paper: str = "a4"
    view: str = ""
    summary: bool = False


def front_of(
    block: TitleBlock | None,
    own: TitleBlock | None,
    date: str,
    *,
    view: str = "",
    paper: str = "a4",
    logo: str | Path | None = None,
    summary: bool = False,
) -> Front:
    """The front of a report; empty entries of the block are those of the model. logo : a PNG or SVG file.

    Raises
    ------
    InputError : unknown paper; a logo that cannot be used.
    """
    if paper not in PAPERS:
        raise InputError(f"No paper called {paper!r}. Give one of {', '.join(PAPERS)}.")
    mark = "" if logo is None else read_logo(logo)
    return Front(block=filled(block, own, date), logo=mark, paper=paper, view="" if summary else view, summary=summary)
