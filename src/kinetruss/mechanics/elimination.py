"""Independent rows of a Jacobian, its rank and its null spaces by one sparse elimination, where that leaves no doubt.

With the independent rows and the columns of their pivots in B, all of J = [B C; D E], singular values interlace: the least of
B is a lower bound of the last one that counts. It is at least 1/(t m), m the largest |B^-1 g| of s normal random vectors g, but
for a chance of (0.8/t)^s (Dixon 1983). The rows that are left are sums of the independent ones up to a rest R, so that the next
singular value is at most |R| (Courant & Fischer). Where these bounds leave the rank open, `sure` is False.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import reverse_cuthill_mckee

from kinetruss.kernels.solve.elimination import Reduced, reduce_rows, solve_columns, solve_rows
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE

if TYPE_CHECKING:
    from numpy.typing import NDArray


ABOVE, BELOW = 4.0 * RANK_TOLERANCE, 1e-11
"""Fractions of the largest singular value: from the first on, and up to the second, there is no doubt."""
PROBES, DOUBT = 8, 100.0
"""The numbers s and t: a chance of 2e-17."""


class Elimination:
    """The elimination of a dense J (rows, columns); rows of `last` (mask) are taken only where no others serve.

    independent (rank,) : rows, ascending. redundant : the others. columns (rank,) : of pivots. first : number of independent
    rows that are not in `last`.
    """

    def __init__(self, J: NDArray[np.float64], last: NDArray[np.bool_] | None = None) -> None:
        self.J, rows = J, len(J)
        self.last = np.zeros(rows, np.bool_) if last is None else last
        self.finite = bool(np.isfinite(J).all())
        self._columns, order = _order(J.shape, (J != 0.0).tobytes())
        self._one = one = _empty(J[:, self._columns])
        waiting = np.empty(rows, np.int64)
        for group in (False, True):
            reduce_rows(one, order[self.last[order] == group], waiting)
            if not group:
                self.first = int(one.found[0])
        self.rank = int(one.found[0])
        self._rows = one.row[: self.rank]
        self.independent = np.sort(self._rows)
        self.redundant = np.setdiff1d(np.arange(rows), self.independent)
        self.columns = self._columns[one.col[: self.rank]]

    @cached_property
    def sure(self) -> bool:
        """Whether the rank, and that of the rows not in `last`, are beyond doubt."""
        plain = ~self.last
        return self.finite and self._sure(self.rank, np.ones_like(plain)) and (
            self.first == self.rank or self._sure(self.first, plain)
        )  # fmt: skip

    @cached_property
    def self_stress(self) -> NDArray[np.float64]:
        """(redundant, rows) combinations of rows that vanish: 1 in a redundant row each, else in independent ones."""
        found = np.zeros((len(self.redundant), len(self.J)))
        found[np.arange(len(self.redundant)), self.redundant] = 1.0
        share = np.zeros((len(self.redundant), self.rank))
        # z with z B = [D E], refined once
        for _ in range(2):
            solve_rows(self._one, self.rank, (found @ self.J)[:, self._columns], share)
            found[:, self._rows] = -share
        return found

    @cached_property
    def free(self) -> NDArray[np.float64]:
        """(columns - rank, columns) changes with no effect: 1 in a column without pivot each, else in those of pivots."""
        none = np.flatnonzero(self._one.at < 0)
        y = np.zeros((len(none), self.J.shape[1]))
        y[np.arange(len(none)), none] = 1.0
        solve_columns(self._one, self.rank, np.zeros((len(none), self.rank)), y)
        found = np.empty_like(y)
        found[:, self._columns] = y
        # B dy = -[B C] y, once
        change = np.zeros_like(y)
        solve_columns(self._one, self.rank, -(found @ self.J[self._rows].T), change)
        found[:, self._columns] += change
        return found

    def _sure(self, rank: int, rows: NDArray[np.bool_]) -> bool:
        """Whether the given rows have the rank of the first pivots, by both bounds."""
        if not rank:
            return not self.J[rows].any()
        J = self.J if rows.all() else self.J[rows]
        size = np.abs(J)
        top = float(np.sqrt(size.sum(axis=0).max() * size.sum(axis=1).max()))
        g = np.random.default_rng(rank).standard_normal((PROBES, rank))
        y = np.zeros((PROBES, self.J.shape[1]))
        solve_columns(self._one, rank, g.copy(), y)
        back = np.empty_like(y)
        back[:, self._columns] = y
        inverse = float(np.linalg.norm(y, axis=1).max())
        exact = float(np.abs((back @ self.J.T)[:, self._rows[:rank]] - g).max())
        if not (exact < 1e-6 and DOUBT * inverse * ABOVE * top < 1.0):
            return False
        if rank == min(J.shape):
            return True
        rest = self.self_stress[rows[self.redundant]][:, rows] @ J
        return bool(np.linalg.norm(rest) < BELOW * np.linalg.norm(J, axis=1).max())


def _empty(a: NDArray[np.float64]) -> Reduced:
    """Workspace for the elimination of a, in place."""
    rows, columns = a.shape
    most = min(rows, columns)
    row, col, n_low, n_up = np.zeros((4, most), np.int64)
    at, done, found = np.full(columns, -1, np.int64), np.zeros(rows, np.int64), np.zeros(1, np.int64)
    low, up = np.empty((most, most), np.int64), np.empty((most, columns), np.int64)
    return Reduced(np.ascontiguousarray(a), row, col, np.zeros(most), at, low, up, n_low, n_up, done, found)


@lru_cache(maxsize=16)
def _order(shape: tuple[int, int], full: bytes) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Orders of columns and rows that keep few entries: of the columns by Cuthill & McKee (1969), of rows by their first."""
    pattern = csr_array(np.frombuffer(full, np.bool_).reshape(shape).astype(np.int32))
    columns = reverse_cuthill_mckee(csr_array(pattern.T @ pattern), symmetric_mode=True).astype(np.int64)
    rank = np.empty(shape[1], np.int64)
    rank[columns] = np.arange(shape[1])
    first = np.full(shape[0], shape[1], np.int64)
    np.minimum.at(first, np.repeat(np.arange(shape[0]), np.diff(pattern.indptr)), rank[pattern.indices])
    return columns, np.argsort(first, kind="stable")
