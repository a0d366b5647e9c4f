"""Beams in space that nothing keeps from spinning about their own axis.

A straight member of elastic beams between ball joints turns freely about its axis. Where nothing drives or loads this, the
motion of all else does not depend on it, and a coupling holds it, whose force is 0: with a the axis of the member at the start
and e a fixed direction across it, Y = e x a turns with a frame of the member, and

    Y . e = 0,

linear in the nodes of the frame. Its gradient vanishes only where the member points along e. A structure that is nearly flat
moves in its plane, and others rather about z: so e is the normal of the plane, or z, for members across it, else e is level.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import few
from kinetruss.model.beams.framing import SHAPE, Axes, Hinge, frame_of, frames, hinges, sound_beams
from kinetruss.model.motion.drives import CoordinateDrive, Coupling
from kinetruss.model.parts.body_loads import BodyCouple, BodyForce

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from kinetruss.model._data import ModelData

__all__ = ["SPIN", "Spin", "spin_note", "spins"]

SPIN = ".spin"
"""End of the name of the coupling that holds a beam, after the name of the beam."""
LINE = 1e-6
"""Nodes within this fraction of the length of a member from its axis lie on it, and directions with this sine are along it."""
FLAT = 0.2
"""Extent of a structure, over its largest one, below which it counts as flat."""
LEVEL = 0.3
"""Cosine of a member with the normal of the plane below which it lies in the plane."""


@dataclass(frozen=True)
class Spin:
    """A member that spins freely: its beams, unit axis (3,), and the frame that is held."""

    beams: tuple[str, ...]
    axis: tuple[float, ...]
    frame: Axes

    @property
    def coupling(self) -> str:
        """The name of the coupling that holds it."""
        return f"{self.beams[0]}{SPIN}"

    def held(self, model: ModelData) -> Coupling:
        """Y . e = 0 of the frame, e fixed."""
        a = np.array(self.axis)
        e = _across(model, a)
        y = np.cross(e, a)
        terms = []
        for i, director in enumerate(self.frame.nodes):
            # the frame has its axes along x, y, z at the start
            for c, axis in enumerate("xyz"):
                if abs(factor := float(y[i] * e[c])) > LINE:
                    terms.append((CoordinateDrive(node=director, axis=axis), factor))
                    terms.append((CoordinateDrive(node=self.frame.origin, axis=axis), -factor))
        return Coupling(terms=tuple(_joined(terms)), value=0.0, beam=self.beams[0])


def spin_note(model: ModelData) -> str:
    """The sentence on members that are held; empty without any."""
    found = spins(model)
    if not found:
        return ""
    names = few([" and ".join(one.beams) if len(one.beams) < 3 else f"{one.beams[0]} to {one.beams[-1]}" for one in found], 6)
    return f"Free to spin about the own axis, which nothing drives or loads, and held: {names}."


def spins(model: ModelData) -> list[Spin]:
    """The members of elastic beams that spin freely, with nothing that drives or loads this, in the order of their frames."""
    if model.dim != 3 or not any(beam.kind == "elastic" and (beam.release or beam.hinges) for beam in model.beams.values()):
        return []
    turning, found, done = _Turning(model), list[Spin](), set[str]()
    for frame in turning.every:
        if frame in done:
            continue
        axis, within = turning.spinning(frame)
        done |= within
        if axis is None:
            continue
        names = turning.beams_of(within)
        elastic = any(model.beams[name].kind == "elastic" for name in names)
        held = any(one in model.clamped for one in within) or not turning.free_nodes(within)
        if elastic and not held and not any(_loads(model, one, turning.every, axis) for one in within):
            found.append(Spin(tuple(names), tuple(axis.tolist()), turning.every[frame]))
    return found


class _Turning:
    """Which frames turn together: beams between them, hinges at them, and the nodes to which something of the user refers."""

    def __init__(self, model: ModelData) -> None:
        self.model, self.every = model, frames(model)
        self.place = {name: k for k, name in enumerate(model.beams)}
        self.beams: dict[str, list[str]] = {frame: [] for frame in self.every}
        self.pins: dict[str, list[Hinge]] = {frame: [] for frame in self.every}
        self.together: dict[str, set[str]] = {frame: {frame} for frame in self.every}
        """Frame -> frames that beams hold together with it, hinges left out; one set for all of them."""
        for name, beam in sound_beams(model):
            ends = [end for end in (frame_of(name, beam, end) for end in beam.ends) if end in self.every]
            for end in ends:
                self.beams[end].append(name)
            if len(ends) == 2 and self.together[ends[0]] is not self.together[ends[1]]:
                small, large = sorted((self.together[end] for end in ends), key=len)
                large |= small
                self.together.update(dict.fromkeys(small, large))
        for hinge in hinges(model):
            self.pins[hinge.own].append(hinge)
            self.pins[hinge.base].append(hinge)
        self.used = _used(model)

    def beams_of(self, within: Iterable[str]) -> list[str]:
        """The beams at some frames, in the order of the model."""
        return sorted({name for frame in within for name in self.beams[frame]}, key=self.place.__getitem__)

    def free_nodes(self, within: Iterable[str]) -> bool:
        """Whether nothing of the user refers to the nodes of these frames and of their hinges."""
        nodes = {node for frame in within for node in self.every[frame].nodes}
        return not self.used & (nodes | {hinge.node for frame in within for hinge in self.pins[frame]})

    def spinning(self, frame: str) -> tuple[NDArray[np.float64] | None, set[str]]:
        """The axis about which a frame spins, or None, and the frames that spin with it: a hinge lets go of a spin about its
        own axis only.
        """
        at, within = self.model.nodes, set(self.together[frame])
        while True:
            ends = [end for name in self.beams_of(within) for end in self.model.beams[name].ends]
            axis = _line([np.array(at[end].at) for end in ends]) if ends else None
            if axis is None:
                return None, self.together[frame]
            more = set(within)
            for hinge in (one for frame in within for one in self.pins[frame]):
                about = np.array(hinge.at) - np.array(at[hinge.base].at)
                if np.linalg.norm(np.cross(about, axis)) > LINE * np.linalg.norm(about):
                    more |= self.together[hinge.own] | self.together[hinge.base]
            if more == within:
                return axis, within
            within = more


def _line(points: list[NDArray[np.float64]]) -> NDArray[np.float64] | None:
    """Unit direction of the line on which the points lie, or None."""
    x = np.array(points)
    far = x[int(np.argmax(np.linalg.norm(x - x[0], axis=1)))] - x[0]
    length = float(np.linalg.norm(far))
    if not length:
        return None
    axis = far / length
    return axis if np.linalg.norm(np.cross(x - x[0], axis), axis=1).max() <= LINE * length else None


def _used(model: ModelData) -> set[str]:
    """The nodes to which bars, bodies, drives, couplings, springs and forces of the user refer: they may hold or turn them."""
    bars = [bar for name, bar in model.bars.items() if not bar.brace and name.partition(SHAPE)[0] not in model.beams]
    records = [*model.drives.values(), *(one for one in model.couplings.values() if one.beam is None), *model.springs.values()]
    return {
        *(end for bar in bars for end in bar.ends),
        *(node for body in model.bodies.values() for node in body.nodes),
        *(text for one in records for text in _texts(one.model_dump())),
        *(str(getattr(load, "node", "")) for load in model.loads.values()),
    }


def _texts(value: Any) -> Iterable[str]:
    """All texts in a nested structure."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for one in value.values():
            yield from _texts(one)
    elif isinstance(value, (list, tuple)):
        for one in value:
            yield from _texts(one)


