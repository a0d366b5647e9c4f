"""Forces of least norm of structures that are not statically determinate, or that leave degrees of freedom free.

There are more equations than bars, so J^T N = f - M a is solved by least squares (singular value decomposition) with the
weights of the least-norm distribution. The residual is the force that would be needed in the free directions.
"""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.kernels.sweep.forces import applied
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian, measure_gradients, rearrange, row_directions
from kinetruss.mechanics.tables import nodal_loads, structure_of

if TYPE_CHECKING:
    from numpy.typing import NDArray


def free_forces(
    system: System, loads: Any, values: NDArray[np.float64], states: States, N: NDArray[np.float64], ends: EndForces
) -> tuple[NDArray[np.bool_], dict[int, NDArray[np.bool_]]]:
    """Fill N and ends like the kernel with the same arguments; returns the mask of constraints with a force not unique, and of
    singular samples, in which more constraints depend on each other than in others, the mask there.
    """
    apply_loads(system, loads, states, ends)
    return least_norm(system, values, states.x, N, ends)


def least_norm(
    system: System, values: NDArray[np.float64], x: NDArray[np.float64], N: NDArray[np.float64], ends: EndForces
) -> tuple[NDArray[np.bool_], dict[int, NDArray[np.bool_]]]:
    """As `free_forces`, with what acts already in the ends."""
    joint, rest = ends
    places = x.reshape(len(x), -1, 3)
    arrangement = rearrange(system, places[0], values[0])
    ranks = _by_singular_values(system, values, places, arrangement.weight, rest, N)
    if best := int(np.argmax(ranks)):
        arrangement = rearrange(system, places[best], values[best])
        ranks = _by_singular_values(system, values, places, arrangement.weight, rest, N)
    p, q = system.p[system.row_member], system.q[system.row_member]
    for i, place in enumerate(places):
        tension = N[i][:, None] * row_directions(system, place, values[i])
        np.add.at(rest[i].reshape(-1, 3), p, tension)
        np.subtract.at(rest[i].reshape(-1, 3), q, tension)
        np.subtract.at(joint[i, :, 0], system.row_member, tension)
        np.add.at(joint[i, :, 1], system.row_member, tension)
    take_sum_forces(system, x, N, rest)
    lower = np.flatnonzero(ranks < ranks.max(initial=0)).tolist()
    return arrangement.not_unique, {i: rearrange(system, places[i], values[i]).not_unique for i in lower}


def _by_singular_values(
    system: System,
    values: NDArray[np.float64],
    places: NDArray[np.float64],
    weight: NDArray[np.float64],
    rest: NDArray[np.float64],
    N: NDArray[np.float64],
) -> NDArray[np.int64]:
    """Fill N (times, rows) with the forces of least sum of weight N^2; returns the ranks (times,)."""
    scale, ranks = np.sqrt(weight), np.zeros(len(places), np.int64)
    # N = W^-1/2 V S^-1 U^T rest with U S V^T = J^T W^-1/2
    for i, place in enumerate(places):
        U, S, V = np.linalg.svd(jacobian(system, place, values[i]).T / scale, full_matrices=False)
        k = ranks[i] = int(np.sum(RANK_TOLERANCE * S.max(initial=0.0) < S))
        N[i] = V[:k].T @ ((U[:, :k].T @ rest[i, system.free]) / S[:k]) / scale
    return ranks


def take_sum_forces(system: System, x: NDArray[np.float64], N: NDArray[np.float64], rest: NDArray[np.float64]) -> None:
    """Subtract J^T N of the constraints on sums from `rest` (times, 3 n); x (times, 3 n), N (times, rows)."""
    for r in system.sums:
        m = system.row_measure[r]
        g = measure_gradients(system, m, x.reshape(len(x), prod(x.shape[1:]) // 3, 3))
        rest -= system.measure_scale[m] * N[:, [r]] * g


def apply_loads(system: System, loads: Any, states: States, ends: EndForces) -> None:
    """Fill `rest` of the ends with f - M a, N, and `joint` with inertia, weight and elastic forces of members."""
    applied(structure_of(system), nodal_loads(loads), states, ends)
