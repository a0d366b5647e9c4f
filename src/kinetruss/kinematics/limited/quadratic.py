"""The least of a convex quadratic function under linear inequalities, by an interior-point method."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

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
    from scipy.sparse import csr_array

    rows: Any = csr_array(G)
    x = np.zeros(len(g))
    s = np.maximum(h, 1.0)
    z = np.ones(len(h))
    size = 1.0 + max(float(np.abs(g).max(initial=0.0)), float(np.abs(h).max(initial=0.0)))
    for _ in range(ROUNDS):
        dual, primal, gap = H @ x + g + rows.T @ z, rows @ x + s - h, float(s @ z) / max(1, len(h))
        if max(float(np.abs(dual).max(initial=0.0)), float(np.abs(primal).max(initial=0.0)), gap) < CLOSE * size:
            return x, True
        M = H + (rows.T @ (rows.multiply((z / s)[:, None]))).toarray()
        # Newton's matrix may be singular to round-off; residuals stay exact
        M += 1e-13 * float(np.diag(M).max()) * np.eye(len(g))
        try:
            inverse = np.linalg.inv(M)
        except np.linalg.LinAlgError:
            return x, False
        given = (inverse, rows, dual, primal, s, z)
        _, ds, dz = _step(given, s * z)
        ahead = min(_room(s, ds), _room(z, dz))
        sigma = (float((s + ahead * ds) @ (z + ahead * dz)) / max(1, len(h)) / gap) ** 3
        dx, ds, dz = _step(given, s * z + ds * dz - sigma * gap)
        share = 0.995 * min(_room(s, ds), _room(z, dz))
        x, s, z = x + share * dx, s + share * ds, z + share * dz
    return x, False


def _step(given: tuple[Any, ...], centre: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    """Newton's step of x, s, z: (H + G^T Z S^-1 G) dx = -dual - G^T S^-1 (Z primal - centre).

    centre : s z + ds dz - sigma mu.
    """
    inverse, G, dual, primal, s, z = given
    dx = inverse @ (-dual - G.T @ ((z * primal - centre) / s))
    ds = -primal - G @ dx
    return dx, ds, -(centre + z * ds) / s


def _room(s: NDArray[np.float64], ds: NDArray[np.float64]) -> float:
    """Largest share of a step, at most 1/0.995, at which no entry of s changes its sign."""
    back = ds < 0
    return min(1.0 / 0.995, float(np.min(-s[back] / ds[back], initial=np.inf)))
