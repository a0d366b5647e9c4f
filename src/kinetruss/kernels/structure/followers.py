"""Loads on bodies: forces at points, couples, pressures, as nodal forces (mechanics.loads)."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.late import kernel_late
from kinetruss.kernels.compiled.record import F1, F2, I1, Vector
from kinetruss.kernels.structure.equations import Equations

__all__ = ["COUPLE", "FLAT_COUPLE", "FORCE", "followers"]

FORCE, COUPLE, FLAT_COUPLE = 0, 1, 2


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


@kernel_bare
def _amount(time: F1, value: F1, first: int, last: int, t: float) -> float:
    """Entry of a table at t: linear between, held outside."""
    k = first
    # interval of the table that holds t
    while k < last - 1 and time[k + 1] <= t:
        k += 1
    if t <= time[k] or k == last - 1:
        return value[k]
    return value[k] + (t - time[k]) / (time[k + 1] - time[k]) * (value[k + 1] - value[k])


@kernel_late
def followers(eq: Equations, t: float, x: F1, f: F1) -> None:
    """Add the nodal forces of all followers at t, x to f (3 n,)."""
    mode, ptr, node = eq.follower_mode, eq.follower_node_ptr, eq.follower_node
    table, time, value = eq.follower_ptr, eq.follower_time, eq.follower_value
    data, own = eq.follower_data, eq.follower_vector
    # amount times V at the nodes, shared by weights, or as the forces of a couple
    for k in range(mode.size):
        first, last = ptr[k], ptr[k + 1]
        amount = _amount(time, value, table[k], table[k + 1], t)
        vx, vy, vz = _made(node, first, last, data, own[k], x)
        vx, vy, vz = amount * vx, amount * vy, amount * vz
        if mode[k] != FORCE:
            _couple(mode[k], node, first, last, (vx, vy, vz), x, f)
            continue
        for i in range(first, last):
            at, w, u = node[i], data[i, 2], data[i, 3]
            f[at] += w * vx - u * vy
            f[at + 1] += w * vy + u * vx
            f[at + 2] += w * vz
