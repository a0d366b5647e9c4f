"""A robot from a model: rigid parts as links, shared nodes as joints of a tree, the other shared nodes as closures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.of_laws import Place, Turn, acting, armed, couplings_of, geared, length_spring, sprung, values_of
from kinetruss.exchange.rigid import masses_of, rigid_parts, rods_of
from kinetruss.exchange.robots import Closure, DrivenLength, LeftOut, Link, Pivot, Robot, RobotOfModel, placement
from kinetruss.model import GROUND, AngleDrive, HingeDrive, Model
from kinetruss.model.links import with_stiff_links

if TYPE_CHECKING:
    from numpy.typing import NDArray


TABLES = {
    "loads": "loads are not carried",
    "beams": "elastic beams are not carried",
    "membranes": "membranes are not carried",
    "solids": "solids are not carried",
    "bearings": "friction is not carried",
    "support_motion": "motions of supports are not carried",
    "load_cases": "loads are not carried",
    "conditions": "conditions are not carried",
    "velocities": "velocities at the start are not carried",
    "runs": "runs are not carried",
}


def robot_of_model(model: Model, position: Any = None) -> RobotOfModel:
    """The robot of a model. position (n, dim), m : the pose; by default that of the model."""
    model = with_stiff_links(model)
    nodes = model.whole.nodes
    x = np.zeros((len(nodes), 3))
    x[:, : model.dim] = [node.at for node in nodes.values()] if position is None else np.asarray(position)[:, : model.dim]
    return _Maker(model, x).drawn()


class _Maker:
    def __init__(self, model: Model, x: NDArray[np.float64]) -> None:
        self.given, self.model, self.x = model, model.whole, x
        self.place = {name: k for k, name in enumerate(self.model.nodes)}
        self.names = list(self.model.nodes)
        self.parts = rigid_parts(model, x)
        self.at: dict[int, list[int]] = {}
        for index, part in enumerate(self.parts):
            for node in part.nodes:
                self.at.setdefault(node, []).append(index)
        self.left = [
            LeftOut(table, one, why)
            for table, why in TABLES.items()
            for one, record in getattr(model, table).items()
            if table != "beams" or record.kind == "elastic"  # rigid ones are parts
        ]
        if model.base_rotation is not None:
            self.left.append(LeftOut("base_rotation", "model", "the base rests"))
        self.left += [
            LeftOut(f"{bar.kind} bar", name, "its force is not carried")
            for name, bar in model.bars.items()
            if bar.kind in ("elastic", "cable")
        ]
        for table, what in (("stops", "gap"), ("springs", "spring")):
            soft = dict.fromkeys(one.text(model.dim) for one in self.model.inner.holdings if one.table == table)
            self.left += [LeftOut("supports", one, f"its {what} is not carried: nothing holds the node there") for one in soft]
        self.pivots: list[Pivot] = []
        self.coordinates = acting(model)
        self.values = values_of(model, self.coordinates, x)
        self.places: dict[str, Place] = {}
        """Coordinates of drives, springs and couplings that are values of joints."""
        self.met: dict[int, dict[int, int]] = {node: {part: part for part in parts} for node, parts in self.at.items()}
        self.link = self._link_names()

    def _link_names(self) -> list[str]:
        taken = {"world"}  # the name of the ground in MJCF
        found = []
        for part in self.parts:
            name = part.name
            while name in taken:
                name += "_"
            taken.add(name)
            found.append(name)
        return found

    def drawn(self) -> RobotOfModel:
        properties, left = masses_of(self.given, self.x, self.parts)
        self.left += left
        turns = list(self._turns())
        self._tree(turns)
        start = values_of(self.given, self.coordinates, self._start())
        self.pivots = sprung(self.given, self.places, start, self.pivots, self.left)
        self.pivots = geared(self.given, self.pivots, self.left)
        drives = {one.drive: 0 for one in self.pivots if one.drive is not None}
        self.left += [
            LeftOut("drive", one.name, "its angle is at no joint of the tree, or measured from no part of it")
            for one in turns
            if one.driven and one.name not in drives
        ]
        lengths = [*self._lengths(), *self._springs(start)]
        links = {
            name: Link(name=name, properties=None if k == 0 else properties[k], where=name) for k, name in enumerate(self.link)
        }
        links |= {pivot.child: Link(name=pivot.child) for pivot in self.pivots if pivot.child not in links}
        gravity = self.model.gravity or (0.0, 0.0)
        robot = Robot(
            title=self.model.title or "model",
            root=GROUND,
            links=links,
            pivots=self.pivots,
            closures=list(self._closures()),
            couplings=couplings_of(self.given, self.places, self.left),
            gravity=(gravity[0], gravity[1], gravity[2] if len(gravity) == 3 else 0.0),
            left_out=self.left,
        )
        robot = armed(robot, {name for one in lengths for name in one.links})
        offsets = {name: place.value for name, place in self.places.items() if name in drives}
        offsets |= {one.name: one.length for one in lengths if one.driven}
        lines = {name: ends for name, ends in self._lines().items() if name in robot.links}
        return RobotOfModel(robot=robot, lengths=lengths, offsets=offsets, lines=lines)

    def _lines(self) -> dict[str, list[NDArray[np.float64]]]:
        found: dict[str, list[NDArray[np.float64]]] = {}
        for bar in self.model.bars.values():
            ends = [self.place[node] for node in bar.ends]
            if (part := self._part_of(ends)) is not None:
                found.setdefault(self.link[part], []).append(self.x[ends])
        return found

    def _start(self) -> NDArray[np.float64]:
        """Places of the nodes in the model, (n, 3) m."""
        x = np.zeros_like(self.x)
        x[:, : self.model.dim] = [node.at for node in self.model.nodes.values()]
        return x

    def _turns(self) -> Iterator[Turn]:
        """Angles of drives, springs and couplings, with the parts that they turn."""
        for name, one in self.coordinates.items():
            driven = name in self.model.drives
            if isinstance(one, HingeDrive):
                axis = tuple(self.place[node] for node in one.axis)
                first, second = (self._part_of((*axis, self.place[node])) for node in (one.start, one.end))
                along = np.array([0.0, 0.0, 1.0]) if len(axis) == 1 else self.x[axis[1]] - self.x[axis[0]]
            elif isinstance(one, AngleDrive) and one.bar in self.model.bars:
                ends = [self.place[node] for node in self.model.bars[one.bar].ends]
                first, second = 0, self._part_of(ends)
                along = np.array([0.0, 0.0, 1.0] if one.axis is None else one.axis, float)
                axis = tuple(node for node in ends if 0 in self.at.get(node, ()))
            else:
                if driven and one.kind != "length" and not self._guided(one):
                    self.left.append(LeftOut("drive", name, "prescribed coordinates are not carried: the node is held"))
                continue
            if first is None or second is None or first == second:
                if driven:
                    self.left.append(LeftOut("drive", name, "it turns no rigid part against another"))
                continue
            unit = along / np.linalg.norm(along)
            yield Turn(name, frozenset((first, second)), first, axis, unit, self.values[name], driven)

    def _guided(self, one: Any) -> bool:
        """True for a coordinate along which a support guides its node."""
        at = [part for part in self.parts if part.kind == "guide" and one.kind == "coordinate"]
        return any(self.place[one.node] in part.nodes and one.axis in part.axes for part in at)

    def _part_of(self, nodes: Sequence[int]) -> int | None:
        """The part that has all of some nodes."""
        return next((k for k, part in enumerate(self.parts) if set(nodes) <= set(part.nodes)), None)

    def _tree(self, turns: Sequence[Turn]) -> None:
        """Joints from the ground outwards: driven angles first, then hinges, then balls; parts out of reach float."""
        driven: dict[frozenset[int], list[Turn]] = {}
        for turn in sorted(turns, key=lambda one: not one.driven):
            driven.setdefault(turn.parts, []).append(turn)
        shared: dict[frozenset[int], list[int]] = {}
        for node, parts in sorted(self.at.items()):
            for pair in combinations(parts, 2):
                shared.setdefault(frozenset(pair), []).append(node)
        guides = {k for k, part in enumerate(self.parts) if part.kind == "guide"}
        rank = {
            pair: 4 * any(one.driven for one in driven.get(pair, ()))
            + 3 * bool(pair & guides)
            + 2 * (pair in driven)
            + (len(nodes) > 1 or self.model.dim == 2)
            for pair, nodes in shared.items()
        }
        for guide in sorted(guides):
            self._slide(guide)
        placed = {0} | guides
        while len(placed) < len(self.parts):
            ready = [pair for pair in shared if len(pair & placed) == 1]
            if ready:
                best = max(ready, key=lambda pair: rank[pair])
                (parent,), (child,) = best & placed, best - placed
                self._join(parent, child, shared[best], driven.get(best, ()))
            else:
                child = min(set(range(len(self.parts))) - placed)
                self._float(child)
            placed.add(child)

    def _slide(self, guide: int) -> None:
        """A node on a guide: slides along the axes that its support leaves free."""
        part = self.parts[guide]
        node, above = part.nodes[0], GROUND
        ends: dict[str, Any] = {"origin": placement(None, self.x[node]), "after": placement(None, -self.x[node])}
        for axis in part.axes:
            name = child = f"{self.link[guide]}.{axis}"
            if axis == part.axes[-1]:
                child = self.link[guide]
            own = [key for key, one in self.coordinates.items() if one.kind == "coordinate"]
            own = [key for key in own if (self.place[self.coordinates[key].node], self.coordinates[key].axis) == (node, axis)]
            drive = next((key for key in own if key in self.model.drives), None)
            along = np.eye(3)["xyz".index(axis)]
            slide = Pivot(name=drive or name, kind="prismatic", parent=above, child=child, axis=along, drive=drive, **ends)
            self.places |= {key: Place(slide.name, 1.0, self.values[key]) for key in own}
            self._add(slide)
            above = child

    def _float(self, child: int) -> None:
        middle, name = self.x[self.parts[child].nodes].mean(axis=0), self.link[child]
        ends: dict[str, Any] = {"origin": placement(None, middle), "after": placement(None, -middle)}
        self._add(Pivot(name=f"{name}.free", kind="free", parent=GROUND, child=name, **ends))

    def _add(self, pivot: Pivot) -> None:
        self.pivots.append(pivot)

    def _join(self, parent: int, child: int, shared: Sequence[int], turns: Sequence[Turn]) -> None:
        """A joint at shared nodes, which are then one; a rod at one node turns about two axes across itself."""
        own, above, name = self.link[child], self.link[parent], self.names[shared[0]]
        place = self.x[shared[0]]
        ends: dict[str, Any] = {"origin": placement(None, place), "after": placement(None, -place)}
        if self.model.dim == 2 or len(shared) > 1:
            along = np.array([0.0, 0.0, 1.0])
            if self.model.dim == 3:
                along = self.x[shared[-1]] - place
                along = along / np.linalg.norm(along)
            fits = [one for one in turns if set(one.axis) <= set(shared) and abs(abs(along @ one.along) - 1) < 1e-9]
            drive = next((one.name for one in fits if one.driven), None)
            if fits:
                along = fits[0].along if fits[0].first == parent else -fits[0].along
            pivot = Pivot(
                name=drive or f"{own}.{name}", kind="revolute", parent=above, child=own, axis=along, drive=drive, **ends
            )
            for one in fits:
                sign = float(np.sign(along @ one.along)) * (1.0 if one.first == parent else -1.0)
                self.places[one.name] = Place(pivot.name, sign, one.value)
            self._add(pivot)
        elif self.parts[child].kind == "rod":
            other = next(node for node in self.parts[child].nodes if node != shared[0])
            line = (self.x[other] - place) / np.linalg.norm(self.x[other] - place)
            across = np.cross(line, np.eye(3)[int(np.argmin(np.abs(line)))])
            across /= np.linalg.norm(across)
            cross = f"{own}.cross"
            self._add(Pivot(name=f"{own}.{name}.1", kind="revolute", parent=above, child=cross, axis=across, **ends))
            two = np.cross(line, across)
            self._add(Pivot(name=f"{own}.{name}.2", kind="revolute", parent=cross, child=own, axis=two, **ends))
        else:
            self._add(Pivot(name=f"{own}.{name}", kind="ball", parent=above, child=own, **ends))
        for node in shared if self.model.dim == 3 or len(shared) == 1 else shared[:1]:
            self._meet(node, parent, child)

    def _meet(self, node: int, one: int, two: int) -> None:
        """Note that two parts are held together at a node."""
        met = self.met[node]
        old, new = met[two], met[one]
        for part, head in met.items():
            met[part] = new if head == old else head

    def _closures(self) -> Iterator[Closure]:
        """Parts at a node that the tree does not hold together there."""
        for node, met in self.met.items():
            heads = list(dict.fromkeys(met.values()))
            for head in heads[1:]:
                place = placement(None, self.x[node])
                name = self.names[node] + (f".{self.link[head]}" if len(heads) > 2 else "")
                yield Closure(name=name, kind="ball", links=(self.link[heads[0]], self.link[head]), frames=(place, place))

    def _lengths(self) -> Iterator[DrivenLength]:
        """Driven bars and active members, these with the masses of their rods."""
        for name in sorted(self.model.driven_members):
            a, b = (self.place[node] for node in self.model.members[name].ends)
            if not self.at.get(a) or not self.at.get(b):
                self.left.append(LeftOut("drive", name, "an end belongs to no rigid part"))
                continue
            links = self.link[self.at[a][0]], self.link[self.at[b][0]]
            length = float(np.linalg.norm(self.x[b] - self.x[a]))
            yield DrivenLength(
                name=name,
                links=links,
                points=(self.x[a], self.x[b]),
                length=length,
                properties=rods_of(self.given, name, self.x),
            )

    def _springs(self, start: Mapping[str, float]) -> Iterator[DrivenLength]:
        """Springs on lengths of members without a drive; those that act on no joint and no length are listed."""
        for name, spring in self.model.springs.items():
            one, single = spring.parts[0][0], len(spring.parts) == 1
            if single and f"{name}.0" in self.places:
                continue
            ends = [self.place[node] for node in self.model.members[one.bar].ends] if one.kind == "length" else []
            if not single or not ends or not all(self.at.get(end) for end in ends) or one.bar in self.model.driven_members:
                self.left.append(LeftOut("springs", name, "it acts on no angle of a joint and on no length without a drive"))
                continue
            links = self.link[self.at[ends[0]][0]], self.link[self.at[ends[1]][0]]
            x = self.x[ends]
            yield DrivenLength(
                name=name, links=links, points=(x[0], x[1]), length=float(np.linalg.norm(x[1] - x[0])), driven=False,
                spring=length_spring(name, spring, start[f"{name}.0"], self.left),
            )  # fmt: skip
