"""What the equations leave open: nodes without mass, and rows that are redundant near the start."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError, few
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics.arrangement import Arrangement, rearrange
from kinetruss.mechanics.measures import flats_of, measured
from kinetruss.mechanics.row_gradients import RANK_TOLERANCE, constraint_jacobian, jacobian
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray


LARGEST = 3000
"""Coupled massless coordinates up to which the check is made; for more it would take longer than the simulation."""


def refuse_massless(system: System, massive: NDArray[np.bool_], x: NDArray[np.float64]) -> None:
    """Raise an InputError that names the massless nodes which rigid and driven bars leave free to move.

    massive (n,) : nodes with a mass; x (n, 3) : positions, m.

    A massless coordinate has no term M a, so its equation is 0 = f - J^T N. A set of k massless coordinates joined by rows
    needs k independent rows; the rank of the rows' gradients decides.
    """
    free = ~system.prescribed.reshape(-1, 3)
    light = np.flatnonzero(free.any(axis=1) & ~massive)
    if not len(light):
        return
    J = constraint_jacobian(system, x).tocsc()
    # rank of J by the coordinates of each set of massless nodes
    for nodes in _joined(system, light):
        columns = [3 * int(i) + c for i in nodes for c in range(3) if free[i, c]]
        if len(columns) > LARGEST:
            continue
        own = J[:, columns]
        loose = _null_direction(own.tocsr()[np.unique(own.indices)].toarray())
        if loose is not None:
            names = _moved(system, columns, loose)
            raise InputError(
                f"{names} no mass, and no rigid bar holds {'it' if names.startswith('Node ') else 'them'} in every direction: "
                "what moves there has no inertia. Give a mass to the node or its bars, or hold it by rigid bars."
            )


def _null_direction(J: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """A direction in which no row changes, or None."""
    _, values, directions = np.linalg.svd(J[np.abs(J).any(axis=1)], full_matrices=True)
    # null vector of J: the last right singular vector
    rank = int(np.sum(values > RANK_TOLERANCE * max(values.max(initial=0.0), 1.0)))
    return directions[-1] if rank < J.shape[1] else None


def _joined(system: System, light: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """Massless nodes, grouped into sets that rows join."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(system.nodes)
    inside = np.zeros(count, bool)
    inside[light] = True
    p, q = system.p[system.row_member], system.q[system.row_member]
    both = inside[p] & inside[q] & (system.row_measure < 0)
    sums = [np.unique(flats_of(system, r) // 3) for r in system.sums]
    pairs = [(one[0], other) for one in (nodes[inside[nodes]] for nodes in sums) for other in one[1:]]
    more = np.array(pairs, np.int64).reshape(-1, 2)
    ends = np.concatenate([p[both], more[:, 0]]), np.concatenate([q[both], more[:, 1]])
    graph = coo_array((np.ones(len(ends[0])), ends), shape=(count, count))
    _, label = connected_components(graph, directed=False)
    return [light[label[light] == k] for k in dict.fromkeys(label[light])]


def _moved(system: System, columns: list[int], direction: NDArray[np.float64]) -> str:
    chosen = [columns[k] // 3 for k in np.argsort(-np.abs(direction)) if abs(direction[k]) > 1e-6]
    inner = system.inner.nodes
    moved = (system.nodes[i] for i in chosen)
    names = list(dict.fromkeys(inner[name].at if name in inner else name for name in moved))
    shown = few([repr(name) for name in names], 4)
    return f"Node {shown} has" if len(names) == 1 else f"Nodes {shown} have"


# Rows that are redundant near the start as well as at it: in a singular position further rows become dependent.

STEPS = 1e-3, 3e-2
"""Distances from the start as fractions of the shortest member; a farther one only if no nearer one could be reached."""
OFF = 0.05
"""Distance that nodes are moved off the closed loops, as a fraction of the shortest member."""
DEPENDENT = 1e-5
"""Singular values below this fraction of the largest, with loops closed, count as dependent rows."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Redundancy:
    """The redundant rows at and near a start configuration.

    arrangement : the one with the fewest redundant rows. sure : a configuration away from the start has as few, so they are
        redundant along the whole motion. bound : some rows are dependent only if the loops are closed (Bennett, Bricard),
            not at arbitrary positions.
    """

    arrangement: Arrangement
    sure: bool = False
    bound: bool = False


def redundant_nearby(system: System) -> Redundancy:
    """The fewest redundant rows at the start, or a small step away along its velocities or any allowed direction."""
    found, sure = rearrange(system, system.x0, None), False
    if not len(found.redundant):
        return Redundancy(arrangement=found)
    directions = _directions(system)
    # rank a little on along the motion: rows that depend on others at the start alone are not redundant
    for step in STEPS:
        for direction in directions:
            x = _closed(system, direction, step)
            if x is not None:
                there = rearrange(system, x, None)
                if len(there.redundant) <= len(found.redundant):
                    found, sure = (there if len(there.redundant) < len(found.redundant) else found), True
        if sure:
            break
    return Redundancy(arrangement=found, sure=sure, bound=_bound(system, len(found.redundant)))


def _bound(system: System, redundant: int) -> bool:
    """True if fewer rows are redundant at positions that do not close the loops."""
    x = system.x0.reshape(-1).copy()
    moved = np.random.default_rng(1).standard_normal(len(system.free))
    x[system.free] += OFF * float(system.length0[system.row_member].min()) * moved
    J = jacobian(system, x.reshape(-1, 3))
    return len(J) - int(np.linalg.matrix_rank(J, tol=RANK_TOLERANCE * np.linalg.norm(J, 2))) < redundant


def _directions(system: System) -> list[NDArray[np.float64]]:
    """Changes (n, 3) of positions that the rows allow, largest 1."""
    free, J = system.free, jacobian(system, system.x0)
    given = system.velocity0.reshape(-1)[free]
    # in a singular position few directions can be followed; that of least weighted change, with weights in a row, is one of
    # them
    ways = [np.random.default_rng(0).standard_normal(len(free))]
    ways += [np.equal(free % 3, axis) * 1.0 for axis in range(system.dim)]
    # projection of each direction onto the null space of J
    along = [(way - np.linalg.lstsq(J, J @ way, rcond=1e-9)[0], 1e-9) for way in ways]
    found = []
    for change, least in ((given, 0.0), *along):
        if (largest := np.abs(change).max(initial=0.0)) > least:
            full = np.zeros(system.x0.size)
            full[free] = change / largest
            found.append(full.reshape(-1, 3))
    return found


def _closed(system: System, direction: NDArray[np.float64], step: float) -> NDArray[np.float64] | None:
    """Positions (n, 3) a small step along a direction, with all constraints closed; None if they cannot be closed."""
    p, q = system.p[system.row_member], system.q[system.row_member]
    wanted = np.linalg.norm(system.x0[q] - system.x0[p], axis=1)
    size, sums = float(wanted.min()), system.sums
    start = [measured(system, system.row_measure[r], system.x0[None])[0, 0] for r in sums]
    x, angle = system.x0 + step * size * direction, system.row_kind == ANGLE
    # Newton's method, least change, for Phi(x) = 0
    for _ in range(30):
        J, d = jacobian(system, x), x[q] - x[p]
        gap = np.linalg.norm(d, axis=1) - wanted
        if angle.any():
            theta = system.drive_start[system.row_drive[angle]]
            gap[angle] = d[angle, 1] * np.cos(theta) - d[angle, 0] * np.sin(theta)
        for r, value in zip(sums, start, strict=True):
            m = system.row_measure[r]
            gap[r] = system.measure_scale[m] * (measured(system, m, x[None])[0, 0] - value)
        if np.abs(gap).max() < 1e-13 * size:
            return x
        x.reshape(-1)[system.free] -= np.linalg.lstsq(J, gap, rcond=DEPENDENT)[0]
    return None
