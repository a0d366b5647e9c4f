"""Known forces of rows put onto joints and nodes."""

from __future__ import annotations

import math

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.structure.plan import ANGLE, SUM

__all__ = ["row_pulls"]


@kernel
def row_pulls(member, kind, A, B, x, N, joint, rest):  # type: ignore[no-untyped-def]
    """Add the pull of every row to joint (times, members, 2, 3), and take it from rest (times, 3 n). Sums are left out.

    member, kind, A, B (rows,): member of the row, LENGTH or ANGLE, flat first coordinates of its ends. x (times, 3 n) positions
    that fulfil the rows; N (times, rows): tension, or of an angle row minus the torque over the length.
    """
    for i in range(x.shape[0]):
        for k in range(A.size):
            if kind[k] == SUM:
                continue
            a, b, m = A[k], B[k], member[k]
            dx, dy, dz = x[i, b] - x[i, a], x[i, b + 1] - x[i, a + 1], x[i, b + 2] - x[i, a + 2]
            L = math.sqrt(dx * dx + dy * dy + dz * dz)
            if kind[k] == ANGLE:
                dx, dy, dz = -dy, dx, 0.0
            scale = N[i, k] / L
            for c, d in ((0, dx), (1, dy), (2, dz)):
                pull = scale * d
                joint[i, m, 0, c] -= pull
                joint[i, m, 1, c] += pull
                rest[i, a + c] += pull
                rest[i, b + c] -= pull
