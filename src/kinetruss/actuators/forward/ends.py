"""What ends the mode of a motor: values that fall through zero, of friction, saturation, speed and current."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from kinetruss.actuators.forward.drive_model import BELOW, HELD
from kinetruss.actuators.forward.events import ModeEvent

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from kinetruss.actuators.forward.modes import Instant, MotorModes

    Values = Callable[[float, NDArray[np.float64]], list[float]]

__all__ = ["watch"]


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
