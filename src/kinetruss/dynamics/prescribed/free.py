"""Forces of mechanisms with free degrees of freedom along a given motion.

There are more equations than bars, so J^T N = f - M a is solved by least squares (singular value decomposition) with the
weights of the least-norm distribution. The residual is the force that would be needed in the free directions.
"""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.plan import NONE
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.kernels.sweep.forces import applied as gather
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian, measure_gradients, rearrange, row_directions
from kinetruss.mechanics.assembly import material_stiffness, nodal_loads, structure_of, with_continua_forces

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["applied", "free_forces", "loose", "out_of_balance", "take_sum_forces"]

BALANCED = 1e-4
"""Residual, as a fraction of the largest nodal load, up to which elastic parts are in balance."""
ROUND_OFF = 1e-12
"""Residual, as a fraction of the stiffness times the size of the structure, that is round-off."""


def free_forces(
    system: System, loads: Any, values: NDArray[np.float64], states: States, N: NDArray[np.float64], ends: EndForces
) -> NDArray[np.bool_]:
    """Fill N and ends like the kernel with the same arguments; returns the mask of constraints with a force not unique."""
    x, (joint, rest) = states.x, ends
    applied(system, loads, states, ends)
    arrangement = rearrange(system, x[0].reshape(-1, 3), values[0])
    scale = np.sqrt(arrangement.weight)
    p, q = system.p[system.row_member], system.q[system.row_member]
    for i, place in enumerate(x.reshape(len(x), -1, 3)):
        J = jacobian(system, place, values[i])
        N[i] = np.linalg.pinv(J.T / scale, rcond=RANK_TOLERANCE) @ rest[i, system.free] / scale
        tension = N[i][:, None] * row_directions(system, place, values[i])
        np.add.at(rest[i].reshape(-1, 3), p, tension)
        np.subtract.at(rest[i].reshape(-1, 3), q, tension)
        np.subtract.at(joint[i, :, 0], system.row_member, tension)
        np.add.at(joint[i, :, 1], system.row_member, tension)
    take_sum_forces(system, x, N, rest)
    return arrangement.not_unique


def out_of_balance(system: System, loads: Any, x: NDArray[np.float64], rest: NDArray[np.float64]) -> float:
    """Largest residual (times, 3 n) at free coordinates, N, where beams, membranes or solids are not in balance; else 0."""
    if system.continua is None or not len(x):
        return 0.0
    largest = float(np.abs(with_continua_forces(system, loads, x).force).max(initial=0.0))
    stiff = float(np.abs(material_stiffness(system, x[0].reshape(-1, 3)).diagonal()).max())
    off = float(np.abs(rest[:, system.free]).max(initial=0.0))
    return off if off > BALANCED * largest + ROUND_OFF * stiff * float(np.ptp(system.x0, axis=0).max()) else 0.0


def loose(system: System, rest: NDArray[np.float64], joint: NDArray[np.float64]) -> float:
    """Largest residual (times, 3 n) at free coordinates, N, where elastic bars are not in balance; else 0.

    joint (times, members, 2, 3) : forces at the ends of members, N. Without elastic bars there is none: what a mechanism needs
    in its free directions is no fault of its positions.
    """
    if not len(rest) or not (system.law != NONE).any():
        return 0.0
    off = float(np.abs(rest[:, system.free]).max(initial=0.0))
    size = float(np.abs(joint).max(initial=0.0))
    stiff = float((system.spring * system.natural).max()) if (system.law != NONE).any() else 0.0
    return off if off > BALANCED * size + ROUND_OFF * stiff else 0.0


def take_sum_forces(system: System, x: NDArray[np.float64], N: NDArray[np.float64], rest: NDArray[np.float64]) -> None:
    """Subtract J^T N of the constraints on sums from `rest` (times, 3 n); x (times, 3 n), N (times, rows)."""
    for r in system.sums:
        m = system.row_measure[r]
        g = measure_gradients(system, m, x.reshape(len(x), prod(x.shape[1:]) // 3, 3))
        rest -= system.measure_scale[m] * N[:, [r]] * g


def applied(system: System, loads: Any, states: States, ends: EndForces) -> None:
    """Fill `rest` of the ends with f - M a, N, and `joint` with inertia, weight and elastic forces of members."""
    loads = with_continua_forces(system, loads, states.x, states.v)
    gather(structure_of(system), nodal_loads(loads), states, ends)
