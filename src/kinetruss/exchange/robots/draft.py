"""The nodes of a model of a robot while it is made: shared places, axes, and the nodes between which angles are measured."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots.parts import SAME, Connection, Part
from kinetruss.exchange.robots.records import LeftOut, turn_about
from kinetruss.model import GROUND, Hinge, HingeDrive, Joint, LengthDrive

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["REACH", "Draft", "extent", "gyration", "hinged"]

REACH = 0.5
"""Distance of the two nodes of an axis, as a fraction of the size of the smaller body."""


@dataclass(eq=False)
class Draft:
    """Nodes by name and place (3,) m, those of each part, joints and drives, while the model is built.

    coordinates : of joints with a drive, a spring or a coupling. offsets : value of a coordinate minus that of its joint in the
        file, rad or m.
    """

    size: float
    places: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    own: dict[str, list[str]] = field(default_factory=dict)
    joints: dict[str, Joint] = field(default_factory=dict)
    coordinates: dict[str, HingeDrive | LengthDrive] = field(default_factory=dict)
    offsets: dict[str, float] = field(default_factory=dict)
    left: list[LeftOut] = field(default_factory=list)

    def share(self, name: str, place: Any, parts: Sequence[str]) -> str:
        """A node of several parts. The node of one of them at this place is the same point of it, so it is shared by all."""
        there = [node for part in parts for node in self.own[part] if self._at(node, place)]
        found = there[0] if there else name
        if not there:
            while found in self.places:
                found += "'"
            self.places[found] = np.array(place, float)
        for other in dict.fromkeys(node for node in there if node != found):
            self._merge(other, found)
        for part in parts:
            if found not in self.own[part]:
                self.own[part].append(found)
        return found

    def _at(self, node: str, place: Any) -> bool:
        return float(np.linalg.norm(self.places[node] - place)) <= SAME * self.size

    def _merge(self, old: str, new: str) -> None:
        """Call a node by the name of another at its place."""
        del self.places[old]
        for part, names in self.own.items():
            self.own[part] = list(dict.fromkeys(_other(names, old, new)))
        for name, joint in self.joints.items():
            hinges = tuple(Hinge(**_named(one, old, new)) for one in joint.hinges)
            self.joints[name] = joint.with_(nodes=_other(joint.nodes, old, new), hinges=hinges)
        for name, one in self.coordinates.items():
            if isinstance(one, HingeDrive):
                self.coordinates[name] = HingeDrive(**_named(one, old, new))


def _other(names: Sequence[str], old: str, new: str) -> tuple[str, ...]:
    return tuple(new if name == old else name for name in names)


def _named(one: Hinge | HingeDrive, old: str, new: str) -> dict[str, Any]:
    start, end = _other((one.start, one.end), old, new)
    return {"axis": _other(one.axis, old, new), "start": start, "end": end}


def gyration(part: Part) -> float:
    """Radius of gyration, m."""
    given = part.properties
    return 0.0 if given is None else math.sqrt(max(float(np.trace(given.inertia)), 0.0) / 2.0 / given.mass)


def extent(part: Part, size: float) -> float:
    """Extent of a part: of its places and its mass, m; of the whole robot for the ground."""
    if part.name == GROUND:
        return size
    places = [*part.joints, *part.points.values(), *([] if part.properties is None else [part.properties.center])]
    return max(float(np.linalg.norm(np.ptp(np.array(places), axis=0))) if places else 0.0, 2 * gyration(part)) or size


def hinged(draft: Draft, one: Connection, parts: Mapping[str, Part]) -> None:
    """Two shared nodes on the axis, and the nodes between which its angle is measured if anything acts on it."""
    reach = REACH * min(extent(parts[name], draft.size) for name in one.parts)
    ends = tuple(draft.share(f"{one.name}.{k}", one.place + far * one.axis, one.parts) for k, far in ((1, 0.0), (2, reach)))
    hinges: tuple[Hinge, ...] = ()
    if one.measured:
        angle = HingeDrive(axis=ends, **_measured(draft, one, reach))
        hinges = (Hinge(axis=ends, start=angle.start, end=angle.end),)
        draft.coordinates[one.name] = angle
        draft.offsets[one.name] = math.atan2(math.sin(one.value), math.cos(one.value)) - one.value  # within half a turn
    draft.joints[one.name] = Joint(kind="revolute", bodies=one.parts, nodes=ends, hinges=hinges)


def _measured(draft: Draft, one: Connection, reach: float) -> dict[str, str]:
    """Nodes at one distance from the axis, one in each body, at one place where the value of the joint is 0."""
    aside = np.eye(3)[int(np.argmin(np.abs(one.axis)))]
    aside = np.cross(one.axis, np.cross(aside, one.axis))
    aside *= reach / float(np.linalg.norm(aside))
    first, second = one.parts
    start = draft.share(f"{one.name}.zero", one.place + aside, (first,))
    turned = one.place + turn_about(one.axis, one.value) @ aside
    return {"start": start, "end": draft.share(f"{one.name}.turned", turned, (second,))}
