"""What is known of a start next to a singular position, and from which pivot on a position counts as one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["EXACTLY", "SINGULAR", "Singular"]

SINGULAR = 1e-3
"""A position is singular where its scaled pivot is below this part of the largest one met."""
EXACTLY = 1e-7
"""Part of the largest scaled pivot met, below which round-off tells no more how near a position is to a singular one."""


class Singular(NamedTuple):
    """A start next to a singular position.

    pivot, most : scaled pivots there and beside it. gain : largest acceleration beside it, m/s^2; a (3 n,) : what the equations
    give at the start. size : of the shortest member, m.
    """

    pivot: float
    most: float
    gain: float
    a: NDArray[np.float64]
    size: float

    @property
    def near(self) -> bool:
        """True where the equations do not give a good acceleration at the start."""
        return self.pivot < SINGULAR * self.most
