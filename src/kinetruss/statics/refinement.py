"""Sparse solutions with error bounds: iterative refinement in doubled precision.

    r = b - M y in twice the working precision,  M d = r,  y <- y + d        (Wilkinson 1963; Skeel 1980)
    |error| <= |M^-1| (|r| + eps (|M| |y| + |b|))                            (Arioli, Demmel & Duff 1989)

The second line counts the rounding of the entries of M too: direction cosines are no better than eps. Its largest entry is
estimated by a few solutions with the same factors (Hager 1984).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import LinearOperator, onenormest

from kinetruss.mechanics.rows import SYMMETRIC, diagonal_factors, factors_of

if TYPE_CHECKING:
    from numpy.typing import NDArray


Solver = Callable[["NDArray[np.float64]"], "NDArray[np.float64]"]

EPS = float(np.finfo(float).eps)

STEPS = 30
"""Largest number of refinement steps; usually three or four are enough."""

WAYS = ((0.0, 1.0), (1e-3, 1.0), (0.1, 1.0), (0.1, 1e-4), (0.1, 1e-8))
"""Pairs that are tried in order: the pivot threshold, as a fraction of the largest entry of a column, and the size to which the
first part of the diagonal is scaled before the factorisation.
"""

STEADY = 0.1
"""A factorisation is good enough if each refinement step reduces the residual to this fraction."""

SPLIT = 134217729.0
"""2^27 + 1: splits a double into two halves whose products are exact (Dekker 1971)."""


class Doubled:
    """b - M y of a sparse matrix in twice the working precision, rounded once at the end."""

    def __init__(self, matrix: csr_array) -> None:
        self.matrix, self.size = matrix, abs(matrix)
        self.high = _high(matrix.data)
        self.low = matrix.data - self.high
        length = np.diff(matrix.indptr)
        # the k-th entries of all rows with at least k entries
        self.slots = []
        rows = np.argsort(-length, kind="stable")
        for k in range(int(length.max(initial=0))):
            rows = rows[: int(np.searchsorted(-length[rows], -k, side="left"))]
            self.slots.append((rows, matrix.indptr[rows] + k))

    def residual(self, y: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
        """b - M y."""
        at = y[self.matrix.indices]
        high = _high(at)
        low = at - high
        product = self.matrix.data * at
        # round-off of each product, from halves of 26 bits (Dekker, 1971)
        lost = ((self.high * high - product) + self.high * low + self.low * high) + self.low * low
        total, rest = b.copy(), np.zeros_like(b)
        for rows, entries in self.slots:
            one, two = total[rows], -product[entries]
            # sum with its round-off (Knuth's TwoSum)
            found = one + two
            part = found - one
            rest[rows] += ((one - (found - part)) + (two - part)) - lost[entries]
            total[rows] = found
        return np.asarray(total + rest)


def _high(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The upper half of the digits."""
    scaled = SPLIT * values
    return np.asarray(scaled - (scaled - values))


@dataclass(frozen=True, kw_only=True, eq=False)
class Refined:
    """y : solution. errors : bound on the error of each part, relative to its largest entry. worst : the larger bound for the
    worst right-hand side of this size; large if the matrix is nearly singular.
    """

    y: NDArray[np.float64]
    errors: tuple[float, ...]
    worst: float


def best_of(
    matrix: csr_array, b: NDArray[np.float64], parts: list[slice], order: NDArray[np.int64], least: float = 0.0
) -> Refined:
    """Solution of a symmetric sparse system whose rows and columns are eliminated in this order as far as that is stable.

    Pivots off the diagonal cause fill, so they are allowed only if refinement does not converge without them.
    parts : groups of unknowns of one kind; each has its own error bound. least : size that the first is compared with at least.
    """
    sizes = [least, *(0.0 for _ in parts[1:])]
    if not len(b):
        return Refined(y=b, errors=(0.0,) * len(parts), worst=0.0)
    doubled = Doubled(matrix)
    found = None
    for share, size in WAYS:
        solve = _factored(matrix, order, share, np.where(np.arange(len(b)) < parts[0].stop, size**0.5, size**-0.5))
        if solve is None:
            continue
        y, left, rate = _refined(doubled, solve, b, parts, sizes)
        rounding = _rounding(doubled, y, b) + np.abs(left)
        errors = tuple(_bound(solve, y, rounding, part, size) for part, size in zip(parts, sizes, strict=True))
        if found is None or max(errors) < max(found[1]):
            found = y, errors, solve
        if rate < STEADY:
            break
    if found is None:
        return Refined(y=np.full(len(b), np.nan), errors=(np.inf,) * len(parts), worst=np.inf)
    y, errors, solve = found
    whole = np.empty(len(b))
    for part in parts:
        whole[part] = _largest(y[part]) or 1.0
    any_load = _rounding(doubled, whole, np.full(len(b), _largest(b)))
    worst = max(_bound(solve, whole, any_load, part) for part in parts)
    return Refined(y=y, errors=errors, worst=max(worst, *errors))


