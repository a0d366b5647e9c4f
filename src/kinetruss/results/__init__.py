"""Frozen result records with axes, units, provenance and status. Parts that need xarray are imported when first used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late
from kinetruss.results.records.arrays import Arrays, Axes, Column, Columns, variable
from kinetruss.results.records.drive_run import DriveRun, Episode
from kinetruss.results.records.records import Demand, Forces, Motion, Result, Sections, Status, Verdict
from kinetruss.results.records.rows import Row, row_text, rows_of
from kinetruss.results.records.simulation import Occurrence, Passage, Simulation

if TYPE_CHECKING:
    from kinetruss.results.records.provenance import model_hash, provenance

__all__ = [
    "Arrays", "Axes", "Column", "Columns", "Demand", "DriveRun", "Episode", "Forces", "Motion", "Occurrence", "Passage",
    "Result", "Row", "Sections", "Simulation", "Status", "Verdict", "model_hash", "provenance", "row_text", "rows_of",
    "variable",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "records.provenance": "model_hash provenance",
    },
)
