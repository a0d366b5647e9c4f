"""Worked calculations: each governing check with its formulas, its numbers with units, its result and its source."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.document.worked.chosen import worked
    from kinetruss.report.document.worked.markup import shown, worked_record
    from kinetruss.report.document.worked.pairs import Pairs, worked_pairs
    from kinetruss.report.document.worked.sheet import Sheet

__all__ = ["Pairs", "Sheet", "shown", "worked", "worked_pairs", "worked_record"]

__getattr__, __dir__ = late(
    __name__, {"chosen": "worked", "pairs": "Pairs worked_pairs", "sheet": "Sheet", "markup": "shown worked_record"}
)
