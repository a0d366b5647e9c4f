"""Nodes of a rigid platform whose place and turns are given in time, with two exact rates.

Position of a node: c + p + R s, with the displacement p, R = Rz(yaw) Ry(pitch) Rx(roll) and s its place from the centre c.
Quantities have their value and two derivatives in time along the first axis; products follow Leibniz's rule.
"""

from __future__ import annotations

import math

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_inline
from kinetruss.kernels.compiled.record import F1, F2, Floats

__all__ = ["platform_motion"]


@kernel_inline
def _turned(axis: int, angle: float, rate: float, second: float, R: Floats, column: F2) -> None:
    """R and its two rates (3, 3, 3) times the rotation about an axis, in place; column (3, 2) is scratch.

    In the columns i, j across the axis [C_i, C_j] becomes [c C_i + s C_j, c C_j - s C_i].
    """
    c, s = math.cos(angle), math.sin(angle)
    c1, s1 = -s * rate, c * rate
    c2, s2 = -c * rate * rate - s * second, c * second - s * rate * rate
    i, j = (axis + 1) % 3, (axis + 2) % 3
    # R and its two derivatives, row by row, times the elementary rotation (Leibniz)
    for row in range(3):
        for order in range(3):
            column[order, 0], column[order, 1] = R[order, row, i], R[order, row, j]
        p, p1, p2, q, q1, q2 = column[0, 0], column[1, 0], column[2, 0], column[0, 1], column[1, 1], column[2, 1]
        R[0, row, i], R[0, row, j] = c * p + s * q, c * q - s * p
        R[1, row, i], R[1, row, j] = c1 * p + c * p1 + s1 * q + s * q1, c1 * q + c * q1 - s1 * p - s * p1
        R[2, row, i] = c2 * p + 2.0 * c1 * p1 + c * p2 + s2 * q + 2.0 * s1 * q1 + s * q2
        R[2, row, j] = c2 * q + 2.0 * c1 * q1 + c * q2 - s2 * p - 2.0 * s1 * p1 - s * p2


@kernel
def platform_motion(centre: F1, arms: F2, motion: Floats, out: Floats) -> None:
    """Fill out (3, times, nodes, dim) with positions (m), velocities and accelerations of nodes at centre + arms (nodes, 3).

    motion (3, times, 6): displacements x, y, z (m) and turns roll, pitch, yaw (rad), with their rates.
    """
    R, column = np.empty((3, 3, 3)), np.empty((3, 2))
    # R = Rz Ry Rx with two derivatives, then c + p + R s and its derivatives
    for i in range(out.shape[1]):
        R[:] = 0.0
        R[0, 0, 0] = R[0, 1, 1] = R[0, 2, 2] = 1.0
        for axis in (2, 1, 0):
            angle, rate, second = motion[0, i, 3 + axis], motion[1, i, 3 + axis], motion[2, i, 3 + axis]
            if angle != 0.0 or rate != 0.0 or second != 0.0:
                _turned(axis, angle, rate, second, R, column)
        for order in range(3):
            for n in range(out.shape[2]):
                for c in range(out.shape[3]):
                    place = motion[order, i, c] + (centre[c] if order == 0 else 0.0)
                    out[order, i, n, c] = (
                        place + R[order, c, 0] * arms[n, 0] + R[order, c, 1] * arms[n, 1] + R[order, c, 2] * arms[n, 2]
                    )
