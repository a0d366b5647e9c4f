"""The bars on which drives, couplings, springs and hinges of hubs act, and the couples that they pass.

An angle turns a bar: the couple acts on the bar between the node and the axis, at the axis. An angle of a named bar acts at the
end of that bar that is held (`Bars.pivot`), a length along its bar. The offset of a node from a line acts on the bar along the
line, at the foot of the node. If there is no such bar, but a bar from the node to either end of the line, it bends these two
at the node. Node coordinates that keep a pin at a place of a bar act there in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.actions import Action, CarriedBy, Instants, NotOnBars, couple_on_ends, cross
from kinetruss.kernels.coordinates.forms import AROUND, OFFSET
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.kernels.structure.terms import term_gradients
from kinetruss.mechanics import cached
from kinetruss.mechanics.bars import Bars, bars_of
from kinetruss.model.hub_expansion import Pivot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model.data import ModelData


Found = Iterator[Action | NotOnBars]
FIRST, LAST = 0, 3
"""Places of P and B among the nodes of a term."""
PARALLEL = 1e-9
"""Parts of a force below this fraction of it are round-off."""
BALANCED = 1e-3
"""Largest distance of a pin from its place on a bar, as a fraction of the coupled length."""


def actions_of_drives(system: System, bars: Bars) -> Found:
    """Actions of drives, couplings and springs on bars, and those that no bar carries."""
    yield from _planar_angles(system, bars)
    for m, name in enumerate(system.measures):
        kind, records = _measured(system.model, name)
        key = (kind, name)
        t = int(system.measure_ptr[m])
        weights: dict[int, NDArray[np.float64]] = {}
        for one in records:
            if one.kind == "coordinate":
                _add_weight(system, t, weights)
            elif one.kind in ("cosine", "distance"):
                pass  # a scalar turns with no bar, and forces along the line of two nodes bend none
            elif one.kind == "offset":
                yield from _offset(system, bars, t, key)
            elif one.kind == "hinge" and system.term_kind[t] == AROUND:
                yield from _hinge(system, bars, t, FIRST, key)
                yield from _hinge(system, bars, t, LAST, key)
            elif one.kind == "hinge":
                yield from _hinge(system, bars, t, FIRST, key)
                t += 1
                yield from _hinge(system, bars, t, FIRST, key)
            else:
                i = bars.index[one.bar]
                yield _pair(system, bars, t, 0, i, bars.pivot(i), key)
            t += 1
        yield from _pinned(system, bars, weights, key)


def _measured(model: ModelData, name: str) -> tuple[str, list[Any]]:
    """Whose measure it is, a drive's, a coupling's or an element's, and its coordinates."""
    if name in model.force_elements:
        kind, record = model.force_elements[name]
        return kind, [one for one, _ in record.parts]
    if name in model.couplings:
        return "coupling", [one for one, _ in model.couplings[name].terms]
    return "drive", [model.all_drives[name]]


