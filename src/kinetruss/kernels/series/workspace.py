"""Workspace of the power series of a motion.

Row j of an array is the order j in tau = (t - t0)/s.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel, kernel_bare
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.compiled.record import F1, F2, I0, Record, record
from kinetruss.kernels.structure.equations import Equations
from kinetruss.kernels.structure.plan import ANGLE

__all__ = ["SeriesWork", "series_work"]


@record
class SeriesWork(Record):
    """axes : in how many something moves, 2 or 3. x (3 n,) places.

    Rows: d (axes r,) differences of their ends, axis by axis; g the same of their directions where some turn at a given angle,
    else empty (they are d); q (r,) force densities, of an angle row forces; squares (r,) of wanted lengths where some change in
    time. motions (d,) of drives and supports. Bars with a law: law_d (3 s,), law_w squares of lengths, law_l lengths, law_r
    quotients by them, law_q densities (s,). Given forces: force_d (3 g,), force_w what they are divided by, force_q (g,)
    densities. sums (2, .), N (r,) : scratch. norms (2, orders) : how large each order is.
    """

    axes: I0
    x: F2
    d: F2
    g: F2
    q: F2
    squares: F2
    motions: F2
    law_d: F2
    law_w: F2
    law_l: F2
    law_r: F2
    law_q: F2
    force_d: F2
    force_w: F2
    force_q: F2
    sums: F2
    N: F1
    norms: F2


_, INTEGERS, REALS = SeriesWork.COUNT


@kernel_bare
def _axes(eq: Equations, stand: F1) -> int:
    """2 where all is and stays in the plane z = 0."""
    free, held = eq.free, eq.held
    # planar where no free coordinate is a z,
    for i in range(free.size):
        if free[i] % 3 == 2:
            return 3
    # none is prescribed,
    for i in range(held.size):
        if held[i] % 3 == 2:
            return 3
    # and all nodes stand at z = 0
    for c in range(2, stand.size, 3):
        if stand[c] != 0.0:
            return 3
    return 2


@kernel
def series_work(eq: Equations, stand: F1, orders: int) -> SeriesWork:
    """Workspace of the orders 0 to `orders` of the places; stand (3 n,) : where prescribed coordinates are, m."""
    kind, motion = eq.kind, eq.motion
    r, s, g, n = kind.size, eq.law_A.size, eq.force_kind.size, stand.size
    axes, turning, moving = _axes(eq, stand), False, False
    # angles need n(t), prescribed lengths need L(t)^2
    for k in range(r):
        turning = turning or kind[k] == ANGLE
        moving = moving or motion[k] >= 0
    rows, widest = orders + 1, max(axes * r, 3 * s)
    # in the order of the fields
    shapes = (
        (rows, n), (rows, axes * r), (rows if turning else 0, axes * r), (rows, r),
        (rows if moving else 0, r), (rows, eq.motion_kind.size),
        (rows, 3 * s), (rows, s), (rows, s), (rows, s), (rows, s),
        (rows, 3 * g), (rows, g), (rows, g), (2, widest), (r, 1), (2, rows),
    )  # fmt: skip
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    work = SeriesWork(ints, reals)
    work.axes = axes
    return work
