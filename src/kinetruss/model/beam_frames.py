"""Frames: nodes that carry the rotations of the ends of beams, and chords; links with a pin in their middle."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import few
from kinetruss.model.bodies import Body
from kinetruss.model.bracing import CHORD
from kinetruss.model.drives import CoordinateDrive, CosineCoordinate, Coupling
from kinetruss.model.inner import Owner
from kinetruss.model.joints import GROUND
from kinetruss.model.links import Piece
from kinetruss.model.members import Brace, Node
from kinetruss.model.supports import turning_supports

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from kinetruss.model.beams import Beam
    from kinetruss.model.data import ModelData
    from kinetruss.model.whole import WholeModel


SHARE = 0.3
"""Distance of the nodes of a frame from its origin, as a fraction of the shortest beam there."""
AWAY = 0.6
"""Distance of a node on the axis of a hinge from the origin, as a fraction of that of the nodes of the frame."""
STEEP = 0.95
"""Cosine of a beam with global z from which on its default orientation is global x."""


@dataclass(frozen=True)
class Axes:
    """A frame: its origin, a node; the distance of its axes, m; and their nodes."""

    origin: str
    size: float
    nodes: tuple[str, ...]

    @property
    def all(self) -> tuple[str, ...]:
        """The origin, then the axes."""
        return self.origin, *self.nodes


def frame_of(name: str, beam: Beam, end: str) -> str:
    """Name of the frame at an end of a beam: that of the node, or the beam's own if the end is released; the parts of a link
    share one at each of its pins.
    """
    if isinstance(beam, Piece):
        return f"{beam.link}.{end}" if end in beam.own else end
    return f"{name}.{end}" if end in beam.release or end in beam.hinges else end


def frames(model: ModelData) -> dict[str, Axes]:
    """All frames of a model by name: at the ends of elastic beams, at clamped nodes, where rigid beams meet."""
    size: dict[str, float] = {}
    origin: dict[str, str] = {}
    rigid: dict[str, int] = {}
    for name, beam in sound_beams(model):
        length = _length(model, beam)
        for end in beam.ends:
            frame = frame_of(name, beam, end)
            hinged = end in beam.hinges
            for one in {frame: 0, end: 0} if hinged else (frame,):
                origin[one] = end
                size[one] = min(SHARE * length, size.get(one, math.inf))
            # a rigid beam needs a frame only where another beam, a clamp or a hinge holds its rotation
            alone = beam.kind == "rigid" and not hinged and not isinstance(beam, Piece)
            rigid[frame] = rigid.get(frame, 0) + (1 if alone else 2)
            rigid[end] = rigid.get(end, 0) + hinged
    # the ground holds no rotation where all beams are released
    held = model.clamped.keys() | turning_supports(model)
    wanted = [frame for frame, count in rigid.items() if frame in origin and (count > 1 or frame in held)]
    axes = [f"d{k + 1}" for k in range(model.dim)]
    return {frame: Axes(origin[frame], size[frame], tuple(f"{frame}.{axis}" for axis in axes)) for frame in wanted}


@dataclass(frozen=True)
class Hinge:
    """A hinge between the frames of a beam and of its node: their names, and a node on its axis besides the origin."""

    own: str
    base: str
    node: str
    at: tuple[float, ...]


def hinges(model: ModelData, every: Mapping[str, Axes]) -> list[Hinge]:
    """The hinges of beams between these frames."""
    found = []
    for name, beam in sound_beams(model):
        for end, about in beam.hinges.items():
            own = frame_of(name, beam, end)
            if end not in beam.ends or not {end, own} <= set(every) or not _directed(model, beam, about):
                continue  # a fault
            axis = axes_of_beam(model, beam)[about - 1] if isinstance(about, int) else about
            reach = AWAY * every[own].size / math.hypot(*axis)
            at = tuple(float(v + reach * u) for v, u in zip(model.nodes[end].at, axis, strict=True))
            found.append(Hinge(own, end, f"{own}.axis", at))
    return found


def add_frames(whole: WholeModel) -> None:
    """Add the nodes of frames and hinges, their supports, and the couplings of rotations that are coordinates."""
    inner, own = whole.inner, set(whole.nodes)
    inner.frames.update(frames(whole))
    inner.hinges.extend(hinges(whole, inner.frames))
    every = "xyz"[: whole.dim]
    owners = {
        frame_of(name, beam, end): Owner("links", beam.link, end) if isinstance(beam, Piece) else Owner("beams", name, end)
        for name, beam in whole.beams.items()
        for end in beam.ends
    }

    def add(node: str, at: tuple[float, ...], owner: Owner) -> None:
        if node not in own:  # else a fault
            whole.nodes[node], inner.nodes[node] = Node.model_construct(at=at, coincident=True), owner

    for name, frame in inner.frames.items():
        at = whole.nodes[frame.origin].at
        for k, axis in enumerate(frame.nodes):
            place = tuple(v + frame.size if i == k else v for i, v in enumerate(at))
            add(axis, place, Owner("nodes", name, name) if name == frame.origin else owners[name])
        if whole.clamped.get(name) == GROUND:
            whole.fixed.update(dict.fromkeys(frame.all, every))
    for hinge in inner.hinges:
        add(hinge.node, hinge.at, owners[hinge.own])
        if whole.clamped.get(hinge.base) == GROUND:
            whole.fixed[hinge.node] = every
    ends = {end for beam in whole.beams.values() for end in beam.ends}
    whole.fixed.update({name: every for name, to in whole.clamped.items() if to == GROUND and name in ends & own})
    for name, beam in rotations(whole).items():
        turning = _turning(whole, name, beam)
        whole.couplings.update(turning)
        inner.couplings.update(dict.fromkeys(turning, Owner("beams", name)))


def carriers_of(whole: WholeModel, name: str) -> tuple[str, ...] | None:
    """The nodes on which a load on a body acts: carriers of the body, or the frame of a node; None if it is neither."""
    if name in whole.bodies:
        return whole.bodies[name].carried_by(whole.dim)
    found = whole.inner.frames.get(name)
    return None if found is None else found.all


def rigid_groups(whole: WholeModel) -> dict[str, Body]:
    """Bodies of the model, with the frames clamped to them, and rigid beams and frames as further ones without mass."""
    found = dict(whole.bodies)
    every, pins = whole.inner.frames, whole.inner.hinges
    for name, frame in every.items():
        to = whole.clamped.get(name)
        # a node on the axis of a hinge belongs to both frames
        on = tuple(hinge.node for hinge in pins if name in (hinge.own, hinge.base))
        on += (whole.inner.tips[name],) if name in whole.inner.tips else ()
        on += whole.inner.arms_of_supports.get(name, ())
        if to in found:
            body = found[to]
            found[to] = body.with_(nodes=(*body.nodes, *frame.nodes, *on), carriers=body.carried_by(whole.dim), brace=True)
        elif to is None:
            found[name if name not in found else f"{name}.frame"] = Body(nodes=(*frame.all, *on), carriers=frame.all)
    for name, beam in sound_beams(whole):
        if beam.kind == "rigid" and beam.rotation is None:
            parts = [every[key].all if (key := frame_of(name, beam, end)) in every else (end,) for end in beam.ends]
            nodes = tuple(dict.fromkeys(node for part in parts for node in part))
            framed = next((part for part in parts if len(part) > 1), nodes)
            found[name if name not in found else f"{name}.beam"] = Body(nodes=nodes, carriers=framed)
    return found


def owner_of(name: str, beam: Beam) -> Owner:
    """Whose a beam is: the user's, or part of a link."""
    return Owner("links", beam.link) if isinstance(beam, Piece) else Owner("beams", name)


