"""The mass matrix by members: times a vector, energy, momenta, dense and by blocks; what velocities and weight add.

Every 3 x 3 block of a member is s 1 + r u u^T, and the one between the ends of a planar body has a skew part about z.
Uniform bar: m/6 [[2, 1], [1, 2]]. Planar body of mass m, centre (e, f), central inertia I: with I_B = I + m e^2 + m f^2,
I_A = I + m (l - e)^2 + m f^2, I_AB = I - m e (l - e) + m f^2 the blocks are I_A/l^2, -I_AB/l^2 and +-m f/l, I_B/l^2
(Meijaard & van der Wijk, 2020, doi 10.1007/s11044-019-09714-z). Changing mass, with P = 1 - u u^T, w = P (v_B - v_A)/L:
T = m_A v_A^2/2 + h_A v_A . w + m_B v_B^2/2 - h_B v_B . w + J w^2/2 + m L'^2/2 for two rods that slide in each other
(h = m l/2 each, J the second moments and rotary inertias about the ends) and an axial mass m (a motor behind a screw).
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Vector
from kinetruss.kernels.structure.structure import States, Structure

__all__ = [
    "at",
    "between",
    "blocks_of",
    "varying_energy",
    "varying_forces",
    "varying_times",
    "direction",
    "dot",
    "mass_times",
    "momenta_of",
    "pair_times",
    "add_varying_forces",
    "turning",
]


@kernel_inline
def blocks_of(data: F2, j: int, L: float) -> tuple[float, ...]:
    """s and r of the blocks AA, AB, BB of member j of varying inertia at length L."""
    second = data[j, 4] / (L * L)
    h_A, h_B, axial = data[j, 2] / L, data[j, 3] / L, data[j, 5]
    p_AA, p_AB, p_BB = second - 2.0 * h_A, h_A + h_B - second, second - 2.0 * h_B
    return data[j, 0] + p_AA, axial - p_AA, p_AB, -axial - p_AB, data[j, 1] + p_BB, axial - p_BB


@kernel_inline
def at(y: F1, place: int) -> Vector:
    """The three numbers of y (3 n,) at a node."""
    return y[place], y[place + 1], y[place + 2]


@kernel_inline
def direction(x: F1, A: int, B: int) -> tuple[float, Vector]:
    """Length and unit vector from A to B, x (3 n,)."""
    dx, dy, dz = x[B] - x[A], x[B + 1] - x[A + 1], x[B + 2] - x[A + 2]
    L = math.sqrt(dx * dx + dy * dy + dz * dz)
    return L, (dx / L, dy / L, dz / L)


@kernel_inline
def between(y: F1, A: int, B: int) -> Vector:
    """y_B - y_A of y (3 n,)."""
    return y[B] - y[A], y[B + 1] - y[A + 1], y[B + 2] - y[A + 2]


@kernel_inline
def dot(g: Vector | F1, d: Vector | F1) -> float:
    """Inner product of two triples."""
    return g[0] * d[0] + g[1] * d[1] + g[2] * d[2]


@kernel_inline
def pair_times(pair: F2, k: int, yA: Vector, yB: Vector) -> tuple[Vector, Vector]:
    """M y of mass pair k at its two ends."""
    aa, ab, bb, skew = pair[k, 0], pair[k, 1], pair[k, 2], pair[k, 3]
    return (
        (aa * yA[0] + ab * yB[0] - skew * yB[1], aa * yA[1] + ab * yB[1] + skew * yB[0], aa * yA[2] + ab * yB[2]),
        (ab * yA[0] + bb * yB[0] + skew * yA[1], ab * yA[1] + bb * yB[1] - skew * yA[0], ab * yA[2] + bb * yB[2]),
    )


@kernel_inline
def varying_times(varying: F2, j: int, L: float, u: Vector, yA: Vector, yB: Vector) -> tuple[Vector, Vector]:
    """M y of member j of varying inertia at its two ends; u : its direction."""
    s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(varying, j, L)
    along_A, along_B = dot(u, yA), dot(u, yB)
    rA, rB = r_AA * along_A + r_AB * along_B, r_AB * along_A + r_BB * along_B
    return (
        (
            s_AA * yA[0] + s_AB * yB[0] + rA * u[0],
            s_AA * yA[1] + s_AB * yB[1] + rA * u[1],
            s_AA * yA[2] + s_AB * yB[2] + rA * u[2],
        ),
        (
            s_AB * yA[0] + s_BB * yB[0] + rB * u[0],
            s_AB * yA[1] + s_BB * yB[1] + rB * u[1],
            s_AB * yA[2] + s_BB * yB[2] + rB * u[2],
        ),
    )


@kernel_inline
def _turn(L: float, u: Vector, e: Vector) -> tuple[float, Vector]:
    """L' and u' = P e/L, e = v_B - v_A."""
    Ld = dot(u, e)
    return Ld, ((e[0] - Ld * u[0]) / L, (e[1] - Ld * u[1]) / L, (e[2] - Ld * u[2]) / L)


@kernel_inline
def turning(L: float, u: Vector, e: Vector, ee: Vector) -> tuple[float, Vector, float, Vector]:
    """L', u', L'' and u'' from e = v_B - v_A and ee = a_B - a_A: u'' = (ee - L'' u - 2 L' u')/L, L'' = u . ee + L |u'|^2."""
    Ld, w = _turn(L, u, e)
    Ldd, turn = dot(u, ee) + L * dot(w, w), 2.0 * Ld / L
    return (
        Ld,
        w,
        Ldd,
        (
            (ee[0] - Ldd * u[0]) / L - turn * w[0],
            (ee[1] - Ldd * u[1]) / L - turn * w[1],
            (ee[2] - Ldd * u[2]) / L - turn * w[2],
        ),
    )


