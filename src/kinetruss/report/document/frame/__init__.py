"""The frame of every report: title block, result, contents, numbered sections, figures and tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.document.frame.columns import Columns
    from kinetruss.report.document.frame.front import PAPERS, Front, front_of
    from kinetruss.report.document.frame.page import Part, framed, with_pages

__all__ = ["PAPERS", "Columns", "Front", "Part", "framed", "front_of", "with_pages"]

__getattr__, __dir__ = late(
    __name__, {"columns": "Columns", "front": "PAPERS Front front_of", "page": "Part framed with_pages"}
)
