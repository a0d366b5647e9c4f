"""How a floating structure moves as a whole while its drives change its shape: from its momenta and the loads on it.

Drives alone give the shape of a structure that nothing holds. In a frame of its own, that moves with the rotation R and the
place r, the shape has positions s and velocities s', the inertia G against rigid motions and the momenta b. In space it has

    x = R s + r,    v = R (s' + u + w x s),    r' = R u,    R' = R [w],    G (u, w) = (R^T p, R^T (L - r x p)) - b

with the momenta (p, L), which only loads and gravity change. Positions follow by integration in time; velocities satisfy the
momenta exactly, and accelerations the balance of all forces on the whole. R and r are found by Gauss collocation (Hairer,
Lubich & Wanner, Geometric Numerical Integration, 2nd ed., 2006, sections II.1.2 and IV.8) on parts of the motion that are
halved until the last coefficients of the rates are small.

Source of the reconstruction from shapes: J. E. Marsden, R. Montgomery, T. Ratiu, Reduction, Symmetry and Phases in Mechanics,
Memoirs AMS 436 (1990).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.polynomial import legendre

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.structure import EndForces, States
from kinetruss.kernels.sweep.forces import applied
from kinetruss.mechanics import System
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.mechanics.momenta import inertia_and_momenta, mass_times
from kinetruss.mechanics.rigid_motions import resultants, rigid_fields, twists
from kinetruss.mechanics.tables import nodal_loads, structure_of
from kinetruss.mechanics.velocities import completed_velocities, named_coordinates
from kinetruss.model import Spline, Trapezoid

if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Shapes = Callable[[Array], tuple[Array, Array, Array]]

STAGES = 10
"""Gauss points of a part."""
PARTS = 8
"""Parts at first."""
TOLERANCE = 1e-12
"""Error of the rotation, rad, and of the place, as a fraction of the size, over the whole motion, at which parts are short
enough."""
JUMP = 1e-13
"""Error of a part that is small enough whatever its length."""
ROUNDS = 60
"""Halvings, and steps of the fixed point of a part, at most."""
MOST = 20_000
"""Parts at most."""
AGAINST_GROUND = 1e-9
"""Resultant of elements in a rigid motion, as a fraction of the largest of their forces, from which on they act against the
ground."""


class Adrift(NamedTuple):
    """x, v, a (times, 3 n) in space; turned (times,) : angle between the frame and where it stood first, rad; error : of the
    rotation at the end, rad, as estimated.
    """

    x: Array
    v: Array
    a: Array
    turned: Array
    error: float

    @property
    def words(self) -> str:
        """What the reader of a motion must know."""
        turn = np.degrees(float(self.turned[-1]))
        return (
            "The structure floats: drives give its shape, and it moves as a whole by its momentum and the loads on it. At the "
            f"end it stands turned by {turn:.6g} deg (error about {max(self.error, 1e-15):.0e} rad)."
        )


@dataclass(frozen=True, eq=False)
class _Frames:
    """Rotations R (times, 3, 3), places r (times, 3) from the first centre of mass, momenta P (times, 6) about it."""

    R: Array
    r: Array
    P: Array


def adrift(system: System, shapes: Shapes, t: Array, states: tuple[Array, Array, Array], edges: Array) -> Adrift:
    """The motion in space at the instants t (s,) s of a floating system.

    shapes : t -> positions, velocities, accelerations (times, 3 n) in a frame of its own; states : those at t; at t[0] the
    frame stands as the structure does. edges : instants, s, at which rates may jump.

    Raises
    ------
    InputError : elements that act against the ground, a structure all in one line. AnalysisError : parts too short.
    """
    body = _Body(system, states, t)
    grid = np.unique(np.concatenate([[t[0], t[-1]], edges[(edges > t[0]) & (edges < t[-1])]]))
    grid = np.unique(np.concatenate([np.linspace(a, b, PARTS + 1) for a, b in pairwise(grid)])) if len(grid) > 1 else grid
    found, error = _frames(body, shapes, t, grid)
    return body.in_space(t, states, found, error)


def edges_of(trajectory: Any) -> Array:
    """Instants (k,), s, at which the accelerations of a trajectory jump; others are found."""
    if isinstance(trajectory, Trapezoid):
        T = trajectory.duration
        return np.array([trajectory.ramp * T, (1 - trajectory.ramp) * T, T])
    if isinstance(trajectory, Spline):
        return np.array(trajectory.times) - trajectory.times[0]
    return np.array([trajectory.duration])


class _Body:
    """A floating structure: its momenta at first, and the loads on it."""

    def __init__(self, system: System, states: tuple[Array, Array, Array], t: Array) -> None:
        self.system, self.own = system, twists(system.dim)
        x, v = (y[:1].reshape(1, -1, 3) for y in states[:2])
        given = completed_velocities(
            system, x.reshape(-1), system.velocity0.reshape(-1), v.reshape(-1), named_coordinates(system, None)
        )
        first = system.velocity0[None] if given is None else given.reshape(1, -1, 3)
        G, _ = inertia_and_momenta(system, x, v)
        mass = G[0, 0, 0]
        if not mass > 0:
            raise InputError("The structure floats and has no mass. Give its members sections and materials, or masses.")
        moment = resultants(x[0], mass_times(system, x, rigid_fields(x)[:, :3])[0])[:, 3:]
        # moment of a unit mass that moves along each axis: the centre of mass crossed with it
        self.centre = np.array([moment[1, 2], -moment[0, 2], moment[0, 1]]) / mass
        self.size = float(np.ptp(x[0], axis=0).max())
        s = x - self.centre
        G, self.P = inertia_and_momenta(system, s, first)
        self.P = self.P[0]
        inertia = G[0][np.ix_(self.own, self.own)]
        if np.linalg.matrix_rank(inertia, hermitian=True, tol=1e-12 * float(np.abs(inertia).max())) < len(self.own):
            raise InputError(
                "The structure floats and its mass is all on one line, so that nothing says how it turns about it. Give it "
                "width, or masses beside the line."
            )
        loads = case_loads(system, t[:1], None)
        weight = bool(np.any(loads.gravity)) or bool(np.any(loads.lump_gravity))
        self.loaded = self._against_ground(s) or weight or bool(system.model.loads)

    def _against_ground(self, s: Array) -> bool:
        """True if elements act against the ground in places that the structure reaches as a whole.

        Raises InputError if they resist its velocity: the rate of the momenta of a rigid motion at constant twist is known.
        """
        size, still = self.size or 1.0, np.zeros_like(s)
        u, w = (np.where(np.isin(k + np.arange(3), self.own), 1.0, 0.0) * one for k, one in ((0, size), (3, 1.0)))
        R, t = _rotation(0.3 * w[None]), np.zeros(1)
        v = u + np.cross(w, s)
        P = inertia_and_momenta(self.system, s, v)[1][0]
        rate = np.concatenate([np.cross(w, P[:3]), np.cross(w, P[3:]) + np.cross(u, P[:3])])
        (begin, all_begin), (moved, all_moved), (moving, all_moving) = (
            self._pushed(t, *y, loads=False)
            for y in ((s, still, still), (_turned(R, s) + 0.3 * u, still, still), (s, v, np.cross(w, v)))
        )
        lever = np.array([1.0, 1.0, 1.0, size, size, size])
        off = (np.abs(moving - begin + rate) / lever)[0, self.own].max()
        if off > AGAINST_GROUND * (all_begin + all_moving):
            raise InputError(
                "The structure floats, but something in it acts against the ground when it moves as a whole (a damper to a "
                "place, drag). dynamics.simulate(model, trajectory=...) takes account of it."
            )
        net = (np.maximum(np.abs(begin), np.abs(moved)) / lever)[0, self.own].max()
        return bool(net > AGAINST_GROUND * (all_begin + all_moved))

    def _pushed(self, t: Array, x: Array, v: Array, a: Array, *, loads: bool = True) -> tuple[Array, float]:
        """Sums (times, 6) of f - M a over the nodes at x (times, n, 3) from the first centre of mass; the largest one, N."""
        system, count = self.system, len(x)
        place = x + self.centre
        acting = case_loads(system, t, None)
        acting = acting.at(place) if loads else _none(acting)
        out = EndForces(*allocate((count, len(system.members), 2, 3), (count, system.x0.size)))
        flat = [np.ascontiguousarray(y).reshape(count, -1) for y in (place, v, a)]
        applied(structure_of(system), nodal_loads(acting), States(*flat), out)
        return resultants(x, out.rest.reshape(x.shape)), float(np.abs(out.rest).max())

    def shaped(self, states: tuple[Array, ...]) -> tuple[Array, Array, Array]:
        """Positions from the first centre of mass (times, n, 3), inertia (times, 6, 6) and momenta (times, 6) in the frame."""
        s, v = (y.reshape(len(y), -1, 3) for y in states[:2])
        s = s - self.centre
        return (s, *inertia_and_momenta(self.system, s, v))

    def twist(self, frames: _Frames, G: Array, b: Array) -> Array:
        """(u, w) (times, 6) of the frame, in the frame."""
        R, p, L = frames.R, frames.P[:, :3], frames.P[:, 3:]
        own = np.concatenate([_back(R, p), _back(R, L - np.cross(frames.r, p))], axis=1) - b
        found = np.zeros_like(own)
        k = self.own
        found[:, k] = np.linalg.solve(G[:, k[:, None], k], own[:, k, None])[..., 0]
        return found

    def loads_on(self, t: Array, s: Array, frames: _Frames) -> Array:
        """Rates (times, 6) of the momenta by loads and gravity."""
        if not self.loaded:
            return np.zeros((len(t), 6))
        x = _turned(frames.R, s) + frames.r[:, None]
        return self._pushed(t, x, np.zeros_like(x), np.zeros_like(x))[0]

    def in_space(self, t: Array, states: tuple[Array, Array, Array], frames: _Frames, error: float) -> Adrift:
        """The motion: velocities from the momenta, accelerations from the balance of the whole."""
        s, G, b = self.shaped(states)
        v, a = (y.reshape(s.shape) for y in states[1:])
        twist, R = self.twist(frames, G, b), frames.R
        u, w = twist[:, None, :3], twist[:, None, 3:]
        moved = v + u + np.cross(w, s)
        bent = a + np.cross(w, v) + np.cross(w, moved)
        x = _turned(R, s) + frames.r[:, None]
        v, a = _turned(R, moved), _turned(R, bent)
        # the rigid part of the accelerations closes the balance of all forces: T^T (f - M a) = 0
        k, rest = self.own, self._pushed(t, x, v, a)[0]
        F, M = rest[:, :3], rest[:, 3:] - np.cross(frames.r, rest[:, :3])
        own = np.concatenate([_back(R, F), _back(R, M)], axis=1)
        second = np.zeros_like(own)
        second[:, k] = np.linalg.solve(G[:, k[:, None], k], own[:, k, None])[..., 0]
        a = a + _turned(R, second[:, None, :3] + np.cross(second[:, None, 3:], s))
        cosine = 0.5 * (np.trace(R, axis1=1, axis2=2) - 1.0)
        sine = 0.5 * np.linalg.norm(
            np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]]), axis=0
        )
        flat = (len(t), -1)
        return Adrift((x + self.centre).reshape(flat), v.reshape(flat), a.reshape(flat), np.arctan2(sine, cosine), error)


def _frames(body: _Body, shapes: Shapes, t: Array, grid: Array) -> tuple[_Frames, float]:
    """Frames at the instants t (s,) by collocation on the parts of a grid, and the estimated error of their rotation."""
    for _ in range(ROUNDS):
        now = _Frames(np.eye(3)[None], np.zeros((1, 3)), body.P[None])
        found = _Frames(*(np.repeat(one, len(t), axis=0) for one in (now.R, now.r, now.P)))
        h, errors = np.diff(grid), np.zeros(max(0, len(grid) - 1))
        places = grid[:-1, None] + h[:, None] * POINTS
        parts = body.shaped(shapes(places.reshape(-1))) if len(h) else ()
        for k, step in enumerate(h):
            here = slice(k * STAGES, (k + 1) * STAGES)
            inside = np.flatnonzero((t > grid[k]) & (t <= grid[k + 1]))
            share = np.append((t[inside] - grid[k]) / step, 1.0)
            states, errors[k] = _part(body, places[k], step, tuple(y[here] for y in parts), now, share)
            for name in ("R", "r", "P"):
                getattr(found, name)[inside] = getattr(states, name)[:-1]
            now = _Frames(states.R[-1:], states.r[-1:], states.P[-1:])
        allowed = TOLERANCE * h / max(t[-1] - t[0], 1e-300)
        # about a jump of rates at an instant that is not known parts become short until their whole error is small
        bad = errors > np.maximum(allowed, JUMP)
        if not bad.any():
            return found, float(errors.sum())
        grid = np.sort(np.concatenate([grid, grid[:-1][bad] + 0.5 * h[bad]]))
        if len(grid) > MOST:
            break
    raise AnalysisError(
        f"The structure floats, and how it turns is not found to {TOLERANCE:g} rad: its rates change too suddenly. Smooth the "
        "trajectory, or take dynamics.simulate(model, trajectory=...)."
    )


def _part(body: _Body, t: Array, h: float, shape: tuple[Array, ...], start: _Frames, share: Array) -> tuple[_Frames, float]:
    """Frames at shares (m,) of one part of h seconds, from the frame at its start; the error, infinite if none is found.

    t (stages,) : Gauss points; shape : positions, inertia, momenta there. Unknown are the rotation vectors of R from the start.
    """
    s, G, b = shape
    y, at = np.zeros((STAGES, 12)), start
    for _ in range(ROUNDS):
        at = _moved(start, h * TO_POINTS @ y)
        twist = body.twist(at, G, b)
        vector = h * (TO_POINTS @ y)[:, :3]
        new = np.concatenate(
            [_rate_of_vector(vector, twist[:, 3:]), _turned(at.R, twist[:, None, :3])[:, 0], body.loads_on(t, s, at)], axis=1
        )
        change, y = np.abs(new - y).max(), new
        if not change > 1e-15 * np.abs(y).max(initial=0.0):
            break
        if not np.isfinite(change):
            return _moved(start, np.zeros((len(share), 12))), np.inf
    else:
        if change > 1e-13 * np.abs(y).max():
            return _moved(start, np.zeros((len(share), 12))), np.inf
    tail = np.abs((TO_LEGENDRE @ y)[-2:]).max(axis=0)
    error = h * max(tail[:3].max(), tail[3:6].max() / (body.size or 1.0))
    return _moved(start, h * _integrals(share) @ y), error


def _moved(start: _Frames, change: Array) -> _Frames:
    """Frames (m,) from one by changes (m, 12): rotation vector, place, momenta."""
    R = start.R @ _rotation(change[:, :3])
    return _Frames(R, start.r + change[:, 3:6], start.P + change[:, 6:])


def _rotation(vector: Array) -> Array:
    """Rotation matrices (m, 3, 3) of rotation vectors (m, 3), rad."""
    angle = np.linalg.norm(vector, axis=1)[:, None, None]
    K, half = _skew(vector), np.sinc(angle / (2 * np.pi))
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * K + 0.5 * half**2 * K @ K)


def _rate_of_vector(vector: Array, w: Array) -> Array:
    """Rates (m, 3) of rotation vectors (m, 3) that turn with w (m, 3) in the turned frame: the inverse of the tangent map."""
    angle = np.linalg.norm(vector, axis=1)[:, None]
    square = angle**2
    small = square < 1e-3
    safe = np.where(small, 1.0, angle)
    exact = (1.0 - 0.5 * safe / np.tan(0.5 * safe)) / safe**2
    c = np.where(small, 1 / 12 + square / 720 + square**2 / 30240 + square**3 / 1209600, exact)
    turn = np.cross(vector, w)
    return np.asarray(w + 0.5 * turn + c * np.cross(vector, turn))


def _skew(v: Array) -> Array:
    zero = np.zeros(len(v))
    x, y, z = v.T
    return np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)


def _turned(R: Array, y: Array) -> Array:
    """Vectors (times, n, 3) of the frame in space."""
    return y @ R.swapaxes(1, 2)


def _back(R: Array, y: Array) -> Array:
    """Vectors (times, 3) of space in the frame."""
    return np.asarray((y[:, None] @ R)[:, 0])


def _none(loads: Loads) -> Loads:
    """The same instants without loads and gravity."""
    return replace(
        loads,
        gravity=0 * loads.gravity,
        lump_gravity=0 * loads.lump_gravity,
        node=loads.node[:0],
        force=loads.force[:, :0],
        unit_loads=(),
    )


# Gauss points on 0 to 1, and the integrals of the polynomial through values at them.

_NODES, _ = legendre.leggauss(STAGES)
POINTS = 0.5 * (_NODES + 1.0)
TO_LEGENDRE = np.linalg.inv(legendre.legvander(_NODES, STAGES - 1))
_INTEGRALS = np.stack([0.5 * legendre.legint(one, lbnd=-1) for one in np.eye(STAGES)], axis=1)


def _integrals(share: Array) -> Array:
    """Weights (m, stages) of the integrals from 0 to shares (m,) of the part."""
    return np.asarray(legendre.legvander(2.0 * share - 1.0, STAGES) @ _INTEGRALS @ TO_LEGENDRE)


TO_POINTS = _integrals(POINTS)
