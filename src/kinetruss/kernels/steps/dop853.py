"""Algebra of one step of DOP853: stages, error, dense output, size of the next step. Nothing here knows any equation.

Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I, 2nd ed., sections II.4 to II.6.
"""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel_bare, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2
from kinetruss.kernels.steps.dop853_table import COL, E3, E5, PTR, VAL, D

__all__ = ["dense_coefficients", "error_norm", "interpolate", "interpolate_rate", "next_step", "stage_state", "stiffness"]

SAFETY, SHRINK, GROW = 0.9, 0.333, 6.0
MEMORY = 0.03
"""Exponent of the last error in the step control (a PI controller, II.4 eq. 4.44): less see-saw, a little smaller steps."""


@kernel_bare
def stage_state(y: F1, K: F2, s: int, h: float, out: F1) -> None:
    """State of stage s: out = y + h sum_j a_sj K[j]. The increment is summed before it is added: one rounding of y."""
    first, last, whole = PTR[s], PTR[s + 1], y.size - y.size % 4
    # four components side by side
    for i in range(0, whole, 4):
        p, q, r, t = 0.0, 0.0, 0.0, 0.0
        for e in range(first, last):
            w, j = VAL[e], COL[e]
            p += w * K[j, i]
            q += w * K[j, i + 1]
            r += w * K[j, i + 2]
            t += w * K[j, i + 3]
        out[i] = y[i] + h * p
        out[i + 1] = y[i + 1] + h * q
        out[i + 2] = y[i + 2] + h * r
        out[i + 3] = y[i + 3] + h * t
    # and the last ones
    for i in range(whole, y.size):
        p = 0.0
        for e in range(first, last):
            p += VAL[e] * K[COL[e], i]
        out[i] = y[i] + h * p


@kernel_bare
def error_norm(K: F2, h: float, scale: F1) -> float:
    """|h| e5^2/sqrt(e5^2 + 0.01 e3^2), e5 and e3 the mean-square error estimates of orders 5 and 3 in units of `scale`."""
    e5, e3 = 0.0, 0.0
    # estimates of orders 5 and 3, K[1:5] have zero weights
    for i in range(scale.size):
        five, three = E5[0] * K[0, i], E3[0] * K[0, i]
        for j in range(5, 12):
            five += E5[j] * K[j, i]
            three += E3[j] * K[j, i]
        inverse = 1.0 / scale[i]
        e5 += (five * inverse) ** 2
        e3 += (three * inverse) ** 2
    if e5 == 0.0:
        return 0.0
    return abs(h) * e5 / math.sqrt(scale.size * (e5 + 0.01 * e3))


@kernel_inline
def next_step(h: float, error: float, error_old: float, rejected_before: bool) -> float:
    """Size of the step after one with this error, accepted (error <= 1) or not."""
    if error > 1.0:
        return h * max(SHRINK, SAFETY * error ** (-1.0 / 8.0))
    factor = SAFETY * max(error, 1e-14) ** (-(1.0 / 8.0 - 0.2 * MEMORY)) * error_old**MEMORY
    factor = min(GROW, max(SHRINK, factor))
    return h * min(factor, 1.0) if rejected_before else h * factor


@kernel_bare
def dense_coefficients(y: F1, new: F1, K: F2, h: float, F: F2) -> None:
    """Coefficients F (8, ny) of the interpolant of order 7 between the states y and new; K with all 16 stages."""
    # cubic Hermite part: value, difference, slopes at both ends
    for i in range(y.size):
        d = new[i] - y[i]
        F[0, i] = y[i]
        F[1, i] = d
        F[2, i] = h * K[0, i] - d
        F[3, i] = 2.0 * d - h * (K[12, i] + K[0, i])
    # corrections of higher order from all 16 stages (II.6)
    for r in range(4):
        for i in range(y.size):
            F[4 + r, i] = 0.0
        for j in range(16):
            w = h * D[r, j]
            if w != 0.0:
                for i in range(y.size):
                    F[4 + r, i] += w * K[j, i]


@kernel_bare
def interpolate(F: F2, s: float, out: F1) -> None:
    """State at the fraction s of the step: F0 + s (F1 + (1-s)(F2 + s (F3 + (1-s)(F4 + s (F5 + (1-s)(F6 + s F7))))))."""
    r = 1.0 - s
    # nested form in s and 1 - s
    for i in range(out.size):
        high = F[4, i] + s * (F[5, i] + r * (F[6, i] + s * F[7, i]))
        out[i] = F[0, i] + s * (F[1, i] + r * (F[2, i] + s * (F[3, i] + r * high)))


@kernel_bare
def interpolate_rate(F: F2, s: float, h: float, out: F1) -> None:
    """Time derivative of the interpolant at the fraction s of a step of h (s)."""
    r = 1.0 - s
    # derivative of the nested form, from the inside out
    for i in range(out.size):
        value, slope = F[7, i], 0.0
        for k in range(6, -1, -1):
            # p <- F_k + (s or 1 - s) p, and its derivative
            if k % 2 == 0:
                slope = value + s * slope
                value = F[k, i] + s * value
            else:
                slope = r * slope - value
                value = F[k, i] + r * value
        out[i] = slope / h


@kernel_bare
def stiffness(K: F2, last: F1, new: F1, h: float, nf: int) -> float:
    """h |lambda|, the dominant eigenvalue estimated from two states at the end of the step (IV.2 eq. 2.7).

    last : state of stage 11, with rate K[11]; new : state of the step, with rate K[12]. The first nf numbers are positions,
    the next nf velocities: |lambda| is both |da|/|dv| and sqrt(|da|/|dx|) where a mode dominates, the less counts.
    """
    dx, dv, da = 0.0, 0.0, 0.0
    # squared norms of the differences of two states at the end of the step
    for i in range(nf):
        dx += (new[i] - last[i]) ** 2
        dv += (new[nf + i] - last[nf + i]) ** 2
        da += (K[12, nf + i] - K[11, nf + i]) ** 2
    if dv == 0.0:
        return 0.0
    rate = math.sqrt(da / dv)
    # positions that a stiff damper holds do not change by a digit
    return abs(h) * (min(rate, math.sqrt(math.sqrt(da / dx))) if dx > 0.0 else rate)
