"""Actions of bodies, loads and pins on bars, and the arms of hubs as cantilevers.

The bars of a hub are those of a truss: arms carry axial forces only, and massless braces between the tips the rest. Here the
forces of braces and supports at the tip of an arm are moved to its root, where they become a force and a couple. With that
every arm is a free body: loaded at the tip by members and loads, clamped at the centre.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kinetruss.dynamics.action_couples import bars_of_hinges, hinge_bodies, hinges_of, through_arm
from kinetruss.dynamics.actions import Action, Instants, NotOnBars
from kinetruss.dynamics.bearing_friction import friction_on_hub
from kinetruss.elements.kinds import LOADS
from kinetruss.elements.loads.body_loads import bar_of, hub_bodies, share
from kinetruss.elements.loads.load import OnMember, Spread
from kinetruss.elements.pin_friction import pins_of
from kinetruss.mechanics import cached
from kinetruss.mechanics.bars import Bars, bars_of
from kinetruss.mechanics.frames import bar_pulls, pulled
from kinetruss.model import BodyCouple, body_mass
from kinetruss.model.hub_arms import arm_through, clamped_at, is_grounded, loops

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.mechanics import System


class HubFrame(NamedTuple):
    """A hub as the frame of its arms and of the members clamped to it.

    joints : by arm or clamped member, which of its ends is not at the centre, and the nodes there: its joint and those on the
    axis of a hinge. braces : bars that hold them. loads : names of those on its body. grounded : bolted to the ground.
    shared : others join its nodes too, so that statics alone does not give the moments in its arms.
    """

    hub: str
    joints: dict[int, tuple[int, list[int]]]
    braces: list[int]
    loads: frozenset[str]
    grounded: bool
    shared: bool


@cached()
def frames_of_hubs(system: System) -> tuple[HubFrame, ...]:
    """The hubs of a model."""
    model, bars, found = system.model, bars_of(system), list[HubFrame]()
    for hub in model.hubs:
        joints = {}
        for name in (*(arm.name for arm in model.inner.arms[hub]), *clamped_at(system.given, hub)):
            i = bars.index[name]
            tip = int(system.nodes[system.p[i]] == hub)
            joint = bars.ends(i)[tip]
            axes = (node for one in hinges_of(system) if one.tip == system.nodes[joint] for node in one.nodes)
            joints[i] = tip, [joint, *map(system.node_index, axes)]
        braces = [i for i, name in enumerate(system.members) if bars.brace[i] and name.startswith(f"{hub}.hub.")]
        loads = frozenset(name for name, load in model.loads.items() if getattr(load, "body", None) == f"{hub}.hub")
        shared = hub in loops(system.given) or _shared_with_others(system, bars, hub, joints)
        found.append(HubFrame(hub, joints, braces, loads, is_grounded(model, hub), shared))
    return tuple(found)


def _shared_with_others(system: System, bars: Bars, hub: str, own: Iterable[int]) -> bool:
    """Whether other rigid bars or bodies join nodes of the hub too, so that they share its moments."""
    model = system.model
    body = model.bodies.get(f"{hub}.hub")
    if body is None:
        return False
    nodes = set(body.nodes)
    alone = [{system.nodes[n] for n in bars.ends(i)} for i in own] + [{one.tip, *one.nodes} for one in hinges_of(system)]
    for name, other in model.bodies.items():
        shared = nodes & set(other.nodes)
        if name != f"{hub}.hub" and len(shared) > 1 and not any(shared <= some for some in alone):
            return True
    return not set(bars.inside({system.node_index(node) for node in nodes})) <= {system.members[i] for i in own}


@cached()
def braces_of_hubs(system: System) -> frozenset[int]:
    """Braces whose forces the arms of hubs take: the free body of a node has the arms instead."""
    return bars_of_hinges(system).union(*(one.braces for one in frames_of_hubs(system) if not one.shared))


def grounded_tips(system: System, node: str) -> list[str] | None:
    """The tips of a hub on the ground by its centre; an empty list at a tip of one; None at other nodes."""
    for one in frames_of_hubs(system):
        joints = [nodes for _, nodes in one.joints.values()]
        tips = [system.nodes[at] for at in (*(nodes[0] for nodes in joints), *(at for nodes in joints for at in nodes[1:]))]
        if one.grounded and node in (one.hub, *tips):
            return tips if node == one.hub else []
    return None


def loads_of_hubs(system: System) -> dict[str, int]:
    """Loads on the bodies of hubs whose arms take them, with the node at the centre."""
    return {load: system.node_index(one.hub) for one in frames_of_hubs(system) if not one.shared for load in one.loads}


def actions_of_hubs(system: System) -> Iterator[Action | NotOnBars]:
    """What braces and supports at the tips of arms do to them; hubs whose moments statics alone does not give."""
    for one in frames_of_hubs(system):
        if one.shared:
            names = (one.hub, *(system.nodes[at[0]] for _, at in one.joints.values()))
            yield NotOnBars(source=one.hub, kind="hub", nodes=names, members=tuple(system.members[i] for i in one.joints))
            continue
        for i, (tip, nodes) in one.joints.items():
            worth = partial(arm_push, one, i, tip, nodes)
            yield Action(source=one.hub, kind="hub", member=i, place=float(1 - tip), worth=worth)


@cached()
def _pulled(system: System) -> tuple[list[int], dict[tuple[str, int], int], NDArray[np.float64]]:
    """Braces of all hubs, the column of each joint by hub and member, and which end of a brace is at a joint of its hub."""
    frames = frames_of_hubs(system)
    columns = {(one.hub, i): k for k, (one, i) in enumerate((one, i) for one in frames for i in one.joints)}
    at = np.zeros((sum(len(one.braces) for one in frames), len(columns)))
    row = 0
    for one in frames:
        rows = slice(row, row := row + len(one.braces))
        for i, (_, nodes) in one.joints.items():
            at[rows, columns[one.hub, i]] = pulled(system, one.braces, nodes).sum(axis=1)
    return [i for one in frames for i in one.braces], columns, at


def arm_push(frame: HubFrame, i: int, tip: int, nodes: list[int], here: Instants) -> NDArray[np.float64]:
    """Two opposite forces (t, 2, 3), N, on arm i: at its tip those that braces and supports exert on the nodes there."""
    if here.carried is None:
        return np.full((len(here.x), 2, 3), np.nan)
    braces, columns, at = _pulled(here.system)
    if "braces" not in here.found:
        pulls = bar_pulls(here.system, here.x, braces, here.carried.tension[:, braces])
        here.found["braces"] = np.einsum("tmc,mk->tkc", pulls, at)
    push = here.found["braces"][:, columns[frame.hub, i]].copy()
    if here.loads is not None and frame.loads:  # loads on the body of a hub act at its centre
        for k, (load, node) in enumerate(zip(here.loads.loads, here.loads.node, strict=True)):
            if node in nodes and load in frame.loads:
                push += here.loads.force[:, k]
    for node, force in friction_on_hub(here, frame.hub):  # at the centre too, but for the couple that enters through the arm
        if node in nodes:
            push += force
    if frame.grounded:
        push += here.carried.support[:, nodes].sum(axis=1)
    found = np.empty((len(push), 2, 3))
    found[:, tip], found[:, 1 - tip] = push, -push
    return found


def couples_through_members(system: System, names: Iterable[str]) -> Iterator[Action]:
    """Couples that enter a hub through a member: across its arm the couple acts at the tip and its opposite at the centre."""
    for name in names:
        load = system.model.loads[name]
        if isinstance(load, BodyCouple) and load.member and (arm := arm_through(system.model, load.body, load.member)):
            yield from through_arm(system, arm.name, (name, arm.hub), "couple", partial(_given, name))


def _given(load: str, here: Instants) -> NDArray[np.float64]:
    """A couple (t, 3), N m, that is a load."""
    none = np.zeros((len(here.x), 3))
    return none if here.loads is None else here.loads.amounts.get(load, none)


# Friction about a pin: a couple on each of its bars, at the pin.


def actions_of_friction(system: System) -> Iterator[Action]:
    """The couples on bars that turn about pins with friction."""
    pins = pins_of(system)
    both = {(int(i), int(at)) for members in (pins.first, pins.second) for i, at in zip(members, pins.node, strict=True)}
    for i, at in sorted(one for one in both if one[0] >= 0):
        couple = partial(pin_couple, i, at)
        yield Action(source=system.nodes[at], kind="friction", member=i, place=float(system.q[i] == at), couple=couple)


def pin_couple(i: int, node: int, here: Instants) -> NDArray[np.float64]:
    """Couple on bar i (t, 3), N m, of all its pairs at a node."""
    pins = pins_of(here.system)
    sign = np.where(pins.node == node, (pins.second == i).astype(float) - (pins.first == i), 0.0)
    return np.multiply.outer(here.pin_torque @ sign, (0.0, 0.0, 1.0))


# The bars that carry bodies and loads: an action on the two nodes of one bar acts on that bar.

Found = Iterator[Action | NotOnBars]


def actions_of_bodies(system: System, bars: Bars) -> Found:
    """The mass of a body of two nodes acts on the bar between them, at its centre (or spread along it if none is given).

    Bars inside larger bodies are reported instead: the weight of the body, and actions at its other nodes, act on them through
    braces.
    """
    model, on_bars = system.model, bodies_on_bars(system)
    for name, body in model.bodies.items():
        if name in on_bars:
            i, m, skew = on_bars[name]
            place = Spread() if body.center is None else share(system, bars, i, body, None)
            yield Action(source=name, kind="body", member=i, place=place, worth=partial(body_push, i, m, skew))
            continue
        own = {system.node_index(node) for node in body.nodes}
        if bar_of(system, bars, body) >= 0 or name in hub_bodies(system) | hinge_bodies(system):
            continue
        if (inside := bars.inside(own)) and (body.mass or bars.braced(own)):
            yield NotOnBars(source=name, kind="body", nodes=tuple(body.nodes), members=inside)


@cached()
def bodies_on_bars(system: System) -> dict[str, tuple[int, NDArray[np.float64], float]]:
    """By body with mass the bar that carries it, m_ij (2, 2) and the skew part, kg, in the order of the bar's ends."""
    found = {}
    for name, body in system.model.bodies.items():
        if body.mass and (i := bar_of(system, bars_of(system), body)) >= 0:
            m, skew = body_mass(system.model, body)
            same = body.carried_by(system.dim)[0] == system.nodes[system.p[i]]
            found[name] = (i, m, skew) if same else (i, m[::-1, ::-1], -skew)
    return found


