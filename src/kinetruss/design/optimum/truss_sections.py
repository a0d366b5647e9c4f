"""The lightest choice of sections of an elastic truss, proven by branch and bound over its redundant forces.

With the redundant forces r of every load case known, all bar forces f = f0 + B r are, and everything else is linear in the
reciprocal areas y of the sections chosen: elongations f y l/E, their compatibility B^T (f y l/E) = 0, displacements by virtual
forces. In a box of r the products f y are bounded by their planes (McCormick, Math. Program. 10 (1976) 147), which close as the
box shrinks; the choice of sections is a linear program with whole numbers (after Rasmussen and Stolpe, Struct. Multidiscip.
Optim. 35 (2008) 517, who bound the products by displacements). So for every box there is a lower bound of the mass: boxes above
the best design known are dropped, sections whose reduced cost is above it too, the others halved, and small ones solved in
whole numbers (HiGHS). What is known when no box is left is the lightest of all combinations. Two redundants under one load
case take seconds; the boxes have as many dimensions as redundants times load cases.
"""

from __future__ import annotations

import heapq
import itertools
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import scipy.sparse as sp
from scipy.linalg import null_space, qr
from scipy.optimize import Bounds, LinearConstraint, linprog, milp

if TYPE_CHECKING:
    from numpy.typing import NDArray

KEPT = 1e-9
"""A limit may be exceeded by so much of itself: round-off."""
BETTER = 1e-6
"""Share of its mass by which another design must be lighter to count."""
SMALL = 0.02
"""Width of a box, of the largest load, from which on it is solved in whole numbers."""


NARROW = 1e-7
"""Width of a box below which halving it tells nothing more."""


