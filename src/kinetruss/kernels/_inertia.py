"""Inertia and weight of members as forces at their two ends, and their energy.

Uniform bar of mass m: q_A = m/6 (2 b_A + b_B), q_B = m/6 (b_A + 2 b_B), b = a - g (consistent mass).
Active member: base rod clamped at A, tube clamped at B, direction u, P = I - u u^T:
q_B(base) = (1/L) P int s (a - g) dm, q_A(tube) = (1/L) P int s' (a - g) dm, the rest at the other end.
Rotary inertia i (kg m^2): couple i u x u'' as forces +-(i/L) P u'' at B and A.
"""

from __future__ import annotations

import numba

__all__ = ["direction_rates", "energy_of", "inertia_forces"]


@numba.njit(cache=True, inline="always")
def _cross_rates(L, ux, uy, uz, dvx, dvy, dvz, dax, day, daz):  # type: ignore[no-untyped-def]
    """L', and the rates u', u'' of the unit vector from the relative velocity and acceleration of the ends."""
    Ld = ux * dvx + uy * dvy + uz * dvz
    wx, wy, wz = (dvx - Ld * ux) / L, (dvy - Ld * uy) / L, (dvz - Ld * uz) / L
    along = ux * dax + uy * day + uz * daz
    # d'' = L'' u + 2 L' u' + L u''; u . u'' = -|u'|^2, so L'' = u . d'' + L |u'|^2
    Ldd = along + L * (wx * wx + wy * wy + wz * wz)
    sx, sy, sz = (
        (dax - Ldd * ux - 2 * Ld * wx) / L,
        (day - Ldd * uy - 2 * Ld * wy) / L,
        (daz - Ldd * uz - 2 * Ld * wz) / L,
    )
    return Ld, Ldd, wx, wy, wz, sx, sy, sz


@numba.njit(cache=True)
def direction_rates(xp, xq, vp, vq, ap, aq, out):  # type: ignore[no-untyped-def]
    """L, L', L'' and u, u', u'' of one member into out (12,), from end positions, velocities, accelerations (3,) each."""
    dx, dy, dz = xq[0] - xp[0], xq[1] - xp[1], xq[2] - xp[2]
    L = (dx * dx + dy * dy + dz * dz) ** 0.5
    ux, uy, uz = dx / L, dy / L, dz / L
    Ld, Ldd, wx, wy, wz, sx, sy, sz = _cross_rates(
        L, ux, uy, uz, vq[0] - vp[0], vq[1] - vp[1], vq[2] - vp[2], aq[0] - ap[0], aq[1] - ap[1], aq[2] - ap[2]
    )
    out[0], out[1], out[2] = L, Ld, Ldd
    out[3], out[4], out[5] = ux, uy, uz
    out[6], out[7], out[8] = wx, wy, wz
    out[9], out[10], out[11] = sx, sy, sz


@numba.njit(cache=True)
def inertia_forces(two_rods, rods, k, ap, aq, g):  # type: ignore[no-untyped-def]
    """q_A and q_B of one member (6 numbers): what its ends must push with so that it moves as it does.

    two_rods : active member; rods (6,) as in System; k (12,) from `direction_rates`; ap, aq, g (3,).
    """
    return _active(rods, k, ap, aq, g) if two_rods else _uniform(rods, k, ap, aq, g)


@numba.njit(cache=True, inline="always")
def _uniform(rods, k, ap, aq, g):  # type: ignore[no-untyped-def]
    m = rods[0] / 6.0
    r = rods[2] / k[0]
    # P u'' = u'' + |u'|^2 u
    w2 = k[6] * k[6] + k[7] * k[7] + k[8] * k[8]
    ax, ay, az = ap[0] - g[0], ap[1] - g[1], ap[2] - g[2]
    bx, by, bz = aq[0] - g[0], aq[1] - g[1], aq[2] - g[2]
    tx, ty, tz = r * (k[9] + w2 * k[3]), r * (k[10] + w2 * k[4]), r * (k[11] + w2 * k[5])
    return (
        m * (2 * ax + bx) - tx, m * (2 * ay + by) - ty, m * (2 * az + bz) - tz,
        m * (ax + 2 * bx) + tx, m * (ay + 2 * by) + ty, m * (az + 2 * bz) + tz,
    )  # fmt: skip


