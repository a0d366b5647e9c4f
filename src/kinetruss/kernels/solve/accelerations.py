"""Accelerations and row forces under given forces, with the friction of bearings that follows from joint forces."""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel, kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Floats
from kinetruss.kernels.solve.kkt import factor, prepare_rows, row_along, solve_refined
from kinetruss.kernels.structure.applied import applied
from kinetruss.kernels.structure.bearings import (
    Bearings,
    JointLoads,
    couple_forces,
    friction_sizes,
    known_loads,
    linear_loads,
    rubbed_loads,
    settled,
)
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import between, mass_times
from kinetruss.kernels.structure.rows import row_second
from kinetruss.kernels.structure.sums import sum_gammas

of_bearings = Apart("eq.rubs[{}]")
"""Kernels of equations with friction of bearings."""


@kernel_inline
def row_gammas(eq: Equations, ws: Workspace, x: F1, v: F1, gamma: F1) -> None:
    """Right-hand sides of J a = gamma of all rows at x, v, with the gradients in ws."""
    kind, A, B, motion = eq.kind, eq.A, eq.B, eq.motion
    now, target, u = ws.now, ws.target, ws.u
    # gamma = (L'^2 + L L'' - |d'|^2)/L of a length, likewise of an angle
    for k in range(kind.size):
        a, b, d = A[k], B[k], motion[k]
        g, second = (u[0, k], u[1, k], u[2, k]), now[2, d] if d >= 0 else 0.0
        # g . d'' with d = x_B - x_A
        gamma[k] = row_second(kind[k], g, between(x, a, b), between(v, a, b), target[1, k], second, target[2, k])
    if eq.sum_row.size:
        sum_gammas(eq, ws, x, v, gamma)


@kernel_inline
def _take_prescribed(eq: Equations, ws: Workspace, x: F1, a: F1, f: F1, gamma: F1) -> None:
    """Set prescribed coordinates of a; take what they contribute to M a and J a off f and gamma."""
    now, held, held_motion = ws.now, eq.held, eq.held_motion
    # accelerations of free coordinates are unknown: zero
    for c in range(a.size):
        a[c] = 0.0
    if held.size == 0:
        return
    # prescribed accelerations
    for k in range(held.size):
        a[held[k]] = now[2, held_motion[k]]
    h, along = ws.h, ws.multiplier
    mass_times(eq, x, a, h)
    row_along(eq, ws, a, along)
    # f - M a of the prescribed part
    for c in range(a.size):
        f[c] -= h[c]
    # gamma - J a of the prescribed part
    for k in range(gamma.size):
        gamma[k] -= along[k]


@kernel_bare
def accelerate(eq: Equations, ws: Workspace, user: int, t: float, x: F1, v: F1, a: F1, N: F1) -> None:
    """`evaluate` with what `prepare_rows` and `factor`, or `project_near`, have left at these t, x."""
    applied(eq, user, t, x, v, ws.f)
    accelerate_under(eq, ws, t, x, v, a, N)


@kernel_bare
def accelerate_under(eq: Equations, ws: Workspace, t: float, x: F1, v: F1, a: F1, N: F1) -> None:
    """`accelerate` under the forces in ws.f."""
    accelerate_smoothly(eq, ws, x, v, a, N)
    if eq.bearing_ints.size:
        rub(eq, ws, t, x, v, a, N)


@kernel_inline
def accelerate_smoothly(eq: Equations, ws: Workspace, x: F1, v: F1, a: F1, N: F1) -> None:
    """`accelerate_under` without the friction of bearings."""
    f, gamma = ws.f, ws.gamma
    row_gammas(eq, ws, x, v, gamma)
    _take_prescribed(eq, ws, x, a, f, gamma)
    solve_refined(eq, ws, x, f, gamma, a, N)


# Friction of bearings follows from the joint forces of the same instant. They are linear in the couples: R = R_0 + sum c_j B_j,
# with R_0 from the solution without friction, and B_j from one more for a unit couple in each bearing.


