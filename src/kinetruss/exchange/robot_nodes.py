"""The nodes of a model of a robot while it is made: shared places, and what carries the mass of each part."""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robot_parts import NOTHING, SAME, Connection, Part, gyration
from kinetruss.exchange.robots import LeftOut, turn_about
from kinetruss.library.bodies import MassProperties
from kinetruss.library.mechanisms.loops import SARRUS_BARS, sarrus_places
from kinetruss.model import GROUND, Bar, Body, Hinge, HingeDrive, Joint, LengthDrive
from kinetruss.model.bodies import quality, second_moments
from kinetruss.model.bracing import beside

if TYPE_CHECKING:
    from numpy.typing import NDArray


REACH = 0.5
"""Distance of the two nodes of an axis, as a fraction of the extent of the smaller part."""
LEAST = 0.02
"""Least extent of a part, as a fraction of the size of the robot: nodes that almost meet have bars without direction."""
CLEAR = 0.05
"""Least distance of a new node from the others of its parts, as a fraction of the reach of its joint."""
SHIFTS = (0.0, 0.3, -0.3, 0.6, -0.6, 1.3, -1.3, 0.15, -0.15, 2.2, -2.2)
REACHES = (1.0, -1.0, 0.7, -0.7, 1.4, -1.4, 0.5, -0.5, 2.0, -2.0)
TURNS = (0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, math.pi, 2.0, -2.0)
"""Places that are tried for a node along an axis and about it, in reaches and rad, until it is clear of others."""
SPARE = 1.15
"""Half the stroke of a slider over the travel that its limits allow."""
APEX = 0.7
"""Height of the apex of a plate of a slider over its length."""

Place = tuple[float, float, float]


@dataclass(eq=False)
class Draft:
    """Nodes by name and place, m, those of each part, joints with their bars, and drives, while the model is built.

    coordinates : of joints with a drive, a spring or a coupling. offsets : value of a coordinate minus that of its joint in the
        file, rad or m. masses : of nodes that are mass points, kg.
    """

    size: float
    places: dict[str, Place] = field(default_factory=dict)
    own: dict[str, list[str]] = field(default_factory=dict)
    joints: dict[str, Joint] = field(default_factory=dict)
    bars: dict[str, Bar] = field(default_factory=dict)
    masses: dict[str, float] = field(default_factory=dict)
    coordinates: dict[str, HingeDrive | LengthDrive] = field(default_factory=dict)
    offsets: dict[str, float] = field(default_factory=dict)
    left: list[LeftOut] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def at(self, node: str) -> NDArray[np.float64]:
        """Place of a node, m."""
        return np.array(self.places[node])

    def add(self, name: str, place: Any) -> str:
        """A node at a place, by this name or a similar free one."""
        name = free(name, self.places)
        x, y, z = np.asarray(place, float).tolist()
        self.places[name] = (x, y, z)
        return name

    def share(self, name: str, place: Any, parts: Sequence[str]) -> str:
        """A node of several parts. The node of one of them at this place is the same point of it, so it is shared by all."""
        near = SAME * self.size
        there = list(
            dict.fromkeys(node for part in parts for node in self.own[part] if math.dist(self.places[node], place) <= near)
        )
        found = there[0] if there else self.add(name, place)
        for other in there[1:]:
            self._merge(other, found)
        for part in parts:
            if found not in self.own[part]:
                self.own[part].append(found)
        return found

    def clear(self, place: Any, parts: Iterable[str], least: float) -> bool:
        """True if the nodes of some parts are at this very place or at least so far from it, m."""
        near, x = SAME * self.size, place.tolist()
        return not any(near < math.dist(self.places[node], x) < least for part in parts for node in self.own[part])

    def _merge(self, old: str, new: str) -> None:
        """Call a node by the name of another at its place."""
        del self.places[old]
        for part, names in self.own.items():
            if old in names:
                self.own[part] = list(dict.fromkeys(_other(names, old, new)))
        for name, joint in self.joints.items():
            hinges = tuple(Hinge(**_named(one, old, new)) for one in joint.hinges)
            slide = None if joint.slide is None else _pair(joint.slide, old, new)
            self.joints[name] = joint.with_(nodes=_other(joint.nodes, old, new), hinges=hinges, slide=slide)
        for name, bar in self.bars.items():
            if old in bar.ends:
                self.bars[name] = bar.with_(ends=_pair(bar.ends, old, new))
        for name, one in self.coordinates.items():
            if isinstance(one, HingeDrive):
                self.coordinates[name] = HingeDrive(**_named(one, old, new))


