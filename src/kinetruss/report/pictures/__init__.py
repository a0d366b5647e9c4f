"""Figures and line drawings."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.pictures.quantities import ALIASES, BUNDLES, FED, QUANTITIES

__all__ = ["ALIASES", "BUNDLES", "FED", "QUANTITIES"]

__getattr__, __dir__ = late(__name__, {"quantities": "ALIASES BUNDLES FED QUANTITIES"})
