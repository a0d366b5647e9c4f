"""The arms of hubs: the members at a hub, their joints, and what is left of their lengths."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations, islice
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model.bodies import quality
from kinetruss.model.bracing import beside

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model.data import ModelData
    from kinetruss.model.whole import WholeModel


FLAT = 1e-6
"""Tips within this fraction of the size of a hub from a plane count as lying in it."""
TRIED = 1000
"""Sets of nodes that are compared."""


@dataclass(frozen=True, kw_only=True)
class Arm:
    """The arm of a member at a hub.

    name : of the arm, and of the node at its tip. end : of the member (0 is A). at (dim,) : place of the tip, m.
    """

    hub: str
    member: str
    name: str
    end: int
    at: tuple[float, ...]


def is_grounded(model: ModelData, hub: str) -> bool:
    """Whether the hub is bolted to the ground."""
    return hub in model.nodes and not model.hubs[hub].turns and len(model.fixed.get(hub, "")) == len(model.nodes[hub].at)


def members_at(model: ModelData, hub: str) -> dict[str, int]:
    """Members at a hub, with their end there; none with missing nodes, which are a fault."""
    found = {}
    for name, member in model.members.items():
        if hub in member.ends and all(end in model.nodes for end in member.ends):
            found[name] = member.ends.index(hub)
    return found


def arms_of(model: ModelData, hub: str) -> list[Arm]:
    """The arms of a hub whose members are known, in the order of the members."""
    record, found = model.hubs[hub], []
    for name, end in members_at(model, hub).items():
        offset: Any = record.arms.get(name, None if name in record.clamped else record.reach)
        if offset is None:
            continue
        ends = model.members[name].ends
        centre, far = (np.array(model.nodes[node].at, float) for node in (ends[end], ends[1 - end]))
        along = far - centre
        length = float(np.linalg.norm(along))
        step = np.array(offset) if isinstance(offset, tuple) else offset / length * along if length else along
        if step.shape == centre.shape:
            at = tuple((centre + step).tolist())
            found.append(Arm(hub=hub, member=name, name=f"{hub}.{name}", end=end, at=at))
    return found


def arm_through(whole: WholeModel, body: str, member: str) -> Arm | None:
    """The arm of a member at the hub in space that has this body (``NODE.hub``, also of a hub on the ground); None without."""
    hub = body.removesuffix(".hub")
    if hub == body or whole.dim != 3:
        return None
    return next((arm for arm in whole.inner.arms.get(hub, ()) if arm.member == member), None)


def clamped_at(model: ModelData, hub: str) -> dict[str, str]:
    """Members clamped at a hub, with the node at their other end."""
    here = members_at(model, hub)
    return {name: model.members[name].ends[1 - here[name]] for name in model.hubs[hub].clamped if name in here}


def free_length(model: ModelData, name: str) -> tuple[float, float]:
    """Length of a member between its nodes and between its joints as drawn, m; the second negative where hubs overlap."""
    ends = model.members[name].ends
    centres = [np.array(model.nodes[node].at, float) for node in ends]
    places = list(centres)
    for end, hub in enumerate(ends):
        if hub in model.hubs:
            places[end] = next((np.array(arm.at) for arm in arms_of(model, hub) if arm.member == name), places[end])
    whole = float(np.linalg.norm(centres[1] - centres[0]))
    rest: float = float((places[1] - places[0]) @ (centres[1] - centres[0])) / whole if whole else 0.0
    return whole, float(np.linalg.norm(places[1] - places[0])) if rest > 0 else rest


def apexes(points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Places of the nodes that a hub in space with these nodes (k, 3) needs beside them, so that bars hold it."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    span = int(np.sum(spread > FLAT * spread[0]))
    if len(points) <= span + 1 or span == points.shape[1]:
        return []
    return beside(points, points.shape[1])


def loops(model: ModelData) -> set[str]:
    """Hubs in closed frames of clamped members, whose moments statics alone does not give."""
    root = {hub: hub for hub in model.hubs}

    def top(hub: str) -> str:
        while root[hub] != hub:
            hub = root[hub]
        return hub

    closed = set()
    for one, two in combinations(model.hubs, 2):
        for name in set(model.hubs[one].clamped) & set(model.hubs[two].clamped):
            if set(model.members[name].ends) == {one, two}:
                if top(one) == top(two):
                    closed.add(top(one))
                root[top(one)] = top(two)
    return {hub for hub in model.hubs if top(hub) in {top(one) for one in closed}}


def spread(places: dict[str, tuple[float, ...]]) -> tuple[str, ...]:
    """The nodes of a hub that span it best, so that loads on its body have carriers: four in space, two in the plane."""
    dim = len(next(iter(places.values())))
    if dim == 2:
        return tuple(places)[:2]
    tried = islice(combinations(places, min(len(places), dim + 1)), TRIED)
    return max(tried, key=lambda names: round(quality([places[name] for name in names]), 9))
