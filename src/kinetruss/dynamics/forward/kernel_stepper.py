"""A simulation without motors, integrated by one kernel from sample to sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.dynamics.forward.integrate import control, integrator_of, restart_memory, start_memory
from kinetruss.dynamics.forward.stepper import Stepper
from kinetruss.dynamics.forward.watch import jumps, watched
from kinetruss.dynamics.remarks.energy_kept import resting
from kinetruss.dynamics.starting.crossing import cross_singular
from kinetruss.dynamics.starting.singular_start import start_beside
from kinetruss.kernels.integrate import state as m
from kinetruss.model import Taylor

if TYPE_CHECKING:
    from kinetruss.dynamics.forward.problem import Problem
    from kinetruss.kernels.integrate.state import Control, Samples

__all__ = ["KernelStepper"]


class KernelStepper(Stepper):
    """Integrates a `Problem` without motors; see `Stepper`."""

    def __init__(self, problem: Problem, t_end: float) -> None:
        super().__init__(problem, t_end)
        self.integrate = integrator_of(problem.method)
        if t_end not in problem.controls:
            problem.controls[t_end] = _control(problem, t_end)
        self.control = problem.controls[t_end].copy()
        start = problem.x0, problem.v0, problem.z0
        self.memory = start_memory(problem.eq, 0.0, *start, len(problem.events), problem.method)
        self._start = self.memory.y[0].copy()
        problem.ws.pivot.fill(0.0)

    def rewind(self) -> None:
        """Return to the start."""
        self.problem.ws.pivot.fill(0.0)
        restart_memory(self.memory, 0.0, self._start)
        self._clear()

    def _integrate(self, samples: Samples, done: int, budget: int) -> tuple[int, int]:
        problem = self.problem
        first = None if self.memory.started else start_beside(problem, self.integrate, self.control, self.memory, samples)
        left = samples.part(done) if done else samples
        code, filled = self.integrate(problem.eq, problem.ws, problem.user.call, self.control, self.memory, left, budget)
        if first is not None and samples.times[0] == 0.0:
            samples.a[0], samples.N[0] = first
        if code == m.UNDETERMINED:
            cross_singular(problem, self.control, self.memory)
            code = m.PAUSED
        return code, done + filled


def _control(problem: Problem, t_end: float) -> Control:
    """The control data of the integrator, from 0 to t_end (s)."""
    eq, system, method = problem.eq, problem.system, problem.method
    return control(
        eq,
        system,
        method,
        (0.0, t_end),
        events=watched(system, eq, problem.events),
        breaks=jumps(eq, isinstance(method, Taylor)),
        isolated=problem.isolated and not resting(problem),
        turns=True,
    )
