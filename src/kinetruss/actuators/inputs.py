"""Inputs, targets and loads as functions of time, cut where they have a kink."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.drive_model import Command, DriveModel, Gains, gains_of, motor_input
from kinetruss.errors import InputError
from kinetruss.model import DriveInput, DriveLoad, DriveTrain, ExponentialInput, PositionLoop, SineInput, StepInput, TableInput

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence


Law = Callable[[float], float]
SHORTEST = 1e-14
"""Of a duration, an interval that is round-off."""
STIFF = 3e4
"""Decays of the winding in a run above which an implicit method is cheaper."""


def source_of(history: DriveInput | PositionLoop) -> str:
    """``voltage`` or ``current``: what the history gives, torques as `in_currents`."""
    if isinstance(history, PositionLoop):
        return "voltage"
    if isinstance(history, StepInput | ExponentialInput | SineInput):
        return "current" if history.voltage is None else "voltage"
    if isinstance(history, TableInput):
        return "current" if history.voltages is None else "voltage"
    raise InputError(
        f"{type(history).__name__} is no input of a drive. "
        "Give kt.StepInput, ExponentialInput, SineInput, TableInput or PositionLoop."
    )


def in_currents(train: DriveTrain, history: Any) -> tuple[DriveTrain, Any]:
    """The same train and input; a torque of the motor is the current that gives it, past the amplifier."""
    field = "torques" if isinstance(history, TableInput) else "torque"
    torque = getattr(history, field, None)
    if torque is None:
        return train, history
    given = tuple(torque) if isinstance(torque, tuple) else (torque,)
    currents = tuple(one / train.motor.torque_constant for one in given)
    flowing = currents if isinstance(torque, tuple) else currents[0]
    return train.with_(amplifier=None), history.with_(**{field: None, field.replace("torque", "current"): flowing})


def edges_of(times: Iterable[float], duration: float) -> tuple[float, ...]:
    """0, the duration, and the times (s) between them, sorted.

    No two are closer than `SHORTEST`: an interval of round-off has neither a middle nor a step.

    >>> edges_of([0.3, 5e-324, 0.3 + 1e-16, 0.1, 2.0], 1.0)
    (0.0, 0.1, 0.3, 1.0)
    """
    found, least = [0.0], SHORTEST * duration
    for t in sorted(times):
        if found[-1] + least < t < duration - least:
            found.append(t)
    return (*found, float(duration))


def kinks(history: DriveInput | PositionLoop, load: DriveLoad) -> set[float]:
    """Times at which input, target or load jump or bend, s."""
    times: set[float] = set(load.times or ())
    if isinstance(history, TableInput | PositionLoop):
        times |= set(history.times or ())
    elif isinstance(history, StepInput):
        times |= {history.start} | ({history.end} if history.end is not None else set())
    return times


def longest_step(history: DriveInput | PositionLoop, duration: float) -> float:
    """A step that sees every turn of the input, s."""
    return min(duration / 20, history.period / 40) if isinstance(history, SineInput) else duration / 20


def command_of(history: DriveInput | PositionLoop, gains: Gains | None, start: float, end: float) -> Command:
    """Input between two neighbouring kinks."""
    middle = (start + end) / 2
    if isinstance(history, PositionLoop):
        assert gains is not None  # noqa: S101 - a loop comes with its gains
        return _feedback(history, gains, middle)
    law = _law(history, middle)
    return lambda t, length, rate, current: law(t)  # noqa: ARG005 - open loop


def _feedback(loop: PositionLoop, gains: Gains, middle: float) -> Command:
    wanted: Law
    if loop.times is None or loop.targets is None:
        target = float(loop.target or 0.0)

        def wanted(t: float) -> float:  # noqa: ARG001 - constant
            return target
    else:
        wanted = _line(loop.times, loop.targets, middle)
    position, speed, winding = gains.position, gains.rate, gains.current

    def command(t: float, length: float, rate: float, current: float) -> float:
        return position * (wanted(t) - length) - speed * rate - winding * current

    return command


def _law(history: Any, middle: float) -> Law:
    if isinstance(history, TableInput):
        return _line(history.times, history.voltages or history.currents or (), middle)
    value = history.voltage if history.voltage is not None else history.current
    if isinstance(history, StepInput):
        on = history.start <= middle and (history.end is None or middle < history.end)
        level = float(value) if on else 0.0
        return lambda t: level  # noqa: ARG005 - constant
    if isinstance(history, SineInput):
        w, phase, amplitude = 2 * math.pi / history.period, history.phase, float(value)
        return lambda t: amplitude * math.sin(w * t + phase)
    first, last, tau = float(value[0]), float(value[1]), history.time_constant
    return lambda t: last + (first - last) * math.exp(-t / tau)


def thrust_of(load: DriveLoad, start: float, end: float) -> Callable[[float, float], float]:
    """Thrust (N) against the drive by time and length, between two neighbouring kinks."""
    middle = (start + end) / 2
    if load.amounts is None:
        constant = load.amount or 0.0
        return lambda t, length: constant  # noqa: ARG005 - constant
    if load.times is not None:
        line = _line(load.times, load.amounts, middle)
        return lambda t, length: line(t)  # noqa: ARG005 - a table in time
    places, values = np.array(load.places), np.array(load.amounts)
    return lambda t, length: float(np.interp(length, places, values))  # noqa: ARG005 - a table over the length


def _line(times: Sequence[float], values: Sequence[float], middle: float) -> Law:
    """The straight line of a table around an instant; constant outside."""
    at = int(np.searchsorted(times, middle))
    if at == 0 or at == len(times):
        held = values[0] if at == 0 else values[-1]
        return lambda t: held  # noqa: ARG005 - constant
    begin, value = times[at - 1], values[at - 1]
    slope = (values[at] - value) / (times[at] - begin)
    return lambda t: value + slope * (t - begin)


def inputs_of(
    models: Sequence[DriveModel],
    histories: Sequence[DriveInput | PositionLoop],
    edges: Sequence[float],
    start: Sequence[float],
    masses: Sequence[float],
    thrust: Callable[[int, float], Sequence[float]],
) -> dict[str, Any]:
    """What the `Drives` need to know of their inputs, between edges (s) where nothing jumps.

    start, masses (k,) : values, and the mass that each motor sees there. thrust(interval, t) (k,) : N, at these values.
    """
    gains = [
        gains_of(model, one, mass) if isinstance(one, PositionLoop) else None
        for model, one, mass in zip(models, histories, masses, strict=True)
    ]
    commands = tuple(
        tuple(command_of(one, gain, a, b) for one, gain in zip(histories, gains, strict=True)) for a, b in pairwise(edges)
    )
    duration, windings = edges[-1], [model.resistance / model.inductance for model in models if model.inductive]
    return {
        "models": tuple(models),
        "edges": tuple(edges),
        "commands": commands,
        "start": np.array(start),
        "longest": min(longest_step(one, duration) for one in histories),
        "small": small_torques(models, commands, edges, start, thrust),
        "stiff": any(duration * decay > STIFF for decay in windings),
    }


def small_torques(
    models: Sequence[DriveModel],
    commands: Sequence[Sequence[Command]],
    edges: Sequence[float],
    start: Any,
    thrust: Callable[[int, float], Any],
) -> list[float]:
    """Torques (k,), N m, that are none beside those that occur. thrust(interval, t) (k,) : N, at the values `start` (k,)."""
    found = [model.shaft.friction for model in models]
    for interval, (a, b) in enumerate(pairwise(edges)):
        for t in np.linspace(a, b, 9).tolist():
            against = thrust(interval, t)
            for j, model in enumerate(models):
                given = motor_input(model, commands[interval][j], t, float(start[j]), 0.0, 0.0)
                current = given.driving / model.resistance if model.inductive and model.resistance else given.current
                found[j] = max(found[j], abs(against[j]) * model.shaft.rest_up, model.torque_constant * abs(current))
    return [1e-11 * float(one) + 1e-18 for one in found]
