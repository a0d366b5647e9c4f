"""Integration of a drive through its modes: it sticks, slips, saturates, runs at its speed limit.

Between two changes of mode the equations are smooth. Each change is found as a root of the interpolant of a step, and the
integration starts anew behind it: Coulomb friction is never smoothed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853, Radau
from scipy.optimize import brentq

from kinetruss.actuators.forward.plant import Mode, Piece, Plant, feed, observe, rates
from kinetruss.errors import AnalysisError

__all__ = ["Stretch", "felt", "march"]

Floats = NDArray[np.float64]
Watch = Callable[[float, Floats], float]

LOOKS = 4
"""Places within a step at which a change of mode is looked for."""
MOST_CHANGES = 5000
LEAST = 1e-140
"""Rates (SI) below which the squares of errors are no numbers any more."""
STIFF = 3e4
"""Decays of the winding in a run above which an implicit method is cheaper."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """A time in one mode: from `begin` to `end` (s); at(t) gives the states. saturated : of input, voltage, current."""

    begin: float
    end: float
    mode: Mode
    saturated: tuple[bool, bool, bool]
    piece: Piece
    at: Callable[[float], Floats]


@dataclass(frozen=True, slots=True)
class Task:
    """What does not change during a run. torque : N m, differences below it are none. limits : of the length, m."""

    plant: Plant
    torque: float
    limits: tuple[float, float]
    rtol: float
    atol: Floats
    longest: float
    stiff: bool


def march(task: Task, pieces: list[tuple[float, float, Piece]], y: Floats) -> list[Stretch]:
    """All stretches of a run from the state y; the last ends early where the stroke does."""
    found: list[Stretch] = []
    for begin, end, piece in pieces:
        t, mode = begin, settled(task, piece, begin, y)
        saturated = _saturated(task.plant, piece, t, y)
        while t < end:
            if mode.direction and mode.direction * (task.limits[mode.direction > 0] - y[0]) <= 0:
                return found
            stretch, event = _stretch(task, piece, mode, saturated, (t, end), y)
            found.append(stretch)
            t, y = stretch.end, stretch.at(stretch.end).copy()
            if event == "end of stroke":
                return found
            if event is not None:
                y, mode, saturated = _changed(task, piece, mode, saturated, t, y, event)
            if len(found) > MOST_CHANGES:
                raise AnalysisError(
                    f"The drive changed its mode {MOST_CHANGES} times before t = {t:.6g} s. Its loop chatters: lower its gains."
                )
    return found


def settled(task: Task, piece: Piece, t: float, y: Floats) -> Mode:
    """The mode that a state is in."""
    plant, (length, rate, current) = task.plant, y[:3]
    given = feed(plant, piece, t, length, rate, current)
    limited = 0
    if plant.inductive and abs(current) >= plant.max_current * (1 - 1e-12):
        outward = (given.driving - plant.resistance * current - plant.emf_constant * plant.shaft.speed * rate) * current
        limited = int(np.sign(current)) if outward > 0 else 0
    if rate == 0:
        torque, load = plant.torque_constant * given.current, piece.thrust(t, length)
        margins = [s * torque - plant.shaft.breakaway(s, load) for s in (1, -1)]
        best = int(np.argmax(margins))
        return Mode((1, -1)[best] if margins[best] > task.torque / 2 else 0, limited=limited)
    direction = 1 if rate > 0 else -1
    if abs(rate) < plant.max_rate * (1 - 1e-12):
        return Mode(direction, limited=limited)
    if abs(rate) > plant.max_rate * (1 + 1e-9):
        return Mode(direction, over=True, limited=limited)
    return _at_speed_limit(plant, piece, t, y, direction) or Mode(direction, limited=limited)


def _at_speed_limit(plant: Plant, piece: Piece, t: float, y: Floats, direction: int) -> Mode | None:
    """Held, where the motor could go faster and its current may be what holds it; beyond, where the load is too much for that.

    None where it slows down.
    """
    needed, left = _spare(plant, piece, t, y, direction)
    if left <= 0 or needed > plant.max_current:
        return None
    return Mode(direction, held=True) if -needed <= plant.max_current else Mode(direction, over=True)


def _spare(plant: Plant, piece: Piece, t: float, y: Floats, direction: int) -> tuple[float, float]:
    """Current (A, along the motion) that keeps the speed, and what the source could give beyond it (A, or V)."""
    length, rate = y[0], y[1]
    needed = plant.shaft.needed(direction, piece.thrust(t, length)) / plant.torque_constant
    given = feed(plant, piece, t, length, rate, direction * needed)
    if plant.inductive:
        emf = plant.emf_constant * plant.shaft.speed * rate
        return needed, direction * (given.driving - emf) - plant.resistance * needed
    return needed, direction * given.current - needed


def _saturated(plant: Plant, piece: Piece, t: float, y: Floats) -> tuple[bool, bool, bool]:
    given = feed(plant, piece, t, y[0], y[1], y[2])
    return given.over_input > 0, given.over_voltage > 0, given.over_current > 0


def _changed(
    task: Task, piece: Piece, mode: Mode, saturated: tuple[bool, bool, bool], t: float, y: Floats, event: str
) -> tuple[Floats, Mode, tuple[bool, bool, bool]]:
    """State, mode and saturations behind an event."""
    plant = task.plant
    if event.startswith("saturation"):
        which = int(event[-1])
        bits = [bit != (k == which) for k, bit in enumerate(saturated)]
        return y, mode, (bits[0], bits[1], bits[2])
    if event == "stop":
        y[1] = 0.0
        mode = settled(task, piece, t, y)
    elif event in ("forth", "back"):
        mode = replace(mode, direction=1 if event == "forth" else -1)
    elif event == "speed":
        y[1] = mode.direction * plant.max_rate
        # a current on its way down may drive it on for a moment
        mode = _at_speed_limit(plant, piece, t, y, mode.direction) or replace(mode, over=True)
    elif event == "slower":
        mode = replace(mode, over=False)
    elif event in ("release", "weak"):
        mode = Mode(mode.direction, over=event == "weak")
    elif event == "limit":
        y[2] = np.copysign(plant.max_current, y[2])
        mode = replace(mode, limited=int(np.sign(y[2])))
    elif event == "unlimit":
        mode = replace(mode, limited=0)
    if plant.inductive and (mode.held or event in ("release", "weak")):
        _set_current(plant, piece, mode.direction, t, y)
    return y, mode, saturated


def _set_current(plant: Plant, piece: Piece, direction: int, t: float, y: Floats) -> None:
    """The limiter sets the current at once: its energy comes from the source, or goes back to it."""
    needed, _ = _spare(plant, piece, t, y, direction)
    y[3] += 0.5 * plant.inductance * (needed**2 - y[2] ** 2)
    y[2] = direction * needed


def felt(rates: Any) -> Floats:
    """Rates without those so small that the error estimate of SciPy's DOP853 would divide the zeros of their squares."""
    found = np.asarray(rates, float)
    found[np.abs(found) < LEAST] = 0.0
    return found


