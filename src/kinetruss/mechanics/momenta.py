"""The momenta of a whole structure, and its inertia against rigid motions.

The momenta that belong to a twist (`rigid_motions`) are (p, L): linear, kg m/s, and angular about the place of moments,
kg m^2/s. With the velocities T of the nodes by unit twists, p and L are T^T M v, and T^T M T is the inertia.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.mechanics.matrices import constant_mass, varying_blocks
from kinetruss.mechanics.rigid_motions import resultants, rigid_fields
from kinetruss.mechanics.tables import elements

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System

    Array = NDArray[np.float64]


def mass_times(system: System, x: Array, w: Array) -> Array:
    """M w (times, k, n, 3) at positions x (times, n, 3) of k velocities w (times, k, n, 3) of all nodes."""
    flat = w.reshape(-1, system.x0.size)
    found = np.asarray((constant_mass(system) @ flat.T).T).reshape(w.shape)
    own = elements(system)
    if len(own["varying"]):
        A, B = own["varying_A"] // 3, own["varying_B"] // 3
        AA, AB, BB = (block[:, None] for block in varying_blocks(system, x))
        a, b = (w[:, :, ends, :, None] for ends in (A, B))
        for ends, push in ((A, AA @ a + AB @ b), (B, AB @ a + BB @ b)):
            np.add.at(found.swapaxes(0, 2), ends, push[..., 0].swapaxes(0, 2))
    return found


def inertia_and_momenta(system: System, x: Array, v: Array) -> tuple[Array, Array]:
    """T^T M T (times, 6, 6) and T^T M v (times, 6) at positions x (times, n, 3) from the place of moments, and velocities v."""
    found = resultants(x[:, None], mass_times(system, x, np.concatenate([rigid_fields(x), v[:, None]], axis=1)))
    return np.ascontiguousarray(found[:, :6]), np.ascontiguousarray(found[:, 6])
