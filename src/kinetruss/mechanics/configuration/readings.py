"""Values of prescribed rows and of drives at given node positions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import lengths as length_rates
from kinetruss.kernels.structure.plan import ANGLE, LENGTH, SUM
from kinetruss.mechanics import System, kept, measured

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["drive_places", "drive_values", "row_values", "shortest"]


def row_values(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Value of each row (length m, angle rad, sum) at positions x (n, 3); angles of sums nearest to the start value."""
    d = x[system.q[system.row_member]] - x[system.p[system.row_member]]
    found = np.where(system.row_kind == ANGLE, np.arctan2(d[:, 1], d[:, 0]), np.linalg.norm(d, axis=1))
    for r in system.sums:
        found[r] = measured(system, system.row_measure[r], x[None])[0, 0]
    return found


def drive_values(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Values, rates and accelerations (times, drives) that given node motions (times, n, 3) have at the drives."""
    value, rate, second = (np.zeros((len(x), len(system.drives))) for _ in range(3))
    for flat, d in system.coordinate_drive:
        node, axis = divmod(int(flat), 3)
        value[:, d], rate[:, d], second[:, d] = x[:, node, axis], v[:, node, axis], a[:, node, axis]
    driven = np.flatnonzero(system.row_drive >= 0)
    along = driven[system.row_kind[driven] == LENGTH]
    if len(along):
        member, d = system.row_member[along], system.row_drive[along]
        found = allocate(*[(len(x), len(along))] * 3)
        flat = (np.ascontiguousarray(y).reshape(len(x), system.x0.size) for y in (x, v, a))
        length_rates(system.p[member], system.q[member], *flat, *found)
        value[:, d], rate[:, d], second[:, d] = found
    for r in driven[system.row_kind[driven] != LENGTH]:
        i, d = system.row_member[r], system.row_drive[r]
        if (m := system.row_measure[r]) >= 0:
            value[:, d], rate[:, d], second[:, d] = measured(system, m, x, v, a).T
            continue
        dx, dv, da = (y[:, system.q[i]] - y[:, system.p[i]] for y in (x, v, a))
        square, turn = np.einsum("tc,tc->t", dx, dx), dx[:, 0] * dv[:, 1] - dx[:, 1] * dv[:, 0]
        value[:, d] = np.unwrap(np.arctan2(dx[:, 1], dx[:, 0]))
        rate[:, d] = turn / square
        along_bar = np.einsum("tc,tc->t", dx, dv)
        second[:, d] = (dx[:, 0] * da[:, 1] - dx[:, 1] * da[:, 0]) / square - 2 * along_bar * turn / square**2
    return value, rate, second


def drive_places(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (times, drives) that node positions (times, n, 3) have at the drives, each position by itself.

    Angles in the plane are from -pi to pi, others the nearest to that at the start.
    """
    value = np.zeros((len(x), len(system.drives)))
    for flat, d in system.coordinate_drive:
        value[:, d] = x[:, flat // 3, flat % 3]
    for r in np.flatnonzero(system.row_drive >= 0):
        i, d, m = system.row_member[r], system.row_drive[r], system.row_measure[r]
        if m >= 0:
            value[:, d] = measured(system, m, x, along=False)[:, 0]
            continue
        along = x[:, system.q[i]] - x[:, system.p[i]]
        turns = system.row_kind[r] == ANGLE
        value[:, d] = np.arctan2(along[:, 1], along[:, 0]) if turns else np.sqrt(np.einsum("tc,tc->t", along, along))
    return value


@kept()
def shortest(system: System) -> float:
    """Unit of length of step limits: the shortest prescribed bar, m."""
    lengths = system.length0[system.row_member[system.row_kind != SUM]]
    return float(lengths.min()) if len(lengths) else 1.0
