"""Lengths of members and their rates along a motion."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, F2, Floats, Ints

__all__ = ["distances", "end_tensions", "lengths", "turn_rates"]


@kernel
def lengths(p: Ints, q: Ints, x: F2, v: F2, a: F2, length: F2, rate: F2, acceleration: F2) -> None:
    """Fill length, rate, acceleration (times, members): L = |d|, L' = u . d', L'' = u . d'' + (|d'|^2 - L'^2)/L."""
    # L, L' = u . d', L'' = u . d'' + (|d'|^2 - L'^2)/L
    for i in range(x.shape[0]):
        for m in range(p.size):
            A, B = 3 * p[m], 3 * q[m]
            square, along, speed, second = 0.0, 0.0, 0.0, 0.0
            for c in range(3):
                d, dv = x[i, B + c] - x[i, A + c], v[i, B + c] - v[i, A + c]
                square += d * d
                along += d * dv
                speed += dv * dv
                second += d * (a[i, B + c] - a[i, A + c])
            L = math.sqrt(square)
            Ld = along / L
            length[i, m] = L
            rate[i, m] = Ld
            acceleration[i, m] = (second + speed - Ld * Ld) / L


@kernel
def distances(p: Ints, q: Ints, x: F2, out: F2) -> None:
    """Fill out (times, k) with the distances of nodes p (k,) and q (k,) at positions x (times, 3 n)."""
    # |x_q - x_p|
    for i in range(x.shape[0]):
        for m in range(p.size):
            A, B, square = 3 * p[m], 3 * q[m], 0.0
            for c in range(3):
                d = x[i, B + c] - x[i, A + c]
                square += d * d
            out[i, m] = math.sqrt(square)


@kernel
def end_tensions(p: Ints, q: Ints, x: F2, joint: Floats, out: Floats) -> None:
    """Axial tension at both ends (times, members, 2) from joint forces (times, members, 2, 3): -F_A . u and F_B . u."""
    # T_A = -F_A . u, T_B = F_B . u
    for i in range(x.shape[0]):
        for m in range(p.size):
            A, B = 3 * p[m], 3 * q[m]
            square, first, second = 0.0, 0.0, 0.0
            for c in range(3):
                d = x[i, B + c] - x[i, A + c]
                square += d * d
                first -= d * joint[i, m, 0, c]
                second += d * joint[i, m, 1, c]
            inverse = 1.0 / math.sqrt(square)
            out[i, m, 0] = first * inverse
            out[i, m, 1] = second * inverse


@kernel
def turn_rates(p: Ints, q: Ints, x: F2, v: F2, out: F1) -> None:
    """Fill out (times,) with the fastest turning of the lines between nodes p and q (k,), |d x d'|/|d|^2, rad/s."""
    # |d x d'|/|d|^2, the largest over the lines
    for i in range(x.shape[0]):
        fastest = 0.0
        for m in range(p.size):
            A, B = 3 * p[m], 3 * q[m]
            dx, dy, dz = x[i, B] - x[i, A], x[i, B + 1] - x[i, A + 1], x[i, B + 2] - x[i, A + 2]
            ex, ey, ez = v[i, B] - v[i, A], v[i, B + 1] - v[i, A + 1], v[i, B + 2] - v[i, A + 2]
            px, py, pz, square = dy * ez - dz * ey, dz * ex - dx * ez, dx * ey - dy * ex, dx * dx + dy * dy + dz * dz
            if square > 0.0:
                fastest = max(fastest, math.sqrt(px * px + py * py + pz * pz) / square)
        out[i] = fastest
