"""What held a drive back: when, and by how much."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.forward.drive_model import BELOW, COLUMNS, HELD, motor_input
from kinetruss.results import Episode, Status

if TYPE_CHECKING:
    from kinetruss.actuators.forward.modes import MotorModes
    from kinetruss.actuators.forward.phases import Phase

__all__ = ["episodes", "outcome"]

LOOKS = 17
"""Instants of a phase at which the worst is looked for."""
STALLED = 0.1
"""A drive that stands still, asked to move, for this last part of a run has stalled."""
KINDS = ("input saturated", "voltage saturated", "current saturated")


def episodes(modes: MotorModes, phases: list[Phase]) -> tuple[Episode, ...]:
    """All episodes in order of time; neighbouring phases of one kind are one."""
    found: dict[str, list[Episode]] = {}
    for phase in phases:
        for new in _of_phase(modes, phase):
            kept = found.setdefault(new.kind, [])
            if kept and kept[-1].end == new.start:
                kept[-1] = _one(kept[-1], new)
            else:
                kept.append(new)
    every = [one for kept in found.values() for one in kept]
    limits = modes.drives.limits
    if math.isfinite(max(limits)):
        last = phases[-1]
        length = float(last.at(last.end)[0])
        edge = min(limits, key=lambda limit: abs(limit - length))
        if last.mode.direction and abs(edge - length) <= 1e-9 * max(abs(edge), abs(limits[1] - limits[0])):
            every.append(
                Episode(
                    "end of stroke", last.end, last.end, last.end, length, edge, "rad" if modes.models[0].shaft.turns else "m"
                )
            )
    return tuple(sorted(every, key=lambda one: (one.start, one.kind)))


def outcome(found: tuple[Episode, ...], phases: list[Phase], duration: float) -> Status:
    """What a run came to: the gravest of its episodes."""
    end = phases[-1].end
    kinds = {one.kind for one in found}
    if "end of stroke" in kinds or end < duration:
        return Status.END_OF_STROKE
    if any(one.kind == "stuck" and one.end == end and one.end - one.start > STALLED * duration for one in found):
        return Status.STALLED
    if kinds & {"speed limit", "too fast"}:
        return Status.SPEED_LIMIT
    return Status.SATURATED if kinds & set(KINDS) else Status.COMPLETED


def _one(first: Episode, second: Episode) -> Episode:
    worse = max(first, second, key=lambda one: one.wanted - one.possible if one.kind != "stuck" else one.possible - one.wanted)
    return Episode(first.kind, first.start, second.end, worse.time, worse.wanted, worse.possible, worse.unit)


def _of_phase(modes: MotorModes, phase: Phase) -> Iterator[Episode]:
    model, command = modes.models[0], modes.drives.commands[phase.interval][0]
    begin, end, mode = phase.begin, phase.end, phase.mode
    instants = np.linspace(begin, end, LOOKS).tolist()
    states = [phase.at(t).tolist() for t in instants]
    for which, saturated in enumerate(mode.saturated):
        if saturated:
            limit, unit = ((model.max_input, "V"), (model.max_voltage, "V"), (model.max_current, "A"))[which]
            over = [motor_input(model, command, t, *y[:3])[4 + which] for t, y in zip(instants, states, strict=True)]
            at = int(np.argmax(over))
            yield Episode(KINDS[which], begin, end, instants[at], limit + over[at], limit, unit)
    if mode.limited:
        yield Episode(KINDS[2], begin, end, begin, *(model.max_current,) * 2, "A")
    if mode.speed != BELOW:
        fastest = model.shaft.speed * max(abs(y[1]) for y in states)
        kind = "speed limit" if mode.speed == HELD else "too fast"
        yield Episode(kind, begin, end, begin, fastest, model.shaft.speed * model.max_rate, "rad/s")
    if mode.direction == 0:
        yield from _stuck(modes, phase, instants, states)
    elif _driven(modes, phase, (begin + end) / 2):
        yield Episode("driven back", begin, end, begin, math.nan, 0.0, "N m")


def _stuck(modes: MotorModes, phase: Phase, instants: list[float], states: list[list[float]]) -> Iterator[Episode]:
    """Asked to move, but too weak to."""
    model, command = modes.models[0], modes.drives.commands[phase.interval][0]
    worst: tuple[float, float, float] | None = None
    for t, y in zip(instants, states, strict=True):
        torque = model.torque_constant * motor_input(model, command, t, *y[:3]).current
        if abs(torque) <= max(modes.drives.small[0], 1e-12):
            continue
        load = phase.instant(modes, t, np.array(y)).thrust[0]
        needed = model.shaft.breakaway(1 if torque > 0 else -1, load)
        if worst is None or abs(torque) - needed > worst[1] - worst[2]:
            worst = t, abs(torque), needed
    if worst is not None:
        yield Episode("stuck", phase.begin, phase.end, worst[0], worst[2], worst[1], "N m")


def _driven(modes: MotorModes, phase: Phase, t: float) -> bool:
    """The motor does not push, yet the load moves."""
    y = phase.at(t)
    instant, s = phase.instant(modes, t, y), phase.mode.direction
    torque = modes.columns(instant, y)[0][list(COLUMNS).index("motor_torque")]
    return not s * torque > modes.drives.small[0] and s * instant.thrust[0] < 0 and s * modes.body.thrust[0] < 0
