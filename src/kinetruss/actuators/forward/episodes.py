"""What held a drive back: when, and by how much."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.forward.plant import Plant, feed, observe
from kinetruss.results import Episode, Status

if TYPE_CHECKING:
    from kinetruss.actuators.forward.integrate import Stretch

__all__ = ["episodes", "outcome"]

LOOKS = 17
"""Instants of a stretch at which the worst is looked for."""
STALLED = 0.1
"""A drive that stands still, told to move, for this last part of a run has stalled."""
KINDS = ("input saturated", "voltage saturated", "current saturated")


def episodes(plant: Plant, stretches: list[Stretch], limits: tuple[float, float] | None, nothing: float) -> tuple[Episode, ...]:
    """All episodes in order of time; neighbouring stretches of one kind are one. Torques up to `nothing` (N m) are none."""
    found: dict[str, list[Episode]] = {}
    for stretch in stretches:
        for new in _of_stretch(plant, stretch, nothing):
            kept = found.setdefault(new.kind, [])
            if kept and kept[-1].end == new.start:
                kept[-1] = _one(kept[-1], new)
            else:
                kept.append(new)
    every = [one for kept in found.values() for one in kept]
    if limits is not None and stretches:
        last = stretches[-1]
        length = float(last.at(last.end)[0])
        edge = min(limits, key=lambda limit: abs(limit - length))
        if last.mode.direction and abs(edge - length) <= 1e-9 * max(abs(edge), abs(limits[1] - limits[0])):
            every.append(
                Episode("end of stroke", last.end, last.end, last.end, length, edge, "rad" if plant.shaft.turns else "m")
            )
    return tuple(sorted(every, key=lambda one: (one.start, one.kind)))


def outcome(found: tuple[Episode, ...], stretches: list[Stretch], duration: float) -> Status:
    """What a run came to: the gravest of its episodes."""
    end = stretches[-1].end if stretches else 0.0
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


def _of_stretch(plant: Plant, stretch: Stretch, nothing: float) -> Iterator[Episode]:
    begin, end, mode = stretch.begin, stretch.end, stretch.mode
    instants = np.linspace(begin, end, LOOKS).tolist()
    states = [stretch.at(t).tolist() for t in instants]
    for which, saturated in enumerate(stretch.saturated):
        if saturated:
            limit, unit = ((plant.max_input, "V"), (plant.max_voltage, "V"), (plant.max_current, "A"))[which]
            over = [feed(plant, stretch.piece, t, *y[:3])[4 + which] for t, y in zip(instants, states, strict=True)]
            at = int(np.argmax(over))
            yield Episode(KINDS[which], begin, end, instants[at], limit + over[at], limit, unit)
    if mode.limited:
        yield Episode(KINDS[2], begin, end, begin, *(plant.max_current,) * 2, "A")
    if mode.held or mode.over:
        fastest = plant.shaft.speed * max(abs(y[1]) for y in states)
        kind = "speed limit" if mode.held else "too fast"
        yield Episode(kind, begin, end, begin, fastest, plant.shaft.speed * plant.max_rate, "rad/s")
    if mode.direction == 0:
        yield from _stuck(plant, stretch, instants, states, nothing)
    elif _driven(plant, stretch, (begin + end) / 2, nothing):
        yield Episode("driven back", begin, end, begin, math.nan, 0.0, "N m")


def _stuck(
    plant: Plant, stretch: Stretch, instants: list[float], states: list[list[float]], nothing: float
) -> Iterator[Episode]:
    """Told to move, but too weak to."""
    worst: tuple[float, float, float] | None = None
    for t, y in zip(instants, states, strict=True):
        torque = plant.torque_constant * feed(plant, stretch.piece, t, *y[:3]).current
        if abs(torque) <= max(nothing, 1e-12):
            continue
        needed = plant.shaft.breakaway(1 if torque > 0 else -1, stretch.piece.thrust(t, y[0]))
        if worst is None or abs(torque) - needed > worst[1] - worst[2]:
            worst = t, abs(torque), needed
    if worst is not None:
        yield Episode("stuck", stretch.begin, stretch.end, worst[0], worst[2], worst[1], "N m")


def _driven(plant: Plant, stretch: Stretch, t: float, nothing: float) -> bool:
    """The motor does not push, yet the load moves."""
    y = stretch.at(t).tolist()
    seen = observe(plant, stretch.piece, stretch.mode, t, (y[0], y[1], y[2]))
    pushing = stretch.mode.direction * plant.torque_constant * seen.current > nothing
    return (
        not pushing and stretch.mode.direction * seen.thrust < 0 and stretch.mode.direction * stretch.piece.thrust(t, y[0]) < 0
    )
