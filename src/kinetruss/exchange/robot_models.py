"""A model from a robot in its closed pose: the body of each rigid part, its nodes, sliders, laws of joints."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.exchange.closing import Posed, frames_at_rest
from kinetruss.exchange.robot_nodes import Draft, ball, body_of, free, hinged, measured, slid
from kinetruss.exchange.robot_parts import Connection, Part, parts_of, size_of
from kinetruss.exchange.robots import Closure, DrivenLength, LeftOut, Link, Pivot, Robot, RobotOfModel, placement
from kinetruss.model import GROUND, Bar, Body, Coupling, Gear, HingeDrive, LengthDrive, Model, Node, Spring


def with_sliders(drawn: RobotOfModel, lengths: Sequence[DrivenLength]) -> RobotOfModel:
    """The robot with some driven lengths as sliders: a cardan joint at the first end, a closure of the other end."""
    robot = drawn.robot
    links, pivots, closures = dict(robot.links), list(robot.pivots), list(robot.closures)
    for driven in lengths:
        start, end = driven.points
        line = (end - start) / np.linalg.norm(end - start)
        one = np.cross(line, np.eye(3)[int(np.argmin(np.abs(line)))])
        one /= np.linalg.norm(one)
        cross, low, high = (f"{driven.name}.{word}" for word in ("cross", "low", "high"))
        base, tube = driven.properties or (None, None)
        links |= {cross: Link(name=cross), low: Link(name=low, properties=base), high: Link(name=high, properties=tube)}
        ends: dict[str, Any] = {"origin": placement(None, start), "after": placement(None, -start)}
        pivots += [
            Pivot(name=f"{driven.name}.1", kind="revolute", parent=driven.links[0], child=cross, axis=one, **ends),
            Pivot(name=f"{driven.name}.2", kind="revolute", parent=cross, child=low, axis=np.cross(line, one), **ends),
            Pivot(name=driven.name, kind="prismatic", parent=low, child=high, axis=line, drive=driven.name, **ends),
        ]
        place = placement(None, end)
        closures.append(Closure(name=f"{driven.name}.tip", kind="ball", links=(high, driven.links[1]), frames=(place, place)))
    left = [one for one in drawn.lengths if one not in lengths]
    return replace(drawn, robot=replace(robot, links=links, pivots=pivots, closures=closures), lengths=left)


# Springs, rotors and couplings of joints, and lengths between points, on the coordinates of a model.

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


# A model from a robot in its closed pose: rigid bodies with shared nodes.
#
# Links that are fixed to each other become one body. A revolute joint is two shared nodes on its axis, a ball one shared
# node, a slider the Sarrus linkage of `library.joints`. The drive of a revolute joint measures the value of the joint itself:
# two nodes at the same distance from the axis, one in each body, are at one place where the value is 0.


@dataclass(frozen=True, kw_only=True, eq=False)
class Assembled:
    """The model; offsets : value of a drive minus that of its joint in the file, rad or m; what was left out and assumed."""

    model: Model
    offsets: Mapping[str, float]
    left_out: Sequence[LeftOut]
    notes: Sequence[str] = ()


def assemble(posed: Posed, progress: Callable[[int, int], None] | None = None) -> Assembled:
    """The model of a robot in its closed pose. progress : called with (bodies done, all bodies).

    Raises
    ------
    ModelError : bodies that are impossible, with the place of the link in the file.
    """
    parts, connections, left = parts_of(posed)
    draft = Draft(size=size_of(parts, connections), own={name: [] for name in parts}, left=left)
    points = {name: (part.name, place) for part in parts.values() for name, place in part.points.items()}
    ends = _joined(draft, parts, connections, {point for one in posed.robot.spans for point in one.points}, points)
    bodies = {}
    for done, part in enumerate(parts.values()):
        if progress is not None:
            progress(done, len(parts))
        if part.name != GROUND and (body := body_of(draft, part)) is not None:
            bodies[part.name] = body
    ground = draft.own[GROUND] or ([] if draft.places else [draft.add("origin", (0.0, 0.0, 0.0))])
    for name, joint in list(draft.joints.items()):
        if any(body not in bodies and body != GROUND for body in joint.bodies):
            del draft.joints[name]  # a point with mass, which has no direction
        else:
            measured(draft, name)
    rotors = rotors_of(draft, connections)
    bars, springs = spans_of(posed.robot, ends)
    couplings = couplings_of(draft, posed.robot) | rotors.couplings
    drives = _drives(draft, connections)
    taken = {*draft.bars, *bars, *drives}
    try:
        model = Model(
            title=posed.robot.title,
            nodes={
                name: Node(at=place, mass=draft.masses.get(name, 0.0), coincident=True) for name, place in draft.places.items()
            },
            fixed=dict.fromkeys(ground, "xyz") | dict.fromkeys(rotors.fixed, "xyz"),
            gravity=posed.robot.gravity,
            bars=draft.bars | bars,
            bodies=bodies | rotors.bodies,
            joints=draft.joints,
            drives=drives,
            couplings={free(name, taken): one for name, one in couplings.items()},
            springs=springs_of(draft, connections) | springs,
        )
    except ModelError as error:
        raise ModelError([_placed(one, parts) for one in error.faults]) from None
    if progress is not None:
        progress(len(parts), len(parts))
    offsets = {one.drive: draft.offsets[one.name] for one in connections if one.drive is not None}
    return Assembled(model=model, offsets=offsets, left_out=draft.left, notes=draft.notes)


def _joined(
    draft: Draft, parts: Mapping[str, Part], connections: Sequence[Connection], ends: set[str], points: Mapping[str, Any]
) -> dict[str, str]:
    """The nodes of all joints and named places; those whose place is given first. The nodes of some points are returned."""
    for one in connections:
        if one.kind == "ball":
            ball(draft, one)
    for name, (part, place) in points.items():
        draft.share(name, place, (part,))
    for one in connections:
        if one.kind == "prismatic":
            slid(draft, one, parts)
    for one in connections:
        if one.kind == "revolute":
            hinged(draft, one, parts)
    return {name: draft.share(name, points[name][1], points[name][:1]) for name in ends}


def _drives(draft: Draft, connections: Sequence[Connection]) -> dict[str, HingeDrive | LengthDrive]:
    """The drives of hinges, with the gears before them."""
    found = {one.drive: (one, draft.coordinates[one.name]) for one in connections if one.kind == "revolute" and one.drive}
    return {
        name: angle if one.ratio is None else angle.with_(gear=Gear(ratio=one.ratio)) for name, (one, angle) in found.items()
    }


def _placed(fault: Fault, parts: Mapping[str, Part]) -> Fault:
    """A fault of a body with the place of its link in the file."""
    part = parts.get(str(fault.path[1])) if fault.path[:1] in (("bodies",), ("Model",)) and len(fault.path) > 1 else None
    if part is None:
        return fault
    return Fault((), f"{part.where}: {fault}", "Correct the masses and inertias of this link.")