@numba.njit(cache=True, inline="always")
def _active(rods, k, ap, aq, g):  # type: ignore[no-untyped-def]
    L = k[0]
    mb, lb, rb, mt, lt, rt = rods[0], rods[1], rods[2], rods[3], rods[4], rods[5]
    ux, uy, uz = k[3], k[4], k[5]
    bax, bay, baz = ap[0] - g[0], ap[1] - g[1], ap[2] - g[2]
    tax, tay, taz = aq[0] - g[0], aq[1] - g[1], aq[2] - g[2]
    hb, qb = mb * lb / 2, mb * lb * lb / 3 + rb
    ht, qt = mt * lt / 2, mt * lt * lt / 3 + rt
    # base: first moment of (a - g) about A over L, across u; tube likewise about B, with a = a_B - s' u''
    bx, by, bz = (hb * bax + qb * k[9]) / L, (hb * bay + qb * k[10]) / L, (hb * baz + qb * k[11]) / L
    tx, ty, tz = (ht * tax - qt * k[9]) / L, (ht * tay - qt * k[10]) / L, (ht * taz - qt * k[11]) / L
    s = bx * ux + by * uy + bz * uz
    bx, by, bz = bx - s * ux, by - s * uy, bz - s * uz
    s = tx * ux + ty * uy + tz * uz
    tx, ty, tz = tx - s * ux, ty - s * uy, tz - s * uz
    fbx, fby, fbz = mb * bax + hb * k[9], mb * bay + hb * k[10], mb * baz + hb * k[11]
    ftx, fty, ftz = mt * tax - ht * k[9], mt * tay - ht * k[10], mt * taz - ht * k[11]
    return (
        fbx - bx + tx, fby - by + ty, fbz - bz + tz,
        ftx - tx + bx, fty - ty + by, ftz - tz + bz,
    )  # fmt: skip


@numba.njit(cache=True)
def energy_of(two_rods, rods, k, xp, xq, vp, vq, ap, aq, g):  # type: ignore[no-untyped-def]
    """Kinetic plus potential energy of one member (J), and its rate (W), from the kinetic energy integral itself."""
    if two_rods:
        w, dw = k[6:9], k[9:12]
        e1, r1 = _rod_energy(rods[0], rods[1], rods[2], 1.0, k, xp, vp, ap, w, dw, g)
        e2, r2 = _rod_energy(rods[3], rods[4], rods[5], -1.0, k, xq, vq, aq, w, dw, g)
        return e1 + e2, r1 + r2
    m, rot = rods[0], rods[2]
    energy, rate = 0.0, 0.0
    for c in range(3):
        energy += m / 6 * (vp[c] * vp[c] + vp[c] * vq[c] + vq[c] * vq[c]) - m / 2 * g[c] * (xp[c] + xq[c])
        energy += 0.5 * rot * k[6 + c] * k[6 + c]
        rate += m / 6 * (2 * vp[c] * ap[c] + ap[c] * vq[c] + vp[c] * aq[c] + 2 * vq[c] * aq[c])
        rate += rot * k[6 + c] * k[9 + c] - m / 2 * g[c] * (vp[c] + vq[c])
    return energy, rate


@numba.njit(cache=True)
def _rod_energy(m, l, rot, side, k, x, v, a, w, dw, g):  # type: ignore[no-untyped-def]
    """A rod clamped at a node, pointing along side * u: energy and rate."""
    energy, rate = 0.0, 0.0
    h, second = side * m * l / 2, m * l * l / 3 + rot
    for c in range(3):
        energy += 0.5 * m * v[c] * v[c] + h * v[c] * w[c] + 0.5 * second * w[c] * w[c]
        energy -= g[c] * (m * x[c] + h * k[3 + c])
        rate += m * v[c] * a[c] + h * (a[c] * w[c] + v[c] * dw[c]) + second * w[c] * dw[c]
        rate -= g[c] * (m * v[c] + h * w[c])
    return energy, rate
