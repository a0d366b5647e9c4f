"""Loads on bodies as forces on nodes: forces at points, couples, pressures, which may turn with the body.

The nodal forces of a load are its amount times the forces of a unit load, which follow from a vector V:

    V = V0 + sum_j (c_j + d_j J) r_j + g (r_1 - r_0) x (r_2 - r_0),    J: turned by 90 deg about z
    force    f_i = (w_i + u_i J) V
    couple   f_i = a x (r_i - mean r),  (sum |r|^2 1 - r r^T) a = V;   plane: V_z J r_i/sum |r|^2

Followers have no potential: their tangent stiffness is not symmetric. Derivatives by complex steps (Squire & Trapp, 1998).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics import System
from kinetruss.mechanics.kept import kept
from kinetruss.mechanics.structure.constraint_gradients import turned
from kinetruss.model import BodyCouple, BodyForce, NodalForce, Pressure
from kinetruss.model.beams import carriers_of
from kinetruss.model.parts import barycentric, fixed_vector

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model

__all__ = ["COUPLE", "FLAT_COUPLE", "FORCE", "Follower", "history_of", "on_ground", "unit_loads_of"]

FORCE, COUPLE, FLAT_COUPLE = 0, 1, 2
STEP = 1e-30


@dataclass(frozen=True, kw_only=True, eq=False)
class Follower:
    """mode FORCE, COUPLE or FLAT_COUPLE; nodes (k,); data (k, 4) c, d, w, u; vector (4,) V0 and g."""

    mode: int
    nodes: NDArray[np.int64]
    data: NDArray[np.float64]
    vector: NDArray[np.float64]

    @property
    def constant(self) -> bool:
        """True if the nodal forces do not depend on positions."""
        return self.mode == FORCE and not self.data[:, :2].any() and not self.vector[3]

    def forces(self, r: NDArray[Any]) -> NDArray[Any]:
        """Nodal forces (..., k, 3) of the amount 1 with its nodes at r (..., k, 3), which may be complex."""
        c, d, w, u = (self.data[:, [j]] for j in range(4))
        # V = V_0 + sum (c + d J) r + g (r_1 - r_0) x (r_2 - r_0)
        V = self.vector[:3] + np.sum(c * r + d * turned(r), axis=-2)
        if self.vector[3]:
            V = V + self.vector[3] * np.cross(r[..., 1, :] - r[..., 0, :], r[..., 2, :] - r[..., 0, :])
        if self.mode == FORCE:
            return np.asarray(w * V[..., None, :] + u * turned(V)[..., None, :])
        r = r - r.mean(axis=-2, keepdims=True)
        square = np.sum(r * r, axis=(-2, -1))
        if self.mode == FLAT_COUPLE:
            return np.asarray((V[..., 2] / square)[..., None, None] * turned(r))
        # f_i = alpha x r_i with (sum |r|^2 1 - r r^T) alpha = V
        G = square[..., None, None] * np.eye(3) - np.swapaxes(r, -1, -2) @ r
        a = np.linalg.solve(G, V[..., None])[..., 0]
        return np.asarray(np.cross(a[..., None, :], r))

    def tangent(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        """d forces/d r, (3 k, 3 k), with its nodes at r (k, 3)."""
        size = r.size
        # complex steps in each coordinate
        stepped = np.broadcast_to(r, (size, *r.shape)) + 1j * STEP * np.eye(size).reshape(size, *r.shape)
        return np.asarray(self.forces(stepped).imag.reshape(size, size).T / STEP)


def history_of(load: Any, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Components (times, c) of a load: constant, or linear between the entries of a table and constant outside it."""
    one = "moment" if isinstance(load, BodyCouple) else "pressure" if isinstance(load, Pressure) else "force"
    many = f"{one}s"
    table = getattr(load, many)
    if table is None:
        given = np.atleast_1d(np.array(getattr(load, one), float))
        return np.broadcast_to(given, (len(t), len(given)))
    rows = np.array(table, float).reshape(len(table), -1)
    return np.stack([np.interp(t, load.times, column) for column in rows.T], axis=1)


