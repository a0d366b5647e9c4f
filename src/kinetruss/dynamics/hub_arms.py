"""Actions of bodies, loads and pins on bars, and the arms of hubs as cantilevers.

The bars of a hub are those of a truss: arms carry axial forces only, and massless braces between the tips the rest. Here the
forces of braces and supports at the tip of an arm are moved to its root, where they become a force and a couple. With that
every arm is a free body: loaded at the tip by members and loads, clamped at the centre.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.dynamics.action_couples import bars_of_hinges, hinge_bodies, hinges_of
from kinetruss.dynamics.actions import Action, Instants, NotOnBars, couple_on_ends
from kinetruss.dynamics.bearing_friction import friction_on_hub
from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.body_loads import bar_of, hub_bodies, share
from kinetruss.elements.loads.load import OnMember, Spread
from kinetruss.elements.pin_friction import pins_of
from kinetruss.mechanics import cached, ends_of, turned
from kinetruss.mechanics.bars import Bars, bars_of
from kinetruss.model import BodyCouple, body_mass
from kinetruss.model.hub_arms import arm_through, clamped_at, is_grounded, loops

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model import Body


@cached()
def braces_of_hubs(system: System) -> frozenset[int]:
    """Braces whose forces the arms of hubs take: the free body of a node has the arms instead."""
    bars, model, found = bars_of(system), system.model, set[int]()
    for hub in model.hubs:
        if not _shared(system, bars, hub):
            found.update(_braces(system, bars, hub))
    return frozenset(found) | bars_of_hinges(system)


def grounded_tips(system: System, node: str) -> list[str] | None:
    """The tips of a hub on the ground by its centre; an empty list at a tip of one; None at other nodes."""
    model = system.model
    for hub in model.hubs:
        if is_grounded(model, hub):
            tips = [arm.name for arm in model.inner.arms[hub]]
            tips += [at for one in hinges_of(system) if one.hub == hub for at in one.nodes]
            if node == hub:
                return tips
            if node in tips:
                return []
    return None


def _braces(system: System, bars: Bars, hub: str) -> list[int]:
    return [i for i, name in enumerate(system.members) if bars.brace[i] and name.startswith(f"{hub}.hub.")]


def _arms(system: System, bars: Bars, hub: str) -> list[int]:
    arms = [bars.index[arm.name] for arm in system.inner.arms[hub]]
    return arms + [bars.index[name] for name in clamped_at(system.given, hub)]


def _shared(system: System, bars: Bars, hub: str) -> bool:
    """Whether others share the moments of a hub, so that statics alone does not give them."""
    return hub in loops(system.given) or _shared_with_others(system, bars, hub, set(_arms(system, bars, hub)))


def actions_of_hubs(system: System, bars: Bars) -> Iterator[Action | NotOnBars]:
    """What braces and supports at the tips of arms do to them; hubs whose moments statics alone does not give."""
    model = system.model
    for hub in model.hubs:
        arms = _arms(system, bars, hub)
        tips = {i: int(system.nodes[bars.ends(i)[0]] == hub) for i in arms}
        if _shared(system, bars, hub):
            nodes = tuple(system.nodes[bars.ends(i)[tip]] for i, tip in tips.items())
            yield NotOnBars(source=hub, kind="hub", nodes=(hub, *nodes), members=tuple(system.members[i] for i in arms))
            continue
        braces = _braces(system, bars, hub)
        on_body = (name for name, load in model.loads.items() if getattr(load, "body", None) == f"{hub}.hub")
        own = frozenset(on_body)
        for i, tip in tips.items():
            joint = bars.ends(i)[tip]
            axes = [node for one in hinges_of(system) if one.tip == system.nodes[joint] for node in one.nodes]
            at = (joint, *(system.node_index(node) for node in axes))
            pulled = tuple((k, bars.ends(k).index(node)) for k in braces for node in at if node in bars.ends(k))
            worth = partial(_passed_on, hub, tip, at, pulled, own, is_grounded(model, hub))
            yield Action(source=hub, kind="hub", member=i, worth=worth, place=float(1 - tip))


def couples_through_members(system: System, names: Iterable[str]) -> Iterator[Action]:
    """Couples that enter a hub through a member: across its arm the couple acts at the tip and its opposite at the centre."""
    model, bars = system.model, bars_of(system)
    for name in names:
        load = model.loads[name]
        if not isinstance(load, BodyCouple) or load.member is None:
            continue
        if (arm := arm_through(model, load.body, load.member)) is None:
            continue
        i = bars.index[arm.name]
        tip = int(system.nodes[bars.ends(i)[0]] == arm.hub)
        for source, sign, place in ((name, 1.0, tip), (arm.hub, -1.0, 1 - tip)):
            yield Action(source=source, kind="couple", member=i, worth=partial(_bent, i, name, sign), place=float(place))


def _bent(i: int, load: str, sign: float, here: Instants) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, equivalent to the part of a couple across arm i."""
    if here.loads is None or load not in here.loads.amounts:
        return np.zeros((len(here.x), 2, 3))
    return couple_on_ends(here.system, here.x, i, sign * here.loads.amounts[load])


def _shared_with_others(system: System, bars: Bars, hub: str, own: set[int]) -> bool:
    """Whether other rigid bars or bodies join nodes of the hub too, so that they share its moments."""
    model = system.model
    body = model.bodies.get(f"{hub}.hub")
    if body is None:
        return False
    nodes = set(body.nodes)
    edges = [{system.nodes[n] for n in bars.ends(i)} for i in own]
    hinged = [{one.tip, *one.nodes} for one in hinges_of(system)]
    for name, other in model.bodies.items():
        shared = nodes & set(other.nodes)
        if name != f"{hub}.hub" and len(shared) > 1 and not any(shared <= edge for edge in [*edges, *hinged]):
            return True
    inside = {i for i in range(len(bars.brace)) if not bars.brace[i] and {system.nodes[n] for n in bars.ends(i)} <= nodes}
    return bool(inside - own)


