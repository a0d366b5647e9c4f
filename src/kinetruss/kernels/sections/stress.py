"""The largest von Mises stress over a cross-section.

All stresses enter as nominal ones: a = T/A, b2 = M2 c3/I2 and b3 = M3 c2/I3 (extreme fibres), k2 and k3 the largest shear
stresses of V2 and V3 alone. Where (y, z) are the coordinates along axes 2 and 3 over c2, c3:

    sigma = a + b2 z - b3 y

round      : on the outer circle, shear flow along it, tau = k2 sin(theta) - k3 cos(theta): exact for a thin tube,
             beam theory (V Q/(I t)) for a solid rod, on the safe side between.
rectangle  : tau_12 = k2 (1 - y^2), tau_13 = k3 (1 - z^2), anywhere in the section.
general    : bound; all bending and all shear at one point.

Source: Timoshenko & Gere, Mechanics of Materials, shear stresses in beams of circular and rectangular section.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import Floats, Ints

__all__ = ["GENERAL", "RECTANGLE", "ROUND", "UNKNOWN", "section_von_mises", "von_mises"]


UNKNOWN, ROUND, RECTANGLE, GENERAL = -1, 0, 1, 2

_STEPS = 24
_COS, _SIN = math.cos(2 * math.pi / _STEPS), math.sin(2 * math.pi / _STEPS)


@kernel_bare
def _circle(a: float, b2: float, b3: float, k2: float, k3: float) -> float:
    """Largest sigma^2 + 3 tau^2 on the circle. With psi from the point of most bending, sigma = a + b cos psi."""
    a = abs(a)
    b = math.sqrt(b2 * b2 + b3 * b3)
    K = 3.0 * (k2 * k2 + k3 * k3)
    if b == 0.0 or K == 0.0:
        return (a + b) * (a + b) + K
    # tau = p sin psi + q cos psi (its sign does not matter)
    p, q = (k3 * b2 - k2 * b3) / b, (k2 * b2 + k3 * b3) / b
    if q == 0.0:
        # shear and bending in one plane: a parabola in cos psi
        best = (a + b) * (a + b)
        if b * b < K and a * b < K - b * b:
            best = max(best, a * a + K + a * a * b * b / (K - b * b))
        return best
    # where bending rules, the maximum is near psi = 0 and f is concave there
    if max(a + 0.866 * b, b - a) ** 2 + K <= (a + b) ** 2 and b * b + 1.7 * a * b > 2 * K:
        top: float = _climb(a, b, p, q, 1.0, 0.0)
        return top
    best, c, s = 0.0, 1.0, 0.0
    before, here = _f(a, b, p, q, _COS, -_SIN), _f(a, b, p, q, 1.0, 0.0)
    # scan once round in steps of equal angle; each local maximum of sigma^2 + 3 tau^2 is refined
    for _ in range(_STEPS):
        cn, sn = c * _COS - s * _SIN, s * _COS + c * _SIN
        after = _f(a, b, p, q, cn, sn)
        if here >= before and here >= after:
            best = max(best, _climb(a, b, p, q, c, s))
        before, here, c, s = here, after, cn, sn
    return best


@kernel_inline
def _f(a: float, b: float, p: float, q: float, c: float, s: float) -> float:
    sigma, tau = a + b * c, p * s + q * c
    return sigma * sigma + 3.0 * tau * tau


@kernel_bare
def _climb(a: float, b: float, p: float, q: float, c: float, s: float) -> float:
    """Newton's method up to the top next to psi, given by its cosine and sine; never lower than where it began."""
    best: float = _f(a, b, p, q, c, s)
    # Newton's method on the derivative by psi, while the second derivative is negative
    for _ in range(6):
        sigma, tau, slope = a + b * c, p * s + q * c, p * c - q * s
        first = -2.0 * b * s * sigma + 6.0 * tau * slope
        second = -2.0 * b * c * sigma + 2.0 * b * b * s * s + 6.0 * (slope * slope - tau * tau)
        if second >= 0.0:
            break
        step = -first / second
        if abs(step) > 0.2:
            step = math.copysign(0.2, step)
        cd, sd = math.cos(step), math.sin(step)
        c, s = c * cd - s * sd, s * cd + c * sd
        here = _f(a, b, p, q, c, s)
        best = max(best, here)
        if abs(step) < 1e-7:
            break
    return best


