"""Stiffness and damping of friction about pins (kernels.structure.pins), as sparse matrices."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array

from kinetruss.mechanics.assembly.tables import pins_of
from kinetruss.mechanics.structure.constraint_gradients import angle_hessians, turned

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["friction_tangents"]


def friction_tangents(system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None) -> tuple[Any, Any]:
    """K and C (3 n, 3 n), N/m and N s/m: minus the derivatives of the forces -c (g . v) g by x and by v, both (n, 3).

    g, H : gradient and Hessian of the angle between the two bars of a pair by the positions of its pin and its far ends. So
    C = c g g^T and K = c (g (H v)^T + (g . v) H).
    """
    node, first, second, c = pins_of(system)
    far = [system.p[m] + system.q[m] - node for m in (first, second)]
    far[1] = np.where(second < 0, node, far[1])
    by_node, H_by_node = np.zeros((len(c), 3, 3)), np.zeros((len(c), 3, 3, 3, 3))
    # gradient g and Hessian H of the angle between the bars, by the pin and both far ends
    for place, (end, sign) in enumerate(zip(far, (1.0, -1.0), strict=True), start=1):
        moving = end != node
        d = x[end[moving]] - x[node[moving]]
        L = np.linalg.norm(d, axis=1)
        u = d / L[:, None]
        gradient, hessian = sign * turned(u) / L[:, None], sign * angle_hessians(u, L) / L[:, None, None]
        by_node[moving, place] += gradient
        by_node[moving, 0] -= gradient
        for i, j, s in ((0, 0, 1.0), (0, place, -1.0), (place, 0, -1.0), (place, place, 1.0)):
            H_by_node[moving, i, :, j] += s * hessian
    nodes = np.stack([node, *far], axis=1)
    g, H = by_node.reshape(-1, 9), H_by_node.reshape(-1, 9, 9)
    # C = c g g^T
    C = c[:, None, None] * g[:, :, None] * g[:, None, :]
    rates = np.zeros_like(g) if v is None else v[nodes].reshape(-1, 9)
    bent, rate = np.einsum("kij,kj->ki", H, rates), np.einsum("ki,ki->k", g, rates)
    # K = c (g (H v)^T + (g . v) H)
    K = c[:, None, None] * (g[:, :, None] * bent[:, None, :] + rate[:, None, None] * H)
    flat = (3 * nodes[:, :, None] + np.arange(3)).reshape(-1, 9).astype(np.int64)
    where = np.repeat(flat, 9, axis=1).reshape(-1), np.tile(flat, (1, 9)).reshape(-1)
    shape = (system.x0.size, system.x0.size)
    return csr_array((K.reshape(-1), where), shape=shape), csr_array((C.reshape(-1), where), shape=shape)
