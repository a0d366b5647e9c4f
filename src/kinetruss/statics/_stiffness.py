"""The stiffness method: a sparse symmetric solve for small displacements of pin-jointed bars.

Bars with a flexibility f = l/(E A), or one over the slope of their law, carry N = e/f, e = G u; bars without one, and locked
angles, are inextensible and carry a multiplier: [[G^T f^-1 G, R^T], [R, 0]] [u, N] = [F, 0].
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import block_array, csc_array, csr_array
from scipy.sparse.linalg import splu

from kinetruss.dynamics._continua import continua_stiffness
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels._laws import tangents
from kinetruss.kernels._plan import ANGLE, LENGTH
from kinetruss.kinematics._mobility import mobility_at
from kinetruss.system import FREE, NONE, System, measure_gradients

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Solved", "flexibility", "row_matrix", "solve", "stiff_rows"]

WEAK = 1e-10
"""Smallest pivot, as a share of the largest, that passes without a look at the rank."""

STEPS = 3
"""The solution and two steps of iterative refinement."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Solved:
    """displacement (3 n,) m, elongation (rows,) m and force (rows,) N of the rows of `stiff_rows`."""

    displacement: NDArray[np.float64]
    elongation: NDArray[np.float64]
    force: NDArray[np.float64]


@lru_cache(maxsize=32)
def stiff_rows(system: System) -> System:
    """The system with one row for every member that carries force, elastic ones included, then its driven angles and sums."""
    members = np.flatnonzero(system.kind != FREE)
    angles = system.row_kind != LENGTH
    count = len(members)
    return replace(
        system,
        row_member=np.concatenate([members, system.row_member[angles]]).astype(np.int32),
        row_kind=np.concatenate([np.full(count, LENGTH), system.row_kind[angles]]).astype(np.int8),
        row_drive=np.concatenate([np.full(count, -1), system.row_drive[angles]]).astype(np.int32),
        row_value=np.concatenate([system.length0[members], system.row_value[angles]]),
        row_measure=np.concatenate([np.full(count, -1), system.row_measure[angles]]),
    )


def flexibility(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """l/(E A) of the rows at positions x (n, 3), m/N; 0 for inextensible ones, infinite for slack cables.

    Of elastic bars and cables: one over the slope of their law at the length they have.
    """
    i = held.row_member
    length = np.linalg.norm(x[held.q[i]] - x[held.p[i]], axis=1)
    found = np.nan_to_num(held.compliance[i]) * length
    if held.law.any():
        slope = np.empty((1, len(i)))
        tangents(held.law[i], held.spring[i], held.natural[i], length[None], slope)
        pulling = held.law[i] != NONE
        with np.errstate(divide="ignore"):
            found[pulling] = 1 / slope[0, pulling]
    found[held.row_kind != LENGTH] = 0.0
    return np.asarray(found)


def row_matrix(held: System, x: NDArray[np.float64]) -> csr_array:
    """Gradients of the rows by all coordinates, (rows, 3 n): unit vectors, -u at A and u at B (angles: across the bar)."""
    p, q = held.p[held.row_member], held.q[held.row_member]
    d = x[q] - x[p]
    g = d / np.linalg.norm(d, axis=1, keepdims=True)
    angle = held.row_kind == ANGLE
    g[angle] = np.stack([-g[angle, 1], g[angle, 0], np.zeros(angle.sum())], axis=1)
    columns = np.stack([3 * p + c for c in range(3)] + [3 * q + c for c in range(3)], axis=1)
    start = np.arange(0, 6 * len(p) + 1, 6)
    found = csr_array((np.hstack([-g, g]).reshape(-1), columns.reshape(-1), start), shape=(len(p), held.x0.size))
    if not len(held.sums):
        return found
    full = found.tolil()
    for r in held.sums:
        m = held.row_measure[r]
        full[r] = held.measure_scale[m] * measure_gradients(held, m, x[None])
    return csr_array(full)


def solve(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], load: NDArray[np.float64]) -> Solved:
    """Displacements and forces under nodal forces load (3 n,), N, at positions x (n, 3).

    Raises
    ------
    InputError : a mechanism, named; inextensible bars that share a force in no unique way.
    AnalysisError : a matrix that cannot be factored although its rank is full.
    """
    G = row_matrix(held, x)[:, held.free]
    soft = flexible > 0
    Gs, Gr = G[soft], G[~soft]
    continuum = _continuum(held, x)
    K = continuum + Gs.T @ csr_array((1 / flexible[soft], (np.arange(soft.sum()),) * 2), shape=(soft.sum(),) * 2) @ Gs
    size = float(K.diagonal().max(initial=0.0)) or 1.0
    matrix: Any = csc_array(block_array([[K / size, Gr.T], [Gr, None]])) if Gr.shape[0] else csc_array(K / size)
    count = len(held.free)
    u, force = np.zeros(count), np.zeros(len(flexible))
    if count:
        factors = _factored(held, x, flexible, matrix)
        # forces are summed up, not found from the displacements: what is left of the balance is then of their own
        # round-off, however badly conditioned K is
        for _ in range(STEPS):
            left = load[held.free] - G.T @ force - continuum @ u
            y = factors.solve(np.concatenate([left / size, -(Gr @ u)]))
            u += y[:count]
            force[soft] += (Gs @ y[:count]) / flexible[soft]
            force[~soft] += y[count:] * size
    displacement = np.zeros(held.x0.size)
    displacement[held.free] = u
    slack = np.isinf(flexible)
    elongation = np.where(slack, G @ u, np.where(slack, 0.0, flexible) * force)
    return Solved(displacement=displacement, elongation=elongation, force=force)


