"""Rank and null spaces of Jacobians: by elimination where it leaves no doubt, else by singular values for small matrices and
by inverse iteration for large ones.

For large J, all right singular vectors of small singular values are found by subspace iteration with the sparse factors of
J^T J + s I (Golub & Van Loan, Matrix Computations, 2013, section 8.2), and the singular values of J on this space decide
(Rayleigh-Ritz).
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_array, eye_array

from kinetruss.errors import InputError
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE
from kinetruss.mechanics.rows import diagonal_factors, structural_rank

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.mechanics.elimination import Elimination


DENSE = 300
"""Rows and columns up to which all singular values are found."""

SHIFT = 1e-15
"""The shift s as a fraction of the largest eigenvalue of J^T J: well above round-off."""

SURE = 1e10
"""Condition number of A A^T below which A has full rank beyond doubt."""

FAR = 3e-7
"""Singular values above this fraction of the largest do not matter for the rank: their squares are well above SHIFT."""

CERTAIN = 1e-13
"""Singular values below this fraction of the largest are round-off."""

LISTED = 2e8
"""Largest number of entries of a basis."""

GUARD = 6
"""Vectors that are iterated in addition to the requested ones."""

MOST = 40
"""Largest number of iterations for the smallest singular value."""

TALL = 500
"""Number of rows in a block of the QR factorisation."""

TIE = 1e-7
"""Entries that differ by less than this fraction count as equal."""


class Spaces:
    """Rank of a sparse matrix J (rows, columns) and bases of its null spaces.

    near : decides whether a change of coordinates with a small effect counts as a null vector; None: it does.
    sure : the elimination of J, if there is one that leaves no doubt of the rank.
    """

    def __init__(
        self, J: Any, near: Callable[[NDArray[np.float64]], bool] | None = None, sure: Elimination | None = None
    ) -> None:
        self.shape, self.near, self.sure, self._given = J.shape, near, sure, J
        self._small = max(J.shape) <= DENSE

    @cached_property
    def _whole(self) -> csr_array:
        J = csr_array(self._given)
        J.eliminate_zeros()
        return J

    @cached_property
    def _rows(self) -> NDArray[np.int64]:
        return np.unique(self._whole.nonzero()[0])

    @cached_property
    def _columns(self) -> NDArray[np.int64]:
        return np.unique(self._whole.nonzero()[1])

    @cached_property
    def _J(self) -> csr_array:
        """J, of a large one without its empty rows and columns."""
        return self._whole if self._small else csr_array(self._whole[self._rows][:, self._columns])

    @cached_property
    def _svd(self) -> Any:
        """Singular values and vectors of a small matrix, or None."""
        return np.linalg.svd(self._J.toarray()) if self._small else None

    @cached_property
    def rank(self) -> int:
        """Number of singular values above RANK_TOLERANCE of the largest; for large structures see `near`."""
        if self.sure is not None:
            return self.sure.rank
        if self._small:
            if _surely_full(self._J.toarray()):
                return int(min(self.shape))
            values = self._svd[1]
            return int(np.sum(values > RANK_TOLERANCE * values.max(initial=0.0)))
        return int(min(self._J.shape) - self._narrow.shape[1])

    @cached_property
    def smallest(self) -> float:
        """Smallest of the min(rows, columns) singular values."""
        if not min(self.shape):
            return 1.0
        if self._svd is not None:
            return float(self._svd[1].min())
        return _Iteration(self._tall).smallest() if self.rank == min(self.shape) else 0.0

    @cached_property
    def right(self) -> NDArray[np.float64]:
        """Basis (columns, columns - rank) of the null space of J, with as many zeros as elimination gives."""
        return self._basis(1)

    @cached_property
    def left(self) -> NDArray[np.float64]:
        """Basis (rows, rows - rank) of the null space of J^T (row forces in balance), likewise."""
        return self._basis(0)

    @cached_property
    def weakest(self) -> NDArray[np.float64]:
        """The right singular vector (columns,) of the smallest singular value."""
        if self._svd is not None:
            return np.asarray(self._svd[2][-1])
        found = np.zeros(self.shape[1])
        vector = _Iteration(self._tall).lowest()[0][:, 0]
        found[self._columns] = vector if self._upright else self._J.T @ vector
        return found

    @property
    def _upright(self) -> bool:
        return bool(self._J.shape[1] <= self._J.shape[0])

    @property
    def _tall(self) -> csr_array:
        return self._J if self._upright else csr_array(self._J.T)

    @cached_property
    def _narrow(self) -> NDArray[np.float64]:
        """Null vectors of a large matrix, on the side with fewer entries."""
        vectors, values, top = _Iteration(self._tall).lowest()
        return vectors[:, [k for k, value in enumerate(values) if self._vanishes(vectors[:, k], value, top)]]

    def _vanishes(self, vector: NDArray[np.float64], value: float, top: float) -> bool:
        """Whether a singular vector is a null vector; a vector of row forces is judged by its right singular vector."""
        if value > RANK_TOLERANCE * top:
            return False
        if value <= CERTAIN * top or self.near is None:
            return True
        moved = np.zeros(self.shape[1])
        moved[self._columns] = vector if self._upright else self._J.T @ vector
        return self.near(moved)

    def _basis(self, side: int) -> NDArray[np.float64]:
        size = self.shape[side]
        count = size - self.rank
        if size * count > LISTED:
            raise InputError(f"{count} vectors of {size} numbers are too many to list. Look at a part of the model.")
        if not count:
            return np.zeros((size, 0))
        if self.sure is not None:
            return tidy((self.sure.free if side else self.sure.self_stress).T)
        if self._svd is not None:
            U, _, Vt = self._svd
            return tidy((Vt.T if side else U)[:, self.rank :])
        kept = self._columns if side else self._rows
        lone = np.setdiff1d(np.arange(size), kept)
        rest = count - len(lone)
        if not rest:
            basis = np.zeros((len(kept), 0))
        elif self._upright == bool(side):
            basis = self._narrow
        else:
            basis = _Iteration(csr_array(self._tall.T)).lowest(rest)[0][:, :rest]
        vectors, pivots = _tidied(basis)
        places = np.argsort(np.concatenate([lone, kept[pivots]]), kind="stable").argsort()
        found = np.zeros((size, count))
        found[lone, places[: len(lone)]] = 1.0
        found[np.ix_(kept, places[len(lone) :])] = vectors
        return found


def _surely_full(A: NDArray[np.float64]) -> bool:
    """True only if A has full rank beyond doubt: the inverse of A A^T (or A^T A) is small, so that the least singular value is
    at least 1e-5 of the largest, which the rounding of the product cannot hide.
    """
    if not A.size:
        return False
    square = A @ A.T if A.shape[0] <= A.shape[1] else A.T @ A
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            return bool(np.linalg.norm(np.linalg.inv(square)) * np.linalg.norm(square) < SURE)
    except np.linalg.LinAlgError:
        return False


class _Iteration:
    """Lowest singular values of a large sparse matrix, and their right singular vectors."""

    def __init__(self, A: csr_array) -> None:
        self.A = A
        self.top = _largest(A)
        self.factors = diagonal_factors(A.T @ A + (SHIFT * self.top**2) * eye_array(A.shape[1]))
        self.chance = np.random.default_rng(1)

    def lowest(self, count: int = 0) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """Orthonormal vectors (n, k), at least `count`, and their singular values, ascending; all below FAR; the largest."""
        size = self.A.shape[1]
        least = max(count, size - structural_rank(self.A)) if size else 0
        V, values = np.zeros((size, 0)), np.full(1, np.inf)
        while V.shape[1] < size:
            more = min(size, least + GUARD if not V.shape[1] else 2 * V.shape[1] + GUARD) - V.shape[1]
            if size * (V.shape[1] + more) > LISTED:
                raise InputError(f"More than {V.shape[1]} freedoms or states of self-stress are too many to find.")
            V = np.hstack([V, self.chance.standard_normal((size, more))])
            V, values = self._turned(V, 2)
            if values[-1] > FAR * self.top:
                break
        if values.min() <= FAR * self.top:
            V, values = self._turned(V, 4)
            for _ in range(3):  # round-off of A^T A leaves components along directions that A does not map to zero
                low = values <= FAR * self.top
                V[:, low] -= self.factors.solve(self.A.T @ (self.A @ V[:, low]))
                V, values = self._turned(V, 0)
        return V, values[: V.shape[1]], self.top

    def smallest(self) -> float:
        """The smallest singular value."""
        V = self.chance.standard_normal((self.A.shape[1], min(self.A.shape[1], 2 * GUARD)))
        last = np.inf
        for _ in range(MOST):
            V, values = self._turned(V, 3)
            if abs(values[0] - last) <= 1e-10 * values[0]:
                break
            last = values[0]
        return float(values[0])

    def _turned(self, V: NDArray[np.float64], steps: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Steps of inverse iteration, then singular vectors within the space (Rayleigh-Ritz)."""
        for _ in range(steps):
            V = self.factors.solve(_orthonormal(V)[0])
        V = _orthonormal(V)[0]
        _, values, Zt = np.linalg.svd(_orthonormal(self.A @ V)[1])
        values = np.pad(values, (0, V.shape[1] - len(values)))
        return np.ascontiguousarray(V @ Zt.T[:, ::-1]), values[::-1]


