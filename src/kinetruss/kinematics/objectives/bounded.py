"""The least of a convex quadratic function under linear equations and bounds, by the method of active sets."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["bounded_least"]

LITTLE = 1e-12
"""A bound this near to 0 is where the search stands; a multiplier this small, over the largest slope, counts as none."""


def bounded_least(
    B: NDArray[np.float64], g: NDArray[np.float64], A: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]
) -> NDArray[np.float64]:
    """p (n,) of least p^T B p/2 + g^T p with A p = 0 and low <= p <= high, where low <= 0 <= high.

    B (n, n) positive definite; A (m, n). From p = 0 along bounds that change one at a time (Nocedal and Wright, 2006, 16.5).
    """
    p = np.zeros(len(g))
    # at the lower bound -1, at the upper one 1, between them 0
    side = np.where(low > -LITTLE, -1, np.where(high < LITTLE, 1, 0))
    for _ in range(10 * len(g) + 10):
        slope, free = g + B @ p, side == 0
        step = np.zeros(len(g))
        step[free] = _newton(B[np.ix_(free, free)], slope[free], A[:, free])
        share, stopped = _as_far(p, step, low, high)
        p = p + share * step
        if stopped >= 0:
            side[stopped] = 1 if step[stopped] > 0 else -1
            p[stopped] = high[stopped] if step[stopped] > 0 else low[stopped]
            continue
        slope = g + B @ p
        factors = np.linalg.lstsq(A[:, free].T, slope[free], rcond=None)[0]
        multiplier = side * (slope - A.T @ factors)  # of bounds: positive where the objective falls inwards
        if multiplier[released := int(np.argmax(multiplier))] <= LITTLE * max(1e-300, float(np.abs(g).max())):
            return p
        side[released] = 0
    return p


def _newton(B: NDArray[np.float64], slope: NDArray[np.float64], A: NDArray[np.float64]) -> NDArray[np.float64]:
    """The step of Newton's method along A p = 0."""
    _, sizes, right = np.linalg.svd(A)
    along = right[int(np.count_nonzero(sizes > 1e-12 * sizes.max(initial=0.0))) :].T
    if not along.shape[1]:
        return np.zeros(len(slope))
    return np.asarray(-along @ np.linalg.solve(along.T @ B @ along, along.T @ slope))


def _as_far(
    p: NDArray[np.float64], step: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]
) -> tuple[float, int]:
    """Share of a step within the bounds, and the entry that stops it, or -1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        room = np.where(step > 0, (high - p) / step, np.where(step < 0, (low - p) / step, np.inf))
    first = int(np.argmin(room)) if len(room) else -1
    return (max(0.0, float(room[first])), first) if first >= 0 and room[first] < 1.0 else (1.0, -1)
