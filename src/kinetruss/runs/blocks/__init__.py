"""Runs in blocks of samples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.runs.blocks.planned import SIMULATED, plan

__all__ = ["SIMULATED", "plan"]

__getattr__, __dir__ = late(__name__, {"planned": "SIMULATED plan"})
