"""What passes between base and tube of an active member."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["interface"]


def interface(
    system: System,
    gravity: NDArray[np.float64],
    x: NDArray[np.float64],
    v: NDArray[np.float64],
    a: NDArray[np.float64],
    joint: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force and moment (times, active, 3), global axes, from the tube on the base at the tube's free end.

    Free body of the tube (mass m, length l, clamped at B, a(s') = a_B - s' u''):
    S = F_B - m (a_B - g - l/2 u''), M = l u x F_B - u x m (l/2 (a_B - g) - l^2/6 u'') - i u x u''.
    x, v, a : (times, n, 3); joint : (times, members, 2, 3).
    """
    active = np.flatnonzero(system.two_rods)
    A, B = system.p[active], system.q[active]
    d, dv, da = (y[:, B] - y[:, A] for y in (x, v, a))
    L = np.linalg.norm(d, axis=2, keepdims=True)
    u = d / L
    Ld = np.sum(u * dv, axis=2, keepdims=True)
    w = (dv - Ld * u) / L
    Ldd = np.sum(u * da, axis=2, keepdims=True) + L * np.sum(w * w, axis=2, keepdims=True)
    dw = (da - Ldd * u - 2 * Ld * w) / L
    m, length, rotary = (system.rods[active, k][None, :, None] for k in (3, 4, 5))
    b = a[:, B] - gravity
    F = joint[:, active, 1]
    force = F - m * (b - length / 2 * dw)
    moment = np.cross(u, length * F - m * (length / 2 * b - length**2 / 6 * dw) - rotary * dw)
    return force, moment