def each_of(
    matrix: csr_array, right: list[NDArray[np.float64]], parts: list[slice], order: NDArray[np.int64]
) -> list[NDArray[np.float64]]:
    """Solutions for several right-hand sides with the factors of one way, the first that is good for all; no error bounds."""
    doubled, sizes = Doubled(matrix), [0.0 for _ in parts]
    found: list[NDArray[np.float64]] = [np.full(len(b), np.nan) for b in right]
    for share, size in WAYS:
        scale = np.where(np.arange(matrix.shape[0]) < parts[0].stop, size**0.5, size**-0.5)
        solve = _factored(matrix, order, share, scale)
        if solve is None:
            continue
        tried = [_refined(doubled, solve, b, parts, sizes) for b in right]
        found = [y for y, _, _ in tried]
        if all(rate < STEADY for _, _, rate in tried):
            break
    return found


def _factored(matrix: csr_array, order: NDArray[np.int64], share: float, scale: NDArray[np.float64]) -> Solver | None:
    """Solver by the factors of the matrix, rows and columns scaled, in this order; None if it is singular."""
    scaled = csr_array(diags_array(scale) @ matrix @ diags_array(scale))
    factors = factors_of(scaled[order][:, order], permc_spec="NATURAL", diag_pivot_thresh=share, **SYMMETRIC)
    if factors is None:
        return None

    def solve(right: NDArray[np.float64]) -> NDArray[np.float64]:
        y = np.empty(len(right))
        y[order] = factors.solve((scale * right)[order])
        return scale * y

    return solve


def _refined(
    doubled: Doubled, solve: Solver, b: NDArray[np.float64], parts: list[slice], sizes: list[float]
) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """Solution y of M y = b, its last residual, and the rate at which refinement converged."""
    y, left = np.zeros_like(b), b
    last, rate = np.inf, 0.0
    for step in range(STEPS):
        change = solve(left)
        if not np.all(np.isfinite(change)):
            return y, left, np.inf
        size = max(
            _largest(change[part]) / (max(_largest((y + change)[part]), own) or 1.0)
            for part, own in zip(parts, sizes, strict=True)
        )
        if step and size > EPS:
            rate = max(rate, size / last)
        if size >= 0.5 * last:
            break
        y, last = y + change, size
        left = doubled.residual(y, b)
        if size <= EPS:
            break
    return y, left, rate


def _rounding(doubled: Doubled, y: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Residual equivalent to rounding errors of the entries of M and b."""
    return np.asarray(EPS * (doubled.size @ np.abs(y) + np.abs(b)))


def _bound(solve: Solver, y: NDArray[np.float64], off: NDArray[np.float64], part: slice, least: float = 0.0) -> float:
    """Largest error of a part of y, as a fraction of its largest entry (or `least`), for residuals up to `off`.

    ||D M^-1 off||, D choosing the part, is the 1-norm of off M^-1 D, since M is symmetric.
    """
    largest = max(_largest(y[part]), least)
    if not largest:
        return 0.0

    def to(z: NDArray[np.float64]) -> NDArray[np.float64]:
        chosen = np.zeros(len(y))
        chosen[part] = z.reshape(-1)[part]
        return off * solve(chosen)

    def back(z: NDArray[np.float64]) -> NDArray[np.float64]:
        chosen = np.zeros(len(y))
        chosen[part] = solve(off * z.reshape(-1))[part]
        return chosen

    operator = LinearOperator((len(y),) * 2, matvec=to, rmatvec=back, dtype=float)
    with np.errstate(all="ignore"):
        found = float(onenormest(operator, t=1)) / largest
    return found if np.isfinite(found) else np.inf


def fill_order(pattern: Any) -> NDArray[np.int64]:
    """An order of elimination that keeps the factors of a symmetric pattern sparse (multiple minimum degree)."""
    count = pattern.shape[0]
    if count < 4:
        return np.arange(count)
    unit = csr_array((np.ones(pattern.nnz), pattern.indices, pattern.indptr), shape=pattern.shape)
    wide = np.asarray(unit.sum(axis=1)).reshape(-1)
    unit.setdiag(2.0 * wide + 1.0)
    return np.argsort(diagonal_factors(unit).perm_c)


def _largest(values: NDArray[np.float64]) -> float:
    return float(np.abs(values).max(initial=0.0))
