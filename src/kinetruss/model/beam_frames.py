"""Frames: nodes that carry the rotations of the ends of beams; links with a pin in their middle; chords for pictures."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import few
from kinetruss.model.bodies import Body
from kinetruss.model.bracing import CHORD, braces_of_each
from kinetruss.model.drives import CoordinateDrive, CosineCoordinate, Coupling
from kinetruss.model.joints import GROUND
from kinetruss.model.members import Active, Bar, Node

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from kinetruss.model.beams import Beam
    from kinetruss.model.data import ModelData


SHARE = 0.3
"""Distance of the nodes of a frame from its origin, as a fraction of the shortest beam there."""
SHAPE = ".shape."
"""Between the name of a beam and the ends of a bar that holds it in its shape."""
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
    """Name of the frame at an end of a beam: that of the node, or the beam's own if the end is released."""
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
            rigid[frame] = rigid.get(frame, 0) + (1 if beam.kind == "rigid" and not hinged else 2)
            rigid[end] = rigid.get(end, 0) + hinged
    # the ground holds no rotation where all beams are released
    wanted = [frame for frame, count in rigid.items() if frame in origin and (count > 1 or frame in model.clamped)]
    axes = [f"d{k + 1}" for k in range(model.dim)]
    return {frame: Axes(origin[frame], size[frame], tuple(f"{frame}.{axis}" for axis in axes)) for frame in wanted}


@dataclass(frozen=True)
class Hinge:
    """A hinge between the frames of a beam and of its node: their names, and a node on its axis besides the origin."""

    own: str
    base: str
    node: str
    at: tuple[float, ...]


def hinges(model: ModelData) -> list[Hinge]:
    """The hinges of beams."""
    found, every = [], frames(model)
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


def expanded(model: ModelData) -> dict[str, Any]:
    """Tables `nodes`, `fixed` and `couplings` with what beams add; what they added before is left out first."""
    own = {name: node for name, node in model.nodes.items() if not node.director}
    fixed = {name: axes for name, axes in model.fixed.items() if name not in model.nodes or name in own}
    couplings = {name: one for name, one in model.couplings.items() if one.beam is None}
    every = "xyz"[: model.dim]
    nodes: dict[str, Node] = {}
    for name, frame in frames(model).items():
        at = own[frame.origin].at
        for k, axis in enumerate(frame.nodes):
            place = tuple(v + frame.size if i == k else v for i, v in enumerate(at))
            if axis not in own:  # else a fault
                nodes[axis] = Node(at=place, coincident=True, director=True)
        if model.clamped.get(name) == GROUND:
            fixed |= dict.fromkeys(frame.all, every)
    for hinge in hinges(model):
        if hinge.node not in own:
            nodes[hinge.node] = Node(at=hinge.at, coincident=True, director=True)
        if model.clamped.get(hinge.base) == GROUND:
            fixed[hinge.node] = every
    ends = {end for beam in model.beams.values() for end in beam.ends}
    fixed |= {name: every for name, to in model.clamped.items() if to == GROUND and name in ends & set(own)}
    for name, beam in rotations(model).items():
        couplings |= _turning(model, name, beam)
    return {"nodes": {**own, **nodes}, "fixed": fixed, "couplings": couplings}


def carriers_of(model: ModelData, name: str) -> tuple[str, ...] | None:
    """The nodes on which a load on a body acts: carriers of the body, or the frame of a node; None if it is neither."""
    if name in model.bodies:
        return model.bodies[name].carried_by(model.dim)
    found = frames(model).get(name)
    return None if found is None else found.all


def rigid_groups(model: ModelData) -> dict[str, Body]:
    """Bodies of the model, with the frames clamped to them, and rigid beams and frames as further ones without mass."""
    found = dict(model.bodies)
    every, pins = frames(model), hinges(model)
    for name, frame in every.items():
        to = model.clamped.get(name)
        # a node on the axis of a hinge belongs to both frames
        on = tuple(hinge.node for hinge in pins if name in (hinge.own, hinge.base))
        if to in found:
            body = found[to]
            found[to] = body.with_(nodes=(*body.nodes, *frame.nodes, *on), carriers=body.carried_by(model.dim), brace=True)
        elif to is None:
            found[name if name not in found else f"{name}.frame"] = Body(nodes=(*frame.all, *on), carriers=frame.all)
    for name, beam in sound_beams(model):
        if beam.kind == "rigid" and beam.rotation is None:
            parts = [every[key].all if (key := frame_of(name, beam, end)) in every else (end,) for end in beam.ends]
            nodes = tuple(dict.fromkeys(node for part in parts for node in part))
            whole = next((part for part in parts if len(part) > 1), nodes)
            found[name if name not in found else f"{name}.beam"] = Body(nodes=nodes, carriers=whole)
    return found