def free(name: str, taken: Container[str]) -> str:
    """The name, or a similar free one."""
    while name in taken:
        name += "'"
    return name


def _other(names: Sequence[str], old: str, new: str) -> tuple[str, ...]:
    return tuple(new if name == old else name for name in names)


def _pair(names: Sequence[str], old: str, new: str) -> tuple[str, str]:
    one, two = _other(names, old, new)
    return one, two


def _named(one: Hinge | HingeDrive, old: str, new: str) -> dict[str, Any]:
    start, end = _pair((one.start, one.end), old, new)
    return {"axis": _other(one.axis, old, new), "start": start, "end": end}


def extent(part: Part, size: float) -> float:
    """Extent of a part: of its places and its mass, m; of the whole robot for the ground; no more than that, and not tiny."""
    if part.name == GROUND:
        return size
    places = [*part.joints, *part.points.values(), *([] if part.properties is None else [part.properties.center])]
    spread = float(np.linalg.norm(np.ptp(np.array(places), axis=0))) if places else 0.0
    found = max(spread, 0.0 if part.properties is None else 2 * gyration(part.properties)) or size
    return min(max(found, LEAST * size), size)


def ball(draft: Draft, one: Connection) -> None:
    """One shared node."""
    node = draft.share(one.name, one.place, one.parts)
    draft.joints[one.name] = Joint(kind="spherical", bodies=one.parts, nodes=(node,))


def hinged(draft: Draft, one: Connection, parts: Mapping[str, Part]) -> None:
    """Two shared nodes on the axis, and the nodes between which its angle is measured if anything acts on it."""
    reach = REACH * min(extent(parts[name], draft.size) for name in one.parts)
    first = _clear(draft, one.parts, [one.place + shift * reach * one.axis for shift in SHIFTS], CLEAR * reach)
    second = _clear(draft, one.parts, [first + far * reach * one.axis for far in REACHES], CLEAR * reach)
    if float((second - first) @ one.axis) < 0:
        first, second = second, first
    one_end, other = (draft.share(f"{one.name}.{k}", place, one.parts) for k, place in ((1, first), (2, second)))
    hinges: tuple[Hinge, ...] = ()
    if one.measured:
        start, end = _measured(draft, one, first, reach)
        hinges = (Hinge(axis=(one_end, other), start=start, end=end),)
        draft.coordinates[one.name] = HingeDrive(axis=(one_end, other), start=start, end=end)
        draft.offsets[one.name] = math.atan2(math.sin(one.value), math.cos(one.value)) - one.value  # within half a turn
    draft.joints[one.name] = Joint(kind="revolute", bodies=one.parts, nodes=(one_end, other), hinges=hinges)


def _clear(draft: Draft, parts: Sequence[str], places: Sequence[Any], least: float) -> NDArray[np.float64]:
    """The first of some places that is clear of the nodes of some parts."""
    return np.asarray(next((place for place in places if draft.clear(place, parts, least)), places[0]))


def _measured(draft: Draft, one: Connection, place: Any, reach: float) -> tuple[str, str]:
    """Nodes at one distance from the axis, one in each body, at one place where the value of the joint is 0."""
    aside = np.eye(3)[int(np.argmin(np.abs(one.axis)))]
    aside = np.cross(one.axis, np.cross(aside, one.axis))
    aside *= reach / float(np.linalg.norm(aside))
    first, second = one.parts
    pairs = [tuple(place + turn_about(one.axis, turn + by) @ aside for by in (0.0, one.value)) for turn in TURNS]
    least = CLEAR * reach
    fits = (pair for pair in pairs if draft.clear(pair[0], (first,), least) and draft.clear(pair[1], (second,), least))
    zero, turned = next(fits, pairs[0])
    return draft.share(f"{one.name}.zero", zero, (first,)), draft.share(f"{one.name}.turned", turned, (second,))


