"""Lengths of members and their rates along a motion."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Floats, Ints

__all__ = ["distances", "end_tensions", "lengths", "line_turning", "turn_rates"]


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


@kernel_inline
def line_turning(x: F1, v: F1, a: int, b: int) -> float:
    """|d x d'|/|d|^2 (rad/s) : how fast the line between two nodes turns; 0 where it has no length."""
    dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
    ex, ey, ez = v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]
    px, py, pz, square = dy * ez - dz * ey, dz * ex - dx * ez, dx * ey - dy * ex, dx * dx + dy * dy + dz * dz
    return math.sqrt(px * px + py * py + pz * pz) / square if square > 0.0 else 0.0


@kernel
def turn_rates(p: Ints, q: Ints, x: F2, v: F2, out: F1) -> None:
    """Fill out (times,) with the fastest turning of the lines between nodes p and q (k,), rad/s."""
    for i in range(x.shape[0]):
        fastest, places, speeds = 0.0, x[i], v[i]
        for m in range(p.size):
            fastest = max(fastest, line_turning(places, speeds, 3 * p[m], 3 * q[m]))
        out[i] = fastest
