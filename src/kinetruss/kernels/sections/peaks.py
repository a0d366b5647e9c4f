"""Where along a part a measure of its section forces is largest: located between stations, not only sampled.

T is quadratic along a segment, V quadratic, M cubic (`section_polynomials`), so a scan of a few stations finds every hump and
a bracketed search (golden section with parabolic steps) tops it.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.sections.stress import von_mises

__all__ = ["MOMENT_RESULTANT", "MOMENT_SUM", "least_tension", "part_least_tension", "part_top", "peaks"]

Floats = NDArray[np.float64]
Shapes = NDArray[np.int8]
Flags = NDArray[np.bool_]

MOMENT_RESULTANT, MOMENT_SUM = 10, 11
"""Measures beside the shapes of `von_mises`: w2 sqrt(M2^2 + M3^2), and w2 |M2| + w3 |M3|."""

_GOLDEN = 0.3819660112501051
_TOLERANCE = 1e-7


@kernel
def _measure(measure: int, c: Any, x: float, s0: float, s1: float, s2: float, s3: float) -> Any:
    m2 = c[9] + x * (c[10] + x * (c[11] + x * c[12]))
    m3 = c[13] + x * (c[14] + x * (c[15] + x * c[16]))
    if measure == MOMENT_RESULTANT:
        return s1 * math.sqrt(m2 * m2 + m3 * m3)
    if measure == MOMENT_SUM:
        return s1 * abs(m2) + s2 * abs(m3)
    tension = c[0] + x * (c[1] + x * c[2])
    v2, v3 = c[3] + x * (c[4] + x * c[5]), c[6] + x * (c[7] + x * c[8])
    return von_mises(measure, s0 * tension, s1 * m2, s2 * m3, s3 * v2, s3 * v3)


@kernel
def _top(measure: int, c: Any, lo: float, x: float, hi: float, fx: float, s0: float, s1: float, s2: float, s3: float) -> Any:
    """Largest measure in [lo, hi] around x by Brent's method (Brent, 1973, chapter 5): place and value."""
    w = v = x
    fw = fv = fx
    step = last = 0.0
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
        fu = _measure(measure, c, u, s0, s1, s2, s3)
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


@kernel
def _segment(measure: int, c: Any, start: float, end: float, spans: int, s0: float, s1: float, s2: float, s3: float) -> Any:
    """Place and value of the largest measure over one segment."""
    h = (end - start) / spans
    best_x, best = start, -1.0
    before, here = -1.0, _measure(measure, c, start, s0, s1, s2, s3)
    for n in range(spans + 1):
        x = start + n * h
        after = _measure(measure, c, x + h, s0, s1, s2, s3) if n < spans else -1.0
        if here >= before and here >= after:
            lo, hi = max(start, x - h), min(end, x + h)
            top_x, top = x, here
            # an end that falls away inwards is its own top
            inward = x + 1e-6 * h if n == 0 else x - 1e-6 * h
            if 0 < n < spans or _measure(measure, c, inward, s0, s1, s2, s3) > here:
                top_x, top = _top(measure, c, lo, x, hi, here, s0, s1, s2, s3)
            if top > best:
                best_x, best = top_x, top
        before, here = here, after
    return best_x, best


@kernel
def part_top(
    measure: int, coef: Floats, ends: Floats, i: int, part: int, path: bool, spans: int,
    s0: float, s1: float, s2: float, s3: float,
) -> Any:  # fmt: skip
    """Place and value of the largest measure over the segments of a part; with `path` over the first one alone."""
    value, place = math.nan, math.nan
    for j in range(coef.shape[2]):
        start, end = 0.0 if j == 0 else max(0.0, ends[i, part, j - 1]), min(1.0, ends[i, part, j])
        if j > 0 and (start >= 1.0 or path):
            break
        if end < start:
            continue
        c = (
            coef[i, part, j, 0], coef[i, part, j, 1], coef[i, part, j, 2], coef[i, part, j, 3], coef[i, part, j, 4],
            coef[i, part, j, 5], coef[i, part, j, 6], coef[i, part, j, 7], coef[i, part, j, 8], coef[i, part, j, 9],
            coef[i, part, j, 10], coef[i, part, j, 11], coef[i, part, j, 12], coef[i, part, j, 13],
            coef[i, part, j, 14], coef[i, part, j, 15], coef[i, part, j, 16],
        )  # fmt: skip
        x, top = _segment(measure, c, start, end, spans, s0, s1, s2, s3)
        if j == 0 or not top <= value:
            value, place = top, x
    return place, value


@kernel
def peaks(
    coef: Floats, ends: Floats, measure: Shapes, scale: Floats, overhang: Flags, spans: int, value: Floats, place: Floats
) -> None:  # fmt: skip
    """The largest measure along every part, and its xi, into value and place (t, parts).

    coef, ends from `section_polynomials`; measure (parts,): a shape of `von_mises` (scale: 1/A, c3/I2, c2/I3, shear factor/A)
    or a moment measure (scale: 0, w2, w3, 0); negative: NaN. scale (1 or t, parts, 4). overhang (parts,): leave out what is
    behind the first segment, the overhang of a base beyond the nut, which carries nothing but itself. spans : of the scan; a
    cubic has two humps at most, so a dozen part them.
    """
    for i in range(coef.shape[0]):
        row = i if scale.shape[0] > 1 else 0
        for part in range(coef.shape[1]):
            value[i, part], place[i, part] = math.nan, math.nan
            if measure[part] < 0:
                continue
            s0, s1, s2, s3 = scale[row, part, 0], scale[row, part, 1], scale[row, part, 2], scale[row, part, 3]
            place[i, part], value[i, part] = part_top(measure[part], coef, ends, i, part, overhang[part], spans, s0, s1, s2, s3)


@kernel
def part_least_tension(coef: Floats, ends: Floats, i: int, part: int, overhang: bool) -> Any:
    """Place and value of the least T over the segments of a part, in closed form; with `overhang` over the first one alone."""
    best_x, best = 0.0, math.inf
    for j in range(coef.shape[2]):
        start = 0.0 if j == 0 else max(0.0, ends[i, part, j - 1])
        end = max(0.0, min(1.0, ends[i, part, j]))
        if j > 0 and (start >= 1.0 or overhang):
            break
        t0, t1, t2 = coef[i, part, j, 0], coef[i, part, j, 1], coef[i, part, j, 2]
        x = -0.5 * t1 / t2 if t2 > 0.0 else start
        if not start < x < end:
            x = start
        for place in (start, end, x):
            T = t0 + place * (t1 + place * t2)
            if not best <= T:  # true of what is no number, too
                best_x, best = place, T
    return best_x, best


@kernel
def least_tension(coef: Floats, ends: Floats, overhang: Flags, value: Floats, place: Floats) -> None:
    """The least T along every part and its xi (t, parts); what is behind the first segment of `overhang` parts is left out."""
    for i in range(coef.shape[0]):
        for part in range(coef.shape[1]):
            place[i, part], value[i, part] = part_least_tension(coef, ends, i, part, overhang[part])
