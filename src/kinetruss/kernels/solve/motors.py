"""Coordinates driven by motors: how accelerations and forces depend on those of them, and projection beside them.

A motor drives a length, an angle in the plane or a sum of terms (an angle about an axis). Its row of the equations is
scale times the gradient of the coordinate: 1 of a length, the length of the line of an angle in the plane.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2, I1, Record, record
from kinetruss.kernels.solve.accelerations import accelerate_smoothly, rub
from kinetruss.kernels.solve.kkt import factor, prepare_rows, project, row_rate_gaps, solve
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.structure import ANGLE, SUM
from kinetruss.kernels.structure.sums import sum_of
from kinetruss.kernels.structure.terms import term_along, term_gradient, term_value

__all__ = ["MotorPlaces", "MotorResponse", "motor_project", "motor_response"]


@record
class MotorResponse(Record):
    """How a structure answers to the accelerations of its motor-driven coordinates.

    rows (k,) of the equations; value, rate (k,) m, rad, of their coordinates, scale (k,) of their rows. a (3 n,), N (r,) where
    none of the coordinates accelerates; a unit of each adds da (k, 3 n), dN (k, r). Friction of bearings is no straight line
    over these accelerations: it is that of w (k,).
    """

    rows: I1
    value: F1
    rate: F1
    scale: F1
    w: F1
    a: F1
    N: F1
    da: F2
    dN: F2


@record
class MotorPlaces(Record):
    """Where motor-driven coordinates stand.

    rows (k,) of the equations. stuck (k,) : 1 of those that stand at `value` (k,), 0 of those that keep value and rate as they
    are; their value is found. rate (k,), scratch (3 n,) : scratch.
    """

    rows: I1
    stuck: I1
    value: F1
    rate: F1
    scratch: F1


@kernel_bare
def _summed(eq: Equations, ws: Workspace, j: int, x: F1, v: F1) -> tuple[float, float, float, float]:
    """The same of sum j; its row is evaluated with the rates as they are."""
    form, at, data, scratch = eq.term_form, eq.term_at, eq.term_data, ws.term_work
    ptr, value, rate = eq.sum_ptr, 0.0, 0.0
    # q and q' = J v of the sum
    for t in range(ptr[j], ptr[j + 1]):
        value += term_value(form, at, data, t, x)
        term_gradient(form, at, data, t, x, scratch)
        rate += term_along(at, t, scratch, v)
    return value, rate, eq.sum_scale[j], 0.0


@kernel_bare
def _coordinate(eq: Equations, ws: Workspace, k: int, x: F1, v: F1) -> tuple[float, float, float, float]:
    """Value (angles between jumps), rate and scale of the coordinate of row k, and the acceleration that the row lacks at rest.

    The rows are held at their present values, which lie within the constraint as they are; evaluated at rest, the right-hand
    side of a length lacks L'^2/L, that of an angle of a line of the length l lacks 2 w l'/l.
    """
    if eq.kind[k] == SUM:
        return _summed(eq, ws, sum_of(eq.sum_row, k), x, v)
    a, b = eq.A[k], eq.B[k]
    dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
    ex, ey, ez = v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]
    if eq.kind[k] == ANGLE:
        square = dx * dx + dy * dy
        rate, length = (dx * ey - dy * ex) / square, math.sqrt(square)
        return math.atan2(dy, dx), rate, length, 2.0 * rate * (dx * ex + dy * ey) / square
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    rate = (dx * ex + dy * ey + dz * ez) / length
    return length, rate, 1.0, rate * rate / length


@kernel
def motor_response(eq: Equations, ws: Workspace, user: int, t: float, x: F1, v: F1, one: MotorResponse) -> float:
    """Evaluate at t (s), x, v (3 n,). Returns the smallest scaled pivot."""
    prepare_rows(eq, ws, t, x, v)
    held, rows, value, rate, scale = eq.value, one.rows, one.value, one.rate, one.scale
    a, N, da, dN = one.a, one.N, one.da, one.dN
    # motor-driven coordinates held where they are
    for j in range(rows.size):
        value[j], rate[j], scale[j], _ = _coordinate(eq, ws, rows[j], x, v)
        held[rows[j]] = value[j]
    prepare_rows(eq, ws, t, x, v)
    pivot = factor(eq, ws, x)
    applied(eq, user, t, x, v, ws.f)
    accelerate_smoothly(eq, ws, x, v, a, N)
    f, gamma = ws.f, ws.gamma
    # response to a unit acceleration of each: M da + J^T dN = 0, J da = scale
    for j in range(rows.size):
        for c in range(f.size):
            f[c] = 0.0
            da[j, c] = 0.0
        for k in range(gamma.size):
            gamma[k] = 0.0
        gamma[rows[j]] = scale[j]
        solve(eq, ws, f, gamma, da[j], dN[j])
        _, _, _, lacking = _coordinate(eq, ws, rows[j], x, v)
        for c in range(f.size):
            a[c] += lacking * da[j, c]
        for k in range(gamma.size):
            N[k] += lacking * dN[j, k]
    if eq.bearing_ints.size:
        _move_by(one, 1.0)
        rub(eq, ws, t, x, v, a, N)
        _move_by(one, -1.0)
    return pivot


@kernel_bare
def _move_by(one: MotorResponse, share: float) -> None:
    """Add a share of what the accelerations w do."""
    for j in range(one.w.size):
        for c in range(one.a.size):
            one.a[c] += share * one.w[j] * one.da[j, c]
        for k in range(one.N.size):
            one.N[k] += share * one.w[j] * one.dN[j, k]


@kernel
def motor_project(eq: Equations, ws: Workspace, t: float, x: F1, v: F1, one: MotorPlaces, tol: float) -> tuple[bool, float]:
    """Bring x and v (3 n,) onto the constraints. Returns (converged, largest change of a coordinate, m)."""
    held, free, rows, stuck, value, rate, scratch = eq.value, eq.free, one.rows, one.stuck, one.value, one.rate, one.scratch
    prepare_rows(eq, ws, t, x, v)
    # targets: stuck ones at their value without rate, the others as they are
    for j in range(rows.size):
        now, rate[j], _, _ = _coordinate(eq, ws, rows[j], x, v)
        if stuck[j]:
            rate[j] = 0.0
        else:
            value[j] = now
        held[rows[j]] = value[j]
    # velocities are projected below, against these rates
    for c in range(v.size):
        scratch[c] = v[c]
    good, moved, _ = project(eq, ws, t, x, scratch, tol)
    prepare_rows(eq, ws, t, x, v)
    factor(eq, ws, x)
    target, f, gamma, N, h = ws.target, ws.f, ws.gamma, ws.multiplier, scratch
    # prescribed rates of the motor-driven coordinates
    for j in range(rows.size):
        target[1, rows[j]] = rate[j]
    largest = 1e-300
    # largest speed, the scale of Phi'
    for c in range(v.size):
        largest = larger(largest, abs(v[c]))
    # J v = prescribed rates, nearest in the norm of the mass
    for _turn in range(4):
        left = row_rate_gaps(eq, ws, x, v, target, gamma)
        if left <= tol * largest:
            break
        for k in range(gamma.size):
            gamma[k] = -gamma[k]
        for c in range(f.size):
            f[c] = 0.0
            h[c] = 0.0
        solve(eq, ws, f, gamma, h, N)
        for i in range(free.size):
            v[free[i]] += h[free[i]]
    return good, moved
