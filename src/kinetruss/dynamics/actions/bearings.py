"""Bearings with Coulomb friction: a couple mu r |R| on each side, against the relative turning rate."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.dynamics.actions.records import Action, Instants, couple_on_ends
from kinetruss.errors import InputError
from kinetruss.mechanics import kept
from kinetruss.model.hubs import seat_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.structure import States
    from kinetruss.mechanics import System
    from kinetruss.model import Model

__all__ = [
    "Seat",
    "actions_of_bearings",
    "couples_on_ends",
    "friction_directions",
    "refuse_bearings",
    "relative_rates",
    "seats_of",
]

STILL = 1e-10
"""Turning rates below this count as rest, rad/s: friction then resists the turning acceleration."""


class Seat(NamedTuple):
    """A bearing: member and end (0 is A), the other member (-1: ground) and its end, mu r in m, slip rate in rad/s."""

    name: str
    member: int
    end: int
    other: int
    other_end: int
    arm: float
    slip: float


@kept()
def seats_of(system: System) -> tuple[Seat, ...]:
    """The bearings of a model."""
    index = {name: i for i, name in enumerate(system.members)}
    found = []
    for name, bearing in system.model.bearings.items():
        member, end, other, other_end = seat_of(system.model, bearing)
        arm = bearing.friction * bearing.radius
        found.append(Seat(name, index[member], end, index.get(other, -1), other_end, arm, bearing.slip))
    return tuple(found)


def relative_rates(system: System, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Turning rate of the member of each bearing less that of the other part, (t, bearings, 3) rad/s; x, v (t, n, 3)."""
    found = np.zeros((len(x), len(seats_of(system)), 3))
    for k, seat in enumerate(seats_of(system)):
        found[:, k] = _turning(system, x, v, seat.member)
        if seat.other >= 0:
            found[:, k] -= _turning(system, x, v, seat.other)
    return found


def friction_directions(system: System, states: States) -> NDArray[np.float64]:
    """Unit vectors (t, bearings, 3) against which friction acts: of the turning rate, at rest of the turning acceleration."""
    x, v, a = (y.reshape(len(y), -1, 3) for y in states)
    rate, change = relative_rates(system, x, v), relative_rates(system, x, a)
    chosen = np.where(np.linalg.norm(rate, axis=2, keepdims=True) > STILL, rate, change)
    size = np.linalg.norm(chosen, axis=2, keepdims=True)
    return np.asarray(np.divide(chosen, size, out=np.zeros_like(chosen), where=size > STILL))


def couples_on_ends(
    system: System, x: NDArray[np.float64], couple: NDArray[np.float64]
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Nodes (k,) and forces (t, k, 3), N, equivalent to the couples (t, bearings, 3), N m, on the members of bearings."""
    nodes, forces = [], []
    for k, seat in enumerate(seats_of(system)):
        for i, sign in ((seat.member, 1.0), (seat.other, -1.0)):
            if i >= 0:
                ends = couple_on_ends(system, x, i, sign * couple[:, k])
                nodes += [system.p[i], system.q[i]]
                forces += [ends[:, 0], ends[:, 1]]
    return np.array(nodes, np.int64), np.stack(forces, axis=1)


def actions_of_bearings(system: System) -> Iterator[Action]:
    """The couples on both members of each bearing, at their joints."""
    for k, seat in enumerate(seats_of(system)):
        for i, end, sign in ((seat.member, seat.end, 1.0), (seat.other, seat.other_end, -1.0)):
            if i >= 0:
                yield Action(source=seat.name, kind="bearing", member=i, worth=partial(_rubbed, k, i, sign), place=float(end))


def _rubbed(k: int, i: int, sign: float, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of bar i, (t, 2, 3) N, equivalent to the couple of bearing k; none at rest."""
    if here.carried is None or not here.carried.couple.shape[1]:
        return np.zeros((len(here.x), 2, 3))
    return couple_on_ends(here.system, here.x, i, sign * here.carried.couple[:, k])


def _turning(system: System, x: NDArray[np.float64], v: NDArray[np.float64], i: int) -> NDArray[np.float64]:
    """Turning rate of bar i across its axis, d x d'/L^2, (t, 3) rad/s."""
    d, rate = (y[:, system.q[i]] - y[:, system.p[i]] for y in (x, v))
    return np.asarray(np.cross(d, rate) / np.einsum("tc,tc->t", d, d)[:, None])


def refuse_bearings(model: Model, what: str) -> None:
    """Refuse an analysis that does not have friction which follows from forces.

    Raises
    ------
    InputError : the model has bearings.
    """
    if model.bearings:
        raise InputError(
            f"{what} does not include the friction of bearings ({', '.join(model.bearings)}), which follows from forces and "
            "jumps with the direction. Use dynamics.inverse, or leave them out: model.with_(bearings={}); viscous friction of "
            "bars is included."
        )
