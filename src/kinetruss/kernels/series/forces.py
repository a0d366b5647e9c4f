"""Orders in time of applied forces: bars with a law, given forces (parts: series.workspace; laws: structure.laws).

A force along d is q d. Lengths: L L = d . d; quotients: (N/L) L = N; of both the highest order stands alone.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.series.workspace import SeriesWork
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.plan import GREEN

__all__ = ["given_order", "law_lengths", "law_order"]


@kernel_bare
def law_lengths(eq: Equations, work: SeriesWork, j: int) -> None:
    """Order j of the differences and lengths of bars with a law; the places must be known to that order."""
    A, B, X = eq.law_A, eq.law_B, work.x
    D, W, L, axes, count = work.law_d, work.law_w, work.law_l, work.axes, A.size
    # D_j = order j of d = x_B - x_A
    for c in range(axes):
        for k in range(count):
            D[j, c * count + k] = X[j, B[k] + c] - X[j, A[k] + c]
    # W_j = order j of d . d = 2 sum_(i < j/2) D_i . D_(j-i), and D_(j/2) . D_(j/2) where j is even
    for k in range(count):
        W[j, k] = 0.0
    for i in range((j + 1) // 2):
        for c in range(axes):
            for k in range(count):
                W[j, k] += 2.0 * D[i, c * count + k] * D[j - i, c * count + k]
    if j % 2 == 0:
        for c in range(axes):
            for k in range(count):
                W[j, k] += D[j // 2, c * count + k] * D[j // 2, c * count + k]
    if j == 0:
        # order 0 of the length is the root of that of its square
        for k in range(count):
            L[0, k] = math.sqrt(W[0, k])
        return
    # L L = W: 2 L_0 L_j = W_j - sum_(0<i<j) L_i L_(j-i)
    for k in range(count):
        L[j, k] = W[j, k]
    # the inner products of the sum
    for i in range(1, j):
        for k in range(count):
            L[j, k] -= L[i, k] * L[j - i, k]
    # solved for L_j
    for k in range(count):
        L[j, k] *= 0.5 / L[0, k]


@kernel_bare
def _densities(eq: Equations, work: SeriesWork, j: int, s: float) -> None:
    """Order j of the force densities; the lengths must be known to the order j + 1."""
    kind, law = eq.law_kind, eq.law
    W, L, R, Q, count = work.law_w, work.law_l, work.law_r, work.law_q, kind.size
    # order j of N = k (L - l0) + c L'; of Green's law the density q itself is linear in W
    for k in range(count):
        stiffness, natural, damping = law[k, 0], law[k, 1], law[k, 2]
        R[j, k] = damping * (j + 1.0) * L[j + 1, k] / s
        Q[j, k] = 0.0
        if kind[k] == GREEN:
            Q[j, k] = 0.5 * stiffness * (W[j, k] / (natural * natural) - (1.0 if j == 0 else 0.0))
        else:
            R[j, k] += stiffness * (L[j, k] - (natural if j == 0 else 0.0))
    # quotient R = N/L: L_0 R_j = N_j - sum_(i>0) L_i R_(j-i)
    for i in range(1, j + 1):
        for k in range(count):
            R[j, k] -= L[i, k] * R[j - i, k]
    # q = N/L, and of Green's law its elastic part
    for k in range(count):
        R[j, k] /= L[0, k]
        Q[j, k] += R[j, k]


@kernel_bare
def law_order(eq: Equations, work: SeriesWork, j: int, s: float, f: F1) -> None:
    """f += order j of the tensions of bars with a law."""
    _densities(eq, work, j, s)
    A, B = eq.law_A, eq.law_B
    D, Q, sums, axes, count = work.law_d, work.law_q, work.sums[0], work.axes, A.size
    # order j of q d
    for m in range(axes * count):
        sums[m] = 0.0
    # Cauchy product: sum_i Q_i D_(j-i)
    for i in range(j + 1):
        for c in range(axes):
            at = c * count
            for k in range(count):
                sums[at + k] += Q[i, k] * D[j - i, at + k]
    # q d at A towards B, -q d at B
    for c in range(axes):
        for k in range(count):
            f[A[k] + c] += sums[c * count + k]
            f[B[k] + c] -= sums[c * count + k]


@kernel_bare
def _amount(time: F1, value: F1, first: int, last: int, t: float) -> tuple[float, float]:
    """Entry of a table just behind t, and its slope: linear between, held outside."""
    if last - first == 1 or t < time[first]:
        return value[first], 0.0
    # first interval of the table that ends behind t
    for k in range(first, last - 1):
        if t < time[k + 1]:
            slope = (value[k + 1] - value[k]) / (time[k + 1] - time[k])
            return value[k] + slope * (t - time[k]), slope
    return value[last - 1], 0.0


@kernel_bare
def _divisor(D: F2, W: F2, g: int, count: int, j: int, angle: bool) -> float:
    """Order j of what the force g is divided by: the square of the length (a torque), or the length."""
    total = 0.0
    # order j of d . d
    for i in range(j + 1):
        for c in range(3):
            total += D[i, c * count + g] * D[j - i, c * count + g]
    if angle:
        return total
    if j == 0:
        return math.sqrt(total)
    # square root: 2 L_0 L_j = W_j - sum_(0<i<j) L_i L_(j-i)
    for i in range(1, j):
        total -= W[i, g] * W[j - i, g]
    return 0.5 * total / W[0, g]


@kernel_bare
def given_order(eq: Equations, work: SeriesWork, t: float, s: float, j: int, f: F1) -> None:
    """f += order j of given forces; t (s) is where the series begins."""
    kind, A, B, ptr = eq.force_kind, eq.force_A, eq.force_B, eq.force_ptr
    X, D, W, Q, count = (
        work.x,
        work.force_d,
        work.force_w,
        work.force_q,
        kind.size,
    )
    # order j of F d/L of a thrust, of T n/L^2 of a torque, by quotient and product of series
    for g in range(count):
        value, slope = _amount(eq.force_time, eq.force_value, ptr[g], ptr[g + 1], t)
        amount = value if j == 0 else slope * s if j == 1 else 0.0
        a, b = A[g], B[g]
        if kind[g] == e.COORDINATE_FORCE:
            f[a] += amount
            continue
        angle = kind[g] == e.ANGLE_FORCE
        for c in range(3):
            D[j, c * count + g] = X[j, b + c] - X[j, a + c]
        W[j, g] = _divisor(D, W, g, count, j, angle)
        for i in range(1, j + 1):
            amount -= W[i, g] * Q[j - i, g]
        Q[j, g] = amount / W[0, g]
        px, py, pz = 0.0, 0.0, 0.0
        for i in range(j + 1):
            px += Q[i, g] * D[j - i, g]
            py += Q[i, g] * D[j - i, count + g]
            pz += Q[i, g] * D[j - i, 2 * count + g]
        if angle:
            px, py, pz = -py, px, 0.0
        f[a] -= px
        f[a + 1] -= py
        f[a + 2] -= pz
        f[b] += px
        f[b + 1] += py
        f[b + 2] += pz
