"""The largest von Mises stress over a cross-section, and where along a part a measure of its section forces is largest.

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
from typing import Any, NamedTuple

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import Flags, Floats, Ints
from kinetruss.kernels.sections.records import Polynomials

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


# T is quadratic along a segment, V quadratic, M cubic (`section_polynomials`), so a scan of a few stations finds every hump and
# a bracketed search (golden section with parabolic steps) tops it.

MOMENT_RESULTANT, MOMENT_SUM = 10, 11
"""Measures beside the shapes of `von_mises`: w2 sqrt(M2^2 + M3^2), and w2 |M2| + w3 |M3|."""

_GOLDEN = 0.3819660112501051
_TOLERANCE = 1e-7


class Measure(NamedTuple):
    """What is to be largest along a part, of T, M2, M3 and V times factors of their own.

    kind : a shape of `von_mises`, with factors 1/A, c3/I2, c2/I3, shear factor/A; or `MOMENT_RESULTANT` or `MOMENT_SUM` with
    0, w2, w3, 0.
    """

    kind: int
    T: float
    M2: float
    M3: float
    V: float


@kernel_bare
def _measured(measure: Measure, c: Any, x: float) -> Any:
    """The measure at xi = x of a segment with the coefficients c."""
    m2 = c[9] + x * (c[10] + x * (c[11] + x * c[12]))
    m3 = c[13] + x * (c[14] + x * (c[15] + x * c[16]))
    if measure.kind == MOMENT_RESULTANT:
        return measure.M2 * math.sqrt(m2 * m2 + m3 * m3)
    if measure.kind == MOMENT_SUM:
        return measure.M2 * abs(m2) + measure.M3 * abs(m3)
    tension = c[0] + x * (c[1] + x * c[2])
    v2, v3 = c[3] + x * (c[4] + x * c[5]), c[6] + x * (c[7] + x * c[8])
    return von_mises(measure.kind, measure.T * tension, measure.M2 * m2, measure.M3 * m3, measure.V * v2, measure.V * v3)


@kernel_bare
def _top(measure: Measure, c: Any, lo: float, x: float, hi: float, fx: float) -> Any:
    """Largest measure in [lo, hi] around x by Brent's method (Brent, 1973, chapter 5): place and value."""
    w = v = x
    fw = fv = fx
    step = last = 0.0
    # Brent's method: parabola through the best three points, golden section where it is not to be trusted
    for _ in range(60):
        middle = 0.5 * (lo + hi)
        if abs(x - middle) <= 2 * _TOLERANCE - 0.5 * (hi - lo):
            break
        parabolic = False
        if abs(last) > _TOLERANCE:
            r, q = (x - w) * (fx - fv), (x - v) * (fx - fw)
            p = (x - v) * q - (x - w) * r
            q = 2 * (q - r)
            p = -p if q > 0 else p
            q = abs(q)
            if abs(p) < abs(0.5 * q * last) and q * (lo - x) < p < q * (hi - x):
                last, step = step, p / q
                parabolic = True
                if x + step - lo < 2 * _TOLERANCE or hi - x - step < 2 * _TOLERANCE:
                    step = math.copysign(_TOLERANCE, middle - x)
        if not parabolic:
            last = (hi if x < middle else lo) - x
            step = _GOLDEN * last
        u = x + (step if abs(step) >= _TOLERANCE else math.copysign(_TOLERANCE, step))
        fu = _measured(measure, c, u)
        if fu >= fx:
            if u >= x:
                lo = x
            else:
                hi = x
            v, w, x, fv, fw, fx = w, x, u, fw, fx, fu
        else:
            if u < x:
                lo = u
            else:
                hi = u
            if fu >= fw or w == x:
                v, w, fv, fw = w, u, fw, fu
            elif fu >= fv or v in (x, w):
                v, fv = u, fu
    return x, fx


@kernel_bare
def _segment(measure: Measure, c: Any, start: float, end: float, spans: int) -> Any:
    """Place and value of the largest measure over one segment."""
    h = (end - start) / spans
    best_x, best = start, -1.0
    before, here = -1.0, _measured(measure, c, start)
    # scan of the stations; each local maximum is refined
    for n in range(spans + 1):
        x = start + n * h
        after = _measured(measure, c, x + h) if n < spans else -1.0
        if here >= before and here >= after:
            lo, hi = max(start, x - h), min(end, x + h)
            top_x, top = x, here
            # an end that falls away inwards is its own top
            inward = x + 1e-6 * h if n == 0 else x - 1e-6 * h
            if 0 < n < spans or _measured(measure, c, inward) > here:
                top_x, top = _top(measure, c, lo, x, hi, here)
            if top > best:
                best_x, best = top_x, top
        before, here = here, after
    return best_x, best


