"""A simulation with motors on its way: it slips, sticks, saturates, and restarts its steps at events.

Between two changes the equations are smooth; each change is found as a root of the interpolant of a step. Coulomb friction is
never smoothed. A step is a function of the state at its beginning alone, so that a resumed run repeats it to the last bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.drive_model import ENERGIES
from kinetruss.actuators.events import crossed
from kinetruss.actuators.modes import MotorModes
from kinetruss.actuators.steps import Step, Tolerances, method_from, step_of, watch
from kinetruss.dynamics.integrators import watched
from kinetruss.dynamics.motors import StructureBody
from kinetruss.dynamics.stepping import Stepper
from kinetruss.errors import AnalysisError, InputError, StoreError
from kinetruss.kernels.coordinates.straight_line import addresses_of
from kinetruss.kernels.integrate import state as m
from kinetruss.kernels.integrate.samples import TURN
from kinetruss.kernels.integrate.state import COORDINATE, LENGTH, SUM, Samples, new_memory
from kinetruss.kernels.structure.lengths import turn_rates
from kinetruss.kernels.structure.terms import measure_value

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.simulation_problem import Problem


STATE = "motor_state"
SAMPLED = "motor_sampled"
CHATTER = 100
"""Changes one after the other without any time between them from which on it goes no further."""
PAUSES = 64
"""Steps of one call at most, so that Ctrl-C and progress are seen to."""


@dataclass(frozen=True, slots=True)
class _Taken:
    """A step, cut at `end` (s) where an event or the end of a mode comes first.

    changes : the mode ends there. events : wanted ones in it; sides (events,) : of what is watched, at its end; stops : one of
    them ends the run.
    """

    step: Step
    end: float
    changes: bool
    events: tuple[tuple[int, float, int, float], ...]
    sides: NDArray[np.float64]
    stops: bool
    evaluations: int

    @property
    def begin(self) -> float:
        """Its beginning, s."""
        return self.step.begin

    @property
    def rejected(self) -> int:
        """Tries that were too long."""
        return max(0, self.evaluations // 12 - 1)


class MotorStepper(Stepper):
    """Integrates a `Problem` with motors; see `Stepper`."""

    def __init__(self, problem: Problem, t_end: float) -> None:
        assert problem.motors is not None  # noqa: S101 - chosen by it
        super().__init__(problem, t_end)
        eq = problem.eq
        self.events = watched(problem.system, eq, problem.events)
        for (*_, period), name in zip(self.events, problem.events, strict=True):
            if period > 0.0:
                raise InputError(
                    f"events.{name}: angles are not watched beside motors with inputs. Watch a coordinate of a node."
                )
        motors, count = problem.motors, len(problem.motors.names)
        self.body = StructureBody(eq, problem.ws, problem.user, motors.rows, motors.period, problem.x0)
        self.modes = MotorModes(motors, self.body)
        self.memory = new_memory(len(eq.free), (2 + len(ENERGIES)) * count, len(eq.A), len(problem.events))
        start = np.zeros((2 + len(ENERGIES)) * count)
        self.memory.stop, self.memory.h_old = np.inf, problem.method.first_step or 0.0
        self.memory.y[0] = self.modes.begin(np.concatenate([problem.x0[eq.free], problem.v0[eq.free], start]))
        self.step: _Taken | None = None
        self.sampled: list[float] = []  # s, samples of this step so far
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
            while self._done < last and samples.times[self._done] < step.end:
                self._fill(samples, step, float(samples.times[self._done]))
            if self._done == last:  # those that come later, of another block, may lie in this step too
                return m.DONE
            if step.stops:
                samples.times[self._done] = step.end
                self._fill(samples, step, step.end)
                self._commit(step)
                return m.EVENT
            if step.end >= self.t_end:
                while self._done < last:
                    self._fill(samples, step, step.end)
                self._commit(step)
                return m.DONE
            self._commit(step)
        return m.PAUSED

    def _taken(self) -> _Taken | None:
        """The step from the present state; None where none can be taken."""
        memory, motors, method, modes = self.memory, self.problem.motors, self.problem.method, self.modes
        assert motors is not None  # noqa: S101
        t, y, interval = float(memory.t), memory.y[0].copy(), int(memory.interval)
        until = min(motors.edges[interval + 1], self.t_end)
        given = Tolerances(
            method.rtol, modes.tolerances(method.atol, min(1e-3 * method.rtol, method.atol)), float(memory.h_old)
        )
        solver = method_from(modes, interval, t, y, until, given)
        step = step_of(solver, watch(modes, interval))
        if self.problem.error is not None or step is None:
            self._failed(t, y, until)
            return None
        evaluations, last = int(solver.nfev), np.nextafter(until, -np.inf)
        sides = memory.watched if memory.steps else memory.watched * np.nan
        found, sides = crossed(self.events, lambda t, y: self._quantities(min(t, last), y), step.at, step.end, sides)
        stop = next((one[1] for one in found if self.events[one[0]][5]), None)
        if stop is None:
            return _Taken(step, step.end, step.event is not None, tuple(found), sides, False, evaluations)
        found = [one for one in found if one[1] <= stop]
        return _Taken(step, float(stop), False, tuple(found), sides, True, evaluations)

    def _quantities(self, t: float, y: NDArray[np.float64]) -> list[float]:
        """Lengths, coordinates and forces that are watched."""
        x, _ = self.body.state(y)
        found, N = [], None
        for kind, a, b, *_, terms, _ in self.events:
            if kind == COORDINATE:
                found.append(float(x[a]))
            elif kind == SUM:
                kinds, places, data = (np.array(column) for column in zip(*terms, strict=True))
                found.append(measure_value(addresses_of(kinds), places, data.astype(float), 0, len(terms), x))
            elif kind == LENGTH:
                found.append(float(np.linalg.norm(x[b : b + 3] - x[a : a + 3])))
            else:
                N = self.body.found(self.modes.instant(t, int(self.memory.interval), y).w)[1] if N is None else N
                found.append(float(N[a]))
        return found

    def _failed(self, t: float, y: NDArray[np.float64], until: float) -> None:
        self.memory.h = 10 * np.spacing(t)
        bad = not np.isfinite(self.modes.rates(int(self.memory.interval))(min(t, np.nextafter(until, 0)), y)).all()
        self.failure = m.NOT_FINITE if bad or self.problem.error is not None else m.STEP_TOO_SMALL

    def _commit(self, step: _Taken) -> None:
        """Stand at the end of a step, in the mode behind it."""
        memory, motors = self.memory, self.problem.motors
        assert motors is not None  # noqa: S101
        t, interval = step.end, int(memory.interval)
        jump = interval + 2 < len(motors.edges) and t >= motors.edges[interval + 1]
        event = step.step.event if step.changes else None
        stopped = (event.motor,) if event is not None and event.name == "stop" else ()
        y, moved = self.modes.projected(t, interval, step.step.at(t), stopped)
        if event is not None:
            y = self.modes.changed(t, interval, y, event)
        if jump:
            interval += 1
            y = self.modes.settled(t, interval, y)
        memory.watched[:] = step.sides
        self._note(step)
        for row in step.events:
            memory.events[min(memory.events_met, len(memory.events) - 1)] = row
            memory.events_met += 1
        again = jump or event is not None
        memory.y[0] = y
        memory.t, memory.h, memory.h_old, memory.constraint = t, step.step.size, 0.0 if again else step.step.next, moved
        if step.stops:
            memory.stop = t
        memory.interval = interval
        memory.stiff_steps = memory.stiff_steps + 1 if t - step.begin <= 8 * np.spacing(t) else 0
        memory.steps += 1
        memory.rejected += step.rejected
        memory.evaluations += step.evaluations
        self.step, self.sampled = None, []

    def _note(self, step: _Taken) -> None:
        """Keep states between samples, as kernels.integrate.samples does."""
        memory, h, places = self.memory, step.end - step.begin, (step.begin, 0.5 * (step.begin + step.end), step.end)
        if not h > 0:
            return
        x, v = (np.array(y) for y in zip(*(self.body.state(step.step.at(t)) for t in places), strict=True))
        system, rates = self.problem.system, np.zeros(3)
        turn_rates(system.p, system.q, x, v, rates)
        turn, s, turned = float(rates.max()) * h, 0.0, float(memory.turned)
        if self.sampled:
            s, turned = (self.sampled[-1] - step.begin) / h, 0.0
        # samples inside the step are taken for all that lies before the last of them
        marks = sorted({*self.sampled, step.begin, step.end})
        gap = max(b - a for a, b in pairwise(marks)) / h * turn
        if gap > TURN:
            kept = np.arange(step.begin, step.end, 0.9 * TURN / turn * h)[1:]
            rows = np.array([[t, *step.step.at(t)] for t in (*kept, step.end)])
            self._pass(rows)
            s, turned = 1.0, 0.0
        elif turned + (1.0 - s) * turn > TURN:
            rows = np.array([[step.end, *step.step.at(step.end)]])
            self._pass(rows)
            s, turned = 1.0, 0.0
        memory.turned = turned + (1.0 - s) * turn

    def _fill(self, samples: Samples, step: _Taken, t: float) -> None:
        """One sample within a step."""
        self.sampled.append(t)
        k, interval = self._done, int(self.memory.interval)
        y, _ = self.modes.projected(t, interval, step.step.at(t), ())
        instant = self.modes.instant(t, interval, y)
        samples.x[k], samples.v[k], samples.a[k], samples.N[k] = self.body.observed(t, y, instant.w)
        samples.z[k] = np.ravel(self.modes.columns(instant, y))
        samples.diagnostics[k] = (
            step.step.size,
            self.body.pivot,
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
        return super().arrays() | {STATE: self.modes.table, SAMPLED: np.array(self.sampled)}

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
        self.modes.table = given
        self.step, self.sampled = None, [float(t) for t in arrays.get(SAMPLED, ())]
