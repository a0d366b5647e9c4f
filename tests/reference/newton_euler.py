"""Newton-Euler form of any pin-jointed set of bars and active members, in the plane and in space.

Every member has its own free body: an unknown force vector at each end, balance of forces, and balance of moments
about its centre of gravity in its own frame (spin about its axis is dropped). Every node is a massless or lumped point
in balance. For one double-octahedral bay that is 18 (3 + 2) + 9 * 3 = 117 equations for 18 * 6 + 9 = 117 unknowns
(Lacy 1991, chapter 4, with its member accelerations, moving centre of gravity and changing inertia put right).

An active member is two overlapping rods: the base clamped at end A, the tube clamped at end B. Its centre of gravity
moves along it and its inertia J changes with the length, so the moment equation is J u x u'' + J' u x u'.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

Axis = tuple[float, float, np.ndarray, np.ndarray, np.ndarray]

__all__ = ["Member", "Rod", "Solution", "Truss", "axis_motion", "size", "solve"]


@dataclass(frozen=True)
class Rod:
    """A uniform rod: mass kg, length m, rotary inertia of its finite diameter kg m^2 (0 for a thin rod)."""

    mass: float
    length: float
    rotary: float = 0.0


@dataclass(frozen=True)
class Member:
    """Ends A, B as node indices; one rod (a bar, as long as the distance of its nodes) or two (base at A, tube at B)."""

    a: int
    b: int
    rods: tuple[Rod, ...]


@dataclass(frozen=True)
class Truss:
    """Members, and per node: supported axes (n, dim), lumped mass (n,) kg, its gravity (n, dim); gravity of rods (dim,) m/s^2.

    `turned` lists members (planar) on which a motor at end A exerts a torque; `pushed` lists (node, axis) that a motor pushes.
    """

    members: tuple[Member, ...]
    supported: np.ndarray
    gravity: np.ndarray
    lump: np.ndarray
    lump_gravity: np.ndarray
    turned: tuple[int, ...] = ()
    pushed: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True)
class Solution:
    """Forces on the members at A and B (m, dim) N, reactions on the structure (n, dim) N, motor torques and pushes."""

    force_a: np.ndarray
    force_b: np.ndarray
    reaction: np.ndarray
    torque: np.ndarray
    push: np.ndarray
    matrix: np.ndarray = field(repr=False)


def size(truss: Truss) -> tuple[int, int]:
    """Equations and unknowns: 117, 117 for one double-octahedral bay."""
    nodes, dim = truss.supported.shape
    equations = len(truss.members) * (2 * dim - 1) + nodes * dim
    unknowns = len(truss.members) * 2 * dim + int(truss.supported.sum()) + len(truss.turned) + len(truss.pushed)
    return equations, unknowns


def axis_motion(member: Member, x: np.ndarray, v: np.ndarray, a: np.ndarray) -> Axis:
    """Length L, its rate, unit vector u from A to B and its first two derivatives, from the ends' motion."""
    d, d_rate, d_acceleration = (w[member.b] - w[member.a] for w in (x, v, a))
    length = float(np.sqrt(d @ d))
    u = d / length
    rate = float(u @ d_rate)
    u_rate = (d_rate - rate * u) / length
    acceleration = float(u @ d_acceleration + length * (u_rate @ u_rate))
    u_acceleration = (d_acceleration - acceleration * u - 2 * rate * u_rate) / length
    return length, rate, u, u_rate, u_acceleration


def solve(truss: Truss, x: np.ndarray, v: np.ndarray, a: np.ndarray, external: np.ndarray | None = None) -> Solution:
    """All joint forces and reactions at one instant.

    x, v, a, external : (n, dim), m, m/s, m/s^2, N. A structure that is not square gets the least-squares forces of least norm.
    """
    equations, unknowns = size(truss)
    matrix, right = np.zeros((equations, unknowns)), np.zeros(equations)
    _member_equations(truss, x, v, a, matrix, right)
    _node_equations(truss, a, np.zeros_like(x) if external is None else external, matrix, right)
    if equations == unknowns:
        forces = np.linalg.solve(matrix, right)
    else:
        forces = np.linalg.lstsq(matrix, right, rcond=None)[0]
    return _unpack(truss, forces, matrix)


