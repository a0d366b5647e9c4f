"""Viscous friction about pins of planar structures: a torque against what two bars turn at one pin, or one bar on the ground.

A damper on the angle between the two bars, q = angle of the first - angle of the second: friction c (N m s) gives the torque
c q' and takes the power c q'^2.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.elements.caching import cached
from kinetruss.elements.numbers import chosen
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
    ends, friction = np.stack([system.p, system.q], axis=1), system.friction
    rubs = chosen((friction.real > 0.0).reshape(*friction.shape[:-2], -1), "bearings with friction").reshape(-1, 2)
    found: list[tuple[int, int, int]] = []
    amounts: list[Any] = []
    # bearings at each node: on the ground, or c_i c_j/sum c between each two bars
    for node in np.unique(ends[rubs]).tolist():
        member, end = np.nonzero((ends == node) & rubs)
        c = np.moveaxis(friction[..., member, end], -1, 0)
        if held[node]:
            found += [(node, m, -1) for m in member.tolist()]
            amounts += list(c)
            continue
        far = ends[member, 1 - end]
        for i, j in combinations(range(len(c)), 2):
            if far[i] != far[j]:
                found.append((node, int(member[i]), int(member[j])))
                amounts.append(c[i] * c[j] / c.sum(axis=0))
    node_of, first, second = np.array(found, np.int64).reshape(-1, 3).T
    return Pins(node_of, first, second, np.moveaxis(np.array(amounts, friction.dtype).reshape(-1, *friction.shape[:-2]), 0, -1))


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
    lead = friction.shape[:-1]
    numbers = np.zeros((*lead, count, 6), friction.dtype)
    numbers[..., DAMPING] = friction
    return Part(
        names=(),
        law=law,
        bent="",
        loses=np.ones(count, np.int64),
        linear=np.ones(count, np.int64),
        ptr=np.cumsum([0, *(1 + pair)]),
        kind=np.full(len(which), FIXED_AXIS),
        at=at,
        data=np.broadcast_to(data, (*lead, *data.shape)),
        rest=np.zeros((*lead, count)),
        period=np.full((*lead, count), 2.0 * np.pi),
        numbers=numbers,
        table_ptr=np.zeros(count + 1, np.int64),
        table=np.zeros((0, 4)),
    )
