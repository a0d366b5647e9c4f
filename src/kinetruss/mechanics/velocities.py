"""Velocities of a start of which only some nodes are given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.mechanics.row_gradients import RANK_TOLERANCE, jacobian

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.mechanics.system import System


LARGEST = 2000
"""Number of free coordinates up to which velocities that were not given are computed."""

REPORTED = 1e-9
"""A relative change of the start below this value is round-off and not reported."""


def named_coordinates(system: System, velocities: Mapping[str, Sequence[float]] | ArrayLike | None) -> NDArray[np.bool_]:
    """Mask of flat coordinates (3 n,) whose velocity is given by name; all if velocities are an array."""
    named = system.model.velocities if velocities is None else velocities
    if not isinstance(named, Mapping):
        return np.ones(3 * len(system.nodes), bool)
    return np.repeat(np.isin(system.nodes, list(named)), 3)


def completed_velocities(
    reduced: System, x: NDArray[np.float64], v: NDArray[np.float64], allowed: NDArray[np.float64], named: NDArray[np.bool_]
) -> NDArray[np.float64] | None:
    """Velocities (3 n,) that keep those of named coordinates and satisfy the constraints by moving other nodes.

    reduced : the system with the active constraints. v : given velocities, else 0. allowed : any velocities that satisfy the
    constraints at positions x (3 n,). The other coordinates get the velocities of least norm. Returns None if nothing is left
    to complete, or the given velocities contradict each other.
    """
    free = reduced.free
    open_ = ~named[free]
    speed = float(np.abs(v).max(initial=0.0))
    fits = bool(np.abs(allowed - v)[free].max(initial=0.0) <= REPORTED * speed)
    if fits or not open_.any() or open_.all() or len(free) > LARGEST:
        return None
    J = jacobian(reduced, x.reshape(-1, 3))
    wanted = J @ allowed[free] - J[:, ~open_] @ v[free][~open_]
    rest = np.linalg.lstsq(J[:, open_], wanted, rcond=RANK_TOLERANCE)[0]
    if np.abs(J[:, open_] @ rest - wanted).max(initial=0.0) > REPORTED * speed:
        return None
    found = allowed.copy()
    found[free[open_]], found[free[~open_]] = rest, v[free[~open_]]
    return found