@kernel_inline
def varying_forces(varying: F2, j: int, gravity: F1, L: float, u: Vector, e: Vector) -> tuple[Vector, Vector]:
    """What member j of varying inertia adds at its two ends to -M a: convective forces and weight. e = v_B - v_A.

    With u'' = -(|w|^2 u + 2 (L'/L) w) where nothing accelerates: -(h_A u'' - c), -(-h_B u'' + c), c = J P u''/L, and along the
    member the axial mass times L |w|^2.
    """
    Ld, w = _turn(L, u, e)
    w2, turn, down = dot(w, w), 2.0 * Ld / L, dot(u, gravity)
    h_A, h_B = varying[j, 2], varying[j, 3]
    across, along, second = (h_A - h_B) / L, varying[j, 5] * L * w2, varying[j, 4] * turn / L
    bx, by, bz = w2 * u[0] + turn * w[0], w2 * u[1] + turn * w[1], w2 * u[2] + turn * w[2]
    sx = second * w[0] + across * (gravity[0] - down * u[0]) - along * u[0]
    sy = second * w[1] + across * (gravity[1] - down * u[1]) - along * u[1]
    sz = second * w[2] + across * (gravity[2] - down * u[2]) - along * u[2]
    gx, gy, gz = gravity[0], gravity[1], gravity[2]
    return (
        (varying[j, 0] * gx + h_A * bx - sx, varying[j, 0] * gy + h_A * by - sy, varying[j, 0] * gz + h_A * bz - sz),
        (varying[j, 1] * gx - h_B * bx + sx, varying[j, 1] * gy - h_B * by + sy, varying[j, 1] * gz - h_B * bz + sz),
    )


@kernel_inline
def varying_energy(varying: F2, j: int, gravity: F1, A: int, B: int, states: States, i: int) -> tuple[float, float]:
    """Kinetic plus potential energy of member j of varying inertia (J) and its rate (W), from the integral over it itself."""
    x, v, a = states.x[i], states.v[i], states.a[i]
    L, u = direction(x, A, B)
    vA, vB, aA, aB = at(v, A), at(v, B), at(a, A), at(a, B)
    e, ee = (vB[0] - vA[0], vB[1] - vA[1], vB[2] - vA[2]), (aB[0] - aA[0], aB[1] - aA[1], aB[2] - aA[2])
    Ld, w, Ldd, s = turning(L, u, e, ee)
    m_A, m_B, h_A, h_B, second, axial = varying[j, 0], varying[j, 1], varying[j, 2], varying[j, 3], varying[j, 4], varying[j, 5]
    energy, rate = 0.5 * axial * Ld * Ld, axial * Ld * Ldd
    # T, V and d(T + V)/dt, axis by axis
    for c in range(3):
        energy += 0.5 * (m_A * vA[c] * vA[c] + m_B * vB[c] * vB[c] + second * w[c] * w[c])
        energy += (h_A * vA[c] - h_B * vB[c]) * w[c]
        energy -= gravity[c] * (m_A * x[A + c] + m_B * x[B + c] + (h_A - h_B) * u[c])
        rate += m_A * vA[c] * aA[c] + m_B * vB[c] * aB[c] + second * w[c] * s[c]
        rate += h_A * (aA[c] * w[c] + vA[c] * s[c]) - h_B * (aB[c] * w[c] + vB[c] * s[c])
        rate -= gravity[c] * (m_A * vA[c] + m_B * vB[c] + (h_A - h_B) * w[c])
    return energy, rate


@kernel_inline
def _add(out: F1, A: int, B: int, qA: Vector, qB: Vector) -> None:
    for c in range(3):
        out[A + c] += qA[c]
        out[B + c] += qB[c]


@kernel_bare
def mass_times(s: Structure, x: F1, y: F1, out: F1) -> None:
    """M(x) y over all coordinates into out (3 n,)."""
    # masses at single nodes
    for i in range(s.lump.size):
        for c in range(3 * i, 3 * i + 3):
            out[c] = (s.lump[i] + s.share[i]) * y[c]
    # constant masses between two nodes: bars, planar bodies, nodes that carry bodies
    for k in range(s.pair_A.size):
        A, B = s.pair_A[k], s.pair_B[k]
        qA, qB = pair_times(s.pair, k, at(y, A), at(y, B))
        _add(out, A, B, qA, qB)
    # members of varying inertia: M(x) y
    for j in range(s.varying_A.size):
        A, B = s.varying_A[j], s.varying_B[j]
        L, u = direction(x, A, B)
        qA, qB = varying_times(s.varying, j, L, u, at(y, A), at(y, B))
        _add(out, A, B, qA, qB)


@kernel_bare
def add_varying_forces(s: Structure, gravity: F1, x: F1, v: F1, f: F1) -> None:
    """Add to f the convective forces and the weights of members of varying inertia."""
    # -(convective inertia forces) + weight of each member of varying inertia
    for j in range(s.varying_A.size):
        A, B = s.varying_A[j], s.varying_B[j]
        L, u = direction(x, A, B)
        fA, fB = varying_forces(s.varying, j, gravity, L, u, (v[B] - v[A], v[B + 1] - v[A + 1], v[B + 2] - v[A + 2]))
        _add(f, A, B, fA, fB)


@kernel_bare
def momenta_of(x: F1, p: F1, out: F1) -> None:
    """Sum of nodal momenta p (3 n,) and their moment about the origin into out (6,)."""
    for c in range(6):
        out[c] = 0.0
    # sum of p, and of x x p
    for a in range(0, x.size, 3):
        for c in range(3):
            d, e = (c + 1) % 3, (c + 2) % 3
            out[c] += p[a + c]
            out[3 + c] += x[a + d] * p[a + e] - x[a + e] * p[a + d]
