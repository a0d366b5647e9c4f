"""All assembly modes of a structure with given drives: its unknown coordinates, and all solutions of their rows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.structure.structure import ANGLE, LENGTH
from kinetruss.kinematics.homotopy import Quadratics, carry, generic, polished, solve_all
from kinetruss.kinematics.jacobians import singularity_at
from kinetruss.kinematics.known_platform import all_places, known_platform
from kinetruss.kinematics.positions import _row_of as row_of, given_lengths
from kinetruss.mechanics import RIGID, System, block_triangular, compile
from kinetruss.mechanics.positions import row_values
from kinetruss.mechanics.rows import matching
from kinetruss.model import Model
from kinetruss.results import variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray


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


# Nodes that rigid bars join to bodies, and every node as a linear function of few unknowns.

FLAT = 1e-6
"""Nodes of a group within this fraction of its size from a plane count as lying in it."""


@dataclass(frozen=True, eq=False)
class Group:
    """Nodes of one body. basis : nodes with unknown positions; maps (nodes, 3, 3 basis) : position of each node from them, or
    NaN for nodes out of the plane of three basis nodes, which follow from the handedness of the body.
    """

    nodes: tuple[int, ...]
    basis: tuple[int, ...]
    maps: NDArray[np.float64]


def rigid_groups(system: System, outside: NDArray[np.bool_]) -> list[Group]:
    """Groups that start as triangles of rigid bars and grow by nodes joined to three of their nodes (two in the plane).

    outside (n,) : nodes that are used outside their group (by other bars, supports, drives).
    """
    near = _neighbours(system)
    found: list[set[int]] = []
    for i, j, k in _triangles(near):
        if any({i, j, k} <= group for group in found) or _size(system, (i, j, k))[1] < 1e-6:
            continue
        found.append(_grown(system, near, {i, j, k}))
    return [one for one in (_group(system, group, outside) for group in found) if one is not None]


def _neighbours(system: System) -> list[set[int]]:
    near: list[set[int]] = [set() for _ in system.nodes]
    for m in np.flatnonzero(system.kind == RIGID):
        near[system.p[m]].add(int(system.q[m]))
        near[system.q[m]].add(int(system.p[m]))
    return near


def _triangles(near: list[set[int]]) -> list[tuple[int, int, int]]:
    return [
        (i, j, k) for i in range(len(near)) for j, k in combinations(sorted(n for n in near[i] if n > i), 2) if k in near[j]
    ]


def _grown(system: System, near: list[set[int]], group: set[int]) -> set[int]:
    """The group with all nodes that are joined to `dim` of its nodes, not on one line."""
    while True:
        hung = [n for n in range(len(near)) if n not in group and _hangs(system, near[n] & group)]
        if not hung:
            return group
        group = group | set(hung)


def _hangs(system: System, others: set[int]) -> bool:
    """True if distances from these nodes fix a position up to a reflection."""
    return any(_size(system, some)[system.dim - 2] > 1e-6 for some in combinations(sorted(others), system.dim))


def _size(system: System, nodes: Any) -> NDArray[np.float64]:
    """Singular values of the nodes' places about their middle, over the largest; three of them."""
    at = system.x0[list(nodes)]
    values = np.linalg.svd(at - at.mean(axis=0), compute_uv=False)
    full = np.zeros(3)
    full[: len(values)] = values[:3]
    return np.asarray(full / max(full[0], 1e-300))


def _group(system: System, group: set[int], outside: NDArray[np.bool_]) -> Group | None:
    """Basis and maps of a group; None if its nodes are on one line."""
    nodes = tuple(sorted(group))
    needed = [n for n in nodes if outside[n]] or list(nodes)
    count = 2 if system.dim == 2 else 3
    if system.dim == 3 and len(needed) > 3 and _size(system, needed)[2] > FLAT:
        count = 4
    pool = needed if len(needed) >= count else list(nodes)
    basis = max(combinations(pool, count), key=lambda some: (_volume(system, some), -sum(some)))
    if _volume(system, basis) < 1e-6:
        return None
    return Group(nodes, basis, np.array([_map(system, n, basis) for n in nodes]))


def _volume(system: System, nodes: tuple[int, ...]) -> float:
    """Product of the singular values of the edges from the first node, over the size to that power."""
    edges = system.x0[list(nodes[1:])] - system.x0[nodes[0]]
    values = np.linalg.svd(edges, compute_uv=False)
    return float(np.prod(values / max(values[0], 1e-300)))


def _map(system: System, node: int, basis: tuple[int, ...]) -> NDArray[np.float64]:
    """Linear map (3, 3 k) from the positions of the basis to that of a node; NaN if the node is not in their span."""
    k, at = len(basis), system.x0[list(basis)]
    if system.dim == 2:  # a similarity of the plane: p + a d + b J d
        d, r = at[1] - at[0], system.x0[node] - at[0]
        a, b = (d @ r) / (d @ d), (d[0] * r[1] - d[1] * r[0]) / (d @ d)
        turn = np.array([[a, -b, 0], [b, a, 0], [0, 0, a]])
        return np.hstack([np.eye(3) - turn, turn])
    A = np.vstack([at.T, np.ones(k)])
    share, *_ = np.linalg.lstsq(A, np.append(system.x0[node], 1.0), rcond=None)
    if np.linalg.norm(A @ share - np.append(system.x0[node], 1.0)) > FLAT * np.linalg.norm(at - at[0]):
        return np.full((3, 3 * k), np.nan)
    return np.asarray(np.kron(share, np.eye(3)), float)


