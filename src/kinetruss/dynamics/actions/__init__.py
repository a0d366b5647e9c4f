"""Actions on bars between their ends: loads, clamped masses, couples of drives and couplings."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.dynamics.actions.bar_actions import (
        acting_along,
        action_coordinates,
        action_variables,
        actions_of,
        mean_tension_at_rest,
    )

__all__ = ["acting_along", "action_coordinates", "action_variables", "actions_of", "mean_tension_at_rest"]

__getattr__, __dir__ = late(
    __name__,
    {
        "bar_actions": "acting_along action_coordinates action_variables actions_of mean_tension_at_rest",
    },
)
