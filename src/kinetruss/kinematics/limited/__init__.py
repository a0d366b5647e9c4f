"""Limits of the rates, accelerations and forces of drives: kept along a task by redundancy, and compared with a motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.limited.uses import LIMIT_ATTRS, Limits, Use, limit_values, motion_uses, slower

__all__ = ["LIMIT_ATTRS", "Limits", "Use", "limit_values", "motion_uses", "slower"]

__getattr__, __dir__ = late(__name__, {"uses": "LIMIT_ATTRS Limits Use limit_values motion_uses slower"})
