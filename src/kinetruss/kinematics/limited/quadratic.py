"""The least of a convex quadratic function under linear inequalities, by an interior-point method.

The inequalities come in groups that each depend on a few neighbouring unknowns, as those of one instant of a curve made of
B-splines. So G^T W G is found group by group, and not as a product of sparse matrices.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Rows", "least"]

ROUNDS = 80
"""Newton's steps at most."""
CLOSE, LITTLE = 1e-8, 1e-10
"""Residuals of a solution, and its mean complementarity, in units of the largest given number."""
ROUND_OFF = 1e-13
"""Added to Newton's matrix, as a share of its largest diagonal entry: it may be singular to round-off."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Rows:
    """The rows of inequalities, G x = sign y[pick], y being blocks[j] x[first[j]:] of all groups j, one after the other.

    blocks : (m, b) of each group, with the same b; first : ascending. pick, sign (rows,); size : number of unknowns. eased :
    one more unknown u, the last, is subtracted from all rows, and the last row is -u.
    """

    blocks: list[NDArray[np.float64]]
    first: list[int]
    pick: NDArray[np.int64]
    sign: NDArray[np.float64]
    size: int
    eased: bool = False

    @cached_property
    def ends(self) -> NDArray[np.int64]:
        """Where the groups begin in y, and its length."""
        return np.asarray(np.cumsum([0, *(len(one) for one in self.blocks)]))

    @property
    def width(self) -> int:
        """Number b of unknowns of a group."""
        return int(self.blocks[0].shape[1])

    def apply(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """G x."""
        y = np.concatenate([one @ x[k : k + self.width] for one, k in zip(self.blocks, self.first, strict=True)])
        found: NDArray[np.float64] = self.sign * y[self.pick]
        return np.append(found, 0.0) - x[-1] if self.eased else found

    def transposed(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """G^T z."""
        y, found = self._summed(self.sign * z[: len(self.pick)]), np.zeros(self.size)
        for one, k, part in zip(self.blocks, self.first, y, strict=True):
            found[k : k + self.width] += part @ one
        return np.append(found, -z.sum()) if self.eased else found

    def normal(self, w: NDArray[np.float64]) -> NDArray[np.float64]:
        """G^T diag(w) G, the upper triangle."""
        from scipy.linalg.blas import dsyrk

        own, found = w[: len(self.pick)], np.zeros((self.size + self.eased,) * 2)
        for one, k, part in zip(self.blocks, self.first, self._summed(own), strict=True):
            found[k : k + self.width, k : k + self.width] += dsyrk(1.0, (np.sqrt(part)[:, None] * one).T)
        if self.eased:
            found[:-1, -1] = -self.transposed(np.append(own, 0.0))[:-1]
            found[-1, -1] = w.sum()
        return found

    def _summed(self, values: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        """Sums of values (rows,) of the same entry of y, by group."""
        return np.split(np.bincount(self.pick, values, self.ends[-1]), self.ends[1:-1])


def least(
    H: NDArray[np.float64], g: NDArray[np.float64], rows: Rows, h: NDArray[np.float64]
) -> tuple[NDArray[np.float64], bool]:
    """x (n,) of least x^T H x/2 + g^T x with G x <= h, and whether it converged.

    H (n, n) positive definite; rows : of G. Predictor and corrector of Mehrotra (1992), with one step length for primal and
    dual variables.
    """
    x = np.zeros(len(g))
    s = np.maximum(h, 1.0)
    z = np.ones(len(h))
    size = 1.0 + max(float(np.abs(g).max(initial=0.0)), float(np.abs(h).max(initial=0.0)))
    for _ in range(ROUNDS):
        dual, primal, gap = H @ x + g + rows.transposed(z), rows.apply(x) + s - h, float(s @ z) / max(1, len(h))
        off = max(float(np.abs(dual).max(initial=0.0)), float(np.abs(primal).max(initial=0.0)))
        if off < CLOSE * size and gap < LITTLE * size:
            return x, True
        solve = _solver(H + rows.normal(z / s), rows)
        if solve is None:
            return x, False
        given = (solve, rows, dual, primal, s, z)
        _, ds, dz = _step(given, s * z)
        ahead = min(_room(s, ds), _room(z, dz))
        sigma = (float((s + ahead * ds) @ (z + ahead * dz)) / max(1, len(h)) / gap) ** 3
        dx, ds, dz = _step(given, s * z + ds * dz - sigma * gap)
        share = 0.995 * min(_room(s, ds), _room(z, dz))
        x, s, z = x + share * dx, s + share * ds, z + share * dz
    return x, False


def _solver(M: NDArray[np.float64], rows: Rows) -> Any:
    """Solver of Newton's matrix M, given by its upper triangle; None: singular.

    By Cholesky factors of its band, u apart; or by those of LU where round-off makes it indefinite.
    """
    from scipy.linalg import get_lapack_funcs

    n = rows.size
    M.flat[:: len(M) + 1] += ROUND_OFF * float(np.diag(M).max())
    pbtrf, pbtrs, getrf, getrs = get_lapack_funcs(("pbtrf", "pbtrs", "getrf", "getrs"), (M,))
    band = np.zeros((rows.width, n))
    for k in range(rows.width):
        band[-1 - k, k:] = np.diagonal(M[:n, :n], k)
    factor, info = pbtrf(band)
    if info:
        lu, pivots, info = getrf(np.triu(M) + np.triu(M, 1).T)
        return None if info else lambda right: getrs(lu, pivots, right)[0]
    if not rows.eased:
        return lambda right: pbtrs(factor, right)[0]
    # M = [A b; b^T c]: u = (r_u - w^T r) / (c - b^T w), x = A^-1 r - w u with w = A^-1 b
    b, c = M[:n, n], M[n, n]
    w = pbtrs(factor, b)[0]

    def solve(right: NDArray[np.float64]) -> NDArray[np.float64]:
        u = (right[n] - w @ right[:n]) / (c - b @ w)
        return np.append(pbtrs(factor, right[:n])[0] - w * u, u)

    return solve


def _step(given: tuple[Any, ...], centre: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    """Newton's step of x, s, z: (H + G^T Z S^-1 G) dx = -dual - G^T S^-1 (Z primal - centre).

    centre : s z + ds dz - sigma mu.
    """
    solve, rows, dual, primal, s, z = given
    dx = solve(-dual - rows.transposed((z * primal - centre) / s))
    ds = -primal - rows.apply(dx)
    return dx, ds, -(centre + z * ds) / s


def _room(s: NDArray[np.float64], ds: NDArray[np.float64]) -> float:
    """Largest share of a step, at most 1/0.995, at which no entry of s changes its sign."""
    back = ds < 0
    return min(1.0 / 0.995, float(np.min(-s[back] / ds[back], initial=np.inf)))
