"""Forces of drives that hold a structure at rest."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kinematics.rates.jacobian import sensitivities
from kinetruss.mechanics.assembly import balance_of
from kinetruss.mechanics.freedom import coordinates

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["holding"]


def holding(system: System) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    """The drive forces (times, d), N or N m, that hold gravity and all loads at rest, as a function of positions (times, 3 n).

    By virtual work: F = -(dx/dq)^T f. Positive if they do positive work when the coordinate grows.
    """
    balance, drives = balance_of(system), coordinates(system, system.drives)

    def at(x: NDArray[np.float64]) -> NDArray[np.float64]:
        f = np.stack([balance.applied(one.reshape(-1, 3)) for one in x])
        return np.asarray(-np.einsum("ti,tid->td", f, sensitivities(system, x, drives)))

    return at
