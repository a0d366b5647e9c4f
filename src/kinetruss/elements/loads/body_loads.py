"""Forces at points of bodies, and couples on them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.loads.follower import COUPLE, FLAT_COUPLE, FORCE, Follower, unit_vector
from kinetruss.elements.loads.load import Load, OnMember, OnOthers
from kinetruss.model import BodyCouple, BodyForce, WholeModel
from kinetruss.model.beam_frames import carriers_of
from kinetruss.model.bodies import barycentric, placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System
    from kinetruss.model import Body


def _forces(system: System, load: BodyForce) -> tuple[Follower, ...]:
    nodes, points = _points(system, load.body)
    weights = _weights(system.model, load, points)
    return tuple(unit_vector(FORCE, nodes, points, axis, weights, load.follows, system.dim) for axis in np.eye(3)[: system.dim])


def on_ground(system: System, load: BodyCouple) -> bool:
    """Whether the ground takes all of a couple: on a hub that has no body, since it is bolted to the ground."""
    return load.member is not None and load.body not in system.model.bodies


def _couples(system: System, load: BodyCouple) -> tuple[Follower, ...]:
    if on_ground(system, load):
        return ()
    nodes, points = _points(system, load.body)
    none = np.zeros((len(nodes), 2))
    if system.dim == 2:
        vector = np.array([0.0, 0.0, 1.0, 0.0])
        return (Follower(mode=FLAT_COUPLE, nodes=nodes, data=np.zeros((len(nodes), 4)), vector=vector),)
    return tuple(unit_vector(COUPLE, nodes, points, axis, none, load.follows, system.dim) for axis in np.eye(3))


def _points(system: System, name: str) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Nodes that carry a body or bar, and their start positions (k, dim)."""
    model = system.model
    names = carriers_of(model, name) or model.bars[name].ends
    nodes = np.array([system.node_index(node) for node in names], np.int64)
    return nodes, system.x0[nodes, : system.dim]


def _weights(model: WholeModel, load: BodyForce, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """w, u (k, 2) of the point a force acts at."""
    weights = np.zeros((len(points), 2))
    if carriers_of(model, load.body):
        place = _centre(model, load.body, points) if load.at is None else np.array(load.at, float)
    else:
        d = points[1] - points[0]
        u = d / np.linalg.norm(d)
        e, f = (float(np.linalg.norm(d)) / 2, 0.0) if load.at is None else load.at
        place = points[0] + e * u + f * np.array([-u[1], u[0]])
    if len(points) == 2 and model.dim == 2:
        # z = p (1 - w) + q w in complex notation: the forces are conj(1 - w) F and conj(w) F
        d, r = complex(*(points[1] - points[0])), complex(*(place - points[0]))
        share = (r / d).conjugate()
        weights[:] = ((1 - share.real, -share.imag), (share.real, share.imag))
    else:
        weights[:, 0] = barycentric(points, place)[0]
    return weights


def _centre(model: WholeModel, name: str, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Start position of the centre of mass, m."""
    body = model.bodies.get(name)
    if body is None:  # a frame: its origin
        return np.asarray(points[0])
    if body.center is None:
        return np.asarray(points.mean(axis=0))
    origin, axes = placed(body.frame, model.dim)
    return np.asarray(origin + axes.T @ np.array(body.center, float))


def _places(system: System, bars: Bars, load: BodyForce | BodyCouple) -> Iterator[OnMember | OnOthers]:
    body = system.model.bodies.get(load.body)
    if body is None and load.body not in bars.index:
        return  # on the frame of a node of beams
    i = bars.index[load.body] if body is None else bar_of(system, bars, body)
    if i >= 0:
        yield OnMember(i, _place(system, i, load) if body is None else share(system, bars, i, body, getattr(load, "at", None)))
        return
    inside = () if body is None else bars.inside({system.node_index(node) for node in body.nodes})
    if body is not None and inside and load.body not in hub_bodies(system):
        yield OnOthers(tuple(body.nodes), inside)


def bar_of(system: System, bars: Bars, body: Body) -> int:
    """The bar between the nodes of a body of two nodes, -1 if there is none or it is an active member."""
    if len(body.nodes) != 2 or set(body.carried_by(system.dim)) != set(body.nodes):
        return -1
    i = bars.between(*(system.node_index(node) for node in body.nodes))
    return -1 if i >= 0 and system.two_rods[i] else i


def share(system: System, bars: Bars, i: int, body: Body, at: Any) -> float:
    """Fraction from end A of bar i of the start position of a point of a body, by default its centre of mass."""
    points = system.x0[list(bars.ends(i)), : system.dim]
    if at is None and body.center is None:
        return 0.5
    if at is None:
        origin, axes = placed(body.frame, system.dim)
        at = origin + axes.T @ np.array(body.center, float)
    return float(barycentric(points, np.array(at, float))[0][1])


def _place(system: System, i: int, load: BodyForce | BodyCouple) -> float:
    """Fraction from end A of a bar of the plane; by default, and for couples, its middle."""
    at = getattr(load, "at", None)
    return 0.5 if at is None else float(at[0]) / float(np.linalg.norm(system.x0[system.q[i]] - system.x0[system.p[i]]))


def hub_bodies(system: System) -> set[str]:
    """Names of the bodies of hubs."""
    return {f"{hub}.hub" for hub in system.model.hubs} & set(system.model.bodies)


FORCES, COUPLES = Load(_forces, _places), Load(_couples, _places)
