"""Rigid parts of a robot in its closed pose: links that are fixed to each other, and the joints between the parts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.exchange.closing import Posed
from kinetruss.exchange.robots import LeftOut, Robot
from kinetruss.library.bodies import MassProperties, combined
from kinetruss.model import GROUND

if TYPE_CHECKING:
    from numpy.typing import NDArray


ROUND = 1e-6
"""Differences of axes, places and moments, relative to their size, that count as round-off of a file."""
SAME = 1e-9
"""Distance of places that are one, as a multiple of the size of the robot."""
NOTHING = 1e-14
"""A moment of inertia below this fraction of mass times squared size of the robot is below the round-off of the mass matrix."""
WEIGHTLESS = 1e-12
"""Mass of a link that has inertia without mass, as a fraction of that of the whole robot."""


@dataclass(eq=False)
class Part:
    """A rigid part: mass properties in global axes, named places (3,) m, places of its joints, its place in the file."""

    name: str
    where: str
    properties: MassProperties | None = None
    points: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    joints: list[NDArray[np.float64]] = field(default_factory=list)
    balls_only: bool = True

    def add(self, more: MassProperties | None) -> None:
        """Add mass properties in global axes."""
        if more is not None:
            self.properties = more if self.properties is None else combined(self.properties, more)


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
    closing = {link for one in posed.robot.closures for link in one.links}
    least = WEIGHTLESS * (sum(one.properties.mass for one in posed.robot.links.values() if one.properties) or 1.0)
    parts: dict[str, Part] = {}
    for link in posed.robot.links.values():
        name = group[link.name]
        part = parts.setdefault(name, Part(name, link.where))
        frame = posed.frames[link.name]
        if link.properties is not None:
            own = link.properties.moved(frame[:3, 3], _orthonormal(frame[:3, :3]).T)
            if not own.mass:
                own = replace(own, mass=least)
                left.append(LeftOut("mass", link.where, f"is 0 beside an inertia: the link has {least:.2g} kg here"))
            if part.properties is None:
                part.where = link.where
            part.add(own)
            if name == GROUND:
                left.append(LeftOut("mass", link.where, f"{own.mass:.6g} kg rest on the ground"))
        elif link.name not in (name, posed.robot.root) and link.name not in closing:
            part.points[link.name] = frame[:3, 3]  # a frame of interest, e.g. of a tool
        for point, place in link.points.items():
            part.points[point] = (frame @ np.append(place, 1.0))[:3]
    parts.setdefault(GROUND, Part(GROUND, ""))
    joints = _joints(posed, group, left)
    net = _Net(parts, [*joints, *_balls(posed, group, {one.name for one in joints}, left)])
    size = size_of(parts, list(net.connections.values()))
    net.without_idle(size, left)
    net.without_spins(left)
    connections = list(net.connections.values())
    for one in connections:
        for name in one.parts:
            parts[name].joints.append(one.place)
            parts[name].balls_only &= one.kind == "ball"
    return parts, net.anchored(size), left


def size_of(parts: Mapping[str, Part], connections: Sequence[Connection]) -> float:
    """Largest extent of all places of the robot, m."""
    places = [one.place for one in connections] + [place for part in parts.values() for place in part.points.values()]
    places += [part.properties.center for part in parts.values() if part.properties is not None]
    spread = float(np.ptp(np.array(places), axis=0).max()) if len(places) > 1 else 0.0
    return spread or max((gyration(part.properties) for part in parts.values() if part.properties), default=0.0) or 1.0


def gyration(given: MassProperties) -> float:
    """Radius of gyration, m."""
    return math.sqrt(max(float(np.trace(given.inertia)), 0.0) / 2.0 / given.mass)


def _orthonormal(R: Any) -> NDArray[np.float64]:
    """The nearest rotation: products of many rotations gather round-off."""
    u, _, v = np.linalg.svd(R)
    return np.asarray(u @ v)


def _groups(robot: Robot) -> dict[str, str]:
    """Link -> name of its part, that of the link nearest to the root; ``ground`` for what the root holds."""
    order = {name: k for k, name in enumerate([robot.root, *(pivot.child for pivot in robot.pivots)])}
    head = {name: name for name in order}

    def find(name: str) -> str:
        while head[name] != name:
            head[name] = head[head[name]]
            name = head[name]
        return name

    pairs = [(one.parent, one.child) for one in robot.pivots if one.kind == "weld"]
    pairs += [one.links for one in robot.closures if one.kind == "weld"]
    for first, second in pairs:
        low, high = sorted((find(first), find(second)), key=order.__getitem__)
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


def _balls(posed: Posed, group: Mapping[str, str], taken: set[str], left: list[LeftOut]) -> list[Connection]:
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
        name = one.name
        while name in taken:
            name += "'"
        taken.add(name)
        found.append(Connection(name=name, kind="ball", parts=parts, place=place, axis=np.eye(3)[2], where=one.where))
    return found


class _Net:
    """The joints by name, and the names of those of each part."""

    def __init__(self, parts: dict[str, Part], connections: Sequence[Connection]) -> None:
        self.parts = parts
        self.connections = {one.name: one for one in connections}
        self.of: dict[str, list[str]] = {name: [] for name in parts}
        for one in connections:
            for name in one.parts:
                self.of[name].append(one.name)

    def _drop(self, name: str) -> Connection:
        gone = self.connections.pop(name)
        for part in gone.parts:
            self.of[part].remove(name)
        return gone

    def without_idle(self, size: float, left: list[LeftOut]) -> None:
        """Parts at the end of a chain that turn or slide without inertia, and without anything that acts on them.

        Their accelerations are not defined and nothing depends on them: one without places goes, another joins its neighbour.
        """
        look = list(self.parts)
        while look:
            name = look.pop()
            part = self.parts.get(name)
            if part is None or name == GROUND or len(self.of[name]) > 1:
                continue
            if not self.of[name]:
                if part.properties is None and not part.points:
                    del self.parts[name]
                continue
            joint = self.connections[self.of[name][0]]
            if joint.measured or not _idle(part, joint, size):
                continue
            self._drop(joint.name)
            other = self.parts[_across(joint, name)]
            look.append(other.name)
            del self.parts[name]
            if part.properties is None and not part.points:
                text = "has no mass, and nothing is attached to it; left out with its joint"
                left.append(LeftOut("link", part.where, text))
                continue
            left.append(LeftOut("joint", joint.where, "moves no inertia, and nothing acts on it: it is fixed here"))
            other.points |= part.points
            other.add(part.properties)

    def without_spins(self, left: list[LeftOut]) -> None:
        """Parts alike all round an axis, between two undriven hinges on it, spin freely and move nothing else by it.

        Each joins a neighbour, without its moment about the axis: CAD programs put such spheres and pins where loops close.
        """
        for name, part in list(self.parts.items()):
            own = [self.connections[key] for key in self.of[name]]
            if name == GROUND or len(own) != 2 or part.points or not _spins(part, *own):
                continue
            beside = [_across(one, name) for one in own]
            if beside[0] == beside[1]:
                continue
            gone, stays = own if beside[0] != GROUND else own[::-1]
            onto = _across(gone, name)
            if (given := part.properties) is not None:
                n = stays.axis
                self.parts[onto].add(replace(given, inertia=given.inertia - (n @ given.inertia @ n) * np.outer(n, n)))
            text = f"link {name!r} turns freely about the one axis of its two joints; it does not here"
            left.append(LeftOut("spin", gone.where, text))
            self._drop(gone.name)
            pair = (onto, stays.parts[1]) if stays.parts[0] == name else (stays.parts[0], onto)
            self.connections[stays.name] = replace(stays, parts=pair)
            self.of[onto].append(stays.name)
            del self.parts[name]

    def anchored(self, size: float) -> list[Connection]:
        """Axes that meet in a part without mass get their first node where they meet: it is a triangle, Hooke's cross."""
        moved: set[str] = set()
        for part in self.parts.values():
            if part.name == GROUND or part.properties is not None:
                continue
            own = [key for key in self.of[part.name] if self.connections[key].kind == "revolute"]
            for one, two in combinations(own, 2):
                if (place := _meeting(self.connections[one], self.connections[two], size)) is not None:
                    for key in {one, two} - moved:
                        self.connections[key] = replace(self.connections[key], place=place)
                        moved.add(key)
        return list(self.connections.values())


def _across(joint: Connection, part: str) -> str:
    """The other part of a joint."""
    return joint.parts[1] if joint.parts[0] == part else joint.parts[0]


def _idle(part: Part, joint: Connection, size: float) -> bool:
    """True if a joint at the end of a chain moves no mass, and no inertia about its axis or its centre."""
    if (given := part.properties) is None:
        return True
    if joint.kind == "prismatic":
        return False
    arm = given.center - joint.place
    moments = given.inertia + given.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    moment = joint.axis @ moments @ joint.axis if joint.kind == "revolute" else float(np.trace(moments))
    return bool(moment <= NOTHING * given.mass * size**2)


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


def _meeting(one: Connection, two: Connection, size: float) -> NDArray[np.float64] | None:
    """The point where two axes meet, m; None for skew or parallel ones."""
    normal = np.cross(one.axis, two.axis)
    square = float(normal @ normal)
    way = two.place - one.place
    if square < 1e-6 or abs(float(way @ normal)) > SAME * size * np.sqrt(square):
        return None
    return np.asarray(one.place + float(np.cross(way, two.axis) @ normal) / square * one.axis)
