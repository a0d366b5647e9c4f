"""Limits that exclude each other: the smallest set of them that cannot be kept together.

The least largest excess of a set of limits is a problem of its own, with one more variable; a set contradicts itself if that
stays above zero. A filter that leaves out one limit after the other, and takes back those without which the rest can be kept,
ends with an irreducible set (Chinneck and Dravnieks, ORSA J. Computing 3 (1991) 157). Beyond linear problems each answer is
that of a local search.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.design.optimum.evaluations import FEASIBLE, Evaluations
from kinetruss.design.optimum.problem import Limit, Problem, Variable
from kinetruss.design.optimum.solvers import search

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

SPAN = 1e3
"""Largest excess that the search for the least one allows for, of the size of a limit."""


class _Excess:
    """The largest excess of some rows as one more variable, which is made small."""

    def __init__(self, asked: Evaluations, rows: NDArray[np.int64]) -> None:
        self.asked, self.rows = asked, rows

    def values(self, p: NDArray[np.float64], rows: NDArray[np.int64] | None) -> tuple[float, NDArray[np.float64]]:
        chosen = self.rows if rows is None else self.rows[rows]
        return float(p[-1]), self.asked.values(p[:-1], chosen)[1] - p[-1]

    def gradients(self, p: NDArray[np.float64], rows: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        slope = self.asked.problem.slope(p[:-1])
        found = self.asked.gradients(p[:-1], self.rows[rows])[1] / slope
        return np.append(np.zeros(len(p) - 1), 1.0), np.hstack([found, -np.ones((len(found), 1))])


def least_excess(
    asked: Evaluations, rows: NDArray[np.int64], start: NDArray[np.float64], iterations: int = 200
) -> tuple[NDArray[np.float64], float]:
    """The point (n,) with the least largest excess of some limits that a search from `start` finds, and that excess."""
    worst = float(asked.values(start, rows)[1].max())
    top = max(worst, FEASIBLE) * 1.01 + 1e-3
    extra = Variable(name="excess", lower=-1.0, upper=min(top, SPAN), start=min(worst, SPAN))
    labels = [Limit(subject="", family="", limit=0, size=1)] * len(rows)
    problem = Problem(variables=[*asked.problem.variables, extra], limits=labels, function=_Excess(asked, rows))
    inner = Evaluations(problem)
    z, _ = search(inner, np.arange(len(rows)), problem.scaled(np.append(start, extra.start)), "slsqp", iterations, 1e-10)
    found = problem.real(z)[:-1]
    return found, float(asked.values(found, rows)[1].max())


def contradiction(
    asked: Evaluations, start: NDArray[np.float64], rows: NDArray[np.int64]
) -> tuple[list[int], NDArray[np.float64], float]:
    """An irreducible set of limits, by row, that no point within the bounds keeps together; empty if all can be kept. With the
    point that comes nearest to keeping all, and its largest excess.
    """
    nearest, worst = least_excess(asked, rows, start)
    if worst <= FEASIBLE:
        return [], nearest, worst
    excess = asked.values(nearest, rows)[1]
    tight = [int(row) for row, one in zip(rows, excess, strict=True) if one > worst - 1e-3 * (1 + abs(worst))]
    kept = tight if _excluded(asked, nearest, tight) else [int(row) for row in rows]
    for row in list(kept):
        rest = [other for other in kept if other != row]
        if rest and _excluded(asked, nearest, rest):
            kept = rest
    return kept, nearest, worst


def _excluded(asked: Evaluations, start: NDArray[np.float64], rows: Iterable[int]) -> bool:
    return least_excess(asked, np.array(list(rows), np.int64), start)[1] > FEASIBLE
