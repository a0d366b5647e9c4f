"""Constitutive laws of bars.

Engineering strain: N = k (L - l0) + c L'. Green's strain: N = k (L^2 - l0^2)/(2 l0) L/l0 + c L', the work conjugate of
E = (L^2 - l0^2)/(2 l0^2) under a stress proportional to E. Cable: max(0, k (L - l0) + c L') where L > l0, else 0.
Codes of laws: `kernels.structure.structure`.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Floats, Ints, Vector
from kinetruss.kernels.structure.mass import direction
from kinetruss.kernels.structure.structure import CABLE, GREEN, NONE, Structure


@kernel_inline
def bar_tension(law: int, k: float, l0: float, c: float, L: float, Ld: float) -> float:
    """Tension N of a bar, N."""
    if law == NONE:
        return 0.0
    if law == GREEN:
        return 0.5 * k * (L - l0) * (L + l0) * L / (l0 * l0) + c * Ld
    excess = L - l0
    N = k * excess + c * Ld
    if law == CABLE and (excess <= 0.0 or N < 0.0):
        return 0.0
    return N


@kernel_inline
def law_energy(law: int, k: float, l0: float, L: float) -> float:
    """Strain energy of a bar, J: the integral of its undamped tension from l0 to L."""
    excess = L - l0
    if law == NONE or (law == CABLE and excess <= 0.0):
        return 0.0
    if law == GREEN:
        green = excess * (L + l0) / l0
        return 0.125 * k * green * green
    return 0.5 * k * excess * excess


@kernel_inline
def law_tangent(law: int, k: float, l0: float, c: float, L: float, Ld: float) -> float:
    """dN/dL, N/m; 0 where a cable is slack."""
    if law == NONE:
        return 0.0
    if law == GREEN:
        return 0.5 * k * (3.0 * L * L - l0 * l0) / (l0 * l0)
    excess = L - l0
    if law == CABLE and (excess <= 0.0 or k * excess + c * Ld < 0.0):
        return 0.0
    return k


@kernel_inline
def law_damping(law: int, k: float, l0: float, c: float, L: float, Ld: float) -> float:
    """dN/dL', N s/m; 0 where a cable is slack."""
    excess = L - l0
    if law == NONE or (law == CABLE and (excess <= 0.0 or k * excess + c * Ld < 0.0)):
        return 0.0
    return c


@kernel_inline
def length_rate(x: F1, v: F1, A: int, B: int) -> tuple[float, Vector, float]:
    """Length, direction and rate of length between the places A and B of x (3 n,)."""
    L, u = direction(x, A, B)
    return L, u, u[0] * (v[B] - v[A]) + u[1] * (v[B + 1] - v[A + 1]) + u[2] * (v[B + 2] - v[A + 2])


@kernel_inline
def law_tension(s: Structure, k: int, L: float, Ld: float) -> float:
    """Tension of the bar of law k at a length and its rate, N."""
    return bar_tension(s.law_kind[k], s.law[k, 0], s.law[k, 1], s.law[k, 2], L, Ld)


@kernel_inline
def law_slopes(s: Structure, k: int, L: float, Ld: float) -> tuple[float, float]:
    """dN/dL (N/m) and dN/dL' (N s/m) of the bar of law k."""
    kind, stiffness, natural, damping = s.law_kind[k], s.law[k, 0], s.law[k, 1], s.law[k, 2]
    return law_tangent(kind, stiffness, natural, damping, L, Ld), law_damping(kind, stiffness, natural, damping, L, Ld)


@kernel_inline
def law_energies(s: Structure, x: F1) -> float:
    """Energy stored in all bars with a law, J."""
    energy = 0.0
    # V(L) of each bar
    for k in range(s.law_A.size):
        energy += law_energy(s.law_kind[k], s.law[k, 0], s.law[k, 1], direction(x, s.law_A[k], s.law_B[k])[0])
    return energy


@kernel_inline
def add_law_forces(s: Structure, x: F1, v: F1, f: F1) -> None:
    """Add to f the tensions of bars with a law."""
    # N u at A, -N u at B
    for k in range(s.law_A.size):
        A, B = s.law_A[k], s.law_B[k]
        L, u, Ld = length_rate(x, v, A, B)
        N = law_tension(s, k, L, Ld)
        for c in range(3):
            f[A + c] += N * u[c]
            f[B + c] -= N * u[c]


@kernel_bare
def law_values(kind: Ints, k: F1, l0: F1, c: F1, L: F2, Ld: F2, out: Floats) -> None:
    """Tension (N), dN/dL (N/m), dN/dL' (N s/m) and strain energy (J) of bars into out (4, times, bars).

    kind, k, l0, c (bars,) : of their laws. L (times, bars), m; Ld the same, m/s, or one row for all times.
    """
    # N, dN/dL, dN/dL', V of each bar at each sample
    for i in range(L.shape[0]):
        for m in range(kind.size):
            rate = Ld[min(i, Ld.shape[0] - 1), m]
            out[0, i, m] = bar_tension(kind[m], k[m], l0[m], c[m], L[i, m], rate)
            out[1, i, m] = law_tangent(kind[m], k[m], l0[m], c[m], L[i, m], rate)
            out[2, i, m] = law_damping(kind[m], k[m], l0[m], c[m], L[i, m], rate)
            out[3, i, m] = law_energy(kind[m], k[m], l0[m], L[i, m])
