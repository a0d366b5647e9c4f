"""Viscous friction about pins of planar structures: a torque against what two bars turn at one pin, or one bar on the ground.

A damper on the angle between the two bars, q = angle of the first - angle of the second: friction c (N m s) gives the torque
c q' and takes the power c q'^2.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.elements.scalars import Part
from kinetruss.elements.spring import DAMPING, law
from kinetruss.kernels.coordinates.forms import FIXED_AXIS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


class Pins(NamedTuple):
    """Pairs of bars with friction between them. node (k,) of the pin; first, second (k,) the bars (second = -1: the ground);
    friction (k,) N m s.
    """

    node: NDArray[np.int64]
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    friction: NDArray[np.float64]


@cached()
def pins_of(system: System) -> Pins:
    """Where friction acts about pins.

    The bearings of all bars at a node turn about one pin without mass. It stands still where the node is fixed, guided or
    driven; else it turns so that their torques are in balance. With such a pin left out, the bearings c_i and c_j of two bars
    are worth c_i c_j/sum c between them; two bars between the same nodes turn alike.
    """
    held = np.any(system.prescribed.reshape(-1, 3)[:, :2], axis=1).tolist()
    ends = np.stack([system.p, system.q], axis=1)
    found: list[tuple[int, int, int, float]] = []
    # bearings at each node: on the ground, or c_i c_j/sum c between each two bars
    for node in np.unique(ends[system.friction > 0.0]).tolist():
        member, end = np.nonzero((ends == node) & (system.friction > 0.0))
        c = system.friction[member, end]
        if held[node]:
            found += [(node, m, -1, own) for m, own in zip(member.tolist(), c.tolist(), strict=True)]
            continue
        far = ends[member, 1 - end]
        for i, j in combinations(range(len(c)), 2):
            if far[i] != far[j]:
                found.append((node, int(member[i]), int(member[j]), float(c[i] * c[j] / c.sum())))
    node_of, first, second, friction = zip(*found, strict=True) if found else ((), (), (), ())
    return Pins(np.array(node_of, np.int64), np.array(first, np.int64), np.array(second, np.int64), np.array(friction, float))


def pins(system: System) -> Part:
    """The pairs of `pins_of` as elements on coordinates."""
    node, first, second, friction = pins_of(system)
    count, pair = len(node), second >= 0
    far = np.stack([system.p[first] + system.q[first] - node, np.where(pair, system.p[second] + system.q[second] - node, node)])
    # the angle of the first bar, and that of the second taken off it; those on the ground have the first alone
    which, side = np.nonzero(np.stack([np.ones(count, bool), pair], axis=1))
    at = 3 * np.stack([far[side, which], node[which], node[which], node[which]], axis=1)
    data = np.zeros((len(which), 7))
    data[:, 0], data[:, 1], data[:, 5] = np.where(side == 0, 1.0, -1.0), 1.0, 1.0
    numbers = np.zeros((count, 6))
    numbers[:, DAMPING] = friction
    return Part(
        names=(),
        law=law,
        bent="",
        loses=np.ones(count, np.int64),
        linear=np.ones(count, np.int64),
        ptr=np.cumsum([0, *(1 + pair)]),
        kind=np.full(len(which), FIXED_AXIS),
        at=at,
        data=data,
        rest=np.zeros(count),
        period=np.full(count, 2.0 * np.pi),
        numbers=numbers,
        table_ptr=np.zeros(count + 1, np.int64),
        table=np.zeros((0, 4)),
    )
