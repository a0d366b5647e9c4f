"""Hinges between hubs in space and their members: nodes on the axis that belong to the hub and hold the member."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model.hubs.arms import apexes, arms_of, free_length, ideal_ends, is_grounded, spread
from kinetruss.model.motion.drives import Coupling, LengthDrive
from kinetruss.model.parts.bodies import Body
from kinetruss.model.parts.members import Active, Bar, Node

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model._data import ModelData

__all__ = ["Pivot", "add_axes", "add_hinged", "is_steady", "pivots_of"]


@dataclass(frozen=True, kw_only=True)
class Pivot:
    """The hinge of a member at the tip of its arm.

    end : of the member there (0 is A). tip, far : nodes at its ends. axis (3,) : unit vector at the start. nodes : on the axis,
    beside the tip; at : their places, m. steady : the length of the member does not change. clamped : the hub at the far end
    whose body the member belongs to, or empty.
    """

    hub: str
    member: str
    end: int
    tip: str
    far: str
    axis: tuple[float, float, float]
    nodes: tuple[str, ...]
    at: tuple[tuple[float, ...], ...]
    steady: bool
    clamped: str

    @property
    def bars(self) -> tuple[str, str]:
        """Free bars from the nodes of the axis to the far end of a member whose length changes; they are equally long."""
        return f"{self.tip}.hinge1", f"{self.tip}.hinge2"

    @property
    def coupling(self) -> str:
        """The condition that they are equally long."""
        return f"{self.tip}.hinge"

    @property
    def body(self) -> str:
        """The rigid body of a member whose length does not change and the axes of its hinges."""
        return f"{self.clamped}.hub" if self.clamped else f"{self.member}.hinges"


def is_steady(model: ModelData, name: str) -> bool:
    """Whether the length of a member does not change."""
    member = model.members[name]
    return not isinstance(member, Active) and member.kind == "rigid" and name not in model.driven_members


def pivots_of(model: ModelData) -> list[Pivot]:
    """The hinges of all hubs whose members have an arm there."""
    found = []
    for hub, record in model.hubs.items():
        arms = {arm.member: arm for arm in arms_of(model, hub)} if record.hinges else {}
        for name, axis in record.hinges.items():
            if name not in arms or len(arms[name].at) != 3:
                continue
            arm, steady = arms[name], is_steady(model, name)
            other = ideal_ends(model, name, model.members[name])[1 - arm.end]
            far = {one.member: one.name for one in arms_of(model, other)}.get(name, other) if other in model.hubs else other
            tip, unit = np.array(arm.at), np.array(axis) / np.linalg.norm(axis)
            # neither much farther than the arm nor much nearer than the far end: both bodies stay well conditioned
            size = float(np.sqrt(np.linalg.norm(tip - np.array(model.nodes[hub].at)) * abs(free_length(model, name)[1])))
            signs = (1.0,) if steady else (1.0, -1.0)
            found.append(
                Pivot(
                    hub=hub,
                    member=name,
                    end=arm.end,
                    tip=arm.name,
                    far=far,
                    axis=tuple(unit.tolist()),
                    nodes=tuple(f"{arm.name}.axis{k}" for k in range(1, len(signs) + 1)),
                    at=tuple(tuple((tip + sign * size * unit).tolist()) for sign in signs),
                    steady=steady,
                    clamped=other if other in model.hubs and name in model.hubs[other].clamped else "",
                )
            )
    return found


def add_axes(model: ModelData, found: dict[str, dict[str, Any]]) -> None:
    """Add the nodes on the axes of hinges, or move them, and remove those of hinges that are no more."""
    pivots = pivots_of(model)
    made = {node for one in pivots for node in one.nodes}
    for hub in model.hubs:
        for arm in arms_of(model, hub):
            for node in (f"{arm.name}.axis{k}" for k in (1, 2)):
                if node in found["nodes"] and node not in made:
                    found["nodes"].pop(node)
                    found["fixed"].pop(node, None)
                    found["support_motion"].pop(node, None)
            if not any(one.tip == arm.name and not one.steady for one in pivots):
                found["couplings"].pop(f"{arm.name}.hinge", None)
                for bar in (f"{arm.name}.hinge1", f"{arm.name}.hinge2"):
                    found["bars"].pop(bar, None)
    for one in pivots:
        for node, at in zip(one.nodes, one.at, strict=True):
            found["nodes"][node] = Node(at=at, coincident=True)
            if is_grounded(model, one.hub):
                found["fixed"][node] = model.fixed[one.hub]
                if one.hub in model.support_motion:
                    found["support_motion"][node] = model.support_motion[one.hub]


def add_hinged(model: ModelData, found: dict[str, dict[str, Any]]) -> None:
    """Keep hinged members at their distance from the axes: a rigid body, or two bars of equal lengths that change."""
    pivots = pivots_of(model)
    for name in model.members:
        own = [one for one in pivots if one.member == name]
        _drop(f"{name}.hinges", found)
        if own and own[0].steady and not own[0].clamped:
            _rigid(own, found)
    for one in pivots:
        if not one.steady:
            for bar, node in zip(one.bars, one.nodes, strict=True):
                found["bars"][bar] = Bar(ends=(node, one.far), kind="free", mass=0.0, brace=True)
            terms = tuple((LengthDrive(bar=bar), sign) for bar, sign in zip(one.bars, (1.0, -1.0), strict=True))
            found["couplings"][one.coupling] = Coupling(terms=terms, value=0.0)


def _rigid(own: list[Pivot], found: dict[str, dict[str, Any]]) -> None:
    """The body of a member and its axes, with apexes where these are flat."""
    nodes = list(dict.fromkeys(node for one in own for node in (one.tip, *one.nodes)))
    nodes += [] if own[0].far in nodes else [own[0].far]
    body, points = own[0].body, np.array([found["nodes"][node].at for node in nodes])
    for k, place in enumerate(apexes(points), start=1):
        nodes.append(f"{body}.apex{k}")
        found["nodes"][nodes[-1]] = Node(at=tuple(place.tolist()), coincident=True)
    found["bodies"][body] = Body(nodes=tuple(nodes), carriers=spread({node: found["nodes"][node].at for node in nodes}))


def _drop(body: str, found: dict[str, dict[str, Any]]) -> None:
    """Remove the body of a hinged member and its apexes."""
    if (old := found["bodies"].pop(body, None)) is not None:
        for node in old.nodes:
            if node.startswith(f"{body}.apex"):
                found["nodes"].pop(node, None)


def perpendicular(axis: NDArray[np.float64], along: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of an axis across a unit vector."""
    return np.asarray(axis - (axis @ along) * along)
