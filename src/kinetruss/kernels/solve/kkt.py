"""Equations of motion, one interface over three solvers: rows, factor, solve, project; energies and momenta."""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.calls import Interface
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.larger import larger
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.structure.element_table import element_energies
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import law_energies
from kinetruss.kernels.structure.mass import direction, mass_times, momenta_of
from kinetruss.kernels.structure.rows import (
    add_row_forces,
    along_rows,
    gradients,
    motions,
    position_residuals,
    targets,
    velocity_residuals,
)
from kinetruss.kernels.structure.sums import add_sum_forces, sum_along, sum_gaps, sum_gradients, sum_rate_gaps


@Interface
def factor_of_solver(eq: Equations, ws: Workspace, x: F1) -> float:
    """Factor at x with the gradients in ws. Returns the smallest scaled pivot."""
    raise NotImplementedError  # never called: a declaration, of which Interface reads the annotations


@Interface
def solve_of_solver(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve M a + J^T N = f, J a = gamma with these factors; only free coordinates of a are written."""


_factor, _solve = factor_of_solver.call, solve_of_solver.call


@kernel_bare
def call_factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """`factor` of the solver at hand."""
    return _factor(eq.factor_at, (eq, ws, x))


@kernel_bare
def call_solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """`solve` with the factors at hand."""
    _solve(eq.solve_at, (eq, ws, f, gamma, a, N))


# What holds redundant rows together is the same everywhere: sum w N^2 is least.

FRESH = 1e-6
"""Error of a length, as a share of it, that factors of positions near by may take away."""
LOW = 1e-2
"""Scaled pivot p below which solutions are refined: those of a Schur complement lose 1/p^2 of the digits."""
PASSING = 0.1
"""The same in parts of the largest pivot along the motion: below it the motion passes a singular position. A series then goes
through the pole that round-off of the positions makes there (steps.taylor_step) the better the less it heeds it."""
TURNS, SHRINK = 60, 0.9
"""Most rounds, and the largest ratio of a correction to the one before it with which they go on."""
ROUND_OFF = 4 * 2.2e-16


@kernel_inline
def _prepare(eq: Equations, ws: Workspace, t: float, x: F1, v: F1) -> None:
    now, held, held_motion = ws.now, eq.held, eq.held_motion
    kind = eq.motion_kind
    if kind.size:
        data, ptr = eq.motion_data, eq.motion_ptr
        motions(kind, data, ptr, eq.piece_start, eq.piece, t, now)
    targets(eq.kind, eq.motion, eq.value, now, ws.target)
    # x and v of prescribed coordinates
    for k in range(held.size):
        x[held[k]] = now[0, held_motion[k]]
        v[held[k]] = now[1, held_motion[k]]


@kernel_bare
def prepare_rows(eq: Equations, ws: Workspace, t: float, x: F1, v: F1) -> None:
    """What drives, supports and rows are held to at t, into ws.now and ws.target; prescribed coordinates of x and v are set."""
    _prepare(eq, ws, t, x, v)


@kernel_inline
def _gradients(eq: Equations, ws: Workspace, x: F1) -> None:
    gradients(eq.kind, eq.A, eq.B, x, ws.target, ws.u)
    if eq.sum_row.size:
        sum_gradients(eq, ws, x)


@kernel_bare
def row_gradients(eq: Equations, ws: Workspace, x: F1) -> None:
    """Gradients of all rows at x into ws."""
    _gradients(eq, ws, x)


@kernel_bare
def row_along(eq: Equations, ws: Workspace, y: F1, out: F1) -> None:
    """J y into out (r,), with the gradients in ws."""
    along_rows(eq.A, eq.B, ws.u, y, out)
    if eq.sum_row.size:
        sum_along(eq, ws, y, out)


@kernel_bare
def add_constraint_forces(eq: Equations, ws: Workspace, N: F1, f: F1) -> None:
    """f -= J^T N, with the gradients in ws."""
    add_row_forces(eq.A, eq.B, ws.u, N, f)
    if eq.sum_row.size:
        add_sum_forces(eq, ws, N, f)


@kernel_bare
def row_gaps(eq: Equations, x: F1, target: F2, out: F1) -> float:
    """Residuals of all rows (m) at x into out (r,); returns the largest share of a length."""
    left = position_residuals(eq.kind, eq.A, eq.B, x, target, out)
    return sum_gaps(eq, x, target, out, left) if eq.sum_row.size else left


@kernel_bare
def row_rate_gaps(eq: Equations, ws: Workspace, x: F1, v: F1, target: F2, out: F1) -> float:
    """J v minus the wanted rates (m/s) of all rows into out (r,), with the gradients in ws; returns the largest."""
    kind, A, B = eq.kind, eq.A, eq.B
    left = velocity_residuals(kind, A, B, x, v, target, ws.u, out)
    return sum_rate_gaps(eq, ws, v, target, out, left) if eq.sum_row.size else left


@kernel_bare
def factor(eq: Equations, ws: Workspace, x: F1) -> float:
    """Factor the matrix at x, for the lengths and angles of the last `prepare_rows`; gradients into ws.u.

    Returns the smallest scaled pivot: about the sine of the angle between the most dependent row and the others, 0 where rows
    that are independent at the start become dependent. Redundant rows do not count.
    """
    _gradients(eq, ws, x)
    pivot = call_factor(eq, ws, x)
    ws.pivot[0] = pivot
    return pivot


@kernel_bare
def solve(eq: Equations, ws: Workspace, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve M a + J^T N = f, J a = gamma with the factors of the last `factor`.

    f, a : (3 n,) over all coordinates, gamma, N : (r,). Only free coordinates of f are read and of a written: what prescribed
    ones that move contribute to M a and J a is taken off f and gamma before.
    """
    call_solve(eq, ws, f, gamma, a, N)


@kernel
def _refine(eq: Equations, ws: Workspace, x: F1, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """Solve for what a solution leaves of its equations, until that is round-off (Higham 2002, ch. 12)."""
    free = eq.free
    own, step, force = np.zeros(x.size), np.zeros(x.size), np.empty(x.size)
    rows, more, before = np.empty(N.size), np.empty(N.size), 0.0
    # largest row force
    for k in range(N.size):
        before = larger(before, abs(N[k]))
    least = ROUND_OFF * before
    # a += d, N += n with M d + J^T n = f - M a - J^T N, J d = gamma - J a
    for _ in range(TURNS):
        for i in range(free.size):
            own[free[i]] = a[free[i]]
        mass_times(eq, x, own, force)
        for c in range(x.size):
            force[c] = f[c] - force[c]
        add_constraint_forces(eq, ws, N, force)
        row_along(eq, ws, own, rows)
        for k in range(N.size):
            rows[k] = gamma[k] - rows[k]
        call_solve(eq, ws, force, rows, step, more)
        size = 0.0
        for k in range(N.size):
            size = larger(size, abs(more[k]))
        if not least < size < SHRINK * before:
            break
        for i in range(free.size):
            a[free[i]] += step[free[i]]
        for k in range(N.size):
            N[k] += more[k]
        before = size


@kernel_inline
def solve_refined(eq: Equations, ws: Workspace, x: F1, f: F1, gamma: F1, a: F1, N: F1) -> None:
    """`solve` to the last digits also where all positions are nearly singular; x (3 n,) : where the matrix was factored."""
    call_solve(eq, ws, f, gamma, a, N)
    if ws.pivot[0] < LOW and ws.pivot[0] >= PASSING * ws.pivot[1]:
        _refine(eq, ws, x, f, gamma, a, N)


@kernel_inline
def _correct(eq: Equations, ws: Workspace, gamma: F1, y: F1) -> float:
    """y += d with M d + J^T N = 0, J d = -gamma; returns the largest change."""
    g, h, free = ws.g, ws.h, eq.free
    # right-hand side -Phi
    for k in range(gamma.size):
        gamma[k] = -gamma[k]
    call_solve(eq, ws, g, gamma, h, ws.multiplier)
    largest = 0.0
    # Newton's correction of the free coordinates
    for i in range(free.size):
        c = free[i]
        y[c] += h[c]
        largest = larger(largest, abs(h[c]))
    return largest


@kernel_bare
def project_near(
    eq: Equations, ws: Workspace, t: float, x: F1, v: F1, tol: float, near: bool
) -> tuple[bool, float, float, float]:
    """`project`, which with `near` begins with the factors at hand, of positions that are nearly these.

    Returns (converged, largest change of a coordinate (m), of a velocity (m/s), pivot of the factors): these are then of the
    new positions; -1 where they are not.
    """
    _prepare(eq, ws, t, x, v)
    target = ws.target
    gamma, g = ws.gamma, ws.g
    # no force drives the projection: f = 0
    for c in range(x.size):
        g[c] = 0.0
    moved, turned, again = 0.0, 0.0, 0.0
    left = row_gaps(eq, x, target, gamma)
    # Newton's method for Phi(x) = 0; new factors where those at hand converge slowly
    for turn in range(20):
        if left <= tol:
            break
        if (turn == 0 and not near) or left > FRESH or again > 0.1:
            factor(eq, ws, x)
        moved += _correct(eq, ws, gamma, x)
        before = left
        left = row_gaps(eq, x, target, gamma)
        again = left / before
        if turn > 3 and left <= 10.0 * tol and again > 0.5:
            break
    if not left <= 10.0 * tol:
        return False, moved, turned, -1.0
    pivot = factor(eq, ws, x)
    scale = 1e-300
    # largest speed of a coordinate,
    for c in range(v.size):
        scale = larger(scale, abs(v[c]))
    # or prescribed rate, as the scale of Phi'
    for k in range(gamma.size):
        scale = larger(scale, abs(target[1, k]))
    # J v = prescribed rates: linear, repeated against round-off
    for _ in range(8):
        left = row_rate_gaps(eq, ws, x, v, target, gamma)
        if left <= tol * scale:
            return True, moved, turned, pivot
        turned += _correct(eq, ws, gamma, v)
    return left <= 10.0 * tol * scale, moved, turned, pivot


@kernel_bare
def project(eq: Equations, ws: Workspace, t: float, x: F1, v: F1, tol: float) -> tuple[bool, float, float]:
    """Bring x and v onto the rows at t, nearest in the norm of the mass; prescribed coordinates are set.

    Newton's method with the matrix at hand: M d + J^T N = 0, J d = -residual. tol : share of a length, and of the largest
    speed given. Returns (converged, largest change of a coordinate (m), of a velocity (m/s)).
    """
    good, moved, turned, _ = project_near(eq, ws, t, x, v, tol, False)
    return good, moved, turned


@kernel_bare
def kinetic(eq: Equations, ws: Workspace, x: F1, v: F1) -> float:
    """Kinetic energy, J."""
    h = ws.h
    mass_times(eq, x, v, h)
    energy = 0.0
    # T = v^T M v/2
    for c in range(v.size):
        energy += 0.5 * v[c] * h[c]
    return energy


@kernel_bare
def potential(eq: Equations, x: F1) -> float:
    """Energy of weights, of bars with a law and of all elements, J; given forces have none."""
    energy = law_energies(eq, x)
    energy += element_energies(eq, x)
    # -f_0 . x of weights and constant forces
    for c in range(x.size):
        energy -= eq.constant[c] * x[c]
    # weight of members of varying inertia: -g . (first moment of mass)
    for j in range(eq.varying_A.size):
        A, B, varying = eq.varying_A[j], eq.varying_B[j], eq.varying
        _, u = direction(x, A, B)
        for c in range(3):
            energy -= eq.gravity[c] * (
                varying[j, 0] * x[A + c] + varying[j, 1] * x[B + c] + (varying[j, 2] - varying[j, 3]) * u[c]
            )
    return energy


@kernel_bare
def momenta(eq: Equations, ws: Workspace, x: F1, v: F1, out: F1) -> None:
    """Linear momentum (kg m/s) and angular momentum about the origin (kg m^2/s) into out (6,)."""
    h = ws.h
    mass_times(eq, x, v, h)
    momenta_of(x, h, out)


# Energies and momenta of the samples of a simulation.


@kernel
def balance(eq: Equations, ws: Workspace, x: F2, v: F2, out: F2) -> None:
    """Kinetic and potential energy (J), momentum (kg m/s), its moment about the origin (kg m^2/s) into out (samples, 8).

    x, v (samples, 3 n).
    """
    # T, V, p and the angular momentum of each sample
    for i in range(x.shape[0]):
        out[i, 0] = kinetic(eq, ws, x[i], v[i])
        out[i, 1] = potential(eq, x[i])
        momenta(eq, ws, x[i], v[i], out[i, 2:])
