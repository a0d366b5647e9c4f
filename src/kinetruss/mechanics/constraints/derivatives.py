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
from scipy.sparse import csr_array

from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.mechanics.structure.constraint_gradients import (
    assembled,
    constraint_jacobian,
    direction_rates,
    row_ends,
    row_scales,
    turned,
)
from kinetruss.mechanics.structure.hessians import measure_turning

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.structure.system import System

__all__ = ["Derivatives", "held_rows"]


class Derivatives(NamedTuple):
    """Rows g, g', g'' (k, 3 n) sparse, and r, r', r'' (k, 3) of k coordinates."""

    g: tuple[Any, Any, Any]
    r: NDArray[np.float64]


def held_rows(
    system: System, x: NDArray[np.float64], v: NDArray[np.float64] | None = None, a: NDArray[np.float64] | None = None
) -> Derivatives:
    """Derivatives of all rows of a system at x, v, a (n, 3); those of sums times their scale: gradients are of one size."""
    first, r = constraint_jacobian(system, x), np.zeros((len(system.row_member), 3))
    r[:, 0] = row_scales(system, x)
    if v is None and a is None:
        still = csr_array(first.shape)
        return Derivatives(g=(first, still, still), r=r)
    # of lengths: g' = d'/L, r' = L'/L
    d, dv, da = (np.zeros((len(r), 3)) if y is None else row_ends(system, y) for y in (x, v, a))
    (L, Ld, Ldd), (u, ud, udd) = direction_rates(d, dv, da)
    g1, g2 = dv / L, da / L
    r[:, 1:] = np.hstack([Ld, Ldd]) / L
    if (angle := system.row_kind == ANGLE).any():
        # of angles: g' = -w u, r'' = L'' + L w^2
        w, wd = (np.sum(turned(u) * one, axis=1, keepdims=True) for one in (ud, udd))
        g1[angle], g2[angle] = (-w * u)[angle], (-wd * u)[angle]
        r[angle, 1:] = np.hstack([Ld, Ldd + L * w**2])[angle]
    # of sums: H v and its rate
    measures = system.row_measure[system.sums]
    r[system.sums, 1:] = 0.0
    turning = [[system.measure_scale[m] * one for one in measure_turning(system, m, x, v, a)] for m in measures]
    later = [assembled(system, g, [both[k] for both in turning]) for k, g in enumerate((g1, g2))]
    return Derivatives(g=(first, later[0], later[1]), r=r)
