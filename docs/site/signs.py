"""Signs of machine elements in SVG, as textbooks draw them, of a model small enough to be read at a glance.

A sign has one size on paper, whatever the size of the model. Places are (2,) arrays on paper, y down.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from pen import BODY, FAINT, INK, Pen, across, by, unit
from scipy.spatial import ConvexHull

import kinetruss as kt
from kinetruss.display import DRIVEN, ELASTIC, KINDS, LOAD
from kinetruss.report.pictures.stands import projected

WIDE, HIGH = 230.0, 150.0
"""Space for the nodes of the model."""
MOST = np.array([300.0, 230.0])
"""Space for all of the picture."""
SIDES = [np.array(way, float) for way in ((0, 1), (-1, 0), (1, 0), (0, -1))]
"""Where a support may stand: below its node first."""


def drawn(model: kt.Model) -> str:
    """The SVG of a model in the plane or in space."""
    sheet = _Sheet(model)
    over = float(np.max(np.ptp(sheet.box, axis=0) / MOST))
    return (sheet if over <= 1 else _Sheet(model, 1 / over)).text()


class _Sheet(Pen):
    """A model on paper: what has been drawn, from back to front, and the signs that draw on it."""

    def __init__(self, model: kt.Model, smaller: float = 1.0) -> None:
        super().__init__()
        self.model = model
        self.reach: dict[str, float] = {}  # of the signs of nodes that are larger than a pin
        self.taken: dict[str, list[Any]] = {}  # by node, the ways on which something is drawn
        flat = {name: projected(np.array(node.at, float)) for name, node in model.nodes.items() if node.at and not node.scalar}
        at = np.array(list(flat.values()))
        size = np.maximum(np.ptp(at, axis=0), 1e-9)
        self.scale = smaller * float(min(WIDE / size[0], HIGH / size[1]))
        self.at = {name: np.array([x, -y]) * self.scale for name, (x, y) in flat.items()}
        self.ends = {
            **{name: bar.ends for name, bar in model.bars.items()},
            **{name: one.ends for name, one in model.active.items()},
        }
        self.pairs = [*self.ends.values(), *(beam.ends for beam in model.beams.values())]
        self.pairs += [pair for link in model.links.values() for pair in zip(link.nodes, link.nodes[1:], strict=False)]
        self.pairs += [one.nodes for one in model.cylinders.values()]
        self.pairs += [one.coordinate.nodes for one in model.springs.values() if one.coordinate.kind == "distance"]
        self._all()

    def _all(self) -> None:
        for part in (self._bodies, self._members, self._couplings, self._springs, self._stops, self._drives, self._supports,
                     self._nodes, self._loads, self._names):  # fmt: skip
            part()

    def _bodies(self) -> None:
        rolling = self._rolling()
        for body in self.model.bodies.values():
            if rolling & set(body.nodes):
                continue
            points = np.array([self.at[node] for node in body.nodes])
            middle = points.mean(axis=0)
            if self.model.dim == 2 and body.center is not None:
                low = np.array([node.at for node in (self.model.nodes[name] for name in body.nodes)])
                shift = np.subtract(body.center, low.mean(axis=0)) * self.scale
                middle = middle + by(shift[0], -shift[1])
                points = np.vstack([points, middle])
            angles = np.linspace(0, 2 * math.pi, 40, endpoint=False)
            margin = 15.0 if self.model.dim == 2 else 0.1
            for node in body.nodes:
                self.taken.setdefault(node, []).append(unit(middle - self.at[node]))
            around = (points[:, None] + margin * np.stack([np.cos(angles), np.sin(angles)], axis=-1)).reshape(-1, 2)
            self.path(_hull(around), 0, closed=True, fill=BODY, stroke=FAINT, stroke_width=1)
            if self.model.dim == 2:
                self.circle(middle, 4, 0, fill="#ffffff", stroke_width=1)
                self.path([middle - by(4, 0), middle + by(4, 0)], 0, stroke_width=1)
                self.path([middle - by(0, 4), middle + by(0, 4)], 0, stroke_width=1)
            if self.model.dim == 3:
                for a, b in itertools.combinations(body.nodes, 2):
                    self.path([self.at[a], self.at[b]], 0, stroke=FAINT, stroke_width=0.8)
        for axis in self._axes():
            a, b = (self.at[node] for node in axis)
            way = unit(b - a)
            self.path([a - 18 * way, b + 18 * way], 3, stroke_dasharray="9 3 2 3", stroke_width=1.4)

    def _axes(self) -> list[tuple[str, str]]:
        """Pairs of nodes in space about which something turns."""
        found = [hinge.axis for joint in self.model.joints.values() for hinge in joint.hinges if len(hinge.axis) == 2]
        found += [drive.axis for drive in self.model.drives.values() if drive.kind == "hinge"]
        if self.model.dim == 3 and not found:
            for body in self.model.bodies.values():
                held = [node for node in body.nodes if node in self.model.fixed]
                found += [tuple(held)] if len(held) == 2 else []
        return found

    def _rolling(self) -> set[str]:
        """Hubs of wheels that roll: an angle coupled with the path of its own first node."""
        found = set()
        for coupling in self.model.couplings.values():
            angles = {self.ends[one.bar][0] for one, _ in coupling.terms if one.kind == "angle"}
            found |= angles & {one.node for one, _ in coupling.terms if one.kind == "coordinate"}
        return found

    def _members(self) -> None:
        model = self.model
        for name, bar in model.bars.items():
            if not model.joints:  # bars of joints by name are not drawn
                self._bar(name, bar)
        for beam in model.beams.values():
            self.path([self.at[end] for end in beam.ends], stroke=ELASTIC, stroke_width=3.4)
        for link in model.links.values():
            colour, points = ELASTIC if link.kind == "elastic" else INK, [self.at[node] for node in link.nodes]
            closed = link.nodes[0] == link.nodes[-1]
            self.path(points, stroke=colour, stroke_width=3.4, **({"fill": BODY} if closed else {}))
        for one in model.active.values():
            a, b = (self.at[end] for end in one.ends)
            self.screw(a + 0.5 * (b - a), b)
            self.cylinder(a, a + 0.8 * (b - a), DRIVEN)
            self._motor(a + 0.2 * (b - a) + 17 * across(unit(b - a)))
        for ram in model.cylinders.values():
            self.cylinder(*(self.at[node] for node in ram.nodes))

    def _bar(self, name: str, bar: kt.Bar) -> None:
        """By its kind; a free bar as what acts on its length."""
        model, (a, b) = self.model, (self._tip(end, name) for end in bar.ends)
        turned = any(getattr(drive, "bar", None) == name for drive in model.drives.values())
        pressed = any(
            getattr(stop.coordinate, "bar", None) == name and stop.coordinate.kind == "length" for stop in model.stops.values()
        )
        roped = any(term == kt.LengthDrive(name) for one in model.couplings.values() for term, _ in one.terms)
        if bar.kind == "cable":
            self.path([a, b], stroke=KINDS["cable"], stroke_dasharray="7 3", stroke_width=1.8)
        elif bar.kind == "elastic":
            self.coil(a, b)
        elif bar.kind == "driven":
            self.cylinder(a, b, DRIVEN)
        elif bar.kind == "free" and bar.damping:
            self.dashpot(a, b)
        elif bar.kind == "free" and pressed:
            self._plates(a, b)
        elif bar.kind == "free" and not roped:
            self.path([a, b], stroke=FAINT, stroke_dasharray="1.5 4")
        elif bar.kind == "rigid":
            self.path([a, b], stroke=DRIVEN if turned else INK, stroke_width=3.2 if turned else 2.4)

    def _tip(self, node: str, bar: str) -> Any:
        """Where a bar ends: at its node, or at the arm of a hub."""
        hub = self.model.hubs.get(node)
        arm = np.atleast_1d(np.array(hub.arms[bar], float)) if hub is not None and bar in hub.arms else np.zeros(2)
        return self.at[node] + np.array([arm[0], -arm[-1]]) * self.scale

    def _plates(self, a: Any, b: Any) -> None:
        """Two plates that press on each other, and may part."""
        side, lower = 9 * across(unit(b - a)), a + 0.45 * (b - a)
        upper = lower + 5 * unit(b - a)
        for end, plate in ((a, lower), (b, upper)):
            self.path([end, plate], stroke_width=2.4)
            self.path([plate - side, plate + side], stroke_width=2.4)

    def _couplings(self) -> None:
        for coupling in self.model.couplings.values():
            if self.model.joints:
                continue
            terms = [(one, float(factor)) for one, factor in coupling.terms]
            kinds = sorted(one.kind for one, _ in terms)
            if kinds == ["angle"] * len(kinds):
                self._wheels(terms)
            elif kinds == ["angle", "coordinate"]:
                self._rack(terms)
            elif kinds == ["length"] * 2:
                self._rope(terms)
            elif kinds == ["offset"]:
                (one, _) = terms[0]
                way = unit(self.at[one.line[1]] - self.at[one.line[0]])
                at, side = self.at[one.point], 7 * across(way)
                corners = [at + s * 12 * way + t * side for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                self.path(corners, 2, closed=True, fill="#ffffff")
                self.taken.setdefault(one.point, []).extend((way, -way))
                self.reach[one.point] = 21

    def _wheels(self, terms: list[tuple[Any, float]]) -> None:
        """Gear wheels that touch, or a belt; three: wheels on a carrier."""
        centres = [self.at[self.ends[one.bar][0]] for one, _ in terms]
        if len(terms) == 3:
            (a, b, c) = centres
            for centre, share in ((a, 0.3), (b, 0.3), (c, 0.2)):
                self.teeth(centre, share * float(np.linalg.norm(a - b)))
            self.path([a, b], 0, stroke=FAINT, stroke_dasharray="4 3")
            return
        (a, b), (f, g) = centres, (factor for _, factor in terms)
        apart, belt = float(np.linalg.norm(b - a)), f * g < 0
        whole = abs(f) + abs(g)
        r, s = (apart * (0.5 if belt else 1.0) * abs(one) / whole for one in (f, g))
        for centre, radius in ((a, r), (b, s)):
            if belt:
                self.circle(centre, radius, 0, stroke=FAINT)
            else:
                self.teeth(centre, radius)
        if belt:
            way = unit(b - a)
            for side in (1, -1):
                lean = (r - s) / apart
                out = side * math.sqrt(1 - lean**2) * across(way) + lean * way
                self.path([a + r * out, b + s * out], 0, stroke=KINDS["cable"], stroke_width=2.4)

    def _rack(self, terms: list[tuple[Any, float]]) -> None:
        """A wheel on a straight line: a rack, a wheel that rolls, or a screw where the ratio is large."""
        (angle, turn), (shift, path) = sorted(terms, key=lambda term: term[0].kind)
        centre, slider = self.at[self.ends[angle.bar][0]], self.at[shift.node]
        radius = abs(turn / path) * self.scale
        if radius < 5:
            self.screw(centre, slider, INK)
            self.turning(centre, 22, 2.2, 2.0, stroke=FAINT)
            self.reach |= {shift.node: 24, self.ends[angle.bar][0]: 26}
            self.taken.setdefault(shift.node, []).append(unit(centre - slider))
            self.taken.setdefault(self.ends[angle.bar][0], []).append(unit(slider - centre))
            self.path(
                [slider + p for p in np.array([[-11, -13], [11, -13], [11, 13], [-11, 13]])], 2, closed=True, fill="#ffffff"
            )
            return
        rolls = shift.node == self.ends[angle.bar][0]
        level = centre[1] + radius
        if rolls:
            self.circle(centre, radius, 0, fill=BODY)
            self.path([(centre[0] - radius - 25, level), (centre[0] + radius + 25, level)], 0)
            self.arrow(centre - by(0, radius + 12), centre + by(34, -radius - 12), stroke=FAINT)
            return
        self.teeth(centre, radius)
        rack = {"stroke": FAINT, "stroke_dasharray": "5", "stroke_width": 6, "stroke_linecap": "butt"}
        self.path([(slider[0], level + 3), (centre[0] + radius + 30, level + 3)], 0, **rack)
        self.path([(slider[0], level + 7), (centre[0] + radius + 30, level + 7)], 0, stroke_width=2.4)

    def _rope(self, terms: list[tuple[Any, float]]) -> None:
        """A pulley where both lengths meet, or two cylinders in step."""
        (one, f), (other, g) = terms
        ends, others = set(self.ends[one.bar]), set(self.ends[other.bar])
        for bar in (one.bar, other.bar):
            a, b = (self.at[end] for end in self.ends[bar])
            if ends & others:
                self.path([a, b], 0, stroke=KINDS["cable"], stroke_width=1.8)
            else:
                self.cylinder(a, b)
        if shared := ends & others:
            node = shared.pop()
            at = self.at[node]
            self.reach[node] = 24
            self.circle(at, 15, 2, fill="#ffffff", stroke_width=2)
            for bar, factor in ((one.bar, f), (other.bar, g)):
                if abs(factor) > 1:
                    a, b = (self.at[end] for end in self.ends[bar])
                    for k in range(1, int(abs(factor))):
                        self.path([a + by(8 * k, 0), b + by(8 * k, 0)], 0, stroke=KINDS["cable"], stroke_width=1.8)
                    self.circle(b, 9, 2, fill="#ffffff", stroke_width=2)
            return
        middles = [0.5 * (self.at[a] + self.at[b]) for a, b in (self.ends[one.bar], self.ends[other.bar])]
        self.path([middles[0] + by(12, 0), middles[1] - by(12, 0)], 0, stroke=FAINT, stroke_dasharray="5 3")
        self.words(sum(middles) / 2 - by(0, 9), "=")

    def _springs(self) -> None:
        for spring in self.model.springs.values():
            one = spring.coordinate
            if one.kind == "distance":
                self.coil(*(self.at[node] for node in one.nodes))
            elif one.kind == "length":
                self.coil(*(self.at[end] for end in self.ends[one.bar]))
            elif one.kind == "angle":
                self._spiral(self.ends[one.bar][0])

    def _spiral(self, node: str) -> None:
        at = self.at[node]
        self.reach[node] = 31
        turn = np.linspace(0, 4.5 * math.pi, 60)
        self.path([at + (6 + 1.1 * a) * np.array([math.cos(a), -math.sin(a)]) for a in turn], 2, stroke=ELASTIC)

    def _stops(self) -> None:
        for stop in self.model.stops.values():
            one = stop.coordinate
            if one.kind == "angle":
                at = self.at[self.ends[one.bar][0]]
                for angle, side in ((stop.lower, 1), (stop.upper, -1)):
                    if angle is not None:
                        way = np.array([math.cos(angle), -math.sin(angle)])
                        out = side * np.array([math.sin(angle), math.cos(angle)])
                        self.path([at + 8 * way, at + 62 * way], 0, stroke=FAINT, stroke_dasharray="4 3", stroke_width=1)
                        self.ground(at + 52 * way, out, 10)
            elif one.kind == "coordinate":
                at, level = self.at[one.node], stop.lower if stop.lower is not None else stop.upper
                k = "xyz".index(one.axis)
                shift = (level - self.model.nodes[one.node].at[k]) * self.scale
                place = at + ([shift, 0] if k == 0 else [0, -shift])
                self.ground(place, unit(place - at), 34)

    def _motor(self, at: Any) -> None:
        self.circle(at, 9, 3, fill="#ffffff", stroke=DRIVEN, stroke_width=2)
        self.words(at, "M", fill=DRIVEN)

    def _drives(self) -> None:
        for drive in self.model.drives.values():
            if drive.kind == "angle":
                a, b = (self.at[end] for end in self.ends[drive.bar])
                start = math.atan2(-(b - a)[1], (b - a)[0])
                if drive.gear is None:
                    self.turning(a, 24, start + 0.35, 1.9, stroke=DRIVEN, stroke_width=2)
                else:
                    self.turning(a, 46, start - 0.25, 0.55, stroke=DRIVEN, stroke_width=2)
                    self.teeth(a, 19, DRIVEN)
                    self.reach[self.ends[drive.bar][0]] = 31
                    self.teeth(a - by(0, 27), 8, DRIVEN)
                    self._motor(a - by(24, 27))
                    self.path([a - by(15, 27), a - by(0, 27)], 3, stroke=DRIVEN, stroke_width=2)
            elif drive.kind == "hinge":
                low, high = (self.at[node] for node in drive.axis)
                self.turning(0.5 * (low + high), 17, -2.9, 4.6, stroke=DRIVEN, stroke_width=2)
            elif drive.kind == "coordinate":
                at = self.at[drive.node]
                way = np.array([1.0, 0.0]) if drive.axis == "x" else np.array([0.0, -1.0])
                self.arrow(at + 8 * way, at + 42 * way, stroke=DRIVEN, stroke_width=2)

    def _held(self) -> Iterator[tuple[str, dict[str, Any], float]]:
        """Node, what holds it in x, y (and r), and by which angle its support is turned."""
        for name, axes in self.model.fixed.items():
            yield name, dict.fromkeys(axes, "held"), 0.0
        for name in self.model.clamped:
            yield name, dict.fromkeys("xyr", "held"), 0.0
        for name, one in self.model.supports.items():
            ways = {"x": one.x, "y": one.y, "r": one.rotation}
            yield name, {key: value for key, value in ways.items() if value is not None}, float(one.turned)

    def _away(self, node: str, ways: Iterable[Any]) -> Any:
        """The way out of a node that is farthest from its members, the first of equals."""
        own = [unit(self.at[b if a == node else a] - self.at[node]) for a, b in self.pairs if node in (a, b)]
        best = min(ways, key=lambda way: round(max((float(one @ way) for one in own), default=0.0), 1))
        self.taken.setdefault(node, []).append(best)
        return best

    def _supports(self) -> None:
        rolling, axes = self._rolling(), {node for axis in self._axes() for node in axis}
        for node, held, turned in self._held():
            if node in rolling or (self.model.joints and node not in axes):
                continue
            at = self.at[node]
            rigid = {key for key, one in held.items() if one == "held" or (one.stiffness is None and not one.settlement)}
            soft = {key: one for key, one in held.items() if key not in rigid}
            if self.model.dim == 3:
                self.path([at, at + np.array([9, 14]), at + np.array([-9, 14])], 2, closed=True, fill="#ffffff")
                self.taken.setdefault(node, []).append(SIDES[0])
                continue
            if {"x", "y", "r"} <= rigid:
                self.ground(at, self._away(node, SIDES), 17)
                self.reach[node] = 26
                continue
            if {"x", "y"} <= rigid:
                self._triangle(at, self._away(node, SIDES))
            elif rigid & {"x", "y"}:
                (axis,) = rigid & {"x", "y"}
                turn = np.array([[math.cos(turned), math.sin(turned)], [-math.sin(turned), math.cos(turned)]])
                way = turn @ (np.array([1.0, 0.0]) if axis == "x" else np.array([0.0, 1.0]))
                self._triangle(at, self._away(node, (way, -way)), rolls=True)
            for axis, one in soft.items():
                if axis == "r":
                    self._spiral(node)
                else:
                    self._soft(node, axis, one)

    def _triangle(self, at: Any, out: Any, rolls: bool = False) -> None:
        side = across(out)
        self.path([at, at + 15 * out + 10 * side, at + 15 * out - 10 * side], 2, closed=True, fill="#ffffff")
        if rolls:
            for k in (-5, 5):
                self.circle(at + 18.5 * out + k * side, 3, 2, fill="#ffffff", stroke_width=1.2)
        self.ground(at + (22 if rolls else 15) * out, out, 14)

    def _soft(self, node: str, axis: str, one: Any) -> None:
        """A spring to the ground, a gap or a settlement along an axis."""
        at = self.at[node]
        way = np.array([1.0, 0.0]) if axis == "x" else np.array([0.0, 1.0])
        out = self._away(node, (way, -way))
        side = across(out)
        if one.gap is not None:
            self._triangle(at, out)
            self.arrow(at + 12 * side + 10 * out, at + 12 * side - 20 * out, stroke=FAINT)
        elif one.settlement:
            self._triangle(at, out, rolls=True)
            down = np.array([1.0, 0.0]) if axis == "x" else np.array([0.0, -1.0])
            self.arrow(
                at + 22 * side + 4 * out, at + 22 * side + 4 * out + 30 * math.copysign(1, one.settlement) * down, stroke=LOAD
            )
        else:
            apart = 9 if one.damping else 0
            end = at + 38 * out
            self.path([at - apart * side, at + apart * side], 2)
            self.coil(at - apart * side, end - apart * side, 2)
            if one.damping:
                self.dashpot(at + apart * side, end + apart * side, 2)
            self.ground(end, out, 18)

    def _nodes(self) -> None:
        """Masses; pins, where more than one thing is joined; squares where members are stiff at an angle."""
        model = self.model
        held = {*model.fixed, *model.supports}
        welds = [node for link in model.links.values() for node in link.weld]
        stiff = [end for beam in model.beams.values() for end in beam.ends if end not in beam.release] + welds
        joined = [
            *(end for ends in self.ends.values() for end in ends),
            *(node for one in model.cylinders.values() for node in one.nodes),
        ]
        joined += [node for link in model.links.values() for node in set(link.nodes)]
        joined += [end for beam in model.beams.values() for end in beam.ends]
        joined += [node for one in model.springs.values() if one.coordinate.kind == "distance" for node in one.coordinate.nodes]
        joined += [node for body in model.bodies.values() for node in body.nodes]
        for name, at in self.at.items():
            if model.nodes[name].mass and model.dim == 2:
                self.circle(at, 8, 3, fill=INK)
                self.reach[name] = 21
            elif name in model.hubs:
                self._hub(name, model.hubs[name])
            elif model.dim == 3:
                if name not in held and not model.joints:
                    self.circle(at, 2, 3, fill=INK)
            elif name in model.clamped:
                pass
            elif stiff.count(name) > 1 and stiff.count(name) == joined.count(name):
                if self._bends(name):
                    self.path([at + p for p in np.array([[-4, -4], [4, -4], [4, 4], [-4, 4]])], 3, closed=True, fill=INK)
                elif name in held:
                    self.circle(at, 4, 3, fill="#ffffff")
            elif name in held or joined.count(name) > 1:
                self.circle(at, 4, 3, fill="#ffffff")
            if any(one.node == name for one in model.bearings.values()):
                self.circle(at, 11, 2, stroke_width=2)
                self.reach[name] = 21
                self.turning(at, 19, 0.6, 1.6, stroke=LOAD)

    def _bends(self, node: str) -> bool:
        """Whether members that meet there are not in one line."""
        own = [unit(self.at[b if a == node else a] - self.at[node]) for a, b in self.pairs if node in (a, b)]
        return any(abs(float(one @ across(own[0]))) > 0.1 for one in own)

    def _hub(self, name: str, hub: Any) -> None:
        for bar in hub.arms:
            tip = self._tip(name, bar)
            self.path([self.at[name], tip], 2, stroke_width=6)
            self.circle(tip, 4, 3, fill="#ffffff")

    def _loads(self) -> None:
        for load in self.model.loads.values():
            if getattr(load, "node", None) is not None and load.force is not None:
                at, way = self.at[load.node], unit(projected(np.array(load.force, float)))
                way = np.array([way[0], -way[1]])
                begins = self._away(load.node, (way, -way)) is way  # else it ends at its node
                start = at + 6 * way if begins else at - 42 * way
                self.arrow(start, start + 36 * way, stroke=LOAD, stroke_width=2)

    def _names(self) -> None:
        """Names of nodes, on the side that members, supports and loads leave free."""
        ways = [unit(way) for way in ((-1, -1), (1, -1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (0, 1))]
        for name, at in self.at.items():
            if "." in name:
                continue  # of a joint
            own = [unit(self.at[b if a == name else a] - at) for a, b in self.pairs if name in (a, b)] + self.taken.get(
                name, []
            )
            best = min(ways, key=lambda way: round(max((float(one @ way) for one in own), default=0.0), 2))
            self.words(at + self.reach.get(name, 15.0) * best, name, fill=FAINT)


def _hull(points: Any) -> Any:
    return points[ConvexHull(points).vertices]
