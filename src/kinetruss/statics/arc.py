"""Steps along an equilibrium path: tangent, prediction, correction on the plane normal to the tangent.

Unknowns are positions, row forces and the load factor; lengths of steps are measured in x and the factor together, so that
limit points are regular points (Riks, J. Appl. Mech. 39 (1972) 1060-1065; Keller, 1977).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, csc_array, csr_array

from kinetruss.mechanics import constraint_jacobian
from kinetruss.mechanics.balance import Balance
from kinetruss.statics.saddle_point import DENSE, Rows, rows_of, sparse_solver, steady_solver
from kinetruss.statics.search import ROUND_OFF, row_errors

if TYPE_CHECKING:
    from numpy.typing import NDArray


ITERATIONS = 12
NEAR = 1e-12
"""Residual forces that no longer decrease count as balanced below this fraction of the largest force."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """x (n, 3) m, N (rows,) N, load factor; unit tangent: to_x (f,), to_factor; number of correction steps."""

    x: NDArray[np.float64]
    N: NDArray[np.float64]
    factor: float
    to_x: NDArray[np.float64]
    to_factor: float
    steps: int = 0


class Road:
    """The constants of a path: constant forces, the scaled force (3 n,), prescribed values of rows, scales.

    Positions are measured in `span` m, factors in `unit`.
    """

    def __init__(
        self, balance: Balance, push: NDArray[np.float64], wanted: NDArray[np.float64], rows: Rows, span: float
    ) -> None:
        self.balance, self.push, self.wanted, self.rows, self.span = balance, push, wanted, rows, span
        self.system, self.free, self.unit, self.stiff = balance.system, balance.system.free, 1.0, 0.0
        self.largest = 0.0  # largest entry of the stiffness at its last evaluation, N/m

    def choose(self, x: NDArray[np.float64]) -> None:
        """Choose the independent rows of a redundant structure again: those of one position may be dependent at the next."""
        if len(self.rows.redundant) and len(self.rows.kept) <= DENSE:
            self.rows = rows_of(self.system, x)

    def loaded(self, factor: float) -> Balance:
        """The forces at a load factor."""
        return self.balance.with_force(self.balance.force + factor * self.push)

    def begin(self, x: NDArray[np.float64], N: NDArray[np.float64], factor: float, sense: float) -> Point:
        """The first point, with a tangent towards larger (sense 1) or smaller (-1) factors; sets the unit of the factor."""
        to_x, _ = self._along(x, N, np.zeros(len(self.free)), 1.0)
        rate = float(np.linalg.norm(to_x)) / self.span
        self.unit = 1 / rate if rate > 0 else 1.0
        to_x, to_factor = self._along(x, N, np.zeros(len(self.free)), 1.0)
        return Point(x=x, N=N, factor=factor, to_x=sense * to_x, to_factor=sense * to_factor)

    def ahead(self, at: Point, s: float, near: tuple[float, Point] | None = None) -> Point | None:
        """The point at distance s along the path, or None if the correction does not converge.

        near : a point at another distance from `at` to begin from.
        """
        start, one = near or (0.0, at)
        x, N, factor = one.x.copy(), one.N.copy(), one.factor + (s - start) * one.to_factor
        x.reshape(-1)[self.free] += (s - start) * one.to_x
        return self._corrected(at, x, N, factor, s)

    def _corrected(self, at: Point, x: NDArray[np.float64], N: NDArray[np.float64], factor: float, s: float) -> Point | None:
        best = (np.inf, x, N, factor)
        for step in range(ITERATIONS):
            g, phi = self._errors(x, N, factor)
            moved = (x - at.x).reshape(-1)[self.free]
            off = float(at.to_x @ moved) / self.span**2 + at.to_factor * (factor - at.factor) / self.unit**2 - s
            size = self._size(x, N, factor)
            left = max(float(np.abs(g).max(initial=0.0)) / size, float(np.abs(phi).max(initial=0.0)) / self.span, abs(off))
            if not np.isfinite(left) or (step > 3 and left > 1e3):
                return None
            if left <= 1e-15 or (left >= 0.5 * best[0] and best[0] < max(NEAR, self._floor(x, N, factor, size))):
                # next to a bifurcation the matrix is nearly singular, and a further step may spoil the last one
                _, x, N, factor = min(best, (left, x, N, factor), key=lambda one: one[0])
                N = self.rows.shared(constraint_jacobian(self.system, x)[:, self.free], N)
                to_x, to_factor = self._along(x, N, at.to_x, at.to_factor)
                return Point(x=x, N=N, factor=factor, to_x=to_x, to_factor=to_factor, steps=step)
            best = min(best, (left, x, N, factor), key=lambda one: one[0])
            solve = self._bordered(x, N, factor, at.to_x, at.to_factor)
            if solve is None:
                return None
            change = solve(np.concatenate([g, -phi, [-off]]))
            count = len(self.free)
            x = x.copy()
            x.reshape(-1)[self.free] += change[:count]
            N = N + change[count:-1]
            factor += float(change[-1])
        return None

    def _errors(self, x: NDArray[np.float64], N: NDArray[np.float64], factor: float) -> tuple[Any, Any]:
        """Forces out of balance (f,) N, and errors of rows (rows,) m."""
        g = self.loaded(factor).applied(x)
        if len(N):
            g = g - constraint_jacobian(self.system, x).T @ N
        return g[self.free], row_errors(self.system, x, self.wanted)

    def _floor(self, x: NDArray[np.float64], N: NDArray[np.float64], factor: float, size: float) -> float:
        """Residual forces by round-off of the positions alone, as a fraction of the largest force."""
        if not self.largest:
            self.largest = float(np.abs(self.loaded(factor).stiffness(x, N).data).max(initial=0.0))
        return ROUND_OFF * self.largest * float(np.abs(x).max()) / size

    def _size(self, x: NDArray[np.float64], N: NDArray[np.float64], factor: float) -> float:
        parts = (self.balance.force, factor * self.push, N, self.balance.tension(x), self.balance.push, self.balance.pushing(x))
        return max(float(np.abs(part).max(initial=0.0)) for part in parts) or 1.0

    def _along(
        self, x: NDArray[np.float64], N: NDArray[np.float64], to_x: NDArray[np.float64], to_factor: float
    ) -> tuple[NDArray[np.float64], float]:
        """The unit tangent with a positive component along the last one."""
        solve = self._bordered(x, N, 0.0, to_x, to_factor)
        if solve is None:
            return to_x, to_factor
        right = np.zeros(len(self.free) + len(N) + 1)
        right[-1] = 1.0
        found = solve(right)
        new_x, new_factor = found[: len(self.free)], float(found[-1])
        size = np.sqrt(float(new_x @ new_x) / self.span**2 + new_factor**2 / self.unit**2)
        return new_x / size, new_factor / size

    def _bordered(
        self, x: NDArray[np.float64], N: NDArray[np.float64], factor: float, to_x: NDArray[np.float64], to_factor: float
    ) -> Any:
        """Solver of [[K, J^T, -F], [J, 0, 0], [t_x, 0, t_l]] for right sides in N, m and steps; None if singular.

        All quantities are scaled by the size of the structure, its stiffness and the unit of the factor.
        """
        free, kept = self.free, self.rows.kept
        whole = self.loaded(factor).stiffness(x, N)
        self.largest = float(np.abs(whole.data).max(initial=0.0))
        small = len(free) + len(kept) < DENSE
        K = whole.toarray()[np.ix_(free, free)] if small else whole[free][:, free]
        J = constraint_jacobian(self.system, x)
        J = J.toarray()[np.ix_(kept, free)] if small else J[:, free][kept]
        # never less than at the start of the path: at a limit point with one degree of freedom, K is 0
        stiff = self.stiff = max(self.stiff, float(np.abs(K if small else K.data).max(initial=0.0))) or 1.0
        F = self.push[free] * self.unit / (stiff * self.span)
        count, rows = len(free), len(kept)
        border = np.concatenate([to_x / self.span, np.zeros(rows), [to_factor / self.unit]])
        if small:
            matrix = np.zeros((count + rows + 1,) * 2)
            matrix[:count, :count] = K / stiff
            matrix[count:-1, :count] = J
            matrix[:count, count:-1] = matrix[count:-1, :count].T
            matrix[:count, -1], matrix[-1] = -F, border
            solve = steady_solver(matrix)
        else:
            column = csr_array(np.concatenate([-F, np.zeros(rows)])[:, None])
            core = block_array([[K / stiff, J.T], [J, None]]) if rows else K / stiff
            last = csr_array(border[None, -1:])
            solve = sparse_solver(csc_array(block_array([[core, column], [csr_array(border[None, :-1]), last]])))
        if solve is None:
            return None
        places = np.concatenate([np.arange(count), count + kept, [count + len(N)]])
        into = np.concatenate([np.full(count, 1 / (stiff * self.span)), np.full(rows, 1 / self.span), [1.0]])
        out = np.concatenate([np.full(count, self.span), np.full(rows, stiff * self.span), [self.unit]])

        def solved(right: NDArray[np.float64]) -> NDArray[np.float64]:
            found = np.zeros(len(right))
            found[places] = solve(into * right[places]) * out
            return found

        return solved
