"""Frozen result records with axes, units, provenance and status. What needs xarray is imported when first used."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.results._drive_run import DriveRun, Episode
from kinetruss.results._records import Demand, Forces, Motion, Result, Sections, Status, Verdict
from kinetruss.results._rows import Row, row_text, rows_of
from kinetruss.results._simulation import Occurrence, Passage, Simulation

if TYPE_CHECKING:
    from kinetruss.results._dataset import dataset, fixed_coordinates
    from kinetruss.results._provenance import model_hash, provenance
    from kinetruss.results._variable import variable

__all__ = [
    "Demand", "DriveRun", "Episode", "Forces", "Motion", "Occurrence", "Passage", "Result", "Row", "Sections", "Simulation",
    "Status", "Verdict", "dataset", "fixed_coordinates", "model_hash", "provenance", "row_text", "rows_of", "variable",
]  # fmt: skip

_LATER = {
    "dataset": "_dataset",
    "fixed_coordinates": "_dataset",
    "model_hash": "_provenance",
    "provenance": "_provenance",
    "variable": "_variable",
}


def __getattr__(name: str) -> Any:
    if name in _LATER:
        return getattr(importlib.import_module(f"kinetruss.results.{_LATER[name]}"), name)
    raise AttributeError(f"module 'kinetruss.results' has no attribute {name!r}")
