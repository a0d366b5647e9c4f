"""A model from a robot in its closed pose: rigid bodies with shared nodes.

Links that are fixed to each other become one body. A revolute joint is two shared nodes on its axis, a ball one shared node, a
slider the Sarrus linkage of `library.joints`. The drive of a revolute joint measures the value of the joint itself: two nodes
at the same distance from the axis, one in each body, are at one place where the value is 0.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.exchange.robots.closing import Posed
from kinetruss.exchange.robots.draft import REACH, Draft, extent, gyration, hinged
from kinetruss.exchange.robots.laws import with_laws, with_rotors, with_spans
from kinetruss.exchange.robots.parts import SAME, Connection, Part, parts_of
from kinetruss.exchange.robots.records import LeftOut
from kinetruss.library import joints
from kinetruss.library.bodies import MassProperties, rigid
from kinetruss.model import GROUND, Bar, Body, Gear, Hinge, HingeDrive, Joint, LengthDrive, Model, Node
from kinetruss.model.checks import beside
from kinetruss.model.parts import quality, second_moments

if TYPE_CHECKING:
    pass

__all__ = ["Assembled", "assemble"]

ROUND = 1e-6
"""Difference of the two cross moments of a rod, relative to their mean, that still counts as none."""
THIN = 1e-9
"""A body is a rod or a plate if a second moment is below this fraction of the largest."""
WIDE, GOOD = 0.5, 0.05
"""Least distance of its carriers, relative to the radius of gyration, and least normalised area or volume."""
APART, FACTORS = 0.01, (1.0, 1.25, 0.8, 1.4, 0.7)
"""Least distance of a carrier from other nodes, over the radius of gyration, and factors of its distance from the centre."""
ALONE = "(alone)"
"""Name of the node of a model without nodes, which every model needs."""
SPARE = 1.15
"""Half the stroke of a slider over the travel that its limits allow."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Assembled:
    """The model; offsets : value of a drive minus that of its joint in the file, rad or m; what was left out."""

    model: Model
    offsets: Mapping[str, float]
    left_out: Sequence[LeftOut]


def assemble(posed: Posed) -> Assembled:
    """The model of a robot in its closed pose.

    Raises
    ------
    ModelError : bodies that are impossible, with the place of the link in the file.
    """
    parts, connections, left = parts_of(posed)
    draft = Draft(size=_size(parts, connections), own={name: [] for name in parts}, left=left)
    for one in connections:
        if one.kind == "ball":
            node = draft.share(one.name, one.place, one.parts)
            draft.joints[one.name] = Joint(kind="spherical", bodies=one.parts, nodes=(node,))
        elif one.kind == "revolute":
            hinged(draft, one, parts)
    for part in parts.values():
        for name, place in part.points.items():
            draft.share(name, place, (part.name,))
    points = {name: (part.name, place) for part in parts.values() for name, place in part.points.items()}
    spans = {one.name: [draft.share(end, points[end][1], points[end][:1]) for end in one.points] for one in posed.robot.spans}
    sliders = [one for one in connections if one.kind == "prismatic"]
    model = _with_bodies(draft, posed, parts, {name for one in sliders for name in one.parts})
    model = model.with_(joints=_with_hinges(model, draft), drives=_drives(draft, connections))
    for one in sliders:
        model = _slider(model, draft, one)
    model = with_rotors(with_laws(model, draft, connections, posed.robot), draft, connections)
    model = with_spans(model, spans, posed.robot)
    offsets = {one.drive: draft.offsets[one.name] for one in connections if one.drive is not None}
    return Assembled(model=model, offsets=offsets, left_out=draft.left)


def _drives(draft: Draft, connections: Sequence[Connection]) -> dict[str, HingeDrive | LengthDrive]:
    """The drives of hinges, with the gears before them."""
    found = {one.drive: (one, draft.coordinates[one.name]) for one in connections if one.kind == "revolute" and one.drive}
    return {
        name: angle if one.ratio is None else angle.with_(gear=Gear(ratio=one.ratio)) for name, (one, angle) in found.items()
    }


def _size(parts: Mapping[str, Part], connections: Sequence[Connection]) -> float:
    """Largest extent of all places of the robot, m."""
    places = [one.place for one in connections] + [place for part in parts.values() for place in part.points.values()]
    places += [part.properties.center for part in parts.values() if part.properties is not None]
    spread = float(np.ptp(np.array(places), axis=0).max()) if len(places) > 1 else 0.0
    return spread or max((gyration(part) for part in parts.values()), default=0.0) or 1.0