def _stretch(
    task: Task, piece: Piece, mode: Mode, saturated: tuple[bool, bool, bool], span: tuple[float, float], y: Floats
) -> tuple[Stretch, str | None]:
    """Integrate until a mode ends; the event that ends it, or None at the end of the span."""
    method = Radau if task.stiff else DOP853

    def derivative(t: float, state: Floats) -> Floats:
        return felt(rates(task.plant, piece, mode, t, state.tolist()))

    solver = method(derivative, span[0], y, span[1], max_step=task.longest, rtol=task.rtol, atol=task.atol)
    watches = list(_watches(task, piece, mode, saturated))
    before = [watch(span[0], y) for _, watch in watches]
    steps: list[Any] = []
    while solver.status == "running":
        solver.step()
        if solver.status == "failed":
            raise AnalysisError(f"The drive could not be integrated beyond t = {solver.t:.6g} s: its step became too small.")
        dense = solver.dense_output()
        steps.append(dense)
        event, when = _first(watches, before, dense)
        if event is not None:
            return Stretch(span[0], when, mode, saturated, piece, _joined(steps)), event
    return Stretch(span[0], span[1], mode, saturated, piece, _joined(steps)), None


def _first(watches: list[tuple[str, Watch]], before: list[float], dense: Any) -> tuple[str | None, float]:
    """The first fall of a watch through zero within a step; updates the values `before`."""
    name, first = None, dense.t_max
    places = np.linspace(dense.t_min, dense.t_max, LOOKS + 1)
    states = [dense(place) for place in places]
    for k, (label, watch) in enumerate(watches):
        old, at = before[k], places[0]
        for place, state in zip(places[1:], states[1:], strict=True):
            new = watch(place, state)
            if old == 0 > new:
                old, at = _rise(watch, dense, at, place)
            if old > 0 >= new:
                root = brentq(lambda t: watch(t, dense(t)), at, place, xtol=1e-15, rtol=8.9e-16)  # noqa: B023 - used at once
                if name is None or root < first:
                    name, first = label, root
                break
            old, at = new, place
        before[k] = old
    return name, first


