"""Deformation modes of beams as quadratic forms of positions: gradients, geometric stiffness, damping.

A mode is m_s = sum m_sw c_w over the pairs w of nodes, with c_w = |d_w|^2. Its gradient B_s is linear in positions and its
second derivative H_s constant, so that H_s v = B_s(v). Mode forces S give the nodes the forces -sum S_s B_s; with damping
S_s = R_s (m_s + b m_s') and m_s' = B_s . v (Kelvin and Voigt).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.beams.elements import BeamElements

__all__ = ["damping_forces", "damping_tangents", "mode_gradients", "mode_rates", "mode_stiffness", "pairs_of"]

Floats = Any


def pairs_of(found: BeamElements) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Nodes (k, w) of the pairs of every beam."""
    i, j = np.triu_indices(found.nodes.shape[1], 1)
    return found.nodes[:, i], found.nodes[:, j]


def mode_rates(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rates of the modes (times, k, s), 1/s, at x, v (times, n, 3)."""
    p, q = pairs_of(found)
    return np.asarray(np.einsum("ksw,tkw->tks", found.modes, 2 * np.sum((x[:, q] - x[:, p]) * (v[:, q] - v[:, p]), axis=-1)))


def mode_stiffness(found: BeamElements, forces: NDArray[np.float64], count: int) -> csr_array:
    """sum S_s H_s of mode forces (k, s), (3 count, 3 count), N/m: the forces on the nodes are minus this times x."""
    p, q = (nodes.reshape(-1) for nodes in pairs_of(found))
    density = 2 * np.einsum("ks,ksw->kw", forces, found.modes).reshape(-1)
    rows, columns = np.concatenate([p, q, p, q]), np.concatenate([p, q, q, p])
    values = np.concatenate([density, density, -density, -density])
    at = (3 * rows[:, None] + np.arange(3)).reshape(-1), (3 * columns[:, None] + np.arange(3)).reshape(-1)
    return csr_array(coo_array((np.repeat(values, 3), at), shape=(3 * count, 3 * count)))


def damping_forces(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces -sum b R_s m_s' B_s of the damping on the nodes (times, n, 3), N, at x, v (times, n, 3)."""
    out = np.zeros_like(x)
    damped = found.damping[:, None] * found.rigidity * mode_rates(found, x, v)
    for i, one in enumerate(damped):
        out[i] = -(mode_stiffness(found, one, x.shape[1]) @ x[i].reshape(-1)).reshape(-1, 3)
    return out


def damping_tangents(found: BeamElements, x: NDArray[np.float64], v: NDArray[np.float64] | None) -> tuple[Any, Any]:
    """Minus the derivatives of `damping_forces` by x and by v, (3 n, 3 n), at x, v (n, 3).

    By v: sum b R B B^T; by x: sum b R (m' H + B(x) B(v)^T), 0 at rest.
    """
    size = x.size
    share = found.damping[:, None] * found.rigidity
    here = mode_gradients(found, x)
    weight = share.reshape(-1)[:, None]
    C = here.T @ (here * weight)
    if v is None or not np.any(v):
        return csr_array((size, size)), C
    rates = mode_rates(found, x[None], v[None])[0]
    return mode_stiffness(found, share * rates, len(x)) + here.T @ (mode_gradients(found, v) * weight), C


def mode_gradients(found: BeamElements, x: NDArray[np.float64]) -> csr_array:
    """B (beams x modes, 3 n) at positions x (n, 3)."""
    p, q = pairs_of(found)
    k, s = found.modes.shape[:2]
    part = 2 * found.modes[..., None] * (x[q] - x[p])[:, None]
    row = np.broadcast_to(np.arange(k * s).reshape(k, s, 1, 1), part.shape)
    rows, columns = [], []
    for nodes in (p, q):
        rows.append(row.reshape(-1))
        columns.append(np.broadcast_to((3 * nodes[:, :, None] + np.arange(3))[:, None], part.shape).reshape(-1))
    values = np.concatenate([-part.reshape(-1), part.reshape(-1)])
    at = np.concatenate(rows), np.concatenate(columns)
    return csr_array(coo_array((values, at), shape=(k * s, x.size)))