@kernel_bare
def part_top(measure: Measure, given: Polynomials, i: int, part: int, path: bool, spans: int) -> Any:
    """Place and value of the largest measure over the segments of a part; with `path` up to the nut."""
    coef, ends, nut = given
    value, place = math.nan, math.nan
    # each segment has its own polynomial
    for j in range(coef.shape[2]):
        start, end = 0.0 if j == 0 else max(0.0, ends[i, part, j - 1]), min(1.0, ends[i, part, j])
        if j > 0 and (start >= 1.0 or (path and ends[i, part, j - 1] >= nut[i, part])):
            break
        if end < start:
            continue
        n = coef[i, part, j]
        c = (
            n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13], n[14], n[15], n[16],
        )  # fmt: skip
        x, top = _segment(measure, c, start, end, spans)
        if j == 0 or not top <= value:
            value, place = top, x
    return place, value


@kernel
def peaks(given: Polynomials, measure: Ints, scale: Floats, overhang: Flags, spans: int, value: Floats, place: Floats) -> None:
    """The largest measure along every part, and its xi, into value and place (t, parts).

    measure (parts,) and scale (1 or t, parts, 4): kinds and factors of each `Measure`; a negative kind: NaN. overhang (parts,):
    leave out what is beyond the nut, the overhang of a base, which carries nothing but itself.
    spans : of the scan; a cubic has two humps at most, so a dozen part them.
    """
    for i in range(given.coef.shape[0]):
        row = i if scale.shape[0] > 1 else 0
        for part in range(given.coef.shape[1]):
            value[i, part], place[i, part] = math.nan, math.nan
            if measure[part] < 0:
                continue
            s0, s1, s2, s3 = scale[row, part, 0], scale[row, part, 1], scale[row, part, 2], scale[row, part, 3]
            sought = Measure(measure[part], s0, s1, s2, s3)
            place[i, part], value[i, part] = part_top(sought, given, i, part, overhang[part], spans)


@kernel_bare
def part_tension(given: Polynomials, i: int, part: int, overhang: bool, sign: float) -> Any:
    """Place and value of the largest sign T over the segments of a part, in closed form; `overhang`: up to the nut."""
    coef, ends, nut = given
    best_x, best = 0.0, -math.inf
    # maximum of the parabola of each segment: its ends or its vertex
    for j in range(coef.shape[2]):
        start = 0.0 if j == 0 else max(0.0, ends[i, part, j - 1])
        end = max(0.0, min(1.0, ends[i, part, j]))
        if j > 0 and (start >= 1.0 or (overhang and ends[i, part, j - 1] >= nut[i, part])):
            break
        t0, t1, t2 = sign * coef[i, part, j, 0], sign * coef[i, part, j, 1], sign * coef[i, part, j, 2]
        x = -0.5 * t1 / t2 if t2 < 0.0 else start
        if not start < x < end:
            x = start
        for place in (start, end, x):
            T = t0 + place * (t1 + place * t2)
            if not best >= T:  # true of what is no number, too
                best_x, best = place, T
    return best_x, best


@kernel_bare
def part_least_tension(given: Polynomials, i: int, part: int, overhang: bool) -> Any:
    """Place and value of the least T over the segments of a part; with `overhang` up to the nut."""
    place, value = part_tension(given, i, part, overhang, -1.0)
    return place, -value


@kernel
def least_tension(given: Polynomials, overhang: Flags, value: Floats, place: Floats) -> None:
    """The least T along every part and its xi (t, parts); what is beyond the nut of `overhang` parts is left out."""
    for i in range(given.coef.shape[0]):
        for part in range(given.coef.shape[1]):
            place[i, part], value[i, part] = part_least_tension(given, i, part, overhang[part])


@kernel_inline
def largest_parabola(c0: float, c1: float, c2: float, lo: float, hi: float) -> float:
    """Largest |c0 + c1 x + c2 x^2| over [lo, hi]."""
    best = max(abs(c0 + lo * (c1 + lo * c2)), abs(c0 + hi * (c1 + hi * c2)))
    if c2 != 0.0:
        x = -0.5 * c1 / c2
        if lo < x < hi:
            best = max(best, abs(c0 + 0.5 * c1 * x))
    return best
