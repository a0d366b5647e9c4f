"""Equations of motion, one interface over three solvers: factor, solve, evaluate, project; energies and momenta.

What holds redundant rows together is the same everywhere: sum w N^2 is least.
"""

from __future__ import annotations

import math

from kinetruss.kernels._applied import applied, law_energies
from kinetruss.kernels._jit import kernel, kernel_inner
from kinetruss.kernels._kkt_dense import dense_factor, dense_solve
from kinetruss.kernels._mass import mass_times, momenta_of
from kinetruss.kernels._motions import motions
from kinetruss.kernels._rows import aims, along_rows, gradients, position_residuals, second_terms, velocity_residuals

__all__ = ["evaluate", "factor", "kinetic", "momenta", "potential", "prepare_rows", "project", "solve"]


@kernel
def prepare_rows(eq, ws, t, x, v):  # type: ignore[no-untyped-def]
    """What drives, supports and rows are held to at t, into ws.now and ws.aim; prescribed coordinates of x and v are set."""
    motions(eq.motion_kind, eq.motion_data, eq.motion_ptr, eq.piece_start, eq.piece, t, ws.now)
    aims(eq.kind, eq.motion, eq.value, ws.now, ws.aim)
    for k in range(eq.held.size):
        x[eq.held[k]] = ws.now[0, eq.held_motion[k]]
        v[eq.held[k]] = ws.now[1, eq.held_motion[k]]


@kernel
def factor(eq, ws, x):  # type: ignore[no-untyped-def]
    """Factor the matrix at x, for the lengths and angles of the last `prepare_rows`; gradients into ws.u.

    Returns the smallest scaled pivot: about the sine of the angle between the most dependent row and the others, 0 where rows
    that are independent at the start become dependent. Redundant rows do not count.
    """
    gradients(eq.kind, eq.A, eq.B, x, ws.aim, ws.u)
    return dense_factor(
        eq.setup[1], eq.dense[0], eq.local, eq.A, eq.B, eq.mass_A, eq.mass_B, eq.mass, eq.lump, eq.var_A, eq.var_B, eq.var,
        eq.dense_pair, eq.spare, x, ws.u, eq.free.size, ws.D, ws.W, ws.S, ws.diagonal, ws.dropped,
    )  # fmt: skip


@kernel
def solve(eq, ws, f, gamma, a, N):  # type: ignore[no-untyped-def]
    """Solve M a + J^T N = f, J a = gamma with the factors of the last `factor`.

    f, a : (3 n,) over all coordinates, gamma, N : (r,). Prescribed coordinates of a are given (zero unless they move) and kept.
    """
    dense_solve(
        eq.setup[1], eq.dense[0], eq.free, eq.local, eq.A, eq.B, eq.weight, eq.dense_inverse, ws.u, eq.free.size, f, gamma,
        ws.D, ws.S, ws.diagonal, ws.dropped, ws.y, ws.b, ws.rhs, N, a, ws.states, ws.matrix, ws.order, ws.z,
    )  # fmt: skip


@kernel_inner
def _carry(eq, ws, x, a):  # type: ignore[no-untyped-def]
    """Prescribed coordinates that accelerate: their part of M a and J a, taken from ws.f and ws.gamma."""
    for c in range(a.size):
        a[c] = 0.0
    for k in range(eq.held.size):
        a[eq.held[k]] = ws.now[2, eq.held_motion[k]]
    mass_times(eq.mass_A, eq.mass_B, eq.mass, eq.lump, eq.var_A, eq.var_B, eq.var, x, a, ws.h)
    along_rows(eq.A, eq.B, ws.u, a, ws.pull)
    for c in range(a.size):
        ws.f[c] -= ws.h[c]
    for k in range(eq.A.size):
        ws.gamma[k] -= ws.pull[k]


@kernel
def evaluate(eq, ws, user, t, x, v, a, N):  # type: ignore[no-untyped-def]
    """Accelerations a (3 n,) and row forces N (r,) at t, x, v; prescribed coordinates of x, v and a are set.

    Returns the smallest scaled pivot, as `factor`.
    """
    prepare_rows(eq, ws, t, x, v)
    applied(eq, user, t, x, v, ws.f)
    pivot = factor(eq, ws, x)
    second_terms(eq.kind, eq.A, eq.B, eq.motion, ws.now, x, v, ws.aim, ws.u, ws.gamma)
    if eq.held.size:
        _carry(eq, ws, x, a)
    else:
        for c in range(a.size):
            a[c] = 0.0
    solve(eq, ws, ws.f, ws.gamma, a, N)
    return pivot


