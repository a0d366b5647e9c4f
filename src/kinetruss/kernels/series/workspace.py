"""Workspace of the power series of a motion, in two buffers (`kernels.compiled.parts`).

Row j of a part is the order j in tau = (t - t0)/s.

X (3 n,) places. D (axes r,) differences of the ends of rows, axis by axis; G the same of their directions where some turn at a
given angle, else empty (they are D); Q (r,) force densities, of an angle row forces; SQUARES (r,) of wanted lengths where some
change in time. MOTIONS (d,) of drives and supports. Bars with a law: LAW_D (3 s,), LAW_W squares of lengths, LAW_L lengths,
LAW_R quotients by them, LAW_Q densities (s,). Given forces: FORCE_D (3 g,), FORCE_W what they are divided by, FORCE_Q (g,)
densities. SUMS (2, .), PULLS (r,) : scratch. NORMS (2, orders) : how large each order is.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.jit import kernel_inner, kernel_making
from kinetruss.kernels.compiled.parts import integers
from kinetruss.kernels.structure import equations as e
from kinetruss.kernels.structure.plan import ANGLE

__all__ = ["AXES", "SeriesRoom", "series_room"]

PARTS = 18
(
    X_, D_, G_, Q_, SQUARES, MOTIONS, LAW_D, LAW_W, LAW_L, LAW_R, LAW_Q, FORCE_D, FORCE_W, FORCE_Q, SUMS, PULLS, NORMS, AXES,
) = range(PARTS)  # fmt: skip


class SeriesRoom(NamedTuple):
    """See above; the last part is no array of reals but the number of axes in which something moves, 2 or 3."""

    ints: NDArray[np.int64]
    reals: NDArray[np.float64]


@kernel_inner
def _axes(eq, stand):  # type: ignore[no-untyped-def]
    """2 where all is and stays in the plane z = 0."""
    free, held = integers(eq, e.FREE), integers(eq, e.HELD)
    for i in range(free.size):
        if free[i] % 3 == 2:
            return 3
    for i in range(held.size):
        if held[i] % 3 == 2:
            return 3
    for c in range(2, stand.size, 3):
        if stand[c] != 0.0:
            return 3
    return 2


@kernel_making
def series_room(eq, stand, orders):  # type: ignore[no-untyped-def]
    """Room for the orders 0 to `orders` of the places; stand (3 n,) : where prescribed coordinates are, m."""
    kind, motion = integers(eq, e.KIND), integers(eq, e.MOTION)
    r, s, g, n = kind.size, integers(eq, e.LAW_A).size, integers(eq, e.FORCE_KIND).size, stand.size
    axes, turning, moving = _axes(eq, stand), False, False
    for k in range(r):
        turning = turning or kind[k] == ANGLE
        moving = moving or motion[k] >= 0
    rows, widest = orders + 1, max(axes * r, 3 * s)
    table = (
        (X_, rows, n), (D_, rows, axes * r), (G_, rows if turning else 0, axes * r), (Q_, rows, r),
        (SQUARES, rows if moving else 0, r), (MOTIONS, rows, integers(eq, e.MOTION_KIND).size),
        (LAW_D, rows, 3 * s), (LAW_W, rows, s), (LAW_L, rows, s), (LAW_R, rows, s), (LAW_Q, rows, s),
        (FORCE_D, rows, 3 * g), (FORCE_W, rows, g), (FORCE_Q, rows, g), (SUMS, 2, widest), (PULLS, r, 1),
        (NORMS, 2, rows),
    )  # fmt: skip
    ints, at = np.zeros(3 * PARTS + 1, np.int64), 0
    for part, height, width in table:
        ints[3 * part], ints[3 * part + 1], ints[3 * part + 2] = at, height, width
        at += height * width
    ints[3 * AXES], ints[3 * AXES + 1], ints[3 * AXES + 2] = 3 * PARTS, 1, 1
    ints[3 * PARTS] = axes
    return SeriesRoom(ints, np.zeros(at))
