"""Steps of Radau IIA, chosen by the error; next to singular positions DOP853 steps instead (see kernels.collocation.step)."""

from __future__ import annotations

from kinetruss.kernels.collocation.matrices import new_matrices
from kinetruss.kernels.collocation.stages import new_stages
from kinetruss.kernels.collocation.step import ASIDE, radau_step
from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.machine import proceed
from kinetruss.kernels.integrate.run_dop853 import new_work
from kinetruss.kernels.integrate.state import Control, Memory, Samples
from kinetruss.kernels.solve.kkt import evaluate, factor, kinetic, potential, prepare_rows, project
from kinetruss.kernels.steps.dop853_step import begin_step
from kinetruss.kernels.structure.equations import Equations, Workspace

__all__ = ["integrate_radau"]


@kernel
def integrate_radau(
    eq: Equations, ws: Workspace, user: int, control: Control, memory: Memory, samples: Samples, budget: int
) -> tuple[int, int]:
    """Go on from `memory` and fill the samples, in at most `budget` steps. Returns a code and how many are filled.

    The run in any number of calls is bit for bit that in one.
    """
    work = new_work(control, memory, samples, budget, m.BY_COLLOCATION)
    laws = eq.law_A.size
    matrices, own = new_matrices(control, laws), new_stages(control, laws)
    x, v = work.x, work.v
    for i in range(x.size):
        x[i] = control.stand[i]
    while True:
        ask = proceed(control, memory, samples, work)
        if ask == m.FINISH:
            return work.code, work.next_sample
        if ask & m.STEP:
            taken = radau_step(eq, ws, user, control, memory, work, matrices, own)
            work.ok = 1.0 if taken else 0.0
            if taken == ASIDE:
                begin_step(control, memory, work)
        if ask & m.PROJECT:
            ok, work.moved, _ = project(eq, ws, work.ask_t, x, v, control.tolerance)
            work.ok = 1.0 if ok else 0.0
        if ask & m.EVALUATE:
            work.new_pivot = evaluate(eq, ws, user, work.ask_t, x, v, work.a, work.N)
            memory.evaluations += 1
        if ask & m.PIVOT_ONLY:
            prepare_rows(eq, ws, work.ask_t, x, v)
            work.new_pivot = factor(eq, ws, x)
        if ask & m.ENERGY:
            work.kinetic, work.potential = kinetic(eq, ws, x, v), potential(eq, x)
