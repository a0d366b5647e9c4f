"""The proof of an optimum to first order: Kuhn-Tucker conditions with multipliers that are found apart from the solver.

At a least value f with limits g <= 0 and bounds, grad f + sum m_i grad g_i + bounds = 0 with m >= 0 and m_i g_i = 0 (Karush
1939; Kuhn and Tucker 1951). The multipliers are those that leave the least residual, by non-negative least squares over the
limits that are reached (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23). They say what each limit costs:
f changes by -m_i per unit of the size of limit i (Haftka and Gurdal 1992, section 5.4).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import nnls

from kinetruss.design.optimum.evaluations import FEASIBLE, Evaluations

if TYPE_CHECKING:
    from numpy.typing import NDArray

REACHED = 1e-4
"""A limit with less than this left, of its size, counts as reached."""
OF_A_FAMILY = 8
"""At most so many rows of a family are looked at: neighbouring instants say the same."""
FIRST_ORDER = 1e-3
"""Largest residual at which the conditions count as fulfilled."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Active:
    """A limit (`row`) or a bound of a variable (`variable`, `side` -1 lower, 1 upper) that is reached.

    multiplier : by how much the objective falls for a unit of the limit or bound, in its own unit. left : of its size.
    """

    row: int = -1
    variable: int = -1
    side: int = 0
    multiplier: float = 0.0
    left: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate:
    """What is proven of a point.

    residual : |grad f + sum m grad g| in variables that go from 0 to 1, of |grad f| or of |f|, the larger. excess : the largest
    of all limits, of their sizes. complementarity : the largest m |g|/f. active : limits and bounds reached, the dearest first.
    """

    residual: float
    excess: float
    complementarity: float
    active: tuple[Active, ...]

    @property
    def feasible(self) -> bool:
        """Whether all limits are kept."""
        return self.excess <= FEASIBLE

    @property
    def first_order(self) -> bool:
        """Whether the conditions hold."""
        return self.feasible and self.residual <= FIRST_ORDER


def certificate(asked: Evaluations, p: NDArray[np.float64]) -> Certificate:
    """The Kuhn-Tucker conditions at a point p (n,)."""
    problem = asked.problem
    objective, excess = asked.values(p)
    rows = worst_of_families(excess, problem.family, REACHED)
    rows = rows[np.argsort(-excess[rows], kind="stable")]  # of instants that say the same the worst is taken
    slope_f, slope_g = asked.gradients(p, rows)
    z = problem.scaled(p)
    low, high = np.flatnonzero(z < REACHED**2), np.flatnonzero(z > 1 - REACHED**2)
    identity = np.eye(len(problem))
    columns = np.concatenate([slope_g, -identity[low], identity[high]]).T
    size = max(float(np.linalg.norm(slope_f)), abs(objective)) or 1.0
    length = np.linalg.norm(columns, axis=0)
    length[length == 0] = 1.0
    multiplier = np.zeros(columns.shape[1])
    if columns.shape[1]:
        multiplier = nnls(columns / length, -slope_f / size)[0] * size / length
    residual = float(np.linalg.norm(slope_f + columns @ multiplier)) / size
    by_bound = problem.slope(p)
    found = [
        Active(row=row, multiplier=float(m) / problem.limits[row].size, left=float(-excess[row]))
        for row, m in zip(rows.tolist(), multiplier, strict=False)
    ]
    sides = [*((k, -1) for k in low.tolist()), *((k, 1) for k in high.tolist())]
    found += [
        Active(variable=k, side=side, multiplier=float(m) / by_bound[k])
        for (k, side), m in zip(sides, multiplier[len(rows) :], strict=True)
    ]
    weight = {id(one): m for one, m in zip(found, multiplier, strict=True)}
    found.sort(key=lambda one: -weight[id(one)])
    lost = float(np.max(multiplier[: len(rows)] * np.abs(excess[rows]), initial=0.0))
    return Certificate(
        residual=residual,
        excess=float(excess.max(initial=-np.inf)),
        complementarity=lost / (abs(objective) or 1.0),
        active=tuple(found),
    )


def worst_of_families(excess: NDArray[np.float64], families: NDArray[np.int64], near: float) -> NDArray[np.int64]:
    """Of every family the rows (k,) with the largest excess that have less than `near` left, in their order."""
    chosen = np.flatnonzero(excess > -near)
    order = chosen[np.lexsort((-excess[chosen], families[chosen]))]
    first = np.flatnonzero(np.diff(families[order], prepend=-1))
    place = np.arange(len(order)) - np.repeat(first, np.diff(np.append(first, len(order))))
    return np.sort(order[place < OF_A_FAMILY])