@kept(256)
def unit_loads_of(system: System, name: str) -> tuple[Follower, ...]:
    """The unit load of each component of a load on a body."""
    load = system.model.loads[name]
    if isinstance(load, NodalForce):
        raise TypeError("nodal forces are put on their nodes as they are")
    if isinstance(load, Pressure):
        return (_pressure(system, load),)
    nodes, points = _points(system, load.body)
    if isinstance(load, BodyCouple):
        return _couples(system.dim, load, nodes, points)
    weights = _weights(system.model, load, points)
    return tuple(_push(FORCE, nodes, points, axis, weights, load.follows, system.dim) for axis in np.eye(3)[: system.dim])


def on_ground(system: System, name: str) -> bool:
    """Whether the ground takes all of a load: a couple on a hub that has no body, since it is bolted to the ground."""
    load = system.model.loads[name]
    return isinstance(load, BodyCouple) and load.member is not None and load.body not in system.model.bodies


def _pressure(system: System, load: Pressure) -> Follower:
    nodes = np.array([system.node_index(node) for node in load.face], np.int64)
    data, vector = np.zeros((len(nodes), 4)), np.zeros(4)
    data[:, 2] = 1.0 / len(nodes)
    if len(nodes) == 2:
        data[:, 1] = (-load.depth, load.depth)
    else:
        # seen from where the pressure acts, the nodes run counter-clockwise: the normal points against the pressure
        vector[3] = -0.5
    return Follower(mode=FORCE, nodes=nodes, data=data, vector=vector)


def _points(system: System, name: str) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Nodes that carry a body or bar, and their start positions (k, dim)."""
    model = system.model
    names = carriers_of(model, name) or model.bars[name].ends
    nodes = np.array([system.node_index(node) for node in names], np.int64)
    return nodes, system.x0[nodes, : system.dim]


def _couples(dim: int, load: BodyCouple, nodes: NDArray[np.int64], points: NDArray[np.float64]) -> tuple[Follower, ...]:
    none = np.zeros((len(nodes), 2))
    if dim == 2:
        vector = np.array([0.0, 0.0, 1.0, 0.0])
        return (Follower(mode=FLAT_COUPLE, nodes=nodes, data=np.zeros((len(nodes), 4)), vector=vector),)
    return tuple(_push(COUPLE, nodes, points, axis, none, load.follows, dim) for axis in np.eye(3))


def _weights(model: Model, load: BodyForce, points: NDArray[np.float64]) -> NDArray[np.float64]:
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


def _centre(model: Model, name: str, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Start position of the centre of mass, m."""
    from kinetruss.model.parts import placed

    body = model.bodies.get(name)
    if body is None:  # a frame: its origin
        return np.asarray(points[0])
    if body.center is None:
        return np.asarray(points.mean(axis=0))
    origin, axes = placed(body.frame, model.dim)
    return np.asarray(origin + axes.T @ np.array(body.center, float))


def _push(
    mode: int,
    nodes: NDArray[np.int64],
    points: NDArray[np.float64],
    axis: NDArray[np.float64],
    weights: NDArray[np.float64],
    follows: bool,
    dim: int,
) -> Follower:
    """A unit vector along a global axis, fixed in space or in the body."""
    data = np.concatenate([np.zeros((len(nodes), 2)), weights], axis=1)
    if not follows:
        return Follower(mode=mode, nodes=nodes, data=data, vector=np.append(axis, 0.0))
    vector = np.zeros(4)
    if dim == 2 and len(nodes) == 2:
        share = complex(*axis[:2]) / complex(*(points[1] - points[0]))
        data[:, :2] = ((-share.real, -share.imag), (share.real, share.imag))
    elif len(nodes) == dim + 1:
        data[:, 0] = fixed_vector(points, axis[:dim])[0]
    else:
        normal = np.cross(points[1] - points[0], points[2] - points[0])
        vector[3] = axis @ normal / (normal @ normal)
        data[:, 0] = fixed_vector(points, axis - vector[3] * normal)[0]
    return Follower(mode=mode, nodes=nodes, data=data, vector=vector)
