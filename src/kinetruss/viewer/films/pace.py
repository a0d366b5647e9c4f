"""The speed of a film that has none given."""

from __future__ import annotations

import numpy as np

__all__ = ["usual_speed"]

ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0)
LEAST, MOST = 5.0, 8.0
"""Length, s, of a film whose speed is not given; as in the page (`usualSpeed`)."""


def usual_speed(duration: float) -> float:
    """The round speed at which a run of a duration, s, takes 5 to 8 s."""
    if not 0 < duration < np.inf:
        return 1.0
    power = int(np.floor(np.log10(duration / MOST)))
    several = [float(f"{one * tens:g}e{power}") for tens in (1, 10) for one in ROUND]
    return next((one for one in several if LEAST <= duration / one <= MOST), 1.0)
