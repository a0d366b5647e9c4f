"""The view of all pictures: projects points in space onto paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["VIEWS", "eye", "projected"]

VIEWS = {"iso": (-62.0, 16.0), "front": (-90.0, 0.0), "side": (0.0, 0.0), "top": (-90.0, 90.0)}
"""Azimuth and elevation of the views, degrees."""


def eye(view: str) -> NDArray[np.float64]:
    """Unit vector (3,) from the structure to the eye."""
    azimuth, elevation = np.radians(VIEWS[view])
    return np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])


def projected(points: NDArray[np.float64], view: str = "iso") -> NDArray[np.float64]:
    """Points (.., 2) or (.., 3), m, on paper (.., 2): the plane as it is, space in parallel projection with z upright."""
    if points.shape[-1] == 2:
        return points
    toward = eye(view)
    right = np.array([-np.sin(np.radians(VIEWS[view][0])), np.cos(np.radians(VIEWS[view][0])), 0.0])
    seen: NDArray[np.float64] = points @ np.column_stack([right, np.cross(toward, right)])
    return seen