def slid(draft: Draft, one: Connection, parts: Mapping[str, Part]) -> None:
    """Sarrus' linkage between two triangles, one in each part, and the bar whose length is the travel if anything acts on it.

    Its place along and about the axis is free. It reaches twice as far as the file allows, or, without limits there, as the
    robot measures.
    """
    travel = 0.0 if one.limits is None else max(one.limits[1] - one.value, one.value - one.limits[0])
    size = SPARE * travel if 0 < travel < math.inf else draft.size
    if not 0 < travel < math.inf:
        low, high = one.value - size, one.value + size
        draft.notes.append(f"slider {one.name} can go from {low:.4g} m to {high:.4g} m: the file gives no limits")
    local = sarrus_places(size, size, size, APEX * size)
    least = CLEAR * REACH * min(extent(parts[name], draft.size) for name in one.parts)
    frames = [_frame(one.axis, turn) for turn in TURNS]
    spots = [one.place + shift * size * one.axis for shift in SHIFTS]
    fits = ((spot, frame) for spot in spots for frame in frames if _fits(draft, one.parts, local, spot, frame, least))
    spot, frame = next(fits, (spots[0], frames[0]))
    places = {key: spot + frame @ at for key, at in local.items()}
    low_end, high_end = one.parts
    node = {key: draft.share(f"{one.name}.{key}", places[key], (low_end,)) for key in LOW}
    node |= {key: draft.share(f"{one.name}.{key}", places[key], (high_end,)) for key in HIGH}
    node |= {key: draft.add(f"{one.name}.{key}", place) for key, place in places.items() if key not in node}
    # with a rigid triangle on top, one of the 32 bars is redundant; bars within a body are added by its bracing
    pairs = [pair for pair in SARRUS_BARS if pair != ("N2", "K") and not set(pair) <= set(HIGH)]
    bars = {f"{one.name}.{a}-{b}": Bar(ends=(node[a], node[b]), mass=0.0) for a, b in pairs}
    slide = node["B"], node["G"]
    draft.bars |= bars
    draft.joints[one.name] = Joint(
        kind="prismatic", bodies=one.parts, nodes=tuple(node.values()), bars=tuple(bars), slide=slide
    )
    if one.measured:
        name = one.drive or f"{one.name}.travel"
        draft.bars[name] = Bar(ends=slide, kind="driven" if one.drive is not None else "free", mass=0.0)
        draft.coordinates[one.name] = LengthDrive(name)
        draft.offsets[one.name] = math.dist(draft.places[slide[0]], draft.places[slide[1]]) - one.value


LOW, HIGH = ("B", "E", "F"), ("G", "H", "K")
"""Nodes of the linkage in the first part and in the second."""


def _frame(axis: Any, turn: float) -> NDArray[np.float64]:
    """Columns: across, along the axis, the third, right-handed; turned about the axis."""
    aside = np.eye(3)[int(np.argmin(np.abs(axis)))]
    x = aside - (aside @ axis) * axis
    x = turn_about(axis, turn) @ (x / np.linalg.norm(x))
    return np.column_stack([x, axis, np.cross(x, axis)])


def _fits(draft: Draft, parts: Sequence[str], local: Mapping[str, Any], spot: Any, frame: Any, least: float) -> bool:
    return all(
        draft.clear(spot + frame @ local[key], (part,), least)
        for part, keys in zip(parts, (LOW, HIGH), strict=True)
        for key in keys
    )


def measured(draft: Draft, name: str) -> None:
    """The joint with its angle between a node of each body off the axis, if it is a hinge on which nothing acts."""
    joint = draft.joints[name]
    if joint.kind != "revolute" or joint.hinges:
        return
    place, other = (draft.at(node) for node in joint.nodes)
    along = (other - place) / float(np.linalg.norm(other - place))
    start, end = (_aside(draft, body, place, along) for body in joint.bodies)
    if start is not None and end is not None and start != end:
        draft.joints[name] = joint.with_(hinges=(Hinge(axis=joint.nodes, start=start, end=end),))


