"""Motions of drives and supports at any time inside a kernel: piecewise polynomials and sines, exact in all derivatives."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1

__all__ = ["POLYNOMIAL", "SINE", "motions", "piece_at"]

POLYNOMIAL, SINE = 0, 1


@kernel_bare
def piece_at(ptr: I1, start: F1, d: int, t: float) -> int:
    """The piece of motion d that holds at t."""
    low, high = ptr[d], ptr[d + 1]
    # bisection for the last piece that starts at t or before
    while high - low > 1:
        middle = (low + high) // 2
        if start[middle] <= t:
            low = middle
        else:
            high = middle
    return low


@kernel_bare
def motions(kind: I1, data: F2, ptr: I1, start: F1, piece: F2, t: float, now: F2) -> None:
    """Value, rate and acceleration of every motion at t into now (3, d).

    POLYNOMIAL: pieces ptr[d]:ptr[d+1], piece i from start[i] on: sum_k piece[i, k] (t - start[i])^k; the first piece also holds
    before its start. SINE: data = mean, amplitude, angular frequency, phase.
    """
    # q(t), q'(t), q''(t) of each prescribed motion
    for d in range(kind.size):
        if kind[d] == SINE:
            w = data[d, 2]
            angle = w * t + data[d, 3]
            now[0, d] = data[d, 0] + data[d, 1] * math.sin(angle)
            now[1, d] = data[d, 1] * w * math.cos(angle)
            now[2, d] = -data[d, 1] * w * w * math.sin(angle)
            continue
        low = piece_at(ptr, start, d, t)
        s = t - start[low]
        value, rate, half = 0.0, 0.0, 0.0
        # Horner's scheme for the polynomial, its derivative and half its second derivative
        for k in range(piece.shape[1] - 1, -1, -1):
            half = half * s + rate
            rate = rate * s + value
            value = value * s + piece[low, k]
        now[0, d], now[1, d], now[2, d] = value, rate, 2.0 * half