def add_chords(whole: WholeModel) -> None:
    """Add free bars without mass from end to end of beams: pictures show them, and their lengths are results."""
    for name, beam in sound_beams(whole):
        whole.bars[f"{name}{CHORD}"] = Brace.model_construct(ends=beam.ends, kind="free", mass=0.0)
        whole.inner.bars[f"{name}{CHORD}"] = owner_of(name, beam)


def rigid_beams(model: ModelData) -> list[Body]:
    """The mass of rigid beams, spread evenly along them."""
    found = []
    for _, beam in sound_beams(model):
        if beam.kind == "rigid":
            section, material, mass = model.section_of(beam), model.material_of(beam), beam.mass
            if mass is None and section is not None and material is not None:
                mass = material.density * section.area * _length(model, beam)
            found.append(Body(nodes=beam.ends, mass=mass or 0.0))
    return found


def rotations(model: ModelData) -> dict[str, Beam]:
    """The rigid beams whose rotation is a coordinate."""
    return {name: beam for name, beam in sound_beams(model) if beam.kind == "rigid" and beam.rotation is not None}


def axes_of_beam(model: ModelData, beam: Beam) -> NDArray[Any]:
    """Local axes 1, 2, 3 of a beam at the start as rows, (dim, dim)."""
    import numpy as np

    a, b = (np.array(model.nodes[end].at, float) for end in beam.ends)
    one = (b - a) / np.linalg.norm(b - a)
    if model.dim == 2:
        return np.array([one, [-one[1], one[0]]])
    given = beam.orientation
    if given is None:
        toward = np.eye(3)[0 if abs(one[2]) > STEEP else 2]
    else:
        toward = np.array(model.nodes[given].at, float) - a if isinstance(given, str) else np.array(given, float)
    three = np.cross(one, toward)
    three = three / np.linalg.norm(three)
    return np.array([one, np.cross(three, one), three])


