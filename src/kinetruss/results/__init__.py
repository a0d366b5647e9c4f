"""Frozen result records with axes, units, provenance and status."""

from kinetruss.results._provenance import model_hash, provenance
from kinetruss.results._records import Demand, Forces, Motion, Result, Sections, Status, Verdict
from kinetruss.results._rows import Row, row_text, rows_of
from kinetruss.results._variable import variable

__all__ = [
    "Demand", "Forces", "Motion", "Result", "Row", "Sections", "Status", "Verdict", "model_hash", "provenance", "row_text",
    "rows_of", "variable",
]  # fmt: skip
