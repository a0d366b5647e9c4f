"""A running simulation without motors: it advances to given times, can be stored as plain arrays and continued later."""

from __future__ import annotations

import math
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.integration import Integration
from kinetruss.dynamics.integrators import control, integrate, jumps, restart_memory, start_memory, watched
from kinetruss.dynamics.remarks import LOOKS, ending, refine, resting, sentences, too_stiff
from kinetruss.dynamics.simulation_problem import all_rows
from kinetruss.dynamics.simulation_records import Trace
from kinetruss.dynamics.singular_starts import cross_singular, start_beside
from kinetruss.errors import StoreError
from kinetruss.kernels.compiled.workspace import allocate
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.state import Memory, Samples
from kinetruss.kinematics.turns import Passed
from kinetruss.model import Taylor
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.simulation_problem import Problem
    from kinetruss.kernels.integrate.state import Control


FIRST_BUDGET = 256
"""Steps in the first call of the kernel; later calls take as many steps as fit in `LOOK` seconds."""
FEW = 8
"""Steps between which step sizes are noted."""
MOST_BUDGET = 1 << 30
"""Largest number of steps in a call. Calls that end early at singular positions do not show how many steps fit in `LOOK`."""
APART = ("events", "passages", "between")
"""Arrays of the memory whose length grows during the run."""
LOOK = 0.25
"""Seconds after which a kernel returns, to handle Ctrl-C and progress."""


