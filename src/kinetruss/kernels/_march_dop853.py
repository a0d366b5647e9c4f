"""Error-controlled DOP853 on the index-1 form: accelerations from M a + J^T N = f, J a = gamma; the state is projected onto
the constraints after every step (Hairer & Wanner, Solving Ordinary Differential Equations II, section VII.2).

Steps never end at wanted times: samples come from the dense output, projected. Where a stage comes near a singular position,
the step is given another size, such that the position lies in a wide gap between stages.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels import _march_state as m
from kinetruss.kernels._jit import kernel, kernel_inner
from kinetruss.kernels._kkt import evaluate, kinetic, potential, project
from kinetruss.kernels._march_machine import proceed

__all__ = ["march_dop853"]


@kernel_inner
def new_room(control, memory, samples, first, last, budget, explicit):  # type: ignore[no-untyped-def]
    """Scratch of a call, and where the machine begins."""
    size, n = memory.y.shape[1], samples.x.shape[1]
    at = np.zeros(16, np.int64)
    at[m.SAMPLE], at[m.LAST], at[m.BUDGET], at[m.EXPLICIT] = first, last, budget, explicit
    return m.Room(
        at, np.zeros(48), np.zeros((16, size)), np.zeros((5, size)), np.zeros(n), np.zeros(n), np.zeros(n),
        np.zeros(memory.multiplier.size), np.zeros(size - 2 * control.free.size), np.zeros((3, memory.watched.size)),
    )  # fmt: skip


@kernel
def march_dop853(eq, ws, user, control, memory, samples, first, last, budget):  # type: ignore[no-untyped-def]
    """Go on from `memory` and fill the samples first:last, in at most `budget` steps. Returns a code and the next sample.

    The run in any number of calls is bit for bit that in one.
    """
    room = new_room(control, memory, samples, first, last, budget, 1)
    x, v, num, tolerance = room.x, room.v, room.num, control.real[m.TOLERANCE]
    for i in range(x.size):
        x[i] = control.place[i]
    while True:
        ask = proceed(control, memory, samples, room)
        if ask == m.FINISH:
            return room.at[m.CODE], room.at[m.SAMPLE]
        if ask & m.PROJECT:
            ok, num[m.MOVED], _ = project(eq, ws, num[m.ASK_T], x, v, tolerance)
            num[m.OK] = 1.0 if ok else 0.0
        if ask & m.EVALUATE:
            num[m.NEW_PIVOT] = evaluate(eq, ws, user, num[m.ASK_T], x, v, room.a, room.N)
            memory.count[m.EVALUATIONS] += 1
        if ask & m.ENERGY:
            num[m.KINETIC], num[m.POTENTIAL] = kinetic(eq, ws, x, v), potential(eq, x)
