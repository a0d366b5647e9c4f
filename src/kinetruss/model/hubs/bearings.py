"""Where bearings are: the end of their member, and the member against which it turns."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinetruss.errors import Fault
from kinetruss.model._words import nearest
from kinetruss.model.checks.common import unknown
from kinetruss.model.parts.joints import GROUND

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData
    from kinetruss.model.parts.joints import Bearing

__all__ = ["bearing_faults", "seat_of"]


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
    """Unknown names, members that end elsewhere, more than one part to turn against."""
    for name, bearing in model.bearings.items():
        path = ("bearings", name)
        if bearing.member not in model.members:
            yield Fault((*path, "member"), f"no member called {bearing.member!r}.", nearest(bearing.member, model.members))
            continue
        if bearing.node not in model.nodes:
            yield unknown("node", bearing.node, model.nodes, (*path, "node"))
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
