"""Friction about a pin: a couple on each of its bars, at the pin."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.actions.records import Action, Instants
from kinetruss.mechanics import ends_of, turned
from kinetruss.mechanics.assembly import pins_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["actions_of_friction"]


def actions_of_friction(system: System) -> Iterator[Action]:
    """The couples on bars that turn about pins with friction."""
    pins = pins_of(system)
    second = pins.second >= 0
    member, node = np.append(pins.first, pins.second[second]), np.append(pins.node, pins.node[second])
    for i, at in sorted(set(zip(member.tolist(), node.tolist(), strict=True))):
        place = float(system.q[i] == at)
        yield Action(source=system.nodes[at], kind="friction", member=i, worth=partial(_held_back, i, at), place=place)


def _held_back(i: int, node: int, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of bar i, (times, 2, 3) N, equivalent to the couple of all its pairs at a node."""
    pins, torque = pins_of(here.system), here.pin_torque
    at = pins.node == node
    couple = torque[:, at & (pins.second == i)].sum(axis=1) - torque[:, at & (pins.first == i)].sum(axis=1)
    _, L, u = ends_of(here.system, here.x, i)
    push = (couple / L)[:, None] * turned(u)
    return np.stack([-push, push], axis=1)
