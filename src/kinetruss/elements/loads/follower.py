"""Forces and couples on bodies as forces on nodes, which may turn with them.

The nodal forces follow from a vector V and the amount of the load:

    V = V0 + sum_j (c_j + d_j J) r_j + g (r_1 - r_0) x (r_2 - r_0),    J: turned by 90 deg about z
    force    f_i = (w_i + u_i J) V
    couple   f_i = a x (r_i - mean r),  (sum |r|^2 1 - r r^T) a = V;   plane: V_z J r_i/sum |r|^2
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.elements.carriers import fixed_in, planar_share
from kinetruss.elements.loads.load import UnitLoad
from kinetruss.elements.local_axes import turned
from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, Vector, record
from kinetruss.kernels.structure.tables import entry_at

FORCE, COUPLE, FLAT_COUPLE = 0, 1, 2


@record
class Followers(Record):
    """mode (k,); node[ptr[k]:ptr[k + 1]] flat coordinates of the nodes of load k, with data (nodes, 4) c, d, w, u; vector
    (k, 4) V0 and g; amounts value at time, s, from table_ptr[k] on.
    """

    mode: I1
    ptr: I1
    node: I1
    table_ptr: I1
    time: F1
    value: F1
    data: F2
    vector: F2


@kernel_bare
def _made(node: I1, first: int, last: int, data: F2, own: F1, x: F1) -> Vector:
    """V = V0 + sum (c + d J) r + g (r_1 - r_0) x (r_2 - r_0)."""
    vx, vy, vz = own[0], own[1], own[2]
    # V_0 + sum (c + d J) r
    for i in range(first, last):
        at, c, d = node[i], data[i, 0], data[i, 1]
        vx += c * x[at] - d * x[at + 1]
        vy += c * x[at + 1] + d * x[at]
        vz += c * x[at + 2]
    if own[3] != 0.0:
        o, p, q = node[first], node[first + 1], node[first + 2]
        ax, ay, az = x[p] - x[o], x[p + 1] - x[o + 1], x[p + 2] - x[o + 2]
        bx, by, bz = x[q] - x[o], x[q + 1] - x[o + 1], x[q + 2] - x[o + 2]
        vx += own[3] * (ay * bz - az * by)
        vy += own[3] * (az * bx - ax * bz)
        vz += own[3] * (ax * by - ay * bx)
    return vx, vy, vz


@kernel_bare
def _couple(mode: int, node: I1, first: int, last: int, V: Vector, x: F1, f: F1) -> None:
    """f_i = a x d_i with d_i from the mean place and (sum |d|^2 1 - d d^T) a = V; in the plane V_z J d_i/sum |d|^2."""
    vx, vy, vz = V
    mx, my, mz = 0.0, 0.0, 0.0
    share = 1.0 / (last - first)
    # centre of the nodes
    for i in range(first, last):
        at = node[i]
        mx += share * x[at]
        my += share * x[at + 1]
        mz += share * x[at + 2]
    xx, yy, zz, xy, yz, zx = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    # second moments of the nodes about their centre
    for i in range(first, last):
        at = node[i]
        dx, dy, dz = x[at] - mx, x[at + 1] - my, x[at + 2] - mz
        xx, yy, zz = xx + dx * dx, yy + dy * dy, zz + dz * dz
        xy, yz, zx = xy + dx * dy, yz + dy * dz, zx + dz * dx
    if mode == FLAT_COUPLE:
        ax, ay, az = 0.0, 0.0, vz / (xx + yy)
    else:
        p, q, r = yy + zz, zz + xx, xx + yy
        # the symmetric matrix [[p, -xy, -zx], [-xy, q, -yz], [-zx, -yz, r]] by cofactors
        pp, qq, rr = q * r - yz * yz, p * r - zx * zx, p * q - xy * xy
        pq, qr, rp = xy * r + yz * zx, yz * p + xy * zx, xy * yz + q * zx
        whole = 1.0 / (p * pp - xy * pq - zx * rp)
        ax = whole * (pp * vx + pq * vy + rp * vz)
        ay = whole * (pq * vx + qq * vy + qr * vz)
        az = whole * (rp * vx + qr * vy + rr * vz)
    # f_i = alpha x d_i: no resultant, moment V
    for i in range(first, last):
        at = node[i]
        dx, dy, dz = x[at] - mx, x[at + 1] - my, x[at + 2] - mz
        f[at] += ay * dz - az * dy
        f[at + 1] += az * dx - ax * dz
        f[at + 2] += ax * dy - ay * dx


@kernel
def force(s: Followers, t: float, x: F1, v: F1, f: F1) -> None:  # noqa: ARG001
    """As kernels.structure.element_table.force."""
    node, data, table = s.node, s.data, s.table_ptr
    # amount times V at the nodes, shared by weights, or as the forces of a couple
    for k in range(s.mode.size):
        first, last = s.ptr[k], s.ptr[k + 1]
        amount = entry_at(s.time, s.value, table[k], table[k + 1], t)
        vx, vy, vz = _made(node, first, last, data, s.vector[k], x)
        vx, vy, vz = amount * vx, amount * vy, amount * vz
        if s.mode[k] != FORCE:
            _couple(s.mode[k], node, first, last, (vx, vy, vz), x, f)
            continue
        for i in range(first, last):
            at, w, u = node[i], data[i, 2], data[i, 3]
            f[at] += w * vx - u * vy
            f[at + 1] += w * vy + u * vx
            f[at + 2] += w * vz


@dataclass(frozen=True, kw_only=True, eq=False)
class Follower(UnitLoad):
    """mode FORCE, COUPLE or FLAT_COUPLE; nodes (k,); data (k, 4) c, d, w, u; vector (4,) V0 and g."""

    kernel, record, own = force, Followers, ("mode", "vector")
    mode: int
    vector: NDArray[np.float64]

    @property
    def constant(self) -> bool:
        """True if the nodal forces do not depend on positions."""
        return self.mode == FORCE and not self.data[:, :2].any() and not self.vector[3]

    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """Nodal forces (..., k, 3) of the amount 1 with its nodes at r (..., k, 3), which may be complex."""
        c, d, w, u = (self.data[:, [j]] for j in range(4))
        # V = V_0 + sum (c + d J) r + g (r_1 - r_0) x (r_2 - r_0)
        V = self.vector[:3] + np.sum(c * r + d * turned(r), axis=-2)
        if self.vector[3]:
            V = V + self.vector[3] * np.cross(r[..., 1, :] - r[..., 0, :], r[..., 2, :] - r[..., 0, :])
        if self.mode == FORCE:
            return np.asarray(w * V[..., None, :] + u * turned(V)[..., None, :])
        r = r - r.mean(axis=-2, keepdims=True)
        square = np.sum(r * r, axis=(-2, -1))
        if self.mode == FLAT_COUPLE:
            return np.asarray((V[..., 2] / square)[..., None, None] * turned(r))
        # f_i = alpha x r_i with (sum |r|^2 1 - r r^T) alpha = V
        G = square[..., None, None] * np.eye(3) - np.swapaxes(r, -1, -2) @ r
        a = np.linalg.solve(G, V[..., None])[..., 0]
        return np.asarray(np.cross(a[..., None, :], r))


def unit_vector(
    mode: int,
    nodes: NDArray[np.int64],
    points: NDArray[np.float64],
    axis: NDArray[np.float64],
    weights: NDArray[np.float64],
    follows: bool,
    dim: int,
) -> Follower:
    """A unit vector along a global axis, fixed in space or in the body."""
    lead = points.shape[:-2]
    data = np.concatenate([np.zeros((*lead, len(nodes), 2)), weights], axis=-1)
    if not follows:
        return Follower(mode=mode, nodes=nodes, data=data, vector=np.append(axis, 0.0))
    data, vector = data.astype(points.dtype), np.zeros((*lead, 4), points.dtype)
    if dim == 2 and len(nodes) == 2:
        d = points[..., 1, :] - points[..., 0, :]
        data[..., 1, 0], data[..., 1, 1] = planar_share(np.broadcast_to(axis[:2], d.shape), d)
        data[..., 0, :2] = -data[..., 1, :2]
    elif len(nodes) == dim + 1:
        data[..., 0] = fixed_in(points, axis[:dim])
    else:
        normal = np.cross(points[..., 1, :] - points[..., 0, :], points[..., 2, :] - points[..., 0, :])
        vector[..., 3] = normal @ axis / np.vecdot(normal.conj(), normal)
        data[..., 0] = fixed_in(points, axis - vector[..., 3:] * normal)
    return Follower(mode=mode, nodes=nodes, data=data, vector=vector)
