"""Laws of motion as plain array functions: value, rate and acceleration at given times; divided differences of exp(s t).

Every law returns three arrays of the shape of `t`: the law, its first and its second derivative in time. Laws of
rest-to-rest moves run from 0 to 1 and hold outside the move; periodic laws and the step response go on.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import Floats

Law = tuple[Floats, Floats, Floats]


def quintic(t: Floats, duration: float) -> Law:
    """10 s^3 - 15 s^4 + 6 s^5 with s = t/duration; rate and acceleration vanish at both ends.

    Flash & Hogan (1985), J. Neurosci. 5, 1688: the path of least jerk between two points at rest.
    """
    s = np.clip(t / duration, 0.0, 1.0)
    value = s**3 * (10.0 + s * (6.0 * s - 15.0))
    rate = 30.0 * (s * (1.0 - s)) ** 2 / duration
    acceleration = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / duration**2
    return value, rate, acceleration


def trapezoid(t: Floats, duration: float, ramp: float) -> Law:
    """Constant acceleration over the fraction `ramp` of the time, constant rate, constant deceleration.

    Where the acceleration jumps, the value of the phase that is under way holds: that of the start at t = 0, that of
    the deceleration at the end.
    """
    s = t / duration
    top = 1.0 / (1.0 - ramp)
    slope = top / ramp
    early, late = s < ramp, s > 1.0 - ramp
    left = np.clip(1.0 - s, 0.0, None)
    passed = np.clip(s, 0.0, None)
    value = np.where(early, 0.5 * slope * passed**2, np.where(late, 1.0 - 0.5 * slope * left**2, top * (s - 0.5 * ramp)))
    rate = np.where(early, slope * passed, np.where(late, slope * left, top))
    acceleration = np.where(early, slope, np.where(late, -slope, 0.0))
    acceleration = np.where((s < 0.0) | (s > 1.0), 0.0, acceleration)
    return value, rate / duration, acceleration / duration**2


def steady(t: Floats) -> Law:
    """The time itself: a constant rate of 1."""
    return t.copy(), np.ones_like(t), np.zeros_like(t)


def sine(t: Floats, period: float, phase: float) -> Law:
    """sin(w t + phase) - sin(phase), w = 2 pi/period: starts from 0."""
    w = 2.0 * math.pi / period
    angle = w * t + phase
    return np.sin(angle) - math.sin(phase), w * np.cos(angle), -(w**2) * np.sin(angle)


def cyclic(t: Floats, period: float) -> Law:
    """(1 - cos(w t))/2, w = 2 pi/period: from 0 to 1 and back, at rest at both."""
    w = 2.0 * math.pi / period
    half = np.sin(0.5 * w * t)
    return half**2, 0.5 * w * np.sin(w * t), 0.5 * w**2 * np.cos(w * t)


def step_response(t: Floats, frequency: float, damping: float, third_pole: float | None = None) -> Law:
    """Response to a unit step of w^2/(s^2 + 2 zeta w s + w^2), times p/(s + p) if a third pole is given.

    Parameters
    ----------
    t : (n,), s. Before 0 the response is 0.
    frequency : w > 0, rad/s.
    damping : zeta > 0; below, at and above 1 alike.
    third_pole : p > 0, rad/s, or None for the second-order system. It may coincide with another pole.

    Notes
    -----
    The impulse response of 1/((s - s1)(s - s2)..) is the divided difference of exp(s t) over the poles, which stays
    regular where poles meet: McCurdy, Ng & Parlett (1984), Math. Comp. 43, 501. With h2 = w^2 exp[s1, s2]:
    h2' = w^2 (s1 exp[s1, s2] + exp(s2 t)) and y2 = 1 - (h2' + 2 zeta w h2)/w^2, from the differential equation;
    h3 = p w^2 exp[s1, s2, -p], h3' = p w^2 (s1 exp[s1, s2, -p] + exp[s2, -p]), y3 = y2 - h3/p.
    Lacy (1991), section 3.2, is the third-order case with p = 2 w.
    """
    after = np.clip(t, 0.0, None)
    w, zeta = frequency, damping
    s1, s2 = _pole_pair(w, zeta)
    two = exp_difference_2(after, s1, s2)
    rate = w**2 * two.real
    acceleration = w**2 * (s1 * two + np.exp(s2 * after)).real
    value = 1.0 - (acceleration + 2.0 * zeta * w * rate) / w**2
    if third_pole is not None:
        p = third_pole
        three = exp_difference_3(after, s1, s2, complex(-p))
        rate = p * w**2 * three.real
        acceleration = p * w**2 * (s1 * three + exp_difference_2(after, s2, complex(-p))).real
        value = value - rate / p
    before = t < 0.0
    return tuple(np.where(before, 0.0, part) for part in (value, rate, acceleration))  # type: ignore[return-value]


def _pole_pair(w: float, zeta: float) -> tuple[complex, complex]:
    """The two roots of s^2 + 2 zeta w s + w^2; real ones slow first, without cancellation."""
    if zeta < 1.0:
        return complex(-zeta * w, w * math.sqrt(1.0 - zeta**2)), complex(-zeta * w, -w * math.sqrt(1.0 - zeta**2))
    fast = zeta + math.sqrt(zeta**2 - 1.0)
    return complex(-w / fast), complex(-w * fast)


def spline(t: Floats, times: Floats, values: Floats) -> Law:
    """Interpolating spline through a table, with its two derivatives.

    Degree 5 (not-a-knot ends: a quintic is reproduced exactly), 3 below 6 points, and the polynomial through all points
    below 4.

    Parameters
    ----------
    t : (n,), s. Outside the table the value of its end holds.
    times : (k,), increasing, s.
    values : (k, m).

    Returns
    -------
    Three arrays (n, m).
    """
    from scipy.interpolate import make_interp_spline

    degree = 5 if times.size >= 6 else 3 if times.size >= 4 else times.size - 1
    # knots near zero and of order 1 keep the system well scaled for any clock
    origin, scale = times[0], (times[-1] - times[0]) / (times.size - 1)
    curve = make_interp_spline((times - origin) / scale, values, k=degree)
    inside = np.clip((t - origin) / scale, 0.0, (times[-1] - origin) / scale)
    outside = ((t < times[0]) | (t > times[-1]))[:, None]
    rate = np.where(outside, 0.0, curve(inside, 1) / scale)
    acceleration = np.where(outside, 0.0, curve(inside, 2) / scale**2)
    return curve(inside), rate, acceleration


# Divided differences of exp(s t) over two or three poles: exact, and regular where poles meet.

Complexes = NDArray[np.complex128]

TERMS = 24  # of the Taylor series inside the unit disc: the last is below 1/(2 * 23!), round-off


def exp_difference_2(t: Floats, a: complex, b: complex) -> Complexes:
    """(exp(a t) - exp(b t))/(a - b), or t exp(a t) where a = b; t >= 0."""
    if a.real > b.real:  # the larger exponential is taken out, so nothing overflows
        a, b = b, a
    if a == b:
        return np.asarray(t * np.exp(b * t))
    return np.asarray(np.exp(b * t) * _expm1(np.asarray((a - b) * t, np.complex128)) / (a - b))


def exp_difference_3(t: Floats, a: complex, b: complex, c: complex) -> Complexes:
    """Second divided difference of exp(s t) over a, b, c; t >= 0.

    Where all three lie within 1/t of their mean, by the Taylor series about the mean, whose terms are the complete
    homogeneous polynomials of the poles; elsewhere by differencing over the two that lie farthest apart.
    """
    mean = (a + b + c) / 3.0
    radius = max(abs(a - mean), abs(b - mean), abs(c - mean))
    near = radius * t < 1.0
    result = np.empty(t.shape, np.complex128)
    result[near] = _series(t[near], a - mean, b - mean, c - mean) * np.exp(mean * t[near])
    if not near.all():
        far = t[~near]
        a, b, c = _ends_apart(a, b, c)
        result[~near] = (exp_difference_2(far, a, b) - exp_difference_2(far, b, c)) / (a - c)
    return result


def _ends_apart(a: complex, b: complex, c: complex) -> tuple[complex, complex, complex]:
    """The three poles with the two that lie farthest apart at the ends."""
    return max(((a, b, c), (b, c, a), (c, a, b)), key=lambda three: abs(three[0] - three[2]))


def _series(t: Floats, a: complex, b: complex, c: complex) -> Complexes:
    """t^2 sum_k h_k(a, b, c) t^k/(k + 2)!, with a + b + c = 0."""
    e2, e3 = a * b + b * c + c * a, a * b * c
    h = [1.0 + 0.0j, 0.0j, -e2]
    # complete homogeneous symmetric polynomials h_k of the three poles, by their recurrence
    while len(h) < TERMS:
        h.append(-e2 * h[-2] + e3 * h[-3])
    total = np.zeros(t.shape, np.complex128)
    # Horner's scheme in t
    for k in range(TERMS - 1, -1, -1):
        total = total * t + h[k] / math.factorial(k + 2)
    return t**2 * total


def _expm1(z: Complexes) -> Complexes:
    """exp(z) - 1 without cancellation near 0."""
    grown = np.expm1(z.real)
    half = np.sin(0.5 * z.imag)
    return grown * np.cos(z.imag) - 2.0 * half**2 + 1j * (grown + 1.0) * np.sin(z.imag)
