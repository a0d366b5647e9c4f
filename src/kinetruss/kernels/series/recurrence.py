"""Power series in time of a motion: all orders from one factorisation.

With x = sum_j X_j tau^j, tau = (t - t0)/s, every order of M a + J^T N = f, J a = gamma has the matrix of the first one, and a
right-hand side of products of the orders before it: d . d = L^2 of a row between two nodes, q d of a force with the density
q = N/L. So a step of any order costs one factorisation, and one solution an order. M must be constant.

J. D. Pryce, Numerical Algorithms 19 (1998) 195-211 (series of the solution of differential-algebraic equations);
A. Jorba, M. Zou, Experimental Mathematics 14 (2005) 99-117 (orders of products, quotients and powers).
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.coordinates.tape import Tape
from kinetruss.kernels.series.measured import measured_order, sum_orders, take_multipliers, take_places
from kinetruss.kernels.series.orders import SeriesWork, given_order, law_lengths, law_order, motion_series, row_series
from kinetruss.kernels.solve.kkt import row_along, solve_refined
from kinetruss.kernels.structure.equations import Equations, Workspace
from kinetruss.kernels.structure.mass import mass_times
from kinetruss.kernels.structure.structure import LENGTH, SUM

__all__ = ["series"]


@kernel_bare
def _differences(eq: Equations, work: SeriesWork, j: int) -> None:
    """Order j of what lies between the ends of rows; it is the direction of those that hold a length."""
    A, B, X, D = eq.A, eq.B, work.x, work.d
    G, kind = work.g, eq.kind
    # D_j = order j of d = x_B - x_A, the gradient of a length
    for c in range(work.axes):
        at = c * A.size
        for k in range(A.size):
            D[j, at + k] = X[j, B[k] + c] - X[j, A[k] + c]
        for k in range(A.size if G.size else 0):
            if kind[k] == LENGTH:
                G[j, at + k] = D[j, at + k]


@kernel_bare
def _products(D: F2, G: F2, j: int, sums: F1) -> None:
    """Sum of G[i] D[j + 2 - i] over i = 1 to j + 1: the order j + 2 of G D without its two ends."""
    for m in range(D.shape[1]):
        sums[m] = 0.0
    # Cauchy product without the terms of order 0 and j + 2
    for i in range(1, j + 2):
        for m in range(D.shape[1]):
            sums[m] += G[i, m] * D[j + 2 - i, m]


@kernel_bare
def _squares(D: F2, j: int, sums: F1) -> None:
    """The same of D D, where all products but the middle one stand twice."""
    half = (j + 2) // 2
    # the middle product of an even order
    for m in range(D.shape[1]):
        sums[m] = D[half, m] * D[half, m] if j % 2 == 0 else 0.0
    # symmetric products count twice
    for i in range(1, (j + 3) // 2):
        for m in range(D.shape[1]):
            sums[m] += 2.0 * D[i, m] * D[j + 2 - i, m]


@kernel_bare
def _row_terms(eq: Equations, ws: Workspace, work: SeriesWork, j: int, rate: float, gamma: F1) -> None:
    """Order j of gamma in J a = gamma; rate : makes orders of x such of a, 1/s^2."""
    kind, motion, target, axes = eq.kind, eq.motion, ws.target, work.axes
    D, G, squares, sums, r = work.d, work.g, work.squares, work.sums[0], kind.size
    if G.size:
        _products(D, G, j, sums)
    else:
        _squares(D, j, sums)
    # d . d = L^2 (or n . d = 0) at order j + 2, solved for J a
    for k in range(r):
        if kind[k] == SUM:
            continue
        total = sums[k]
        for c in range(1, axes):
            total += sums[c * r + k]
        if kind[k] == LENGTH:
            wanted = squares[j + 2, k] if motion[k] >= 0 else 0.0
            gamma[k] = 0.5 * rate * (wanted - total) * target[2, k]
        else:
            gamma[k] = -rate * (total + G[j + 2, k] * D[0, k] + G[j + 2, r + k] * D[0, r + k])


@kernel_bare
def _row_forces(eq: Equations, work: SeriesWork, j: int, f: F1) -> None:
    """f += order j of the constraint forces -J^T N, by the force densities of lower orders."""
    A, B, Q, sums = eq.A, eq.B, work.q, work.sums[0]
    G, r, axes = work.g, A.size, work.axes
    if G.size == 0:
        G = work.d
    for m in range(axes * r):
        sums[m] = 0.0
    # Cauchy product Q_i G_(j-i) without the unknown Q_j
    for i in range(j):
        for c in range(axes):
            at = c * r
            for k in range(r):
                sums[at + k] += Q[i, k] * G[j - i, at + k]
    # -J^T N of the known orders: at A towards B, at B towards A
    for c in range(axes):
        at = c * r
        for k in range(r):
            f[A[k] + c] += sums[at + k]
            f[B[k] + c] -= sums[at + k]


@kernel_bare
def _take_prescribed(eq: Equations, ws: Workspace, work: SeriesWork, j: int, rate: float, f: F1, gamma: F1, a: F1) -> None:
    """Take what prescribed coordinates that move contribute to M a and J a at order j off f and gamma."""
    held, motion, X, now = eq.held, eq.held_motion, work.x, work.motions
    # accelerations of free coordinates are unknown: zero
    for c in range(a.size):
        a[c] = 0.0
    # order j of the accelerations of prescribed coordinates
    for k in range(held.size):
        X[j + 2, held[k]] = now[j + 2, motion[k]]
        a[held[k]] = rate * X[j + 2, held[k]]
    h, along = ws.h, ws.multiplier
    mass_times(eq, a, a, h)
    row_along(eq, ws, a, along)
    # f - M a of the prescribed part
    for c in range(a.size):
        f[c] -= h[c]
    # gamma - J a of the prescribed part
    for k in range(gamma.size):
        gamma[k] -= along[k]


@kernel_bare
def _begin(eq: Equations, ws: Workspace, tape: Tape, work: SeriesWork, t: float, s: float, x: F1, v: F1) -> None:
    """Orders 0 and 1 of places, differences, lengths; all orders of motions."""
    X = work.x
    # X_0 = x, X_1 = s v
    for c in range(x.size):
        X[0, c], X[1, c] = x[c], s * v[c]
    if eq.motion_kind.size:
        motion_series(eq, work, t, s)
    if work.squares.size + work.g.size:
        row_series(eq, ws, work)
    # orders 0 and 1 of d and of the lengths of bars with a law
    for j in range(2):
        _differences(eq, work, j)
        if eq.law_A.size:
            law_lengths(eq, work, j)
        if tape.op.size:
            take_places(tape, work, j)


@kernel_bare
def _forces(eq: Equations, tape: Tape, laws: F2, work: SeriesWork, t: float, s: float, j: int, f: F1) -> None:
    """Order j of all forces but the unknown part of the constraint forces, into f (3 n,)."""
    constant = eq.constant
    # constant forces have order 0 alone
    for c in range(f.size):
        f[c] = constant[c] if j == 0 else 0.0
    if eq.law_A.size:
        if j:
            law_lengths(eq, work, j + 1)
        law_order(eq, work, j, s, f)
    if eq.force_kind.size:
        given_order(eq, work, t, s, j, f)
    if tape.op.size:
        measured_order(eq, tape, laws, work, t, s, j, f)
    if j:
        _row_forces(eq, work, j, f)


@kernel_bare
def series(eq: Equations, ws: Workspace, tape: Tape, laws: F2, work: SeriesWork, t: float, s: float, x: F1, v: F1) -> None:
    """Orders of the motion through x (3 n,) with v at t (s) in the time scale s (s), into the arrays of `work`.

    Rows must be prepared for t and the matrix factored at x. tape, laws : of all sums (see series.measured). Equations with
    varying inertia, continua, followers, slack cables or user forces have other series.
    """
    X, Q, target, kind = work.x, work.q, ws.target, eq.kind
    f, gamma, a, N, free = ws.f, ws.gamma, ws.g, work.N, eq.free
    moved, measured = eq.held.size > 0, tape.op.size > 0
    _begin(eq, ws, tape, work, t, s, x, v)
    # order by order: right-hand side, one solution with the same factors, X_(j+2) = s^2 A_j/((j + 1)(j + 2))
    for j in range(X.shape[0] - 2):
        rate = (j + 1.0) * (j + 2.0) / (s * s)
        _forces(eq, tape, laws, work, t, s, j, f)
        _row_terms(eq, ws, work, j, rate, gamma)
        if measured:
            sum_orders(eq, tape, work, j, rate, gamma)
        if moved:
            _take_prescribed(eq, ws, work, j, rate, f, gamma, a)
        solve_refined(eq, ws, x, f, gamma, a, N)
        # the force of a sum is no density along a line
        for k in range(kind.size):
            Q[j, k] = 0.0 if kind[k] == SUM else N[k] * target[2, k]
        back = 1.0 / rate
        for i in range(free.size):
            X[j + 2, free[i]] = a[free[i]] * back
        _differences(eq, work, j + 2)
        if measured:
            take_multipliers(eq, work, j, N)
            take_places(tape, work, j + 2)
