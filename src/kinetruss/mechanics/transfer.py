"""First-order changes of all node coordinates when prescribed lengths, angles or coordinates change."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.sweep.blocks import transfer
from kinetruss.mechanics.accuracy import NEAR, NOTHING, error_of, lost
from kinetruss.mechanics.arrangement import Arrangement, arrange, rearrange
from kinetruss.mechanics.measures import measure_gradients
from kinetruss.mechanics.mobility import underdriven
from kinetruss.mechanics.positions import drive_values
from kinetruss.mechanics.row_gradients import row_directions, row_ends, row_scales
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray


def arrangement_at(system: System, x: NDArray[np.float64]) -> tuple[Arrangement, NDArray[np.bool_]]:
    """The arrangement, with the blocks, of a system at flat positions x (3 n,), and the mask of rows that cannot change alone.

    Raises InputError for mechanisms that the drives do not hold.
    """
    found = arrange(system)
    if len(found.redundant) or found.plan is None:
        nodes = x.reshape(1, -1, 3)
        values, _, _ = drive_values(system, nodes, np.zeros_like(nodes), np.zeros_like(nodes))
        found = rearrange(system, nodes[0], values[0])
    if found.plan is None:
        raise underdriven(system)
    held = found.not_unique.copy()
    held[found.redundant] = True
    return found, held


def displacements(system: System, x: NDArray[np.float64], change: NDArray[np.float64]) -> NDArray[np.float64]:
    """Displacements (times, 3 n), m, that elongations of the rows (times, rows), m, cause at flat positions x (times, 3 n)."""
    found, _ = arrangement_at(system, x[0])
    y = np.zeros((len(x), 1, x.shape[1]))
    plan: Any = found.plan
    _transferred(system, found, x, np.ascontiguousarray(change[:, None, plan.row]), y)
    return y[:, 0]


def transfers(
    system: System, x: NDArray[np.float64], rows: NDArray[np.int64], coordinates: NDArray[np.int64]
) -> NDArray[np.float64]:
    """d(node coordinates)/d(rows, then prescribed coordinates), (times, 3 n, k), all other rows and coordinates held.

    x (times, 3 n) m; rows are indices, a length counts in m and an angle in rad; coordinates are flat indices.

    Raises InputError for a row that other rows hold too.
    """
    found, held = arrangement_at(system, x[0])
    if np.any(held[rows]):
        name = system.part_of(rows[held[rows]][0])
        raise InputError(f"{name!r} is held by other bars or drives too, so it cannot change alone. Choose another coordinate.")
    plan: Any = found.plan
    place = np.empty(len(system.row_member), np.int64)
    place[plan.row] = np.arange(len(plan.row))
    k = len(rows) + len(coordinates)
    rhs, y = np.zeros((len(x), k, len(plan.row))), np.zeros((len(x), k, x.shape[1]))
    rhs[:, np.arange(len(rows)), place[rows]] = row_scales(system, x.reshape(len(x), -1, 3), rows)
    y[:, np.arange(len(rows), k), coordinates] = 1.0
    _transferred(system, found, x, rhs, y)
    return y.transpose(0, 2, 1)


def _transferred(
    system: System, found: Arrangement, x: NDArray[np.float64], rhs: NDArray[np.float64], y: NDArray[np.float64]
) -> None:
    """The kernel `transfer`; AnalysisError at a singular position, where there is no change or one of many."""
    pivot = np.empty(len(x))
    transfer(found.plan, np.ascontiguousarray(x), rhs, y, pivot)
    for k in np.flatnonzero(pivot < NEAR):
        if error_of(*lost(system, found, x[k].tobytes())) >= NOTHING:
            raise AnalysisError(
                f"Position {k} of {len(x)} is singular: drives and bars leave a motion free there, so that positions have no "
                "derivatives by them. Take another position."
            )


def contradicted(system: System, x: NDArray[np.float64], S: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Redundant rigid rows that the columns of S (times, 3 n, k) would change, with these columns."""
    _, held = arrangement_at(system, x[0])
    nodes, y = x.reshape(len(x), -1, 3), S.transpose(0, 2, 1)
    found = []
    for r in np.flatnonzero(held & (system.row_drive < 0)):
        if (m := system.row_measure[r]) >= 0:
            off = np.einsum("tkc,tc->tk", y, measure_gradients(system, m, nodes) * system.measure_scale[m])
        else:
            apart = row_ends(system, y.reshape(*y.shape[:2], -1, 3), [r])
            off = np.einsum("tkrc,trc->tk", apart, row_directions(system, nodes, rows=[r]))
        bad = np.abs(off).max(axis=0, initial=0.0) > 1e-9 * np.abs(y).max(axis=(0, 2), initial=1.0)
        found += [(int(r), int(k)) for k in np.flatnonzero(bad)]
    return found


def flat_positions(system: System, position: NDArray[np.float64]) -> NDArray[np.float64]:
    """(times, nodes, dim) as (times, 3 n), z = 0 in the plane."""
    full = np.zeros((len(position), len(system.nodes), 3))
    full[:, :, : system.dim] = position
    return full.reshape(len(position), 3 * len(system.nodes))
