"""A simulation with motors on its way: it slips, sticks, saturates, and restarts its steps at every such change.

Between two changes the equations are smooth; each change is found as a root of the interpolant of a step. Coulomb friction is
never smoothed. A step is a function of the state at its beginning alone, so that a resumed run repeats it to the last bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853, Radau

from kinetruss.dynamics.forward.stepper import Stepper
from kinetruss.dynamics.forward.watch import watched
from kinetruss.dynamics.motors.modes import ENERGIES, MotorModes
from kinetruss.dynamics.motors.watch import crossed, first_change, user_values
from kinetruss.errors import AnalysisError, StoreError
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.between import TURN
from kinetruss.kernels.integrate.state import Samples, new_memory
from kinetruss.kernels.structure.lengths import turn_rates

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

__all__ = ["MotorStepper"]

STATE = "motor_state"
CHATTER = 100
"""Changes one after the other without any time between them from which on it goes no further."""
SAME_TURN = 0.1
"""Error (m, rad) of the values of lengths and angles, which only tell the turn: positions tell all else."""
PAUSES = 64
"""Steps of one call at most, so that Ctrl-C and progress are seen to."""


@dataclass(frozen=True, slots=True)
class _Step:
    """From `begin` to `end` (s). at(t) gives the state; change : what ends the mode, if anything; sides (events,) : of what is
    watched, at the end. size, next : of steps, s.
    """

    begin: float
    end: float
    at: Any
    change: tuple[int, str] | None
    events: tuple[tuple[int, float, int, float], ...]
    sides: NDArray[np.float64]
    stops: bool
    size: float
    next: float
    rejected: int
    evaluations: int
    sampled: list[float] = field(default_factory=list)


class MotorStepper(Stepper):
    """Integrates a `Problem` with motors; see `Stepper`."""

    def __init__(self, problem: Problem, t_end: float) -> None:
        assert problem.motors is not None  # noqa: S101 - chosen by it
        super().__init__(problem, t_end)
        eq = problem.eq
        self.events = watched(problem.system, eq, problem.events)
        self.modes = MotorModes(problem)
        count = len(problem.motors.names)
        self.memory = new_memory(len(eq.free), (2 + len(ENERGIES)) * count, len(eq.A), len(problem.events))
        start = np.zeros((2 + len(ENERGIES)) * count)
        self.memory.stop, self.memory.h_old = np.inf, problem.method.first_step or 0.0
        self.memory.y[0] = self.modes.begin(np.concatenate([problem.x0[eq.free], problem.v0[eq.free], start]))
        self.step: _Step | None = None
        self.failure = m.DONE

    def _integrate(self, samples: Samples, done: int, budget: int) -> tuple[int, int]:
        self._done = done
        try:
            return self._go(samples, min(budget, PAUSES)), self._done
        except AnalysisError:
            return m.STEP_TOO_SMALL, self._done
        except KeyboardInterrupt as stop:
            self.problem.user.error = stop
            return m.PAUSED, self._done

    def _go(self, samples: Samples, budget: int) -> int:
        memory, last = self.memory, len(samples.times)
        for _ in range(budget):
            if memory.steps >= self.problem.method.max_steps:
                return m.TOO_MANY_STEPS
            if self.step is None:
                self.step = self._taken()
            if self.step is None:
                return self.failure
            if memory.stiff_steps > CHATTER:
                return m.STEP_TOO_SMALL
            step = self.step
            final = step.end >= self.t_end or step.stops
            reach = step.end if not final else np.nextafter(step.end, np.inf) if step.stops else np.inf
            while self._done < last and samples.times[self._done] < reach:
                self._fill(samples, step, min(float(samples.times[self._done]), step.end))
            if step.stops and self._done < last:
                samples.times[self._done] = step.end
                self._fill(samples, step, step.end)
                self._commit(step)
                return m.EVENT
            if self._done == last and not final:
                return m.DONE
            self._commit(step)
            if final:
                return m.EVENT if step.stops else m.DONE
        return m.PAUSED

    def _taken(self) -> _Step | None:
        """The step from the present state; None where none can be taken."""
        memory, motors, method, modes = self.memory, self.problem.motors, self.problem.method, self.modes
        assert motors is not None  # noqa: S101
        t, y, edge = float(memory.t), memory.y[0].copy(), int(memory.interval)
        until = min(motors.edges[edge + 1], self.t_end)
        last = np.nextafter(until, -np.inf)
        rates = modes.rates(edge)
        atol = np.full(len(y), method.atol)
        atol[modes.first :] = min(1e-3 * method.rtol, method.atol)
        modes.values(atol)[:] = SAME_TURN
        solver = (Radau if motors.stiff else DOP853)(
            lambda t, y: rates(min(t, last), y), t, y, until, max_step=motors.longest, rtol=method.rtol, atol=atol
        )
        if memory.h_old > 0:
            solver.h_abs = float(memory.h_old)
        solver.step()
        if self.problem.user.error is not None or solver.status == "failed" or not np.isfinite(solver.y).all():
            self._failed(t, y, until)
            return None
        evaluations = int(solver.nfev)
        dense = solver.dense_output()
        watch, events = modes.watch(edge), lambda t, y: user_values(self.events, modes, edge, min(t, last), y)
        change, when = first_change(watch, (t, y), dense)
        found, sides = crossed(self.events, events, dense, when, memory.watched if memory.steps else memory.watched * np.nan)
        stops = [one for one in found if self.events[one[0]][5]]
        if stops and stops[0][1] <= when:
            change, when = None, stops[0][1]
            found = [one for one in found if one[1] <= when]
        ended = bool(stops and stops[0][1] == when)
        return _Step(
            begin=t,
            end=float(when),
            at=dense,
            change=change,
            events=tuple(found),
            stops=ended,
            size=float(solver.t - t),
            sides=sides,
            next=float(solver.h_abs),
            rejected=max(0, evaluations // 12 - 1),
            evaluations=evaluations,
        )

    def _failed(self, t: float, y: NDArray[np.float64], until: float) -> None:
        self.memory.h = 10 * np.spacing(t)
        bad = not np.isfinite(self.modes.rates(int(self.memory.interval))(min(t, np.nextafter(until, 0)), y)).all()
        self.failure = m.NOT_FINITE if bad or self.problem.user.error is not None else m.STEP_TOO_SMALL

    def _commit(self, step: _Step) -> None:
        """Stand at the end of a step, in the mode behind it."""
        memory, motors = self.memory, self.problem.motors
        assert motors is not None  # noqa: S101
        t, edge = step.end, int(memory.interval)
        jump = edge + 2 < len(motors.edges) and t >= motors.edges[edge + 1]
        y, moved = self.modes.projected(
            t, edge, step.at(t), () if step.change is None or step.change[1] != "stop" else step.change[:1]
        )
        if step.change is not None:
            y = self.modes.changed(t, edge, y, step.change)
        if jump:
            edge += 1
            y = self.modes.settled(t, edge, y)
        memory.watched[:] = step.sides
        self._note(step)
        for row in step.events:
            memory.events[min(memory.events_met, len(memory.events) - 1)] = row
            memory.events_met += 1
        again = jump or step.change is not None
        memory.y[0] = y
        memory.t, memory.h, memory.h_old, memory.constraint = t, step.size, 0.0 if again else step.next, moved
        if step.stops:
            memory.stop = t
        memory.interval = edge
        memory.stiff_steps = memory.stiff_steps + 1 if t - step.begin <= 8 * np.spacing(t) else 0
        memory.steps += 1
        memory.rejected += step.rejected
        memory.evaluations += step.evaluations
        self.step = None

    def _note(self, step: _Step) -> None:
        """Keep states between samples, as kernels.integrate.between does."""
        memory, h, places = self.memory, step.end - step.begin, (step.begin, 0.5 * (step.begin + step.end), step.end)
        if not h > 0:
            return
        x, v = (np.array(y) for y in zip(*(self.modes.state(step.at(t)) for t in places), strict=True))
        system, rates = self.problem.system, np.zeros(3)
        turn_rates(system.p, system.q, x, v, rates)
        turn, s, turned = float(rates.max()) * h, 0.0, float(memory.turned)
        if step.sampled:
            s, turned = (step.sampled[-1] - step.begin) / h, 0.0
        # samples inside the step are taken for all that lies before the last of them
        marks = sorted({*step.sampled, step.begin, step.end})
        gap = max(b - a for a, b in pairwise(marks)) / h * turn
        if gap > TURN:
            kept = np.arange(step.begin, step.end, 0.9 * TURN / turn * h)[1:]
            rows = np.array([[t, *step.at(t)] for t in (*kept, step.end)])
            self._pass(rows)
            s, turned = 1.0, 0.0
        elif turned + (1.0 - s) * turn > TURN:
            rows = np.array([[step.end, *step.at(step.end)]])
            self._pass(rows)
            s, turned = 1.0, 0.0
        memory.turned = turned + (1.0 - s) * turn

    def _fill(self, samples: Samples, step: _Step, t: float) -> None:
        """One sample within a step."""
        step.sampled.append(t)
        k, edge = self._done, int(self.memory.interval)
        y, _ = self.modes.projected(t, edge, step.at(t), ())
        samples.x[k], samples.v[k], samples.a[k], samples.N[k], samples.z[k], pivot = self.modes.observed(t, edge, y)
        samples.diagnostics[k] = (
            step.size,
            pivot,
            self.memory.constraint,
            self.memory.steps + 1,
            self.memory.rejected + step.rejected,
            self.memory.evaluations + step.evaluations,
        )
        self._done += 1

    def _conclude(self, code: int, whole: bool) -> None:
        super()._conclude(code, whole)
        if self.ended:
            self.message = " ".join(filter(None, [self.message, *self.modes.notes()]))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Where it stands, as plain arrays."""
        return super().arrays() | {STATE: self.modes.table.copy()}

    def restore(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Stand where another one stood; what follows is the same to the last bit.

        Raises
        ------
        StoreError : arrays of another model or version.
        """
        given = arrays.get(STATE)
        if given is None or given.shape != self.modes.table.shape:
            raise StoreError(f"The stored state of the integration does not fit this model ({STATE}). Run it again.")
        super().restore(arrays)
        self.modes.table[:] = given
        self.step = None
