"""The bars that carry bodies and loads: an action on the two nodes of one bar acts on that bar."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.actions.bars_between import Bars
from kinetruss.dynamics.actions.hinges import hinge_bodies
from kinetruss.dynamics.actions.hubs import hub_bodies
from kinetruss.dynamics.actions.records import Action, Instants, NotOnBars
from kinetruss.model import BodyCouple, BodyForce, NodalForce, Pressure, body_mass
from kinetruss.model.parts import barycentric, placed

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from kinetruss.mechanics import System
    from kinetruss.model import Body

__all__ = ["actions_of_bodies", "actions_of_loads"]

Found = Iterator[Action | NotOnBars]


def actions_of_bodies(system: System, bars: Bars) -> Found:
    """The mass of a body of two nodes acts on the bar between them, at its centre (or spread along it if none is given).

    Bars inside larger bodies are reported instead: the weight of the body, and actions at its other nodes, act on them through
    braces.
    """
    for name, body in system.model.bodies.items():
        i = _bar_of(system, bars, body)
        if i >= 0:
            if body.mass:
                place = None if body.center is None else _share(system, bars, i, body, None)
                worth = partial(_inertia, i, *_mass(system, bars, i, body))
                yield Action(source=name, kind="body", member=i, worth=worth, place=place)
            continue
        own = {system.node_index(node) for node in body.nodes}
        inside = () if name in hub_bodies(system) | hinge_bodies(system) else bars.inside(own)
        if inside and (body.mass or bars.braced(own)):
            yield NotOnBars(source=name, kind="body", nodes=tuple(body.nodes), members=inside)


def actions_of_loads(system: System, bars: Bars, names: Iterable[str]) -> Found:
    """A force or a couple on a bar or on a body of two nodes acts at its place; a pressure on an edge along its bar."""
    model = system.model
    for name in names:
        load = model.loads[name]
        if isinstance(load, NodalForce):
            continue
        if isinstance(load, Pressure):
            yield from _pressure(system, bars, name, load)
            continue
        body = model.bodies.get(load.body)
        if body is None and load.body not in bars.index:
            continue  # on the frame of a node of beams
        i = bars.index[load.body] if body is None else _bar_of(system, bars, body)
        if i >= 0:
            place = _place(system, i, load) if body is None else _share(system, bars, i, body, getattr(load, "at", None))
            yield Action(source=name, kind="load", member=i, worth=partial(_load, i, name), place=place)
        elif (
            load.body not in hub_bodies(system)
            and body is not None
            and (inside := bars.inside({system.node_index(node) for node in body.nodes}))
        ):
            yield NotOnBars(source=name, kind="load", nodes=tuple(body.nodes), members=inside)


def _bar_of(system: System, bars: Bars, body: Body) -> int:
    """The bar between the nodes of a body of two nodes, -1 if there is none or it is an active member."""
    if len(body.nodes) != 2 or set(body.carried_by(system.dim)) != set(body.nodes):
        return -1
    i = bars.between(*(system.node_index(node) for node in body.nodes))
    return -1 if i >= 0 and system.two_rods[i] else i


def _share(system: System, bars: Bars, i: int, body: Body, at: Any) -> float:
    """Fraction from end A of bar i of the start position of a point of a body, by default its centre of mass."""
    points = system.x0[list(bars.ends(i)), : system.dim]
    if at is None and body.center is None:
        return 0.5
    if at is None:
        origin, axes = placed(body.frame, system.dim)
        at = origin + axes.T @ np.array(body.center, float)
    return float(barycentric(points, np.array(at, float))[0][1])


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


def _place(system: System, i: int, load: BodyForce | BodyCouple) -> float:
    """Fraction from end A of a bar of the plane; by default, and for couples, its middle."""
    at = getattr(load, "at", None)
    return 0.5 if at is None else float(at[0]) / float(np.linalg.norm(system.x0[system.q[i]] - system.x0[system.p[i]]))


def _load(i: int, name: str, here: Instants) -> NDArray[np.float64]:
    """Equivalent forces of a load at the ends of bar i."""
    found = np.zeros((len(here.x), 2, 3))
    if here.loads is not None:
        for k, (one, node) in enumerate(zip(here.loads.loads, here.loads.node, strict=True)):
            if one == name:
                found[:, int(node == here.system.q[i])] += here.loads.force[:, k]
    return found


def _pressure(system: System, bars: Bars, name: str, load: Pressure) -> Found:
    nodes = [system.node_index(node) for node in load.face]
    sheets: tuple[Any, ...] = (*system.model.membranes.values(), *system.model.solids.values())
    if any(set(load.face) <= set(one.nodes) for one in sheets):
        return  # it acts on the membrane or solid
    i = bars.between(nodes[0], nodes[1]) if len(nodes) == 2 else -1
    if i >= 0 and not system.two_rods[i]:
        yield Action(source=name, kind="load", member=i, worth=partial(_load, i, name), place=None)
        return
    beams = tuple(beam for beam, one in system.model.beams.items() if set(one.ends) <= set(load.face))
    if inside := (*bars.inside(set(nodes)), *beams):
        yield NotOnBars(source=name, kind="load", nodes=tuple(load.face), members=inside)
