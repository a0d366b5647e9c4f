"""Forces of drives that hold a structure at rest."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.kinematics.rates.jacobian import sensitivities
from kinetruss.mechanics import jacobian
from kinetruss.mechanics.assembly import balance_of
from kinetruss.mechanics.freedom import coordinates

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["holding", "holding_rates"]


def holding(system: System) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    """The drive forces (times, d), N or N m, that hold gravity and all loads at rest, as a function of positions (times, 3 n).

    By virtual work: F = -(dx/dq)^T f. Positive if they do positive work when the coordinate grows.
    """
    balance, drives = balance_of(system), coordinates(system, system.drives)

    def at(x: NDArray[np.float64]) -> NDArray[np.float64]:
        f = np.stack([balance.applied(one.reshape(-1, 3)) for one in x])
        return np.asarray(-np.einsum("ti,tid->td", f, sensitivities(system, x, drives)))

    return at


def holding_rates(
    system: System,
) -> Callable[[NDArray[np.float64]], tuple[NDArray[np.float64], NDArray[np.float64]]] | None:
    """Drive forces F (d,) as by `holding`, and their derivatives dF_i/dq_j (d, d) by the drives, at positions x (3 n,).

    dF/dq = (dx/dq)^T K dx/dq with the stiffness K of loads and row forces N, J^T N = f: from f = J^T N and J dx/dq_i = e_i in
    all configurations. None for redundant structures, springs, membranes, solids and driven angles of bars.
    """
    angles = system.row_kind == ANGLE
    if len(system.row_member) != len(system.free) or len(system.springs) or system.continua is not None or angles.any():
        return None
    balance, drives = balance_of(system), coordinates(system, system.drives)

    def at(x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        place = x.reshape(-1, 3)
        f, columns = balance.applied(place), sensitivities(system, x[None], drives)[0]
        N = np.asarray(np.linalg.solve(jacobian(system, place).T, f[system.free]), np.float64)
        return -columns.T @ f, columns.T @ (balance.stiffness(place, N) @ columns)

    return at
