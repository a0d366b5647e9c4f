"""How a bar pulls by its length L and rate of length L': k (N/m), natural length l0 (m), damping c (N s/m).

Engineering strain: N = k (L - l0) + c L'. Green's strain: N = k (L^2 - l0^2)/(2 l0) L/l0 + c L', the work conjugate of
E = (L^2 - l0^2)/(2 l0^2) under a stress proportional to E. Cable: max(0, k (L - l0) + c L') where L > l0, else 0.
Codes of laws: `kernels.structure.plan`.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.structure.plan import CABLE, GREEN, NONE

__all__ = ["law_damping", "law_energy", "law_tangent", "pull", "pulls", "tangents"]


@kernel_inline
def pull(law, k, l0, c, L, Ld):  # type: ignore[no-untyped-def]
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
def law_energy(law, k, l0, L):  # type: ignore[no-untyped-def]
    """Strain energy of a bar, J: the integral of its undamped tension from l0 to L."""
    excess = L - l0
    if law == NONE or (law == CABLE and excess <= 0.0):
        return 0.0
    if law == GREEN:
        stretch = excess * (L + l0) / l0
        return 0.125 * k * stretch * stretch
    return 0.5 * k * excess * excess


@kernel_inline
def law_tangent(law, k, l0, c, L, Ld):  # type: ignore[no-untyped-def]
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
def law_damping(law, k, l0, c, L, Ld):  # type: ignore[no-untyped-def]
    """dN/dL', N s/m; 0 where a cable is slack."""
    excess = L - l0
    if law == NONE or (law == CABLE and (excess <= 0.0 or k * excess + c * Ld < 0.0)):
        return 0.0
    return c


@kernel
def pulls(law, k, l0, c, L, Ld, out):  # type: ignore[no-untyped-def]
    """Tension of all bars into out (times, members), N, from lengths and rates of the same shape; Ld (1, members) at rest."""
    still = Ld.shape[0] == 1
    for i in range(L.shape[0]):
        for m in range(law.size):
            out[i, m] = pull(law[m], k[m], l0[m], c[m], L[i, m], Ld[0 if still else i, m])


@kernel
def tangents(law, k, l0, L, out):  # type: ignore[no-untyped-def]
    """dN/dL of all bars at rest into out (times, members), N/m, from lengths (times, members)."""
    for i in range(L.shape[0]):
        for m in range(law.size):
            out[i, m] = law_tangent(law[m], k[m], l0[m], 0.0, L[i, m], 0.0)
