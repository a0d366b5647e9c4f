"""Gradients of the constraints, their Jacobians, and how they turn along a motion.

A length has the direction u = d/L at end B and -u at A; an angle, times the length of its member, u turned by 90 degrees; a sum
the gradient of its measure times its scale. All are of unit size.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array

from kinetruss.elements.caching import cached
from kinetruss.elements.local_axes import turned
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics.measures import measure_curvature, measure_flats, measure_gradients

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


RANK_TOLERANCE = 1e-9
"""Singular values of the row-normalised Jacobian below this fraction of the largest count as zero."""

Three = tuple["NDArray[Any]", "NDArray[Any]", "NDArray[Any]"]
"""A quantity with its first and second rate."""


def ends_of(
    system: System, y: NDArray[np.float64], member: Any = slice(None)
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Differences d (..., k, 3), lengths (..., k), directions (..., k, 3) of members (k,), all by default, at y (..., n, 3)."""
    d = y[..., system.q[member], :] - y[..., system.p[member], :]
    L = np.linalg.norm(d, axis=-1)
    return d, L, d / L[..., None]


def direction_rates(d: NDArray[Any], dv: NDArray[Any], da: NDArray[Any]) -> tuple[Three, Three]:
    """L, L', L'' (..., 1) and u, u', u'' of vectors d (..., 3) with their rates dv, da; complex ones allowed.

    u' = (d' - L' u)/L, u'' = (d'' - L'' u - 2 L' u')/L.
    """
    L = np.sqrt(dot(d, d))
    u = d / L
    Ld = dot(u, dv)
    ud = (dv - Ld * u) / L
    Ldd = dot(u, da) + L * dot(ud, ud)
    return (L, Ld, Ldd), (u, ud, (da - Ldd * u - 2 * Ld * ud) / L)


def dot(one: NDArray[Any], two: NDArray[Any]) -> NDArray[Any]:
    """Products (..., 1) of vectors (..., 3); of complex ones without conjugation."""
    return np.asarray(np.sum(one * two, axis=-1, keepdims=True))


def row_ends(system: System, y: NDArray[np.float64], rows: Any = slice(None)) -> NDArray[np.float64]:
    """Differences (..., k, 3) of the ends of the members of rows (k,), of positions or their rates y (..., n, 3)."""
    member = system.row_member[rows]
    return np.asarray(y[..., system.q[member], :] - y[..., system.p[member], :])


def row_directions(
    system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None = None, rows: Any = slice(None)
) -> NDArray[np.float64]:
    """Gradients (..., k, 3) of rows (k,), all by default, by end B of their members at x (..., n, 3); zero of sums.

    Those of angles are normal to the members, or to the directions that drives at `values` (..., drives) prescribe.
    """
    member = system.row_member[rows]
    # d/L of a length, n of an angle, zero of a sum
    g = ends_of(system, x, member)[2]
    angle = system.row_kind[rows] == ANGLE
    if angle.any():
        u = g[..., angle, :]
        if values is not None:
            theta = values[..., system.row_drive[rows][angle]]
            u = np.stack([np.cos(theta), np.sin(theta), np.zeros_like(theta)], axis=-1)
        g[..., angle, :] = turned(u)
    g[..., system.row_measure[rows] >= 0, :] = 0.0
    return np.asarray(g)


def row_scales(system: System, x: NDArray[np.float64], rows: Any = slice(None)) -> NDArray[np.float64]:
    """Gradients of rows (k,) over those of their values, (..., k), at x (..., n, 3): 1 for lengths, L for angles, m."""
    found = np.where(system.row_kind[rows] == ANGLE, ends_of(system, x, system.row_member[rows])[1], 1.0)
    measure = system.row_measure[rows]
    found[..., measure >= 0] = system.measure_scale[measure[measure >= 0]]
    return np.asarray(found)


class _Pattern(NamedTuple):
    """Sparsity pattern of the Jacobian: columns, ascending in each row, and rows (entries,); start (rows + 1,).

    sign (rows, 1) of the end with the higher columns; plain (rows,): no sums; own (entries,): theirs.
    """

    column: NDArray[np.int32]
    row: NDArray[np.int64]
    start: NDArray[np.int32]
    sign: NDArray[np.float64]
    plain: NDArray[np.bool_]
    own: NDArray[np.bool_]


