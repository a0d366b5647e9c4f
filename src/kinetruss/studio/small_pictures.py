"""Small pictures of models: what a page needs to draw one as wide as a thumb."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

from kinetruss.model import DistanceCoordinate, turns
from kinetruss.viewer.support_marks import support_marks

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kinetruss.model import Model

DIGITS = 5
"""Digits of a place."""


def small_picture(model: Model, path: Iterable[Iterable[float]] = ()) -> dict[str, Any]:
    """Places of nodes, m; lines between them with the kind of their member; supports; members that turn; a path to show."""
    names = [name for name, node in model.nodes.items() if node.at and not node.scalar]
    index = {name: k for k, name in enumerate(names)}
    coordinates = [spring.coordinate for spring in model.springs.values()]
    lines = [
        *((member.ends, "elastic" if kind in ("elastic", "cable", "free") else kind) for member, kind in _straight(model)),
        *((pair, "rigid") for link in model.links.values() for pair in pairwise(link.nodes)),
        *((one.nodes, "elastic") for one in coordinates if isinstance(one, DistanceCoordinate)),
    ]
    turning = [getattr(drive, "bar", "") for drive in model.all_drives.values() if turns(drive)]
    first = {**{name: bar.ends for name, bar in model.bars.items()}, **{name: link.nodes for name, link in model.links.items()}}
    return {
        "dim": model.dim,
        "places": [_short(model.nodes[name].at) for name in names],
        "lines": [[*(index[end] for end in ends), kind] for ends, kind in lines if all(end in index for end in ends)],
        "bodies": [
            [index[node] for node in body.nodes if node in index] for body in model.bodies.values() if len(body.nodes) > 2
        ],
        "supports": [{**mark, "node": index[mark["node"]]} for mark in support_marks(model) if mark["node"] in index],
        "turning": [[index[node] for node in first[bar][:2]] for bar in turning if bar in first],
        "path": [_short(place) for place in path],
    }


def _straight(model: Model) -> Iterable[tuple[Any, str]]:
    """Members between two nodes with their kind."""
    yield from ((bar, str(bar.kind)) for bar in model.bars.values())
    yield from ((one, "driven") for one in [*model.active.values(), *model.cylinders.values()])
    yield from ((beam, "rigid") for beam in model.beams.values())


def _short(place: Iterable[float]) -> list[float]:
    return [float(f"{value:.{DIGITS}g}") for value in place]
