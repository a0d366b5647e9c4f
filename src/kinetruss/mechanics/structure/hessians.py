"""How gradients of measures turn: Hessians, and rates of gradients along a motion; exact, complex positions allowed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.kernels.structure.plan import ALONG, COSINE, FIXED_AXIS, NODE, OFFSET
from kinetruss.mechanics.structure.measures import measure_flats

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.structure.system import System

__all__ = ["measure_curvature", "measure_hessian", "measure_turning"]

STEP = 1e-30
"""Of complex steps: small enough for its square to vanish (Squire & Trapp, SIAM Review 40 (1998) 110-112)."""


def measure_hessian(system: System, m: Any, x: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Flat coordinates (k,) of the nodes of measure m, and its second derivatives (k, k) by these, at x (n, 3)."""
    flats = measure_flats(system, m)
    turned = np.zeros((len(flats), x.size))
    for k, flat in enumerate(flats):
        unit = np.zeros(x.size)
        unit[flat] = 1.0
        # column k of the Hessian
        turned[k] = _hessian_times(system, m, x.reshape(-1), unit)
    found = turned[:, flats]
    return flats, 0.5 * (found + found.T)


def measure_curvature(system: System, m: Any, x: NDArray[np.float64], F: NDArray[np.float64]) -> NDArray[np.float64]:
    """F_i^T H F_j (k, k) of measure m at x (n, 3), for the columns of F (3 n, k)."""
    flats, H = measure_hessian(system, m, x)
    return np.asarray(F[flats].T @ H @ F[flats])


def measure_turning(
    system: System, m: Any, x: NDArray[np.float64], v: NDArray[np.float64] | None, a: NDArray[np.float64] | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """First and second rate (3 n,) of the gradient of measure m at x, v, a (n, 3); None is at rest."""
    y, w, b = (np.zeros(x.size) if one is None else one.reshape(-1) for one in (x, v, a))
    if not (np.any(w) or np.any(b)):
        return np.zeros(x.size), np.zeros(x.size)
    return _hessian_times(system, m, y, w), _hessian_times(system, m, y + 1j * STEP * w, w + 1j * STEP * b).imag / STEP


def _hessian_times(system: System, m: Any, x: NDArray[Any], v: NDArray[Any]) -> NDArray[Any]:
    """The Hessian of measure m at flat x times v, (3 n,)."""
    found = np.zeros(x.size, np.result_type(x, v))
    for t in range(system.measure_ptr[m], system.measure_ptr[m + 1]):
        # each term depends on P, 1 and 2 by r = x_P - x_1 and b = x_2 - x_1: its gradient is g at P, -(1 - s) g at 1, -s g at 2
        P, one, two = (slice(flat, flat + 3) for flat in system.term_at[t, :3])
        kind, data = int(system.term_kind[t]), system.term_data[t]
        if kind == COSINE:
            # m = c cos(x + phase): -c cos(x + phase) x'
            flat = P.start
            found[flat] -= data[0] * np.cos(x[flat] + data[1]) * v[flat]
            continue
        g, share, gd, shift = _rates(kind, data, x[P] - x[one], x[two] - x[one], v[P] - v[one], v[two] - v[one])
        if kind == NODE:
            continue
        # rates of g, (1 - s) g and s g
        found[P] += gd
        found[one] -= (1 - share) * gd - shift * g
        found[two] -= share * gd + shift * g
    return found


def _rates(
    kind: int, data: NDArray[np.float64], r: NDArray[Any], b: NDArray[Any], rd: NDArray[Any], bd: NDArray[Any]
) -> tuple[Any, Any, Any, Any]:
    """g, s of a term and their rates (see kernels.constraints.terms), from r = x_P - x_1, b = x_2 - x_1 and their rates."""
    factor, e1, e2 = data[0], data[1:4], data[4:7]
    if kind == NODE:
        return e1, 0.0, 0.0 * e1, 0.0
    if kind == ALONG:
        L = np.sqrt(r @ r)
        # c |r|: g = c u, g' = c (r' - u (u . r'))/|r|
        return factor * r / L, 0.0, factor * (rd - r * (r @ rd) / (r @ r)) / L, 0.0
    if kind == FIXED_AXIS:
        # angle about a fixed axis: tan = (e_2 . r)/(e_1 . r)
        c, s, cd, sd = e1 @ r, e2 @ r, e1 @ rd, e2 @ rd
        square, across = c * c + s * s, c * e2 - s * e1
        return (
            factor * across / square,
            0.0,
            factor * ((cd * e2 - sd * e1) - 2 * (c * cd + s * sd) / square * across) / square,
            0.0,
        )
    # s = r . b/b^2: the foot of P on the line 1 2
    square = b @ b
    share, dilation = (r @ b) / square, (b @ bd) / square
    shift = (rd @ b + r @ bd) / square - 2 * share * dilation
    if kind == OFFSET:
        # distance to the left of the line: g = c n/|b|, n = b turned by 90 degrees
        n, nd = (np.array([-y[1], y[0], 0.0 * y[0]]) for y in (b, bd))
        B = np.sqrt(square)
        return factor * n / B, share, factor * (nd - dilation * n) / B, shift
    # angle about the line: g = c |b| n/n^2, n = b x r
    c, cd = np.cross(b, r), np.cross(bd, r) + np.cross(b, rd)
    size = factor * np.sqrt(square) / (c @ c)
    return size * c, share, size * (cd + (dilation - 2 * (c @ cd) / (c @ c)) * c), shift
