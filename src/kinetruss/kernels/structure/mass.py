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

from kinetruss.kernels.compiled.jit import kernel_inline, kernel_inner
from kinetruss.kernels.structure.equations import Equations

__all__ = ["blocks_of", "mass_of", "mass_times", "momenta_of", "sway"]


@kernel_inner
def blocks_of(data, j, L):  # type: ignore[no-untyped-def]
    """s and r of the blocks AA, AB, BB of member j of changing mass at length L."""
    second = data[j, 4] / (L * L)
    h_A, h_B, axial = data[j, 2] / L, data[j, 3] / L, data[j, 5]
    p_AA, p_AB, p_BB = second - 2.0 * h_A, h_A + h_B - second, second - 2.0 * h_B
    return data[j, 0] + p_AA, axial - p_AA, p_AB, -axial - p_AB, data[j, 1] + p_BB, axial - p_BB


@kernel_inline
def _constant_times(mass_A, mass_B, mass, lump, y, out):  # type: ignore[no-untyped-def]
    for i in range(lump.size):
        for c in range(3 * i, 3 * i + 3):
            out[c] = lump[i] * y[c]
    for k in range(mass_A.size):
        a, b = mass_A[k], mass_B[k]
        aa, ab, bb, skew = mass[k, 0], mass[k, 1], mass[k, 2], mass[k, 3]
        for c in range(3):
            out[a + c] += aa * y[a + c] + ab * y[b + c]
            out[b + c] += ab * y[a + c] + bb * y[b + c]
        if skew != 0.0:
            out[a] -= skew * y[b + 1]
            out[a + 1] += skew * y[b]
            out[b] += skew * y[a + 1]
            out[b + 1] -= skew * y[a]


@kernel_inline
def mass_times(mass_A, mass_B, mass, lump, var_A, var_B, var, x, y, out):  # type: ignore[no-untyped-def]
    """M(x) y over all coordinates into out (3 n,)."""
    _constant_times(mass_A, mass_B, mass, lump, y, out)
    for j in range(var_A.size):
        a, b = var_A[j], var_B[j]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L = math.sqrt(dx * dx + dy * dy + dz * dz)
        ux, uy, uz = dx / L, dy / L, dz / L
        s_AA, r_AA, s_AB, r_AB, s_BB, r_BB = blocks_of(var, j, L)
        along_A = ux * y[a] + uy * y[a + 1] + uz * y[a + 2]
        along_B = ux * y[b] + uy * y[b + 1] + uz * y[b + 2]
        at_A, at_B = r_AA * along_A + r_AB * along_B, r_AB * along_A + r_BB * along_B
        for c, u in ((0, ux), (1, uy), (2, uz)):
            out[a + c] += s_AA * y[a + c] + s_AB * y[b + c] + at_A * u
            out[b + c] += s_AB * y[a + c] + s_BB * y[b + c] + at_B * u


@kernel_inner
def mass_of(eq: Equations, x, y, out):  # type: ignore[no-untyped-def]
    """M(x) y of these equations over all coordinates into out (3 n,)."""
    mass_times(
        eq.mass_A, eq.mass_B, eq.mass, eq.lump, eq.var_A,
        eq.var_B, eq.var, x, y, out,
    )  # fmt: skip


@kernel_inner
def sway(var_A, var_B, var, gravity, x, v, f):  # type: ignore[no-untyped-def]
    """Add to f what members of changing mass push with beside M a: their velocity terms and their weight.

    With u'' = -(|w|^2 u + 2 (L'/L) w) where nothing accelerates: -(h_A u'' - c), -(-h_B u'' + c), c = J P u''/L, and along the
    member the axial mass times L |w|^2.
    """
    for j in range(var_A.size):
        a, b = var_A[j], var_B[j]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        L = math.sqrt(dx * dx + dy * dy + dz * dz)
        ux, uy, uz = dx / L, dy / L, dz / L
        ex, ey, ez = v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]
        Ld = ux * ex + uy * ey + uz * ez
        wx, wy, wz = (ex - Ld * ux) / L, (ey - Ld * uy) / L, (ez - Ld * uz) / L
        w2 = wx * wx + wy * wy + wz * wz
        down = ux * gravity[0] + uy * gravity[1] + uz * gravity[2]
        h_A, h_B, turn = var[j, 2], var[j, 3], 2.0 * Ld / L
        across, along = (h_A - h_B) / L, var[j, 5] * L * w2
        for c, u, w in ((0, ux, wx), (1, uy, wy), (2, uz, wz)):
            bend = w2 * u + turn * w
            swing = var[j, 4] * turn * w / L + across * (gravity[c] - down * u) - along * u
            f[a + c] += var[j, 0] * gravity[c] + h_A * bend - swing
            f[b + c] += var[j, 1] * gravity[c] - h_B * bend + swing


@kernel_inner
def momenta_of(x, p, out):  # type: ignore[no-untyped-def]
    """Sum of nodal momenta p (3 n,) and their moment about the origin into out (6,)."""
    for c in range(6):
        out[c] = 0.0
    for a in range(0, x.size, 3):
        for c in range(3):
            d, e = (c + 1) % 3, (c + 2) % 3
            out[c] += p[a + c]
            out[3 + c] += x[a + d] * p[a + e] - x[a + e] * p[a + d]
