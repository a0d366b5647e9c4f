"""The eye of all pictures: where a point in space is seen on paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["projected"]

AZIMUTH, ELEVATION = np.radians(-62.0), np.radians(16.0)


def projected(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points (n, 2) or (n, 3), m, on paper (n, 2): the plane as it is, space in parallel projection with z upright."""
    if points.shape[1] == 2:
        return points
    right = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0])
    toward = np.array([np.cos(AZIMUTH) * np.cos(ELEVATION), np.sin(AZIMUTH) * np.cos(ELEVATION), np.sin(ELEVATION)])
    seen: NDArray[np.float64] = points @ np.column_stack([right, np.cross(toward, right)])
    return seen
