"""The state machine of motors: stick, slip, saturation, speed limit; and what they move."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np

from kinetruss.actuators.drive_model import (
    BELOW,
    BEYOND,
    ENERGIES,
    HELD,
    Command,
    DriveModel,
    Mode,
    MotorInput,
    Observation,
    motor_input,
    observe,
    stored_energy,
)
from kinetruss.actuators.slip import slipping

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.events import ModeEvent

    Floats = NDArray[np.float64]


class Body(Protocol):
    """A body with k driven coordinates, lengths (m) or angles (rad).

    count : numbers of its own at the beginning of a state.
    places : where value and rate of each coordinate stand in a state; None where they are no states.

    `at` evaluates value, rate, thrust (k,) and mass (k, k): with accelerations w (k,) of the coordinates the motors push with
    F = thrust + mass w, N or N m. They are plain numbers: a drive alone has one, and arrays of one would take its time.
    """

    count: int
    places: Sequence[tuple[int, int]] | None
    value: list[float]
    rate: list[float]
    thrust: list[float]
    mass: list[list[float]]

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:
        """Evaluate at t (s) of an interval between two jumps; angles are counted on from those of `near` (k,)."""

    def bends(self, w: list[float]) -> bool:
        """True if thrust and mass were not those at the accelerations w (k,), where `at` was called last; they are now."""

    def pushed(self, w: list[float]) -> list[float]:
        """F (k,), with the accelerations w (k,), where `at` was called last."""

    def rates(self, y: Floats, w: list[float]) -> list[float]:
        """Rates of its own numbers, with the accelerations w (k,), where `at` was called last."""

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:
        """Bring its own numbers onto its constraints, coordinates that are `stuck` (k,) at rest at `places` (k,).

        Returns values (k,), angles in any turn, and the largest change, m.
        """

    def moving(self, y: Floats) -> list[bool]:
        """Which coordinates (k,) move, beyond round-off, where `at` was called last."""

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""


class Coordinate:
    """The body of a drive alone: a mass (kg, kg m^2) moves with the length or angle, thrust(t, length) acts against it.

    thrusts : one law for each interval.
    """

    def __init__(self, mass: float, thrusts: Sequence[Callable[[float, float], float]]) -> None:
        self.thrusts, self.count = thrusts, 2
        self.places: Sequence[tuple[int, int]] | None = ((0, 1),)
        self.value, self.rate, self.thrust = [0.0], [0.0], [0.0]
        self.mass = [[mass]]

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:  # noqa: ARG002 - the angle itself is the state
        """Evaluate at t (s) of a state."""
        self.value[0], self.rate[0] = y.item(0), y.item(1)
        self.thrust[0] = self.thrusts[interval](t, self.value[0])

    def bends(self, w: list[float]) -> bool:  # noqa: ARG002 - the thrust does not depend on it
        """Never."""
        return False

    def pushed(self, w: list[float]) -> list[float]:
        """The whole thrust, with the mass that is accelerated."""
        return [self.thrust[0] + self.mass[0][0] * w[0]]

    def rates(self, y: Floats, w: list[float]) -> list[float]:  # noqa: ARG002 - its rate is known
        """Rate and acceleration."""
        return [self.rate[0], w[0]]

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:  # noqa: ARG002
        """A coordinate that sticks stands at its place."""
        if stuck[0]:
            y[0], y[1] = places[0], 0.0
        return y[:1], 0.0

    def moving(self, y: Floats) -> list[bool]:
        """Whether it has a rate."""
        return [y[1] != 0]

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""
        return 0.5 * self.mass[0][0] * float(y[1]) ** 2


# What ends the mode of a motor: values that fall through zero, of friction, saturation, speed and current.


# The state machine of motors: stick, slip, saturation, speed limit; rates in a mode, what ends it, what follows.
#
# A state is: the body's own numbers, currents (k,), values of the driven lengths and angles (k,), which tell the turn that an
# angle is in, and per motor the energies of `ENERGIES`.

ROUNDS = 60
"""Most of them for accelerations whose joint forces change the friction that changes them."""
AT_LIMIT = 1e-9
"""Share of its largest speed within which a motor is at it."""
SAME_TURN = 0.1
"""Error (m, rad) of the values of lengths and angles, which only tell the turn: the body tells all else."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Drives:
    """k drives and their inputs. names, models : of each.

    edges : times (s) between which nothing jumps; commands[i][j] : input of motor j in interval i. period (k,) : after which a
    position has the same value again, 2 pi of an angle, 0 of a length. start (k,) : values, m, rad. longest : step, s.
    small (k,) : N m, a torque that is none. stiff : a winding is so quick that an implicit method is cheaper. limits :
    least and largest value.
    """

    names: tuple[str, ...]
    models: tuple[DriveModel, ...]
    edges: tuple[float, ...]
    commands: tuple[tuple[Command, ...], ...]
    period: Floats
    start: Floats
    longest: float
    small: Sequence[float]
    stiff: bool
    limits: tuple[float, float] = (-math.inf, math.inf)


