"""The least of a convex quadratic function under linear inequalities, by an interior-point method."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["least"]

ROUNDS = 80
"""Newton's steps at most."""
CLOSE = 1e-8
"""Residuals and mean complementarity of a solution, in units of the largest given number."""


def least(
    H: NDArray[np.float64], g: NDArray[np.float64], G: NDArray[np.float64], h: NDArray[np.float64]
) -> tuple[NDArray[np.float64], bool]:
    """x (n,) of least x^T H x/2 + g^T x with G x <= h, and whether it converged.

    H (n, n) positive definite, G (m, n). Predictor and corrector of Mehrotra (1992), with one step length for primal and
    dual variables.
    """
    from scipy.linalg import LinAlgError, cho_factor, cho_solve

    x = np.zeros(len(g))
    s = np.maximum(h, 1.0)
    z = np.ones(len(h))
    size = 1.0 + max(float(np.abs(g).max(initial=0.0)), float(np.abs(h).max(initial=0.0)))
    for _ in range(ROUNDS):
        dual, primal, gap = H @ x + g + G.T @ z, G @ x + s - h, float(s @ z) / max(1, len(h))
        if max(float(np.abs(dual).max(initial=0.0)), float(np.abs(primal).max(initial=0.0)), gap) < CLOSE * size:
            return x, True
        M = H + G.T @ ((z / s)[:, None] * G)
        # Newton's matrix may be singular to round-off; residuals stay exact
        M += 1e-13 * float(np.diag(M).max()) * np.eye(len(g))
        try:
            factors = cho_factor(M)
        except LinAlgError:
            return x, False

        def step(centre: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
            # (H + G^T Z S^-1 G) dx = -dual - G^T S^-1 (Z primal - centre), with centre = s z + ds dz - sigma mu
            dx = cho_solve(factors, -dual - G.T @ ((z * primal - centre) / s))
            ds = -primal - G @ dx
            return dx, ds, -(centre + z * ds) / s

        _, ds, dz = step(s * z)
        ahead = min(_room(s, ds), _room(z, dz))
        sigma = (float((s + ahead * ds) @ (z + ahead * dz)) / max(1, len(h)) / gap) ** 3
        dx, ds, dz = step(s * z + ds * dz - sigma * gap)
        share = 0.995 * min(_room(s, ds), _room(z, dz))
        x, s, z = x + share * dx, s + share * ds, z + share * dz
    return x, False


def _room(s: NDArray[np.float64], ds: NDArray[np.float64]) -> float:
    """Largest share of a step, at most 1/0.995, at which no entry of s changes its sign."""
    back = ds < 0
    return min(1.0 / 0.995, float(np.min(-s[back] / ds[back], initial=np.inf)))
