"""Rigid parts of a model in a pose: their nodes, mass, centre and inertia.

The motions are the null space of the gradients of the lengths, with drives released. Nodes belong to a part if they move with
it in all of them and the bars inside the part make it rigid, by rank: the sides of a parallelogram move alike, and are two.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots import LeftOut
from kinetruss.kernels.structure.structure import LENGTH
from kinetruss.library.bodies import MassProperties, combined, properties_of, rod_properties
from kinetruss.limits import hold
from kinetruss.mechanics import compile, constraint_jacobian
from kinetruss.mechanics.rows import null_basis
from kinetruss.model import Model, WholeModel
from kinetruss.model.beam_frames import rigid_beams, sound_beams
from kinetruss.model.data import ModelData
from kinetruss.model.links import frame_at

if TYPE_CHECKING:
    from numpy.typing import NDArray


MOST = 6000
"""Largest number of coordinates; the null space is dense."""
ALIKE = 1e-7
"""Difference of velocities that counts as none; the largest of a motion is about 1."""


@dataclass(eq=False)
class Rigid:
    """A rigid part: numbers of its nodes. kind : ``ground``, ``body`` (it has an orientation), ``rod`` or ``guide``.

    A guide is one node that a support lets move along `axes` only.
    """

    name: str
    kind: str
    nodes: list[int]
    axes: str = ""


def rigid_parts(model: Model, x: NDArray[np.float64]) -> list[Rigid]:
    """The ground, the bodies, the bars that are part of none, and guided nodes. x (n, 3), m, at which the model is assembled.

    Raises
    ------
    InputError : the model has too many coordinates.
    """
    system, whole = compile(model), model.whole
    hold(x.size, "The motions of the model", "Export a smaller part.", most=MOST, of="coordinates")
    rows = (system.row_drive < 0) & (system.row_kind == LENGTH)
    place = {name: k for k, name in enumerate(whole.nodes)}
    moved = [3 * place[one.node] + "xyz".index(one.axis) for one in model.drives.values() if one.kind == "coordinate"]
    free = np.union1d(system.free, np.array(moved, dtype=int))
    J = constraint_jacobian(system, x)[:, free][rows]
    modes = null_basis(J, 1e-10)
    flat = np.zeros((modes.shape[1], x.size))
    flat[:, free] = modes.T
    V = flat.reshape(len(flat), len(x), 3)
    pairs = _pairs(whole, system)
    parts = [Rigid("ground", "ground", _still(V))]
    taken = [set(parts[0].nodes)]
    for name, seed in _seeds(whole, pairs):
        if any(set(seed) <= own for own in taken):
            continue
        nodes = _moving_with(x, V, seed, model.dim)
        if nodes is not None:
            if not _held_together(x, nodes, pairs, taken[0], whole):
                nodes = _grown(x, seed, nodes, pairs, model.dim)
                if not _held_together(x, nodes, pairs, taken[0], whole):
                    continue
            parts.append(Rigid(name, "body", nodes))
            taken.append(set(nodes))
    for pair, name in pairs.items():
        if not any(pair <= own for own in taken):
            parts.append(Rigid(name, "rod", sorted(pair)))
            taken.append(set(pair))
    return [*parts, *_guides(whole, taken[0])]


def _pairs(model: ModelData, system: Any) -> dict[frozenset[int], str]:
    """Rigid bars between nodes, with their names."""
    driven = model.driven_members
    return {
        frozenset(map(system.node_index, bar.ends)): name
        for name, bar in model.bars.items()
        if bar.kind == "rigid" and name not in driven
    }


def _seeds(model: WholeModel, pairs: Iterable[frozenset[int]]) -> Iterator[tuple[str, list[int]]]:
    """Nodes that are in one part: of bodies, of frames of links, of triangles of bars (in the plane of bars)."""
    place = {name: k for k, name in enumerate(model.nodes)}
    for name, body in model.bodies.items():
        if body.kind == "rigid":
            yield name, [place[node] for node in body.nodes]
    for name, link in model.links.items():
        frame = model.inner.frames.get(frame_at(link, name, link.nodes[0]))
        if frame is not None:
            yield name, [place[node] for node in frame.all]
    beside: dict[int, set[int]] = {}
    names = {frozenset((place[a], place[b])): name for name, (a, b) in ((n, bar.ends) for n, bar in model.bars.items())}
    for pair in pairs:
        for a, b in (tuple(pair), tuple(pair)[::-1]):
            beside.setdefault(a, set()).add(b)
    for pair in pairs:
        a, b = pair
        if model.dim == 2:
            yield names[pair], [a, b]
        for c in sorted(beside[a] & beside[b]) if model.dim == 3 else ():
            yield names[pair], [a, b, c]


def _still(V: Any) -> list[int]:
    """Nodes that do not move."""
    return np.flatnonzero(np.abs(V).max(axis=(0, 2), initial=0.0) < ALIKE).tolist()


def _guides(model: ModelData, still: set[int]) -> Iterator[Rigid]:
    """Nodes that move, held by a support along some axes."""
    for k, name in enumerate(model.nodes):
        if (held := model.fixed.get(name, "")) and k not in still:
            yield Rigid(f"{name}.guide", "guide", [k], "".join(axis for axis in "xyz"[: model.dim] if axis not in held))


def _moving_with(x: Any, V: Any, seed: Sequence[int], dim: int) -> list[int] | None:
    """All nodes that move with those of a seed; None if they are on one line (in space), or no part."""
    r = x[list(seed)] - x[seed[0]]
    spread = np.linalg.svd(r, compute_uv=False)
    if dim == 3 and (len(spread) < 2 or spread[1] < 1e-6 * spread[0]):
        return None
    # v_k - v_0 = w x r_k for the rotation w of each motion
    rows = np.concatenate([_crossed(one) for one in r[1:]])
    if dim == 2:
        rows = rows[:, 2:]
    w = np.zeros((len(V), 3))
    relative = (V[:, seed[1:]] - V[:, seed[:1]]).reshape(len(V), -1)
    w[:, -rows.shape[1] :] = np.linalg.lstsq(rows, relative.T, rcond=None)[0].T
    expected = V[:, seed[:1]] + np.cross(w[:, None], (x - x[seed[0]])[None])
    off = np.abs(V - expected).max(axis=(0, 2), initial=0.0)
    return np.flatnonzero(off < ALIKE).tolist() if (off[list(seed)] < ALIKE).all() else None


def _crossed(r: Any) -> NDArray[np.float64]:
    """The matrix of w x r by w."""
    a, b, c = r
    return np.array([[0.0, c, -b], [-c, 0.0, a], [b, -a, 0.0]])


def _held_together(x: Any, nodes: Sequence[int], pairs: Iterable[frozenset[int]], ground: set[int], model: ModelData) -> bool:
    """True if the bars, bodies and fixed nodes inside a part make it rigid, by rank."""
    own, dim = set(nodes), model.dim
    place = {name: k for k, name in enumerate(model.nodes)}
    inside = {pair for pair in pairs if pair <= own} | {frozenset(two) for two in combinations(sorted(own & ground), 2)}
    for body in model.bodies.values():
        inside |= {frozenset(two) for two in combinations(sorted({place[name] for name in body.nodes} & own), 2)}
    at = {node: k for k, node in enumerate(nodes)}
    R = np.zeros((len(inside), dim * len(nodes)))
    for row, (a, b) in enumerate(map(tuple, inside)):
        u = (x[b] - x[a])[:dim] / max(float(np.linalg.norm(x[b] - x[a])), 1e-300)
        R[row, dim * at[a] : dim * at[a] + dim], R[row, dim * at[b] : dim * at[b] + dim] = -u, u
    wanted = dim * len(nodes) - dim * (dim + 1) // 2
    return bool(np.linalg.matrix_rank(R, tol=1e-9) >= wanted) if len(R) else wanted <= 0


def _grown(x: Any, seed: Sequence[int], nodes: Sequence[int], pairs: Iterable[frozenset[int]], dim: int) -> list[int]:
    """The seed and the nodes that bars hold to it one by one: parts may move alike, as those of parallelograms, and be two."""
    own, left = list(seed), [node for node in nodes if node not in seed]
    beside: dict[int, set[int]] = {}
    for a, b in map(tuple, pairs):
        beside.setdefault(a, set()).add(b)
        beside.setdefault(b, set()).add(a)
    added = True
    while added:
        added = False
        for node in list(left):
            ends = [x[other] - x[node] for other in own if other in beside.get(node, ())]
            if len(ends) >= dim and np.linalg.matrix_rank(np.array(ends)[:, :dim], tol=1e-9) >= dim:
                own.append(node)
                left.remove(node)
                added = True
    return sorted(own)


# Mass, centre and inertia of the rigid parts of a model in a pose.


def masses_of(
    model: Model, x: NDArray[np.float64], parts: Sequence[Rigid]
) -> tuple[list[MassProperties | None], list[LeftOut]]:
    """Mass properties of each part in global axes at x (n, 3), m; and masses that belong to no part.

    Bodies and bars belong to the part of their nodes, a mass at a node to the first part with the node.
    """
    place = {name: k for k, name in enumerate(model.whole.nodes)}
    own: list[list[MassProperties]] = [[] for _ in parts]
    left: list[LeftOut] = []

    def put(nodes: Sequence[int], given: MassProperties, what: str, name: str) -> None:
        part = next((k for k, one in enumerate(parts) if set(nodes) <= set(one.nodes)), None)
        if part is None:
            left.append(LeftOut(what, name, f"{given.mass:.6g} kg that move with no rigid part"))
        elif given.mass:
            own[part].append(given)

    for name, body in model.bodies.items():
        if body.mass:
            nodes = [place[node] for node in body.nodes]
            put(nodes, _moved(model, x, name, nodes), "body", name)
    for name, given, nodes in _members(model, x):
        put(nodes, given, "mass of member", name)
    for name, node in model.nodes.items():
        if node.mass:
            put([place[name]], MassProperties(mass=node.mass, center=x[place[name]], inertia=np.zeros((3, 3))), "mass", name)
    return [combined(*some) if some else None for some in own], left


def _members(model: Model, x: Any) -> list[tuple[str, MassProperties, list[int]]]:
    """Bars of constant length and rigid beams with mass. Members that change their length are in no part: reported."""
    system = compile(model)
    found = []
    for k, name in enumerate(system.members):
        nodes = [int(system.p[k]), int(system.q[k])]
        a, b = x[nodes[0]], x[nodes[1]]
        if system.is_body[k]:
            mass, e, f, inertia = system.body[k]
            u = (b - a) / np.linalg.norm(b - a)
            center = a + e * u + f * np.array([-u[1], u[0], 0.0])
            found.append((name, _flat(mass, center, inertia), nodes))
        elif mass := 0.0 if system.two_rods[k] else float(system.rods[k, 0]):
            found.append((name, rod_properties(a, b, mass=mass), nodes))
    rigid = [name for name, beam in sound_beams(system.model) if beam.kind == "rigid"]
    for name, one in zip(rigid, rigid_beams(system.model), strict=True):
        if one.mass:
            nodes = [system.node_index(node) for node in one.nodes]
            found.append((name, rod_properties(*x[nodes], mass=one.mass), nodes))
    return found


def _flat(mass: float, center: Any, inertia: float) -> MassProperties:
    """A planar body: half the polar moment about each axis of the plane, which plays no part."""
    return MassProperties(mass=float(mass), center=center, inertia=float(inertia) * np.array([0.5, 0.5, 1.0]))


def _moved(model: Model, x: Any, name: str, nodes: Sequence[int]) -> MassProperties:
    """A body of the model where its nodes are at x: the rotation that fits them best (Kabsch 1976), exact for a rigid body."""
    given = properties_of(model, name)
    old = np.zeros((len(nodes), 3))
    old[:, : model.dim] = [model.whole.nodes[node].at for node in model.bodies[name].nodes]
    new = x[list(nodes)]
    center = np.zeros(3)
    center[: model.dim] = given.center
    whole = _flat(given.mass, center, float(given.inertia)) if model.dim == 2 else given
    if np.array_equal(old, new):
        return whole
    u, _, v = np.linalg.svd((old - old.mean(axis=0)).T @ (new - new.mean(axis=0)))
    turn = u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))]) @ v
    return whole.moved(-old.mean(axis=0)).moved(new.mean(axis=0), turn)


def rods_of(model: Model, name: str, x: NDArray[np.float64]) -> tuple[MassProperties | None, MassProperties | None] | None:
    """The base and the tube of an active member with the masses clamped on them, in global axes; None for what has no mass."""
    if name not in model.active:
        return None
    system = compile(model)
    k = system.members.index(name)
    a, b = x[system.p[k]], x[system.q[k]]
    u = (b - a) / np.linalg.norm(b - a)
    found: list[MassProperties | None] = []
    for part, start in ((0, a), (1, b - system.own_rods[k, 4] * u)):
        mass, length = system.own_rods[k, 3 * part : 3 * part + 2]
        own = [rod_properties(start, start + length * u, mass=mass)] if mass else []
        for at, fraction, clamped in system.clamped:
            if int(at) == 2 * k + part and clamped:
                own.append(MassProperties(mass=clamped, center=start + fraction * length * u, inertia=np.zeros((3, 3))))
        found.append(combined(*own) if own else None)
    return (found[0], found[1]) if any(found) else None
