"""Gives hubs their arms and hinges: nodes at the tips, rigid bars to them, bodies, axes; where bearings are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.errors import Fault
from kinetruss.model.bodies import Body
from kinetruss.model.drives import Coupling, LengthDrive
from kinetruss.model.hub_arms import Arm, apexes, arms_of, clamped_at, free_length, ideal_ends, is_grounded, spread
from kinetruss.model.joints import GROUND
from kinetruss.model.members import Active, Bar, Node

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model.data import ModelData
    from kinetruss.model.joints import Bearing


def seat_of(model: ModelData, bearing: Bearing) -> tuple[str, int, str, int]:
    """The member and its end there (0 is A), and the other member and its end; ``ground`` and -1 for the ground."""
    node = _node(model, bearing)
    end = model.members[bearing.member].ends.index(node)
    other = bearing.against or (GROUND if node in model.fixed else _others(model, bearing.member, node)[0])
    return bearing.member, end, other, -1 if other == GROUND else model.members[other].ends.index(node)


def _node(model: ModelData, bearing: Bearing) -> str:
    """The node at the end of the member: of a hub the tip of its arm."""
    tip = f"{bearing.node}.{bearing.member}"
    return tip if bearing.node in model.hubs and tip in model.members[bearing.member].ends else bearing.node


def _others(model: ModelData, name: str, node: str) -> list[str]:
    """Other members that end at a node, without braces."""
    found = model.members.items()
    return [other for other, one in found if other != name and node in one.ends and not getattr(one, "brace", False)]


def bearing_faults(model: ModelData) -> Iterator[Fault]:
    """Members that end elsewhere, more than one part to turn against."""
    for name, bearing in model.bearings.items():
        path = ("bearings", name)
        if bearing.member not in model.members or bearing.node not in model.nodes:
            continue
        node, ends = _node(model, bearing), model.members[bearing.member].ends
        if node not in ends:
            mend = f"Name one of its ends: {', '.join(ends)}."
            yield Fault((*path, "node"), f"{bearing.member!r} does not end at {bearing.node!r}.", mend)
            continue
        others = _others(model, bearing.member, node)
        free, space = node not in model.fixed, len(model.nodes[node].at) == 3
        hinged = bearing.node in model.hubs and bearing.member in model.hubs[bearing.node].hinges
        if space and not hinged and (free or bearing.against not in (None, GROUND)):
            message = "is a ball joint between moving parts: how slender members spin about their own axes is not known."
            mend = f"Give the joint an axis: hinges: {{{bearing.member}: z}} of a hub; or give the bearing to a fixed node."
            yield Fault(path, message, mend)
        elif bearing.against not in (None, GROUND, *others):
            message = f"{bearing.against!r} does not end at {node!r}."
            yield Fault((*path, "against"), message, f"Name one of: {', '.join([*others, GROUND])}.")
        elif bearing.against is None and free and len(others) != 1:
            has = f"{len(others)} other members end" if others else "no other member ends"
            mend = f"Say against which it turns: against: {', '.join([*others, GROUND])}."
            yield Fault(path, f"{has} at {node!r}.", mend)


# Hinges between hubs in space and their members: nodes on the axis that belong to the hub and hold the member.


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


# Gives the hubs of a model their arms: nodes at the tips, rigid bars to them, and a rigid body of all.

TABLES = ("nodes", "bars", "active", "bodies", "fixed", "support_motion", "couplings")
"""Tables of a model that hubs change."""


def with_arms(model: ModelData) -> dict[str, dict[str, Any]]:
    """The tables of a model that change when its hubs get their arms, by field; the joints of hubs that have them are moved to
    where their arms end.
    """
    every = {hub: arms_of(model, hub) for hub in model.hubs}
    new = {hub: arms for hub, arms in every.items() if not _expanded(model, hub, arms)}
    found: dict[str, dict[str, Any]] = {field: dict(getattr(model, field)) for field in TABLES}
    for hub, arms in every.items():
        if hub in new:
            _add_arms(model, hub, arms, found)
        else:
            for arm in arms:
                found["nodes"][arm.name] = found["nodes"][arm.name].with_(at=arm.at)
    add_axes(model, found)
    for hub, arms in every.items():
        if hub not in new:
            _move(model, hub, arms, found)
        elif not is_grounded(model, hub):
            _add_body(model, hub, arms, found)
    add_hinged(model, found)
    return {field: table for field, table in found.items() if table != getattr(model, field)}


def _expanded(model: ModelData, hub: str, arms: list[Arm]) -> bool:
    """Whether a hub has its arms: its members end at them, or its body is there."""
    if arms:
        return all(model.members[arm.member].ends[arm.end] == arm.name for arm in arms)
    return f"{hub}.hub" in model.bodies


def _move(model: ModelData, hub: str, arms: list[Arm], found: dict[str, dict[str, Any]]) -> None:
    """Give a hub whose joints are where its record and its node say the body that it then has."""
    if (body := found["bodies"].get(f"{hub}.hub")) is None:
        return
    beside = [node for node in body.nodes if node.startswith(f"{hub}.hub.apex")]
    nodes = _nodes(model, hub, arms, found)
    places = apexes(np.array([found["nodes"][node].at for node in nodes]))
    if [*nodes, *beside] == list(body.nodes) and len(places) == len(beside):
        moved = {node: found["nodes"][node].with_(at=tuple(at.tolist())) for node, at in zip(beside, places, strict=True)}
        found["nodes"].update(moved)
        return
    for node in beside:
        found["nodes"].pop(node)
    _add_body(model, hub, arms, found)


def _nodes(model: ModelData, hub: str, arms: list[Arm], found: dict[str, dict[str, Any]]) -> list[str]:
    """The nodes of a hub's body without apexes: its centre, the tips, axes of hinges, and the far ends of clamped members."""
    nodes = [hub, *(arm.name for arm in arms)]
    nodes += [node for one in pivots_of(model) if hub in (one.hub, one.clamped) for node in one.nodes]
    for name in clamped_at(model, hub):
        nodes += [node for node in found["bars"][name].ends if node != hub]
    return nodes