def _loads(model: ModelData, frame: str, every: dict[str, Axes], axis: NDArray[np.float64]) -> bool:
    """Whether a load on this frame has a moment about the axis."""
    origin = np.array(model.nodes[every[frame].origin].at)
    for load in model.loads.values():
        if not isinstance(load, (BodyCouple, BodyForce)) or load.body != frame:
            continue
        if isinstance(load, BodyCouple):
            given = load.moments if load.moment is None else (load.moment,)
            arm = None
        else:
            given = load.forces if load.force is None else (load.force,)
            arm = np.zeros(3) if load.at is None else np.array(load.at) - origin
        for value in given or ():
            vector = np.array(value, float)
            if vector.shape != (3,) or (arm is not None and arm.shape != (3,)):
                return True  # a fault
            moment = vector if arm is None else np.cross(arm, vector)
            if abs(moment @ axis) > LINE * math.hypot(*vector):
                return True
    return False


def _across(model: ModelData, a: NDArray[np.float64]) -> NDArray[np.float64]:
    """The fixed direction e across the axis."""
    x = np.array([node.at for node in model.nodes.values() if not node.scalar and not node.director and len(node.at) == 3])
    extent = np.ptp(x, axis=0)
    flat = int(np.argmin(extent)) if extent.min() < FLAT * extent.max() else 2
    n = np.eye(3)[flat]
    e = n - (n @ a) * a if abs(n @ a) < LEVEL else np.cross(n, a)
    if np.linalg.norm(e) < LEVEL:  # along the normal
        e = np.eye(3)[(flat + 1) % 3] - a[(flat + 1) % 3] * a
    return np.asarray(e / np.linalg.norm(e))


def _joined(terms: list[tuple[CoordinateDrive, float]]) -> list[tuple[CoordinateDrive, float]]:
    """Terms of one coordinate as one."""
    found: dict[tuple[str, str], float] = {}
    for one, factor in terms:
        key = one.node, one.axis
        found[key] = found.get(key, 0.0) + factor
    return [(CoordinateDrive(node=node, axis=axis), factor) for (node, axis), factor in found.items() if factor]
