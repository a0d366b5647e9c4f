"""[[M + beta K + gamma C, J^T], [J, -delta]] = L D L^T for the implicit methods, K with the stiffness of forces in bars.

K, C : dN/dL u u^T of bars with a law, N/L (1 - u u^T) of all that carry a force, dN/dL' u u^T of dampers; those of all other
elements (structure.element_table). The pattern is found once (mechanics.sparse_plan); delta is small: what it spoils, the next
iteration of Newton's method mends; so it does the curvature of sums, left out.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2, I1, I2
from kinetruss.kernels.integrate.state import Control
from kinetruss.kernels.solve.ldl import ldl_factor, ldl_solve
from kinetruss.kernels.structure.element_table import element_tangents
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.laws import law_slopes, law_tension, length_rate
from kinetruss.kernels.structure.structure import LENGTH, Structure
from kinetruss.kernels.structure.sums import sum_entries


@kernel_bare
def _add_block(at: I2, k: int, value: F1, ux: float, uy: float, uz: float, s: float, r: float) -> None:
    """Add s 1 + r u u^T at both ends of a member, its negative between them; at (members, 36) places."""
    # lower triangle of [[K, -K], [-K, K]], K = s 1 + r u u^T
    for i in range(6):
        for j in range(i + 1):
            c, d = i % 3, j % 3
            uc = ux if c == 0 else (uy if c == 1 else uz)
            ud = ux if d == 0 else (uy if d == 1 else uz)
            entry = r * uc * ud + (s if c == d else 0.0)
            value[at[k, 6 * i + j]] += entry if (i < 3) == (j < 3) else -entry


@kernel_bare
def _add_laws(s: Structure, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    # beta K + gamma C of each bar with a law: dN/dL u u^T, N/L (1 - u u^T), dN/dL' u u^T
    for k in range(s.law_A.size):
        L, (ux, uy, uz), Ld = length_rate(x, v, s.law_A[k], s.law_B[k])
        stiffness, damping = law_slopes(s, k, L, Ld)
        # compression softens sideways; left out, it costs iterations but keeps the matrix definite
        across = beta * max(0.0, law_tension(s, k, L, Ld) / L)
        _add_block(at, k, value, ux, uy, uz, across, beta * stiffness + gamma * damping - across)


@kernel_bare
def _add_rows(kind: I1, u: F2, target: F2, N: F1, at: I2, gradient_at: I2, beta: float, value: F1) -> None:
    # J, and the geometric stiffness N/L of bars under tension
    for k in range(kind.size):
        for c in range(3):
            value[gradient_at[k, c]] = -u[c, k]
            value[gradient_at[k, 3 + c]] = u[c, k]
        if kind[k] == LENGTH and N[k] > 0.0:
            _add_block(at, k, value, u[0, k], u[1, k], u[2, k], beta * N[k] * target[2, k], 0.0)


@kernel_bare
def tangent_fill(
    eq: Equations, ws: Workspace, record: Control, x: F1, v: F1, N: F1, weights: tuple[float, float], value: F1
) -> None:
    """Assemble at x, v with the row forces N and the gradients in ws into value; `record` holds the pattern.

    weights : beta of the stiffness and gamma of the damping.
    """
    (beta, gamma), base = weights, record.base
    # M and -delta, which do not depend on x
    for i in range(base.size):
        value[i] = base[i]
    _add_laws(eq, record.law_at, x, v, beta, gamma, value)
    element_tangents(eq, record.element_at, record.element_ptr, x, v, beta, gamma, value)
    _add_rows(eq.kind, ws.u, ws.target, N, record.row_at, record.gradient_at, beta, value)
    if eq.sum_row.size:
        sum_entries(ws, record.sum_at, value)


@kernel_bare
def tangent_factor(eq: Equations, ws: Workspace, record: Control, x: F1, v: F1, N: F1, beta: float, gamma: float) -> None:
    """Assemble and factor in the values of `record`."""
    tangent_fill(eq, ws, record, x, v, N, (beta, gamma), record.values)
    ldl_factor(record.ptr, record.below, record.target, record.values)


@kernel_bare
def tangent_solve(eq: Equations, record: Control, f: F1, g: F1, a: F1, N: F1) -> None:
    """Solve for changes a (3 n,) of free coordinates and N (rows,) with the residuals f (3 n,) and g (rows,)."""
    place, row_place, free, b = record.place, record.row_place, eq.free, record.space
    # residual of the equations of motion, in the order of elimination
    for i in range(free.size):
        b[place[i]] = f[free[i]]
    # residual of the constraints
    for k in range(row_place.size):
        b[row_place[k]] = g[k]
    ldl_solve(record.ptr, record.below, record.target, record.values, b)
    # da of the free coordinates
    for i in range(free.size):
        a[free[i]] = b[place[i]]
    # dN of the constraints
    for k in range(row_place.size):
        N[k] = b[row_place[k]]
