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
    from kinetruss.dynamics.actions.bearings import (
        couples_on_ends,
        friction_directions,
        friction_on_arms,
        refuse_bearings,
        relative_rates,
        seats_of,
    )
    from kinetruss.dynamics.actions.hinges import couples_at_hinges
    from kinetruss.dynamics.actions.hubs import braces_of_hubs, grounded_tips
    from kinetruss.dynamics.actions.records import CarriedBy

__all__ = [
    "CarriedBy",
    "acting_along",
    "action_coordinates",
    "action_variables",
    "actions_of",
    "braces_of_hubs",
    "couples_at_hinges",
    "couples_on_ends",
    "friction_on_arms",
    "friction_directions",
    "refuse_bearings",
    "relative_rates",
    "seats_of",
    "grounded_tips",
    "mean_tension_at_rest",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "bar_actions": "acting_along action_coordinates action_variables actions_of mean_tension_at_rest",
        "bearings": "couples_on_ends friction_on_arms friction_directions refuse_bearings relative_rates seats_of",
        "hinges": "couples_at_hinges",
        "hubs": "braces_of_hubs grounded_tips",
        "records": "CarriedBy",
    },
)
