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

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.record import Floats, Ints

__all__ = ["GENERAL", "RECTANGLE", "ROUND", "UNKNOWN", "section_von_mises", "von_mises"]


UNKNOWN, ROUND, RECTANGLE, GENERAL = -1, 0, 1, 2


@kernel_bare
def _circle(a: float, b2: float, b3: float, k2: float, k3: float) -> float:
    """Largest sigma^2 + 3 tau^2 on the circle.

    With x = (y, z) on the unit circle it is a^2 + x Q x + 2 g x, a quadratic form. Its stationary points are the roots of a
    quartic in the multiplier l of (l - Q) x = g, |x| = 1; the largest value belongs to the largest root, l >= l1, the larger
    eigenvalue of Q, and is the minimum over l >= l1 of the dual a^2 + l + g1^2/(l - l1) + g2^2/(l - l2), which is convex and
    never too low (More & Sorensen, 1983, SIAM J. Sci. Stat. Comput. 4, 553; Stern & Wolkowicz, 1995, SIAM J. Optim. 5, 286).
    """
    unit, size = 1.0, max(abs(a), abs(b2), abs(b3), abs(k2), abs(k3))
    if size == 0.0 or not size < math.inf:
        return size
    if not 1e-70 < size < 1e70:  # fourth powers have the range of floats
        unit = size
        a, b2, b3, k2, k3 = a / unit, b2 / unit, b3 / unit, k2 / unit, k3 / unit
    q11, q12, q22 = b3 * b3 + 3.0 * k3 * k3, -b2 * b3 - 3.0 * k2 * k3, b2 * b2 + 3.0 * k2 * k2
    # eigenvector (c, s) of l1; any one where the eigenvalues are equal
    apart, c, s = abs(q11 - q22), 1.0, 0.0
    if q12 == 0.0:
        if q22 > q11:
            c, s = 0.0, 1.0
    else:
        apart = math.sqrt(apart * apart + 4.0 * q12 * q12)
        if q11 >= q22:
            c = math.sqrt(0.5 + 0.5 * (q11 - q22) / apart)
            s = q12 / (apart * c)
        else:
            s = math.sqrt(0.5 + 0.5 * (q22 - q11) / apart)
            c = q12 / (apart * s)
    g1, g2 = abs(a * (b2 * s - b3 * c)), abs(a * (b2 * c + b3 * s))
    top = a * a + 0.5 * (q11 + q22 + apart)
    if g2 == 0.0:  # bending and l1 have one direction
        return unit * unit * (top + 2.0 * g1)
    if g1 == 0.0 and g2 <= apart:
        return unit * unit * (top + (g2 * g2 / apart))
    # 1/|x| - 1 is concave and rises with m = l - l1: Newton's method from below cannot overshoot its root
    m = max(g1, g2 - apart)
    x1, x2 = 0.0, 0.0
    for _ in range(60):
        x1, x2 = g1 / m, g2 / (m + apart)
        square = x1 * x1 + x2 * x2
        if not square > 1.0:
            break
        step = square * (math.sqrt(square) - 1.0) / (x1 * x1 / m + x2 * x2 / (m + apart))
        # the slope of the dual times the step is what it can still fall by
        if step * (square - 1.0) < 1e-17 * top:
            break
        m += step
    return unit * unit * (top + m + x1 * g1 + x2 * g2)


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
    """Largest sigma^2 + 3 tau^2 over a rectangle, by climbing along y and z in turn.

    Two starts find it: the best y rises with z and the best z with y, so a climb from z = 0 ends at the lowest point that is
    best along both, one from z = 1 at the highest. Inside, each is a convex function of the other, so that only the lowest of
    such points can be a top; on the sides the highest is.
    """
    a, b2, b3 = abs(a), abs(b2), abs(b3)
    best = 0.0
    # a climb from below and one from above
    for start in range(2):
        y, z = 0.0, float(start)
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
