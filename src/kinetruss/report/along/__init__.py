"""Diagrams of section forces along members and beams at one instant."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.along.chosen import Subject, asked, diagrams_record, governing_diagrams
    from kinetruss.report.along.drawing import drawn, scales_of
    from kinetruss.report.along.sampled import Along, only, section_lines

__all__ = [
    "Along", "Subject", "asked", "diagrams_record", "drawn", "governing_diagrams", "only", "scales_of", "section_lines",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "chosen": "Subject asked diagrams_record governing_diagrams",
        "drawing": "drawn scales_of",
        "sampled": "Along only section_lines",
    },
)
