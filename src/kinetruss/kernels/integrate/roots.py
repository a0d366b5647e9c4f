"""All places in [0, 1] at which a polynomial arrives at zero, by subdivision of its Bernstein form.

The variations in sign of the Bernstein coefficients bound the number of roots from above, and differ from it by an even number
(Descartes' rule; Eigenwillig, Sharma & Yap, ISSAC 2006, 71-78): none means none, one means exactly one. Else the interval is
halved (de Casteljau). So no root is overlooked, however many lie in one step.

Values within a band of zero, of the size of round-off, count as zero. The side on which the polynomial was last is carried
from step to step: 1 above, -1 below, 0 at zero, where it has arrived already.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Vector

__all__ = ["NODES", "TO_BERNSTEIN", "bernstein", "derivatives", "roots"]

DEEPEST = 44
"""Halvings of a step: 2^-44 of it is below the round-off of its time."""
TURNS = 60
DEGREE = 12
"""Of the polynomial through sampled values."""
NODES = 0.5 - 0.5 * np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
"""Chebyshev's places of samples, in parts of an interval."""


def _to_bernstein() -> np.ndarray:
    """Matrix from values at NODES to Bernstein coefficients, and from them to the last two Chebyshev coefficients."""
    from math import comb

    basis = np.array([[comb(DEGREE, j) * s**j * (1 - s) ** (DEGREE - j) for j in range(DEGREE + 1)] for s in NODES])
    return np.ascontiguousarray(np.linalg.inv(basis))


TO_BERNSTEIN = _to_bernstein()


@kernel_bare
def bernstein(power: F1, n: int, out: F1) -> float:
    """Coefficients in Bernstein's basis of degree n from those of powers; returns the sum of the sizes of the latter.

    b_i = sum_j C(i, j)/C(n, j) a_j, by sums alone: as exact as the powers are (Farouki & Rajan 1987, CAGD 4, 191).
    """
    size, choose = 0.0, 1.0
    # scaled powers a_j/C(n, j)
    for j in range(n + 1):
        out[j] = power[j] / choose
        size += abs(power[j])
        choose *= (n - j) / (j + 1.0)
    # b_i by repeated sums along Pascal's triangle
    for k in range(1, n + 1):
        for i in range(n, k - 1, -1):
            out[i] += out[i - 1]
    return size


@kernel_bare
def derivatives(b: F1, n: int, s: float, scratch: F1) -> Vector:
    """Value, slope and curvature at s of the polynomial with the coefficients b[:n + 1]; n > 1; scratch (n + 1,)."""
    r = 1.0 - s
    for i in range(n + 1):
        scratch[i] = b[i]
    # de Casteljau down to degree two: the last three points hold value, slope and curvature
    for k in range(1, n - 1):
        for i in range(n + 1 - k):
            scratch[i] = r * scratch[i] + s * scratch[i + 1]
    curvature = n * (n - 1) * (scratch[2] - 2.0 * scratch[1] + scratch[0])
    low, high = r * scratch[0] + s * scratch[1], r * scratch[1] + s * scratch[2]
    return r * low + s * high, n * (high - low), curvature


@kernel_bare
def _halve(b: F1, left: F1, right: F1, n: int) -> None:
    """The coefficients of both halves of an interval; `right` may be b."""
    for i in range(n + 1):
        right[i] = b[i]
    left[0] = right[0]
    # de Casteljau at 1/2: the edges of the triangle are the coefficients of both halves
    for k in range(1, n + 1):
        for i in range(n + 1 - k):
            right[i] = 0.5 * (right[i] + right[i + 1])
        left[k] = right[0]


@kernel_inline
def _side(value: float, band: float) -> int:
    return 1 if value > band else (-1 if value < -band else 0)


@kernel_bare
def _variations(b: F1, n: int, band: float) -> tuple[int, int, int, int]:
    """Changes of sign along the coefficients beyond the band, the first and the last of their signs, and 1 where some within
    the band lie between two of one sign: there the polynomial may touch zero.
    """
    count, first, last, within, touches = 0, 0, 0, False, 0
    # sign changes along the coefficients bound the number of roots (Descartes)
    for i in range(n + 1):
        sign = _side(b[i], band)
        if sign == 0:
            within = last != 0
            continue
        if last == 0:
            first = sign
        elif sign != last:
            count += 1
        elif within:
            touches = 1
        last, within = sign, False
    return count, first, last, touches


