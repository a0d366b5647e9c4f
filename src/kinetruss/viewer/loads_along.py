"""Arrows of loads between the ends of members: at their places, and along members as parts of the whole."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.load import OnMember, Spread
from kinetruss.mechanics import System
from kinetruss.mechanics.bars import bars_of
from kinetruss.model.bracing import CHORD

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.elements.beams import BeamElements

EACH, FEW, MANY = 5, 2, 12
"""Arrows of a load along a member, and of each of them where there are more than `MANY`."""


def drawn_along(system: System, name: str, whole: NDArray[np.float64], count: int) -> tuple[list[dict[str, Any]], list[Any]]:
    """Arrows of a load that acts on members between their ends, and their forces (times, 3), N, which add up to the whole.

    Each has its `member`, and its place as nodes with factors (`at`); along a member its `span`, m, so that force over span is
    the force a length, and `words` on the one that tells it. None of couples, and of loads whose whole is 0 by their shape.
    """
    load = system.model.loads[name]
    if load.amount != "force":
        return [], []
    entries: list[dict[str, Any]] = []
    forces: list[Any] = []
    for member, (begin, end), shape, nodes in _where(system, name):
        if shape is None:
            places, ratio, length = np.array([begin]), np.ones(1), 0.0
        elif not sum(shape):
            continue
        else:
            eta = (np.arange(count) + 0.5) / count
            places = begin + (end - begin) * eta
            ratio = 2.0 * (shape[0] + (shape[1] - shape[0]) * eta) / sum(shape) / count
            length = (end - begin) * _length(system, member)
        told = int(np.argmax(np.abs(ratio)))
        for k, (place, part) in enumerate(zip(places, ratio, strict=True)):
            entry = {"name": name, "member": member, "at": nodes(float(place))}
            entries.append(entry | ({"span": length / count, "words": k == told} if length else {}))
            forces.append(part * whole)
    return entries, forces


class _Loaded(NamedTuple):
    """A member under a load: where it begins and ends, as fractions, its amounts there (None at a place), a function for the
    nodes of a place with their factors.
    """

    member: int
    span: tuple[float, float]
    shape: tuple[float, float] | None
    nodes: Callable[[float], list[list[float]]]


def _where(system: System, name: str) -> Iterator[_Loaded]:
    load, kind = system.model.loads[name], LOADS[type(system.model.loads[name])]
    for one in kind.places(system, bars_of(system), load):
        if isinstance(one, OnMember):
            spread = isinstance(one.place, Spread)
            span = (one.place.begin, one.place.end) if isinstance(one.place, Spread) else (float(one.place),) * 2
            shape = cast("Any", load).shape if spread else None
            yield _Loaded(one.member, span, shape, partial(_on_line, int(system.p[one.member]), int(system.q[one.member])))
    for on in kind.on_beams(system, load):
        beams = cast("Any", system.continua).beams
        member = system.members.index(f"{beams.names[on.beam]}{CHORD}")
        yield _Loaded(member, (float(on.begin), float(on.end)), on.shape, partial(_on_axis, beams, on.beam))


def _on_line(p: int, q: int, xi: float) -> list[list[float]]:
    return [[p, 1.0 - xi], [q, xi]]


def _on_axis(beams: BeamElements, beam: int, xi: float) -> list[list[float]]:
    factors = beams.along(np.array([xi]))[beam, 0]
    return [[int(n), float(f)] for n, f in zip(beams.nodes[beam], factors, strict=True) if f]


def _length(system: System, member: int) -> float:
    """Of a member in the model, m."""
    return float(np.linalg.norm(system.x0[system.q[member]] - system.x0[system.p[member]]))


def points_of(header: Mapping[str, Any], x: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Where the loads of a scene act, with its nodes at x (n, dim)."""
    return [
        x[one["node"]] if "node" in one else np.sum([factor * x[node] for node, factor in one["at"]], axis=0)
        for one in header["loads"]
    ]