def _aside(draft: Draft, part: str, place: Any, along: Any) -> str | None:
    """The node of a part farthest from an axis."""
    names = draft.own[part]
    if not names:
        return None
    way = np.array([draft.places[name] for name in names]) - place
    off = np.linalg.norm(way - np.outer(way @ along, along), axis=1)
    best = int(np.argmax(off > off.max() * (1 - 1e-9)))
    return names[best] if off[best] > 1e-6 else None


# The body of each rigid part: the nodes that carry its mass, and further nodes where bars alone would not hold it.

ROUND = 1e-6
"""Difference of the two cross moments of a rod, relative to their mean, that still counts as none."""
THIN = 1e-9
"""A body has no extent in a direction if the second moment is below this fraction of the largest."""
WIDE, GOOD = 0.5, 0.05
"""Least distance of own nodes that carry a mass, over the radius of gyration, and least normalised area or volume."""
THICK = 0.1
"""Least thickness of the carrying tetrahedron over its length; the mass matrix is exact for any thickness."""
APART, FACTORS = 0.01, (1.0, 1.25, 0.8, 1.4, 0.7, 1.7, 0.55, 2.1)
"""Least distance of a carrier from other nodes, over that from the centre, and factors of its distance from the centre."""
CORNERS = np.sqrt(3.0) * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
"""Alternate corners of a cube whose second moments are 1 if a quarter of the mass is at each."""


def body_of(draft: Draft, part: Part) -> Body | None:
    """The body of a part; None if it has neither mass nor nodes, or is a single point."""
    given = part.properties
    if given is not None and float(np.trace(given.inertia)) <= NOTHING * given.mass * draft.size**2:
        text = "the link has mass without inertia: its mass is at one node"
        draft.left += [LeftOut("inertia", part.where, text)] * bool(given.inertia.any() or given.mass)
        node = draft.share(f"{part.name}.mass", given.center, (part.name,))
        draft.masses[node] = draft.masses.get(node, 0.0) + given.mass
        given = None
    names = draft.own[part.name]
    if len(names) == 2 and part.balls_only and (given is None or _round(draft, names, given)):
        text = "turns freely about the line of its two balls; it is carried by the two nodes without that turning"
        draft.left.append(LeftOut("spin", part.where, text))
        return Body(nodes=tuple(names), carriers=tuple(names), **_mass(draft, names, given))
    if given is None and not _reaching(draft, part):
        return None
    carriers = () if given is None else _carriers(draft, part.name, given)
    _braced(draft, part.name, least=3 if given is None else 0)
    carriers = carriers or _spanning({name: draft.at(name) for name in names})
    fields = {} if given is None else _fields(given)
    return Body(nodes=(*carriers, *(name for name in names if name not in carriers)), carriers=carriers, **fields)


def _fields(given: MassProperties) -> dict[str, Any]:
    return {"mass": given.mass, "center": tuple(given.center.tolist()), "inertia": given.inertia.tolist()}


def _mass(draft: Draft, names: Sequence[str], given: MassProperties | None) -> dict[str, Any]:
    """Mass properties of a rod on two nodes, without its moment about their line."""
    if given is None:
        return {}
    along = draft.at(names[1]) - draft.at(names[0])
    across = np.eye(3) - np.outer(along, along) / float(along @ along)
    return _fields(given) | {"inertia": (0.5 * float(np.trace(across @ given.inertia)) * across).tolist()}


def _round(draft: Draft, names: Sequence[str], given: MassProperties) -> bool:
    """True if a mass is alike all round the line of two nodes."""
    a, b = (draft.at(name) for name in names)
    along = (b - a) / float(np.linalg.norm(b - a))
    across = np.eye(3) - np.outer(along, along)
    moment = 0.5 * float(np.trace(across @ given.inertia))
    rest = across @ given.inertia @ across - moment * across
    crossed = float(np.abs(given.inertia @ along - (along @ given.inertia @ along) * along).max())
    off = float(np.linalg.norm(across @ (given.center - a)))
    return off <= SAME * draft.size and max(float(np.abs(rest).max()), crossed) <= ROUND * moment


