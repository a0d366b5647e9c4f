"""Steps of SciPy's methods through the modes of motors: each ends at the first event, behind which a new one begins.

Between two events the equations are smooth; Coulomb friction is never smoothed. The method is DOP853, or Radau where a
winding is very quick.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853, Radau

from kinetruss.actuators.drive_model import (
    BELOW,
    HELD,
)
from kinetruss.actuators.events import Interpolant, ModeEvent, Values, first_change
from kinetruss.actuators.modes import Instant, MotorModes

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.modes import MotorModes

    Floats = NDArray[np.float64]


LEAST = 1e-140
"""Rates (SI) below which the squares of errors are no numbers any more."""


@dataclass(frozen=True, slots=True)
class Tolerances:
    """rtol, atol (size,) : of a state. first : size of a step to begin with, s; 0 where the method finds one."""

    rtol: float
    atol: Floats
    first: float = 0.0


@dataclass(frozen=True, slots=True)
class Step:
    """From `begin` to `end` (s). at : the interpolant, at(t) the state; event : what ends the mode, if anything.

    size, next : of steps, s.
    """

    begin: float
    end: float
    at: Interpolant
    event: ModeEvent | None
    size: float
    next: float


def method_from(modes: MotorModes, interval: int, t: float, y: Floats, until: float, given: Tolerances) -> Any:
    """SciPy's method from a state on, in the present modes, to `until` (s), the end of the interval or of the run."""
    rates, last = modes.rates(interval), np.nextafter(until, -np.inf)
    solver = (Radau if modes.drives.stiff else DOP853)(
        # a jump at the end belongs to the next interval
        lambda t, y: finite_rates(rates(min(t, last), y)),
        t,
        y,
        until,
        max_step=modes.drives.longest,
        rtol=given.rtol,
        atol=given.atol,
    )
    if given.first > 0:
        solver.h_abs = given.first
    return solver


def finite_rates(rates: Iterable[float]) -> Floats:
    """Rates without those so small that the error estimate of SciPy's DOP853 would divide the zeros of their squares."""
    return np.array([0.0 if -LEAST < rate < LEAST else rate for rate in rates])


def step_of(solver: Any, watched: tuple[list[ModeEvent], Values]) -> Step | None:
    """One step, cut at the first event; None where none can be taken. watched : see `ends.watch`."""
    begin, y = float(solver.t), solver.y
    solver.step()
    if solver.status == "failed" or not np.isfinite(solver.y).all():
        return None
    dense = Interpolant(solver.dense_output())
    event, end = first_change(*watched, (begin, y), dense)
    return Step(begin, end, dense, event, float(solver.t - begin), float(solver.h_abs))


# What ends the mode of a motor: values that fall through zero, of friction, saturation, speed and play.


def watch(modes: MotorModes, interval: int) -> tuple[list[ModeEvent], Values]:
    """What ends the present modes; and a function with the values of those events that are no straight lines."""
    events = [event for j in range(modes.count) for ends in (_saturated, _moved, _sped, _flowed) for event in ends(modes, j)]
    sampled = [event.value for event in events if event.line is None]

    def values(t: float, y: NDArray[np.float64]) -> list[float]:
        instant = modes.instant(t, interval, y)
        return [value(instant) for value in sampled]

    return events, values


def _saturated(modes: MotorModes, j: int) -> Iterator[ModeEvent]:
    """An input, voltage or current that reaches or leaves its limit."""
    model = modes.models[j]
    for k, limit in enumerate((model.max_input, model.max_voltage, model.max_current)):
        if math.isfinite(limit) and not (k == 2 and model.inductive):
            sign = 1.0 if modes.modes[j].saturated[k] else -1.0

            def over(at: Instant, k: int = k, sign: float = sign) -> float:
                return sign * at.inputs[j][4 + k]

            yield ModeEvent(j, f"saturation {k}", over)


def _moved(modes: MotorModes, j: int) -> Iterator[ModeEvent]:
    """A motion that stops, jams or comes to the end of its stroke; or one that starts."""
    s, own, small = modes.modes[j].direction, modes.body.places, modes.drives.small[j]
    if not s:
        yield ModeEvent(j, "forth", lambda at: modes.lacking(j, 1, at) + small)
        yield ModeEvent(j, "back", lambda at: modes.lacking(j, -1, at) + small)
        return
    yield ModeEvent(j, "stop", lambda at: s * at.rate[j], None if own is None else (own[j][1], s, 0.0))
    if own is None:  # the mass of a coordinate alone is constant, and checked
        yield ModeEvent(j, "jam", lambda at: -1.0 if j in at.jammed else 1.0)
    end = modes.drives.limits[s > 0]
    if math.isfinite(end):
        yield ModeEvent(
            j, "end of stroke", lambda at: s * (end - at.value[j]), None if own is None else (own[j][0], -s, s * end)
        )


def _sped(modes: MotorModes, j: int) -> Iterator[ModeEvent]:
    """A motor that comes to its largest speed, leaves it there, or comes back to it."""
    model, mode, own = modes.models[j], modes.modes[j], modes.body.places
    s, most = mode.direction, model.max_rate
    if not (s and math.isfinite(most)):
        return
    if mode.speed == HELD:
        yield ModeEvent(j, "release", lambda at: modes.spare(j, at)[1])
        yield ModeEvent(j, "weak", lambda at: model.max_current - abs(modes.spare(j, at)[0]))
    elif mode.speed == BELOW:
        yield ModeEvent(j, "speed", lambda at: most - s * at.rate[j], None if own is None else (own[j][1], -s, most))
    else:
        yield ModeEvent(j, "slower", lambda at: s * at.rate[j] - most, None if own is None else (own[j][1], s, -most))


def _flowed(modes: MotorModes, j: int) -> Iterator[ModeEvent]:
    """A current through an inductance that comes to its limit, or leaves it there."""
    model, mode = modes.models[j], modes.modes[j]
    most = model.max_current
    if not (model.inductive and math.isfinite(most)) or mode.speed == HELD:
        return
    if mode.limited:
        yield ModeEvent(j, "unlimit", lambda at: mode.limited * modes.surplus(j, at))
        return
    at = modes.first + j
    yield ModeEvent(j, "limit", lambda now: most - now.currents[j], (at, -1, most))
    yield ModeEvent(j, "limit", lambda now: most + now.currents[j], (at, 1, most))