class Instant(NamedTuple):
    """All about an instant: values, rates (0 where one sticks), accelerations and thrusts of the coordinates (k,).

    currents (k or more,), inputs (k,) : of the motors. jammed : motors that jam.
    """

    t: float
    interval: int
    value: list[float]
    rate: list[float]
    currents: list[float]
    inputs: list[MotorInput]
    w: list[float]
    thrust: list[float]
    jammed: tuple[int, ...]


def unwrapped(value: Floats, near: Floats, period: Floats) -> Floats:
    """Values (..., k) in the turn nearest to others; where the period (k,) is 0 as they are."""
    if not period.any():
        return value
    turns = np.rint(np.divide(near - value, period, out=np.zeros_like(value), where=period > 0))
    found: Floats = value + turns * period
    return found


class MotorModes:
    """Which drives slip and stick, and the equations in between."""

    def __init__(self, drives: Drives, body: Body | Coordinate) -> None:
        self.drives, self.models, self.body, self.count = drives, drives.models, body, len(drives.models)
        self.modes = [Mode(0, 0, 0.0, [False] * 3, BELOW, math.nan, math.nan) for _ in self.models]
        self.first, self.energies = body.count, body.count + 2 * self.count
        self.size = self.energies + len(ENERGIES) * self.count
        self._start = drives.start.tolist()

    @property
    def table(self) -> Floats:
        """The modes as numbers (k, 9), saved with the state."""
        return np.array([mode.row() for mode in self.modes], float)

    @table.setter
    def table(self, table: Floats) -> None:
        self.modes = [Mode.of(row) for row in table.tolist()]

    def values(self, y: Floats) -> Floats:
        """Lengths and angles (k,) as the state has them, m and rad."""
        return y[self.first + self.count : self.energies]

    def tolerances(self, body: float, motors: float) -> Floats:
        """Absolute ones (size,) of the body's numbers and of those of the motors."""
        atol = np.full(self.size, body)
        atol[self.first :] = motors
        self.values(atol)[:] = SAME_TURN
        return atol

    def _answer(self, t: float, interval: int, y: Floats) -> tuple[Any, ...]:
        """Rates, currents and what follows of an `Instant`; value and rate of the body are evaluated too."""
        body, own = self.body, y[self.first : self.energies].tolist()
        body.at(t, interval, y, own[self.count :])
        rates, inputs, torque, driven = [], [], [], []
        motors = zip(self.models, self.modes, self.drives.commands[interval], body.value, body.rate, own, strict=False)
        for model, mode, command, value, rate, current in motors:
            s = mode.direction
            given = motor_input(model, command, t, value, rate if s else 0.0, current)
            rates.append(rate if s else 0.0)
            inputs.append(given)
            torque.append(model.torque_constant * given.current)
            driven.append(s if mode.speed != HELD else 0)
        w, jammed = slipping(self.models, driven, torque, body.thrust, body.mass)
        for _ in range(ROUNDS):
            if jammed or not body.bends(w):
                break
            w, jammed = slipping(self.models, driven, torque, body.thrust, body.mass)
        return rates, own, inputs, w, body.pushed(w), jammed

    def instant(self, t: float, interval: int, y: Floats) -> Instant:
        """Evaluate the body and the motors."""
        answer = self._answer(t, interval, y)
        return Instant(t, interval, self.body.value[:], *answer)

    def _observations(self, instant: Instant) -> list[Observation]:
        """Every motor under the whole thrust that it works against."""
        return list(map(observe, self.models, instant.inputs, self.modes, instant.rate, instant.thrust))

    def rates(self, interval: int) -> Callable[[float, Floats], list[float]]:
        """Derivative of the state in an interval without jumps, in the present modes."""
        answer, body, models = self._answer, self.body, self.models

        def derivative(t: float, y: Floats) -> list[float]:
            rates, _, inputs, w, thrust, _ = answer(t, interval, y)
            motors = [observe(*one) for one in zip(models, inputs, self.modes, rates, thrust, strict=False)]
            found = body.rates(y, w)
            found += [one.current_rate for one in motors]
            found += body.rate
            for one in motors:
                found += one[5:]
            return found

        return self._alone(interval, body) if isinstance(body, Coordinate) else derivative

    def _alone(self, interval: int, body: Coordinate) -> Callable[[float, Floats], list[float]]:
        """The same of a drive alone, without loops: its mass is a number, and does not jam it."""
        (model,), (mode,), (command,), law = self.models, self.modes, self.drives.commands[interval], body.thrusts[interval]
        shaft, push, direction, ((mass,),) = model.shaft, model.torque_constant, mode.direction, body.mass
        driven = direction != 0 and mode.speed != HELD

        def derivative(t: float, y: Floats) -> list[float]:
            value, rate, current, *_ = y.tolist()
            moved = rate if direction else 0.0
            given, thrust, w = motor_input(model, command, t, value, moved, current), law(t, value), 0.0
            if driven:
                w = shaft.acceleration(direction, push * given.current, thrust, mass)
            motor = observe(model, given, mode, moved, thrust + mass * w)
            return [rate, w, motor.current_rate, rate, *motor[5:]]

        return derivative

    def lacking(self, j: int, sign: int, instant: Instant) -> float:
        """Torque (N m) that motor j lacks to start in a direction."""
        model = self.models[j]
        return model.shaft.breakaway(sign, instant.thrust[j]) - sign * model.torque_constant * instant.inputs[j].current

    def surplus(self, j: int, instant: Instant) -> float:
        """Voltage that would change the current of motor j."""
        model, current = self.models[j], instant.currents[j]
        back = model.emf_constant * model.shaft.speed * instant.rate[j]
        return instant.inputs[j].driving - model.resistance * current - back

    def spare(self, j: int, instant: Instant) -> tuple[float, float]:
        """Current (A, along the motion) that keeps the speed of motor j, and what the source could give beyond it (A, or V)."""
        model, s, rate = self.models[j], self.modes[j].direction, instant.rate[j]
        needed = model.shaft.needed(s, instant.thrust[j]) / model.torque_constant
        command = self.drives.commands[instant.interval][j]
        given = motor_input(model, command, instant.t, instant.value[j], rate, s * needed)
        if model.inductive:
            return needed, s * (given.driving - model.emf_constant * model.shaft.speed * rate) - model.resistance * needed
        return needed, s * given.current - needed

    def _at_speed_limit(self, t: float, interval: int, y: Floats, j: int) -> int:
        """At its largest speed: held, where the motor could go faster and its current can hold it; below where it slows."""
        self.modes[j].speed = HELD
        needed, left = self.spare(j, self.instant(t, interval, y))
        if left <= 0 or needed > self.models[j].max_current:
            return BELOW
        return HELD if -needed <= self.models[j].max_current else BEYOND

    def _sped(self, t: float, interval: int, y: Floats, j: int, name: str) -> Floats:
        """State behind a change at the largest speed."""
        model, mode, at = self.models[j], self.modes[j], self.first + j
        # a current on its way down may drive it on for a moment
        to = (self._at_speed_limit(t, interval, y, j) or BEYOND) if name == "speed" else BEYOND if name == "weak" else BELOW
        if model.inductive and (to == HELD or name in ("release", "weak")):
            # the limiter sets the current at once: its energy comes from the source, or goes back to it
            mode.speed, mode.limited = HELD, 0
            needed, _ = self.spare(j, self.instant(t, interval, y))
            y[self.energies + len(ENERGIES) * j] += 0.5 * model.inductance * (needed**2 - y[at] ** 2)
            y[at] = mode.direction * needed
        mode.speed = to
        return y

    def begin(self, y: Floats) -> Floats:
        """The modes that a start is in, from the body's own numbers; the rest of the state is filled in."""
        self.values(y)[:] = self.drives.start
        body = self.body
        body.at(0.0, 0, y, self._start)
        for mode, value, rate, moves in zip(self.modes, body.value, body.rate, body.moving(y), strict=True):
            mode.place, mode.direction = value, int(np.sign(rate)) if moves else 0
        y, _ = self.projected(0.0, 0, y, ())
        return self.settled(0.0, 0, y)

    def projected(self, t: float, interval: int, y: Floats, stopped: tuple[int, ...]) -> tuple[Floats, float]:
        """The state on the constraints, what sticks at rest where it sticks; and how far it was off, m."""
        y = y.copy()
        if stopped:
            self.body.at(t, interval, y, self.values(y).tolist())
        stuck = [mode.direction == 0 or j in stopped for j, mode in enumerate(self.modes)]
        places = [self.body.value[j] if j in stopped else mode.place for j, mode in enumerate(self.modes)]
        values, moved = self.body.project(t, y, stuck, places)
        self.values(y)[:] = np.where(stuck, places, unwrapped(values, self.values(y), self.drives.period))
        for j in stopped:
            self.modes[j].place = places[j]
        return y, moved

    def changed(self, t: float, interval: int, y: Floats, event: ModeEvent) -> Floats:
        """State and modes behind an event."""
        j, name, at, mode = event.motor, event.name, self.first + event.motor, self.modes[event.motor]
        if name.startswith("saturation"):
            mode.saturated[int(name[-1])] ^= True
        elif name in ("speed", "slower", "release", "weak"):
            return self._sped(t, interval, y, j, name)
        elif name == "limit":
            y[at] = np.copysign(self.models[j].max_current, y[at])
            mode.limited = int(np.sign(y[at]))
        elif name == "unlimit":
            mode.limited = 0
        else:
            if name == "stop":
                mode.direction = 0
            elif name == "jam":
                self.body.at(t, interval, y, self.values(y).tolist())
                y = self._jam(t, interval, y, (j,))
            return self.settled(t, interval, y)
        return y

    def settled(self, t: float, interval: int, y: Floats) -> Floats:
        """Modes of all motors at rest, and the saturations; a screw that jams stops at once.

        Motors at rest start one by one, the one most beyond its static friction first; one that does not get away sticks.
        """
        modes, excluded = self.modes, set[int]()
        rest = [j for j, mode in enumerate(modes) if mode.direction == 0]
        for _ in range(4 * self.count + 4):
            instant = self.instant(t, interval, y)
            if instant.jammed:
                y = self._jam(t, interval, y, instant.jammed)
                rest, excluded = sorted({*rest, *instant.jammed}), excluded | set(instant.jammed)
                continue
            back = [j for j in rest if modes[j].direction and modes[j].direction * instant.w[j] <= 0]
            if back:
                for j in back:
                    modes[j].direction = 0
                excluded |= set(back)
                continue
            sticking = [j for j in rest if not modes[j].direction and j not in excluded]
            lacking = {(j, s): self.lacking(j, s, instant) for j in sticking for s in (1, -1)}
            best = min(lacking, key=lambda one: lacking[one], default=None)
            if best is None or lacking[best] >= -0.5 * self.drives.small[best[0]]:
                break
            modes[best[0]].direction = best[1]
        self._limits(instant)
        for j, (model, mode) in enumerate(zip(self.models, modes, strict=True)):
            share = abs(instant.rate[j]) / model.max_rate
            near = self._at_speed_limit(t, interval, y, j) if abs(share - 1.0) <= AT_LIMIT else BELOW
            mode.speed = BEYOND if share > 1.0 + AT_LIMIT else near
        return y

    def _limits(self, instant: Instant) -> None:
        for j, (model, mode, given) in enumerate(zip(self.models, self.modes, instant.inputs, strict=True)):
            mode.saturated, current = [over > 0 for over in given[4:]], instant.currents[j]
            limited = model.inductive and abs(current) >= model.max_current * (1 - 1e-12)
            mode.limited = int(np.sign(current)) if limited and self.surplus(j, instant) * current > 0 else 0

    def _jam(self, t: float, interval: int, y: Floats, jammed: tuple[int, ...]) -> Floats:
        """Screws stop at once: an impact, whose energy the screws take. The velocities change as little as the mass allows."""
        before = [self.body.rate[j] for j in jammed]
        for j in jammed:
            self.modes[j].place, self.modes[j].direction = self.body.value[j], 0
        if not any(before):
            return y
        first = self.body.kinetic(y)
        y, _ = self.projected(t, interval, y, ())
        lost = first - self.body.kinetic(y)
        for j, rate in zip(jammed, before, strict=True):
            mode, shaft, at = self.modes[j], self.models[j].shaft, self.energies + len(ENERGIES) * j
            mode.jammed = t if math.isnan(mode.jammed) else mode.jammed
            y[at + 4] += 0.5 * shaft.inertia * (shaft.speed * rate) ** 2 + lost / len(jammed)
            y[at + 5] -= lost / len(jammed)
        return y

    def columns(self, instant: Instant, y: Floats) -> list[list[float]]:
        """What is recorded of the motors (k, COLUMNS) at an instant of a state."""
        rows, n, spent = [], len(ENERGIES), y[self.energies :].tolist()
        for j, (model, mode, one) in enumerate(zip(self.models, self.modes, self._observations(instant), strict=True)):
            rate = instant.rate[j]
            if abs(rate) > model.max_rate * (1 + 1e-9) and math.isnan(mode.fast):
                mode.fast = instant.t
            turned, speed = model.shaft.speed * (instant.value[j] - self._start[j]), model.shaft.speed * rate
            screw, torque = math.nan if model.shaft.turns else one.screw_torque, model.torque_constant * one.current
            row = [one.input.command, one.voltage, one.current, torque, turned, speed, mode.direction, screw]
            rows.append([*row, *spent[n * j : n * j + n], stored_energy(model, rate, one.current)])
        return rows

    def notes(self) -> list[str]:
        """What the message says at the end."""
        found = []
        for name, mode, model in zip(self.drives.names, self.modes, self.models, strict=True):
            if not math.isnan(mode.jammed):
                locks = "gear" if model.shaft.turns else "screw"
                found.append(
                    f"The {locks} of {name} jammed at t = {mode.jammed:.6g} s: what drove it is too heavy for its rotor."
                )
            if not math.isnan(mode.fast):
                limit = model.max_rate * model.shaft.speed
                found.append(
                    f"The motor of {name} went beyond its largest speed ({limit:.4g} rad/s), first seen at {mode.fast:.6g} s."
                )
        return found
