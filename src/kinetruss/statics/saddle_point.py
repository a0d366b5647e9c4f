"""Saddle-point systems of equilibrium with rigid rows, and stability from their inertia.

    [[(K + shift)/s, J^T], [J, 0]] [dx, dN/s] = [g/s, -phi],    s = largest entry of K

Redundant rows are left out of the matrix and get their forces afterwards: N = N0 + S z with the states of self-stress S and z
that minimises sum w N^2, as in inverse dynamics.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, csc_array, diags_array, eye_array

from kinetruss.mechanics import RANK_TOLERANCE, System, arrange, rearrange
from kinetruss.mechanics.accuracy import weakest_block
from kinetruss.mechanics.rows import diagonal_factors, factors_of, null_basis

if TYPE_CHECKING:
    from numpy.typing import NDArray


DENSE = 240
"""Number of unknowns up to which a dense factorisation is faster."""

LOOKED_AT = 1500
"""Number of rows or free coordinates up to which ranks and all eigenvalues are computed."""

RELAXED = 1e-8
REFINE = 12
VAGUE = 1e-9
"""Directions with singular values below this fraction of the largest count as undetermined."""

NEUTRAL = 1e-11
"""Reduced stiffnesses below this fraction of the largest eigenvalue count as zero."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Rows:
    """kept, redundant : indices of independent and of redundant rows. weight (rows,) of the share. relax : small where nobody
    knows which rows are redundant.
    """

    kept: NDArray[np.int64]
    redundant: NDArray[np.int64]
    weight: NDArray[np.float64]
    relax: float = 0.0

    def shared(self, J: Any, N: NDArray[np.float64]) -> NDArray[np.float64]:
        """Row forces N (rows,) with those of redundant rows; J (rows, f)."""
        if not len(self.redundant):
            return N
        count = J.shape[1]
        solver = Saddle(eye_array(count, format="csr"), J, self)
        states = np.zeros((len(self.redundant), len(N)))
        for state, r in zip(states, self.redundant, strict=True):
            state[:] = -solver.solve(J[[r]].toarray()[0], np.zeros(len(N)))[1]
            state[r] = 1.0
        z = np.linalg.solve((states * self.weight) @ states.T, (states * self.weight) @ N)
        return np.asarray(N - states.T @ z)


def rows_of(system: System, x: NDArray[np.float64]) -> Rows:
    """Which rows of a system are redundant at positions x (n, 3)."""
    count = len(system.row_member)
    every, one = np.arange(count), np.ones(count)
    if not count:
        return Rows(kept=every, redundant=every, weight=one)
    if count > LOOKED_AT:
        return Rows(kept=every, redundant=every[:0], weight=one, relax=1e-9)
    found = arrange(system)
    if found.plan is not None and not len(found.redundant) and weakest_block(system, found.plan, x) > RANK_TOLERANCE:
        return Rows(kept=every, redundant=every[:0], weight=one)
    found = rearrange(system, x, None)
    return Rows(kept=np.setdiff1d(every, found.redundant), redundant=found.redundant, weight=found.weight)


class Saddle:
    """Factors of a saddle-point matrix of K (f, f), N/m, with a shift (N/m) on its diagonal, and J (rows, f)."""

    def __init__(self, K: Any, J: Any, rows: Rows, shift: float = 0.0) -> None:
        self.rows, self.all = rows, J.shape[0]
        J = J[rows.kept] if len(rows.redundant) else J
        held, self.count = J.shape
        self.size = max(float(np.abs(K.data).max(initial=0.0)), shift) or 1.0
        relax = np.concatenate([np.zeros(self.count), np.full(held, rows.relax)])
        if held + self.count <= DENSE:
            full = np.zeros((held + self.count,) * 2)
            full[: self.count, : self.count] = (K.toarray() + shift * np.eye(self.count)) / self.size
            full[self.count :, : self.count] = J.toarray()
            full[: self.count, self.count :] = full[self.count :, : self.count].T
            self.matrix: Any = full
            self._solve = dense_solver(full - np.diag(relax))
            return
        top = (K + shift * eye_array(self.count)) / self.size
        self.matrix = csc_array(block_array([[top, J.T], [J, None]])) if held else csc_array(top)
        self._solve = sparse_solver(csc_array(self.matrix - diags_array(relax)) if held else self.matrix)

    def solve(self, g: NDArray[np.float64], phi: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """dx (f,) m and dN (rows,) N for residual forces g (f,) N and residuals phi (rows,) m of the rows.

        Redundant rows get no force here, see `Rows.shared`.
        """
        row_force = np.zeros(self.all)
        right = np.concatenate([g / self.size, phi[self.rows.kept]])
        if self._solve is None:
            return np.full(self.count, np.nan), row_force + np.nan
        found, last = self._solve(right), np.inf
        for _ in range(REFINE):
            change = self._solve(right - self.matrix @ found)
            size = float(np.abs(change).max(initial=0.0))
            if not size < 0.5 * last:
                break
            found, last = found + change, size
        row_force[self.rows.kept] = found[self.count :] * self.size
        return found[: self.count], row_force


def dense_solver(matrix: NDArray[np.float64]) -> Any:
    """Solver of a matrix, or None if it is singular."""
    from scipy.linalg import get_lapack_funcs

    if not len(matrix):
        return lambda right: right
    getrf, getrs = get_lapack_funcs(("getrf", "getrs"), (matrix,))
    lu, pivots, info = getrf(matrix)
    return None if info else lambda right: getrs(lu, pivots, right)[0]


def steady_solver(matrix: NDArray[np.float64]) -> Any:
    """Solver of a matrix that may be nearly singular: directions without stiffness get no change."""
    from scipy.linalg import get_lapack_funcs

    getrf, getrs, gecon = get_lapack_funcs(("getrf", "getrs", "gecon"), (matrix,))
    lu, pivots, info = getrf(matrix)
    if not info and gecon(lu, np.abs(matrix).sum(axis=0).max())[0] > VAGUE:
        return lambda right: getrs(lu, pivots, right)[0]
    return lambda right: np.linalg.lstsq(matrix, right, rcond=VAGUE)[0]


def sparse_solver(matrix: Any) -> Any:
    """Solver of a matrix, or None if it is singular."""
    factors = factors_of(matrix)
    return None if factors is None else factors.solve


def modes(K: Any, J: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Eigenvalues (k,) N/m, ascending, and modes (f, k) of K on the changes that J allows."""
    from scipy.linalg import eigh

    Z = null_basis(J)
    if not Z.shape[1]:
        return np.zeros(0), Z
    H = Z.T @ (K @ Z)
    values, vectors = eigh(0.5 * (H + H.T))
    return values, Z @ vectors


def inertia(K: Any, J: Any) -> tuple[int, int]:
    """Numbers of negative and of zero eigenvalues of K on the changes that J allows, for large systems.

    Signs of the pivots of [[K, J^T], [J, -delta]]: the negative pivots in excess of the number of rows are negative
    eigenvalues of the reduced K (Haynsworth).
    """
    size = float(np.abs(K.data).max(initial=0.0)) or 1.0
    rows = J.shape[0]
    matrix: Any = csc_array(block_array([[K / size, J.T], [J, -RELAXED * eye_array(rows)]])) if rows else csc_array(K / size)
    factors = diagonal_factors(matrix)
    if factors is None:
        return 0, 1
    pivots = factors.U.diagonal()
    return int(np.sum(pivots < -NEUTRAL)) - rows, int(np.sum(np.abs(pivots) <= NEUTRAL))
