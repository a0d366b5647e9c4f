"""Rigid parts of a robot in its closed pose: links that are fixed to each other, and the joints between the parts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.exchange.robots.closing import Posed
from kinetruss.exchange.robots.records import LeftOut, Robot
from kinetruss.library.bodies import MassProperties, combined
from kinetruss.model import GROUND

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Connection", "Part", "SAME", "parts_of"]

ROUND = 1e-6
"""Differences of axes, places and moments, relative to their size, that count as round-off of a file."""
SAME = 1e-9
"""Distance of places that are one, as a multiple of the size of the robot."""


@dataclass(eq=False)
class Part:
    """A rigid part: mass properties in global axes, named places (3,) m, places of its joints, its place in the file."""

    name: str
    where: str
    properties: MassProperties | None = None
    points: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    joints: list[NDArray[np.float64]] = field(default_factory=list)
    balls_only: bool = True


@dataclass(frozen=True, kw_only=True, eq=False)
class Connection:
    """A joint between two parts in the pose: place (3,) m, unit axis, value in that pose; rad or m."""

    name: str
    kind: Literal["revolute", "prismatic", "ball"]
    parts: tuple[str, str]
    place: NDArray[np.float64]
    axis: NDArray[np.float64]
    value: float = 0.0
    drive: str | None = None
    ratio: float | None = None
    limits: tuple[float, float] | None = None
    spring: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    armature: float = 0.0
    coupled: bool = False
    where: str = ""

    @property
    def measured(self) -> bool:
        """True if a drive, a spring, the inertia of a rotor or a coupling acts on its value."""
        return self.drive is not None or self.coupled or self.sprung or bool(self.armature)

    @property
    def sprung(self) -> bool:
        """True if it has stiffness, damping or friction."""
        return bool(self.spring[0] or self.spring[2] or self.spring[3])


def parts_of(posed: Posed) -> tuple[dict[str, Part], list[Connection], list[LeftOut]]:
    """The parts by name (``ground`` holds the root), the joints between them, and what was left out."""
    left: list[LeftOut] = []
    group = _groups(posed.robot)
    parts: dict[str, Part] = {}
    for link in posed.robot.links.values():
        name = group[link.name]
        part = parts.setdefault(name, Part(name, link.where))
        frame = posed.frames[link.name]
        if link.properties is not None:
            own = link.properties.moved(frame[:3, 3], _orthonormal(frame[:3, :3]).T)
            part.properties = own if part.properties is None else combined(part.properties, own)
            if name == GROUND:
                left.append(LeftOut("mass", link.where, f"{own.mass:.6g} kg rest on the ground"))
        elif link.name not in (name, posed.robot.root) and not _closes(posed.robot, link.name):
            part.points[link.name] = frame[:3, 3]  # a frame of interest, e.g. of a tool
        for point, place in link.points.items():
            part.points[point] = (frame @ np.append(place, 1.0))[:3]
    parts.setdefault(GROUND, Part(GROUND, ""))
    connections = [*_joints(posed, group, left), *_balls(posed, group, left)]
    connections = _without_spins(parts, _without_idle(parts, connections, left), left)
    for one in connections:
        for name in one.parts:
            parts[name].joints.append(one.place)
            parts[name].balls_only &= one.kind == "ball"
    size = float(np.ptp(np.array([one.place for one in connections]), axis=0).max()) if connections else 1.0
    return parts, _anchored(parts, connections, size or 1.0), left


def _orthonormal(R: Any) -> NDArray[np.float64]:
    """The nearest rotation: products of many rotations gather round-off."""
    u, _, v = np.linalg.svd(R)
    return np.asarray(u @ v)


def _closes(robot: Robot, link: str) -> bool:
    return any(link in one.links for one in robot.closures)


def _groups(robot: Robot) -> dict[str, str]:
    """Link -> name of its part, that of the link nearest to the root; ``ground`` for what the root holds."""
    order = [robot.root, *(pivot.child for pivot in robot.pivots)]
    head = {name: name for name in order}

    def find(name: str) -> str:
        while head[name] != name:
            name = head[name]
        return name

    pairs = [(one.parent, one.child) for one in robot.pivots if one.kind == "weld"]
    pairs += [one.links for one in robot.closures if one.kind == "weld"]
    for first, second in pairs:
        low, high = sorted((find(first), find(second)), key=order.index)
        head[high] = low
    return {name: GROUND if find(name) == robot.root else find(name) for name in order}


def _joints(posed: Posed, group: Mapping[str, str], left: list[LeftOut]) -> list[Connection]:
    found = []
    coupled = {name for one in posed.robot.couplings for name in one.factors}
    for pivot in posed.robot.pivots:
        parts = group[pivot.parent], group[pivot.child]
        if pivot.kind == "weld" or pivot.kind == "free":
            continue
        if parts[0] == parts[1]:
            left.append(LeftOut("joint", pivot.where, "its two links are fixed to each other by closures: it cannot move"))
            continue
        frame = posed.frames[pivot.parent] @ pivot.origin
        value = posed.values.get(pivot.name, 0.0)
        axis = frame[:3, :3] @ pivot.axis
        place = frame[:3, 3] + (value * axis if pivot.kind == "prismatic" else 0.0)
        found.append(
            Connection(
                name=pivot.name, kind=pivot.kind, parts=parts, place=place, axis=axis / np.linalg.norm(axis), value=value,
                drive=pivot.drive, ratio=pivot.ratio, limits=pivot.limits, spring=pivot.spring, armature=pivot.armature,
                coupled=pivot.name in coupled, where=pivot.where,
            )
        )  # fmt: skip
    return found


def _balls(posed: Posed, group: Mapping[str, str], left: list[LeftOut]) -> list[Connection]:
    found = []
    for one in posed.robot.closures:
        parts = group[one.links[0]], group[one.links[1]]
        if one.kind != "ball":
            continue
        if parts[0] == parts[1]:
            left.append(LeftOut("closure", one.where, "its two links are fixed to each other already"))
            continue
        first, second = one.frames
        ends = [posed.frames[one.links[0]] @ first, posed.frames[one.links[1]] @ (first if second is None else second)]
        place = 0.5 * (ends[0][:3, 3] + ends[1][:3, 3])
        found.append(Connection(name=one.name, kind="ball", parts=parts, place=place, axis=np.eye(3)[2], where=one.where))
    return found


def _without_idle(parts: dict[str, Part], connections: list[Connection], left: list[LeftOut]) -> list[Connection]:
    """Parts without mass at the end of a chain carry nothing: their named places stay in no body, so they are left out."""
    while True:
        count = {name: [one for one in connections if name in one.parts] for name in parts}
        idle = [
            name
            for name, part in parts.items()
            if name != GROUND and part.properties is None and len(count[name]) <= 1 and not part.points
        ]
        if not idle:
            return connections
        for name in idle:
            left.append(
                LeftOut("link", parts[name].where, "has no mass, and nothing is attached to it; left out with its joint")
            )
            connections = [one for one in connections if name not in one.parts]
            del parts[name]


def _without_spins(parts: dict[str, Part], connections: list[Connection], left: list[LeftOut]) -> list[Connection]:
    """Parts alike all round an axis, between two undriven hinges on it, spin freely and move nothing else by it.

    Each joins a neighbour, without its moment about the axis: CAD programs put such spheres and pins where loops close.
    """
    for name in list(parts):
        own = [one for one in connections if name in one.parts]
        if name == GROUND or len(own) != 2 or parts[name].points or not _spins(parts[name], *own):
            continue
        beside = [next(iter(set(one.parts) - {name})) for one in own]
        if beside[0] == beside[1]:
            continue
        gone, stays = own if beside[0] != GROUND else own[::-1]
        onto = next(iter(set(gone.parts) - {name}))
        if (given := parts.pop(name).properties) is not None:
            n = stays.axis
            rest = replace(given, inertia=given.inertia - (n @ given.inertia @ n) * np.outer(n, n))
            old = parts[onto].properties
            parts[onto].properties = rest if old is None else combined(old, rest)
        left.append(
            LeftOut("spin", gone.where, f"link {name!r} turns freely about the one axis of its two joints; it does not here")
        )
        pair = (onto, stays.parts[1]) if stays.parts[0] == name else (stays.parts[0], onto)
        connections = [replace(one, parts=pair) if one is stays else one for one in connections if one is not gone]
    return connections


def _spins(part: Part, one: Connection, two: Connection) -> bool:
    """True for two hinges without drive on one axis, about which the mass of the part is alike all round."""
    if any(joint.kind != "revolute" or joint.measured for joint in (one, two)):
        return False
    n, given = one.axis, part.properties
    places = [two.place, *([] if given is None else [given.center])]
    size = max(float(np.linalg.norm(two.place - one.place)), 1e-3)
    off = [float(np.linalg.norm(np.cross(place - one.place, n))) for place in places]
    if float(np.linalg.norm(np.cross(n, two.axis))) > ROUND or max(off) > ROUND * size:
        return False
    if given is None:
        return True
    across = np.eye(3) - np.outer(n, n)
    moment = 0.5 * float(np.trace(across @ given.inertia))
    uneven = given.inertia - moment * across - (n @ given.inertia @ n) * np.outer(n, n)
    return float(np.abs(uneven).max()) <= ROUND * float(np.trace(given.inertia))


def _anchored(parts: Mapping[str, Part], connections: Sequence[Connection], size: float) -> list[Connection]:
    """Axes that meet in a part without mass get their first node where they meet: it is a triangle, Hooke's cross."""
    found = {one.name: one for one in connections}
    moved: set[str] = set()
    for part in parts.values():
        own = [found[one.name] for one in connections if part.name in one.parts and one.kind == "revolute"]
        if part.name == GROUND or part.properties is not None:
            continue
        for one, two in combinations(own, 2):
            if (place := _meeting(one, two, size)) is not None:
                for each in (one, two):
                    if each.name not in moved:
                        found[each.name] = replace(found[each.name], place=place)
                        moved.add(each.name)
    return list(found.values())


def _meeting(one: Connection, two: Connection, size: float) -> NDArray[np.float64] | None:
    """The point where two axes meet, m; None for skew or parallel ones."""
    normal = np.cross(one.axis, two.axis)
    square = float(normal @ normal)
    way = two.place - one.place
    if square < 1e-6 or abs(float(way @ normal)) > SAME * size * np.sqrt(square):
        return None
    return np.asarray(one.place + float(np.cross(way, two.axis) @ normal) / square * one.axis)