# All assembly modes of a structure with given drives.

LARGEST_BLOCK = 12
"""Largest number of quadratic equations that are solved together: 4,096 paths."""
REAL = 1e-7
"""Solutions with imaginary parts below this fraction of the size of the structure are real."""
CLOSED = 1e-8
"""Tolerance of a row as a fraction of its length."""


@one_thread
def assembly_modes(model: Model, lengths: Mapping[str, float] | None = None, *, most: int = 1000) -> xr.Dataset:
    """All configurations that a structure can have with given drives, not only the one that is connected to its start.

    Parameters
    ----------
    lengths : member or drive name -> value, m or rad, as in `assemble`; by default as in the model.
    most : configurations at which to stop.

    Returns
    -------
    Dataset. ``position`` (mode, node, axis) m; ``distance`` (mode): root mean square distance of the nodes from the model's own
    configuration, m, by which the modes are sorted; ``singularity`` (mode): distance from a singular position, as
    `Motion.singularity`. attrs: ``complex_solutions`` of each block of equations, ``lost``: paths that could not be followed
    to their end (0: the list is complete, with probability one).

    Raises
    ------
    InputError : a structure that can move with its drives held, blocks of more than 12 quadratic equations, drives other than
        lengths, node coordinates and angles in the plane. AnalysisError : more than `most`.

    Notes
    -----
    Bodies of rigid bars keep their handedness. Their inner bars are left out, and the remaining equations split into blocks (a
    Stewart-Gough platform with joints in a plane is one of nine quadratics, 40 complex solutions at most: M. Raghavan 1993; a
    half bay is one of nine). A body on six legs is solved by 40 paths from a generic platform whose poses are stored (see
    `known_platform`). Any other block is solved once for generic complex data by following all 2^n paths (see `homotopy`),
    then continued to the real data by as many paths as it has solutions.

    >>> import kinetruss as kt
    >>> two = kt.Model(nodes={"A": (0, 0), "B": (4, 0), "C": (2, 1)}, fixed=["A", "B"], bars={"a": ("A", "C"), "b": ("B", "C")})
    >>> kt.kinematics.assembly_modes(two).position.sel(node="C").values.round(9).tolist()
    [[2.0, 1.0], [2.0, -1.0]]
    """
    system = compile(model)
    wanted = _wanted(system, given_lengths(lengths))
    groups = rigid_groups(system, _outside(system))
    layout = Layout(system, groups)
    equations = layout.equations(wanted)
    scale = float(np.mean(wanted[system.row_kind == LENGTH])) if len(wanted) else 1.0
    states = [np.zeros(len(layout.unknown))]
    counts, lost = [], 0
    for rows, columns in _blocks(equations):
        body = layout.body_of(columns)
        found = None if body is None else _platform(equations, rows, columns, states, scale, system.x0[body] / scale)
        states, count, missed = found or _solved(equations, rows, columns, states, scale)
        counts.append(count)
        lost += missed
        if len(states) > most:
            raise AnalysisError(f"More than {most} configurations. Ask for fewer bays at once, or raise most.", None)
    return _dataset(system, layout, [layout.places(one) for one in states], wanted, counts, lost)


def _platform(
    equations: Equations, rows: Any, columns: Any, states: list[NDArray[np.float64]], scale: float, points: NDArray[np.float64]
) -> tuple[list[NDArray[np.float64]], int, int] | None:
    """Like `_solved`, for a body on six legs; None if the block is not one, or has fewer solutions."""
    grown = []
    for state in states:
        block = _block(equations, rows, columns, state, scale)
        if (u := all_places(block, points)) is None:
            return None
        for one in polished(block, u[np.abs(u.imag).max(axis=1) < REAL].real).real:
            grown.append(state.copy())
            grown[-1][columns] = one * scale
    return grown, len(known_platform()[1]), 0


def _solved(
    equations: Equations, rows: Any, columns: Any, states: list[NDArray[np.float64]], scale: float
) -> tuple[list[NDArray[np.float64]], int, int]:
    """Every state with every real solution of one block inserted; the number of complex solutions of the block; lost paths."""
    if not states:
        return [], 0, 0
    outer = np.delete(equations.D[rows], columns, axis=2)  # rows between unknowns of the block alone keep their d = 0
    apart = np.any(outer != 0, axis=(1, 2)) | np.any(equations.d[rows] != 0, axis=1)
    family = generic(_block(equations, rows, columns, states[0], scale), apart)
    known = solve_all(family)
    lost, grown = known.lost, []
    for state in states:
        found = carry(_block(equations, rows, columns, state, scale), family, known.u)
        lost += found.lost
        for u in found.u[np.abs(found.u.imag).max(axis=1, initial=0) < REAL].real:
            grown.append(state.copy())
            grown[-1][columns] = u * scale
    return grown, len(known.u), lost