@kernel_bare
def _one(b: F1, n: int, low: float, high: float, rising: bool, scratch: F1) -> float:
    """The only root between low and high: Newton's method kept between bounds."""
    s = 0.5 * (low + high)
    # Newton's method, bisection where it leaves the bracket
    for _ in range(TURNS):
        value, slope, _ = derivatives(b, n, s, scratch)
        if value == 0.0:
            return s
        if (value > 0.0) == rising:
            high = s
        else:
            low = s
        new = s - value / slope if slope != 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - s) <= 1e-16 or not low < new < high:
            return new
        s = new
    return s


@kernel_bare
def _nearby(b: F1, n: int, s: float, reach: float, band: float, scratch: F1) -> float:
    """Where a polynomial within the band at s is zero: at its turning point where it turns back there, else at its root."""
    start = s
    # Newton's method for p = 0, or for p' = 0 where the polynomial only touches zero
    for _ in range(4):
        value, slope, curvature = derivatives(b, n, s, scratch)
        turning = curvature != 0.0 and slope * slope <= 16.0 * abs(curvature) * max(abs(value), band)
        step = slope / curvature if turning else (value / slope if slope != 0.0 else 0.0)
        new = min(max(s - step, 0.0), 1.0)
        if not abs(new - start) <= reach:
            break
        s = new
    return s


@kernel_bare
def _entered(found: F2, k: int, s: float, way: int, slope: float) -> int:
    """One more arrival at s, rising (1) or falling (-1); returns how many there are."""
    if k < found.shape[0]:
        found[k, 0], found[k, 1], found[k, 2] = s, way, slope
        return k + 1
    return k


@kernel_bare
def _arrived(b: F1, n: int, s: float, side: int, band: float, found: F2, k: int, scratch: F1) -> int:
    """Enter the arrival next to s, where the polynomial is within the band."""
    s = _nearby(b, n, s, 1e-3, band, scratch)
    _, slope, _ = derivatives(b, n, s, scratch)
    return _entered(found, k, s, -side, slope)


@kernel_bare
def roots(b: F1, n: int, side: int, band: float, level: float, stack: F2, found: F2, scratch: F1) -> tuple[int, int]:
    """Arrivals at zero of the polynomial b[:n + 1] over [0, 1] into found (k, 3): place, 1 rising or -1 falling, and the
    slope there, 0 where it only touches zero or jumps.

    side : where it was before. level : at the start of a run, what is no farther than this from zero stands there already, and
    leaves it without arriving; else 0. stack (DEEPEST + 2, n + 3) and scratch (n + 1,) are scratch.
    Returns the number found and the side at the end.
    """
    count, top = 0, 1
    # the whole interval first
    for i in range(n + 1):
        stack[0, i] = b[i]
    stack[0, n + 1], stack[0, n + 2] = 0.0, 0.0
    # depth-first from left to right: no sign change, no root; one, exactly one; more, halve
    while top > 0:
        top -= 1
        c, low, depth = stack[top], stack[top, n + 1], stack[top, n + 2]
        width = 0.5**depth
        if side != 0 and abs(c[0]) <= band:
            count, side = _arrived(b, n, low, side, band, found, count, scratch), 0
        changes, first, last, touches = _variations(c, n, band)
        if (changes > 1 or touches) and depth < DEEPEST:
            _halve(c, scratch, c, n)
            for i in range(n + 1):
                stack[top + 1, i] = scratch[i]
            c[n + 1], c[n + 2] = low + 0.5 * width, depth + 1.0
            stack[top + 1, n + 1], stack[top + 1, n + 2] = low, depth + 1.0
            top += 2
            continue
        there = side == 0
        if first != 0:
            # the side changed between two steps, where something jumps
            if side == -first:
                count = _entered(found, count, low, first, 0.0)
            side = first
        if changes > 0:
            s = _one(b, n, low, low + width, last > 0, scratch) if first != last else low + 0.5 * width
            farthest, _, _ = derivatives(b, n, 0.5 * (low + s), scratch)
            near = max(level, 2.0 * band) if count == 0 and abs(b[0]) <= level else 2.0 * band
            # what has not left zero cannot arrive there
            if not there or abs(farthest) > near:
                _, slope, _ = derivatives(b, n, s, scratch)
                count = _entered(found, count, s, -first, slope)
            behind, _, _ = derivatives(b, n, 0.5 * (s + low + width), scratch)
            # where it ends at zero it may only have turned back there
            side = last if abs(c[n]) > band or abs(behind) > 2.0 * band else 0
        if side != 0 and abs(c[n]) <= band:
            count, side = _arrived(b, n, low + width, side, band, found, count, scratch), 0
    return count, side
