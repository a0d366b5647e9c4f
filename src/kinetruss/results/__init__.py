"""Frozen result records with axes, units, provenance and status."""

from kinetruss.results._provenance import model_hash, provenance
from kinetruss.results._records import Demand, Forces, Motion, Result, Sections, Status, Verdict
from kinetruss.results._variable import variable

__all__ = ["Demand", "Forces", "Motion", "Result", "Sections", "Status", "Verdict", "model_hash", "provenance", "variable"]
