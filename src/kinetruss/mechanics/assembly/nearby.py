"""Rows that are redundant near the start as well as at it: in a singular position further rows become dependent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.mechanics import RANK_TOLERANCE, Arrangement, System, jacobian, measured, rearrange

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Redundancy", "redundant_nearby"]

STEPS = 1e-3, 3e-2
"""Distances from the start as fractions of the shortest member; a farther one only if no nearer one could be reached."""
OFF = 0.05
"""Distance that nodes are moved off the closed loops, as a fraction of the shortest member."""
DEPENDENT = 1e-5
"""Singular values below this fraction of the largest, with loops closed, count as dependent rows."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Redundancy:
    """The redundant rows at and near a start configuration.

    arrangement : the one with the fewest redundant rows. sure : a configuration away from the start has as few, so they are
        redundant along the whole motion. bound : some rows are dependent only if the loops are closed (Bennett, Bricard),
            not at arbitrary positions.
    """

    arrangement: Arrangement
    sure: bool = False
    bound: bool = False


def redundant_nearby(system: System) -> Redundancy:
    """The fewest redundant rows at the start, or a small step away along its velocities or any allowed direction."""
    found, sure = rearrange(system, system.x0, None), False
    if not len(found.redundant):
        return Redundancy(arrangement=found)
    directions = _directions(system)
    # rank a little on along the motion: rows that depend on others at the start alone are not redundant
    for step in STEPS:
        for direction in directions:
            x = _closed(system, direction, step)
            if x is not None:
                there = rearrange(system, x, None)
                if len(there.redundant) <= len(found.redundant):
                    found, sure = (there if len(there.redundant) < len(found.redundant) else found), True
        if sure:
            break
    return Redundancy(arrangement=found, sure=sure, bound=_bound(system, len(found.redundant)))


def _bound(system: System, redundant: int) -> bool:
    """True if fewer rows are redundant at positions that do not close the loops."""
    x = system.x0.reshape(-1).copy()
    moved = np.random.default_rng(1).standard_normal(len(system.free))
    x[system.free] += OFF * float(system.length0[system.row_member].min()) * moved
    J = jacobian(system, x.reshape(-1, 3))
    return len(J) - int(np.linalg.matrix_rank(J, tol=RANK_TOLERANCE * np.linalg.norm(J, 2))) < redundant


def _directions(system: System) -> list[NDArray[np.float64]]:
    """Changes (n, 3) of positions that the rows allow, largest 1."""
    free, J = system.free, jacobian(system, system.x0)
    given = system.velocity0.reshape(-1)[free]
    # in a singular position few directions can be followed; that of least weighted change, with weights in a row, is one of
    # them
    ways = [np.random.default_rng(0).standard_normal(len(free))]
    ways += [np.equal(free % 3, axis) * 1.0 for axis in range(system.dim)]
    # projection of each direction onto the null space of J
    along = [(way - np.linalg.lstsq(J, J @ way, rcond=1e-9)[0], 1e-9) for way in ways]
    found = []
    for change, least in ((given, 0.0), *along):
        if (largest := np.abs(change).max(initial=0.0)) > least:
            full = np.zeros(system.x0.size)
            full[free] = change / largest
            found.append(full.reshape(-1, 3))
    return found


def _closed(system: System, direction: NDArray[np.float64], step: float) -> NDArray[np.float64] | None:
    """Positions (n, 3) a small step along a direction, with all constraints closed; None if they cannot be closed."""
    p, q = system.p[system.row_member], system.q[system.row_member]
    wanted = np.linalg.norm(system.x0[q] - system.x0[p], axis=1)
    size, sums = float(wanted.min()), system.sums
    start = [measured(system, system.row_measure[r], system.x0[None])[0, 0] for r in sums]
    x, angle = system.x0 + step * size * direction, system.row_kind == ANGLE
    # Newton's method, least change, for Phi(x) = 0
    for _ in range(30):
        J, d = jacobian(system, x), x[q] - x[p]
        gap = np.linalg.norm(d, axis=1) - wanted
        if angle.any():
            theta = system.drive_start[system.row_drive[angle]]
            gap[angle] = d[angle, 1] * np.cos(theta) - d[angle, 0] * np.sin(theta)
        for r, value in zip(sums, start, strict=True):
            m = system.row_measure[r]
            gap[r] = system.measure_scale[m] * (measured(system, m, x[None])[0, 0] - value)
        if np.abs(gap).max() < 1e-13 * size:
            return x
        x.reshape(-1)[system.free] -= np.linalg.lstsq(J, gap, rcond=DEPENDENT)[0]
    return None
