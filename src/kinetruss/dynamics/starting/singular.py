"""Data of a start near a singular position, and the limits of pivots at which a position is singular."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["EXACTLY", "SINGULAR", "Singular"]

SINGULAR = 1e-3
"""A position is singular if its scaled pivot is below this fraction of the largest one so far."""
EXACTLY = 1e-7
"""Fraction of the largest scaled pivot below which the distance to a singular position is lost in round-off."""


class Singular(NamedTuple):
    """A start near a singular position.

    pivot, most : scaled pivot at the start, and the largest one near it. gain : size of the accelerations near it, m/s^2.
    a (3 n,) : accelerations that the equations give at the start. size : length of the shortest member, m.
    """

    pivot: float
    most: float
    gain: float
    a: NDArray[np.float64]
    size: float

    @property
    def near(self) -> bool:
        """True if the equations do not give accurate accelerations at the start."""
        return self.pivot < SINGULAR * self.most
