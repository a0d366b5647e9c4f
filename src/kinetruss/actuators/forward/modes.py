"""The state machine of motors: stick, slip, saturation, speed limit; rates in a mode, what ends it, what follows.

A state is: the body's own numbers, currents (k,), values of the driven lengths and angles (k,), which tell the turn that an
angle is in, and per motor the energies of `ENERGIES`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.actuators.forward.drive_model import (
    ENERGIES,
    Command,
    DriveModel,
    Mode,
    MotorInput,
    Observation,
    motor_input,
    observe,
    stored_energy,
)
from kinetruss.actuators.forward.events import ModeEvent
from kinetruss.actuators.forward.slip import slipping

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.forward.body import Body

    Floats = NDArray[np.float64]

__all__ = ["SAME_TURN", "Drives", "Instant", "MotorModes", "mode_of", "saturated", "unwrapped"]

# columns of the table of modes: all that is remembered beside the state
DIRECTION, LIMITED, PLACE, SATURATED, SPEED, JAMMED, FAST = 0, 1, 2, 3, 6, 7, 8
WIDTH = 9
# of its speed: below the limit, held there by the electronics, beyond it
BELOW, HELD, BEYOND = 0, 1, 2
REST = 1e-12
"""Of the largest speed: below this share a length is at rest at the start."""
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
    small: Floats
    stiff: bool
    limits: tuple[float, float] = (-np.inf, np.inf)


class Instant(NamedTuple):
    """All about an instant: input of each motor, accelerations and thrusts of the coordinates, motors that jam."""

    t: float
    interval: int
    inputs: list[MotorInput]
    w: Floats
    thrust: Floats
    jammed: tuple[int, ...]


def mode_of(row: Floats) -> Mode:
    """The mode in a row of the table."""
    return Mode(int(row[DIRECTION]), held=row[SPEED] == HELD, over=row[SPEED] == BEYOND, limited=int(row[LIMITED]))


def saturated(row: Floats) -> list[bool]:
    """Whether input, voltage and current are at their limits, from a row of the table."""
    return [bool(one) for one in row[SATURATED : SATURATED + 3]]


def unwrapped(value: Floats, near: Floats, period: Floats) -> Floats:
    """Values (..., k) in the turn nearest to others; where the period (k,) is 0 as they are."""
    if not period.any():
        return value
    turns = np.rint(np.divide(near - value, period, out=np.zeros_like(value), where=period > 0))
    found: Floats = value + turns * period
    return found


class MotorModes:
    """Which drives slip and stick, and the equations in between. table (k, 9) : the modes, saved with the state."""

    def __init__(self, drives: Drives, body: Body) -> None:
        self.drives, self.models, self.body, self.count = drives, drives.models, body, len(drives.models)
        self.table = np.zeros((self.count, WIDTH))
        self.table[:, JAMMED:] = np.nan
        self.first, self.size = body.count, body.count + (2 + len(ENERGIES)) * self.count

    def currents(self, y: Floats) -> Floats:
        """Currents (k,) of a state, A."""
        return y[self.first : self.first + self.count]

    def values(self, y: Floats) -> Floats:
        """Lengths and angles (k,) as the state has them, m and rad."""
        return y[self.first + self.count : self.first + 2 * self.count]

    def _energies(self, j: int) -> int:
        """Where the energies of motor j stand in a state."""
        return self.first + 2 * self.count + len(ENERGIES) * j

    def tolerances(self, body: float, motors: float) -> Floats:
        """Absolute ones (size,) of the body's numbers and of those of the motors."""
        atol = np.full(self.size, body)
        atol[self.first :] = motors
        self.values(atol)[:] = SAME_TURN
        return atol

    def _evaluate(self, t: float, interval: int, y: Floats) -> None:
        self.body.at(t, interval, y, self.values(y))

    def _rate(self, j: int) -> float:
        return float(self.body.rate[j]) if self.table[j, DIRECTION] else 0.0

    def instant(self, t: float, interval: int, y: Floats) -> Instant:
        """Evaluate the body and the motors."""
        self._evaluate(t, interval, y)
        body, commands, inputs, torque, driven = self.body, self.drives.commands[interval], [], [], []
        state = zip(body.value.tolist(), body.rate.tolist(), self.currents(y).tolist(), self.table.tolist(), strict=True)
        for model, command, (value, rate, current, row) in zip(self.models, commands, state, strict=True):
            given = motor_input(model, command, t, value, rate if row[DIRECTION] else 0.0, current)
            inputs.append(given)
            torque.append(model.torque_constant * given.current)
            driven.append(0 if row[SPEED] == HELD else int(row[DIRECTION]))
        w, jammed = slipping(self.models, driven, torque, body.thrust, body.mass)
        return Instant(t, interval, inputs, w, body.thrust + body.mass @ w, jammed)

    def _observations(self, instant: Instant) -> list[Observation]:
        """Every motor under the whole thrust that it works against."""
        return [
            observe(model, instant.inputs[j], mode_of(self.table[j]), self._rate(j), float(instant.thrust[j]))
            for j, model in enumerate(self.models)
        ]

    def rates(self, interval: int) -> Callable[[float, Floats], Floats]:
        """Derivative of the state in an interval without jumps."""

        def derivative(t: float, y: Floats) -> Floats:
            instant = self.instant(t, interval, y)
            motors, out = self._observations(instant), np.empty_like(y)
            self.body.rates(y, instant.w, out)
            self.currents(out)[:] = [one.current_rate for one in motors]
            self.values(out)[:] = self.body.rate
            out[self._energies(0) :] = [power for one in motors for power in one[5:]]
            return out

        return derivative

    def watch(self, interval: int) -> tuple[list[ModeEvent], Callable[[float, Floats], list[float]]]:
        """What ends the present modes; and a function with the values of those events that are no straight lines."""
        events = [event for j in range(self.count) for event in self._ends(j)]
        sampled = [event for event in events if event.line is None]

        def values(t: float, y: Floats) -> list[float]:
            instant = self.instant(t, interval, y)
            return [self._watched(event.motor, event.name, instant, y) for event in sampled]

        return events, values

    def _ends(self, j: int) -> list[ModeEvent]:
        """The events that end the mode of a motor; those that are straight lines in the state with place, slope and offset."""
        model, row, own = self.models[j], self.table[j], self.body.places
        s, place, rate = float(row[DIRECTION]), *(own[j] if own is not None else (0, 0))
        limits, found = (model.max_input, model.max_voltage, model.max_current), []
        for k, limit in enumerate(limits):
            if np.isfinite(limit) and not (k == 2 and model.inductive):
                found.append(ModeEvent(j, f"saturation {k}"))
        lines = {"stop": (rate, s, 0.0), "speed": (rate, -s, model.max_rate), "slower": (rate, s, -model.max_rate)}
        names = ["stop"] if s else ["forth", "back"]
        if s and np.isfinite(model.max_rate):
            names += {BELOW: ["speed"], HELD: ["release", "weak"], BEYOND: ["slower"]}[int(row[SPEED])]
        found += [ModeEvent(j, name, lines.get(name) if own is not None else None) for name in names]
        if s and own is None:  # the mass of a coordinate alone is constant, and checked
            found.append(ModeEvent(j, "jam"))
        end = self.drives.limits[s > 0]
        if s and own is not None and np.isfinite(end):
            found.append(ModeEvent(j, "end of stroke", (place, -s, s * end)))
        if model.inductive and np.isfinite(model.max_current) and row[SPEED] != HELD:
            at = self.first + j
            ways = [] if row[LIMITED] else [(at, -1.0, model.max_current), (at, 1.0, model.max_current)]
            found += [ModeEvent(j, "limit", way) for way in ways] or [ModeEvent(j, "unlimit")]
        return found

    def _watched(self, j: int, name: str, instant: Instant, y: Floats) -> float:
        model, given, s = self.models[j], instant.inputs[j], float(self.table[j, DIRECTION])
        if name.startswith("saturation"):
            k = int(name[-1])
            return float((1.0 if self.table[j, SATURATED + k] else -1.0) * given[4 + k])
        if name == "stop":
            return s * float(self.body.rate[j])
        if name == "jam":
            return -1.0 if j in instant.jammed else 1.0
        if name in ("forth", "back"):
            return float(self._lacking(j, 1 if name == "forth" else -1, instant) + self.drives.small[j])
        if name in ("speed", "slower"):
            below = model.max_rate - s * float(self.body.rate[j])
            return below if name == "speed" else -below
        if name in ("release", "weak"):
            needed, left = self._spare(j, instant)
            return left if name == "release" else model.max_current - abs(needed)
        return float(self.table[j, LIMITED] * self._surplus(j, given, float(self.currents(y)[j])))

    def _lacking(self, j: int, sign: int, instant: Instant) -> float:
        """Torque (N m) that is lacking to start in a direction."""
        model = self.models[j]
        torque = model.torque_constant * instant.inputs[j].current
        return model.shaft.breakaway(sign, float(instant.thrust[j])) - sign * torque

    def _surplus(self, j: int, given: MotorInput, current: float) -> float:
        """Voltage that would change the current."""
        model = self.models[j]
        return given.driving - model.resistance * current - model.emf_constant * model.shaft.speed * self._rate(j)

    def _spare(self, j: int, instant: Instant) -> tuple[float, float]:
        """Current (A, along the motion) that keeps the speed, and what the source could give beyond it (A, or V)."""
        model, s, rate = self.models[j], int(self.table[j, DIRECTION]), float(self.body.rate[j])
        needed = model.shaft.needed(s, float(instant.thrust[j])) / model.torque_constant
        command = self.drives.commands[instant.interval][j]
        given = motor_input(model, command, instant.t, float(self.body.value[j]), rate, s * needed)
        if model.inductive:
            return needed, s * (given.driving - model.emf_constant * model.shaft.speed * rate) - model.resistance * needed
        return needed, s * given.current - needed

    def _at_speed_limit(self, t: float, interval: int, y: Floats, j: int) -> int:
        """At its largest speed: held, where the motor could go faster and its current can hold it; below where it slows."""
        self.table[j, SPEED] = HELD
        needed, left = self._spare(j, self.instant(t, interval, y))
        if left <= 0 or needed > self.models[j].max_current:
            return BELOW
        return HELD if -needed <= self.models[j].max_current else BEYOND

    def _sped(self, t: float, interval: int, y: Floats, j: int, name: str) -> Floats:
        """State behind a change at the largest speed."""
        model = self.models[j]
        if name == "speed":
            # a current on its way down may drive it on for a moment
            self.table[j, SPEED] = self._at_speed_limit(t, interval, y, j) or BEYOND
        else:
            self.table[j, SPEED] = BEYOND if name == "weak" else BELOW
        if model.inductive and (self.table[j, SPEED] == HELD or name in ("release", "weak")):
            # the limiter sets the current at once: its energy comes from the source, or goes back to it
            speed, self.table[j, SPEED], self.table[j, LIMITED] = self.table[j, SPEED], HELD, 0
            needed, _ = self._spare(j, self.instant(t, interval, y))
            self.table[j, SPEED] = speed
            at = self.first + j
            y[self._energies(j)] += 0.5 * model.inductance * (needed**2 - y[at] ** 2)
            y[at] = self.table[j, DIRECTION] * needed
        return y

    def begin(self, y: Floats) -> Floats:
        """The modes that a start is in, from the body's own numbers; the rest of the state is filled in."""
        self.values(y)[:] = self.drives.start
        self._evaluate(0.0, 0, y)
        body = self.body
        self.table[:, PLACE] = body.value
        moving = np.abs(body.rate * body.scale) > REST * body.fastest(y)
        self.table[:, DIRECTION] = np.where(moving, np.sign(body.rate), 0.0)
        y, _ = self.projected(0.0, 0, y, ())
        return self.settled(0.0, 0, y)

    def projected(self, t: float, interval: int, y: Floats, stopped: tuple[int, ...]) -> tuple[Floats, float]:
        """The state on the constraints, what sticks at rest where it sticks; and how far it was off, m."""
        stuck, places = self.table[:, DIRECTION] == 0, self.table[:, PLACE].copy()
        if stopped:
            self._evaluate(t, interval, y)
        for j in stopped:
            stuck[j], places[j] = True, self.body.value[j]
        y = y.copy()
        values, moved = self.body.project(t, y, stuck, places)
        self.values(y)[:] = np.where(stuck, places, unwrapped(values, self.values(y), self.drives.period))
        self.table[stuck, PLACE] = places[stuck]
        return y, moved

    def changed(self, t: float, interval: int, y: Floats, event: ModeEvent) -> Floats:
        """State behind an event; the table is changed."""
        j, name, _ = event
        if name.startswith("saturation"):
            place = SATURATED + int(name[-1])
            self.table[j, place] = 1.0 - self.table[j, place]
            return y
        if name in ("speed", "slower", "release", "weak"):
            return self._sped(t, interval, y, j, name)
        if name == "stop":
            self.table[j, DIRECTION] = 0
        elif name == "jam":
            self._evaluate(t, interval, y)
            y = self._jam(t, interval, y, (j,))
        elif name in ("limit", "unlimit"):
            at = self.first + j
            if name == "limit":
                y[at] = np.copysign(self.models[j].max_current, y[at])
            self.table[j, LIMITED] = np.sign(y[at]) if name == "limit" else 0
            return y
        return self.settled(t, interval, y)

    def settled(self, t: float, interval: int, y: Floats) -> Floats:
        """Modes of all motors at rest, and the saturations; a screw that jams stops at once.

        Motors at rest start one by one, the one most beyond its static friction first; one that does not get away sticks.
        """
        rest = [j for j in range(self.count) if self.table[j, DIRECTION] == 0]
        excluded: set[int] = set()
        for _ in range(4 * self.count + 4):
            instant = self.instant(t, interval, y)
            if instant.jammed:
                y = self._jam(t, interval, y, instant.jammed)
                rest, excluded = sorted({*rest, *instant.jammed}), excluded | set(instant.jammed)
                continue
            back = [j for j in rest if self.table[j, DIRECTION] and self.table[j, DIRECTION] * instant.w[j] <= 0]
            if back:
                self.table[back, DIRECTION] = 0
                excluded |= set(back)
                continue
            sticking = [j for j in rest if not self.table[j, DIRECTION] and j not in excluded]
            lacking = {(j, s): self._lacking(j, s, instant) for j in sticking for s in (1, -1)}
            best = min(lacking, key=lambda one: lacking[one], default=None)
            if best is None or lacking[best] >= -0.5 * self.drives.small[best[0]]:
                break
            self.table[best[0], DIRECTION] = best[1]
        self._limits(instant, y)
        for j, model in enumerate(self.models):
            share = abs(self._rate(j)) / model.max_rate
            near = self._at_speed_limit(t, interval, y, j) if abs(share - 1.0) <= AT_LIMIT else BELOW
            self.table[j, SPEED] = BEYOND if share > 1.0 + AT_LIMIT else near
        return y

    def _limits(self, instant: Instant, y: Floats) -> None:
        currents = self.currents(y)
        for j, (model, given) in enumerate(zip(self.models, instant.inputs, strict=True)):
            self.table[j, SATURATED : SATURATED + 3] = [given.over_input > 0, given.over_voltage > 0, given.over_current > 0]
            limited = model.inductive and abs(currents[j]) >= model.max_current * (1 - 1e-12)
            outward = limited and self._surplus(j, given, float(currents[j])) * currents[j] > 0
            self.table[j, LIMITED] = np.sign(currents[j]) if outward else 0

    def _jam(self, t: float, interval: int, y: Floats, jammed: tuple[int, ...]) -> Floats:
        """Screws stop at once: an impact, whose energy the screws take. The velocities change as little as the mass allows."""
        before = self.body.rate[list(jammed)].copy()
        self.table[jammed, PLACE] = self.body.value[list(jammed)]
        self.table[jammed, DIRECTION] = 0
        if not np.abs(before).any():
            return y
        first = self.body.kinetic(y)
        y, _ = self.projected(t, interval, y, ())
        lost = first - self.body.kinetic(y)
        for j, rate in zip(jammed, before, strict=True):
            self.table[j, JAMMED] = t if np.isnan(self.table[j, JAMMED]) else self.table[j, JAMMED]
            shaft, at = self.models[j].shaft, self._energies(j)
            y[at + 4] += 0.5 * shaft.inertia * (shaft.speed * rate) ** 2 + lost / len(jammed)
            y[at + 5] -= lost / len(jammed)
        return y

    def columns(self, instant: Instant, y: Floats) -> Floats:
        """What is recorded of the motors (k, COLUMNS) at an instant of a state."""
        rows = []
        for j, (model, one) in enumerate(zip(self.models, self._observations(instant), strict=True)):
            rate, at = self._rate(j), self._energies(j)
            if abs(rate) > model.max_rate * (1 + 1e-9) and np.isnan(self.table[j, FAST]):
                self.table[j, FAST] = instant.t
            turned, speed = model.shaft.speed * (self.body.value[j] - self.drives.start[j]), model.shaft.speed * rate
            screw, torque = np.nan if model.shaft.turns else one.screw_torque, model.torque_constant * one.current
            row = [one.input.command, one.voltage, one.current, torque, turned, speed, self.table[j, DIRECTION], screw]
            rows.append([*row, *y[at : at + len(ENERGIES)], stored_energy(model, rate, one.current)])
        return np.array(rows)

    def notes(self) -> list[str]:
        """What the message says at the end."""
        found = []
        for name, row, model in zip(self.drives.names, self.table, self.models, strict=True):
            if not np.isnan(row[JAMMED]):
                locks = "gear" if model.shaft.turns else "screw"
                found.append(
                    f"The {locks} of {name} jammed at t = {row[JAMMED]:.6g} s: what drove it is too heavy for its rotor."
                )
            if not np.isnan(row[FAST]):
                limit = model.max_rate * model.shaft.speed
                found.append(
                    f"The motor of {name} went beyond its largest speed ({limit:.4g} rad/s), first seen at {row[FAST]:.6g} s."
                )
        return found
