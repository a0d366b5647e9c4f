"""The bars on which drives, couplings, springs and hinges of hubs act, and the couples that they pass.

A source acts on frames (`kinetruss.mechanics.frames`). Here the bars of a frame take what it does: a couple about an axis the
bars from there to the node that turns, at the axis; an angle or a length of a named bar that bar, at its end that is held
(`Bars.pivot`); the offset of a node from a line, and coordinates of nodes that keep a pin at a place of a bar, the bar that
the line or the pin is on, at that place, else bars from the node to the others, which it bends at the node.
How several bars within one rigid frame share it, statics does not say: the bars to the axis or the line count.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.actions import Action, Instants, NotOnBars
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics import cached, ends_of
from kinetruss.mechanics.bars import Bars, bars_of
from kinetruss.mechanics.frames import Side, bar_pushes, resultant, side_forces, sides_of
from kinetruss.model.hub_expansion import Pivot

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from kinetruss.mechanics import System


Found = Iterator[Action | NotOnBars]
PARALLEL = 1e-9
"""Parts of a force below this fraction of it are round-off."""
BALANCED = 1e-3
"""Largest distance of a pin from its place on a bar, as a fraction of the coupled length."""


def actions_of_drives(system: System, bars: Bars) -> Found:
    """Actions of drives, couplings and springs on bars, and those that no bar carries."""
    # angles of bars in the plane have rows of their own, which belong to the bar
    for r in np.flatnonzero((system.row_kind == ANGLE) & (system.row_drive >= 0)):
        i, key = int(system.row_member[r]), ("drive", system.drives[system.row_drive[r]])
        couple = partial(_torque, key)
        yield Action(source=key[1], kind=key[0], member=i, place=float(bars.pivot(i)), couple=couple, counted=True)
    spins = {("coupling", one.coupling) for one in system.inner.spins}
    for k, side in enumerate(sides_of(system)):
        if side.source in spins:
            # it bends nothing: what it holds, nothing else drives or loads
            continue
        if side.member >= 0:
            yield _spoke(bars, k, side, 1, side.member, bars.pivot(side.member))
        elif side.turns:
            yield from _turned(system, bars, k, side)
        else:
            yield from _pressed(system, bars, k, side)


def _torque(key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    return np.multiply.outer(here.amounts[key], (0.0, 0.0, 1.0))


def _turned(system: System, bars: Bars, k: int, side: Side) -> Found:
    """A couple about an axis: on the bars from its nodes to the one that turns, there."""
    P, *axis = side.nodes
    size = np.abs(side_forces(system, side, system.x0[None])[0]).max(axis=1)
    for column, node in enumerate(axis, start=1):
        if (i := bars.between(P, node)) >= 0:
            yield _spoke(bars, k, side, column, i, bars.ends(i).index(node))
        elif not size[column] <= PARALLEL * size[0]:
            yield from _on_no_bar(system, bars, side, (P, node))


def _pressed(system: System, bars: Bars, k: int, side: Side) -> Found:
    """Forces on a line and a node off it: on the bar along the line, else on those from the node; so with a pin on a bar."""
    line, centres, found = side.nodes[1:], side.nodes[:1], list[int]()
    if side.weights is not None:
        line = centres = side.nodes
        if len(line) < 3 or not _in_balance(system, side):
            if any(bars.between(a, b) >= 0 for a, b in combinations(line, 2)):
                yield from _on_no_bar(system, bars, side, line)
            return
        found = _bars_across(system, bars, side)
    elif (i := bars.between(*line)) >= 0:
        found, centres = [i] if not system.two_rods[i] else [], ()
    for i in found:
        columns = [side.nodes.index(node) for node in bars.ends(i)]
        yield _action(side, i, partial(_share, columns, k, side), partial(side_push, columns, np.ones(2), k, side))
    for M in () if found else centres:
        spokes = [(column, bars.between(M, n)) for column, n in enumerate(side.nodes) if n != M]
        if min(i for _, i in spokes) >= 0:
            for column, i in spokes:
                yield _spoke(bars, k, side, column, i, bars.ends(i).index(M))
            return
    if not found:
        yield from _on_no_bar(system, bars, side, line)


def _action(
    side: Side, i: int, place: float | Callable[..., NDArray[np.float64]], worth: Callable[..., NDArray[np.float64]]
) -> Action:
    return Action(source=side.source[1], kind=side.source[0], member=i, place=place, worth=worth)


def _spoke(bars: Bars, k: int, side: Side, column: int, i: int, place: int) -> Action:
    """The force on one node of a side as two opposite forces on bar i, which ends there."""
    signs = np.array([1.0, -1.0] if bars.ends(i)[0] == side.nodes[column] else [-1.0, 1.0])
    return _action(side, i, float(place), partial(side_push, [column, column], signs, k, side))


def _units(k: int, side: Side, here: Instants) -> NDArray[np.float64]:
    if (name := f"side {k}") not in here.found:
        here.found[name] = side_forces(here.system, side, here.x)
    return here.found[name]


def side_push(columns: list[int], signs: NDArray[np.float64], k: int, side: Side, here: Instants) -> NDArray[np.float64]:
    """Forces on two nodes of a side, (t, 2, 3) N."""
    return np.asarray(here.amounts[side.source][:, None, None] * (signs[:, None] * _units(k, side, here)[:, columns]))


def _share(columns: list[int], k: int, side: Side, here: Instants) -> NDArray[np.float64]:
    """Where two parallel forces have their resultant, as a fraction from the first to the second."""
    both = _units(k, side, here)[:, columns]
    whole = both.sum(axis=1)
    return np.asarray(np.vecdot(both[:, 1], whole) / np.vecdot(whole, whole))


def _on_no_bar(system: System, bars: Bars, side: Side, nodes: tuple[int, ...]) -> Found:
    """The action that no bar carries; none if the nodes are fixed."""
    if not bars.ground.issuperset(nodes):
        names = tuple(dict.fromkeys(system.nodes[n] for n in nodes))
        yield NotOnBars(source=side.source[1], kind=side.source[0], nodes=names, members=bars.touching(nodes))


def _in_balance(system: System, side: Side) -> bool:
    """True if the forces and moments of a coupling sum to zero, so that it acts between the coupled parts only."""
    x, w = system.x0[list(side.nodes)], side.weights
    x = x - x.mean(axis=0)
    largest = float(np.abs(w).max())
    still = np.abs(w.sum(axis=0)).max() <= BALANCED * largest
    return bool(still and np.abs(np.cross(x, w).sum(axis=0)).max() <= BALANCED * largest * float(np.abs(x).max()))


def _bars_across(system: System, bars: Bars, side: Side) -> list[int]:
    """Bars whose two ends take a force: those with the pin between their ends; for three nodes else one with the pin beyond."""
    alike: list[int] = []
    beyond: list[int] = []
    for (a, one), (b, two) in combinations(zip(side.nodes, side.weights, strict=True), 2):
        i, W = bars.between(a, b), one + two
        if i < 0 or system.two_rods[i] or not np.abs(W).max() > PARALLEL * np.abs(one).max():
            continue
        if np.abs(np.cross(one, two)).max() > PARALLEL * float(W @ W):
            continue
        (alike if one @ two > 0 else beyond).append(i)
    found: list[int] = []
    used: set[int] = set()
    for i in alike or (beyond[:1] if len(side.nodes) == 3 else []):
        if not used.intersection(bars.ends(i)):
            found.append(i)
            used.update(bars.ends(i))
    return found


# Hinges of hubs in space: the couples that they pass between a member and the arm of its hub.
#
# A hinge is a rigid body of the member and of nodes on the axis that belong to the hub, or two bars of equal lengths from
# there to the far end of a member whose length changes. The forces of these bars on the hub make a force f at the joint and a
# couple c about it. Here they are given back to the member: f at its joint, -c as a couple that bends it there; +c twists and
# bends the arm.


@cached()
def hinges_of(system: System) -> tuple[Pivot, ...]:
    """The hinges of hubs."""
    return tuple(system.inner.pivots)


def hinge_bodies(system: System) -> set[str]:
    """Names of the bodies that hold members to the axes of their hinges."""
    return {one.body for one in hinges_of(system) if one.steady and not one.clamped}


@cached()
def bars_of_hinges(system: System) -> frozenset[int]:
    """Bars whose forces the members and arms of hinges take."""
    bars = bars_of(system)
    return frozenset(k for one in hinges_of(system) for k in bars_of_hinge(system, bars, one))


def bars_of_hinge(system: System, bars: Bars, pivot: Pivot) -> list[int]:
    """The bars that join the nodes on the axis of a hinge with its member."""
    if not pivot.steady:
        return [bars.index[name] for name in pivot.bars]
    return [i for i, name in enumerate(system.members) if bars.brace[i] and name.startswith(f"{pivot.body}.")]


def through_arm(
    system: System, arm: str, sources: tuple[str, str], kind: str, couple: Callable[[Instants], NDArray[np.float64]]
) -> Iterator[Action]:
    """A couple (t, 3), N m, that enters a hub at the tip of an arm, and its opposite at the centre, each with its source."""
    i = system.members.index(arm)
    yield Action(source=sources[0], kind=kind, member=i, place=1.0, couple=couple)
    yield Action(source=sources[1], kind=kind, member=i, place=0.0, couple=lambda here: -couple(here))


def actions_of_hinges(system: System, bars: Bars) -> Iterator[Action]:
    """The couples of hinges on their members, with the axial force of their bars, and on the arms."""
    met = set[str]()
    for k, pivot in enumerate(hinges_of(system)):
        i, couple = bars.index[pivot.member], partial(hinge_couple, k)
        # of a member clamped at its other end the hub there has the axial force, and takes the couple
        worth = None if pivot.member in met or pivot.clamped else partial(hinge_pull, k, i)
        opposite = partial(hinge_couple, k, sign=-1.0)
        yield Action(source=pivot.hub, kind="hinge", member=i, place=float(pivot.end), worth=worth, couple=opposite)
        met.add(pivot.member)
        if pivot.clamped:
            yield Action(source=pivot.clamped, kind="couple", member=i, place=float(1 - pivot.end), couple=couple)
        yield from through_arm(system, pivot.tip, (pivot.hub, pivot.hub), "couple", couple)


def hinge_wrench(
    system: System, k: int, x: NDArray[np.float64], tension: NDArray[np.float64], amounts: Mapping[str, NDArray[np.float64]]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force (t, 3), N, and couple about the joint (t, 3), N m, that the bars of hinge k exert on the hub, without friction.

    x (t, n, 3) positions, tension (t, members) of truss bars, N; amounts : forces of couplings by name.
    """
    pivot = hinges_of(system)[k]
    nodes = [system.node_index(node) for node in (pivot.tip, *pivot.nodes)]
    own = bars_of_hinge(system, bars_of(system), pivot)
    # a positive force of the coupling lengthens the first bar and shortens the second
    tensions = tension[:, own] if pivot.steady else np.multiply.outer(amounts[pivot.coupling], (-1.0, 1.0))
    return resultant(x[:, nodes], bar_pushes(system, x, own, tensions, nodes), x[:, nodes[0]])


def _wrench(k: int, here: Instants) -> NDArray[np.float64]:
    """`hinge_wrench` of these instants, (2, t, 3)."""
    if here.carried is None:
        return np.full((2, len(here.x), 3), np.nan)
    if f"hinge {k}" not in here.found:
        amounts = {name: one for (kind, name), one in here.amounts.items() if kind == "coupling"}
        here.found[f"hinge {k}"] = np.stack(hinge_wrench(here.system, k, here.x, here.carried.tension, amounts))
    return here.found[f"hinge {k}"]


def hinge_couple(k: int, here: Instants, sign: float = 1.0) -> NDArray[np.float64]:
    """The couple (t, 3), N m, of `hinge_wrench`."""
    return np.asarray(sign * _wrench(k, here)[1])


def hinge_pull(k: int, i: int, here: Instants) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, on member i: the axial force of the bars of hinge k."""
    u, end = ends_of(here.system, here.x, i)[2], hinges_of(here.system)[k].end
    along = np.einsum("tc,tc->t", _wrench(k, here)[0], u)[:, None] * u
    return np.stack([along, -along] if end == 0 else [-along, along], axis=1)