def _add_arms(model: ModelData, hub: str, arms: list[Arm], found: dict[str, dict[str, Any]]) -> None:
    """Add the nodes at the tips of a hub and the bars to them, and let its members end there."""
    record, grounded = model.hubs[hub], is_grounded(model, hub)
    matter = {"section": record.section, "material": record.material}
    # between fixed nodes a rigid bar would be in a state of self-stress
    kind: Literal["free", "rigid"] = "free" if grounded else "rigid"
    for arm in arms:
        found["nodes"][arm.name] = Node(at=arm.at, coincident=True)
        found["bars"][arm.name] = Bar(ends=(hub, arm.name), kind=kind, buckling="clamped-free", **matter)
        table = found["bars" if arm.member in model.bars else "active"]
        ends = list(table[arm.member].ends)
        ends[arm.end] = arm.name
        table[arm.member] = table[arm.member].with_(ends=tuple(ends))
        if grounded:
            found["fixed"][arm.name] = model.fixed[hub]
            if hub in model.support_motion:
                found["support_motion"][arm.name] = model.support_motion[hub]
        for other in model.hubs:  # a body that is there and clamps the member
            body = found["bodies"].get(f"{other}.hub")
            if other != hub and body and arm.member in model.hubs[other].clamped:
                nodes = tuple(arm.name if node == hub else node for node in body.nodes)
                found["bodies"][f"{other}.hub"] = body.with_(
                    nodes=nodes, carriers=spread({node: found["nodes"][node].at for node in nodes})
                )


def _add_body(model: ModelData, hub: str, arms: list[Arm], found: dict[str, dict[str, Any]]) -> None:
    """Add the rigid body of the centre, the tips and the far ends of clamped members, with apexes where these are flat."""
    nodes = _nodes(model, hub, arms, found)
    points = np.array([found["nodes"][node].at for node in nodes])
    for k, place in enumerate(apexes(points), start=1):
        nodes.append(f"{hub}.hub.apex{k}")
        found["nodes"][nodes[-1]] = Node(at=tuple(place.tolist()), coincident=True)
    if len(nodes) > 1:
        found["bodies"][f"{hub}.hub"] = Body(
            nodes=tuple(nodes), carriers=spread({node: found["nodes"][node].at for node in nodes})
        )
