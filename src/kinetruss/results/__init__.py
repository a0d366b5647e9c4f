"""Frozen result records with axes, units, provenance and status."""

from kinetruss.results._records import Demand, Forces, Motion, Result, Sections, Status, Verdict

__all__ = ["Demand", "Forces", "Motion", "Result", "Sections", "Status", "Verdict"]
