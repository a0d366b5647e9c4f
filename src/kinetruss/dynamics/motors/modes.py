"""The modes of motors coupled with a structure: rates of the state, what ends a mode, what comes behind it.

A state is: free positions, free velocities, currents (k,), values of the motor-driven lengths and angles (k,), which tell the
turn that an angle is in, and per motor the energies of `ENERGIES`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.actuators.forward import Feed, Mode, Piece, Seen, feed, felt, observe
from kinetruss.dynamics.motors.laws import slipping
from kinetruss.dynamics.motors.motors import Response, motor_places, unwrapped
from kinetruss.errors import AnalysisError
from kinetruss.kernels.solve.kkt import kinetic
from kinetruss.kernels.solve.motors import motor_project

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.forward.problem import Problem

    Floats = NDArray[np.float64]

__all__ = ["ENERGIES", "MotorModes"]

# columns of the table of modes: all that is remembered beside the state
DIRECTION, LIMITED, PLACE, SATURATED, SPEED, JAMMED, FAST = 0, 1, 2, 3, 6, 7, 8
WIDTH = 9
# of its speed: below the limit, held there by the electronics, beyond it
BELOW, HELD, BEYOND = 0, 1, 2
TOLERANCE = 1e-13
REST = 1e-12
"""Of the largest speed: below this share a length is at rest at the start."""
AT_LIMIT = 1e-9
"""Share of its largest speed within which a motor is at it."""
SPEED_ENDS = {BELOW: ("speed",), HELD: ("release", "weak"), BEYOND: ("slower",)}
"""What ends each of them."""
ENERGIES = ("electrical", "copper", "motor", "gear", "screw", "work")


class _Instant(NamedTuple):
    """All about an instant: what feeds each motor, accelerations of the coordinates, motors that jam."""

    t: float
    edge: int
    feeds: list[Feed]
    w: Floats
    thrust: Floats
    jammed: tuple[int, ...]


def _constant(value: float) -> Callable[[float, float], float]:
    return lambda t, length: value  # noqa: ARG005 - whatever time and length


class MotorModes:
    """Which screws slip and stick, and the equations in between. table (k, 8) : the modes, saved with the state."""

    def __init__(self, problem: Problem) -> None:
        assert problem.motors is not None  # noqa: S101 - made for them
        self.problem, self.motors = problem, problem.motors
        eq, k = problem.eq, len(problem.motors.names)
        self.free, self.count, self.base = eq.free, k, problem.x0
        self.response = Response(eq, problem.ws, problem.user, problem.motors.rows, problem.motors.period)
        self.table = np.zeros((k, WIDTH))
        self.table[:, JAMMED:] = np.nan
        self.places = motor_places(problem.motors.rows, problem.x0.size)

    def state(self, y: Floats) -> tuple[Floats, Floats]:
        """Positions and velocities (3 n,); prescribed coordinates as at the start."""
        nf, x, v = len(self.free), self.base.copy(), np.zeros_like(self.base)
        x[self.free], v[self.free] = y[:nf], y[nf : 2 * nf]
        return x, v

    def _mode(self, j: int) -> Mode:
        row = self.table[j]
        return Mode(int(row[DIRECTION]), held=row[SPEED] == HELD, over=row[SPEED] == BEYOND, limited=int(row[LIMITED]))

    @property
    def first(self) -> int:
        """Where the currents stand in a state."""
        return 2 * len(self.free)

    def _currents(self, y: Floats) -> Floats:
        return y[self.first : self.first + self.count]

    def values(self, y: Floats) -> Floats:
        """Lengths and angles as the state has them, m and rad."""
        return y[self.first + self.count : self.first + 2 * self.count]

    def _energies(self, j: int) -> int:
        """Where the energies of motor j stand in a state."""
        return self.first + 2 * self.count + len(ENERGIES) * j

    def _answer(self, t: float, y: Floats) -> Response:
        return self.response.at(t, *self.state(y), self.values(y))

    def _instant(self, t: float, edge: int, y: Floats) -> _Instant:
        """Evaluate the structure and the motors."""
        answer, plants = self._answer(t, y), self.motors.plants
        direction = self.table[:, DIRECTION].astype(int).tolist()
        lengths, speeds, currents = answer.value.tolist(), answer.rate.tolist(), self._currents(y).tolist()
        pieces = self.motors.pieces[edge]
        feeds = [
            feed(plant, pieces[j], t, lengths[j], speeds[j] if direction[j] else 0.0, currents[j])
            for j, plant in enumerate(plants)
        ]
        torque = np.array([plant.torque_constant * given.current for plant, given in zip(plants, feeds, strict=True)])
        pushed = [0 if speed == HELD else s for s, speed in zip(direction, self.table[:, SPEED], strict=True)]
        w, jammed = slipping(plants, pushed, torque, answer.thrust, answer.mass)
        return _Instant(t, edge, feeds, w, answer.thrust + answer.mass @ w, jammed)

    def _seen(self, t: float, edge: int, y: Floats, instant: _Instant) -> list[Seen]:
        """Every motor under the whole thrust that it works against, so without a mass of its own."""
        currents, answer, found = self._currents(y), self.response, []
        for j, plant in enumerate(self.motors.plants):
            piece = Piece(command=self.motors.pieces[edge][j].command, thrust=_constant(float(instant.thrust[j])))
            mode = self._mode(j)
            rate = float(answer.rate[j]) if mode.direction else 0.0
            found.append(observe(plant, piece, mode, t, (float(answer.value[j]), rate, float(currents[j]))))
        return found

    def rates(self, edge: int) -> Callable[[float, Floats], Floats]:
        """Derivative of the state between two edges."""
        nf = len(self.free)

        def derivative(t: float, y: Floats) -> Floats:
            instant = self._instant(t, edge, y)
            seen = self._seen(t, edge, y, instant)
            out = np.empty_like(y)
            out[:nf] = y[nf : 2 * nf]
            out[nf : 2 * nf] = self.response.found(instant.w)[0][self.free]
            self._currents(out)[:] = [one.current_rate for one in seen]
            self.values(out)[:] = self.response.rate
            out[self._energies(0) :] = [power for one in seen for power in one[7:]]
            return felt(out)

        return derivative

    def watch(self, edge: int) -> tuple[list[tuple[int, str]], Callable[[float, Floats], list[float]]]:
        """What ends the present modes: motor and name, and a function whose values fall through zero then."""
        names: list[tuple[int, str]] = []
        for j, plant in enumerate(self.motors.plants):
            limits = (plant.max_input, plant.max_voltage, plant.max_current)
            names += [
                (j, f"saturation {k}")
                for k, limit in enumerate(limits)
                if np.isfinite(limit) and not (k == 2 and plant.inductive)
            ]
            names += [(j, "stop"), (j, "jam")] if self.table[j, DIRECTION] else [(j, "forth"), (j, "back")]
            if self.table[j, DIRECTION] and np.isfinite(plant.max_rate):
                names += [(j, name) for name in SPEED_ENDS[int(self.table[j, SPEED])]]
            if plant.inductive and np.isfinite(plant.max_current) and self.table[j, SPEED] != HELD:
                names.append((j, "unlimit" if self.table[j, LIMITED] else "limit"))

        def values(t: float, y: Floats) -> list[float]:
            instant = self._instant(t, edge, y)
            return [self._watched(j, name, instant, y) for j, name in names]

        return names, values

    def _watched(self, j: int, name: str, instant: _Instant, y: Floats) -> float:
        plant, given, current = self.motors.plants[j], instant.feeds[j], float(self._currents(y)[j])
        if name.startswith("saturation"):
            k = int(name[-1])
            return float((1.0 if self.table[j, SATURATED + k] else -1.0) * given[4 + k])
        if name == "stop":
            return float(self.table[j, DIRECTION] * self.response.rate[j])
        if name == "jam":
            return -1.0 if j in instant.jammed else 1.0
        if name in ("forth", "back"):
            sign = 1 if name == "forth" else -1
            return float(self._needed(j, sign, instant) + self.motors.small[j])
        if name == "limit":
            return plant.max_current - abs(current)
        if name in ("speed", "slower"):
            below = plant.max_rate - float(self.table[j, DIRECTION] * self.response.rate[j])
            return below if name == "speed" else -below
        if name in ("release", "weak"):
            needed, left = self._spare(j, instant)
            return left if name == "release" else plant.max_current - abs(needed)
        return float(self.table[j, LIMITED] * self._surplus(j, given, current))

    def _needed(self, j: int, sign: int, instant: _Instant) -> float:
        """Torque (N m) that is lacking to start in a direction."""
        plant = self.motors.plants[j]
        torque = plant.torque_constant * instant.feeds[j].current
        return plant.shaft.breakaway(sign, float(instant.thrust[j])) - sign * torque

    def _surplus(self, j: int, given: Feed, current: float) -> float:
        """Voltage that would change the current."""
        plant = self.motors.plants[j]
        rate = float(self.response.rate[j]) if self.table[j, DIRECTION] else 0.0
        return given.driving - plant.resistance * current - plant.emf_constant * plant.shaft.speed * rate

    def _spare(self, j: int, instant: _Instant) -> tuple[float, float]:
        """Current (A, along the motion) that keeps the speed, and what the source could give beyond it (A, or V)."""
        plant, s, rate = self.motors.plants[j], int(self.table[j, DIRECTION]), float(self.response.rate[j])
        needed = plant.shaft.needed(s, float(instant.thrust[j])) / plant.torque_constant
        piece = self.motors.pieces[instant.edge][j]
        given = feed(plant, piece, instant.t, float(self.response.value[j]), rate, s * needed)
        if plant.inductive:
            return needed, s * (given.driving - plant.emf_constant * plant.shaft.speed * rate) - plant.resistance * needed
        return needed, s * given.current - needed

    def _at_speed_limit(self, t: float, edge: int, y: Floats, j: int) -> int:
        """At its largest speed: held, where the motor could go faster and its current can hold it; below where it slows."""
        self.table[j, SPEED] = HELD
        needed, left = self._spare(j, self._instant(t, edge, y))
        if left <= 0 or needed > self.motors.plants[j].max_current:
            return BELOW
        return HELD if -needed <= self.motors.plants[j].max_current else BEYOND

    def _sped(self, t: float, edge: int, y: Floats, j: int, name: str) -> Floats:
        """State behind a change at the largest speed."""
        plant = self.motors.plants[j]
        if name == "speed":
            # a current on its way down may drive it on for a moment
            self.table[j, SPEED] = self._at_speed_limit(t, edge, y, j) or BEYOND
        else:
            self.table[j, SPEED] = BEYOND if name == "weak" else BELOW
        if plant.inductive and (self.table[j, SPEED] == HELD or name in ("release", "weak")):
            # the limiter sets the current at once: its energy comes from the source, or goes back to it
            speed, self.table[j, SPEED] = self.table[j, SPEED], HELD
            needed, _ = self._spare(j, self._instant(t, edge, y))
            self.table[j, SPEED] = speed
            at = self.first + j
            y[self._energies(j)] += 0.5 * plant.inductance * (needed**2 - y[at] ** 2)
            y[at] = self.table[j, DIRECTION] * needed
        return y

    def begin(self, y: Floats) -> Floats:
        """The modes that a start is in."""
        self.values(y)[:] = self.motors.start
        answer, (_, v) = self._answer(0.0, y), self.state(y)
        self.table[:, PLACE] = answer.value
        moving = np.abs(answer.rate * answer.scale) > REST * np.abs(v).max(initial=0.0)
        self.table[:, DIRECTION] = np.where(moving, np.sign(answer.rate), 0.0)
        y, _ = self.projected(0.0, 0, y, ())
        return self.settled(0.0, 0, y)

    def projected(self, t: float, edge: int, y: Floats, stopped: tuple[int, ...]) -> tuple[Floats, float]:  # noqa: ARG002
        """The state on the constraints, what sticks at rest where it sticks; and how far it was off, m."""
        x, v = self.state(y)
        stuck, places = self.places.stuck, self.places.value
        stuck[:], places[:] = self.table[:, DIRECTION] == 0, self.table[:, PLACE]
        for j in stopped:
            stuck[j], places[j] = 1, self._answer(t, y).value[j]
        good, moved = motor_project(self.problem.eq, self.problem.ws, t, x, v, self.places, TOLERANCE)
        if not good:
            raise AnalysisError(f"The lengths of the bars could not be closed at t = {t:.6g} s.")
        y, nf = y.copy(), len(self.free)
        y[:nf], y[nf : 2 * nf] = x[self.free], v[self.free]
        self.values(y)[:] = places = np.where(stuck, places, unwrapped(places, self.values(y), self.motors.period))
        self.table[:, PLACE] = np.where(stuck == 1, places, self.table[:, PLACE])
        return y, moved

    def changed(self, t: float, edge: int, y: Floats, change: tuple[int, str]) -> Floats:
        """State behind a change of mode; the table is changed."""
        j, name = change
        if name.startswith("saturation"):
            place = SATURATED + int(name[-1])
            self.table[j, place] = 1.0 - self.table[j, place]
            return y
        if name in ("speed", "slower", "release", "weak"):
            return self._sped(t, edge, y, j, name)
        if name == "stop":
            self.table[j, DIRECTION] = 0
        elif name == "jam":
            self._answer(t, y)
            y = self._jam(t, y, (j,))
        elif name in ("limit", "unlimit"):
            at = self.first + j
            if name == "limit":
                y[at] = np.copysign(self.motors.plants[j].max_current, y[at])
            self.table[j, LIMITED] = np.sign(y[at]) if name == "limit" else 0
            return y
        return self.settled(t, edge, y)

    def settled(self, t: float, edge: int, y: Floats) -> Floats:
        """Modes of all screws at rest, and the saturations; a screw that jams stops at once.

        Screws at rest start one by one, the one most beyond its static friction first; one that does not get away sticks.
        """
        rest = [j for j in range(self.count) if self.table[j, DIRECTION] == 0]
        spoilt: set[int] = set()
        for _ in range(4 * self.count + 4):
            instant = self._instant(t, edge, y)
            if instant.jammed:
                y = self._jam(t, y, instant.jammed)
                rest, spoilt = sorted({*rest, *instant.jammed}), spoilt | set(instant.jammed)
                continue
            back = [j for j in rest if self.table[j, DIRECTION] and self.table[j, DIRECTION] * instant.w[j] <= 0]
            if back:
                self.table[back, DIRECTION] = 0
                spoilt |= set(back)
                continue
            lacking = {
                (j, s): self._needed(j, s, instant)
                for j in rest
                if not self.table[j, DIRECTION] and j not in spoilt
                for s in (1, -1)
            }
            best = min(lacking, key=lambda one: lacking[one], default=None)
            if best is None or lacking[best] >= -0.5 * self.motors.small[best[0]]:
                break
            self.table[best[0], DIRECTION] = best[1]
        self._limits(instant, y)
        for j, plant in enumerate(self.motors.plants):
            share = abs(self.response.rate[j]) / plant.max_rate if self.table[j, DIRECTION] else 0.0
            near = self._at_speed_limit(t, edge, y, j) if abs(share - 1.0) <= AT_LIMIT else BELOW
            self.table[j, SPEED] = BEYOND if share > 1.0 + AT_LIMIT else near
        return y

    def _limits(self, instant: _Instant, y: Floats) -> None:
        currents = self._currents(y)
        for j, (plant, given) in enumerate(zip(self.motors.plants, instant.feeds, strict=True)):
            self.table[j, SATURATED : SATURATED + 3] = [given.over_input > 0, given.over_voltage > 0, given.over_current > 0]
            limited = plant.inductive and abs(currents[j]) >= plant.max_current * (1 - 1e-12)
            outward = limited and self._surplus(j, given, float(currents[j])) * currents[j] > 0
            self.table[j, LIMITED] = np.sign(currents[j]) if outward else 0

    def _jam(self, t: float, y: Floats, jammed: tuple[int, ...]) -> Floats:
        """Screws stop at once: an impact, whose energy the screws take. The velocities change as little as the mass allows."""
        eq, ws = self.problem.eq, self.problem.ws
        before = self.response.rate[list(jammed)].copy()
        self.table[jammed, PLACE] = self.response.value[list(jammed)]
        self.table[jammed, DIRECTION] = 0
        moving = np.abs(before) > 0
        if not moving.any():
            return y
        first = kinetic(eq, ws, *self.state(y))
        y, _ = self.projected(t, 0, y, ())
        lost = first - kinetic(eq, ws, *self.state(y))
        for j, rate in zip(jammed, before, strict=True):
            self.table[j, JAMMED] = t if np.isnan(self.table[j, JAMMED]) else self.table[j, JAMMED]
            shaft, at = self.motors.plants[j].shaft, self._energies(j)
            y[at + 4] += 0.5 * shaft.inertia * (shaft.speed * rate) ** 2 + lost / len(jammed)
            y[at + 5] -= lost / len(jammed)
        return y

    def observed(self, t: float, edge: int, y: Floats) -> tuple[Any, ...]:
        """x, v, a (3 n,), N (r,), what is told of the motors (k times COLUMNS,), smallest pivot."""
        x, v = self.state(y)
        instant = self._instant(t, edge, y)
        a, N = self.response.found(instant.w)
        self.response.at(t, x, v, self.values(y))
        rows = []
        for j, (plant, seen) in enumerate(zip(self.motors.plants, self._seen(t, edge, y, instant), strict=True)):
            rate = self.response.rate[j] if self.table[j, DIRECTION] else 0.0
            if abs(rate) > plant.max_rate * (1 + 1e-9) and np.isnan(self.table[j, FAST]):
                self.table[j, FAST] = t
            stored = 0.5 * plant.shaft.inertia * (plant.shaft.speed * rate) ** 2
            stored += 0.5 * plant.inductance * seen.current**2 if plant.inductive else 0.0
            at, turned = self._energies(j), plant.shaft.speed * (self.response.value[j] - self.motors.start[j])
            rows += [seen.feed.command, seen.voltage, seen.current, plant.torque_constant * seen.current, turned]
            rows += [plant.shaft.speed * rate, self.table[j, DIRECTION], np.nan if plant.shaft.turns else seen.screw_torque]
            rows += [*y[at : at + len(ENERGIES)], stored]
        return x, v, a, N, np.array(rows), self.response.pivot

    def notes(self) -> list[str]:
        """What is to be said at the end."""
        found = []
        for name, row, plant in zip(self.motors.names, self.table, self.motors.plants, strict=True):
            if not np.isnan(row[JAMMED]):
                locks = "gear" if plant.shaft.turns else "screw"
                found.append(
                    f"The {locks} of {name} jammed at t = {row[JAMMED]:.6g} s: what drove it is too heavy for its rotor."
                )
            if not np.isnan(row[FAST]):
                limit = plant.max_rate * plant.shaft.speed
                found.append(
                    f"The motor of {name} went beyond its largest speed ({limit:.4g} rad/s), first seen at {row[FAST]:.6g} s."
                )
        return found