def of_two_masses(m: NDArray[np.float64], skew: float, b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces (t, 2, 3), N, at the ends of a bar with a body: sum_j m_ij b_j and the skew part; b alike, m/s^2."""
    turned = np.zeros_like(b)
    turned[..., 0], turned[..., 1] = -b[..., 1], b[..., 0]
    return np.asarray(np.einsum("ij,tjc->tic", m, b) + skew * np.stack([turned[:, 1], -turned[:, 0]], axis=1))


def body_push(i: int, m: NDArray[np.float64], skew: float, here: Instants) -> NDArray[np.float64]:
    """Weight less inertia of a body on bar i, at its ends."""
    return of_two_masses(m, skew, here.gravity - here.a[:, [here.system.p[i], here.system.q[i]]])


def actions_of_loads(system: System, bars: Bars, names: Iterable[str]) -> Found:
    """Loads act on members between their ends where their kinds say so."""
    for name in names:
        load = system.model.loads[name]
        for one in LOADS[type(load)].places(system, bars, load):
            if isinstance(one, OnMember):
                yield Action(
                    source=name, kind="load", member=one.member, worth=partial(load_push, one.member, name), place=one.place
                )
            else:
                yield NotOnBars(source=name, kind="load", nodes=one.nodes, members=one.members)


def load_push(i: int, name: str, here: Instants) -> NDArray[np.float64]:
    """Equivalent forces of a load at the ends of bar i."""
    found = np.zeros((len(here.x), 2, 3))
    if here.loads is not None:
        for k, (one, node) in enumerate(zip(here.loads.loads, here.loads.node, strict=True)):
            if one == name:
                found[:, int(node == here.system.q[i])] += here.loads.force[:, k]
    return found
