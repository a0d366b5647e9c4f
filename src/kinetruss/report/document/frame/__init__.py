"""The frame of every report: title block, result, contents, numbered sections, figures and tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.document.frame.columns import Columns
    from kinetruss.report.document.frame.page import PAPERS, Part, framed, known_paper, with_pages

__all__ = ["PAPERS", "Columns", "Part", "framed", "known_paper", "with_pages"]

__getattr__, __dir__ = late(__name__, {"columns": "Columns", "page": "PAPERS Part framed known_paper with_pages"})
