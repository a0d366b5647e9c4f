"""Forces on nodes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.elements.loads.follower import FORCE, Follower
from kinetruss.elements.loads.load import Load, OnMember, OnOthers

if TYPE_CHECKING:
    from kinetruss.mechanics.bars import Bars
    from kinetruss.mechanics.system import System
    from kinetruss.model import NodalForce


def _units(system: System, load: NodalForce) -> tuple[Follower, ...]:
    nodes, data = np.array([system.node_index(load.node)], np.int64), np.array([[0.0, 0.0, 1.0, 0.0]])
    return tuple(Follower(mode=FORCE, nodes=nodes, data=data, vector=np.append(axis, 0.0)) for axis in np.eye(3)[: system.dim])


def _places(system: System, bars: Bars, load: NodalForce) -> Iterator[OnMember | OnOthers]:  # noqa: ARG001
    yield from ()


FORCES = Load(_units, _places)
