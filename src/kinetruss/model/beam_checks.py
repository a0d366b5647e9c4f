"""Cross-checks of beams: ends, matter, directions, releases; beams that nothing keeps from spinning.

A straight member of elastic beams between ball joints turns freely about its axis. Where nothing drives or loads this, the
motion of all else does not depend on it, and a coupling holds it, whose force is 0: with a the axis of the member at the start
and e a fixed direction across it, Y = e x a turns with a frame of the member, and

    Y . e = 0,

linear in the nodes of the frame. Its gradient vanishes only where the member points along e. A structure that is nearly flat
moves in its plane, and others rather about z: so e is the normal of the plane, or z, for members across it, else e is level.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, few
from kinetruss.model.beam_frames import Axes, Hinge, frame_of, owner_of, sound_beams
from kinetruss.model.common_faults import components
from kinetruss.model.drives import CoordinateDrive, Coupling
from kinetruss.model.inner import Owner
from kinetruss.model.joints import GROUND
from kinetruss.model.links import Piece
from kinetruss.model.loads import BodyCouple, BodyForce
from kinetruss.model.members import Brace, Node

if TYPE_CHECKING:
    from collections.abc import Container, Iterable

    from numpy.typing import NDArray

    from kinetruss.model.beams import Beam
    from kinetruss.model.data import ModelData
    from kinetruss.model.whole import WholeModel


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

    def held(self, model: ModelData, inner: Container[str]) -> Coupling:
        """Y . e = 0 of the frame, e fixed. inner : nodes that do not count for the extent of the structure."""
        a = np.array(self.axis)
        e = _across([node for name, node in model.nodes.items() if name not in inner], a)
        y = np.cross(e, a)
        terms = []
        for i, director in enumerate(self.frame.nodes):
            # the frame has its axes along x, y, z at the start
            for c, axis in enumerate("xyz"):
                if abs(factor := float(y[i] * e[c])) > LINE:
                    terms.append((CoordinateDrive(node=director, axis=axis), factor))
                    terms.append((CoordinateDrive(node=self.frame.origin, axis=axis), -factor))
        return Coupling(terms=tuple(_joined(terms)), value=0.0)


def add_spins(whole: WholeModel) -> None:
    """Add the couplings that hold spinning members."""
    inner = whole.inner
    frames = {name for name, owner in inner.nodes.items() if owner.table != "hubs"}
    for one in _spins(whole):
        inner.spins.append(one)
        whole.couplings[one.coupling] = one.held(whole, frames)
        inner.couplings[one.coupling] = owner_of(one.beams[0], whole.beams[one.beams[0]])


def spin_note(whole: WholeModel) -> str:
    """The sentence on members that are held; empty without any."""
    found = whole.inner.spins
    if not found:
        return ""
    owned = [list(dict.fromkeys(owner_of(name, whole.beams[name]).name for name in one.beams)) for one in found]
    names = few([" and ".join(own) if len(own) < 3 else f"{own[0]} to {own[-1]}" for own in owned], 6)
    return f"Free to spin about the own axis, which nothing drives or loads, and held: {names}."


def _spins(model: WholeModel) -> list[Spin]:
    """The members of elastic beams that spin freely, with nothing that drives or loads this, in the order of their frames."""
    if model.dim != 3 or not any(_spins_alone(beam) and (beam.release or beam.hinges) for beam in model.beams.values()):
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
        elastic = any(_spins_alone(model.beams[name]) for name in names)
        held = any(one in model.clamped for one in within) or not turning.free_nodes(within)
        if elastic and not held and not any(_loads(model, one, turning.every, axis) for one in within):
            found.append(Spin(tuple(names), tuple(axis.tolist()), turning.every[frame]))
    return found


def _spins_alone(beam: Beam) -> bool:
    """Whether the rotation of a beam about its own axis is one of the structure: its ends have frames."""
    return beam.kind == "elastic" or isinstance(beam, Piece)


class _Turning:
    """Which frames turn together: beams between them, hinges at them, and the nodes to which something of the user refers."""

    def __init__(self, model: WholeModel) -> None:
        self.model, self.every = model, model.inner.frames
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
        for hinge in model.inner.hinges:
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


def _used(model: WholeModel) -> set[str]:
    """The nodes to which bars, bodies, drives, couplings, springs and forces of the user refer: they may hold or turn them."""
    bars = [bar for bar in model.bars.values() if not isinstance(bar, Brace)]
    rotations = {name for name, owner in model.inner.couplings.items() if owner.table in ("beams", "links")}
    couplings = (one for name, one in model.couplings.items() if name not in rotations)
    records = [*model.drives.values(), *couplings, *(one for _, one in model.force_elements.values())]
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


def _across(nodes: Iterable[Node], a: NDArray[np.float64]) -> NDArray[np.float64]:
    """The fixed direction e across the axis."""
    x = np.array([node.at for node in nodes if not node.scalar and len(node.at) == 3])
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


# Cross-checks of beams: ends, matter, directions, releases, rotations, clamps.

ON_HUB = Owner("hubs", "")
ALONG = 1e-6
"""Sine of the angle between a beam and its orientation below which these are parallel."""
Path = tuple[Any, ...]


def beam_faults(model: WholeModel, dim: int) -> Iterator[Fault]:
    """Faults of all beams and clamps of a model with `dim` axes."""
    held = {name for one in model.inner.spins for name in one.beams}
    for name, beam in model.beams.items():
        if isinstance(beam, Piece):
            yield from _hinges(model, beam, ("links", beam.link), dim)
            continue
        path = ("beams", name)
        if name in model.members:
            yield Fault(path, f"{name!r} is also the name of a bar.", "Give each member its own name.", about=(("bars", name),))
        good = yield from _ends(model, beam, path)
        yield from _matter(model, beam, path, dim)
        yield from _release(beam, path, loose=dim == 3 and name not in held)
        yield from _hinges(model, beam, path, dim)
        if beam.kind == "rigid" and beam.damping:
            yield Fault(
                (*path, "damping"), "is given for a rigid beam, which does not deform.", "Leave it out, or kind: elastic."
            )
        yield from _rotation(model, beam, path, dim)
        if good and beam.orientation is not None:
            yield from _orientation(model, beam, path, dim)
    yield from _taken(model)
    yield from _clamps(model)


def _ends(model: WholeModel, beam: Beam, path: Path) -> Any:
    """Faults of the ends; returns True if the beam has a direction."""
    p, q = beam.ends
    good = True
    for k, end in enumerate(beam.ends):
        if end not in model.nodes:
            good = False
        elif model.nodes[end].scalar or model.inner.nodes.get(end, ON_HUB).table != "hubs":
            yield Fault(
                (*path, "ends", k), f"{end!r} is no place that a beam can join.", "Name a node.", about=(("nodes", end),)
            )
            good = False
    if p == q:
        yield Fault((*path, "ends"), f"joins node {p!r} to itself.", "Give two different nodes.")
        return False
    if good and model.nodes[p].at == model.nodes[q].at:
        message = f"has zero length: {p!r} and {q!r} stand at one place."
        yield Fault((*path, "ends"), message, "Move one of its ends.", about=(("nodes", p), ("nodes", q)))
        return False
    return good


def _matter(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """An elastic beam needs a section and a material, in space with a torsion constant."""
    lacks = []
    for field, table in (("section", model.sections), ("material", model.materials)):
        chosen = getattr(beam, field) if getattr(beam, field) is not None else getattr(model, field)
        if chosen is None:
            lacks.append(field)
        elif isinstance(chosen, str) and chosen not in table:
            return
    about = tuple((*place, field) for place in (path, ()) for field in ("section", "material"))
    if beam.kind == "elastic" and lacks:
        yield Fault(path, f"is elastic but has no {' and no '.join(lacks)}.", "Give both, or kind: rigid.", about=about)
    elif beam.kind == "elastic" and dim == 3 and model.section_of(beam).torsion_constant is None:
        message = "has a section without a torsion constant."
        yield Fault((*path, "section"), message, "Give the section J, m^4.", about=(*about, ("nodes",)))


def _lets_go(beam: Beam) -> bool:
    """Whether an elastic beam can spin about its own axis at both ends."""
    free = {*beam.release, *(end for end, about in beam.hinges.items() if about == 1)}
    return beam.kind == "elastic" and set(beam.ends) <= free


def _release(beam: Beam, path: Path, *, loose: bool) -> Iterator[Fault]:
    """Ends that are none, and in space a spin that is not held."""
    for k, end in enumerate(beam.release):
        if end not in beam.ends:
            mend = f"Name {beam.ends[0]} or {beam.ends[1]}."
            yield Fault((*path, "release", k), f"{end!r} is no end of the beam.", mend, about=((*path, "ends"),))
    if loose and _lets_go(beam):
        mend = "Make it an elastic bar, or release one end only."
        place = (*path, "release" if beam.release else "hinges")
        message = "leaves the beam free to spin about its own axis, and something drives or loads this."
        yield Fault(place, message, mend, about=(("nodes",),))


def _hinges(model: WholeModel, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """A hinge is at an end, in space, about a direction, against something that has a rotation."""
    for end, about in beam.hinges.items():
        place = (*path, "hinges", end)
        if end not in beam.ends:
            mend = f"Name {beam.ends[0]} or {beam.ends[1]}."
            yield Fault(place, f"{end!r} is no end of the beam.", mend, about=((*path, "ends"),))
        elif dim == 2:
            yield Fault(place, "is given in a planar model.", f"A pin in the plane: release: [{end}].", about=(("nodes",),))
        elif end in beam.release:
            message = f"{end!r} is released about all axes too."
            yield Fault(place, message, "Name it in one of both.", about=((*path, "release"),))
        elif not isinstance(about, int) and len(about) != dim:
            yield from components(about, dim, place)
        elif not isinstance(about, int) and not any(about):
            yield Fault(place, "is the zero vector.", "Give a direction, or 1, 2, 3 for an axis of the beam.")
        elif end in model.nodes and end not in model.inner.frames:
            mend = "Clamp the node, or let another beam share its rotation; a ball joint is release."
            yield Fault(place, f"{end!r} has no rotation that the hinge could hold.", mend, about=(("beams",), ("clamped",)))


def _rotation(model: WholeModel, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    """The rotation is a scalar node, of a rigid beam in the plane whose ends no other beam and no clamp holds."""
    if beam.rotation is None:
        return
    place = (*path, "rotation")
    if beam.kind != "rigid":
        yield Fault(place, "is given for an elastic beam, whose ends turn differently.", "Leave it out, or kind: rigid.")
    elif dim == 3:
        mend = "Leave it out: frames carry rotations in space."
        yield Fault(place, "is one angle, but the beam turns in space.", mend, about=(("nodes",),))
    elif beam.rotation in model.nodes and not model.nodes[beam.rotation].scalar:
        mend = f"Make it one: {beam.rotation}: {{at: [0, 0], scalar: true}}."
        yield Fault(place, f"{beam.rotation!r} is no scalar.", mend, about=(("nodes", beam.rotation),))
    elif held := [end for end in beam.ends if end not in beam.release and end in model.inner.frames]:
        message = f"shares its rotation at {held[0]!r}, where a frame carries it."
        yield Fault(place, message, f"Release that end (release: [{held[0]}]), or leave rotation out.", about=(("beams",),))


def _orientation(model: ModelData, beam: Beam, path: Path, dim: int) -> Iterator[Fault]:
    place = (*path, "orientation")
    given: Any = beam.orientation
    if dim == 2:
        yield Fault(place, "is given in a planar model.", "Leave it out: axis 2 lies in the plane.", about=(("nodes",),))
        return
    a, b = (model.nodes[end].at for end in beam.ends)
    if isinstance(given, str):
        if given not in model.nodes:
            return
        given = tuple(v - u for u, v in zip(a, model.nodes[given].at, strict=True))
    elif len(given) != dim:
        yield from components(given, dim, place)
        return
    d = [v - u for u, v in zip(a, b, strict=True)]
    cross = (d[1] * given[2] - d[2] * given[1], d[2] * given[0] - d[0] * given[2], d[0] * given[1] - d[1] * given[0])
    if math.hypot(*cross) <= ALONG * math.hypot(*d) * math.hypot(*given):
        yield Fault(place, "points along the beam, so it spans no plane with it.", "Give a direction across the beam.")


def _taken(model: WholeModel) -> Iterator[Fault]:
    """Names that frames need."""
    for name, frame in model.inner.frames.items():
        for axis in frame.nodes:
            if axis in model.nodes and axis not in model.inner.nodes:
                yield Fault(("nodes", axis), f"has the name of an axis of the frame at {name!r}.", "Give it another name.")


def _clamps(model: WholeModel) -> Iterator[Fault]:
    framed = model.inner.frames
    for node, to in model.clamped.items():
        place = ("clamped", node)
        body = model.bodies.get(to) if to != GROUND else None
        if node in model.nodes and node not in framed:
            links = [name for name, link in model.links.items() if node in link.nodes]
            if not any(node in beam.ends and not isinstance(beam, Piece) for beam in model.beams.values()):
                mend = "Join a beam to it, or fix the node."  # released ones are pinned there
                if links:
                    mend = f"Weld the link to it (links: {{{links[0]}: {{.., weld: [{node}]}}}}), or fix the node."
                what = f"the link {links[0]!r} is pinned there" if links else "no beam has its rotation"
                yield Fault(place, f"is clamped, but {what}.", mend, about=(("beams",), ("links",)))
        elif node in framed and body is not None and (body.kind != "rigid" or node not in body.nodes):
            message = f"is clamped to {to!r}, which is not a rigid body with this node."
            yield Fault(place, message, "Add the node to the nodes of a rigid body.", about=(("bodies", to),))