@cached()
def _pattern(system: System) -> _Pattern:
    """The constant pattern of the Jacobian of a system."""
    p, q, plain = system.p[system.row_member], system.q[system.row_member], system.row_measure < 0
    flats = [measure_flats(system, m) for m in system.row_measure[~plain]]
    count = np.full(len(plain), 6)
    count[~plain] = [len(one) for one in flats]
    row = np.repeat(np.arange(len(plain)), count)
    column, own = np.empty(len(row), np.int32), plain[row]
    ends = np.stack([np.minimum(p, q), np.maximum(p, q)], axis=1)[plain]
    column[own] = (3 * ends[:, :, None] + np.arange(3)).reshape(-1)
    column[~own] = np.concatenate([*flats, np.zeros(0)])
    start = np.concatenate([[0], np.cumsum(count)]).astype(np.int32)
    return _Pattern(column, row, start, np.where(p < q, 1.0, -1.0)[:, None], plain, own)


def _entries(system: System, g: NDArray[np.float64], sums: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Entries (..., entries) of rows with g (..., rows, 3) at B and -g at A, and with gradients (..., 3 n) of sums."""
    at = _pattern(system)
    g = at.sign * g
    both = np.concatenate([-g, g], axis=-1)
    if not len(sums):
        return both.reshape(*g.shape[:-2], -1)
    found = np.empty((*g.shape[:-2], len(at.column)))
    found[..., at.own] = both[..., at.plain, :].reshape(*g.shape[:-2], -1)
    for r, one in zip(system.sums, sums, strict=True):
        here = slice(at.start[r], at.start[r + 1])
        found[..., here] = one[..., at.column[here]]
    return found


def assembled(system: System, g: NDArray[np.float64], sums: Sequence[NDArray[np.float64]]) -> Any:
    """Sparse rows (rows, 3 n) with g (rows, 3) at end B of members and -g at A; those of sums are given, (3 n,) each."""
    at = _pattern(system)
    return csr_array((_entries(system, g, sums), at.column, at.start), shape=(len(at.plain), system.x0.size))


def _of_sums(system: System, x: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Gradients (times, 3 n) of each row that is a sum, times its scale, at x (times, n, 3)."""
    return [system.measure_scale[m] * measure_gradients(system, m, x) for m in system.row_measure[system.sums]]


def constraint_jacobian(system: System, x: NDArray[np.float64]) -> Any:
    """Gradients of all rows, sparse (rows, 3 n), at positions x (n, 3)."""
    return assembled(system, row_directions(system, x), [one[0] for one in _of_sums(system, x[None])])


def constraint_gradients(
    system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None = None
) -> NDArray[np.float64]:
    """Gradients of all rows, dense (times, rows, 3 n), at positions x (times, n, 3); see `row_directions`."""
    at = _pattern(system)
    found = np.zeros((len(x), len(at.plain), system.x0.size))
    found[:, at.row, at.column] = _entries(system, row_directions(system, x, values), _of_sums(system, x))
    return found


def jacobian(system: System, x: NDArray[np.float64], values: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """Dense Jacobian (rows, free coordinates) at positions x (n, 3), with angles at drive `values`, by default of the start."""
    given = system.drive_start if values is None else values
    return np.asarray(constraint_gradients(system, x[None], given[None])[0][:, system.free])


def length_hessians(u: NDArray[np.float64], L: NDArray[np.float64]) -> NDArray[np.float64]:
    """Second derivatives (k, 3, 3), 1/m, of lengths L (k,) by the difference of their ends, of direction u (k, 3)."""
    return np.asarray((np.eye(3) - u[:, :, None] * u[:, None, :]) / L[:, None, None])


def angle_hessians(u: NDArray[np.float64], L: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same of angles in the plane, times the length."""
    both = turned(u)[:, :, None] * u[:, None, :]
    return np.asarray(-(both + both.swapaxes(1, 2)) / L[:, None, None])


def constraint_curvature(system: System, x: NDArray[np.float64], F: NDArray[np.float64]) -> NDArray[np.float64]:
    """F_i^T H F_j (rows, k, k) with the Hessian H of each row times its scale, at x (n, 3), for the columns of F (3 n, k)."""
    _, L, u = ends_of(system, x, system.row_member)
    H, angle = length_hessians(u, L), system.row_kind == ANGLE
    H[angle] = angle_hessians(u[angle], L[angle])
    D = row_ends(system, F.T.reshape(F.shape[1], -1, 3)).transpose(1, 2, 0)
    found = D.swapaxes(1, 2) @ H @ D
    for r in system.sums:
        m = system.row_measure[r]
        found[r] = system.measure_scale[m] * measure_curvature(system, m, x, F)
    return np.asarray(found)
