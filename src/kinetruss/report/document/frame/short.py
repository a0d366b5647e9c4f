"""The sections of a summary: one or two sheets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from kinetruss.report.document.frame.page import Part
from kinetruss.report.document.worked import shown

if TYPE_CHECKING:
    from kinetruss.display import Markup
    from kinetruss.report.document.worked import Sheet

__all__ = ["summary_parts"]


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