def _with_bodies(draft: Draft, posed: Posed, parts: Mapping[str, Part], slides: set[str]) -> Model:
    """The model with its nodes and bodies. Each body is made in a model of its own nodes, so that many take little time."""
    ground = draft.own.get(GROUND, [])
    if not draft.places:
        draft.places["origin"], ground = np.zeros(3), ["origin"]
    nodes = {name: Node(at=tuple(place.tolist()), coincident=True) for name, place in draft.places.items()}
    bodies: dict[str, Body] = {}
    for part in parts.values():
        if part.name != GROUND:
            own = {name: nodes[name] for name in draft.own[part.name]}
            made = _with_body(Model(nodes=own or {ALONE: Node(at=(0, 0, 0))}), draft, part, part.name in slides)
            names = {name: name if name in own else _free(name, nodes) for name in made.nodes if name != ALONE}
            nodes |= {names[name]: node.with_(coincident=True) for name, node in made.nodes.items() if name in names}
            bodies |= {key: _renamed(body, names) for key, body in made.bodies.items()}
    return Model(title=posed.robot.title, nodes=nodes, fixed=tuple(ground), gravity=posed.robot.gravity, bodies=bodies)


def _free(name: str, taken: Mapping[str, Any]) -> str:
    while name in taken:
        name += "'"
    return name


def _renamed(body: Body, names: Mapping[str, str]) -> Body:
    carriers = None if body.carriers is None else tuple(names[name] for name in body.carriers)
    return body.with_(nodes=tuple(names[name] for name in body.nodes), carriers=carriers)


def _with_body(model: Model, draft: Draft, part: Part, slides: bool) -> Model:
    """The model with the body of a part."""
    names, given = draft.own[part.name], part.properties
    try:
        if given is None:
            return _massless(model, draft, part, slides)
        if not given.inertia.any():
            draft.left.append(LeftOut("inertia", part.where, "the link has mass without inertia: its mass is at one node"))
            return _massless(_with_mass(model, draft, part.name, given), draft, part, slides)
        if (rod := _rod(draft, part, slides)) is not None:
            text = "turns freely about the line of its two balls; it is carried by the two nodes without that turning"
            draft.left.append(LeftOut("spin", part.where, text))
            return model.with_(bodies=model.bodies | {part.name: rod})
        points = _thin_carriers(draft, names, given)
        made = rigid(model, part.name, given, nodes=[name for name in names if name not in points], points=points or None)
        return made if points else _apart(made, model, draft, part)
    except InputError as error:
        faults = error.faults if isinstance(error, ModelError) else [Fault((), str(error), "")]
        words = " ".join(str(one) for one in faults)
        raise ModelError([Fault((), f"{part.where}: {words}", "Correct the masses and inertias of this link.")]) from None


def _with_mass(model: Model, draft: Draft, part: str, given: MassProperties) -> Model:
    """The model with a mass at one node of a part, a new one if none is there."""
    there = [name for name in draft.own[part] if float(np.linalg.norm(draft.places[name] - given.center)) <= SAME * draft.size]
    name = there[0] if there else f"{part}.mass"
    at = model.nodes[name].at if there else tuple(given.center.tolist())
    mass = given.mass + (model.nodes[name].mass if there else 0.0)
    return model.with_(nodes=model.nodes | {name: Node(at=at, mass=mass, coincident=True)})


def _massless(model: Model, draft: Draft, part: Part, slides: bool) -> Model:
    """A body without mass on its nodes, with more nodes if they do not make a body."""
    names = [name for name in model.nodes if name != ALONE]
    if not names and not slides:
        return model
    places = {name: np.array(model.nodes[name].at) for name in names}
    if slides or not names:  # a slider needs a body with an extent
        middle = next(iter(places.values()), part.joints[0] if part.joints else np.zeros(3))
        reach = REACH * extent(part, draft.size)
        places |= {f"{part.name}.{k + 1}": middle + reach * along for k, along in enumerate(np.eye(3))}
    elif len(places) == 1:
        middle, reach = next(iter(places.values())), REACH * draft.size
        places |= {f"{part.name}.{k + 1}": middle + reach * along for k, along in enumerate(np.eye(3)[:2])}
    more = beside(np.array(list(places.values())), 3) if len(places) > 1 else []
    span = 3 - len(more)
    if len(places) > span + 1 or span < 2:  # bars hold nodes in one plane or on one line to second order only
        places |= {f"{part.name}.apex{k + 1 if k else ''}": place for k, place in enumerate(more)}
    new = {name: Node(at=tuple(place.tolist()), coincident=True) for name, place in places.items() if name not in model.nodes}
    carriers = _spanning(places)
    body = Body(nodes=tuple(places), carriers=carriers)
    return model.with_(nodes=model.nodes | new, bodies=model.bodies | {part.name: body})


def _spanning(places: Mapping[str, Any]) -> tuple[str, ...]:
    """Nodes that span what all of them span, chosen one by one by their distance from those before."""
    names = list(places)
    chosen, rows = [names[0]], np.zeros((0, 3))
    while len(chosen) < 4:
        away = np.array([places[name] - places[chosen[0]] for name in names])
        away = away - away @ rows.T @ rows
        far = np.linalg.norm(away, axis=1)
        best = int(np.argmax(far))
        if far[best] <= 1e-9 * max(float(far.max()), 1.0) or names[best] in chosen:
            break
        chosen.append(names[best])
        rows = np.vstack([rows, away[best] / far[best]])
        if len(rows) == 3:
            break
    return tuple(chosen)