@kernel
def project(eq, ws, t, x, v, tol):  # type: ignore[no-untyped-def]
    """Bring x and v onto the rows at t, nearest in the norm of the mass; prescribed coordinates are set.

    Newton's method with the matrix at hand: M d + J^T N = 0, J d = -residual. tol : share of a length, and of the largest
    speed. Returns (settled, largest change of a coordinate (m), of a velocity (m/s)).
    """
    prepare_rows(eq, ws, t, x, v)
    for c in range(x.size):
        ws.g[c] = 0.0
    moved, fresh = 0.0, False
    left = position_residuals(eq.kind, eq.A, eq.B, x, ws.aim, ws.gamma)
    for turn in range(12):
        if left <= tol:
            break
        if turn == 0 or not left <= 1e-4:
            factor(eq, ws, x)
            fresh = True
        moved += _correct(eq, ws, x)
        before = left
        left = position_residuals(eq.kind, eq.A, eq.B, x, ws.aim, ws.gamma)
        if not left <= 0.1 * before and turn > 0:
            factor(eq, ws, x)
    if not left <= tol:
        return False, moved, 0.0
    if fresh:
        gradients(eq.kind, eq.A, eq.B, x, ws.aim, ws.u)
    else:
        factor(eq, ws, x)
    turned, scale = 0.0, 1e-300
    for c in range(v.size):
        scale = max(scale, abs(v[c]))
    for turn in range(6):
        left = velocity_residuals(eq.kind, eq.A, eq.B, x, v, ws.aim, ws.u, ws.gamma)
        if left <= tol * scale:
            return True, moved, turned
        if turn == 2:
            factor(eq, ws, x)
        turned += _correct(eq, ws, v)
    return left <= 10.0 * tol * scale, moved, turned


@kernel_inner
def _correct(eq, ws, y):  # type: ignore[no-untyped-def]
    """y += d with M d + J^T N = 0, J d = -ws.gamma; returns the largest change."""
    for k in range(eq.A.size):
        ws.gamma[k] = -ws.gamma[k]
    for c in range(y.size):
        ws.h[c] = 0.0
    solve(eq, ws, ws.g, ws.gamma, ws.h, ws.pull)
    largest = 0.0
    for i in range(eq.free.size):
        c = eq.free[i]
        y[c] += ws.h[c]
        if not abs(ws.h[c]) <= largest:
            largest = abs(ws.h[c])
    return largest


@kernel
def kinetic(eq, ws, x, v):  # type: ignore[no-untyped-def]
    """Kinetic energy, J."""
    mass_times(eq.mass_A, eq.mass_B, eq.mass, eq.lump, eq.var_A, eq.var_B, eq.var, x, v, ws.h)
    energy = 0.0
    for c in range(v.size):
        energy += 0.5 * v[c] * ws.h[c]
    return energy


@kernel
def potential(eq, x):  # type: ignore[no-untyped-def]
    """Energy of weights and of bars with a law, J; given forces have none."""
    energy = law_energies(eq.law_A, eq.law_B, eq.law_kind, eq.law, x)
    for c in range(x.size):
        energy -= eq.constant[c] * x[c]
    for j in range(eq.var_A.size):
        a, b = eq.var_A[j], eq.var_B[j]
        dx, dy, dz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
        across = (eq.var[j, 2] - eq.var[j, 3]) / math.sqrt(dx * dx + dy * dy + dz * dz)
        for c, d in ((0, dx), (1, dy), (2, dz)):
            energy -= eq.gravity[c] * (eq.var[j, 0] * x[a + c] + eq.var[j, 1] * x[b + c] + across * d)
    return energy


@kernel
def momenta(eq, ws, x, v, out):  # type: ignore[no-untyped-def]
    """Linear momentum (kg m/s) and angular momentum about the origin (kg m^2/s) into out (6,)."""
    mass_times(eq.mass_A, eq.mass_B, eq.mass, eq.lump, eq.var_A, eq.var_B, eq.var, x, v, ws.h)
    momenta_of(x, ws.h, out)
