"""Strain gauges: simulated and measured readings."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.strength.strain_gauges.compare_gauges import inside

__all__ = ["inside"]

__getattr__, __dir__ = late(__name__, {"compare_gauges": "inside"})
