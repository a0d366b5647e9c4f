"""Rows that are redundant all around the start, not only there: in a singular position more rows depend on each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels._plan import ANGLE
from kinetruss.system import Arrangement, System, jacobian, measured, rearrange

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["redundant_nearby"]

STEP = 1e-3
"""How far to look, in parts of the shortest member."""


def redundant_nearby(system: System) -> Arrangement:
    """The arrangement with the fewest redundant rows: at the start, a little on along its velocities, or in any direction."""
    found = rearrange(system, system.x0, None)
    if not len(found.extra):
        return found
    for direction in _directions(system):
        x = _closed(system, direction)
        if x is not None:
            there = rearrange(system, x, None)
            found = there if len(there.extra) < len(found.extra) else found
    return found


def _directions(system: System) -> list[NDArray[np.float64]]:
    """Changes (n, 3) of positions that the rows allow, largest 1."""
    free, J = system.free, jacobian(system, system.x0)
    given = system.velocity0.reshape(-1)[free]
    any_way = np.random.default_rng(0).standard_normal(len(free))
    any_way -= np.linalg.lstsq(J, J @ any_way, rcond=1e-9)[0]
    found = []
    for change in (given, any_way):
        if (largest := np.abs(change).max(initial=0.0)) > 0:
            full = np.zeros(system.x0.size)
            full[free] = change / largest
            found.append(full.reshape(-1, 3))
    return found


def _closed(system: System, direction: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Positions (n, 3) a little along a direction, with rows as long as they are at the start; None where they do not close."""
    p, q = system.p[system.row_member], system.q[system.row_member]
    wanted = np.linalg.norm(system.x0[q] - system.x0[p], axis=1)
    size, sums = float(wanted.min()), system.sums
    start = [measured(system, system.row_measure[r], system.x0[None])[0, 0] for r in sums]
    x, angle = system.x0 + STEP * size * direction, system.row_kind == ANGLE
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
        x.reshape(-1)[system.free] -= np.linalg.lstsq(J, gap, rcond=1e-12)[0]
    return None