def _carriers(draft: Draft, name: str, given: MassProperties) -> tuple[str, ...]:
    """Own nodes that carry a mass, or new ones: two of a rod on its line, three of a plate in its plane, else four."""
    values, axes = np.linalg.eigh(second_moments(given.inertia))
    values, axes = values[::-1], axes[:, ::-1] * np.sign(axes[np.abs(axes).argmax(axis=0), np.arange(3)])[::-1]
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    count = int(np.sum(values > THIN * values[0])) + 1
    reach = math.sqrt(values[0] / given.mass)
    off = {key: np.abs((draft.at(key) - given.center) @ axes[:, count - 1 :]) for key in draft.own[name]}
    within = {key: draft.at(key) for key, far in off.items() if (far <= SAME * draft.size).all()}
    if len(within) >= count:
        own = _spanning(within)[:count]
        points = np.array([within[key] for key in own])
        wide = float(np.linalg.norm(np.ptp(points, axis=0))) > WIDE * min(reach, draft.size)
        if len(own) == count and wide and quality(points) > GOOD:
            return own
    # the mass matrix is exact for any carriers: these neither stand close to each other nor far outside the robot
    spread = np.clip(np.sqrt(np.maximum(values, 0.0) / given.mass), LEAST * draft.size / 4, 2 * draft.size)
    spread = np.maximum(spread, THICK * spread[0])
    turns = np.pi / 2 + 2 * np.pi / 3 * np.arange(3)
    triangle = np.sqrt(8.0) * np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    local = {2: np.sqrt(3.0) * np.array([[-1.0, 0, 0], [1.0, 0, 0]]), 3: triangle, 4: CORNERS}[count]
    ways = (local * spread) @ axes.T
    others = np.array([draft.places[key] for key in draft.own[name]])
    factor = next((one for one in FACTORS if _apart(given.center + one * ways, others, APART * spread[0])), 1.0)
    new = tuple(draft.add(f"{name}.{k + 1}", place) for k, place in enumerate(given.center + factor * ways))
    draft.own[name] += new
    return new


def _apart(places: Any, others: Any, least: float) -> bool:
    return not len(others) or float(np.linalg.norm(places[:, None] - others[None], axis=2).min()) > least


def _reaching(draft: Draft, part: Part) -> bool:
    """Give a part without mass two more nodes beside a single one, for its joint; False if it is no body but a point."""
    own = draft.own[part.name]
    if len(own) == 1 and part.joints:
        reach = REACH * extent(part, draft.size)
        own += [draft.add(f"{part.name}.{k + 1}", draft.at(own[0]) + reach * along) for k, along in enumerate(np.eye(3)[:2])]
    return len(own) > 1


def _braced(draft: Draft, name: str, least: int) -> None:
    """Nodes beside those of a part that lie in one plane or on one line: bars hold them there to second order only.

    least : number of nodes that a part needs to have a direction.
    """
    own = draft.own[name]
    more = beside(np.array([draft.places[key] for key in own]), 3)
    if len(own) > max(4 - len(more), least - 1) or 4 - len(more) < least:
        own += [draft.add(f"{name}.apex{k + 1 if k else ''}", place) for k, place in enumerate(more)]


def _spanning(places: Mapping[str, Any]) -> tuple[str, ...]:
    """Nodes that span what all of them span, chosen one by one by their distance from those before."""
    names = list(places)
    points = np.array(list(places.values()))
    away = points - points[0]
    first = float(np.linalg.norm(away, axis=1).max(initial=0.0))
    chosen = [0]
    while len(chosen) < 4:
        far = np.linalg.norm(away, axis=1)
        best = int(np.argmax(far >= far.max() * (1 - 1e-9)))
        if far[best] <= 1e-9 * first or best in chosen:
            break
        chosen.append(best)
        row = away[best] / far[best]
        away = away - np.outer(away @ row, row)
    return tuple(names[k] for k in chosen)
