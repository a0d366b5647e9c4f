"""Inertia and weight of members as forces at their two ends, and their energy.

Uniform bar of mass m: q_A = m/6 (2 b_A + b_B), q_B = m/6 (b_A + 2 b_B), b = a - g (consistent mass).
Active member: base rod clamped at A, tube clamped at B, direction u, P = I - u u^T:
q_B(base) = (1/L) P int s (a - g) dm, q_A(tube) = (1/L) P int s' (a - g) dm, the rest at the other end.
Rotary inertia i (kg m^2): couple i u x u'' as forces +-(i/L) P u'' at B and A.
Histories x, v, a are (times, 3 n); A, B are the first coordinates of a member's ends.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_inline

__all__ = ["direction", "direction_rates", "inertia_forces", "member_energy"]


@kernel_inline
def direction(x, i, A, B):  # type: ignore[no-untyped-def]
    """Length and unit vector from A to B."""
    dx, dy, dz = x[i, B] - x[i, A], x[i, B + 1] - x[i, A + 1], x[i, B + 2] - x[i, A + 2]
    L = (dx * dx + dy * dy + dz * dz) ** 0.5
    return L, dx / L, dy / L, dz / L


@kernel_inline
def direction_rates(v, a, i, A, B, L, ux, uy, uz):  # type: ignore[no-untyped-def]
    """L', u' and u'': u' = (d' - L' u)/L, u'' = (d'' - L'' u - 2 L' u')/L with L'' = u . d'' + L |u'|^2."""
    dvx, dvy, dvz = v[i, B] - v[i, A], v[i, B + 1] - v[i, A + 1], v[i, B + 2] - v[i, A + 2]
    dax, day, daz = a[i, B] - a[i, A], a[i, B + 1] - a[i, A + 1], a[i, B + 2] - a[i, A + 2]
    Ld = ux * dvx + uy * dvy + uz * dvz
    wx, wy, wz = (dvx - Ld * ux) / L, (dvy - Ld * uy) / L, (dvz - Ld * uz) / L
    Ldd = ux * dax + uy * day + uz * daz + L * (wx * wx + wy * wy + wz * wz)
    sx, sy, sz = (dax - Ldd * ux) / L, (day - Ldd * uy) / L, (daz - Ldd * uz) / L
    turn = 2.0 * Ld / L
    return Ld, wx, wy, wz, sx - turn * wx, sy - turn * wy, sz - turn * wz


@kernel_inline
def inertia_forces(two_rods, rods, m, x, v, a, i, j, A, B, g, out):  # type: ignore[no-untyped-def]
    """q_A and q_B of member m into out (6,): what its ends must push with so that it moves as it does.

    two_rods (m,), rods (m, 6) as in System; g (3,). Positions are read at row i, velocities and accelerations at row j.
    """
    if not two_rods[m]:
        sixth = rods[m, 0] / 6.0
        for c in range(3):
            bA, bB = a[j, A + c] - g[c], a[j, B + c] - g[c]
            out[c] = sixth * (2.0 * bA + bB)
            out[3 + c] = sixth * (bA + 2.0 * bB)
        if rods[m, 2] == 0.0:
            return
    L, ux, uy, uz = direction(x, i, A, B)
    _, wx, wy, wz, sx, sy, sz = direction_rates(v, a, j, A, B, L, ux, uy, uz)
    # across the member: P u'' = u'' + |u'|^2 u
    w2 = wx * wx + wy * wy + wz * wz
    u, s, cross = (ux, uy, uz), (sx, sy, sz), (sx + w2 * ux, sy + w2 * uy, sz + w2 * uz)
    if not two_rods[m]:
        rotary = rods[m, 2] / L
        for c in range(3):
            out[c] -= rotary * cross[c]
            out[3 + c] += rotary * cross[c]
        return
    mb, lb, mt, lt = rods[m, 0], rods[m, 1], rods[m, 3], rods[m, 4]
    hb, ht = 0.5 * mb * lb, 0.5 * mt * lt
    # moments of (a - g) about A (base) and B (tube), whose part along u carries nothing across
    along_b, along_t = 0.0, 0.0
    for c in range(3):
        along_b += u[c] * (a[j, A + c] - g[c])
        along_t += u[c] * (a[j, B + c] - g[c])
    second = (mb * lb * lb + mt * lt * lt) / 3.0 + rods[m, 2] + rods[m, 5]
    for c in range(3):
        bA, bB = a[j, A + c] - g[c], a[j, B + c] - g[c]
        swing = (hb * (bA - along_b * u[c]) - ht * (bB - along_t * u[c]) + second * cross[c]) / L
        out[c] = mb * bA + hb * s[c] - swing
        out[3 + c] = mt * bB - ht * s[c] + swing


@kernel_inline
def member_energy(two_rods, rods, m, x, v, a, i, A, B, g):  # type: ignore[no-untyped-def]
    """Kinetic plus potential energy of member m (J) and its rate (W), from the kinetic energy integral itself."""
    energy, rate = 0.0, 0.0
    mass, rotary = rods[m, 0], rods[m, 2]
    if not two_rods[m]:
        for c in range(3):
            vA, vB, aA, aB = v[i, A + c], v[i, B + c], a[i, A + c], a[i, B + c]
            energy += mass / 6.0 * (vA * vA + vA * vB + vB * vB) - 0.5 * mass * g[c] * (x[i, A + c] + x[i, B + c])
            rate += mass / 6.0 * (2.0 * vA * aA + aA * vB + vA * aB + 2.0 * vB * aB) - 0.5 * mass * g[c] * (vA + vB)
        if rotary == 0.0:
            return energy, rate
    L, ux, uy, uz = direction(x, i, A, B)
    _, wx, wy, wz, sx, sy, sz = direction_rates(v, a, i, A, B, L, ux, uy, uz)
    u, w, s = (ux, uy, uz), (wx, wy, wz), (sx, sy, sz)
    if two_rods[m]:
        for side in range(2):
            mass, length, rotary = rods[m, 3 * side], rods[m, 3 * side + 1], rods[m, 3 * side + 2]
            at = A if side == 0 else B
            h = (0.5 if side == 0 else -0.5) * mass * length
            second = mass * length * length / 3.0 + rotary
            for c in range(3):
                vc, ac = v[i, at + c], a[i, at + c]
                energy += 0.5 * mass * vc * vc + h * vc * w[c] + 0.5 * second * w[c] * w[c]
                energy -= g[c] * (mass * x[i, at + c] + h * u[c])
                rate += mass * vc * ac + h * (ac * w[c] + vc * s[c]) + second * w[c] * s[c]
                rate -= g[c] * (mass * vc + h * w[c])
        return energy, rate
    for c in range(3):
        energy += 0.5 * rotary * w[c] * w[c]
        rate += rotary * w[c] * s[c]
    return energy, rate
