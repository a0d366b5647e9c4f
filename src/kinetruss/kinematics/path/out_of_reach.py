"""Checks if the prescribed values after the end of a motion can be reached at all, and how near the structure comes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import LENGTH
from kinetruss.kinematics.path.redundant import AGREE, misses
from kinetruss.mechanics import arrange, jacobian
from kinetruss.mechanics.configuration import shortest

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.path.redundant import Path
    from kinetruss.mechanics import System

__all__ = ["out_of_reach"]

LARGEST = 300
"""Number of free coordinates up to which the check is made."""
SHOWN = 3
HELD = 1e4
"""Weight of constraints that are not meant to change: their share of the residual is about 1/weight^2."""


def out_of_reach(system: System, path: Path, k: int, x: NDArray[np.float64]) -> str:
    """Text: how near to sample k of a path the structure comes from the positions x (3 n,); "" if it can be closed there.

    Minimises the sum of squares of all residuals, with those of bars and of drives at rest weighted so that only the moving
    drives miss their values. If the minimum is above round-off, no configuration nearby has the prescribed lengths.
    """
    free = np.flatnonzero(~system.prescribed)
    if len(free) > LARGEST:
        return ""
    from scipy.optimize import least_squares

    rows, values, here = np.arange(len(system.row_member)), path.drive[0][k], x.copy()
    if (plan := arrange(system).plan) is not None:
        here[plan.moving] = path.moving[0][k]

    moved = np.abs(values - path.drive[0][0]) > 0
    weight = np.where((system.row_drive >= 0) & moved[np.maximum(system.row_drive, 0)], 1.0, HELD) if len(moved) else HELD

    def placed(y: NDArray[np.float64]) -> NDArray[np.float64]:
        at = here.copy()
        at[free] = y
        return at

    def gaps(y: NDArray[np.float64]) -> NDArray[np.float64]:
        found: NDArray[np.float64] = weight * misses(system, rows, values[None], placed(y)[None])[0]
        return found

    def slopes(y: NDArray[np.float64]) -> NDArray[np.float64]:
        found: NDArray[np.float64] = np.reshape(weight, (-1, 1)) * jacobian(system, placed(y).reshape(-1, 3), values)
        return found

    # MINPACK's method takes a fiftieth of the time, but needs at least as many equations as unknowns
    method = "lm" if len(rows) >= len(free) else "trf"
    found = least_squares(gaps, here[free], slopes, method=method, xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=200)
    off = gaps(found.x) / weight
    if not np.abs(off).max() > 100 * AGREE * shortest(system):
        return ""
    driven = [r for r in rows if system.row_drive[r] >= 0 and system.row_kind[r] == LENGTH and moved[system.row_drive[r]]]
    driven = sorted((r for r in driven if abs(off[r]) > 0), key=lambda r: -abs(off[r]))[:SHOWN]
    wanted = values[system.row_drive[driven]] if driven else np.zeros(0)
    near = ", ".join(f"{system.row_name(r)} {w + off[r]:.6g} m of {w:.6g} m" for r, w in zip(driven, wanted, strict=True))
    return f"the nearest possible then is {near}" if near else f"the bars would be off by {np.abs(off).max():.3g} m"