def _continuum(held: System, x: NDArray[np.float64]) -> Any:
    """Stiffness of membranes and solids among the free coordinates, N/m: without that of what they carry at x already."""
    count = len(held.free)
    if held.continua is None:
        return csr_array((count, count))
    none = np.zeros(len(held.continua.p))
    return csr_array(continua_stiffness(held.continua, x, none))[held.free][:, held.free]


def _factored(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64], matrix: Any) -> Any:
    """Sparse factors; where a pivot is weak, the rank decides."""
    try:
        factors = splu(matrix)
    except RuntimeError:
        _explain(held, x, flexible)
        raise AnalysisError("The stiffness matrix cannot be factored although its rank is full.") from None
    pivots = np.abs(factors.U.diagonal())
    if pivots.min() < WEAK * pivots.max():
        _explain(held, x, flexible)
    return factors


def _explain(held: System, x: NDArray[np.float64], flexible: NDArray[np.float64]) -> None:
    """InputError that names the mechanism, or the inextensible bars whose forces are not unique."""
    pulling = _rows_of(held, np.isfinite(flexible))  # slack cables hold nothing
    found = mobility_at(pulling, x, _angles(pulling, x))
    if found.undriven:
        moves = "; ".join(found.mechanism_texts()[:4])
        raise InputError(
            f"The structure is a mechanism here, with all drives locked ({found.undriven} "
            f"freedom{'s' if found.undriven != 1 else ''}): {moves}. Add a bar or a support for each."
        )
    rigid = _rows_of(held, flexible == 0)
    shared = mobility_at(rigid, x, _angles(held, x))
    if shared.self_stress:
        raise InputError(
            f"The forces of inextensible bars are not unique: {shared.self_stress_texts()[0]}. "
            "Give them a section and a material (E and A)."
        )


def _rows_of(held: System, chosen: NDArray[np.bool_]) -> System:
    """The system with some of its rows only."""
    return held.with_rows(chosen)


def _angles(held: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Drive values of which only the angles count: what the bars stand at."""
    found = held.drive_start.copy()
    for r in np.flatnonzero(held.row_kind == ANGLE):
        d = x[held.q[held.row_member[r]]] - x[held.p[held.row_member[r]]]
        found[held.row_drive[r]] = np.arctan2(d[1], d[0])
    return found