def _apart(made: Model, model: Model, draft: Draft, part: Part) -> Model:
    """The model with the carriers of a body farther from its centre if one is almost at another node of the body.

    That of a uniform rod is at the end of the rod, where its joint is; a bar between the two would have no direction.
    """
    given = part.properties
    at = {name: np.array(made.nodes[name].at) for name in made.bodies[part.name].carriers or ()}
    others = [draft.places[name] for name in draft.own[part.name]]
    if given is None or not others or not at.keys().isdisjoint(draft.own[part.name]):
        return made
    for factor in FACTORS:
        points = {name: given.center + factor * (place - given.center) for name, place in at.items()}
        least = min(float(np.linalg.norm(place - other)) for place in points.values() for other in others)
        if least > APART * gyration(part):
            break
    return made if factor == 1.0 else rigid(model, part.name, given, nodes=draft.own[part.name], points=points)


def _thin_carriers(draft: Draft, names: Sequence[str], given: MassProperties) -> dict[str, Any]:
    """Nodes that carry the mass of a rod or a plate, if it has some on its line or in its plane.

    The carriers that are chosen otherwise lie near the ends of a uniform rod, so almost where its joints are.
    """
    values, axes = np.linalg.eigh(second_moments(given.inertia))
    extent = int(np.sum(values > THIN * values[-1]))
    off = {name: np.abs((draft.places[name] - given.center) @ axes[:, : 3 - extent]) for name in names}
    own = {name: draft.places[name] for name in names if extent < 3 and (off[name] <= SAME * draft.size).all()}
    if len(own) <= extent:
        return {}
    found = {name: own[name] for name in _spanning(own)[: extent + 1]}
    spread = float(np.linalg.norm(np.ptp(np.array(list(found.values())), axis=0)))
    wide = spread > WIDE * math.sqrt(float(values[-1]) / given.mass)
    return found if wide and len(found) == extent + 1 and quality(list(found.values())) > GOOD else {}


def _rod(draft: Draft, part: Part, slides: bool) -> Body | None:
    """A body between two balls that is alike all round their line: on two nodes, without turning about the line."""
    names, given = draft.own[part.name], part.properties
    if given is None or slides or len(names) != 2 or not part.balls_only:
        return None
    a, b = (draft.places[name] for name in names)
    along = (b - a) / float(np.linalg.norm(b - a))
    off = given.center - a
    across = np.eye(3) - np.outer(along, along)
    moment = 0.5 * float(np.trace(across @ given.inertia))
    rest = across @ given.inertia @ across - moment * across
    crossed = float(np.abs(given.inertia @ along - (along @ given.inertia @ along) * along).max())
    if float(np.linalg.norm(across @ off)) > SAME * draft.size or max(float(np.abs(rest).max()), crossed) > ROUND * moment:
        return None
    return Body(
        nodes=tuple(names),
        carriers=tuple(names),
        mass=given.mass,
        center=tuple(given.center),
        inertia=(moment * across).tolist(),
    )


def _with_hinges(model: Model, draft: Draft) -> dict[str, Joint]:
    """The joints; a revolute one without a drive gets its angle between a node of each body off the axis."""
    found = {}
    for name, joint in draft.joints.items():
        if joint.kind == "revolute" and not joint.hinges:
            place = np.array([model.nodes[node].at for node in joint.nodes])
            along = (place[1] - place[0]) / float(np.linalg.norm(place[1] - place[0]))
            ends = [_aside(model, body, place[0], along) for body in joint.bodies]
            if ends[0] is not None and ends[1] is not None:
                joint = joint.with_(hinges=(Hinge(axis=joint.nodes, start=ends[0], end=ends[1]),))
        found[name] = joint
    return found


def _aside(model: Model, body: str, place: Any, along: Any) -> str | None:
    """The node of a body farthest from an axis."""
    names = list(model.fixed) if body == GROUND else model.bodies[body].nodes
    best, found = 1e-6, None
    for name in names:
        way = np.array(model.nodes[name].at) - place
        off = float(np.linalg.norm(way - (way @ along) * along))
        if off > best * (1 + 1e-9):
            best, found = off, name
    return found


def _slider(model: Model, draft: Draft, one: Connection) -> Model:
    """The model with a slider; its stroke holds the travel between the limits."""
    size = None
    if one.limits is not None:
        travel = max(one.limits[1] - one.value, one.value - one.limits[0])
        size = SPARE * travel if 0 < travel < math.inf else None
    made = joints.prismatic(model, one.name, bodies=one.parts, at=one.place, axis=one.axis, size=size)
    slide = made.joints[one.name].slide
    if one.measured and slide is not None:
        name = one.drive or f"{one.name}.travel"
        bar = Bar(ends=slide, kind="driven" if one.drive is not None else "free", mass=0.0)
        made = made.with_(bars=made.bars | {name: bar})
        draft.coordinates[one.name] = LengthDrive(name)
        first, second = (np.array(made.nodes[node].at) for node in slide)
        draft.offsets[one.name] = float(np.linalg.norm(second - first)) - one.value
    return made
