"""Saddle-point systems of equilibrium with rigid rows, and what they say of stability.

    [[K/s + shift, J^T], [J, -delta W]] [dx, dN/s] = [g/s, -phi],    s = largest entry of K

with a small delta, so that redundant rows do no harm (they share by W), refined against the matrix without it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, csc_array, diags_array, eye_array

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["DELTA", "DENSE", "Saddle", "dense_solver", "inertia", "modes", "sparse_solver", "steady_solver"]

DENSE = 240
"""Unknowns up to which a dense factorisation is faster."""

DELTA = 1e-6
RELAXED = 1e-8
REFINE = 12
VAGUE = 1e-9
"""Share of the largest singular value below which a direction counts as undetermined."""

NEUTRAL = 1e-9
"""Share of the largest eigenvalue below which a reduced stiffness counts as none."""


class Saddle:
    """Factors of a saddle-point matrix of K (f, f) and J (rows, f)."""

    def __init__(self, K: Any, J: Any, weight: NDArray[np.float64], shift: float = 0.0) -> None:
        rows, self.count = J.shape
        self.size = float(np.abs(K.data).max(initial=0.0)) or 1.0
        relax = np.concatenate([np.zeros(self.count), DELTA * weight])
        if rows + self.count <= DENSE:
            full = np.zeros((rows + self.count,) * 2)
            full[: self.count, : self.count] = K.toarray() / self.size + shift * np.eye(self.count)
            full[self.count :, : self.count] = J.toarray()
            full[: self.count, self.count :] = full[self.count :, : self.count].T
            self.matrix: Any = full
            self._solve = dense_solver(full - np.diag(relax))
            return
        top = K / self.size + shift * eye_array(self.count)
        self.matrix = csc_array(block_array([[top, J.T], [J, None]])) if rows else csc_array(top)
        self._solve = sparse_solver(csc_array(self.matrix - diags_array(relax)) if rows else self.matrix)

    def solve(self, g: NDArray[np.float64], phi: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """dx (f,) m and dN (rows,) N for forces g (f,) N out of balance and rows phi (rows,) m to be changed by."""
        right = np.concatenate([g / self.size, phi])
        if self._solve is None:
            return np.full(self.count, np.nan), np.full(len(phi), np.nan)
        found = self._solve(right)
        last = np.inf
        for _ in range(REFINE if len(phi) else 1):
            change = self._solve(right - self.matrix @ found)
            size = float(np.abs(change).max(initial=0.0))
            if not size < 0.5 * last:
                break
            found, last = found + change, size
        return found[: self.count], found[self.count :] * self.size


def dense_solver(matrix: NDArray[np.float64]) -> Any:
    """Solver of a matrix, or None where it is singular."""
    from scipy.linalg import get_lapack_funcs

    getrf, getrs = get_lapack_funcs(("getrf", "getrs"), (matrix,))
    lu, pivots, info = getrf(matrix)
    return None if info else lambda right: getrs(lu, pivots, right)[0]


def steady_solver(matrix: NDArray[np.float64]) -> Any:
    """Solver of a matrix that may be all but singular: directions that it says nothing of are left alone."""
    from scipy.linalg import get_lapack_funcs

    getrf, getrs, gecon = get_lapack_funcs(("getrf", "getrs", "gecon"), (matrix,))
    lu, pivots, info = getrf(matrix)
    if not info and gecon(lu, np.abs(matrix).sum(axis=0).max())[0] > VAGUE:
        return lambda right: getrs(lu, pivots, right)[0]
    return lambda right: np.linalg.lstsq(matrix, right, rcond=VAGUE)[0]


def sparse_solver(matrix: Any) -> Any:
    """Solver of a matrix, or None where it is singular."""
    from scipy.sparse.linalg import splu

    try:
        return splu(matrix).solve
    except RuntimeError:
        return None


def modes(K: Any, J: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Eigenvalues (k,) N/m, ascending, and modes (f, k) of K on the changes that J allows."""
    from scipy.linalg import eigh, null_space

    Z = null_space(J.toarray(), rcond=NEUTRAL) if J.shape[0] else np.eye(K.shape[0])
    if not Z.shape[1]:
        return np.zeros(0), Z
    H = Z.T @ (K @ Z)
    values, vectors = eigh(0.5 * (H + H.T))
    return values, Z @ vectors


def inertia(K: Any, J: Any) -> tuple[int, int]:
    """How many eigenvalues of K on the changes that J allows are negative, and how many none, for large systems.

    Signs of the pivots of [[K, J^T], [J, -delta]]: those beyond the rows' own are negative ones of the reduced K (Haynsworth).
    """
    from scipy.sparse.linalg import splu

    size = float(np.abs(K.data).max(initial=0.0)) or 1.0
    rows = J.shape[0]
    matrix: Any = csc_array(block_array([[K / size, J.T], [J, -RELAXED * eye_array(rows)]])) if rows else csc_array(K / size)
    try:
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:
        return 0, 1
    pivots = factors.U.diagonal()
    return int(np.sum(pivots < -NEUTRAL)) - rows, int(np.sum(np.abs(pivots) <= NEUTRAL))
