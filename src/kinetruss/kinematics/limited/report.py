"""What a motion says about the limits of its drives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kinematics.limited.holding import holding
from kinetruss.kinematics.limited.uses import LIMIT_ATTRS, Limits, motion_uses, uses_text
from kinetruss.results.records import MOTORS_UNCHECKED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["reported"]


def reported(
    system: System, limits: Limits, why: str, t: NDArray[np.float64], x: NDArray[np.float64], drives: Any
) -> dict[str, Any]:
    """`LIMIT_ATTRS` and `MOTORS_UNCHECKED` of a motion, and `words`, what is to be said; empty if there are no limits.

    why : limits that are not kept are not; x (times, 3 n) of the good samples; drives : values, rates and second rates.
    """
    good = len(x)
    if not good:
        return {}
    t, force = t[:good], holding(system)(x) if np.isfinite(limits.force).any() else None
    uses = motion_uses(limits, system.drives, t, (drives[1][:good], drives[2][:good]), force)
    words = [uses_text(uses, t, why)]
    data: dict[str, Any] = {"words": " ".join(one for one in words if one)}
    if limits.others:
        data[MOTORS_UNCHECKED] = list(limits.others)
    if uses:
        worst = uses[0]
        values = (int(worst.kept), worst.limit, worst.drive, worst.time, worst.ratio)
        data |= dict(zip(LIMIT_ATTRS, values, strict=True))
    return data
