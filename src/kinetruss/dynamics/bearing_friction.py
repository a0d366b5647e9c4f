"""Bearings with Coulomb friction: a couple mu r |R| on each side, against the relative turning rate."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.dynamics.action_couples import hinges_of
from kinetruss.dynamics.actions import Action, Instants, couple_on_ends
from kinetruss.errors import InputError
from kinetruss.mechanics import cached
from kinetruss.mechanics.frames import across_bars, cross
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


class Sides(NamedTuple):
    """The members that bearings rub which are not hinges: seat, member, and 1 of its member or -1 of the other, (k,) each."""

    seat: NDArray[np.int64]
    member: NDArray[np.int64]
    sign: NDArray[np.float64]


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


@cached()
def _sides(system: System) -> Sides:
    """The sides of all bearings, in the order of the bearings."""
    found = [
        (k, i, sign)
        for k, seat in enumerate(seats_of(system))
        for i, sign in ((seat.member, 1.0), (seat.other, -1.0))
        if seat.turn is None and i >= 0
    ]
    seat, member, sign = (np.array([one[c] for one in found]) for c in range(3))
    return Sides(seat.astype(np.int64), member.astype(np.int64), sign.astype(float))


@cached()
def _turning_pairs(system: System) -> tuple[NDArray[np.float64], tuple[tuple[int, Turn], ...]]:
    """How the rates of sides add up to those of bearings (bearings, sides), and the hinges."""
    sides, seats = _sides(system), seats_of(system)
    sums = np.zeros((len(seats), len(sides.seat)))
    sums[sides.seat, np.arange(len(sides.seat))] = sides.sign
    return sums, tuple((k, seat.turn) for k, seat in enumerate(seats) if seat.turn is not None)


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


def _across(x: NDArray[np.float64], turn: Turn, node: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The axis of a hinge as a unit vector, and the vector from it to a node, (t, 3) each."""
    a = x[:, turn.axis] - x[:, turn.joint]
    a = a / np.linalg.norm(a, axis=1)[:, None]
    d = x[:, node] - x[:, turn.joint]
    return a, d - np.einsum("tc,tc->t", d, a)[:, None] * a


def _hinge_rate(x: NDArray[np.float64], v: NDArray[np.float64], turn: Turn) -> NDArray[np.float64]:
    """Turning rate of the member less that of the hub about the axis of their hinge, (t, 3) rad/s."""
    found = np.zeros((len(x), 3))
    for node, sign in ((turn.far, 1.0), (turn.hub, -1.0)):
        if node < 0:
            continue
        a, r = _across(x, turn, node)
        base = x[:, turn.axis] - x[:, turn.joint]
        # the foot of the node on the axis moves with the axis: v_foot = v_joint + s (v_axis - v_joint)
        s = np.einsum("tc,tc->t", x[:, node] - x[:, turn.joint], base) / np.einsum("tc,tc->t", base, base)
        foot = v[:, turn.joint] + s[:, None] * (v[:, turn.axis] - v[:, turn.joint])
        rate = np.einsum("tc,tc->t", cross(r, v[:, node] - foot), a) / np.einsum("tc,tc->t", r, r)
        found += (sign * rate)[:, None] * a
    return found


