"""Springs, rotors and couplings of joints, and lengths between points, on the coordinates of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from kinetruss.exchange.robots.closing import frames_at_rest
from kinetruss.exchange.robots.draft import Draft, free
from kinetruss.exchange.robots.parts import Connection
from kinetruss.exchange.robots.records import LeftOut, Robot
from kinetruss.model import Bar, Body, Coupling, HingeDrive, LengthDrive, Spring

__all__ = ["Rotors", "couplings_of", "rotors_of", "spans_of", "springs_of"]

RADIUS = 0.05
"""Of the wheels of rotors, as a fraction of the size of the robot."""
GYRATION = 100.0
"""Radius of gyration of such a wheel over the size of the robot: its weight does not count, its inertia does."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Rotors:
    """Wheels on the ground, and the couplings that turn them. fixed : nodes that the ground holds."""

    fixed: list[str] = field(default_factory=list)
    bodies: dict[str, Body] = field(default_factory=dict)
    couplings: dict[str, Coupling] = field(default_factory=dict)


def springs_of(draft: Draft, connections: Sequence[Connection]) -> dict[str, Spring]:
    """Springs, dampers and friction of joints."""
    found = {}
    for one in connections:
        if one.sprung and one.name in draft.coordinates:
            stiffness, rest, damping, friction = one.spring
            found[f"{one.name}.spring"] = Spring(
                coordinate=draft.coordinates[one.name],
                stiffness=stiffness,
                rest=rest + draft.offsets[one.name],
                damping=damping,
                friction=friction,
            )
    return found


def couplings_of(draft: Draft, robot: Robot) -> dict[str, Coupling]:
    """Couplings of joints, at their values in the pose."""
    found = {}
    for each in robot.couplings:
        if lost := [name for name in each.factors if name not in draft.coordinates]:
            draft.left.append(LeftOut("coupling", each.where, f"joint {lost[0]!r} is not part of the model"))
            continue
        found[each.name] = Coupling(terms=tuple((draft.coordinates[name], factor) for name, factor in each.factors.items()))
    return found


def rotors_of(draft: Draft, connections: Sequence[Connection]) -> Rotors:
    """A wheel on the ground for each joint with `armature`, coupled to its angle one to one, or to its length; its nodes too.

    The wheel turns at the rate of the joint itself, so its energy is armature/2 times the square of this rate.
    """
    found = Rotors()
    for one in connections:
        if not one.armature or one.name not in draft.coordinates:
            continue
        name, axis, radius = free(f"{one.name}.rotor", draft.own), one.axis, RADIUS * draft.size
        side = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
        side /= np.linalg.norm(side)
        ahead = np.cross(axis, side)
        ways = {"1": 0.0 * axis, "2": axis, "3": side, "4": ahead, "zero": -ahead}
        *ends, zero = (draft.add(f"{name}.{key}", one.place + radius * way) for key, way in ways.items())
        found.fixed.extend([*ends[:2], zero])
        found.bodies[name] = Body(
            nodes=tuple(ends),
            carriers=(ends[0], *ends[2:]),
            mass=one.armature / (GYRATION * draft.size) ** 2,
            center=tuple(one.place.tolist()),
            inertia=(0.5 * one.armature * (np.eye(3) + np.outer(axis, axis))).tolist(),
        )
        turning = HingeDrive(axis=tuple(ends[:2]), start=zero, end=ends[2])
        found.couplings[name] = Coupling(terms=((turning, 1.0), (draft.coordinates[one.name], -1.0)))
    return found


def spans_of(robot: Robot, ends: Mapping[str, str]) -> tuple[dict[str, Bar], dict[str, Spring]]:
    """Driven bars and springs between points. ends : point -> node."""
    bars: dict[str, Bar] = {}
    springs: dict[str, Spring] = {}
    resting = {
        point: (frame @ np.append(place, 1.0))[:3]
        for link, frame in (frames_at_rest(robot) if robot.spans else {}).items()
        for point, place in robot.links[link].points.items()
    }
    for one in robot.spans:
        bars[one.name] = Bar(ends=(ends[one.points[0]], ends[one.points[1]]), kind="driven" if one.driven else "free", mass=0.0)
        if one.spring is not None:
            stiffness, rest, damping, friction = one.spring
            if rest is None:
                rest = float(np.linalg.norm(resting[one.points[1]] - resting[one.points[0]]))
            springs[f"{one.name}.spring"] = Spring(
                coordinate=LengthDrive(one.name), stiffness=stiffness, rest=rest, damping=damping, friction=friction
            )
    return bars, springs
