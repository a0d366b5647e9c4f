"""Directions of members in space: local axes from a line and a direction that spans a plane with it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def axes_along(d: NDArray[Any], h: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Axes 1, 2, 3 (..., 3) in space of a member along d whose plane 1-2 the direction h spans with it; complex or not."""
    one = unit(d)
    two = unit(h - one * np.sum(h * one, axis=-1, keepdims=True))
    return one, two, np.cross(one, two)


def unit(d: NDArray[Any]) -> NDArray[Any]:
    """Directions of vectors (..., 3); complex ones allowed."""
    return np.asarray(d / np.sqrt(np.sum(d * d, axis=-1, keepdims=True)))


def start_references(x0: NDArray[np.float64], p: NDArray[np.int32], q: NDArray[np.int32]) -> NDArray[np.float64]:
    """Reference directions (m, 3) in space: z, or x for members within 18 deg of z at the positions x0 (n, dim)."""
    reference = np.zeros((len(p), 3))
    if x0.shape[1] == 3:
        d = x0[q] - x0[p]
        upright = np.abs(d[:, 2]) > 0.95 * np.linalg.norm(d, axis=1)
        reference[:, 2], reference[:, 0] = ~upright, upright
    return reference
