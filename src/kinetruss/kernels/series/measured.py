"""Orders in time of sums of terms: what rows hold them to, and the forces of such rows, of elements and of torques on them.

A tape (kernels.coordinates.tape) has the values as results: of the rows that are sums, of all elements on coordinates, whose
laws are linear, of all given torques. Their orders are those of its operations, and one pass back
with the orders of all forces F_i as adjoints gives those of the nodal forces sum F_i dq_i/dx. Row j of an array is the order j
in tau = (t - t0)/s.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.calls import Apart
from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.coordinates.tape import Tape, backward_order, forward
from kinetruss.kernels.series.orders import SeriesWork, table_order
from kinetruss.kernels.structure.equations import SUM_FORCE, Equations
from kinetruss.kernels.structure.terms import nearest_turn

measured = Apart("tape.series[{}]")
"""Kernels of equations with such sums, by power series."""


@measured
def sum_orders(eq: Equations, tape: Tape, work: SeriesWork, j: int, rate: float, gamma: F1) -> None:
    """gamma of J a = gamma of the sums: order j + 2 of what is asked less what the orders of the places up to j + 1 make."""
    X, T, row, scale = work.x, work.tape, eq.sum_row, eq.sum_scale
    for c in range(X.shape[1]):
        X[j + 2, c] = 0.0
    forward(tape, X, X, j + 2, T)
    # scale (wanted_(j+2) - q_(j+2) of X_(j+2) = 0), as an acceleration
    for i in range(row.size):
        d = eq.motion[row[i]]
        wanted = work.motions[j + 2, d] if d >= 0 else 0.0
        gamma[row[i]] = rate * scale[i] * (wanted - T[j + 2, tape.out[i]])


@measured
def take_places(tape: Tape, work: SeriesWork, j: int) -> None:
    """Order j of all values, by the places."""
    forward(tape, work.x, work.x, j, work.tape)


@kernel_bare
def take_multipliers(eq: Equations, work: SeriesWork, j: int, N: F1) -> None:
    """Order j of what the rows push with, -scale N, by their multipliers."""
    for i in range(eq.sum_row.size):
        work.pushes[j, i] = -eq.sum_scale[i] * N[eq.sum_row[i]]


@kernel_bare
def _given(eq: Equations, tape: Tape, laws: F2, work: SeriesWork, t: float, s: float, j: int) -> None:
    """Order j of what elements and torques push with; that of rows is not known yet."""
    F, T, out, first = work.pushes, work.tape, tape.out, eq.sum_row.size
    for i in range(first):
        F[j, i] = 0.0
    # -(F_0 + k (q - rest) + c q')
    for k in range(laws.shape[0]):
        at = out[first + k]
        e, constant = T[j, at], 0.0
        if j == 0:
            e, constant = nearest_turn(e - laws[k, 0], laws[k, 1]), laws[k, 2]
        F[j, first + k] = -(constant + laws[k, 3] * e + laws[k, 4] * (j + 1.0) * T[j + 1, at] / s)
    i = first + laws.shape[0]
    for g in range(eq.force_kind.size):
        if eq.force_kind[g] == SUM_FORCE:
            F[j, i] = table_order(eq, g, t, s, j)
            i += 1


@measured
def measured_order(eq: Equations, tape: Tape, laws: F2, work: SeriesWork, t: float, s: float, j: int, f: F1) -> None:
    """f += order j of the nodal forces, without the part of the rows' unknown order j; t (s) is where the series begins.

    laws (k, 5) : `Control.tape_laws`.
    """
    B, out, g = work.adjoints, tape.out, work.sums[1]
    _given(eq, tape, laws, work, t, s, j)
    # order j - 1 once more, now that its multipliers are known
    for k in range(max(j - 1, 0), j + 1):
        for c in range(B.shape[1]):
            B[k, c] = 0.0
        for i in range(out.size):
            B[k, out[i]] += work.pushes[k, i]
        for c in range(f.size):
            g[c] = 0.0
        backward_order(tape, k, work.tape, B, work.quotients, g)
    for c in range(f.size):
        f[c] += g[c]
