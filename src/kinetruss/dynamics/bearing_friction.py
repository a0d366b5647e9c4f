"""Bearings with Coulomb friction: a couple mu r |R| on each side, against the relative turning rate."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.dynamics.action_couples import hinges_of, through_arm
from kinetruss.dynamics.actions import Action, Instants
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.structure.bearings import Bearings, forces_of_couples, turning_rates
from kinetruss.mechanics import cached
from kinetruss.mechanics.frames import cross
from kinetruss.model.hub_arms import is_grounded
from kinetruss.model.hub_expansion import seat_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.structure import States
    from kinetruss.mechanics import System
    from kinetruss.model import Model


STILL = 1e-10
"""Turning rates below this count as rest, rad/s: friction then resists the turning acceleration."""


class Turn(NamedTuple):
    """A hinge: the nodes at the joint, on the axis, at the far end of the member and of the hub off the axis (-1: ground);
    carriers (k,) of the hub; the arm, a member.
    """

    joint: int
    axis: int
    far: int
    hub: int
    carriers: tuple[int, ...]
    arm: int


class Seat(NamedTuple):
    """A bearing: member and end (0 is A), the other member (-1: ground) and its end, mu r in m, slip rate in rad/s; on the
    hinge of a hub its `Turn`.
    """

    name: str
    member: int
    end: int
    other: int
    other_end: int
    arm: float
    slip: float
    turn: Turn | None


@cached()
def seats_of(system: System) -> tuple[Seat, ...]:
    """The bearings of a model."""
    index = {name: i for i, name in enumerate(system.members)}
    found = []
    for name, bearing in system.model.bearings.items():
        member, end, other, other_end = seat_of(system.model, bearing)
        arm = bearing.friction * bearing.radius
        turn = _turn(system, bearing.node, bearing.member)
        found.append(Seat(name, index[member], end, index.get(other, -1), other_end, arm, bearing.slip, turn))
    return tuple(found)


def _turn(system: System, hub: str, member: str) -> Turn | None:
    """The hinge of a member at a hub, if it has one."""
    pivot = next((one for one in hinges_of(system) if (one.hub, one.member) == (hub, member)), None)
    if pivot is None:
        return None
    at = system.node_index
    body = system.model.bodies.get(f"{hub}.hub")
    fixed = is_grounded(system.model, hub) or body is None
    nodes = () if fixed or body is None else tuple(at(node) for node in body.nodes)
    d = system.x0[list(nodes)] - system.x0[at(pivot.tip)]
    off = np.linalg.norm(np.cross(d, pivot.axis), axis=1)
    carriers = () if fixed or body is None else tuple(at(node) for node in body.carried_by(system.dim))
    return Turn(
        joint=at(pivot.tip),
        axis=at(pivot.nodes[0]),
        far=at(pivot.far),
        hub=nodes[int(np.argmax(off))] if nodes else -1,
        carriers=carriers,
        arm=system.members.index(pivot.tip),
    )


@cached()
def bearings_of(system: System) -> Bearings:
    """The bearings of a model for kernels."""
    seats, p, q = seats_of(system), system.p, system.q
    pin, turn = (np.full((len(seats), 4), -1, np.int64) for _ in range(2))
    nodes: list[list[int]] = []
    for k, seat in enumerate(seats):
        if seat.turn is not None:
            turn[k] = [
                3 * node if node >= 0 else -1 for node in (seat.turn.joint, seat.turn.axis, seat.turn.far, seat.turn.hub)
            ]
            nodes.append([seat.turn.far, seat.turn.joint, *seat.turn.carriers])
            continue
        nodes.append([end for i in (seat.member, seat.other) if i >= 0 for end in (p[i], q[i])])
        pin[k, : len(nodes[-1])] = 3 * np.array(nodes[-1])
    return Bearings.of(
        {
            "pin": pin,
            "turn": turn,
            "ptr": np.cumsum([0, *map(len, nodes)]),
            "node": 3 * np.array([node for own in nodes for node in own], np.int64),
            "arm": np.array([seat.arm for seat in seats], float),
            "slip": np.array([seat.slip for seat in seats], float),
        }
    )


def relative_rates(system: System, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Turning rate of the member of each bearing less that of the other part, (t, bearings, 3) rad/s; x (t, n, 3), v the same
    or (1, n, 3).
    """
    found = np.empty((len(x), len(seats_of(system)), 3))
    turning_rates(bearings_of(system), _flat(x), _flat(v), found)
    return found


