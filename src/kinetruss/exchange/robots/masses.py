"""Mass, centre and inertia of the rigid parts of a model in a pose."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots.records import LeftOut
from kinetruss.exchange.robots.rigid import Rigid
from kinetruss.library.bodies import MassProperties, combined, properties_of, rod_properties
from kinetruss.mechanics import compile
from kinetruss.model import Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["masses_of", "rods_of"]


def masses_of(
    model: Model, x: NDArray[np.float64], parts: Sequence[Rigid]
) -> tuple[list[MassProperties | None], list[LeftOut]]:
    """Mass properties of each part in global axes at x (n, 3), m; and masses that belong to no part.

    Bodies and bars belong to the part of their nodes, a mass at a node to the first part with the node.
    """
    place = {name: k for k, name in enumerate(model.nodes)}
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
    """Bars of constant length with mass. Members that change their length are in no part, so they are reported."""
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
    return found


def _flat(mass: float, center: Any, inertia: float) -> MassProperties:
    """A planar body: half the polar moment about each axis of the plane, which plays no part."""
    return MassProperties(mass=float(mass), center=center, inertia=float(inertia) * np.array([0.5, 0.5, 1.0]))


def _moved(model: Model, x: Any, name: str, nodes: Sequence[int]) -> MassProperties:
    """A body of the model where its nodes are at x: the rotation that fits them best (Kabsch 1976), exact for a rigid body."""
    given = properties_of(model, name)
    old = np.zeros((len(nodes), 3))
    old[:, : model.dim] = [model.nodes[node].at for node in model.bodies[name].nodes]
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
