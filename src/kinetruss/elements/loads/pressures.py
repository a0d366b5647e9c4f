"""Pressures on faces and edges."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.loads.follower import FORCE, Follower
from kinetruss.elements.loads.load import Load, OnMember, OnOthers, Spread

if TYPE_CHECKING:
    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System
    from kinetruss.model import Pressure


def _units(system: System, load: Pressure) -> tuple[Follower, ...]:
    nodes = np.array([system.node_index(node) for node in load.face], np.int64)
    depth = np.asarray(load.depth)
    data, vector = np.zeros((*depth.shape, len(nodes), 4), depth.dtype), np.zeros(4)
    data[..., 2] = 1.0 / len(nodes)
    if len(nodes) == 2:
        data[..., 0, 1], data[..., 1, 1] = -depth, depth
    else:
        # seen from where the pressure acts, the nodes run counter-clockwise: the normal points against the pressure
        vector[3] = -0.5
    return (Follower(mode=FORCE, nodes=nodes, data=data, vector=vector),)


def _places(system: System, bars: Bars, load: Pressure) -> Iterator[OnMember | OnOthers]:
    nodes = [system.node_index(node) for node in load.face]
    sheets: tuple[Any, ...] = (*system.model.membranes.values(), *system.model.solids.values())
    if any(set(load.face) <= set(one.nodes) for one in sheets):
        return  # it acts on the membrane or solid
    i = bars.between(nodes[0], nodes[1]) if len(nodes) == 2 else -1
    if i >= 0 and not system.two_rods[i]:
        yield OnMember(i, Spread())
        return
    beams = tuple(beam for beam, one in system.model.beams.items() if set(one.ends) <= set(load.face))
    if inside := (*bars.inside(set(nodes)), *beams):
        yield OnOthers(tuple(load.face), inside)


PRESSURES = Load(_units, _places)
