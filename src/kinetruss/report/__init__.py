"""What people read: tables, figures. Reads results and computes no physics; drawing is loaded when something is drawn."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.report._summary import summary, summary_text
from kinetruss.report._text import number, quantity, table

if TYPE_CHECKING:
    from kinetruss.report._figures import figures
    from kinetruss.report._joints import JointForces, joints, joints_record, joints_text
    from kinetruss.report._plot import plot

__all__ = [
    "PICTURES", "JointForces", "figures", "joints", "joints_record", "joints_text", "number", "plot", "quantity", "summary",
    "summary_text", "table",
]  # fmt: skip

PICTURES = "pictures"
"""Folder in a run folder that its pictures go to."""

_LATER = {
    "figures": "_figures", "plot": "_plot",
    "JointForces": "_joints", "joints": "_joints", "joints_record": "_joints", "joints_text": "_joints",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _LATER:
        return getattr(importlib.import_module(f"kinetruss.report.{_LATER[name]}"), name)
    raise AttributeError(f"module 'kinetruss.report' has no attribute {name!r}")
