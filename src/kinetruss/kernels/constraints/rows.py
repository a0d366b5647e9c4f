"""Rows of the equations: gradients, residuals on all three levels, pulls.

Length row: d/L . (...), residual (|d|^2/L - L)/2, rate d/L . d' = L', d/L . d'' = (L'^2 + L L'' - |d'|^2)/L.
Angle row, n = (-sin, cos): n . d = 0, n . d' = w l, n . d'' = w' l + 2 w (c . d') + w^2 (n . d), c = (cos, sin), l = c . d.
Rows of kind SUM depend on more than two nodes: they have gradient 0 here, and are added by _sum_rows.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.structure.plan import ANGLE, LENGTH, SUM

__all__ = ["add_pulls", "aims", "along_rows", "gradients", "position_residuals", "second_terms", "velocity_residuals"]


@kernel_inline
def aims(kind, motion, value, now, aim):  # type: ignore[no-untyped-def]
    """What rows are held to into aim (3, r): length or angle, its rate, the reciprocal of the length (1 for an angle)."""
    for k in range(kind.size):
        d = motion[k]
        aim[0, k] = now[0, d] if d >= 0 else value[k]
        aim[1, k] = now[1, d] if d >= 0 else 0.0
        aim[2, k] = 1.0 / aim[0, k] if kind[k] == LENGTH else 1.0


@kernel_inline
def gradients(kind, A, B, x, aim, u):  # type: ignore[no-untyped-def]
    """Gradients of the rows with respect to the position of B into u (3, r)."""
    for k in range(kind.size):
        if kind[k] != LENGTH:
            angle = kind[k] == ANGLE
            u[0, k], u[1, k], u[2, k] = -math.sin(aim[0, k]) if angle else 0.0, math.cos(aim[0, k]) if angle else 0.0, 0.0
            continue
        a, b, scale = A[k], B[k], aim[2, k]
        u[0, k] = (x[b] - x[a]) * scale
        u[1, k] = (x[b + 1] - x[a + 1]) * scale
        u[2, k] = (x[b + 2] - x[a + 2]) * scale


@kernel_inline
def along_rows(A, B, u, y, out):  # type: ignore[no-untyped-def]
    """J y into out (r,), with all coordinates of y."""
    for k in range(A.size):
        a, b = A[k], B[k]
        out[k] = u[0, k] * (y[b] - y[a]) + u[1, k] * (y[b + 1] - y[a + 1]) + u[2, k] * (y[b + 2] - y[a + 2])


@kernel_inline
def add_pulls(A, B, u, N, f):  # type: ignore[no-untyped-def]
    """f -= J^T N over all coordinates."""
    for k in range(A.size):
        a, b = A[k], B[k]
        for c in range(3):
            pull = N[k] * u[c, k]
            f[a + c] += pull
            f[b + c] -= pull


@kernel_inline
def position_residuals(kind, A, B, x, aim, out):  # type: ignore[no-untyped-def]
    """Residuals of the rows (m) into out (r,); returns the largest share of a length."""
    largest = 0.0
    for k in range(kind.size):
        a, b, scale = A[k], B[k], aim[2, k]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        if kind[k] == SUM:
            out[k] = 0.0
            continue
        if kind[k] == ANGLE:
            out[k] = -math.sin(aim[0, k]) * dx + math.cos(aim[0, k]) * dy
            scale = 1.0 / math.sqrt(dx * dx + dy * dy)
        else:
            out[k] = 0.5 * ((dx * dx + dy * dy + dz * dz) * scale - aim[0, k])
        size = abs(out[k]) * scale
        largest = larger(largest, size)
    return largest


@kernel_inline
def velocity_residuals(kind, A, B, x, v, aim, u, out):  # type: ignore[no-untyped-def]
    """J v minus the wanted rates (m/s) into out (r,); returns the largest."""
    largest = 0.0
    for k in range(kind.size):
        a, b = A[k], B[k]
        wanted = aim[1, k]
        if kind[k] == SUM:
            continue
        if kind[k] == ANGLE:
            wanted *= u[1, k] * (x[b] - x[a]) - u[0, k] * (x[b + 1] - x[a + 1])
        rate = u[0, k] * (v[b] - v[a]) + u[1, k] * (v[b + 1] - v[a + 1]) + u[2, k] * (v[b + 2] - v[a + 2]) - wanted
        out[k] = rate
        largest = larger(largest, abs(rate))
    return largest


@kernel_inline
def second_terms(kind, A, B, motion, now, x, v, aim, u, gamma):  # type: ignore[no-untyped-def]
    """Right-hand sides of J a = gamma."""
    for k in range(kind.size):
        a, b, d = A[k], B[k], motion[k]
        second = now[2, d] if d >= 0 else 0.0
        dx, dy, dz = v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]
        rate = aim[1, k]
        if kind[k] == ANGLE:
            c, s = u[1, k], -u[0, k]
            ex, ey = x[b] - x[a], x[b + 1] - x[a + 1]
            gamma[k] = second * (c * ex + s * ey) + 2.0 * rate * (c * dx + s * dy) + rate * rate * (c * ey - s * ex)
        elif kind[k] == SUM:
            gamma[k] = second
        else:
            gamma[k] = second + (rate * rate - dx * dx - dy * dy - dz * dz) * aim[2, k]
