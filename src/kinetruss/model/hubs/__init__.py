"""Nodes of finite size: rigid hubs whose members end at the tips of arms."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.hubs.arms import apexes, arm_through, arms_of, clamped_at, free_length, hub_of, is_grounded, loops
    from kinetruss.model.hubs.bearings import bearing_faults, seat_of
    from kinetruss.model.hubs.expand import with_arms
    from kinetruss.model.hubs.hinges import Pivot, pivots_of
    from kinetruss.model.hubs.record import Hub

__all__ = [
    "Hub",
    "Pivot",
    "apexes",
    "arm_through",
    "arms_of",
    "bearing_faults",
    "clamped_at",
    "free_length",
    "hub_of",
    "is_grounded",
    "loops",
    "pivots_of",
    "seat_of",
    "with_arms",
]

__getattr__, __dir__ = late(
    __name__,
    {
        "arms": "apexes arm_through arms_of clamped_at free_length hub_of is_grounded loops",
        "bearings": "bearing_faults seat_of",
        "expand": "with_arms",
        "hinges": "Pivot pivots_of",
        "record": "Hub",
    },
)
