"""Nodes without mass that no constraint determines: the equations of motion leave their accelerations undetermined."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError, few
from kinetruss.mechanics import RANK_TOLERANCE, System, constraint_jacobian, flats_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["refuse_massless"]

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
        loose = _loose(own.tocsr()[np.unique(own.indices)].toarray())
        if loose is not None:
            names = _moved(system, columns, loose)
            raise InputError(
                f"{names} no mass, and no rigid bar holds {'it' if names.startswith('Node ') else 'them'} in every direction: "
                "what moves there has no inertia. Give a mass to the node or its bars, or hold it by rigid bars."
            )


def _loose(J: NDArray[np.float64]) -> NDArray[np.float64] | None:
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
    names = list(dict.fromkeys(system.nodes[i] for i in chosen))
    shown = few([repr(name) for name in names], 4)
    return f"Node {shown} has" if len(names) == 1 else f"Nodes {shown} have"