def _member_equations(truss: Truss, x: np.ndarray, v: np.ndarray, a: np.ndarray, matrix: np.ndarray, right: np.ndarray) -> None:
    dim = x.shape[1]
    rows, columns = 2 * dim - 1, 2 * dim
    for k, member in enumerate(truss.members):
        row, column = rows * k, columns * k
        length, rate, u, u_rate, u_acceleration = axis_motion(member, x, v, a)
        mass, centre, inertia, inertia_rate = _inertia(member, length, rate)
        momentum_rate = sum((rod.mass * w for rod, w in _centres(member, a, u_acceleration)), np.zeros(dim))
        # balance of forces: FA + FB = sum m (a - g)
        matrix[row : row + dim, column : column + dim] = np.eye(dim)
        matrix[row : row + dim, column + dim : column + 2 * dim] = np.eye(dim)
        right[row : row + dim] = momentum_rate - mass * truss.gravity
        # balance of moments about the centre of gravity, about the axis u x e for each transverse direction e
        for i, e in enumerate(_transverse(u)):
            line = row + dim + i
            matrix[line, column : column + dim] = -centre * e
            matrix[line, column + dim : column + 2 * dim] = (length - centre) * e
            right[line] = (inertia * u_acceleration + inertia_rate * u_rate) @ e
    for i, k in enumerate(truss.turned):
        # in the plane u x e is +z: a counter-clockwise torque on the member counts as it stands
        matrix[rows * k + dim, matrix.shape[1] - len(truss.turned) - len(truss.pushed) + i] = 1.0


def _centres(member: Member, a: np.ndarray, u_acceleration: np.ndarray) -> list[tuple[Rod, np.ndarray]]:
    """Each rod with the acceleration of its own centre."""
    if len(member.rods) == 1:
        return [(member.rods[0], (a[member.a] + a[member.b]) / 2)]
    base, tube = member.rods
    return [(base, a[member.a] + base.length / 2 * u_acceleration), (tube, a[member.b] - tube.length / 2 * u_acceleration)]


def _inertia(member: Member, length: float, rate: float) -> tuple[float, float, float, float]:
    """Mass, distance of the centre of gravity from A, transverse inertia about it, rate of that inertia."""
    if len(member.rods) == 1:
        (rod,) = member.rods
        return rod.mass, length / 2, rod.mass * length**2 / 12 + rod.rotary, rod.mass * length * rate / 6
    base, tube = member.rods
    mass = base.mass + tube.mass
    reduced = base.mass * tube.mass / mass if mass > 0 else 0.0
    apart = length - tube.length / 2 - base.length / 2
    centre = (base.mass * base.length / 2 + tube.mass * (length - tube.length / 2)) / mass if mass > 0 else length / 2
    own = sum(rod.mass * rod.length**2 / 12 + rod.rotary for rod in member.rods)
    return mass, centre, own + reduced * apart**2, 2 * reduced * apart * rate


def _transverse(u: np.ndarray) -> np.ndarray:
    """Unit vectors across u: one in the plane, two in space."""
    if len(u) == 2:
        return np.array([[-u[1], u[0]]])
    first = np.cross(u, np.eye(3)[np.argmin(np.abs(u))])
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(u, first)])


def _node_equations(truss: Truss, a: np.ndarray, external: np.ndarray, matrix: np.ndarray, right: np.ndarray) -> None:
    dim = truss.supported.shape[1]
    first = len(truss.members) * (2 * dim - 1)
    for k, member in enumerate(truss.members):
        for i, node in enumerate((member.a, member.b)):
            column = 2 * dim * k + dim * i
            matrix[first + dim * node : first + dim * (node + 1), column : column + dim] = -np.eye(dim)
    column = len(truss.members) * 2 * dim
    for node, axis in np.argwhere(truss.supported):
        matrix[first + dim * node + axis, column] = 1.0
        column += 1
    for i, (node, axis) in enumerate(truss.pushed):
        matrix[first + dim * node + axis, matrix.shape[1] - len(truss.pushed) + i] = 1.0
    right[first:] = (truss.lump[:, None] * (a - truss.lump_gravity) - external).ravel()


def _unpack(truss: Truss, forces: np.ndarray, matrix: np.ndarray) -> Solution:
    dim, members = truss.supported.shape[1], len(truss.members)
    joints = forces[: members * 2 * dim].reshape(members, 2, dim)
    supports, turned = int(truss.supported.sum()), len(truss.turned)
    rest = forces[members * 2 * dim :]
    reaction = np.zeros(truss.supported.shape)
    reaction[truss.supported] = rest[:supports]
    return Solution(joints[:, 0], joints[:, 1], reaction, rest[supports : supports + turned], rest[supports + turned :], matrix)
