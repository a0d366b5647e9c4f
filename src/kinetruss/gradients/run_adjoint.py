"""The variation of a motion between two instants, turned round: what the state at the end owes to that at the start.

Small changes of a motion M a + J^T N = f, J a = gamma obey

    dx' = dv,    dv' = a_x dx + a_v dv + a_p dp

with the derivatives of the accelerations from K (a_x; N_x) = -r_x, K = dr/d(a, N), of the residual r. In cells of the time
they are integrated by collocation at Gauss points, of order 2 s (Hairer, Norsett & Wanner, Solving Ordinary Differential
Equations I, 1993, II.7), with the states of the run itself at these points; the transpose of a cell is exact, so that the
gradient is that of the integrated variation. Of a motion without explicit time, l^T (v, a) of the adjoint l does not change:
that measures the error.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import AnalysisError
from kinetruss.gradients.differences import FOUR, TWO
from kinetruss.gradients.nearness import Near, colours
from kinetruss.kernels.solve.adjoint import adjoint_cells

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Points = Sequence[tuple[float, float]]

STAGES = 8
"""Gauss points of a cell."""
NUDGE, LONGER = 1e-5, 1e-4
"""Step of differences by places and velocities, in parts of their size; the error is the square of it. By places of what is
elastic, where that square counts by the stiffness along against that across, those of fourth order take the longer one.
"""
LINEAR = ((1.0, 1.0),)
"""Steps and weights of the difference of a linear function."""
MASSLESS, ROUND_OFF = 1e8, 1e-12
"""Condition of the masses from which on some coordinate has none; change of masses that counts as none."""
LEAK = 1e-9
"""Fraction of a change beyond which it is not near what causes it."""


class States(NamedTuple):
    """Instants (s,) of a run: t; x, v, a (s, 3 n); N (s, rows) of the rows of the equations."""

    t: Floats
    x: Floats
    v: Floats
    a: Floats
    N: Floats

    def part(self, which: Any) -> States:
        """Some of them."""
        return States(*(one[which] for one in self))


class Columns(NamedTuple):
    """Columns by free coordinates that one evaluation finds together: of no two of a group are nodes near both.

    near : of each coordinate. nodes : how many there are.
    """

    groups: list[list[int]]
    near: list[Near]
    nodes: int

    @classmethod
    def of(cls, near: Sequence[Near], count: int) -> Columns:
        """By the nodes near each coordinate."""
        return cls(colours(near, count), [*near], count)

    def found(self, change: Callable[[list[int]], Floats], site: NDArray[np.int64]) -> Iterator[tuple[int, Any, Floats]]:
        """Column, places of values, and the change (.., places) of these; change : of all values (.., m) for a group.

        site (m,) : the node of each value, -1 unknown.
        """
        for group in self.groups:
            moved = change(group)
            if len(group) == 1:
                yield group[0], slice(None), moved
                continue
            label = np.full(self.nodes + 1, -1)  # the last is of what is nowhere
            for j in group:
                label[[*(self.near[j] or ())]] = j
            own = label[site]
            if np.abs(moved[..., own < 0]).sum() > LEAK * np.abs(moved).sum():
                for j in group:
                    yield j, slice(None), change([j])
                continue
            for j in group:
                places = np.flatnonzero(own == j)
                yield j, places, moved[..., places]


@dataclass(frozen=True, eq=False)
class Tangent:
    """Derivatives at instants: rx, rv (s, m', free) of the residual of what is kept, at fixed a and N; M (f, f) or (s, f, f)
    and J (s, rows, f) of M a + J^T N = f, J a = gamma.
    """

    rx: Floats
    rv: Floats
    M: Floats
    J: Floats

    @cached_property
    def inverse(self) -> Floats:
        """That of [M J^T; J 0], (s, m', m'), symmetric."""
        f, r = self.J.shape[2], self.J.shape[1]
        whole = np.zeros((len(self.J), f + r, f + r))
        mass = self.M if self.M.ndim == 2 else self.M[0]
        try:
            if np.linalg.cond(mass) < MASSLESS:
                inverse = np.linalg.inv(self.M)
                W = inverse @ self.J.swapaxes(1, 2)
                S = np.linalg.inv(self.J @ W)
                across = W @ S
                whole[:, :f, :f] = inverse - across @ W.swapaxes(1, 2)
                whole[:, :f, f:], whole[:, f:, :f], whole[:, f:, f:] = across, across.swapaxes(1, 2), -S
                return whole
            # some coordinates have no mass of their own
            whole[:, :f, :f], whole[:, f:, :f], whole[:, :f, f:] = self.M, self.J, self.J.swapaxes(1, 2)
            return np.asarray(np.linalg.inv(whole))
        except np.linalg.LinAlgError:
            raise AnalysisError("The motion passes a singular position, through which it has no gradient.") from None


@dataclass(frozen=True, eq=False)
class Varying:
    """A motion that can be varied.

    residual : (s, m) of states. states : those of the run at instants. free : flat free coordinates. kept : places among the
    residuals and unknowns (a, N) of those that determine the accelerations. columns, site : which nodes are near to what.
    length (free,) : m, what changes of places are compared with. elastic : something is, so that differences are of fourth
    order.
    """

    residual: Callable[[States], Floats]
    free: NDArray[np.int64]
    kept: NDArray[np.int64]
    columns: Columns
    site: NDArray[np.int64]
    length: Floats
    elastic: bool

    def nudged(self, function: Callable[[Floats], Floats], where: Floats, places: Any, step: Floats, points: Points) -> Floats:
        """The change of a function of arrays (s, 3 n) for a step of some places of them; `where` is as before afterwards."""
        kept, found = where[:, places], np.zeros(())
        for share, weight in points:
            where[:, places] = kept + share * step
            found = found + weight * function(where)
        where[:, places] = kept
        return np.asarray(found)

    def tangent(self, at: States) -> Tangent:
        """The derivatives at these instants."""
        count = len(self.free)
        speed = float(np.abs(at.v).max(initial=0.0)) or float(self.length.mean())
        by_x = self._by(at, "x", self.reach * self.length, self.points)
        by_v = self._by(at, "v", np.full(count, NUDGE * speed), TWO)
        size = np.full(count, max(float(np.abs(at.a).max(initial=0.0)), 1.0))
        by_a = self._by(at, "a", size, LINEAR, self.residual(at))
        if len(self.kept) < len(self.site):
            by_x, by_v, by_a = (one[:, self.kept] for one in (by_x, by_v, by_a))
        mass = -by_a[:, :count]
        mass = mass[0] if np.abs(mass - mass[0]).max(initial=0.0) <= ROUND_OFF * np.abs(mass).max(initial=0.0) else mass
        return Tangent(by_x, by_v, mass, by_a[:, count:])

    @property
    def points(self) -> Points:
        """Those of differences by places."""
        return FOUR if self.elastic else TWO

    @property
    def reach(self) -> float:
        """Their step, in parts of lengths."""
        return LONGER if self.elastic else NUDGE

    def _by(self, at: States, name: str, step: Floats, points: Points, less: Floats | float = 0.0) -> Floats:
        """Derivatives (s, m, free) of the residual by places, velocities or accelerations; less : its value, if points lie on
        one side.
        """
        moved = getattr(at, name).copy()

        def change(group: list[int]) -> Floats:
            return self.nudged(
                lambda own: self.residual(at._replace(**{name: own})) - less, moved, self.free[group], step[group], points
            )

        found = np.zeros((len(at.t), len(self.site), len(self.free)))
        for j, places, effect in self.columns.found(change, self.site):
            found[:, places, j] = effect / step[j]
        return found

    def weights(self, at: Tangent, of_a: Floats, of_N: Floats | None = None) -> Floats:
        """z (s, k, m) of K^T z = weights of a (s, k, free) and N (s, k, rows)."""
        count, found = len(self.free), np.zeros((*of_a.shape[:2], len(self.site)))
        both = of_a @ at.inverse[:, :count]
        if of_N is not None:
            both += of_N[:, :, self.kept[count:] - count] @ at.inverse[:, count:]
        both[:, :, :count] *= -1.0
        found[:, :, self.kept] = both
        return found


# Collocation in cells.


class Gauss(NamedTuple):
    """c (s,), b (s,), A (s, s) of collocation at Gauss points, A^2 and b A."""

    c: Floats
    b: Floats
    A: Floats
    twice: Floats
    above: Floats


def gauss(stages: int) -> Gauss:
    """The numbers of collocation.

    >>> gauss(1).c.tolist(), gauss(1).A.tolist()
    ([0.5], [[0.5]])
    """
    points, weights = np.polynomial.legendre.leggauss(stages)
    c, b = (np.asarray(one, float) for one in (0.5 * (1.0 + points), 0.5 * weights))
    powers = np.arange(stages)
    # sum_j A_ij c_j^k = c_i^(k + 1)/(k + 1)
    A = np.linalg.solve((c[None] ** powers[:, None]), (c[:, None] ** (powers + 1) / (powers + 1)).T).T
    return Gauss(c, b, np.asarray(A, float), np.asarray(A @ A, float), np.asarray(b @ A, float))


class Cells(NamedTuple):
    """Transposed cells: back (cells, 2 f, 2 f) of states at the end to those at the start; inner (cells, s f, 2 f): the
    weights of the accelerations at the Gauss points.
    """

    back: Floats
    inner: Floats


def cells_of(at: Tangent, h: Floats, kept: int, scheme: Gauss) -> Cells:
    """The cells of lengths h (cells,), with derivatives at all their Gauss points in order; kept : free coordinates."""
    f, s, count = kept, len(scheme.b), len(h)
    both = np.concatenate([at.rx, at.rv], axis=2)
    both[:, f:] *= -1.0
    solved = at.inverse[:, :f] @ both
    ax, av = (one.reshape(count, s, f, f) for one in (solved[:, :, :f], solved[:, :, f:]))
    h4 = h[:, None, None, None]
    # (1 - D) k = E y0, y1 = P y0 + Q k
    D = np.zeros((count, s, f, s, f))
    for i in range(s):
        for j in range(s):
            D[:, i, :, j] = h4[:, 0] ** 2 * scheme.twice[i, j] * ax[:, i] + h4[:, 0] * scheme.A[i, j] * av[:, i]
    D = np.eye(s * f) - D.reshape(count, s * f, s * f)
    E = np.concatenate([ax, h4 * scheme.c[None, :, None, None] * ax + av], axis=3).reshape(count, s * f, 2 * f)
    Q = np.zeros((count, 2 * f, s, f))
    one = np.arange(f)
    for j in range(s):
        Q[:, one, j, one] = (h**2 * scheme.above[j])[:, None]
        Q[:, f + one, j, one] = (h * scheme.b[j])[:, None]
    inner = np.linalg.solve(D.swapaxes(1, 2), Q.reshape(count, 2 * f, s * f).swapaxes(1, 2))
    back = E.swapaxes(1, 2) @ inner
    back[:, np.arange(2 * f), np.arange(2 * f)] += 1.0
    back[:, f + one, one] += h[:, None]
    return Cells(np.asarray(back, float), np.asarray(inner, float))


def back_through(
    at: Tangent, h: Floats, stages: int, adjoint: Floats, jump: Floats, stiff: bool
) -> tuple[Floats, Floats, Floats]:
    """From the last of cells of lengths h to the first: the adjoints (cells, k, 2 f) at the end and the start of each, and the
    weights (cells, s, k, f) of the accelerations at its Gauss points.

    adjoint (k, 2 f) : at the end. jump (cells, k, 2 f) : what comes to it at the start of each cell. stiff : by matrices of the
    cells. Else the stages follow by simple iteration, which converges where a cell is short against all that vibrates, as the
    steps of explicit methods are.
    """
    f, count, scheme = at.J.shape[2], len(h), gauss(stages)
    later, earlier = np.empty((2, count, *adjoint.shape))
    later[-1] = adjoint
    if not stiff:
        inner, G = np.empty((count, stages, len(adjoint), f)), at.inverse[:, :f].copy()
        G[:, :, :f] *= -1.0
        R = np.concatenate([at.rx, at.rv], axis=2)
        row, column = np.nonzero(np.abs(R).max(axis=0))
        start = np.searchsorted(row, np.arange(R.shape[1] + 1))
        pattern = start, column, np.ascontiguousarray(R[:, row, column])
        left = adjoint_cells(G, pattern, h, tuple(scheme), jump, later, earlier, inner)
        if not left:
            return later, earlier, inner
    cells = cells_of(at, h, f, scheme)
    for c in range(count - 1, -1, -1):
        earlier[c] = later[c] @ cells.back[c].T
        if c:
            later[c - 1] = earlier[c] + jump[c]
    inner = (later @ cells.inner.swapaxes(1, 2)).reshape(count, len(adjoint), stages, f).swapaxes(1, 2)
    return later, earlier, inner


def edges_between(marks: Floats, t: Floats, h: Floats, share: float) -> Floats:
    """Ends of cells from the first of the marks to the last, which all are ends; no cell is longer than a share of the steps.

    t, h : instants of a run and its steps there.

    >>> edges_between(np.array([0.0, 1.0]), np.array([0.0, 1.0]), np.array([0.5, 0.5]), 1.0).tolist()
    [0.0, 0.5, 1.0]
    """
    passed = np.concatenate([[0.0], np.cumsum(np.diff(t) * 0.5 * (1.0 / h[1:] + 1.0 / h[:-1]))]) / share
    found: list[Any] = [marks[:1]]
    for first, last in pairwise(marks.tolist()):
        a, b = np.interp([first, last], t, passed)
        count = max(1, int(np.ceil(b - a - 1e-6)))
        inner = np.interp(np.linspace(a, b, count + 1)[1:-1], passed, t)
        found += [inner, [last]]
    return np.concatenate(found)
