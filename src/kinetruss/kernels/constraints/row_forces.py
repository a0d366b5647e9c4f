"""Known forces of rows put onto joints and nodes."""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F2, Floats, Ints
from kinetruss.kernels.constraints.rows import unit_gradient
from kinetruss.kernels.structure.mass import between
from kinetruss.kernels.structure.plan import SUM

__all__ = ["row_forces"]


@kernel
def row_forces(member: Ints, kind: Ints, A: Ints, B: Ints, x: F2, N: F2, joint: Floats, rest: F2) -> None:
    """Add the force of every row to joint (times, members, 2, 3), and take it from rest (times, 3 n). Sums are left out.

    member, kind, A, B (rows,): member of the row, LENGTH or ANGLE, flat first coordinates of its ends. x (times, 3 n) positions
    that fulfil the rows; N (times, rows): tension, or of an angle row minus the torque over the length.
    """
    # J^T N row by row: tension N along g, -N g on the member at A, +N g at B; the nodes take the opposite
    for i in range(x.shape[0]):
        for k in range(A.size):
            if kind[k] == SUM:
                continue
            a, b, m = A[k], B[k], member[k]
            g = unit_gradient(kind[k], between(x[i], a, b))
            for c in range(3):
                force = N[i, k] * g[c]
                joint[i, m, 0, c] -= force
                joint[i, m, 1, c] += force
                rest[i, a + c] += force
                rest[i, b + c] -= force
