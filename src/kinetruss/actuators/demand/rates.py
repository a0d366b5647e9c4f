"""Rate of change of a sampled current."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["current_rate"]

FEWEST = 4
"""Samples a cubic spline needs."""


def current_rate(
    time: NDArray[np.float64], current: NDArray[np.float64], moving: NDArray[np.float64], thrust: NDArray[np.float64]
) -> NDArray[np.float64]:
    """dI/dt (A/s), shape (times,), from samples of the current.

    The current jumps where the motion turns (friction turns with it) and bends where the thrust does: between two such
    places the derivative of a cubic spline through the samples is taken, exact to the third order of their distance; of two
    or three samples, differences. A sample alone between two jumps has none: the spike of a jump is not counted.
    """
    found = np.zeros_like(current)
    signs = 3 * np.sign(moving) + np.sign(thrust)
    cuts = np.flatnonzero(np.diff(signs)) + 1
    for part in np.split(np.arange(len(time)), cuts):
        if len(part) >= FEWEST:
            from scipy.interpolate import CubicSpline

            found[part] = CubicSpline(time[part], current[part])(time[part], 1)
        elif len(part) > 1:
            found[part] = np.gradient(current[part], time[part])
    return found
