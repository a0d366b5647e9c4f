"""States within the last step: from the interpolant of DOP853 or of the implicit methods, or from a power series."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel_bare
from kinetruss.kernels.compiled.record import F1
from kinetruss.kernels.integrate.state import Memory
from kinetruss.kernels.steps.dop853 import interpolate, interpolate_rate

__all__ = ["rate_within", "state_within"]


@kernel_bare
def state_within(memory: Memory, s: float, out: F1) -> None:
    """State at the fraction s of the last step into out."""
    F = memory.dense
    if memory.series == 0:
        interpolate(F, s, out)
        return
    # Horner's scheme for the power series of the step: highest order,
    for i in range(out.size):
        out[i] = F[F.shape[0] - 1, i]
    # then the lower ones
    for j in range(F.shape[0] - 2, -1, -1):
        for i in range(out.size):
            out[i] = out[i] * s + F[j, i]


@kernel_bare
def rate_within(memory: Memory, s: float, h: float, out: F1) -> None:
    """Rate of the state at the fraction s of the last step, of h (s), into out."""
    F = memory.dense
    if memory.series == 0:
        interpolate_rate(F, s, h, out)
        return
    # derivative of the power series by its fraction:
    for i in range(out.size):
        out[i] = 0.0
    # Horner's scheme for sum_j j F_j s^(j-1)
    for j in range(F.shape[0] - 1, 0, -1):
        for i in range(out.size):
            out[i] = out[i] * s + j * F[j, i]
    # and in time
    for i in range(out.size):
        out[i] /= h