def _rise(watch: Watch, dense: Any, begin: float, end: float) -> tuple[float, float]:
    """Where a watch that starts at zero, and is below zero at `end`, is above it in between: value and place; else zero."""
    for k in range(1, 40):
        place = begin + (end - begin) * 0.5**k
        if (value := watch(place, dense(place))) > 0:
            return value, place
    return 0.0, begin


def _joined(steps: list[Any]) -> Callable[[float], Floats]:
    ends = np.array([step.t_max for step in steps])

    def at(t: float) -> Floats:
        found: Floats = steps[min(int(np.searchsorted(ends, t)), len(steps) - 1)](t)
        return found

    return at


def _watches(task: Task, piece: Piece, mode: Mode, saturated: tuple[bool, bool, bool]) -> Any:
    """What ends a mode: a name, and a function of time and state that falls through zero then."""
    plant = task.plant
    for k, (limit, bit) in enumerate(zip((plant.max_input, plant.max_voltage, plant.max_current), saturated, strict=True)):
        if np.isfinite(limit) and not (k == 2 and plant.inductive):
            yield f"saturation {k}", _saturation(plant, piece, k, bit)
    least, largest = task.limits
    if mode.direction:
        edge = largest if mode.direction > 0 else least
        if np.isfinite(edge):
            yield "end of stroke", lambda t, y: mode.direction * (edge - y[0])  # noqa: ARG005
        yield "stop", lambda t, y: mode.direction * y[1]  # noqa: ARG005
    else:
        for name, sign in (("forth", 1), ("back", -1)):
            yield name, _sticking(task, piece, sign)
    if mode.direction and np.isfinite(plant.max_rate):
        if mode.held:
            yield "release", lambda t, y: _spare(plant, piece, t, y, mode.direction)[1]
            yield "weak", lambda t, y: plant.max_current - abs(_spare(plant, piece, t, y, mode.direction)[0])
        elif mode.over:
            yield "slower", lambda t, y: mode.direction * y[1] - plant.max_rate  # noqa: ARG005
        else:
            yield "speed", lambda t, y: plant.max_rate - mode.direction * y[1]  # noqa: ARG005
    if plant.inductive and np.isfinite(plant.max_current) and not mode.held:
        if not mode.limited:
            yield "limit", lambda t, y: plant.max_current - abs(y[2])  # noqa: ARG005
        else:
            yield "unlimit", _outward(plant, piece, mode.limited)


def _saturation(plant: Plant, piece: Piece, which: int, saturated: bool) -> Watch:
    sign = 1.0 if saturated else -1.0

    def watch(t: float, y: Floats) -> float:
        return sign * feed(plant, piece, t, y[0], y[1], y[2])[4 + which]

    return watch


def _outward(plant: Plant, piece: Piece, sign: int) -> Watch:
    """What would raise a limited current further, V."""

    def watch(t: float, y: Floats) -> float:
        driving = feed(plant, piece, t, y[0], y[1], y[2]).driving
        return float(sign * (driving - plant.resistance * y[2] - plant.emf_constant * plant.shaft.speed * y[1]))

    return watch


def _sticking(task: Task, piece: Piece, sign: int) -> Watch:
    plant = task.plant

    def watch(t: float, y: Floats) -> float:
        given = observe(plant, piece, Mode(0), t, (y[0], 0.0, y[2]))
        return plant.shaft.breakaway(sign, given.thrust) + task.torque - sign * plant.torque_constant * given.current

    return watch
