"""Planar bodies: one bar whose four coordinates carry a whole body, with a constant mass matrix.

A point of the body at (xi, eta) l from the first end, along and to the left of the bar, moves as z = p (1 - w) + q w with
w = xi + i eta in complex notation, so for [x_A, y_A, x_B, y_B], with mass m, centre (e, f), central inertia I, length l:

    M = [  pp      0      pq   -cross ]    pp = (I + m (l - e)^2 + m f^2)/l^2     pq    = -(I - m e (l - e) + m f^2)/l^2
        [   0     pp    cross     pq  ]    qq = (I + m e^2 + m f^2)/l^2           cross = m f/l
        [  pq    cross    qq       0  ]
        [-cross   pq       0      qq  ]    det M = (m I/l^2)^2; M does not change under rotation.

Weight is a force at the centre, hence M [g; g], constant as well. The concept: J. P. Meijaard, V. van der Wijk, Multibody
System Dynamics 48 (2020) 259-282; derived here from the moments of the body, the same as natural coordinates (Garcia de
Jalon, Bayo, 1994).
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_inline

__all__ = ["body_energy", "body_forces", "body_terms", "pair_energy"]


@kernel_inline
def body_terms(mass, e, f, inertia, l):  # type: ignore[no-untyped-def]
    """pp, qq, pq, cross of the mass matrix, kg."""
    ll = l * l
    polar = inertia + mass * f * f
    rest = l - e
    return (polar + mass * rest * rest) / ll, (polar + mass * e * e) / ll, (mass * e * rest - polar) / ll, mass * f / l


@kernel_inline
def body_forces(pp, qq, pq, cross, a, j, A, B, g, out):  # type: ignore[no-untyped-def]
    """q_A and q_B into out (6,): M (a - g), what the ends must push with; accelerations (times, 3 n) are read at row j."""
    ax, ay = a[j, A] - g[0], a[j, A + 1] - g[1]
    bx, by = a[j, B] - g[0], a[j, B + 1] - g[1]
    out[0] = pp * ax + pq * bx - cross * by
    out[1] = pp * ay + pq * by + cross * bx
    out[2] = 0.0
    out[3] = qq * bx + pq * ax + cross * ay
    out[4] = qq * by + pq * ay - cross * ax
    out[5] = 0.0


@kernel_inline
def body_energy(pp, qq, pq, cross, x, v, a, i, A, B, g):  # type: ignore[no-untyped-def]
    """Kinetic plus potential energy of a body (J) and its rate (W) at row i: v M v/2 - g M x and v M (a - g)."""
    px, py = pp * v[i, A] + pq * v[i, B] - cross * v[i, B + 1], pp * v[i, A + 1] + pq * v[i, B + 1] + cross * v[i, B]
    rx, ry = qq * v[i, B] + pq * v[i, A] + cross * v[i, A + 1], qq * v[i, B + 1] + pq * v[i, A + 1] - cross * v[i, A]
    wx, wy = (pp + pq) * g[0] - cross * g[1], (pp + pq) * g[1] + cross * g[0]
    sx, sy = (qq + pq) * g[0] + cross * g[1], (qq + pq) * g[1] - cross * g[0]
    energy = 0.5 * (px * v[i, A] + py * v[i, A + 1] + rx * v[i, B] + ry * v[i, B + 1])
    energy -= wx * x[i, A] + wy * x[i, A + 1] + sx * x[i, B] + sy * x[i, B + 1]
    rate = px * a[i, A] + py * a[i, A + 1] + rx * a[i, B] + ry * a[i, B + 1]
    rate -= wx * v[i, A] + wy * v[i, A + 1] + sx * v[i, B] + sy * v[i, B + 1]
    return energy, rate


@kernel_inline
def pair_energy(P, Q, m, s, g, x, v, a, i):  # type: ignore[no-untyped-def]
    """Energy (J) and its rate (W) of the share m 1 + s [[0, -1], [1, 0]] of M between coordinates P and Q."""
    energy, rate = 0.0, 0.0
    for c in range(3):
        energy += m * (v[i, P + c] * v[i, Q + c] - g[c] * (x[i, P + c] + x[i, Q + c]))
        rate += m * (v[i, P + c] * (a[i, Q + c] - g[c]) + v[i, Q + c] * (a[i, P + c] - g[c]))
    if P == Q:
        return 0.5 * energy, 0.5 * rate
    if s != 0.0:
        energy += s * (v[i, P + 1] * v[i, Q] - v[i, P] * v[i, Q + 1])
        energy -= s * (x[i, P + 1] * g[0] - x[i, P] * g[1] + x[i, Q] * g[1] - x[i, Q + 1] * g[0])
        rate += s * (v[i, P + 1] * (a[i, Q] - g[0]) - v[i, P] * (a[i, Q + 1] - g[1]))
        rate += s * (v[i, Q] * (a[i, P + 1] - g[1]) - v[i, Q + 1] * (a[i, P] - g[0]))
    return energy, rate
