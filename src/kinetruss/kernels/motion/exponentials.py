"""Divided differences of exp(s t) over two or three poles: exact, and regular where poles meet."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import Floats

__all__ = ["exp_difference_2", "exp_difference_3"]

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
