"""Steps chosen by the error, of DOP853 or by power series, on the index-1 form: accelerations from M a + J^T N = f,
J a = gamma; the state is projected onto the constraints after every step (Hairer & Wanner, Solving Ordinary Differential
Equations II, section VII.2).

Steps never end at wanted times: samples come from the dense output, projected. Where a stage of DOP853 comes near a singular
position, the step is given another size, such that the position lies in a wide gap between stages.
"""

from __future__ import annotations

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.laid_out import laid_out
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.machine import proceed
from kinetruss.kernels.integrate.roots import DEEPEST, DEGREE
from kinetruss.kernels.integrate.state import Control, Memory, Samples, Work
from kinetruss.kernels.series.workspace import series_work
from kinetruss.kernels.solve.kkt import accelerate, factor, kinetic, potential, prepare_rows, project_near
from kinetruss.kernels.steps.taylor_step import taylor_step
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["integrate_explicit"]

_, INTEGERS, REALS = m.Work.COUNT


@kernel
def new_work(control: Control, memory: Memory, samples: Samples, budget: int, explicit: int) -> Work:
    """Scratch of a call, and where the machine begins."""
    size, n, rows = memory.y.shape[1], samples.x.shape[1], memory.multiplier.size
    degree = max(2 * (memory.dense.shape[0] - 1), DEGREE) if memory.watched.size > 0 else -1
    deep, most = (DEEPEST + 2, 2 * degree + 8) if degree > 0 else (0, 0)
    # in the order of the fields
    shapes = (
        (14, 1),
        (16, size),
        (5, size),
        (n, 1),
        (n, 1),
        (n, 1),
        (rows, 1),
        (size - 2 * control.free.size, 1),
        (5, degree + 1),
        (deep, degree + 3),
        (most, 3),
        (64 * most, 3),
        (16, 2),
    )
    ints, reals = laid_out(shapes, INTEGERS, REALS)
    work = m.Work(ints, reals)
    work.last_sample, work.budget, work.explicit = samples.times.size, budget, explicit
    return work


@kernel
def integrate_explicit(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, samples: Samples, budget: int
) -> tuple[int, int]:
    """Go on from `memory` and fill the samples, in at most `budget` steps. Returns a code and how many are filled.

    The run in any number of calls is bit for bit that in one.
    """
    by_series = control.method == m.TAYLOR
    work = new_work(control, memory, samples, budget, m.BY_SERIES if by_series else 1)
    orders = int(control.orders) if by_series else 2
    own = series_work(eq, control.stand, orders)
    x, v, tolerance = work.x, work.v, control.tolerance
    a, N = work.a, work.N
    work.factored = -1.0
    # prescribed coordinates at rest keep their places
    for i in range(x.size):
        x[i] = control.stand[i]
    # reverse communication: the step control asks, the equations of motion answer
    while True:
        ask, pivot = proceed(control, memory, samples, work), -1.0
        ws.pivot[1] = memory.pivot_most
        if ask == m.FINISH:
            return work.code, work.next_sample
        if ask & m.STEP:
            work.ok = 1.0 if taylor_step(eq, ws, control, memory, work, own) else 0.0
        if ask & (m.PROJECT | m.EVALUATE | m.PIVOT_ONLY):
            work.factored = -1.0
        if ask & m.PROJECT:
            # behind a step the factors at hand are of its last stage; next to a singular position every digit counts
            far = work.lowest >= control.pivot_limit * memory.pivot_most
            near = far and work.phase == m.GOT_NEW
            ok, work.moved, _, pivot = project_near(eq, ws, work.ask_t, x, v, tolerance, near)
            work.ok = 1.0 if ok else 0.0
        if ask & (m.EVALUATE | m.PIVOT_ONLY):
            if pivot == -1.0:  # no factors of these places are left by a projection
                prepare_rows(eq, ws, work.ask_t, x, v)
                pivot = factor(eq, ws, x)
            work.new_pivot = pivot
        if ask & m.EVALUATE:
            accelerate(eq, ws, user, work.ask_t, x, v, a, N)
            memory.evaluations += 1
        if ask & m.ENERGY:
            work.kinetic, work.potential = kinetic(eq, ws, x, v), potential(eq, x)
