"""Rows that hold a structure, with their first and second derivatives along a motion.

A coordinate s of a member (length or angle) with end difference d keeps g . dd = r ds for small changes at one instant, and
along a motion

    g . dd'  = r ds'  + r' ds - g' . dd
    g . dd'' = r ds'' + 2 r' ds' + r'' ds - 2 g' . dd' - g'' . dd,

with g = d/L, g' = d'/L, r = 1 of a length (from the quadratic form |d|^2 = s^2, whose Hessian is constant), and
g = n, g' = -w u, r = L of an angle (from n(s) . d = 0; w, w' its rates). Exact to first order in the change, for any motion.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.sparse import csr_array, vstack

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.mechanics import System, measure_gradients, measure_turning

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

__all__ = ["Jets", "held_rows", "member_jets", "sum_jets"]


class Jets(NamedTuple):
    """Rows g, g', g'' (k, 3 n) sparse, and r, r', r'' (k, 3) of k coordinates."""

    g: tuple[Any, Any, Any]
    r: NDArray[np.float64]


def member_jets(
    system: System, member: NDArray[np.int64], angle: NDArray[np.bool_], x: NDArray[np.float64],
    v: NDArray[np.float64] | None = None, a: NDArray[np.float64] | None = None,
) -> Jets:  # fmt: skip
    """Jets of lengths and angles of members, at x, v, a (n, 3)."""
    p, q = system.p[member], system.q[member]
    d, dv, da = (np.zeros((len(p), 3)) if y is None else y[q] - y[p] for y in (x, v, a))
    L = np.linalg.norm(d, axis=1, keepdims=True)
    u = d / L
    Ld = _dot(u, dv)
    Ldd = _dot(u, da) + (_dot(dv, dv) - Ld**2) / L
    g0, g1, g2 = u.copy(), dv / L, da / L
    r = np.hstack([np.ones_like(L), Ld / L, Ldd / L])
    if angle.any():
        n = np.stack([-u[:, 1], u[:, 0], np.zeros(len(u))], axis=1)
        w = _dot(n, dv) / L
        wd = (_dot(n, da) - 2 * Ld * w) / L
        g0[angle], g1[angle], g2[angle] = n[angle], (-w * u)[angle], (-wd * u)[angle]
        r[angle] = np.hstack([L, Ld, _dot(u, da) + 2 * L * w**2])[angle]
    if v is None and a is None:
        still = csr_array((len(p), system.x0.size))
        return Jets(g=(_placed(system, p, q, g0), still, still), r=r)
    return Jets(g=(_placed(system, p, q, g0), _placed(system, p, q, g1), _placed(system, p, q, g2)), r=r)


def held_rows(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None, a: NDArray[np.float64] | None = None
) -> Jets:
    """Jets of all rows of a system; those of sums times their scale, so that gradients are of one size."""
    if not len(system.row_member):
        none = csr_array((0, system.x0.size))
        return Jets(g=(none, none, none), r=np.zeros((0, 3)))
    jets = member_jets(system, system.row_member.astype(np.int64), system.row_kind == ANGLE, x, v, a)
    sums = system.sums
    if not len(sums):
        return jets
    own = sum_jets(system, system.row_measure[sums], x, v, a, scaled=True)
    order = np.arange(len(system.row_member))
    order[sums] = len(order) + np.arange(len(sums))
    g = [vstack([one, two], format="csr")[order] for one, two in zip(jets.g, own.g, strict=True)]
    return Jets(g=(g[0], g[1], g[2]), r=np.vstack([jets.r, own.r])[order])


def sum_jets(
    system: System, measures: Iterable[int], x: NDArray[np.float64], v: NDArray[np.float64] | None,
    a: NDArray[np.float64] | None, *, scaled: bool = False,
) -> Jets:  # fmt: skip
    """Jets of measures: s is the sum itself, so that r is 1 (or the scale) and does not change."""
    rows: list[tuple[NDArray[np.float64], ...]] = []
    r: list[tuple[float, float, float]] = []
    for m in measures:
        size = float(system.measure_scale[m]) if scaled else 1.0
        rows.append(
            tuple(size * one for one in (measure_gradients(system, m, x[None])[0], *measure_turning(system, m, x, v, a)))
        )
        r.append((size, 0.0, 0.0))
    g = [csr_array(np.array([row[order] for row in rows]).reshape(-1, x.size)) for order in range(3)]
    return Jets(g=(g[0], g[1], g[2]), r=np.array(r, float).reshape(-1, 3))


def _placed(system: System, p: NDArray[Any], q: NDArray[Any], g: NDArray[np.float64]) -> Any:
    """Rows (k, 3 n) with -g at p and g at q."""
    columns = np.stack([3 * p + c for c in range(3)] + [3 * q + c for c in range(3)], axis=1).astype(np.int64)
    start = np.arange(0, 6 * len(p) + 1, 6)
    return csr_array((np.hstack([-g, g]).reshape(-1), columns.reshape(-1), start), shape=(len(p), system.x0.size))


def _dot(one: NDArray[np.float64], two: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.sum(one * two, axis=1, keepdims=True))