def _flat(y: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.ascontiguousarray(y).reshape(len(y), -1)


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
    own = bearings_of(system)
    found = np.zeros((len(x), len(own.node), 3))
    forces_of_couples(own, _flat(x), np.ascontiguousarray(couple, dtype=float), found)
    return own.node // 3, found


def rows_on_hub(system: System, hub: str) -> list[int]:
    """Where the nodes that carry a hub stand among those of `couples_on_ends`, by all hinges of the hub."""
    own, bearings = bearings_of(system), system.model.bearings.values()
    turning = (k for k, one in enumerate(bearings) if one.node == hub and own.turn[k, 0] >= 0)
    return [row for k in turning for row in range(own.ptr[k] + 2, own.ptr[k + 1])]


def friction_on_hub(here: Instants, hub: str) -> list[tuple[int, NDArray[np.float64]]]:
    """Nodes of a hub and the forces (t, 3), N, on them that its share of friction in hinges is worth."""
    if (found := _rubbing(here)) is None:
        return []
    node = bearings_of(here.system).node // 3
    return [(int(node[row]), found[:, row]) for row in rows_on_hub(here.system, hub)]


def friction_on_arms(system: System, x: NDArray[np.float64], couple: NDArray[np.float64]) -> dict[int, NDArray[np.float64]]:
    """By arm (a member), the couple (t, 3), N m, of friction in its hinge; couple (t, bearings, 3) on members of bearings."""
    forces = couples_on_ends(system, x, couple)[1]
    return {one.turn.arm: _on_arm(system, x, k, forces) for k, one in enumerate(seats_of(system)) if one.turn is not None}


def _on_arm(system: System, x: NDArray[np.float64], k: int, forces: NDArray[np.float64]) -> NDArray[np.float64]:
    """The couple (t, 3), N m, of bearing k on the hub: the opposite of the moment of its forces on the member."""
    far, joint = (int(place) // 3 for place in bearings_of(system).turn[k, [2, 0]])
    return -cross(x[:, far] - x[:, joint], forces[:, bearings_of(system).ptr[k]])


def actions_of_bearings(system: System) -> Iterator[Action]:
    """The couples on both members of each bearing, at their joints."""
    seats, first = seats_of(system), bearings_of(system).ptr.tolist()
    for k, seat in enumerate(seats):
        if seat.turn is not None:
            row, arm = first[k], system.members[seat.turn.arm]
            yield _on_member(seat, seat.member, (row, row + 1) if seat.end else (row + 1, row), seat.end)
            yield from through_arm(system, arm, (seat.name, seat.name), "bearing", partial(_rubbed_hub, k))
    for seat, row in zip(seats, first, strict=False):
        if seat.turn is None:
            yield _on_member(seat, seat.member, (row, row + 1), seat.end)
            if seat.other >= 0:
                yield _on_member(seat, seat.other, (row + 2, row + 3), seat.other_end)


def _on_member(seat: Seat, member: int, rows: tuple[int, int], end: int) -> Action:
    return Action(source=seat.name, kind="bearing", member=member, worth=partial(bearing_push, rows), place=float(end))


def _rubbing(here: Instants) -> NDArray[np.float64] | None:
    """Forces of friction on the nodes of `couples_on_ends`, (t, k, 3) N; None at rest."""
    if here.carried is None or not here.carried.couple.shape[1]:
        return None
    if "bearings" not in here.found:
        here.found["bearings"] = couples_on_ends(here.system, here.x, here.carried.couple)[1]
    return here.found["bearings"]


def bearing_push(rows: tuple[int, int], here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of a member, (t, 2, 3) N, equivalent to the couple of its bearing; none at rest."""
    found = _rubbing(here)
    return np.zeros((len(here.x), 2, 3)) if found is None else found[:, list(rows)]


def _rubbed_hub(k: int, here: Instants) -> NDArray[np.float64]:
    """The couple (t, 3), N m, of bearing k on the hub; none at rest."""
    found = _rubbing(here)
    return np.zeros((len(here.x), 3)) if found is None else _on_arm(here.system, here.x, k, found)


def jam(worst: str) -> AnalysisError:
    """The error of couples that do not settle."""
    return AnalysisError(
        f"The friction of bearing {worst!r} does not settle: the joint jams. Give it less friction or a smaller radius, or "
        "stay farther from positions in which its members line up."
    )


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