@dataclass(frozen=True, kw_only=True, eq=False)
class SectionTask:
    """A truss of m bars in g groups with n degrees of freedom.

    directions : (m, n), elongations over displacements. stretch : (m,) l/E. loads : (cases, n). group : (m,).
    areas, costs : of each group (sections,), the area and what the whole group of that section costs.
    pull, push : of each bar (sections of its group,), the largest tension and compression allowed, N.
    measures : (q, n), displacements with limits; least, most : (q,).
    """

    directions: NDArray[np.float64]
    stretch: NDArray[np.float64]
    loads: NDArray[np.float64]
    group: NDArray[np.int64]
    areas: Sequence[NDArray[np.float64]]
    costs: Sequence[NDArray[np.float64]]
    pull: Sequence[NDArray[np.float64]]
    push: Sequence[NDArray[np.float64]]
    measures: NDArray[np.float64]
    least: NDArray[np.float64]
    most: NDArray[np.float64]

    def cost(self, choice: NDArray[np.int64]) -> float:
        """Of sections chosen by number (groups,)."""
        return float(sum(costs[k] for costs, k in zip(self.costs, choice, strict=True)))

    def used(self, choice: NDArray[np.int64]) -> float:
        """The largest utilisation of sections chosen by number (groups,); 1 at a limit. By the stiffness method."""
        area = np.array([self.areas[g][choice[g]] for g in self.group])
        stiffness = (self.directions.T * (area / self.stretch)) @ self.directions
        u = np.linalg.solve(stiffness, self.loads.T).T
        force = (u @ self.directions.T) * (area / self.stretch)
        pull = np.array([self.pull[i][choice[g]] for i, g in enumerate(self.group)])
        push = np.array([self.push[i][choice[g]] for i, g in enumerate(self.group)])
        moved = u @ self.measures.T
        middle, half = 0.5 * (self.least + self.most), 0.5 * (self.most - self.least)
        by = (force / pull, -force / push, np.abs(moved - middle) / half)
        return float(max(one.max(initial=0.0) for one in by))

    @cached_property
    def redundants(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """f0 (cases, m) and B (m, k) of f = f0 + B r; r are the forces of some bars."""
        particular = np.linalg.lstsq(self.directions.T, self.loads.T, rcond=None)[0].T
        kernel = null_space(self.directions.T)
        if kernel.shape[1] == 0:
            return np.asarray(particular), np.asarray(kernel)
        chosen = np.sort(qr(kernel.T, pivoting=True)[2][: kernel.shape[1]])
        basis = kernel @ np.linalg.inv(kernel[chosen])
        return np.asarray(particular - particular[:, chosen] @ basis.T), np.asarray(basis)


@dataclass(frozen=True, kw_only=True, eq=False)
class Proof:
    """The lightest choice (groups,) that was found, its cost, and what is proven.

    bound : no design costs less. gap : (cost - bound)/cost, 0 if closed: within `BETTER`. boxes, programs : linear
    programs, and those in whole numbers. choice is None if no design keeps all limits (closed) or none was found.
    """

    choice: NDArray[np.int64] | None
    cost: float
    bound: float
    boxes: int
    programs: int
    seconds: float
    stopped: str = ""

    @property
    def gap(self) -> float:
        """0: nothing lighter exists."""
        return max(0.0, (self.cost - self.bound) / self.cost) if self.choice is not None else float("nan")

    @property
    def closed(self) -> bool:
        """Whether the answer is proven."""
        return not self.stopped


class _Node(NamedTuple):
    bound: float
    number: int
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    allowed: NDArray[np.bool_]


class _Program(NamedTuple):
    A: Any
    b: NDArray[np.float64]
    bounds: NDArray[np.float64]
    allowed: NDArray[np.bool_]


def lightest(
    task: SectionTask,
    start: NDArray[np.int64] | None = None,
    seconds: float = 600.0,
    told: Callable[[int, float, float], None] | None = None,
) -> Proof:
    """The lightest choice of sections that keeps all limits in all load cases.

    start : a choice that keeps them, if one is known. seconds : after which it stops with the gap that is left; Ctrl-C stops it
    too. told : called with boxes, cost of the best design and bound.
    """
    search = _Search(task, start, seconds, told)
    try:
        search.run()
    except KeyboardInterrupt:
        search.stopped = "interrupted"
    return search.proof()


class _Search:
    """The boxes that are left, in units of the largest load and a middle area."""

    def __init__(self, task: SectionTask, start: Any, seconds: float, told: Any) -> None:
        self.task, self.seconds, self.told = task, seconds, told
        self.began, self.number, self.programs, self.stopped = time.monotonic(), 0, 0, ""
        self.best: NDArray[np.int64] | None = None
        self.heap: list[_Node] = []
        self.force = float(np.abs(task.loads).max()) or 1.0
        areas = np.concatenate(task.areas)
        self.area = float(np.exp(np.log(areas).mean()))
        self.cost = float(sum(one.mean() for one in task.costs))
        self.cut = float(sum(one.max() for one in task.costs)) * (1 + 2 * BETTER)
        self._arrays()
        if start is not None and task.used(start) <= 1 + KEPT:
            self.best, self.cut = np.asarray(start), task.cost(start)

    def _arrays(self) -> None:
        """What all boxes share. Unknowns: x of sections, r of cases, products d = f y of cases and bars."""
        task, count = self.task, len(self.task.loads)
        self.f0, self.B = task.redundants[0] / self.force, task.redundants[1]
        m, k = self.B.shape
        sizes = [len(one) for one in task.areas]
        first = np.concatenate([[0], np.cumsum(sizes)])
        self.columns, self.of = int(first[-1]), np.repeat(np.arange(len(sizes)), sizes)
        self.first = first
        self.y = self.area / np.concatenate(task.areas)
        price = np.concatenate(task.costs) / self.cost
        groups = sp.csr_matrix((np.ones(self.columns), (self.of, np.arange(self.columns))), (len(sizes), self.columns))
        picked = sp.csr_matrix((np.ones(m), (np.arange(m), task.group)), (m, len(sizes)))
        self.reciprocal = (picked @ groups.multiply(self.y)).tocsr()  # (m, columns)
        forces = [np.concatenate([one[i] if j == g else np.zeros(sizes[j]) for j in range(len(sizes))])
                  for one in (task.pull, task.push) for i, g in enumerate(task.group)]  # fmt: skip
        self.allowed_force = sp.csr_matrix(np.array(forces) / self.force)  # (2 m, columns)
        self.pull, self.push = self.allowed_force[:m].toarray(), self.allowed_force[m:].toarray()
        self.objective = np.concatenate([price, np.zeros(count * (k + m))])
        stretch = task.stretch / task.stretch.max()
        zero = sp.csr_matrix
        cases = sp.eye(count)
        self.equal = sp.bmat(
            [[groups, zero((len(sizes), count * k)), zero((len(sizes), count * m))],
             [zero((count * k, self.columns)), zero((count * k, count * k)), sp.kron(cases, sp.csr_matrix(self.B.T * stretch))]]
        ).tocsr()  # fmt: skip
        self.right = np.concatenate([np.ones(len(sizes)), np.zeros(count * k)])
        virtual = np.linalg.lstsq(task.directions.T, task.measures.T, rcond=None)[0].T  # (q, m): forces under unit loads
        size = np.maximum(np.abs(task.least), np.abs(task.most))
        unit = self.force * task.stretch.max() / self.area
        rows = sp.kron(cases, sp.csr_matrix((virtual * stretch) * (unit / size)[:, None]))
        lead = zero((rows.shape[0], self.columns + count * k))
        self.moved = sp.vstack([sp.hstack([lead, rows]), sp.hstack([lead, -rows])])
        self.moved_most = np.concatenate([np.tile(task.most / size, count), np.tile(-task.least / size, count)])

    def program(self, low: NDArray[np.float64], high: NDArray[np.float64], allowed: NDArray[np.bool_]) -> _Program | None:
        """The linear program of a box low <= r <= high (cases, k); None if it holds no design."""
        m, count = len(self.B), len(self.f0)
        ends = self.B[None] * low[:, None, :], self.B[None] * high[:, None, :]
        least, most = self.f0 + np.minimum(*ends).sum(-1), self.f0 + np.maximum(*ends).sum(-1)
        # sections that cannot bear the least force of a bar
        allowed = allowed.copy()
        for i, g in enumerate(self.task.group):
            own = slice(self.first[g], self.first[g + 1])
            allowed[own] &= self.pull[i, own] >= least[:, i].max() - KEPT
            allowed[own] &= self.push[i, own] >= -most[:, i].min() - KEPT
        if not all(allowed[a:b].any() for a, b in itertools.pairwise(self.first)):
            return None
        y = [self.y[a:b][allowed[a:b]] for a, b in itertools.pairwise(self.first)]
        y_low, y_high = (np.array([f(y[g]) for g in self.task.group]) for f in (np.min, np.max))
        blocks, right = [], []
        for c in range(count):
            for sign, y_at, f_at in ((1, y_low, least), (1, y_high, most), (-1, y_high, least), (-1, y_low, most)):
                blocks.append(self._row(c, sp.diags(sign * f_at[c]) @ self.reciprocal, sign * y_at[:, None] * self.B, -sign))
                right.append(sign * y_at * (f_at[c] - self.f0[c]))
            blocks += [self._row(c, -self.allowed_force[:m], self.B, 0), self._row(c, -self.allowed_force[m:], -self.B, 0)]
            right += [-self.f0[c], self.f0[c]]
        free = np.full((count * m, 2), (-np.inf, np.inf))
        bounds = np.concatenate([np.c_[np.zeros(self.columns), allowed], np.c_[low.ravel(), high.ravel()], free])
        return _Program(sp.vstack([*blocks, self.moved]).tocsr(), np.concatenate([*right, self.moved_most]), bounds, allowed)

    def _row(self, case: int, x: Any, r: NDArray[np.float64], d: float) -> Any:
        """Rows of all bars in one case, by their blocks."""
        m, k = self.B.shape
        here = sp.csr_matrix(([1.0], ([0], [case])), (1, len(self.f0)))
        return sp.hstack([x, sp.kron(here, sp.csr_matrix(r)) if k else sp.csr_matrix((m, 0)), sp.kron(here, d * sp.eye(m))])

    def run(self) -> None:
        """Until no box is left."""
        k, count = self.B.shape[1], len(self.f0)
        reach = np.array([[max(a.max(), b.max()) / self.force] for a, b in zip(self.task.pull, self.task.push, strict=True)])
        chosen = [int(np.argmax(np.isclose(self.B, np.eye(k)[j]).all(axis=1))) for j in range(k)]
        r = np.tile(reach[chosen, 0], (count, 1))
        self.push_box(-r, r, np.ones(self.columns, bool))
        while self.heap:
            node = heapq.heappop(self.heap)
            if node.bound > self.limit:
                self.heap.clear()
                break
            if time.monotonic() - self.began > self.seconds:
                heapq.heappush(self.heap, node)
                self.stopped = f"stopped after {self.seconds:.0f} s"
                return
            if self.told is not None:
                self.told(self.number, self.cut, node.bound * self.cost)
            width = node.high - node.low
            if (width.max(initial=0.0) < SMALL or not width.size) and self.in_whole_numbers(node):
                continue
            if width.max(initial=0.0) < NARROW:
                heapq.heappush(self.heap, node)
                self.stopped = "met a design that exceeds a limit by less than round-off"
                return
            at = np.unravel_index(int(width.argmax()), width.shape)
            middle = 0.5 * (node.low[at] + node.high[at])
            upper, lower = node.high.copy(), node.low.copy()
            upper[at] = lower[at] = middle
            self.push_box(node.low, upper, node.allowed)
            self.push_box(lower, node.high, node.allowed)

    @property
    def limit(self) -> float:
        """Scaled cost from which on a design is no better than the best."""
        return self.cut * (1 - BETTER) / self.cost

    def push_box(self, low: NDArray[np.float64], high: NDArray[np.float64], allowed: NDArray[np.bool_]) -> None:
        """Keep a box, with its bound, if it may hold a better design."""
        made = self.program(low, high, allowed)
        if made is None:
            return
        self.number += 1
        found = linprog(
            self.objective, A_ub=made.A, b_ub=made.b, A_eq=self.equal, b_eq=self.right, bounds=made.bounds, method="highs"
        )
        if found.status == 2 or (found.status == 0 and found.fun > self.limit):
            return
        if found.status == 0:  # a section that costs too much by its reduced cost alone is in no better design
            dear = found.fun + found.lower.marginals[: self.columns] > self.limit
            heapq.heappush(self.heap, _Node(found.fun, self.number, low, high, made.allowed & ~dear))
        else:
            heapq.heappush(self.heap, _Node(0.0, self.number, low, high, made.allowed))

    def in_whole_numbers(self, node: _Node) -> bool:
        """Solve a small box; whether it is done with: it holds nothing better than is known now."""
        made = self.program(node.low, node.high, node.allowed)
        if made is None:
            return True
        self.programs += 1
        kept = [LinearConstraint(made.A, -np.inf, made.b), LinearConstraint(self.equal, self.right, self.right),
                LinearConstraint(sp.csr_matrix(self.objective), -np.inf, self.limit)]  # fmt: skip
        found = milp(
            self.objective, constraints=kept, bounds=Bounds(*made.bounds.T),
            integrality=np.arange(len(self.objective)) < self.columns, options={"mip_rel_gap": 0.0, "time_limit": self.seconds},
        )  # fmt: skip
        if found.status == 2:
            return True
        if found.x is not None:
            choice = np.array([int(np.argmax(found.x[a:b])) for a, b in itertools.pairwise(self.first)])
            if self.task.used(choice) <= 1 + KEPT and (self.best is None or self.task.cost(choice) < self.cut):
                self.best, self.cut = choice, self.task.cost(choice)
                # without redundants the program is exact
                return not node.low.size
        return False

    def proof(self) -> Proof:
        """What is known now."""
        open_boxes = min((node.bound * self.cost for node in self.heap), default=self.cut)
        cost = self.cut if self.best is not None else float("inf")
        return Proof(
            choice=self.best, cost=cost, bound=min(cost, open_boxes) if self.heap or self.best is not None else float("inf"),
            boxes=self.number, programs=self.programs, seconds=time.monotonic() - self.began, stopped=self.stopped,
        )  # fmt: skip