def _on_hinge(
    x: NDArray[np.float64], turn: Turn, couple: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force (t, 3), N, on the far end of the member, its opposite at the joint, that a couple C about the axis of a hinge is
    worth, C x r/r^2, and the couple on the hub (t, 3), N m: the opposite of the moment of both.
    """
    _, r = _across(x, turn, turn.far)
    force = cross(couple, r) / np.einsum("tc,tc->t", r, r)[:, None]
    return force, -cross(x[:, turn.far] - x[:, turn.joint], force)


def _spread(x: NDArray[np.float64], nodes: tuple[int, ...], couple: NDArray[np.float64]) -> NDArray[np.float64]:
    """The smallest forces on nodes (t, k, 3), N, that are worth a couple: a x r_i with (sum |r|^2 1 - r r^T) a = C."""
    r = x[:, list(nodes)]
    r = r - r.mean(axis=1, keepdims=True)
    G = np.einsum("tkc,tkc->t", r, r)[:, None, None] * np.eye(3) - np.einsum("tki,tkj->tij", r, r)
    return np.asarray(cross(np.linalg.solve(G, couple[:, :, None])[:, None, :, 0], r))


def friction_on_hub(here: Instants, hub: str) -> list[tuple[int, NDArray[np.float64]]]:
    """Nodes of a hub and the forces (t, 3), N, on them that its share of friction in hinges is worth."""
    if here.carried is None or not here.carried.couple.shape[1]:
        return []
    found = []
    for k, (seat, bearing) in enumerate(zip(seats_of(here.system), here.system.model.bearings.values(), strict=True)):
        if seat.turn is not None and seat.turn.carriers and bearing.node == hub:
            forces = _spread(here.x, seat.turn.carriers, _on_hinge(here.x, seat.turn, here.carried.couple[:, k])[1])
            found += [(node, forces[:, n]) for n, node in enumerate(seat.turn.carriers)]
    return found


def friction_on_arms(system: System, x: NDArray[np.float64], couple: NDArray[np.float64]) -> dict[int, NDArray[np.float64]]:
    """By arm (a member), the couple (t, 3), N m, of friction in its hinge; couple (t, bearings, 3) on members of bearings."""
    turns = ((k, seat.turn) for k, seat in enumerate(seats_of(system)))
    return {turn.arm: _on_hinge(x, turn, couple[:, k])[1] for k, turn in turns if turn is not None}


def relative_rates(system: System, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Turning rate of the member of each bearing less that of the other part, (t, bearings, 3) rad/s; x, v (t, n, 3)."""
    (sums, turns), member = _turning_pairs(system), _sides(system).member
    d, rate = (y[:, system.q[member]] - y[:, system.p[member]] for y in (x, v))
    found = sums @ (cross(d, rate) / np.einsum("tkc,tkc->tk", d, d)[:, :, None])
    for k, turn in turns:
        found[:, k] = _hinge_rate(x, v, turn)
    return np.asarray(found)


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
    sides = _sides(system)
    push = across_bars(system, x, sides.member, couple[:, sides.seat] * sides.sign[:, None])
    nodes, forces = [system.p[sides.member], system.q[sides.member]], [-push, push]
    for k, turn in _turning_pairs(system)[1]:
        on_member, on_hub = _on_hinge(x, turn, couple[:, k])
        nodes.append(np.array([turn.far, turn.joint, *turn.carriers]))
        forces.append(np.stack([on_member, -on_member], axis=1))
        if turn.carriers:
            forces.append(_spread(x, turn.carriers, on_hub))
    return np.concatenate(nodes), np.concatenate(forces, axis=1)


def actions_of_bearings(system: System) -> Iterator[Action]:
    """The couples on both members of each bearing, at their joints."""
    for k, seat in enumerate(seats_of(system)):
        if seat.turn is not None:
            worth, tip = partial(_rubbed_member, k, seat), int(system.q[seat.turn.arm] == seat.turn.joint)
            yield Action(source=seat.name, kind="bearing", member=seat.member, worth=worth, place=float(seat.end))
            for sign, place in ((1.0, tip), (-1.0, 1 - tip)):  # enters the arm at its tip, and the centre holds it
                worth = partial(_rubbed_arm, k, seat.turn, sign)
                yield Action(source=seat.name, kind="bearing", member=seat.turn.arm, worth=worth, place=float(place))
    for n, (k, i, sign) in enumerate(zip(*_sides(system), strict=True)):
        seat = seats_of(system)[k]
        end = seat.end if sign > 0 else seat.other_end
        yield Action(source=seat.name, kind="bearing", member=int(i), worth=partial(_rubbed, n), place=float(end))


def _rubbed(n: int, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of the bar of side n, (t, 2, 3) N, equivalent to the couple of its bearing; none at rest."""
    if here.carried is None or not here.carried.couple.shape[1]:
        return np.zeros((len(here.x), 2, 3))
    if "bearings" not in here.found:
        sides = _sides(here.system)
        couple = here.carried.couple[:, sides.seat] * sides.sign[:, None]
        push = across_bars(here.system, here.x, sides.member, couple)
        here.found["bearings"] = np.stack([-push, push], axis=2)
    return here.found["bearings"][:, n]


def _rubbed_member(k: int, seat: Seat, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of the member of a hinge, (t, 2, 3) N, that the couple of bearing k is worth."""
    found = np.zeros((len(here.x), 2, 3))
    if seat.turn is not None and here.carried is not None and here.carried.couple.shape[1]:
        push = _rubbed_hinge(k, seat.turn, here, here.carried.couple)[0]
        found[:, 1 - seat.end], found[:, seat.end] = push, -push
    return found


def _rubbed_arm(k: int, turn: Turn, sign: float, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of the arm of a hinge, (t, 2, 3) N, worth the part across it of what bearing k does to the hub."""
    if here.carried is None or not here.carried.couple.shape[1]:
        return np.zeros((len(here.x), 2, 3))
    return couple_on_ends(here.system, here.x, turn.arm, sign * _rubbed_hinge(k, turn, here, here.carried.couple)[1])


def _rubbed_hinge(k: int, turn: Turn, here: Instants, couple: NDArray[np.float64]) -> NDArray[np.float64]:
    """What `_on_hinge` gives for bearing k, (2, t, 3); couple (t, bearings, 3), N m."""
    if f"bearing {k}" not in here.found:
        here.found[f"bearing {k}"] = np.stack(_on_hinge(here.x, turn, couple[:, k]))
    return here.found[f"bearing {k}"]


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
