"""Loads of a load case on a time axis, and loads on bodies as forces on nodes, which may turn with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.errors import InputError
from kinetruss.mechanics.rotating_base import RotatingBase, base_of
from kinetruss.mechanics.row_gradients import turned
from kinetruss.mechanics.system import System
from kinetruss.model import BodyCouple, BodyForce, LoadCase, NodalForce, Pressure, loads_along_beams
from kinetruss.model.beam_frames import carriers_of
from kinetruss.model.bodies import barycentric, fixed_vector

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model


# Loads on bodies as forces on nodes: forces at points, couples, pressures, which may turn with the body.
#
# The nodal forces of a load are its amount times the forces of a unit load, which follow from a vector V:
#
#     V = V0 + sum_j (c_j + d_j J) r_j + g (r_1 - r_0) x (r_2 - r_0),    J: turned by 90 deg about z
#     force    f_i = (w_i + u_i J) V
#     couple   f_i = a x (r_i - mean r),  (sum |r|^2 1 - r r^T) a = V;   plane: V_z J r_i/sum |r|^2
#
# Followers have no potential: their tangent stiffness is not symmetric. Derivatives by complex steps (Squire & Trapp, 1998).
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


@cached(256)
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
    from kinetruss.model.bodies import placed

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


# Loads of a load case on a time axis.

ROTATES = (
    "The base rotates (base_rotation), which this analysis does not take into account. These do: dynamics.inverse, "
    "dynamics.simulate, statics.at_poses, missions, explain. Use one of them, or leave out base_rotation."
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Loads:
    """t (times,) s; gravity (3,), lump_gravity (n, 3) m/s^2; loads (k,) names, node (k,) and force (times, k, 3) N.

    unit_loads : loads on bodies: name, unit load, amount (times,); `at` turns them into nodal forces. couples : by load, those
    that enter hubs through members (times, 3), N m; on a hub on the ground they are no nodal forces.
    base : its rotation, or None.
    """

    name: str
    loads: tuple[str, ...]
    gravity: NDArray[np.float64]
    lump_gravity: NDArray[np.float64]
    node: NDArray[np.int64]
    force: NDArray[np.float64]
    unit_loads: tuple[tuple[str, Follower, NDArray[np.float64]], ...] = ()
    couples: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    t: NDArray[np.float64] = field(default_factory=lambda: np.zeros(1))
    base: RotatingBase | None = None

    def at(self, x: NDArray[np.float64]) -> Loads:
        """A copy with the loads on bodies turned into nodal forces, at positions x (times, 3 n) or (times, n, 3)."""
        if not self.unit_loads:
            return self
        x = x.reshape(len(x), prod(x.shape[1:]) // 3, 3)
        names, nodes, forces = list(self.loads), [self.node], [self.force]
        for name, follower, amount in self.unit_loads:
            names += [name] * len(follower.nodes)
            nodes.append(follower.nodes)
            forces.append(amount[:, None, None] * follower.forces(x[:, follower.nodes]))
        return replace(
            self, loads=tuple(names), node=np.concatenate(nodes), force=np.concatenate(forces, axis=1), unit_loads=()
        )


def case_loads(system: System, t: NDArray[np.float64], name: str | None, *, rotating: bool = False) -> Loads:
    """Gravity and nodal forces of a load case of the model (None: all loads with factor 1).

    rotating : the caller takes account of `base`.

    Raises
    ------
    InputError : an unknown load case; a base that rotates, of which the caller takes no account.
    """
    base = base_of(system)
    if base is not None and not rotating:
        raise InputError(ROTATES)
    loads, (steady, factors) = system.model.loads, _steady(system, name)
    force = np.zeros((len(t), len(steady.loads), 3))
    for k, load in enumerate(steady.loads):
        force[:, k, : system.dim] = factors[load] * history_of(loads[load], t)
    unit_loads = [
        (load, follower, factor * amount)
        for load, factor in factors.items()
        if factor and load not in steady.loads and not on_ground(system, load)
        for follower, amount in zip(unit_loads_of(system, load), history_of(loads[load], t).T, strict=True)
        if amount.any()
    ]
    couples = {
        load: factor * history_of(loads[load], t) for load, factor in factors.items() if getattr(loads[load], "member", None)
    }
    return replace(steady, force=force, unit_loads=tuple(unit_loads), t=t, couples=couples, base=base)


@cached()
def _steady(system: System, name: str | None) -> tuple[Loads, Mapping[str, float]]:
    """What of a load case does not change in time, and the factors of its loads."""
    model = system.model
    if name is not None and name not in model.load_cases:
        raise InputError(f"No load case called {name!r}. There are: {', '.join(model.load_cases) or 'none'}.")
    case = LoadCase() if name is None else model.load_cases[name]
    gravity = system.gravity.copy()
    if case.gravity is not None:
        gravity[: system.dim] = case.gravity
    own = np.isfinite(system.own_gravity)
    factors = dict.fromkeys(model.loads, 1.0) if case.loads is None else case.loads
    if refused := [fault for fault in loads_along_beams(model) if factors.get(str(fault.path[1]))]:
        raise InputError(str(refused[0]))
    nodal = {load: record.node for load in factors if isinstance(record := model.loads[load], NodalForce)}
    steady = Loads(
        name=name or "all",
        loads=tuple(nodal),
        gravity=gravity,
        lump_gravity=np.where(own, np.nan_to_num(system.own_gravity), gravity),
        node=np.array([system.node_index(node) for node in nodal.values()], np.int64),
        force=np.zeros((0, len(nodal), 3)),
    )
    return steady, factors
