"""Steps chosen by the error, of DOP853 or by power series, on the index-1 form: accelerations from M a + J^T N = f,
J a = gamma; the state is projected onto the constraints after every step (Hairer & Wanner, Solving Ordinary Differential
Equations II, section VII.2).

Steps never end at wanted times: samples come from the dense output, projected. Where a stage of DOP853 comes near a singular
position, the step is given another size, such that the position lies in a wide gap between stages.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel, kernel_making
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.machine import proceed
from kinetruss.kernels.integrate.roots import DEEPEST, DEGREE
from kinetruss.kernels.integrate.state import Control
from kinetruss.kernels.series.workspace import series_room
from kinetruss.kernels.solve.kkt import accelerate, factor, kinetic, potential, prepare_rows, project_near
from kinetruss.kernels.steps.taylor_step import taylor_step

__all__ = ["march_dop853"]


@kernel_making
def new_room(control: Control, memory, samples, first, last, budget, explicit):  # type: ignore[no-untyped-def]
    """Scratch of a call, and where the machine begins."""
    size, n, rows = memory.y.shape[1], samples.x.shape[1], memory.multiplier.size
    degree = max(2 * (memory.dense.shape[0] - 1), DEGREE) if memory.watched.size > 0 else -1
    deep, most = (DEEPEST + 2, 2 * degree + 8) if degree > 0 else (0, 0)
    # in the order of the fields, behind AT
    shapes = (
        (m.NUMBERS, 1), (16, size), (5, size), (n, 1), (n, 1), (n, 1), (rows, 1), (size - 2 * control.free.size, 1),
        (5, degree + 1), (deep, degree + 3), (most, 3), (64 * most, 3), (16, 2),
    )  # fmt: skip
    first_int = 3 * (len(shapes) + 1)
    ints, at = np.zeros(first_int + m.PLACES, np.int64), 0
    ints[0], ints[1], ints[2] = first_int, m.PLACES, 1
    for k, (height, width) in enumerate(shapes):
        ints[3 * k + 3], ints[3 * k + 4], ints[3 * k + 5] = at, height, width
        at += height * width
    ints[first_int + m.SAMPLE], ints[first_int + m.LAST] = first, last
    ints[first_int + m.BUDGET], ints[first_int + m.EXPLICIT] = budget, explicit
    return m.Room(ints, np.zeros(at))


@kernel
def march_dop853(eq, ws, user, control: Control, memory, samples, first, last, budget):  # type: ignore[no-untyped-def]
    """Go on from `memory` and fill the samples first:last, in at most `budget` steps. Returns a code and the next sample.

    The run in any number of calls is bit for bit that in one.
    """
    by_series = control.real[m.METHOD] == m.TAYLOR
    room = new_room(control, memory, samples, first, last, budget, m.BY_SERIES if by_series else 1)
    orders = int(control.real[m.ORDERS]) if by_series else 2
    own = series_room(eq, control.stand, orders)
    x, v, num, tolerance = room.x, room.v, room.num, control.real[m.TOLERANCE]
    a, pulls = room.a, room.pulls
    num[m.FACTORED] = -1.0
    for i in range(x.size):
        x[i] = control.stand[i]
    while True:
        ask, pivot = proceed(control, memory, samples, room), -1.0
        if ask == m.FINISH:
            return room.at[m.CODE], room.at[m.SAMPLE]
        if ask & m.STEP:
            num[m.OK] = 1.0 if taylor_step(eq, ws, control, memory, room, own) else 0.0
        if ask & (m.PROJECT | m.EVALUATE | m.PIVOT_ONLY):
            num[m.FACTORED] = -1.0
        if ask & m.PROJECT:
            # behind a step the factors at hand are of its last stage; next to a singular position every digit counts
            far = num[m.LOWEST] >= control.real[m.PIVOT_LIMIT] * memory.real[m.PIVOT_MOST]
            near = far and room.at[m.PHASE] == m.GOT_NEW
            ok, num[m.MOVED], _, pivot = project_near(eq, ws, num[m.ASK_T], x, v, tolerance, near)
            num[m.OK] = 1.0 if ok else 0.0
        if ask & m.EVALUATE:
            num[m.NEW_PIVOT] = accelerate(eq, ws, user, num[m.ASK_T], x, v, a, pulls, pivot)
            memory.count[m.EVALUATIONS] += 1
        if ask & m.PIVOT_ONLY:
            if pivot == -1.0:
                prepare_rows(eq, ws, num[m.ASK_T], x, v)
                pivot = factor(eq, ws, x)
            num[m.NEW_PIVOT] = pivot
        if ask & m.ENERGY:
            num[m.KINETIC], num[m.POTENTIAL] = kinetic(eq, ws, x, v), potential(eq, x)
