"""Whether motion and loads alone determine the resultants at a cut of a body, by the equilibrium of rigid bodies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.mechanics import DRIVEN, RANK_TOLERANCE, RIGID, System, ends_of, measure_gradients

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LARGEST", "determined"]

LARGEST = 900
"""Largest number of unknown forces; above it, the null space takes too long."""


class _Column(NamedTuple):
    """Forces (dim,) on nodes by 1 N of an unknown; the body that exerts it on one node, and that node, or none."""

    forces: dict[int, NDArray[np.float64]]
    body: str = ""
    node: int = -1


def determined(system: System, x: NDArray[np.float64], body: str, names: Sequence[str]) -> bool | None:
    """True if force and moment on a body through some of its nodes follow from balance and motion; None beyond `LARGEST`.

    x (n, 3) : positions, m. The unknowns are the forces of every rigid body on each node that it shares, of rigid and driven
    bars outside bodies, and of couplings and hinge drives. The equations are the equilibrium of these nodes and of the bodies.
    The cut is determined if no state of self-stress has a force or moment there.
    """
    dim = system.dim
    columns = list(_columns(system, x))
    if len(columns) > LARGEST:
        return None
    bodies = [name for name, one in system.model.bodies.items() if one.kind == "rigid"]
    place = {name: k for k, name in enumerate(bodies)}
    nodes = sorted({n for forces, _, _ in columns for n in forces})
    row = {n: k for k, n in enumerate(nodes)}
    turns = 1 if dim == 2 else 3
    size = float(np.ptp(x, axis=0).max()) or 1.0
    A = np.zeros((dim * len(nodes) + (dim + turns) * len(bodies), len(columns)))
    wrench = np.zeros((dim + turns, len(columns)))
    for k, (forces, owner, node) in enumerate(columns):
        for n, force in forces.items():
            A[dim * row[n] : dim * (row[n] + 1), k] = force
        if owner:
            force = -forces[node]  # force of the node on the body
            moment = np.cross(_spatial(x[node] / size), _spatial(force))
            both = np.concatenate([force, moment[2:] if dim == 2 else moment])
            first = dim * len(nodes) + (dim + turns) * place[owner]
            A[first : first + dim + turns, k] = both
            if owner == body and system.nodes[node] in names:
                wrench[:, k] = both
    held = system.prescribed.reshape(-1, 3)[:, :dim]
    kept = np.concatenate([~held[np.array(nodes, np.int64)].reshape(-1), np.ones((dim + turns) * len(bodies), bool)])
    _, values, Vt = np.linalg.svd(A[kept])
    stress = Vt[int(np.sum(values > RANK_TOLERANCE * values.max(initial=0.0))) :]
    return bool(np.abs(wrench @ stress.T).max(initial=0.0) < 100 * RANK_TOLERANCE)


def _spatial(y: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.pad(y, (0, 3 - len(y)))


def _columns(system: System, x: NDArray[np.float64]) -> Iterator[_Column]:
    """All unknown forces."""
    model, dim = system.model, system.dim
    own = {name: set(one.nodes) for name, one in model.bodies.items() if one.kind == "rigid"}
    met: dict[int, int] = {}  # number of bodies, bars and other elements at each node
    loose: list[_Column] = []
    for i in range(len(system.members)):
        ends = int(system.p[i]), int(system.q[i])
        if any(nodes.issuperset(system.nodes[n] for n in ends) for nodes in own.values()):
            continue
        for n in ends:
            met[n] = met.get(n, 0) + 1
        if system.kind[i] in (RIGID, DRIVEN):
            u = ends_of(system, x, i)[2][:dim]
            loose.append(_Column({ends[0]: u, ends[1]: -u}))
    for m, name in enumerate(system.measures):
        g = measure_gradients(system, m, x[None])[0].reshape(-1, 3)[:, :dim]
        there: list[int] = np.flatnonzero(np.abs(g).max(axis=1) > 0).tolist()
        for n in there:
            met[n] = met.get(n, 0) + 1
        if there and name not in system.springs:
            loose.append(_Column({n: g[n] / np.abs(g).max() for n in there}))
    yield from loose
    held = {n for n in range(len(system.nodes)) if system.prescribed[3 * n : 3 * n + dim].any()}
    for nodes in own.values():
        for one in nodes:
            n = system.node_index(one)
            met[n] = met.get(n, 0) + 1
    for name, nodes in own.items():
        for one in sorted(nodes):
            n = system.node_index(one)
            if met[n] > 1 or n in held:
                for axis in np.eye(dim):
                    yield _Column({n: axis}, name, n)
