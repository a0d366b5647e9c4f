"""The bars on which drives, couplings and springs act.

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

from kinetruss.dynamics.actions.bars_between import Bars
from kinetruss.dynamics.actions.records import Action, Instants, NotOnBars
from kinetruss.kernels.constraints.terms import term_gradients
from kinetruss.kernels.structure.plan import ANGLE, AROUND

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model import Model

__all__ = ["actions_of_drives", "term_weights"]

Found = Iterator[Action | NotOnBars]
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
            elif one.kind == "offset":
                yield from _offset(system, bars, t, key)
            elif one.kind == "hinge":
                yield from _hinge(system, bars, t, key)
                t += 1
                yield from _hinge(system, bars, t, key)
            else:
                i = bars.index[one.bar]
                yield _pair(system, bars, t, 0, i, bars.pivot(i), key)
            t += 1
        yield from _pinned(system, bars, weights, key)


def _measured(model: Model, name: str) -> tuple[str, list[Any]]:
    """Whose measure it is, a drive's, a coupling's or a spring's, and its coordinates."""
    if name in model.springs:
        return "spring", [one for one, _ in model.springs[name].parts]
    if name in model.couplings:
        return "coupling", [one for one, _ in model.couplings[name].terms]
    return "drive", [model.all_drives[name]]


def term_weights(system: System, t: int, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Forces (times, 3, 3) of the amount 1 of term t on its nodes P, 1, 2, and the weight (times,) of 2; x (times, n, 3)."""
    out = np.empty((len(x), 5))
    flat = np.ascontiguousarray(x, dtype=float).reshape(len(x), -1)
    term_gradients(system.term_kind, system.term_at, system.term_data, t, flat, out)
    g = out[:, :3]
    return np.stack([g, -out[:, 3, None] * g, -out[:, 4, None] * g], axis=1), out[:, 4]


def _nodes(system: System, t: int) -> tuple[int, int, int]:
    """P, 1 and 2 of term t."""
    P, one, two = (int(flat) // 3 for flat in system.term_at[t, :3])
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


def _pair(system: System, bars: Bars, t: int, which: int, i: int, end: int, key: tuple[str, str]) -> Action:
    """The force on node 1 or 2 (which = 0, 1) of term t as two opposite forces on bar i from there to P; place: `end`."""
    first = bars.ends(i)[0] == _nodes(system, t)[0]
    return _action(i, key, partial(_opposite, t, which, first, key), float(end))


def _opposite(t: int, which: int, first: bool, key: tuple[str, str], here: Instants) -> NDArray[np.float64]:
    push = here.amounts[key][:, None] * term_weights(here.system, t, here.x)[0][:, 1 + which]
    return np.stack([-push, push] if first else [push, -push], axis=1)


def _loose(system: System, bars: Bars, key: tuple[str, str], nodes: tuple[int, ...]) -> Found:
    """The action that no bar carries; none if the nodes are fixed."""
    if not bars.ground.issuperset(nodes):
        names = tuple(dict.fromkeys(system.nodes[n] for n in nodes))
        yield NotOnBars(source=key[1], kind=key[0], nodes=names, members=bars.touching(nodes))


def _hinge(system: System, bars: Bars, t: int, key: tuple[str, str]) -> Found:
    """One side of a hinge: the couple on the bar from each node of the axis to P, weighted by the foot of P on the axis."""
    P, *axis = _nodes(system, t)
    shares = term_weights(system, t, system.x0[None])[0][0]
    largest = np.abs(shares[0]).max()
    for which in range(2 if system.term_kind[t] == AROUND else 1):
        i = bars.between(P, axis[which])
        if i >= 0:
            yield _pair(system, bars, t, which, i, bars.ends(i).index(axis[which]), key)
        elif not np.abs(shares[1 + which]).max() <= PARALLEL * largest:
            yield from _loose(system, bars, key, (P, axis[which]))


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
        yield from _loose(system, bars, key, (one, two))


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
            yield from _loose(system, bars, key, tuple(weights))
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
    yield from _loose(system, bars, key, tuple(weights))


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