def term_weights(
    system: System, t: int, x: NDArray[np.float64], end: int = FIRST
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Forces (times, 3, 3) of the amount 1 of term t on its nodes P, 1, 2, and the weight (times,) of 2; x (times, n, 3).

    end : FIRST, or LAST for what an angle about an axis makes at its node B and, for that, at 1 and 2. The force g at a point
    off the axis is taken off 1 and 2 in the shares 1 - s and s, the place of its foot on the axis.
    """
    out = np.empty((len(x), 12))
    flat = np.ascontiguousarray(x, dtype=float).reshape(len(x), -1)
    term_gradients(system.term_form, system.term_at, system.term_data, t, flat, out)
    g = out[:, 3 * end : 3 * end + 3]
    if system.term_kind[t] not in (AROUND, OFFSET):
        return np.stack([g, -g, np.zeros_like(g)], axis=1), np.zeros(len(x))
    P, one, two = (x[:, n] for n in _nodes(system, t, end))
    b = two - one
    s = np.einsum("tc,tc->t", P - one, b) / np.einsum("tc,tc->t", b, b)
    return np.stack([g, -(1.0 - s)[:, None] * g, -s[:, None] * g], axis=1), s


def _nodes(system: System, t: int, end: int = FIRST) -> tuple[int, int, int]:
    """P or B, 1 and 2 of term t."""
    P, one, two = (int(flat) // 3 for flat in system.term_at[t, [end, 1, 2]])
    return P, one, two


def _planar_angles(system: System, bars: Bars) -> Found:
    """Angles of bars in the plane have rows of their own, which belong to the bar."""
    for r in np.flatnonzero((system.row_kind == ANGLE) & (system.row_drive >= 0)):
        i = int(system.row_member[r])
        key = ("drive", system.drives[system.row_drive[r]])
        yield Action(
            source=key[1],
            kind=key[0],
            member=i,
            worth=partial(_turned, i, key),
            place=float(bars.pivot(i)),
            counted=True,
            torque=partial(_amount, key),
        )


def _turned(i: int, key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    """A torque on bar i in the plane, as forces at its ends."""
    d = here.along(i)
    push = here.amounts[key] / np.einsum("tc,tc->t", d, d)
    found = np.zeros((len(d), 2, 3))
    found[:, 1, 0], found[:, 1, 1] = -push * d[:, 1], push * d[:, 0]
    np.negative(found[:, 1], out=found[:, 0])
    return found


def _amount(key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    return here.amounts[key]


def _action(i: int, key: tuple[str, str], worth: Any, place: Any) -> Action:
    return Action(source=key[1], kind=key[0], member=i, worth=worth, place=place)


def _pair(system: System, bars: Bars, t: int, which: int, i: int, place: int, key: tuple[str, str], end: int = FIRST) -> Action:
    """The force on node 1 or 2 (which = 0, 1) of term t as two opposite forces on bar i from there to P (or B)."""
    first = bars.ends(i)[0] == _nodes(system, t, end)[0]
    return _action(i, key, partial(_opposite, t, end, which, first, key), float(place))


def _opposite(t: int, end: int, which: int, first: bool, key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    if (name := f"term {t} {end}") not in here.found:  # the forces on both nodes of an axis
        here.found[name] = term_weights(here.system, t, here.x, end)[0]
    push = here.amounts[key][:, None] * here.found[name][:, 1 + which]
    return np.stack([-push, push] if first else [push, -push], axis=1)


def _on_no_bar(system: System, bars: Bars, key: tuple[str, str], nodes: tuple[int, ...]) -> Found:
    """The action that no bar carries; none if the nodes are fixed."""
    if not bars.ground.issuperset(nodes):
        names = tuple(dict.fromkeys(system.nodes[n] for n in nodes))
        yield NotOnBars(source=key[1], kind=key[0], nodes=names, members=bars.touching(nodes))


def _hinge(system: System, bars: Bars, t: int, end: int, key: tuple[str, str]) -> Found:
    """One side of a hinge: the couple on the bar from each node of the axis to P, weighted by the foot of P on the axis."""
    P, *axis = _nodes(system, t, end)
    shares = term_weights(system, t, system.x0[None], end)[0][0]
    largest = np.abs(shares[0]).max()
    for which in range(2 if system.term_kind[t] == AROUND else 1):
        i = bars.between(P, axis[which])
        if i >= 0:
            yield _pair(system, bars, t, which, i, bars.ends(i).index(axis[which]), key, end)
        elif not np.abs(shares[1 + which]).max() <= PARALLEL * largest:
            yield from _on_no_bar(system, bars, key, (P, axis[which]))


def _offset(system: System, bars: Bars, t: int, key: tuple[str, str]) -> Found:
    P, one, two = _nodes(system, t)
    i, halves = bars.between(one, two), (bars.between(P, one), bars.between(P, two))
    if i >= 0 and not system.two_rods[i]:
        first = bars.ends(i)[0] == one
        yield _action(i, key, partial(_pressed, t, first, key), partial(_foot, t, first))
    elif i < 0 <= min(halves):
        for which, half in enumerate(halves):
            yield _pair(system, bars, t, which, half, bars.ends(half).index(P), key)
    else:
        yield from _on_no_bar(system, bars, key, (one, two))


def _pressed(t: int, first: bool, key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    """Forces of a term on the two nodes of its line, in the order of the bar."""
    push = here.amounts[key][:, None, None] * term_weights(here.system, t, here.x)[0][:, 1:]
    return push if first else push[:, ::-1]


def _foot(t: int, first: bool, here: Instants) -> NDArray[np.float64]:
    share = term_weights(here.system, t, here.x)[1]
    return share if first else 1.0 - share


def _add_weight(system: System, t: int, weights: dict[int, NDArray[np.float64]]) -> None:
    """Count a coordinate of a node, unless the node is a scalar, which has no position."""
    P = _nodes(system, t)[0]
    if not system.model.nodes[system.nodes[P]].scalar:
        weights[P] = weights.get(P, np.zeros(3)) + system.term_data[t, 0] * system.term_data[t, 1:4]


def _pinned(system: System, bars: Bars, weights: dict[int, NDArray[np.float64]], key: tuple[str, str]) -> Found:
    """A coupling of node coordinates: force weights[n] times its amount on node n; as pins on bars if possible."""
    weights = {n: w for n, w in weights.items() if w.any()}
    if len(weights) < 3 or not _in_balance(system, weights):
        if any(bars.between(a, b) >= 0 for a, b in combinations(weights, 2)):
            yield from _on_no_bar(system, bars, key, tuple(weights))
        return
    found = _bars_across(system, bars, weights)
    for i in found:
        a, b = bars.ends(i)
        W = weights[a] + weights[b]
        place = float(weights[b] @ W / (W @ W))
        yield _action(i, key, partial(_constant, np.stack([weights[a], weights[b]]), key), place)
    if found:
        return
    for M in weights:
        spokes = {n: bars.between(M, n) for n in weights if n != M}
        if min(spokes.values()) >= 0:
            for n, i in spokes.items():
                first, push = bars.ends(i)[0] == n, np.stack([weights[n], -weights[n]])
                worth = push if first else push[::-1]
                yield _action(i, key, partial(_constant, worth, key), float(bars.ends(i).index(M)))
            return
    yield from _on_no_bar(system, bars, key, tuple(weights))


def _constant(push: NDArray[np.float64], key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    return np.asarray(here.amounts[key][:, None, None] * push)


def _in_balance(system: System, weights: dict[int, NDArray[np.float64]]) -> bool:
    """True if the forces and moments of a coupling sum to zero, so that it acts between the coupled parts only."""
    x, w = system.x0[list(weights)], np.array(list(weights.values()))
    x = x - x.mean(axis=0)
    largest = float(np.abs(w).max())
    still = np.abs(w.sum(axis=0)).max() <= BALANCED * largest
    return bool(still and np.abs(np.cross(x, w).sum(axis=0)).max() <= BALANCED * largest * float(np.abs(x).max()))


def _bars_across(system: System, bars: Bars, weights: dict[int, NDArray[np.float64]]) -> list[int]:
    """Bars whose two ends take a force: those with the pin between their ends; for three nodes else one with the pin beyond."""
    alike: list[int] = []
    beyond: list[int] = []
    for a, b in combinations(weights, 2):
        i, W = bars.between(a, b), weights[a] + weights[b]
        if i < 0 or system.two_rods[i] or not np.abs(W).max() > PARALLEL * np.abs(weights[a]).max():
            continue
        if np.abs(np.cross(weights[a], weights[b])).max() > PARALLEL * float(W @ W):
            continue
        (alike if weights[a] @ weights[b] > 0 else beyond).append(i)
    found: list[int] = []
    used: set[int] = set()
    for i in alike or (beyond[:1] if len(weights) == 3 else []):
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


def actions_of_hinges(system: System, bars: Bars) -> Iterator[Action]:
    """The couples of hinges on their members, with the axial force of their bars, and on the arms."""
    met = set[str]()
    for k, pivot in enumerate(hinges_of(system)):
        i, arm = bars.index[pivot.member], bars.index[pivot.tip]
        # of a member clamped at its other end the hub there has the axial force, and takes the couple
        worth = partial(_on_member, k, i, pivot.member not in met and not pivot.clamped)
        yield Action(source=pivot.hub, kind="hinge", member=i, worth=worth, place=float(pivot.end))
        met.add(pivot.member)
        if pivot.clamped:
            worth = partial(_across, k, i, 1.0)
            yield Action(source=pivot.clamped, kind="couple", member=i, worth=worth, place=float(1 - pivot.end))
        tip = int(system.nodes[system.q[arm]] == pivot.tip)
        for sign, place in ((1.0, tip), (-1.0, 1 - tip)):
            worth = partial(_across, k, arm, sign)
            yield Action(source=pivot.hub, kind="couple", member=arm, worth=worth, place=float(place))


def couples_at_hinges(
    system: System, x: NDArray[np.float64], tension: NDArray[np.float64], coupling: NDArray[np.float64]
) -> list[tuple[Pivot, NDArray[np.float64]]]:
    """Couples (t, 3), N m, of members on the hubs of their hinges, about the joint, without friction.

    x (t, n, 3) positions, tension (t, members) and coupling (t, couplings) forces.
    """
    none = np.zeros(x.shape)
    here = Instants(
        system=system,
        x=x,
        v=none,
        a=none,
        gravity=np.zeros(3),
        amounts={("coupling", name): coupling[:, k] for k, name in enumerate(system.model.couplings)},
        carried=CarriedBy(tension, none, none[:, :0]),
    )
    return [(pivot, couple_of_hinge(here, k)[1]) for k, pivot in enumerate(hinges_of(system))]


def couple_of_hinge(here: Instants, k: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force (t, 3), N, and couple about the joint (t, 3), N m, that the bars of hinge k exert on the hub."""
    if here.carried is None:
        return np.full((len(here.x), 3), np.nan), np.full((len(here.x), 3), np.nan)
    if f"hinge {k}" not in here.found:
        here.found[f"hinge {k}"] = np.stack(_couple_of_hinge(here, here.carried.tension, k))
    force, couple = here.found[f"hinge {k}"]
    return force, couple


def _couple_of_hinge(here: Instants, tensions: NDArray[np.float64], k: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """`couple_of_hinge` from the tensions (t, members), N, of truss bars."""
    force, couple = np.zeros((2, len(here.x), 3))
    system, pivot = here.system, hinges_of(here.system)[k]
    group = {system.node_index(node) for node in (pivot.tip, *pivot.nodes)}
    joint = here.x[:, system.node_index(pivot.tip)]
    for n, i in enumerate(bars_of_hinge(system, bars_of(system), pivot)):
        tension = tensions[:, i]
        if not pivot.steady:  # a positive force of the coupling lengthens the first bar and shortens the second
            tension = here.amounts["coupling", pivot.coupling] * (1.0 if n else -1.0)
        d = here.along(i)
        push = (tension / np.linalg.norm(d, axis=1))[:, None] * d
        for node, sign in ((system.p[i], 1.0), (system.q[i], -1.0)):
            if int(node) in group:
                force += sign * push
                couple += cross(here.x[:, node] - joint, sign * push)
    return force, couple


def _on_member(k: int, i: int, first: bool, here: Instants) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, on member i: the couple of hinge k across it, and once the axial force of its bars."""
    force, couple = couple_of_hinge(here, k)
    found = couple_on_ends(here.system, here.x, i, -couple)
    if first:
        end, d = hinges_of(here.system)[k].end, here.along(i)
        along = (np.einsum("tc,tc->t", force, d) / np.einsum("tc,tc->t", d, d))[:, None] * d
        found[:, end] += along
        found[:, 1 - end] -= along
    return found


def _across(k: int, i: int, sign: float, here: Instants) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, equivalent to the part of the couple of hinge k across bar i."""
    return couple_on_ends(here.system, here.x, i, sign * couple_of_hinge(here, k)[1])
