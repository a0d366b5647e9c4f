"""Gives the hubs of a model their arms: nodes at the tips, rigid bars to them, and a rigid body of all."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.model.hubs.arms import Arm, apexes, arms_of, clamped_at, is_grounded, spread
from kinetruss.model.hubs.hinges import add_axes, add_hinged, pivots_of
from kinetruss.model.parts.bodies import Body
from kinetruss.model.parts.members import Bar, Node

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData

__all__ = ["with_arms"]

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
