"""Drag on nodes: F = -c |v| v, c = density coefficient area/2."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import coo_array, csr_array

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, I1, I2, Record, record
from kinetruss.kernels.structure import element_table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


@record
class Drags(Record):
    """at (k,) flat nodes, c (k,) N s^2/m^2."""

    at: I1
    c: F1


@kernel
def force(s: Drags, t: float, x: F1, v: F1, f: F1) -> None:
    """As kernels.structure.element_table.force."""
    for k in range(s.at.size):
        A = s.at[k]
        speed = math.sqrt(v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2])
        for i in range(3):
            f[A + i] -= s.c[k] * speed * v[A + i]


@kernel
def energy(s: Drags, x: F1) -> float:
    """As kernels.structure.element_table.energy: none is stored."""
    return 0.0


@kernel
def balance(s: Drags, t: float, x: F1, v: F1, out: F1) -> None:
    """As kernels.structure.element_table.balance."""
    for k in range(s.at.size):
        A = s.at[k]
        square = v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2]
        out[2] += s.c[k] * square * math.sqrt(square)


@kernel
def tangent(s: Drags, at: I2, x: F1, v: F1, beta: float, gamma: float, value: F1) -> None:
    """As kernels.structure.element_table.tangent: c (|v| 1 + v v^T/|v|)."""
    for k in range(s.at.size):
        A = s.at[k]
        speed = math.sqrt(v[A] * v[A] + v[A + 1] * v[A + 1] + v[A + 2] * v[A + 2])
        if speed == 0.0:
            continue
        for i in range(3):
            for j in range(i + 1):
                value[at[k, 3 * i + j]] += gamma * s.c[k] * (v[A + i] * v[A + j] / speed + (speed if i == j else 0.0))


@kernel
def swap(s: Drags, t: float, x0: F1, x1: F1, xe: F1, ve: F1, h: float, f: F1) -> None:
    """As kernels.structure.element_table.swap: nothing is stored."""


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
    area, coefficient, density = system.numbers("drag", "area", "coefficient", "density").T
    at = 3 * np.array([system.node_index(one.node) for one in own.values()], np.int64)
    return {"at": at, "c": (density * coefficient * area / 2).T}


def coordinates(s: Drags) -> NDArray[np.int64]:
    """Those of the nodes."""
    return s.at[:, None] + np.arange(3)


def tangents(system: System, record: Drags, x: NDArray[np.float64], v: NDArray[np.float64] | None) -> tuple[Any, Any]:
    """As elements.kinds.Element.tangents."""
    empty = csr_array((x.size, x.size))
    if v is None:
        return empty, empty
    own = np.reshape(v, (-1, 3))[record.at // 3]
    speed = np.linalg.norm(own, axis=1)[:, None, None]
    direction = own / np.where(speed[:, 0] > 0.0, speed[:, 0], 1.0)
    blocks = record.c[:, None, None] * speed * (np.eye(3) + direction[:, :, None] * direction[:, None, :])
    rows, columns = np.broadcast_arrays(coordinates(record)[:, :, None], coordinates(record)[:, None, :])
    return empty, csr_array(coo_array((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=empty.shape))


def results(system: System, record: Drags, t: Any, x: Any, v: NDArray[np.float64]) -> Any:
    """As elements.kinds.Element.results."""
    from kinetruss.elements.kinds import Results

    own = v.reshape(len(v), -1, 3)[:, record.at // 3]
    force = -record.c[:, None] * np.linalg.norm(own, axis=2, keepdims=True) * own
    return Results("drag", tuple(system.model.drags), {"force": (force, "N", "resistance on the node")})
