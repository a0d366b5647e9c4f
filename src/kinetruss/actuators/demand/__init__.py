"""Demand on drive trains along a motion, against their limits."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.actuators.demand.evaluate import STANDSTILL, UNMOVED, columns_of
    from kinetruss.actuators.demand.rates import current_rate
    from kinetruss.actuators.demand.summarise import QUANTITIES

__all__ = ["QUANTITIES", "STANDSTILL", "UNMOVED", "columns_of", "current_rate"]

__getattr__, __dir__ = late(
    __name__, {"rates": "current_rate", "evaluate": "STANDSTILL UNMOVED columns_of", "summarise": "QUANTITIES"}
)
