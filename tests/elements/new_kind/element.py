"""Drag on nodes with an elastic bedding: F = -c |v| v - k (x - x0), c = density coefficient area/2."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, F2, I1, I2, Record, record
from kinetruss.kernels.structure import element_table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


@record
class Drags(Record):
    """at (k,) flat nodes, c (k,) N s^2/m^2, stiff (k,) N/m, start (k, 3) m."""

    at: I1
    c: F1
    stiff: F1
    start: F2


@kernel
def force(s: Drags, t: float, x: F1, v: F1, f: F1) -> None:
    """As kernels.structure.element_table.force."""
    for k in range(s.at.size):
        A = s.at[k]
        speed = math.sqrt(v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2])
        for i in range(3):
            f[A + i] -= s.c[k] * speed * v[A + i] + s.stiff[k] * (x[A + i] - s.start[k, i])


@kernel
def energy(s: Drags, x: F1) -> float:
    """As kernels.structure.element_table.energy: k |x - x0|^2/2."""
    total = 0.0
    for k in range(s.at.size):
        for i in range(3):
            total += 0.5 * s.stiff[k] * (x[s.at[k] + i] - s.start[k, i]) ** 2
    return total


@kernel
def balance(s: Drags, t: float, x: F1, v: F1, out: F1) -> None:
    """As kernels.structure.element_table.balance."""
    for k in range(s.at.size):
        A = s.at[k]
        square = v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2]
        out[2] += s.c[k] * square * math.sqrt(square)
        for i in range(3):
            d = x[A + i] - s.start[k, i]
            out[0] += 0.5 * s.stiff[k] * d * d
            out[1] += s.stiff[k] * d * v[A + i]


@kernel
def tangent(s: Drags, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """As kernels.structure.element_table.tangent: c (|v| 1 + v v^T/|v|) and k 1."""
    for k in range(s.at.size):
        A = s.at[k]
        speed = math.sqrt(v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2])
        for i in range(3):
            value[at[k, 4 * i]] += beta * s.stiff[k] + gamma * s.c[k] * speed
            for j in range(i + 1):
                if speed > 0.0:
                    value[at[k, 3 * i + j]] += gamma * s.c[k] * v[A + i] * v[A + j] / speed


@kernel
def swap(s: Drags, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """As kernels.structure.element_table.swap: the force of the bedding half way from x0 to x1."""
    for k in range(s.at.size):
        for i in range(3):
            j = s.at[k] + i
            f[j] += s.stiff[k] * (xe[j] - 0.5 * (x0[j] + x1[j]))


KERNELS = dict(enumerate(zip(element_table.INTERFACES, (force, energy, balance, tangent, swap), strict=True)))


def table(system: System) -> Drags | None:
    """All drags of a system; None where there are none."""
    own = fields(system)
    return None if own is None else Drags.of(own)


def fields(system: System) -> dict[str, Any] | None:
    """The fields of `table`."""
    own: dict[str, Any] = system.model.drags
    if not own:
        return None
    area, coefficient, density, bedding = np.moveaxis(
        system.numbers("drag", "area", "coefficient", "density", "bedding"), -1, 0
    )
    at = np.array([system.node_index(one.node) for one in own.values()], np.int64)
    return {
        "at": 3 * at,
        "c": density * coefficient * area / 2,
        "stiff": np.where(np.isnan(bedding), 0.0, bedding),
        "start": system.x0[..., at, :],
    }


def coordinates(s: Drags) -> NDArray[np.int64]:
    """Those of the nodes."""
    return s.at[:, None] + np.arange(3)


def tangents(system: System, record: Drags, x: NDArray[np.float64], v: NDArray[np.float64] | None) -> tuple[Any, Any]:
    """As elements.kinds.Element.tangents."""
    flat, shape = coordinates(record).ravel(), (x.size, x.size)
    K = csr_array(coo_array((np.repeat(record.stiff, 3), (flat, flat)), shape=shape))
    if v is None:
        return K, csr_array(shape)
    own = np.reshape(v, (-1, 3))[record.at // 3]
    speed = np.linalg.norm(own, axis=1)[:, None, None]
    direction = own / np.where(speed[:, 0] > 0.0, speed[:, 0], 1.0)
    blocks = record.c[:, None, None] * speed * (np.eye(3) + direction[:, :, None] * direction[:, None, :])
    rows, columns = np.broadcast_arrays(coordinates(record)[:, :, None], coordinates(record)[:, None, :])
    return K, csr_array(coo_array((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=shape))


def results(system: System, record: Drags, t: Any, x: Any, v: NDArray[np.float64]) -> Any:
    """As elements.kinds.Element.results."""
    from kinetruss.elements.kinds import Results

    place, own = (y.reshape(len(y), -1, 3)[:, record.at // 3] for y in (x, v))
    force = -record.c[:, None] * np.linalg.norm(own, axis=2, keepdims=True) * own
    force -= record.stiff[:, None] * (place - record.start)
    return Results("drag", tuple(system.model.drags), {"force": (force, "N", "resistance on the node")})