def _turning(model: ModelData, name: str, beam: Beam) -> dict[str, Coupling]:
    """x_Q - x_P - l cos(rotation + phase) = 0 and the same of y with the sine; 0 phase if the angle is that of the drawing."""
    p, q = beam.ends
    a, b = model.nodes[p].at, model.nodes[q].at
    length, drawn = math.dist(a, b), math.atan2(b[1] - a[1], b[0] - a[0])
    scalar = str(beam.rotation)
    # the scalar may count whole turns, and may be rounded in the drawing
    phase = math.remainder(drawn - model.nodes[scalar].at[0], 2 * math.pi)
    found = {}
    for axis, quarter in (("x", 0.0), ("y", -0.5 * math.pi)):
        along = [(CoordinateDrive(node=q, axis=axis), 1.0), (CoordinateDrive(node=p, axis=axis), -1.0)]
        turned = CosineCoordinate(node=scalar, phase=phase + quarter)
        found[f"{name}.{axis}"] = Coupling(terms=(*along, (turned, -length)), value=0.0)
    return found


def sound_beams(model: ModelData) -> list[tuple[str, Beam]]:
    """The beams whose ends stand; the others are faults."""
    fitting = {name for name, node in model.nodes.items() if len(node.at) == model.dim and not node.scalar}
    return [
        (name, beam)
        for name, beam in model.beams.items()
        if set(beam.ends) <= fitting
        and model.nodes[beam.ends[0]].at != model.nodes[beam.ends[1]].at
        and (beam.rotation is None or (beam.rotation in model.nodes and model.nodes[beam.rotation].scalar))
    ]


def _directed(model: ModelData, beam: Beam, about: Any) -> bool:
    """False if a hinge has no direction in space: a fault."""
    if model.dim != 3 or not isinstance(about, int):
        return model.dim == 3 and len(about) == 3 and any(about)
    given = beam.orientation
    if isinstance(given, str):
        return given in model.nodes and len(model.nodes[given].at) == 3 and given not in beam.ends
    return given is None or (len(given) == 3 and any(given))


def _length(model: ModelData, beam: Beam) -> float:
    return math.dist(*(model.nodes[end].at for end in beam.ends))


# Members with a pin in their middle: what bars on one line do not hold, and links do.

LINE = 1e-6
"""A node within this fraction of the length of a bar from its axis lies on it."""


def middle_pins(model: ModelData) -> list[tuple[str, str, str]]:
    """Three nodes on one line, each two joined by a rigid bar: bars hold the middle one to second order only.

    >>> import kinetruss as kt
    >>> middle_pins(kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)},
    ...                      bars={"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C")}))
    [('A', 'B', 'C')]
    """
    joined: dict[str, set[str]] = {}
    pairs = [bar.ends for bar in model.bars.values() if bar.kind == "rigid" and not isinstance(bar, Brace)]
    for a, b in pairs:
        joined.setdefault(a, set()).add(b)
        joined.setdefault(b, set()).add(a)
    found = []
    for a, c in pairs:
        x, y = (np.array(model.nodes[end].at) for end in (a, c))
        along = y - x
        square = float(along @ along)
        for middle in sorted(joined[a] & joined[c], key=list(model.nodes).index):
            d = np.array(model.nodes[middle].at) - x
            share = float(d @ along) / square
            if 0 < share < 1 and np.linalg.norm(d - share * along) <= LINE * square**0.5:
                found.append((a, middle, c))
    return found


def line_advice(model: ModelData) -> str:
    """How to make a member of which bars do not hold the middle; empty if there is none."""
    pins = middle_pins(model)
    if not pins:
        return ""
    a, m, c = pins[0]
    text = f"{a}, {m} and {c} lie on one line, so that bars do not hold {m}: make one link of them "
    text += f"(links: {{boom: [{a}, {m}, {c}]}})"
    crossed = next(((p, q) for p, middle, q in pins[1:] if middle == m and {p, q} != {a, c}), None)
    return text if crossed is None else f"{text}, and another of {crossed[0]}, {m} and {crossed[1]}: they turn freely at {m}"


def shared_rotations(model: ModelData) -> str:
    """A sentence on nodes where three beams or more share one rotation; empty if there are none."""
    count = Counter(
        end for beam in model.beams.values() for end in beam.ends if end not in beam.release and end not in beam.hinges
    )
    nodes = [node for node, beams in count.items() if beams > 2]
    if not nodes:
        return ""
    return (
        f"Beams that meet at {few(nodes, 4)} share one rotation, as if welded. Make a link of those that run through it as "
        f"one member (links: {{boom: [.., {nodes[0]}, ..]}}), or release a beam that ends there (release: [{nodes[0]}])."
    )
