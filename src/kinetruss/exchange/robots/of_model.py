"""A robot from a model: rigid parts as links, shared nodes as joints of a tree, the other shared nodes as closures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.exchange.robots.masses import masses_of, rods_of
from kinetruss.exchange.robots.records import Closure, DrivenLength, LeftOut, Link, Pivot, Robot, RobotOfModel, placement
from kinetruss.exchange.robots.rigid import rigid_parts
from kinetruss.mechanics import compile
from kinetruss.mechanics.configuration import drive_values
from kinetruss.model import GROUND, AngleDrive, HingeDrive, Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["robot_of_model"]

TABLES = {
    "couplings": "couplings are not carried: the robot has more freedoms",
    "springs": "springs are not carried",
    "loads": "loads are not carried",
    "beams": "beams are not carried",
    "membranes": "membranes are not carried",
    "solids": "solids are not carried",
    "bearings": "friction is not carried",
    "support_motion": "motions of supports are not carried",
    "load_cases": "loads are not carried",
    "conditions": "conditions are not carried",
    "velocities": "velocities at the start are not carried",
    "actuators": "gears, screws and motors are not carried; its drive is",
    "runs": "runs are not carried",
}


def robot_of_model(model: Model, position: Any = None) -> RobotOfModel:
    """The robot of a model. position (n, dim), m : the pose; by default that of the model.

    Raises
    ------
    InputError : supports that guide nodes which move.
    """
    x = np.zeros((len(model.nodes), 3))
    x[:, : model.dim] = [node.at for node in model.nodes.values()] if position is None else np.asarray(position)[:, : model.dim]
    return _Maker(model, x).drawn()


@dataclass(frozen=True, slots=True)
class _Turn:
    """A drive of an angle between two parts about an axis through nodes."""

    name: str
    parts: frozenset[int]
    first: int
    axis: tuple[int, ...]
    along: Any
    value: float


class _Maker:
    def __init__(self, model: Model, x: NDArray[np.float64]) -> None:
        self.model, self.x = model, x
        self.place = {name: k for k, name in enumerate(model.nodes)}
        self.names = list(model.nodes)
        self.parts = rigid_parts(model, x)
        self.at: dict[int, list[int]] = {}
        for index, part in enumerate(self.parts):
            for node in part.nodes:
                self.at.setdefault(node, []).append(index)
        self.left = [LeftOut(table, one, why) for table, why in TABLES.items() for one in getattr(model, table)]
        if model.base_rotation is not None:
            self.left.append(LeftOut("base_rotation", "model", "the base rests"))
        self.left += [
            LeftOut(f"{bar.kind} bar", name, "its force is not carried")
            for name, bar in model.bars.items()
            if bar.kind in ("elastic", "cable", "free")
        ]
        self.pivots: list[Pivot] = []
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
        properties, left = masses_of(self.model, self.x, self.parts)
        self.left += left
        turns = list(self._turns())
        self._tree(turns)
        drives = {one.drive: 0 for one in self.pivots if one.drive is not None}
        self.left += [
            LeftOut("drive", one.name, "its angle is at no joint of the tree, or measured from no part of it")
            for one in turns
            if one.name not in drives
        ]
        lengths = list(self._lengths())
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
            gravity=(gravity[0], gravity[1], gravity[2] if len(gravity) == 3 else 0.0),
            left_out=self.left,
        )
        offsets = {one.name: one.value for one in turns if one.name in drives} | {one.name: one.length for one in lengths}
        return RobotOfModel(robot=robot, lengths=lengths, offsets=offsets, lines=self._lines())

    def _lines(self) -> dict[str, list[NDArray[np.float64]]]:
        found: dict[str, list[NDArray[np.float64]]] = {}
        for bar in self.model.bars.values():
            ends = [self.place[node] for node in bar.ends]
            if (part := self._part_of(ends)) is not None:
                found.setdefault(self.link[part], []).append(self.x[ends])
        return found

    def _turns(self) -> Iterator[_Turn]:
        """Drives of angles, with the parts that they turn."""
        system = compile(self.model)
        x = self.x[None]
        start = dict(zip(system.drives, drive_values(system, x, 0 * x, 0 * x)[0][0].tolist(), strict=True))
        for name, drive in self.model.drives.items():
            if isinstance(drive, HingeDrive):
                axis = tuple(self.place[node] for node in drive.axis)
                first, second = (self._part_of((*axis, self.place[node])) for node in (drive.start, drive.end))
                along = np.array([0.0, 0.0, 1.0]) if len(axis) == 1 else self.x[axis[1]] - self.x[axis[0]]
            elif isinstance(drive, AngleDrive) and drive.bar in self.model.bars:
                ends = [self.place[node] for node in self.model.bars[drive.bar].ends]
                first, second = 0, self._part_of(ends)
                along = np.array([0.0, 0.0, 1.0] if drive.axis is None else drive.axis, float)
                axis = tuple(node for node in ends if 0 in self.at.get(node, ()))
            else:
                if drive.kind != "length":
                    self.left.append(LeftOut("drive", name, "prescribed coordinates are not carried: the node is held"))
                continue
            if first is None or second is None or first == second:
                self.left.append(LeftOut("drive", name, "it turns no rigid part against another"))
                continue
            yield _Turn(name, frozenset((first, second)), first, axis, along / np.linalg.norm(along), start[name])

    def _part_of(self, nodes: Sequence[int]) -> int | None:
        """The part that has all of some nodes."""
        return next((k for k, part in enumerate(self.parts) if set(nodes) <= set(part.nodes)), None)

    def _tree(self, turns: Sequence[_Turn]) -> None:
        """Joints from the ground outwards: driven angles first, then hinges, then balls; parts out of reach float."""
        driven = {one.parts: one for one in turns}
        shared: dict[frozenset[int], list[int]] = {}
        for node, parts in sorted(self.at.items()):
            for pair in combinations(parts, 2):
                shared.setdefault(frozenset(pair), []).append(node)
        rank = {pair: 2 * (pair in driven) + (len(nodes) > 1 or self.model.dim == 2) for pair, nodes in shared.items()}
        placed = {0}
        while len(placed) < len(self.parts):
            ready = [pair for pair in shared if len(pair & placed) == 1]
            if ready:
                best = max(ready, key=lambda pair: rank[pair])
                (parent,), (child,) = best & placed, best - placed
                self._join(parent, child, shared[best], driven.get(best))
            else:
                child = min(set(range(len(self.parts))) - placed)
                self._float(child)
            placed.add(child)

    def _float(self, child: int) -> None:
        middle, name = self.x[self.parts[child].nodes].mean(axis=0), self.link[child]
        ends: dict[str, Any] = {"origin": placement(None, middle), "after": placement(None, -middle)}
        self._add(Pivot(name=f"{name}.free", kind="free", parent=GROUND, child=name, **ends))

    def _add(self, pivot: Pivot) -> None:
        self.pivots.append(pivot)

    def _join(self, parent: int, child: int, shared: Sequence[int], turn: _Turn | None) -> None:
        """A joint at shared nodes, which are then one; a rod at one node turns about two axes across itself."""
        own, above, name = self.link[child], self.link[parent], self.names[shared[0]]
        place = self.x[shared[0]]
        ends: dict[str, Any] = {"origin": placement(None, place), "after": placement(None, -place)}
        if self.model.dim == 2 or len(shared) > 1:
            along = np.array([0.0, 0.0, 1.0])
            if self.model.dim == 3:
                along = self.x[shared[-1]] - place
                along = along / np.linalg.norm(along)
            drive, fits = None, turn is not None and set(turn.axis) <= set(shared)
            if turn is not None and fits and abs(abs(along @ turn.along) - 1) < 1e-9:
                drive = turn.name
                along = turn.along if turn.first == parent else -turn.along
            self._add(
                Pivot(name=drive or f"{own}.{name}", kind="revolute", parent=above, child=own, axis=along, drive=drive, **ends)
            )
        elif self.parts[child].kind == "rod":
            other = next(node for node in self.parts[child].nodes if node != shared[0])
            line = (self.x[other] - place) / np.linalg.norm(self.x[other] - place)
            one = np.cross(line, np.eye(3)[int(np.argmin(np.abs(line)))])
            one /= np.linalg.norm(one)
            cross = f"{own}.cross"
            self._add(Pivot(name=f"{own}.{name}.1", kind="revolute", parent=above, child=cross, axis=one, **ends))
            two = np.cross(line, one)
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
                properties=rods_of(self.model, name, self.x),
            )
