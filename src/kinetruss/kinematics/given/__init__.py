"""Given motions: arrays, tables, supports; checks that a model can follow them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.given.own_motion import check_motion
    from kinetruss.kinematics.given.support import check_support, check_supports
    from kinetruss.kinematics.given.tables import check_reach, monotone, table_notes

__all__ = ["check_motion", "check_reach", "check_support", "check_supports", "monotone", "table_notes"]

__getattr__, __dir__ = late(
    __name__,
    {
        "own_motion": "check_motion",
        "support": "check_support check_supports",
        "tables": "check_reach monotone table_notes",
    },
)