def _passed_on(
    hub: str,
    tip: int,
    nodes: tuple[int, ...],
    pulled: tuple[tuple[int, int], ...],
    own: frozenset[str],
    fixed: bool,
    here: Instants,
) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, on an arm: at its tip those that braces and supports exert on the nodes there, which
    are the joint and the axis of its hinge.
    """
    found = np.zeros((len(here.x), 2, 3))
    if here.carried is None:
        return found * np.nan
    push = found[:, tip]
    for k, end in pulled:
        d = here.along(k) * (1.0 if end else -1.0)  # outward from the brace at its end
        push -= (here.carried.tension[:, k] / np.linalg.norm(d, axis=1))[:, None] * d
    if here.loads is not None:  # loads on the body of a hub act at its centre
        for k, (load, at) in enumerate(zip(here.loads.loads, here.loads.node, strict=True)):
            if at in nodes and load in own:
                push += here.loads.force[:, k]
    for at, force in friction_on_hub(here, hub):  # acts at the centre too, but for the couple that enters through the arm
        if at in nodes:
            push += force
    if fixed:
        push += here.carried.support[:, list(nodes)].sum(axis=1)
    found[:, 1 - tip] = -push
    return found


# Friction about a pin: a couple on each of its bars, at the pin.


def actions_of_friction(system: System) -> Iterator[Action]:
    """The couples on bars that turn about pins with friction."""
    pins = pins_of(system)
    second = pins.second >= 0
    member, node = np.append(pins.first, pins.second[second]), np.append(pins.node, pins.node[second])
    for i, at in sorted(set(zip(member.tolist(), node.tolist(), strict=True))):
        place = float(system.q[i] == at)
        yield Action(source=system.nodes[at], kind="friction", member=i, worth=partial(_pin_forces, i, at), place=place)


def _pin_forces(i: int, node: int, here: Instants) -> NDArray[np.float64]:
    """Forces at the ends of bar i, (times, 2, 3) N, equivalent to the couple of all its pairs at a node."""
    pins, torque = pins_of(here.system), here.pin_torque
    at = pins.node == node
    couple = torque[:, at & (pins.second == i)].sum(axis=1) - torque[:, at & (pins.first == i)].sum(axis=1)
    _, L, u = ends_of(here.system, here.x, i)
    push = (couple / L)[:, None] * turned(u)
    return np.stack([-push, push], axis=1)


# The bars that carry bodies and loads: an action on the two nodes of one bar acts on that bar.

Found = Iterator[Action | NotOnBars]


def actions_of_bodies(system: System, bars: Bars) -> Found:
    """The mass of a body of two nodes acts on the bar between them, at its centre (or spread along it if none is given).

    Bars inside larger bodies are reported instead: the weight of the body, and actions at its other nodes, act on them through
    braces.
    """
    for name, body in system.model.bodies.items():
        i = bar_of(system, bars, body)
        if i >= 0:
            if body.mass:
                place = Spread() if body.center is None else share(system, bars, i, body, None)
                worth = partial(_inertia, i, *_mass(system, bars, i, body))
                yield Action(source=name, kind="body", member=i, worth=worth, place=place)
            continue
        own = {system.node_index(node) for node in body.nodes}
        inside = () if name in hub_bodies(system) | hinge_bodies(system) else bars.inside(own)
        if inside and (body.mass or bars.braced(own)):
            yield NotOnBars(source=name, kind="body", nodes=tuple(body.nodes), members=inside)


def actions_of_loads(system: System, bars: Bars, names: Iterable[str]) -> Found:
    """Loads act on members between their ends where their kinds say so."""
    for name in names:
        load = system.model.loads[name]
        for one in LOADS[type(load)].places(system, bars, load):
            if isinstance(one, OnMember):
                yield Action(
                    source=name, kind="load", member=one.member, worth=partial(_load, one.member, name), place=one.place
                )
            else:
                yield NotOnBars(source=name, kind="load", nodes=one.nodes, members=one.members)


def _mass(system: System, bars: Bars, i: int, body: Body) -> tuple[NDArray[np.float64], float]:
    """m_ij (2, 2) and the skew part, kg, in the order of the bar's ends."""
    m, skew = body_mass(system.model, body)
    if body.carried_by(system.dim)[0] == system.nodes[bars.ends(i)[0]]:
        return m, skew
    return m[::-1, ::-1], -skew


def _inertia(i: int, m: NDArray[np.float64], skew: float, here: Instants) -> NDArray[np.float64]:
    """Weight less inertia of a body on bar i, at its ends: sum_j m_ij (g - a_j) and the skew part."""
    b = here.gravity - here.a[:, [here.system.p[i], here.system.q[i]]]
    turned = np.stack([-b[..., 1], b[..., 0], np.zeros_like(b[..., 0])], axis=-1)
    return np.asarray(np.einsum("ij,tjc->tic", m, b) + skew * np.stack([turned[:, 1], -turned[:, 0]], axis=1))


def _load(i: int, name: str, here: Instants) -> NDArray[np.float64]:
    """Equivalent forces of a load at the ends of bar i."""
    found = np.zeros((len(here.x), 2, 3))
    if here.loads is not None:
        for k, (one, node) in enumerate(zip(here.loads.loads, here.loads.node, strict=True)):
            if one == name:
                found[:, int(node == here.system.q[i])] += here.loads.force[:, k]
    return found
