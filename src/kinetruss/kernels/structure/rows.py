"""Rows of the equations between two nodes: gradients, residuals on all three levels, forces, and motions given in time.

Length row: d/L . (...), residual (|d|^2/L - L)/2, rate d/L . d' = L', d/L . d'' = (L'^2 + L L'' - |d'|^2)/L.
Angle row, n = (-sin, cos): n . d = 0, n . d' = w l, n . d'' = w' l + 2 w (c . d') + w^2 (n . d), c = (cos, sin), l = c . d.
Rows of kind SUM depend on more than two nodes: they have gradient 0 here, and are added by structure.sums.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I1, Floats, Ints, Vector
from kinetruss.kernels.structure.mass import between, dot
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM


@kernel_inline
def targets(kind: I1, motion: I1, value: F1, now: F2, target: F2) -> None:
    """What rows are held to into target (3, r): length or angle, its rate, the reciprocal of the length (1 for an angle)."""
    # targets L and L' (or angle and rate) of Phi = 0, and 1/L
    for k in range(kind.size):
        d = motion[k]
        target[0, k] = now[0, d] if d >= 0 else value[k]
        target[1, k] = now[1, d] if d >= 0 else 0.0
        target[2, k] = 1.0 / target[0, k] if kind[k] == LENGTH else 1.0


@kernel_inline
def row_gradient(kind: int, d: Vector, target: float, reciprocal: float) -> Vector:
    """Gradient of a row with respect to the position of B, d = x_B - x_A; `target`, `reciprocal` as in `targets`."""
    if kind == LENGTH:
        return d[0] * reciprocal, d[1] * reciprocal, d[2] * reciprocal
    if kind == ANGLE:
        return -math.sin(target), math.cos(target), 0.0
    return 0.0, 0.0, 0.0


@kernel_inline
def unit_gradient(kind: int, d: Vector) -> Vector:
    """The same from positions alone, whether or not they meet the target; of unit size."""
    scale = 0.0 if kind == SUM else 1.0 / math.sqrt(dot(d, d))
    if kind == ANGLE:
        return -d[1] * scale, d[0] * scale, 0.0
    return d[0] * scale, d[1] * scale, d[2] * scale


@kernel_inline
def row_residual(kind: int, g: Vector, d: Vector, target: float) -> float:
    """Residual of a row with gradient g, m."""
    along = dot(g, d)
    return 0.5 * (along - target) if kind == LENGTH else along


@kernel_inline
def row_rate(kind: int, g: Vector | F1, d: Vector, rate: float) -> float:
    """What g . d' is to be where the target changes at a rate, m/s."""
    return rate * (g[1] * d[0] - g[0] * d[1]) if kind == ANGLE else rate


@kernel_inline
def row_second(kind: int, g: Vector | F1, d: Vector, e: Vector, rate: float, second: float, reciprocal: float) -> float:
    """What g . d'' is to be where d' = e and the target changes at a rate and a second rate, m/s^2."""
    if kind == ANGLE:
        along, across, turning = g[1] * d[0] - g[0] * d[1], g[1] * d[1] + g[0] * d[0], g[1] * e[0] - g[0] * e[1]
        return second * along + 2.0 * rate * turning + rate * rate * across
    if kind == SUM:
        return second
    return second + (rate * rate - dot(e, e)) * reciprocal


@kernel_inline
def gradients(kind: I1, A: I1, B: I1, x: F1, target: F2, u: F2) -> None:
    """Gradients of the rows with respect to the position of B into u (3, r)."""
    # rows of J: g at B, -g at A
    for k in range(kind.size):
        u[0, k], u[1, k], u[2, k] = row_gradient(kind[k], between(x, A[k], B[k]), target[0, k], target[2, k])


@kernel_inline
def along_rows(A: I1, B: I1, u: F2, y: F1, out: F1) -> None:
    """J y into out (r,), with all coordinates of y."""
    # J y: g . (y_B - y_A)
    for k in range(A.size):
        out[k] = dot((u[0, k], u[1, k], u[2, k]), between(y, A[k], B[k]))


@kernel_inline
def add_row_forces(A: I1, B: I1, u: F2, N: F1, f: F1) -> None:
    """f -= J^T N over all coordinates."""
    # -J^T N: the tension N g acts at A towards B, and at B towards A
    for k in range(A.size):
        a, b = A[k], B[k]
        for c in range(3):
            force = N[k] * u[c, k]
            f[a + c] += force
            f[b + c] -= force


@kernel_inline
def position_residuals(kind: I1, A: I1, B: I1, x: F1, target: F2, out: F1) -> float:
    """Residuals of the rows (m) into out (r,); returns the largest share of a length."""
    largest = 0.0
    # Phi(x): (|d|^2/L - L)/2 of a length, n . d of an angle
    for k in range(kind.size):
        d, scale = between(x, A[k], B[k]), target[2, k]
        out[k] = row_residual(kind[k], row_gradient(kind[k], d, target[0, k], scale), d, target[0, k])
        if kind[k] == ANGLE:
            scale = 1.0 / math.sqrt(d[0] * d[0] + d[1] * d[1])
        if kind[k] != SUM:
            largest = larger(largest, abs(out[k]) * scale)
    return largest


@kernel_inline
def velocity_residuals(kind: I1, A: I1, B: I1, x: F1, v: F1, target: F2, u: F2, out: F1) -> float:
    """J v minus the wanted rates (m/s) into out (r,); returns the largest."""
    largest = 0.0
    # Phi' = J v - (prescribed rate)
    for k in range(kind.size):
        if kind[k] == SUM:
            continue
        g = u[0, k], u[1, k], u[2, k]
        out[k] = dot(g, between(v, A[k], B[k])) - row_rate(kind[k], g, between(x, A[k], B[k]), target[1, k])
        largest = larger(largest, abs(out[k]))
    return largest


# Known forces of rows put onto joints and nodes.


@kernel
def row_forces(member: Ints, kind: Ints, A: Ints, B: Ints, x: F2, N: F2, joint: Floats, rest: F2) -> None:
    """Add the force of every row to joint (times, members, 2, 3), and take it from rest (times, 3 n). Sums are left out.

    member, kind, A, B (rows,): member of the row, LENGTH or ANGLE, flat first coordinates of its ends. x (times, 3 n) positions
    that fulfil the rows; N (times, rows): tension, or of an angle row minus the torque over the length.
    """
    # J^T N row by row: tension N along g, -N g on the member at A, +N g at B; the nodes take the opposite
    for i in range(x.shape[0]):
        for k in range(A.size):
            if kind[k] == SUM:
                continue
            a, b, m = A[k], B[k], member[k]
            g = unit_gradient(kind[k], between(x[i], a, b))
            for c in range(3):
                force = N[i, k] * g[c]
                joint[i, m, 0, c] -= force
                joint[i, m, 1, c] += force
                rest[i, a + c] += force
                rest[i, b + c] -= force


# Motions of drives and supports at any time inside a kernel: piecewise polynomials and sines, exact in all derivatives.

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
