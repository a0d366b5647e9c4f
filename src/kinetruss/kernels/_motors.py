"""Members driven by motors: how accelerations and forces depend on those of their lengths, and projection beside them."""

from __future__ import annotations

import math

from kinetruss.kernels import _equations as e
from kinetruss.kernels._jit import kernel, kernel_inner
from kinetruss.kernels._kkt import evaluate, factor, prepare_rows, project, row_rate_gaps, solve
from kinetruss.kernels._parts import integers, matrix, vector

__all__ = ["motor_project", "motor_response"]


@kernel_inner
def _lengths(A, B, rows, x, v, length, rate):  # type: ignore[no-untyped-def]
    """Lengths and their rates of the rows at x, v."""
    for j in range(rows.size):
        a, b = A[rows[j]], B[rows[j]]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        length[j] = math.sqrt(dx * dx + dy * dy + dz * dz)
        rate[j] = (dx * (v[b] - v[a]) + dy * (v[b + 1] - v[a + 1]) + dz * (v[b + 2] - v[a + 2])) / length[j]


@kernel
def motor_response(eq, ws, user, t, x, v, rows, length, rate, a, N, da, dN):  # type: ignore[no-untyped-def]
    """a (3 n,), N (r,) where the lengths of `rows` (k,) do not accelerate; what a unit of each adds: da (k, 3 n), dN (k, r).

    length, rate (k,) : of these rows at x, v. The rows are held at their present lengths, which lie within the constraint as
    they are; evaluated at rest, their right-hand side lacks L'^2/L, which is added as if it were an acceleration of the length.
    Returns the smallest scaled pivot.
    """
    prepare_rows(eq, ws, t, x, v)
    _lengths(integers(eq, e.A_), integers(eq, e.B_), rows, x, v, length, rate)
    value = vector(eq, e.VALUE)
    for j in range(rows.size):
        value[rows[j]] = length[j]
    pivot = evaluate(eq, ws, user, t, x, v, a, N)
    f, gamma = vector(ws, e.F), vector(ws, e.GAMMA)
    for j in range(rows.size):
        for c in range(f.size):
            f[c] = 0.0
            da[j, c] = 0.0
        for k in range(gamma.size):
            gamma[k] = 0.0
        gamma[rows[j]] = 1.0
        solve(eq, ws, f, gamma, da[j], dN[j])
        missing = rate[j] * rate[j] / length[j]
        for c in range(f.size):
            a[c] += missing * da[j, c]
        for k in range(gamma.size):
            N[k] += missing * dN[j, k]
    return pivot


@kernel
def motor_project(eq, ws, t, x, v, rows, stuck, length, rate, scratch, tol):  # type: ignore[no-untyped-def]
    """Bring x and v onto the constraints; stuck `rows` stand at `length`, the others keep their length and rate.

    stuck (k,) : 1 or 0. rate (k,), scratch (3 n,) : room. Returns (settled, largest change of a coordinate, m).
    """
    A, B, value, free = integers(eq, e.A_), integers(eq, e.B_), vector(eq, e.VALUE), integers(eq, e.FREE)
    prepare_rows(eq, ws, t, x, v)
    for j in range(rows.size):
        a, b = A[rows[j]], B[rows[j]]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        now = math.sqrt(dx * dx + dy * dy + dz * dz)
        rate[j] = (dx * (v[b] - v[a]) + dy * (v[b + 1] - v[a + 1]) + dz * (v[b + 2] - v[a + 2])) / now
        if stuck[j]:
            rate[j] = 0.0
        else:
            length[j] = now
        value[rows[j]] = length[j]
    for c in range(v.size):
        scratch[c] = v[c]
    good, moved, _ = project(eq, ws, t, x, scratch, tol)
    prepare_rows(eq, ws, t, x, v)
    factor(eq, ws, x)
    aim, f, gamma, pull, h = matrix(ws, e.AIM), vector(ws, e.F), vector(ws, e.GAMMA), vector(ws, e.PULL), scratch
    for j in range(rows.size):
        aim[1, rows[j]] = rate[j]
    scale = 1e-300
    for c in range(v.size):
        scale = max(scale, abs(v[c]))
    for _turn in range(4):
        left = row_rate_gaps(eq, ws, x, v, aim, gamma)
        if left <= tol * scale:
            break
        for k in range(gamma.size):
            gamma[k] = -gamma[k]
        for c in range(f.size):
            f[c] = 0.0
            h[c] = 0.0
        solve(eq, ws, f, gamma, h, pull)
        for i in range(free.size):
            v[free[i]] += h[free[i]]
    return good, moved