def _orthonormal(V: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """QR factors of a tall, narrow matrix, by blocks of rows that stay in cache (Demmel, Grigori, Hoemmen & Langou 2012)."""
    size, count = V.shape
    pieces = size // max(TALL, 4 * count)
    if pieces < 2:
        return np.linalg.qr(V)
    high = size // pieces
    head, rest = V[: pieces * high].reshape(pieces, high, count), V[pieces * high :]
    Q, R = np.linalg.qr(head)
    last, top = np.linalg.qr(np.vstack([R.reshape(-1, count), rest]))
    whole = (Q @ last[: pieces * count].reshape(pieces, count, count)).reshape(-1, count)
    return np.vstack([whole, last[pieces * count :]]), top


def _largest(A: csr_array) -> float:
    """Largest singular value, to a few per cent (power iteration)."""
    v = np.random.default_rng(0).standard_normal(A.shape[1])
    for _ in range(20 if A.nnz else 0):
        v = A.T @ (A @ (v / np.linalg.norm(v)))
    return float(np.sqrt(np.linalg.norm(v)))


def outside(A: Any, b: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of b (rows, k) orthogonal to the range of A (rows, columns)."""
    if not min(A.shape):
        return b
    if max(A.shape) <= DENSE:
        U, values, _ = np.linalg.svd(A.toarray(), full_matrices=False)
        U = U[:, values > RANK_TOLERANCE * values.max()]
        return np.asarray(b - U @ (U.T @ b))
    one = _Iteration(csr_array(A))
    for _ in range(4):
        b = b - A @ one.factors.solve(A.T @ b)
    return np.asarray(b)


def tidy(basis: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same space (n, k) with as many zeros as Gauss-Jordan elimination gives, largest entry of each vector +1.

    Pivots depend on the space alone, not on the given basis: each is the coordinate with the largest component, the first
    of equal ones. The vectors are in the order of their pivots.
    """
    return _tidied(basis)[0]


def _tidied(basis: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """The tidy vectors (n, k) and their pivots (k,), ascending."""
    if not basis.shape[1]:
        return basis, np.zeros(0, np.int64)
    left = np.linalg.qr(basis)[0]
    reach = np.sum(left**2, axis=1)
    pivots, ways = [], np.zeros((left.shape[1], left.shape[1]))
    for k, way in enumerate(ways):
        row = int(np.argmax(reach >= (1 - TIE) * reach.max()))
        pivots.append(row)
        # Gram-Schmidt: what is left of the row beside those chosen before
        way[:] = left[row] - ways[:k].T @ (ways[:k] @ left[row])
        way /= np.linalg.norm(way)
        reach -= (left @ way) ** 2
    pivots.sort()
    places = np.array(pivots, np.int64)
    found = np.linalg.solve(basis[places].T, basis.T).T
    size = np.abs(found)
    largest = np.argmax(size >= (1 - TIE) * size.max(axis=0), axis=0)
    found /= found[largest, np.arange(found.shape[1])]
    found[np.abs(found) < 1e-12] = 0.0
    return np.asarray(found), places