class Stepper(Integration, ABC):
    """An integration that advances to given times."""

    @cached_property
    def _rows(self) -> int:
        return len(self.problem.eq.A)

    @cached_property
    def _all_rows(self) -> bool:
        """True if the equations have all constraints of the system, in its order."""
        return np.array_equal(self.problem.eq.row, np.arange(len(self.problem.system.row_member)))

    @abstractmethod
    def _integrate(self, samples: Samples, done: int, budget: int) -> tuple[int, int]:
        """Take at most `budget` steps and fill samples from index `done` on. Returns the end code and the number of samples."""

    def advance(
        self,
        times: NDArray[np.float64],
        *,
        patience: float | None = None,
        progress: Callable[[int], None] | None = None,
        steps: list[tuple[float, float]] | None = None,
    ) -> Trace:
        """Advance to the next given times (s), increasing; the trace holds the good samples.

        patience : seconds after which the call returns with fewer samples, but at least one; they count after the first call of
        the kernel, which may compile it. progress : called with the number of samples done, a few times a second. steps : gets
        times and step sizes on the way (s), of every few steps.
        Ctrl-C ends it with the status INTERRUPTED.
        """
        samples, done, budget, code = self._room(times), 0, FIRST_BUDGET, m.PAUSED
        last = math.inf
        self.problem.user.ready()
        try:
            while True:
                began = time.perf_counter()
                code, done = self._integrate(samples, done, self._to_next_look(budget if steps is None else FEW))
                if steps is not None:
                    steps.append((float(self.memory.t), float(self.memory.h)))
                self._drain()
                now = time.perf_counter()
                if patience is not None and last == math.inf:
                    last = now + patience
                if progress is not None:
                    progress(done)
                if isinstance(self.problem.user.error, KeyboardInterrupt):
                    raise self.problem.user.error
                if code == m.PAUSED and int(self.memory.steps) in LOOKS and too_stiff(self):
                    code = m.STIFF
                if code != m.PAUSED or (now > last and done):
                    break
                budget = int(np.clip(budget * LOOK / max(now - began, 1e-9), FIRST_BUDGET, min(8 * budget, MOST_BUDGET)))
        except KeyboardInterrupt:
            self.ended, self.status = True, Status.INTERRUPTED
        refine(self.problem, samples, done, float(self.memory.pivot_most), self.lost)
        self._conclude(code, done == len(times) and float(times[-1]) >= self.t_end)
        return self._trace(samples, done)

    def _to_next_look(self, budget: int) -> int:
        """The budget, limited so that a call ends at the steps at which stiffness is checked: always the same steps."""
        steps = int(self.memory.steps)
        return min([budget, *(look - steps for look in LOOKS if look > steps)])

    def _room(self, times: NDArray[np.float64]) -> Samples:
        count, size, problem = len(times), self.problem.system.x0.size, self.problem
        shapes = [(count, size)] * 3 + [(count, self._rows), (count, len(problem.z0)), (count, len(m.DIAGNOSTICS))]
        return Samples(times.astype(float), *allocate(*shapes))

    def _conclude(self, code: int, whole: bool) -> None:
        """Set status and message from the end code of the last call."""
        if self.status is not Status.INTERRUPTED:
            self.status = ending(code, self.problem.error)
            self.ended = whole or not self.status.ok or self.status is Status.EVENT
        if self.ended:
            self.message = " ".join([*self.problem.notes, *sentences(self)])

    def _trace(self, samples: Samples, done: int) -> Trace:
        done = self._finite(samples, done)
        t, x, v, a, N, extra, diagnostics = (values[:done] for values in samples)
        N = N if self._all_rows else all_rows(self.problem, t, x, v, N)
        return Trace(t=t, x=x, v=v, a=a, N=N, extra=extra, diagnostics=diagnostics)

    def _finite(self, samples: Samples, done: int) -> int:
        """The samples before the first one with a number that is not finite; a run with such a sample is not complete."""
        # a sum is not finite only if one of its terms is not finite, or the sum overflows
        if math.isfinite(sum(float(values[:done].sum()) for values in samples[1:5])):
            return done
        whole = np.ones(done, np.bool_)
        # extra states that a motor does not have are NaN
        for values in samples[1:5]:
            whole &= np.isfinite(values[:done]).all(axis=1)
        if whole.all():
            return done
        self.status, self.ended = Status.NOT_FINITE, True
        self.message = " ".join([*self.problem.notes, *sentences(self)])
        return int(np.argmin(whole))

    def _drain(self) -> None:
        """Move the states between samples out of the memory, and enlarge its full arrays of events and passages."""
        memory = self.memory
        if kept := memory.states_between:
            self._pass(memory.between[:kept])
            memory.states_between = 0
        for name, met in (("events", memory.events_met), ("passages", memory.passages_met)):
            if met and 2 * met > len(rows := getattr(memory, name)):
                self.memory = self.memory.with_(**{name: np.concatenate([rows, np.zeros_like(rows)])})

    def arrays(self) -> dict[str, NDArray[Any]]:
        """The state of the integration as plain arrays."""
        kept = {name: values for name, values in self.memory.arrays().items() if name not in APART}
        passed = {f"passed_{name}": values for name, values in vars(self.passed).items()}
        memory = self.memory
        happened = self.happened() | {
            "events": memory.events[: memory.events_met],
            "passages": memory.passages[: memory.passages_met],
        }
        return kept | happened | passed | {"angles": self.angles.copy(), "worst": self.worst.copy(), "lost": self.lost.copy()}

    def restore(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Continue from the state of another integration; all later results are the same to the last bit.

        Raises
        ------
        StoreError : arrays of another model or version.
        """
        fields = {}
        for name, own in self.memory.arrays().items():
            if name == "between":
                fields[name] = own
                continue
            given = arrays.get(name)
            if given is None or given.dtype != own.dtype or given.shape[1:] != own.shape[1:]:
                raise StoreError(f"The stored state of the integration does not fit this model ({name}). Run it again.")
            fields[name] = given
            if name in APART:
                fields[name] = np.zeros((max(len(own), 2 * len(given)), *own.shape[1:]))
                fields[name][: len(given)] = given
        self.memory, self.angles = Memory.of(fields), np.array(arrays["angles"])
        self.worst, self.lost = (np.array(arrays.get(name, np.zeros(3))) for name in ("worst", "lost"))
        if "passed_t" in arrays:
            self._passed, self._unread = Passed(*(np.array(arrays[f"passed_{name}"]) for name in ("t", "x", "v"))), []


# A simulation without motors, integrated by one kernel from sample to sample.


class KernelStepper(Stepper):
    """Integrates a `Problem` without motors; see `Stepper`."""

    def __init__(self, problem: Problem, t_end: float) -> None:
        super().__init__(problem, t_end)
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
        first = None if self.memory.started else start_beside(problem, self.control, self.memory, samples)
        left = samples.part(done) if done else samples
        code, filled = integrate(problem.eq, problem.ws, problem.user.call, self.control, self.memory, left, budget)
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