@of_bearings(allocates=True)
def rub(eq: Equations, ws: Workspace, t: float, x: F1, v: F1, a: F1, N: F1) -> None:
    """Add what the friction of bearings changes to a (3 n,) and N (r,) without it; the couples into ws.couple (k,), N m.

    ws.jammed[0] : 1 + the bearing whose couple does not settle, else 0; a is then not a number.
    """
    b, p = Bearings(eq.bearing_ints, eq.bearing_reals), JointLoads(eq.pressed_ints, eq.pressed_reals)
    k, f, gamma, amount, scratch = b.arm.size, ws.f, ws.gamma, ws.couple, np.empty(24)
    most, way, base, change = np.empty(k), np.empty((k, 3)), np.zeros((k, 3)), np.zeros((k, k, 3))
    ws.jammed[0] = 0
    if friction_sizes(b, x, v, way, most) == 0.0:
        for j in range(k):
            amount[j] = 0.0
        return
    known_loads(eq, p, t, x, v, f, ws.g, scratch, base)
    linear_loads(eq, p, x, a, N, scratch, base)
    force, da, dN = np.zeros((b.node.size, 3)), np.zeros((k, a.size)), np.zeros((k, N.size))
    # M da + J^T dN = f of a unit couple, J da = 0
    for j in range(k):
        couple_forces(b, j, x, (way[j, 0], way[j, 1], way[j, 2]), force)
        for c in range(f.size):
            f[c] = 0.0
        for i in range(gamma.size):
            gamma[i] = 0.0
        for i in range(b.ptr[j], b.ptr[j + 1]):
            for c in range(3):
                f[b.node[i] + c] += force[i, c]
        solve_refined(eq, ws, x, f, gamma, da[j], dN[j])
        linear_loads(eq, p, x, da[j], dN[j], scratch, change[j])
        rubbed_loads(p, j, force, change[j])
    worst = settled(most, base, change, amount, np.empty(k))
    ws.jammed[0] = 1 + worst
    for j in range(k):
        share = amount[j] if worst < 0 else np.nan
        for c in range(a.size):
            a[c] += share * da[j, c]
        for i in range(N.size):
            N[i] += share * dN[j, i]


@of_bearings(allocates=True)
def add_friction(eq: Equations, ws: Workspace, t: float, x: F1, v: F1, f: F1) -> None:
    """Add the nodal forces of the friction of bearings to f (3 n,), all other forces, at the places of the factors at hand."""
    b, a, N = Bearings(eq.bearing_ints, eq.bearing_reals), np.empty(x.size), np.empty(eq.kind.size)
    for c in range(f.size):
        ws.f[c] = f[c]
    accelerate_under(eq, ws, t, x, v, a, N)
    most, way, force = np.empty(b.arm.size), np.empty((b.arm.size, 3)), np.zeros((b.node.size, 3))
    friction_sizes(b, x, v, way, most)
    for j in range(b.arm.size):
        size = ws.couple[j] if ws.jammed[0] == 0 else np.nan
        couple_forces(b, j, x, (size * way[j, 0], size * way[j, 1], size * way[j, 2]), force)
        for i in range(b.ptr[j], b.ptr[j + 1]):
            for k in range(3):
                f[b.node[i] + k] += force[i, k]


@kernel
def couples_along(eq: Equations, t: F1, x: F2, v: F2, a: F2, N: F2, out: Floats) -> None:
    """Couples (times, bearings, 3), N m, on the members of bearings at solved states x, v, a (times, 3 n), N (times, rows)."""
    b, p = Bearings(eq.bearing_ints, eq.bearing_reals), JointLoads(eq.pressed_ints, eq.pressed_reals)
    k, scratch, f, g = b.arm.size, np.empty(24), np.empty(x.shape[1]), np.empty(x.shape[1])
    most, way, amount, found, force = np.empty(k), np.empty((k, 3)), np.empty(k), np.empty(k), np.empty((b.node.size, 3))
    for i in range(t.size):
        friction_sizes(b, x[i], v[i], way, most)
        base, change = np.zeros((k, 3)), np.zeros((k, k, 3))
        known_loads(eq, p, t[i], x[i], v[i], f, g, scratch, base)
        linear_loads(eq, p, x[i], a[i], N[i], scratch, base)
        # what the couples do to the states is in these; the rest is what they do at the ends of members
        for j in range(k):
            couple_forces(b, j, x[i], (way[j, 0], way[j, 1], way[j, 2]), force)
            rubbed_loads(p, j, force, change[j])
        settled(most, base, change, amount, found)
        for j in range(k):
            for c in range(3):
                out[i, j, c] = amount[j] * way[j, c]


@kernel_bare
def evaluate(eq: Equations, ws: Workspace, user: int, t: float, x: F1, v: F1, a: F1, N: F1) -> float:
    """Accelerations a (3 n,) and row forces N (r,) at t, x, v; prescribed coordinates of x, v and a are set.

    Returns the smallest scaled pivot, as `factor`.
    """
    prepare_rows(eq, ws, t, x, v)
    pivot = factor(eq, ws, x)
    accelerate(eq, ws, user, t, x, v, a, N)
    return pivot