def shape_bars(model: ModelData, names: Iterable[str]) -> dict[str, dict[str, Bar]]:
    """By elastic beam the rigid bars without mass that hold it in its shape, called ``BEAM.shape.N1-N2``."""
    every, bodies = frames(model), {}
    for name in names:
        first, second = (every[frame_of(name, model.beams[name], end)].all for end in model.beams[name].ends)
        bodies[f"{name}{SHAPE[:-1]}"] = Body(nodes=tuple(dict.fromkeys((*first, *second))), carriers=first)
    return braces_of_each(model, rigid_groups(model), bodies)


def chords(model: ModelData) -> dict[str, Bar]:
    """Free bars without mass from end to end of beams: pictures show them, and their lengths are results."""
    return {f"{name}{CHORD}": Bar(ends=beam.ends, kind="free", mass=0.0, brace=True) for name, beam in sound_beams(model)}


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
        found[f"{name}.{axis}"] = Coupling(terms=(*along, (turned, -length)), value=0.0, beam=name)
    return found


def sound_beams(model: ModelData) -> list[tuple[str, Beam]]:
    """The beams whose ends stand; the others are faults."""
    fitting = {name for name, node in model.nodes.items() if len(node.at) == model.dim and not (node.scalar or node.director)}
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


# Links with a pin in their middle: what bars on one line do not hold, and how beams do.

LINE = 1e-6
"""A node within this fraction of the length of a link from its axis lies on it."""

OWN_NODE = (
    "where two links cross, the second one gets a node of its own at the same place (coincident: true), and two couplings keep "
    "x and y of both nodes equal"
)


def middle_pins(model: ModelData) -> list[tuple[str, str, str]]:
    """Three nodes on one line, each two joined by a rigid bar: bars hold the middle one to second order only.

    >>> import kinetruss as kt
    >>> middle_pins(kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)},
    ...                      bars={"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C")}))
    [('A', 'B', 'C')]
    """
    joined: dict[str, set[str]] = {}
    pairs = [bar.ends for bar in model.bars.values() if bar.kind == "rigid" and not bar.brace]
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
    """How to make a link of which bars do not hold the middle; empty if there is none."""
    pins = middle_pins(model)
    if not pins:
        return ""
    a, m, c = pins[0]
    text = f"{a}, {m} and {c} lie on one line, so that bars do not hold {m}: make the link of two beams ({a}-{m}, {m}-{c})"
    crossed = Counter(middle for _, middle, _ in pins)[m] > 1
    return f"{text}; {OWN_NODE}" if crossed else text


def shared_rotations(model: ModelData) -> str:
    """A sentence on nodes where three beams or more share one rotation; empty if there are none."""
    count = Counter(
        end for beam in model.beams.values() for end in beam.ends if end not in beam.release and end not in beam.hinges
    )
    nodes = [node for node, beams in count.items() if beams > 2]
    if not nodes:
        return ""
    return (
        f"Beams that meet at {few(nodes, 4)} share one rotation, as if welded. Release a beam that is pinned to the others "
        f"(release: [{nodes[0]}]); {OWN_NODE}."
    )


# What pictures show of beams: their chords. The nodes and bars of frames are left out.

FRAME = "frame"
"""Kind of the bars of frames, which pictures leave out."""


def shown_kinds(model: ModelData) -> dict[str, str]:
    """The kind that pictures show of each member: ``active``, or the kind of the bar; of the chord of a beam ``beam``, or
    ``rigid``; ``frame`` of bars that end at a node of a frame.
    """
    found = {name: "active" if isinstance(one, Active) else one.kind for name, one in model.members.items()}
    if not model.beams:
        return found
    beams = zip(chords(model), (beam.kind for beam in model.beams.values()), strict=False)
    found |= {chord: "beam" if kind == "elastic" else "rigid" for chord, kind in beams if chord in found}
    directors = {name for name, node in model.nodes.items() if node.director}
    found |= {name: FRAME for name, one in model.members.items() if directors & set(one.ends)}
    return found


def shown_names(model: ModelData) -> dict[str, str]:
    """The name that pictures show of each member: of the chord of a beam that of the beam."""
    beams = {f"{name}{CHORD}": name for name in model.beams}
    return {name: beams.get(name, name) for name in model.members}
