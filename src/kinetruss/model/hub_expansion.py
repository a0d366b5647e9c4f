"""Gives hubs their arms and hinges: nodes at the tips, rigid bars to them, bodies, axes; where bearings are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.errors import Fault
from kinetruss.model.bodies import Body
from kinetruss.model.drives import Coupling, LengthDrive
from kinetruss.model.hub_arms import Arm, apexes, arms_of, clamped_at, free_length, is_grounded, spread
from kinetruss.model.inner import Owner
from kinetruss.model.joints import GROUND
from kinetruss.model.members import Active, Bar, Brace, Node

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model.data import ModelData
    from kinetruss.model.joints import Bearing
    from kinetruss.model.whole import WholeModel


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
    return [other for other, one in found if other != name and node in one.ends and not isinstance(one, Brace)]


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
            other = model.members[name].ends[1 - arm.end]
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


def _add_axes(whole: WholeModel) -> None:
    """Add the nodes on the axes of hinges."""
    for one in whole.inner.pivots:
        for node, at in zip(one.nodes, one.at, strict=True):
            _add_node(whole, one.hub, node, at, still=is_grounded(whole, one.hub))


def _add_node(whole: WholeModel, hub: str, node: str, at: tuple[float, ...], *, still: bool = False) -> None:
    """Add a node of a hub. still : it moves and stands with the centre, which the ground holds."""
    whole.nodes[node], whole.inner.nodes[node] = Node.model_construct(at=at, coincident=True), Owner("hubs", hub, hub)
    if still:
        whole.fixed[node] = whole.fixed[hub]
        if hub in whole.support_motion:
            whole.support_motion[node] = whole.support_motion[hub]


def _add_hinged(model: ModelData, whole: WholeModel) -> None:
    """Keep hinged members at their distance from the axes: a rigid body, or two bars of equal lengths that change."""
    pivots, inner = whole.inner.pivots, whole.inner
    for name in model.members:
        own = [one for one in pivots if one.member == name]
        if own and own[0].steady and not own[0].clamped:
            nodes = list(dict.fromkeys(node for one in own for node in (one.tip, *one.nodes)))
            nodes += [] if own[0].far in nodes else [own[0].far]
            _add_body(whole, own[0].body, nodes, own[-1].hub)
    for one in pivots:
        owner = Owner("hubs", one.hub)
        if not one.steady:
            for bar, node in zip(one.bars, one.nodes, strict=True):
                whole.bars[bar], inner.bars[bar] = Brace(ends=(node, one.far), kind="free", mass=0.0), owner
            terms = tuple((LengthDrive(bar=bar), sign) for bar, sign in zip(one.bars, (1.0, -1.0), strict=True))
            whole.couplings[one.coupling] = Coupling(terms=terms, value=0.0)
            inner.couplings[one.coupling] = owner._replace(at=one.hub)


def perpendicular(axis: NDArray[np.float64], along: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of an axis across a unit vector."""
    return np.asarray(axis - (axis @ along) * along)


# Gives the hubs of a model their arms: nodes at the tips, rigid bars to them, and a rigid body of all.


def add_hubs(model: ModelData, whole: WholeModel) -> None:
    """Add the arms, axes and bodies of the hubs of a model to its whole, and let members end at their arms."""
    inner = whole.inner
    inner.pivots.extend(pivots_of(model))
    for hub, arms in inner.arms.items():
        _add_arms(whole, hub, arms)
    _add_axes(whole)
    for hub in model.hubs:
        if not is_grounded(model, hub) and len(nodes := _nodes(model, whole, hub)) > 1:
            _add_body(whole, f"{hub}.hub", nodes, hub)
    _add_hinged(model, whole)


def _nodes(model: ModelData, whole: WholeModel, hub: str) -> list[str]:
    """The nodes of a hub's body without apexes: its centre, the tips, axes of hinges, and the far ends of clamped members."""
    nodes = [hub, *(arm.name for arm in whole.inner.arms[hub])]
    nodes += [node for one in whole.inner.pivots if hub in (one.hub, one.clamped) for node in one.nodes]
    for name in clamped_at(model, hub):
        nodes += [node for node in whole.bars[name].ends if node != hub]
    return nodes


def _add_arms(whole: WholeModel, hub: str, arms: list[Arm]) -> None:
    """Add the nodes at the tips of a hub and the bars to them, and let its members end there."""
    record, grounded = whole.hubs[hub], is_grounded(whole, hub)
    # between fixed nodes a rigid bar would be in a state of self-stress
    kind: Literal["free", "rigid"] = "free" if grounded else "rigid"
    for arm in arms:
        _add_node(whole, hub, arm.name, arm.at, still=grounded)
        table: dict[str, Any] = whole.bars if arm.member in whole.bars else whole.active
        ends = list(table[arm.member].ends)
        ends[arm.end] = arm.name
        table[arm.member] = table[arm.member].with_(ends=tuple(ends))
        whole.bars[arm.name] = Bar(
            ends=(hub, arm.name), kind=kind, buckling="clamped-free", section=record.section, material=record.material
        )
        whole.inner.bars[arm.name] = Owner("hubs", hub)


def _add_body(whole: WholeModel, body: str, nodes: list[str], hub: str) -> None:
    """Add a rigid body of these nodes, with apexes where they are flat."""
    for k, place in enumerate(apexes(np.array([whole.nodes[node].at for node in nodes])), start=1):
        nodes.append(f"{body}.apex{k}")
        _add_node(whole, hub, nodes[-1], tuple(place.tolist()))
    whole.bodies[body] = Body(nodes=tuple(nodes), carriers=spread({node: whole.nodes[node].at for node in nodes}))
    whole.inner.bodies[body] = Owner("hubs", hub, hub)
