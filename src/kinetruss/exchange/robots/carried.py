"""The body of each rigid part: the nodes that carry its mass, and further nodes where bars alone would not hold it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from kinetruss.exchange.robots.draft import LEAST, REACH, Draft, extent
from kinetruss.exchange.robots.parts import NOTHING, SAME, Part
from kinetruss.exchange.robots.records import LeftOut
from kinetruss.library.bodies import MassProperties
from kinetruss.model import Body
from kinetruss.model.checks import beside
from kinetruss.model.parts import quality, second_moments

__all__ = ["body_of"]

ROUND = 1e-6
"""Difference of the two cross moments of a rod, relative to their mean, that still counts as none."""
THIN = 1e-9
"""A body has no extent in a direction if the second moment is below this fraction of the largest."""
WIDE, GOOD = 0.5, 0.05
"""Least distance of own nodes that carry a mass, over the radius of gyration, and least normalised area or volume."""
THICK = 0.1
"""Least thickness of the carrying tetrahedron over its length; the mass matrix is exact for any thickness."""
APART, FACTORS = 0.01, (1.0, 1.25, 0.8, 1.4, 0.7, 1.7, 0.55, 2.1)
"""Least distance of a carrier from other nodes, over that from the centre, and factors of its distance from the centre."""
CORNERS = np.sqrt(3.0) * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
"""Alternate corners of a cube whose second moments are 1 if a quarter of the mass is at each."""


def body_of(draft: Draft, part: Part) -> Body | None:
    """The body of a part; None if it has neither mass nor nodes, or is a single point."""
    given = part.properties
    if given is not None and float(np.trace(given.inertia)) <= NOTHING * given.mass * draft.size**2:
        text = "the link has mass without inertia: its mass is at one node"
        draft.left += [LeftOut("inertia", part.where, text)] * bool(given.inertia.any() or given.mass)
        node = draft.share(f"{part.name}.mass", given.center, (part.name,))
        draft.masses[node] = draft.masses.get(node, 0.0) + given.mass
        given = None
    names = draft.own[part.name]
    if len(names) == 2 and part.balls_only and (given is None or _round(draft, names, given)):
        text = "turns freely about the line of its two balls; it is carried by the two nodes without that turning"
        draft.left.append(LeftOut("spin", part.where, text))
        return Body(nodes=tuple(names), carriers=tuple(names), **_mass(draft, names, given))
    if given is None and not _reaching(draft, part):
        return None
    carriers = () if given is None else _carriers(draft, part.name, given)
    _braced(draft, part.name, least=3 if given is None else 0)
    carriers = carriers or _spanning({name: draft.at(name) for name in names})
    fields = {} if given is None else _fields(given)
    return Body(nodes=(*carriers, *(name for name in names if name not in carriers)), carriers=carriers, **fields)


def _fields(given: MassProperties) -> dict[str, Any]:
    return {"mass": given.mass, "center": tuple(given.center.tolist()), "inertia": given.inertia.tolist()}


def _mass(draft: Draft, names: Sequence[str], given: MassProperties | None) -> dict[str, Any]:
    """Mass properties of a rod on two nodes, without its moment about their line."""
    if given is None:
        return {}
    along = draft.at(names[1]) - draft.at(names[0])
    across = np.eye(3) - np.outer(along, along) / float(along @ along)
    return _fields(given) | {"inertia": (0.5 * float(np.trace(across @ given.inertia)) * across).tolist()}


def _round(draft: Draft, names: Sequence[str], given: MassProperties) -> bool:
    """True if a mass is alike all round the line of two nodes."""
    a, b = (draft.at(name) for name in names)
    along = (b - a) / float(np.linalg.norm(b - a))
    across = np.eye(3) - np.outer(along, along)
    moment = 0.5 * float(np.trace(across @ given.inertia))
    rest = across @ given.inertia @ across - moment * across
    crossed = float(np.abs(given.inertia @ along - (along @ given.inertia @ along) * along).max())
    off = float(np.linalg.norm(across @ (given.center - a)))
    return off <= SAME * draft.size and max(float(np.abs(rest).max()), crossed) <= ROUND * moment


def _carriers(draft: Draft, name: str, given: MassProperties) -> tuple[str, ...]:
    """Own nodes that carry a mass, or new ones: two of a rod on its line, three of a plate in its plane, else four."""
    values, axes = np.linalg.eigh(second_moments(given.inertia))
    values, axes = values[::-1], axes[:, ::-1] * np.sign(axes[np.abs(axes).argmax(axis=0), np.arange(3)])[::-1]
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    count = int(np.sum(values > THIN * values[0])) + 1
    reach = math.sqrt(values[0] / given.mass)
    off = {key: np.abs((draft.at(key) - given.center) @ axes[:, count - 1 :]) for key in draft.own[name]}
    within = {key: draft.at(key) for key, far in off.items() if (far <= SAME * draft.size).all()}
    if len(within) >= count:
        own = _spanning(within)[:count]
        points = np.array([within[key] for key in own])
        wide = float(np.linalg.norm(np.ptp(points, axis=0))) > WIDE * min(reach, draft.size)
        if len(own) == count and wide and quality(points) > GOOD:
            return own
    # the mass matrix is exact for any carriers: these neither stand close to each other nor far outside the robot
    spread = np.clip(np.sqrt(np.maximum(values, 0.0) / given.mass), LEAST * draft.size / 4, 2 * draft.size)
    spread = np.maximum(spread, THICK * spread[0])
    turns = np.pi / 2 + 2 * np.pi / 3 * np.arange(3)
    triangle = np.sqrt(8.0) * np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    local = {2: np.sqrt(3.0) * np.array([[-1.0, 0, 0], [1.0, 0, 0]]), 3: triangle, 4: CORNERS}[count]
    ways = (local * spread) @ axes.T
    others = np.array([draft.places[key] for key in draft.own[name]])
    factor = next((one for one in FACTORS if _apart(given.center + one * ways, others, APART * spread[0])), 1.0)
    new = tuple(draft.add(f"{name}.{k + 1}", place) for k, place in enumerate(given.center + factor * ways))
    draft.own[name] += new
    return new


def _apart(places: Any, others: Any, least: float) -> bool:
    return not len(others) or float(np.linalg.norm(places[:, None] - others[None], axis=2).min()) > least


def _reaching(draft: Draft, part: Part) -> bool:
    """Give a part without mass two more nodes beside a single one, for its joint; False if it is no body but a point."""
    own = draft.own[part.name]
    if len(own) == 1 and part.joints:
        reach = REACH * extent(part, draft.size)
        own += [draft.add(f"{part.name}.{k + 1}", draft.at(own[0]) + reach * along) for k, along in enumerate(np.eye(3)[:2])]
    return len(own) > 1


def _braced(draft: Draft, name: str, least: int) -> None:
    """Nodes beside those of a part that lie in one plane or on one line: bars hold them there to second order only.

    least : number of nodes that a part needs to have a direction.
    """
    own = draft.own[name]
    more = beside(np.array([draft.places[key] for key in own]), 3)
    if len(own) > max(4 - len(more), least - 1) or 4 - len(more) < least:
        own += [draft.add(f"{name}.apex{k + 1 if k else ''}", place) for k, place in enumerate(more)]


def _spanning(places: Mapping[str, Any]) -> tuple[str, ...]:
    """Nodes that span what all of them span, chosen one by one by their distance from those before."""
    names = list(places)
    points = np.array(list(places.values()))
    away = points - points[0]
    first = float(np.linalg.norm(away, axis=1).max(initial=0.0))
    chosen = [0]
    while len(chosen) < 4:
        far = np.linalg.norm(away, axis=1)
        best = int(np.argmax(far >= far.max() * (1 - 1e-9)))
        if far[best] <= 1e-9 * first or best in chosen:
            break
        chosen.append(best)
        row = away[best] / far[best]
        away = away - np.outer(away @ row, row)
    return tuple(names[k] for k in chosen)
