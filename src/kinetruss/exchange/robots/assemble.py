"""A model from a robot in its closed pose: rigid bodies with shared nodes.

Links that are fixed to each other become one body. A revolute joint is two shared nodes on its axis, a ball one shared node, a
slider the Sarrus linkage of `library.joints`. The drive of a revolute joint measures the value of the joint itself: two nodes
at the same distance from the axis, one in each body, are at one place where the value is 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from kinetruss.errors import Fault, ModelError
from kinetruss.exchange.robots.carried import body_of
from kinetruss.exchange.robots.closing import Posed
from kinetruss.exchange.robots.draft import Draft, ball, free, hinged, measured, slid
from kinetruss.exchange.robots.laws import couplings_of, rotors_of, spans_of, springs_of
from kinetruss.exchange.robots.parts import Connection, Part, parts_of, size_of
from kinetruss.exchange.robots.records import LeftOut
from kinetruss.model import GROUND, Gear, HingeDrive, LengthDrive, Model, Node

__all__ = ["Assembled", "assemble"]


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
