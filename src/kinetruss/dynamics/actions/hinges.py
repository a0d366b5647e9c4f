"""Hinges of hubs in space: the couples that they pass between a member and the arm of its hub.

A hinge is a rigid body of the member and of nodes on the axis that belong to the hub, or two bars of equal lengths from there
to the far end of a member whose length changes. The forces of these bars on the hub make a force f at the joint and a couple c
about it. Here they are given back to the member: f at its joint, -c as a couple that bends it there; +c twists and bends the
arm.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.actions.bars_between import Bars, bars_of
from kinetruss.dynamics.actions.records import Action, CarriedBy, Instants, couple_on_ends, cross
from kinetruss.mechanics import kept
from kinetruss.model.hubs import Pivot, pivots_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System

__all__ = ["actions_of_hinges", "bars_of_hinges", "couple_of_hinge", "couples_at_hinges", "hinge_bodies", "hinges_of"]


@kept()
def hinges_of(system: System) -> tuple[Pivot, ...]:
    """The hinges of hubs."""
    return tuple(pivots_of(system.model)) if system.model.hubs else ()


def hinge_bodies(system: System) -> set[str]:
    """Names of the bodies that hold members to the axes of their hinges."""
    return {one.body for one in hinges_of(system) if one.steady and not one.clamped}


@kept()
def bars_of_hinges(system: System) -> frozenset[int]:
    """Bars whose forces the members and arms of hinges take."""
    bars = bars_of(system)
    return frozenset(k for one in hinges_of(system) for k in _bars(system, bars, one))


def _bars(system: System, bars: Bars, pivot: Pivot) -> list[int]:
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
    for n, i in enumerate(_bars(system, bars_of(system), pivot)):
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
