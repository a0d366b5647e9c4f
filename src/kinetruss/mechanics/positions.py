"""What positions of nodes say: values of rows and drives, planes through nodes, rigid motion of groups."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.errors import InputError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.structure.lengths import lengths as length_rates
from kinetruss.kernels.structure.structure import ANGLE, LENGTH, SUM
from kinetruss.mechanics.arguments import names_of
from kinetruss.mechanics.measures import measured
from kinetruss.mechanics.row_gradients import direction_rates
from kinetruss.mechanics.system import System
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


# Values of prescribed rows and of drives at given node positions.


def row_values(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Value of each row (length m, angle rad, sum) at positions x (n, 3); angles of sums nearest to the start value."""
    d = x[system.q[system.row_member]] - x[system.p[system.row_member]]
    found = np.where(system.row_kind == ANGLE, np.arctan2(d[:, 1], d[:, 0]), np.linalg.norm(d, axis=1))
    for r in system.sums:
        found[r] = measured(system, system.row_measure[r], x[None])[0, 0]
    return found


def drive_values(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Values, rates and accelerations (times, drives) that given node motions (times, n, 3) have at the drives."""
    value, rate, second = (np.zeros((len(x), len(system.drives))) for _ in range(3))
    for flat, d in system.coordinate_drive:
        node, axis = divmod(int(flat), 3)
        value[:, d], rate[:, d], second[:, d] = x[:, node, axis], v[:, node, axis], a[:, node, axis]
    driven = np.flatnonzero(system.row_drive >= 0)
    along = driven[system.row_kind[driven] == LENGTH]
    if len(along):
        member, d = system.row_member[along], system.row_drive[along]
        found = allocate(*[(len(x), len(along))] * 3)
        flat = (np.ascontiguousarray(y).reshape(len(x), system.x0.size) for y in (x, v, a))
        length_rates(system.p[member], system.q[member], *flat, *found)
        value[:, d], rate[:, d], second[:, d] = found
    for r in driven[system.row_kind[driven] != LENGTH]:
        i, d = system.row_member[r], system.row_drive[r]
        if (m := system.row_measure[r]) >= 0:
            value[:, d], rate[:, d], second[:, d] = measured(system, m, x, v, a).T
            continue
        dx, dv, da = (y[:, system.q[i]] - y[:, system.p[i]] for y in (x, v, a))
        square, turn = np.einsum("tc,tc->t", dx, dx), dx[:, 0] * dv[:, 1] - dx[:, 1] * dv[:, 0]
        value[:, d] = np.unwrap(np.arctan2(dx[:, 1], dx[:, 0]))
        rate[:, d] = turn / square
        along_bar = np.einsum("tc,tc->t", dx, dv)
        second[:, d] = (dx[:, 0] * da[:, 1] - dx[:, 1] * da[:, 0]) / square - 2 * along_bar * turn / square**2
    return value, rate, second


def drive_places(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (times, drives) that node positions (times, n, 3) have at the drives, each position by itself.

    Angles in the plane are from -pi to pi, others the nearest to that at the start.
    """
    value = np.zeros((len(x), len(system.drives)))
    for flat, d in system.coordinate_drive:
        value[:, d] = x[:, flat // 3, flat % 3]
    for r in np.flatnonzero(system.row_drive >= 0):
        i, d, m = system.row_member[r], system.row_drive[r], system.row_measure[r]
        if m >= 0:
            value[:, d] = measured(system, m, x, along=False)[:, 0]
            continue
        along = x[:, system.q[i]] - x[:, system.p[i]]
        turns = system.row_kind[r] == ANGLE
        value[:, d] = np.arctan2(along[:, 1], along[:, 0]) if turns else np.sqrt(np.einsum("tc,tc->t", along, along))
    return value


@cached()
def shortest(system: System) -> float:
    """Unit of length of step limits: the shortest prescribed bar, m."""
    lengths = system.length0[system.row_member[system.row_kind != SUM]]
    return float(lengths.min()) if len(lengths) else 1.0


# Planes through nodes: vector area, normal and gimbal angles, with two rates where the nodes have them.

Rates = tuple["NDArray[np.float64]", ...]
"""A quantity (times, ...) alone, or with its first and second rate."""


def _product(multiply: Callable[[Any, Any], Any], p: Any, q: Any) -> Rates:
    """A product with its rates, by Leibniz's rule."""
    return tuple(sum(comb(k, i) * multiply(p[i], q[k - i]) for i in range(k + 1)) for k in range(len(p)))


def _dot(y: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.einsum("tc,tc->t", y, z))


def vector_area(arms: Sequence[Any]) -> Rates:
    """Vector area of the polygon of the arms (times, nodes, 3), with the rates that they have."""
    return tuple(y.sum(axis=1) for y in _product(np.cross, arms, [np.roll(y, -1, axis=1) for y in arms]))


def size(rates: Any) -> Rates:
    """Size of a vector with its rates; zero rates where it vanishes."""
    value = np.linalg.norm(rates[0], axis=1)
    if len(rates) == 1:
        return (value,)
    d, v, a = rates
    safe = np.where(value > 0, value, 1.0)
    rate = _dot(d, v) / safe
    second = (_dot(d, a) + _dot(v, v) - rate**2) / safe
    return value, rate, np.where(value > 0, second, 0.0)


def normalised(rates: Any) -> Rates:
    """Unit vector with its rates."""
    return (rates[0] / size(rates)[0][:, None],) if len(rates) == 1 else direction_rates(*rates)[1]


def gimbal_angles(normal: Rates, base: list[Any] | None, names: Sequence[str] | None) -> dict[str, Rates]:
    """beta and gamma of a normal in the frame of the base, with their rates."""
    zero = np.zeros_like(normal[0])
    frame: list[Any] = [(zero + axis, zero, zero)[: len(normal)] for axis in np.eye(3)]
    if base is not None:
        inertia_of(base[0], names or (), 3)
        up = normalised(vector_area(base))
        side = [y[:, 1] - y[:, 0] for y in base]
        ahead = normalised(_product(np.cross, up, side))  # y = z x (first to second), so that x lies in the plane
        frame = [_product(np.cross, ahead, up), ahead, up]
    x, y, z = (_product(_dot, normal, axis) for axis in frame)
    return {"beta": turn(z, tuple(-part for part in y)), "gamma": _tilt(x, y, z)}


def turn(c: Any, s: Any) -> Rates:
    """Angle of the vector (c, s) with its rates, unwrapped."""
    value = np.unwrap(np.arctan2(s[0], c[0]))
    if len(c) == 1:
        return (value,)
    square, slope = c[0] ** 2 + s[0] ** 2, 2 * (c[0] * c[1] + s[0] * s[1])
    rate = (c[0] * s[1] - s[0] * c[1]) / square
    return value, rate, (c[0] * s[2] - s[0] * c[2]) / square - slope * rate / square


def _tilt(x: Any, y: Any, z: Any) -> Rates:
    """gamma = atan2(-x, sqrt(y^2 + z^2))."""
    pair = [np.stack([p, q], axis=1) for p, q in zip(y, z, strict=True)]
    return turn(size(pair), tuple(-part for part in x))


# Mean rigid motion of a group of nodes: centroid, arms from it, angular velocity and acceleration.


def centred(system: System, histories: list[NDArray[np.float64]], names: Sequence[str]) -> tuple[list[Any], list[Any]]:
    """Centroid (times, 3) of named nodes and their arms from it (times, nodes, 3), each with two rates."""
    least = system.dim
    if not isinstance(names, str):
        names = names_of(names, f"at least {least} nodes, e.g. ('N7', 'N9', 'N8')")
    if isinstance(names, str) or len(set(names)) != len(names) or len(names) < least:
        raise InputError(f"{names!r} is no plane. Name at least {least} different nodes, e.g. ('N7', 'N9', 'N8').")
    if unknown := [name for name in names if name not in system.nodes]:
        raise InputError(f"No node called {unknown[0]!r}. {nearest(unknown[0], system.nodes)}")
    index = [system.node_index(name) for name in names]
    nodes = [y.reshape(len(y), -1, 3)[:, index] for y in histories]
    centre = [y.mean(axis=1) for y in nodes]
    return centre, [y - c[:, None] for y, c in zip(nodes, centre, strict=True)]


def inertia_of(r: NDArray[np.float64], names: Sequence[str], dim: int) -> NDArray[np.float64]:
    """sum |r|^2 1 - r r^T (times, 3, 3) of arms r (times, nodes, 3).

    Raises
    ------
    InputError : the nodes are on one line.
    """
    matrix = _second_moment(r, r)
    if dim == 2:  # about z alone; nodes on one line are enough
        matrix[:, :2], matrix[:, :, :2] = 0.0, 0.0
        matrix[:, 0, 0] = matrix[:, 1, 1] = matrix[:, 2, 2]
    size = np.linalg.eigvalsh(matrix)
    if np.any(size[:, 0] < 1e-9 * size[:, -1]):
        raise InputError(f"Nodes {', '.join(names)} lie on one line, so they span no plane. Name another one.")
    return matrix


def spin_of(arms: list[Any], names: Sequence[str], dim: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """w = I^-1 h and its derivative I^-1 (h' - I' w), with h = sum r x r' and I = sum |r|^2 1 - r r^T."""
    r, v, a = arms
    matrix, change = inertia_of(r, names, dim), _second_moment(r, v)
    change = change + change.transpose(0, 2, 1)
    if dim == 2:
        change[:, :2], change[:, :, :2] = 0.0, 0.0
    w = np.linalg.solve(matrix, np.cross(r, v).sum(axis=1)[..., None])
    left = np.cross(r, a).sum(axis=1)[..., None] - change @ w
    return w[..., 0], np.linalg.solve(matrix, left)[..., 0]


def _second_moment(p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """sum p . q 1 - p q^T over the nodes, (times, 3, 3)."""
    return np.asarray(np.einsum("tnc,tnc->t", p, q)[:, None, None] * np.eye(3) - np.einsum("tni,tnj->tij", p, q))
