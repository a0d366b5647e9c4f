"""Unknown coordinates of a structure with bodies reduced to basis nodes, and its rows over them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels.structure.plan import ANGLE, LENGTH
from kinetruss.kinematics.modes.rigid_groups import Group
from kinetruss.mechanics import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Equations", "Layout"]


@dataclass(frozen=True, eq=False)
class Equations:
    """Rows over unknowns: end difference D u + d, D (rows, 3, unknowns), d (rows, 3); wanted length (rows,); normal (rows, 3)
    of linear ones.
    """

    D: NDArray[np.float64]
    d: NDArray[np.float64]
    value: NDArray[np.float64]
    normal: NDArray[np.float64]
    linear: NDArray[np.bool_]


class Layout:
    """The unknown coordinates u, and the position of every node as M u + c."""

    def __init__(self, system: System, groups: list[Group]) -> None:
        count = len(system.nodes)
        self.system, self.groups = system, groups
        inner = {n for group in groups for n in group.nodes if n not in group.basis}
        basis = {n for group in groups for n in group.basis}
        free = ~system.prescribed.reshape(-1, 3)
        loose = np.array([n in basis or n not in inner for n in range(count)])
        self.unknown = np.flatnonzero((free & loose[:, None]).reshape(-1))
        width = len(self.unknown)
        self.M, self.c = np.zeros((count, 3, width)), np.zeros((count, 3))
        self.M.reshape(3 * count, width)[self.unknown, np.arange(width)] = 1.0
        held = ~np.isin(np.arange(3 * count), self.unknown).reshape(-1, 3)
        self.c[held] = system.x0[held]
        self.ties: list[tuple[int, NDArray[np.float64]]] = []
        placed = basis | {n for n in range(count) if n not in inner} | {n for n in range(count) if not free[n].any()}
        for group in groups:
            for node, one in zip(group.nodes, group.maps, strict=True):
                if node in group.basis or np.isnan(one).any():
                    continue
                if node in placed:  # in two bodies, or fixed: both positions must agree
                    self.ties.append((node, one @ self._stacked(group)))
                else:
                    self._put(node, one, group)
                    placed.add(node)
        self.late = [n for n in range(count) if n not in placed]

    def _stacked(self, group: Group) -> NDArray[np.float64]:
        """Positions of basis nodes as (3 k, unknowns + 1), the constant last."""
        index = list(group.basis)
        return np.hstack([self.M[index].reshape(3 * len(index), -1), self.c[index].reshape(-1, 1)])

    def _put(self, node: int, one: NDArray[np.float64], group: Group) -> None:
        both = one @ self._stacked(group)
        self.M[node], self.c[node] = both[:, :-1], both[:, -1]

    def equations(self, wanted: NDArray[np.float64]) -> Equations:
        """Rows outside bodies, distances of the basis nodes of each body, and equations of nodes that two bodies share."""
        system, late = self.system, set(self.late)
        ends = list(zip(system.p[system.row_member].tolist(), system.q[system.row_member].tolist(), strict=True))
        rows = [r for r in range(len(wanted)) if not set(ends[r]) & late and not self._inside(r, ends[r])]
        barred = {frozenset(ends[r]) for r in rows if system.row_kind[r] == LENGTH}
        pairs = {frozenset(two): two for group in self.groups for two in combinations(group.basis, 2)}
        shapes = [two for key, two in pairs.items() if key not in barred]
        angle = system.row_kind[rows] == ANGLE
        normal = np.zeros((len(rows) + len(shapes), 3))
        normal[: len(rows)][angle, 0], normal[: len(rows)][angle, 1] = -np.sin(wanted[rows][angle]), np.cos(wanted[rows][angle])
        p, q = np.array([*(ends[r] for r in rows), *shapes], np.int64).reshape(-1, 2).T
        kept = [float(np.linalg.norm(system.x0[j] - system.x0[i])) for i, j in shapes]
        linear = np.r_[angle, np.zeros(len(shapes), np.bool_)]
        own = Equations(self.M[q] - self.M[p], self.c[q] - self.c[p], np.r_[wanted[rows], kept], normal, linear)
        return self._tied(own)

    def _tied(self, own: Equations) -> Equations:
        """The equations with those of nodes that two bodies share, one for each coordinate."""
        tied = [(both - np.hstack([self.M[n], self.c[n][:, None]]))[: self.system.dim] for n, both in self.ties]
        lines = np.array(tied).reshape(-1, len(self.unknown) + 1)
        D, d = np.zeros((len(lines), 3, len(self.unknown))), np.zeros((len(lines), 3))
        D[:, 0], d[:, 0] = lines[:, :-1], lines[:, -1]
        first = np.tile([1.0, 0.0, 0.0], (len(lines), 1))
        return Equations(
            D=np.concatenate([own.D, D]),
            d=np.concatenate([own.d, d]),
            value=np.r_[own.value, np.zeros(len(lines))],
            normal=np.concatenate([own.normal, first]),
            linear=np.r_[own.linear, np.ones(len(lines), np.bool_)],
        )

    def _inside(self, r: int, ends: tuple[int, int]) -> bool:
        """True for rows that the shape of a body satisfies: all within it except those between its basis nodes."""
        if self.system.row_drive[r] >= 0 or self.system.row_kind[r] != LENGTH:
            return False
        two = set(ends)
        return any(two <= set(group.nodes) and not two <= set(group.basis) for group in self.groups)

    def body_of(self, columns: NDArray[np.int64]) -> list[int] | None:
        """The basis nodes of a body, ascending, whose coordinates these unknowns are; None if they belong to no body."""
        flats = self.unknown[np.sort(columns)]
        nodes = flats[::3] // 3
        if len(flats) % 3 or not np.array_equal(np.repeat(3 * nodes, 3) + np.tile(np.arange(3), len(nodes)), flats):
            return None
        found: list[int] = nodes.tolist()
        return found if any(sorted(group.basis) == found for group in self.groups) else None

    def places(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """All nodes (n, 3); nodes out of the plane of the three basis nodes of their body by its handedness."""
        x = self.M @ u + self.c
        for group in self.groups:
            late = [n for n in group.nodes if n in self.late]
            if late:
                index = list(group.basis)
                now, start = _frame(x[index]), _frame(self.system.x0[index])
                x[late] = x[index[0]] + (self.system.x0[late] - self.system.x0[index[0]]) @ start.T @ now
        return x


def _frame(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Axes (rows) of the frame of three points."""
    e = points[1] - points[0]
    e = e / np.linalg.norm(e)
    n = np.cross(e, points[2] - points[0])
    n = n / np.linalg.norm(n)
    return np.array([e, np.cross(n, e), n])
