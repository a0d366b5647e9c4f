"""Models and motions under operating conditions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.kinematics.conditions.models import named_condition, under
    from kinetruss.kinematics.conditions.motions import commanded

__all__ = ["commanded", "named_condition", "under"]

__getattr__, __dir__ = late(__name__, {"motions": "commanded", "models": "named_condition under"})