def _wanted(system: System, lengths: Mapping[str, float]) -> NDArray[np.float64]:
    """Values of the rows; refuses rows that are neither lengths nor angles in the plane."""
    if np.any((system.row_kind != LENGTH) & (system.row_kind != ANGLE)) or (
        system.dim == 3 and np.any(system.row_kind == ANGLE)
    ):
        raise InputError("Only lengths, node coordinates and angles in the plane can be held here. Drive lengths instead.")
    wanted = system.row_value.copy()
    driven = system.row_drive >= 0
    wanted[driven] = system.drive_start[system.row_drive[driven]]
    for name, value in lengths.items():
        row = row_of(system, name)
        if system.row_kind[row] == LENGTH and value <= 0:
            raise InputError(f"lengths[{name!r}] is {value:g}. Give a value of a length above 0 m.")
        wanted[row] = value
    return wanted


def _outside(system: System) -> NDArray[np.bool_]:
    """Nodes used outside the rigid bars of one body: ends of other rows than rigid lengths, prescribed coordinates."""
    found: NDArray[np.bool_] = np.any(system.prescribed.reshape(-1, 3)[:, : system.dim], axis=1)
    rest = (system.row_drive >= 0) | (system.row_kind != LENGTH)
    for ends in (system.p, system.q):
        found[ends[system.row_member[rest]]] = True
    return found


def _blocks(equations: Equations) -> list[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """Rows and columns of square blocks, each depending on earlier ones only; unused rows are checked at the end."""
    from scipy.sparse import csr_array

    touches = np.any(equations.D != 0, axis=1)
    row_of_column = matching(csr_array(touches.T))
    if np.any(row_of_column < 0):
        raise InputError("The structure can move with its drives held, so it has infinitely many configurations. Add drives.")
    found = []
    for mine, columns in block_triangular(csr_array(touches[row_of_column])) or []:
        rows = row_of_column[mine]
        quadratic = int((~equations.linear[rows]).sum())
        if quadratic > LARGEST_BLOCK:
            raise InputError(
                f"{quadratic} quadratic equations are coupled here, more than the {LARGEST_BLOCK} that can be solved at "
                f"once. Hold more of the structure, or take it apart."
            )
        found.append((rows, np.array(columns)))
    return found


def _block(equations: Equations, rows: Any, columns: Any, state: NDArray[np.float64], scale: float) -> Quadratics:
    """One block with known values inserted; lengths over a scale."""
    known = state.copy()
    known[columns] = 0.0
    d = (equations.d[rows] + equations.D[rows] @ known) / scale
    return Quadratics(
        D=equations.D[np.ix_(rows, range(3), columns)],
        d=d,
        s=(equations.value[rows] / scale) ** 2,
        normal=equations.normal[rows],
        linear=equations.linear[rows],
    )


def _dataset(
    system: System, layout: Layout, places: list[NDArray[np.float64]], wanted: NDArray[np.float64], counts: list[int], lost: int
) -> xr.Dataset:
    """Configurations that satisfy all rows and keep the handedness of every body, the nearest to the model's own first."""
    length = system.row_kind == LENGTH
    good = []
    for x in places:
        off = row_values(system, x) - wanted
        off = np.where(length, off / np.maximum(wanted, 1e-300), np.abs(np.exp(1j * off) - 1))
        if np.abs(off).max(initial=0.0) < CLOSED and _same_hand(system, layout, x):
            good.append(x)
    distance = np.array([np.sqrt(np.mean(np.sum((x - system.x0) ** 2, axis=1))) for x in good])
    order = np.argsort(distance, kind="stable")
    position = np.array(good).reshape(-1, len(system.nodes), 3)[order][:, :, : system.dim]
    gauge = singularity_at(system, np.array(good).reshape(len(good), -1)[order])
    data = {
        "position": variable(("mode", "node", "axis"), position, "m", "node position"),
        "distance": variable(("mode",), distance[order], "m", "root mean square distance from the model's configuration"),
        "singularity": variable(("mode",), gauge, "", "distance from a singular position"),
    }
    coords = {"mode": np.arange(1, len(good) + 1), "node": list(system.nodes), "axis": ["x", "y", "z"][: system.dim]}
    return xr.Dataset(data, coords=coords, attrs={"kind": "assembly_modes", "complex_solutions": counts, "lost": lost})


def _same_hand(system: System, layout: Layout, x: NDArray[np.float64]) -> bool:
    """True if no body of four basis nodes is mirrored."""
    for group in layout.groups:
        if len(group.basis) == 4:
            index = list(group.basis)
            now, start = (float(np.linalg.det(y[index[1:]] - y[index[0]])) for y in (x, system.x0))
            if now * start <= 0:
                return False
    return True