@kernel_bare
def _along(A: float, b: float, k: float) -> float:
    """y in [0, 1] with the largest (A + b y)^2 + 3 k^2 (1 - y^2)^2, for A, b >= 0."""
    shear = 12.0 * k * k
    if 2.0 * b * b >= shear:
        return 1.0
    # the slope 12 k^2 y^3 + (2 b^2 - 12 k^2) y + 2 A b is convex: Newton from 0 climbs to its first root, if there is one
    y = 0.0
    # Newton's method on the derivative by y from below: convex, so it cannot overshoot its first root
    for _ in range(60):
        slope = shear * y * y * y + (2.0 * b * b - shear) * y + 2.0 * A * b
        second = 3.0 * shear * y * y + 2.0 * b * b - shear
        if slope <= 0.0:
            break
        if second >= 0.0 or y >= 1.0:
            return 1.0
        step = -slope / second
        y += step
        if step < 1e-12:
            break
    if y >= 1.0:
        return 1.0
    inner, corner = A + b * y, A + b
    return y if inner * inner + 0.25 * shear * (1.0 - y * y) ** 2 > corner * corner else 1.0


@kernel_bare
def _box(a: float, b2: float, b3: float, k2: float, k3: float) -> float:
    """Largest sigma^2 + 3 tau^2 over a rectangle, by climbing along y and z in turn from several corners."""
    a, b2, b3 = abs(a), abs(b2), abs(b3)
    best = 0.0
    # coordinate ascent from the four corners of a quarter of the section
    for start in range(4):
        y, z = float(start & 1), float(start >> 1)
        for _ in range(40):
            y_new = _along(a + b2 * z, b3, k2)
            z_new = _along(a + b3 * y_new, b2, k3)
            moved = abs(y_new - y) + abs(z_new - z)
            y, z = y_new, z_new
            if moved < 1e-9:
                break
        sigma = a + b3 * y + b2 * z
        shear = (k2 * (1.0 - y * y)) ** 2 + (k3 * (1.0 - z * z)) ** 2
        best = max(best, sigma * sigma + 3.0 * shear)
    return best


@kernel
def von_mises(shape: int, a: float, b2: float, b3: float, k2: float, k3: float) -> float:
    """Largest von Mises stress over a section of the given shape, Pa; NaN where the shape is unknown."""
    if shape == ROUND:
        return math.sqrt(_circle(a, b2, b3, k2, k3))
    if shape == RECTANGLE:
        return math.sqrt(_box(a, b2, b3, k2, k3))
    if shape == GENERAL:
        top = abs(a) + abs(b2) + abs(b3)
        return math.sqrt(top * top + 3.0 * (k2 * k2 + k3 * k3))
    return math.nan


@kernel
def section_von_mises(shape: Ints, scale: Floats, T: Floats, V: Floats, M: Floats, out: Floats) -> None:
    """von Mises stress at every station into out (t, parts, stations).

    shape (parts,); scale (parts, 4): 1/A, c3/I2, c2/I3, shear factor/A; T (t, parts, stations), V and M with a last axis of 2
    (in the plane 1) as from `section_forces`.
    """
    space = V.shape[3] == 2
    # nominal stresses at each station, then the largest von Mises stress over the section
    for i in range(T.shape[0]):
        for part in range(T.shape[1]):
            per_T, per_M2, per_M3, per_V = scale[part, 0], scale[part, 1], scale[part, 2], scale[part, 3]
            for n in range(T.shape[2]):
                k3, b2 = 0.0, 0.0
                if space:
                    k3, b2 = V[i, part, n, 1] * per_V, M[i, part, n, 0] * per_M2
                b3 = M[i, part, n, M.shape[3] - 1] * per_M3
                out[i, part, n] = von_mises(shape[part], T[i, part, n] * per_T, b2, b3, V[i, part, n, 0] * per_V, k3)
