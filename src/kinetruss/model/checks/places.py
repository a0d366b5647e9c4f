"""Cross-checks of bodies: the span of their nodes, and places for additional nodes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, islice, pairwise
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData
    from kinetruss.model.parts.bodies import Body

__all__ = ["FLAT", "ROUND", "beside", "lying", "place_faults"]

FLAT = 1e-6
"""Points count as lying in a plane or on a line up to this normalised volume; it is 1 for a regular simplex."""
ROUND = 1e-6
"""Tolerance of moments of inertia, axes and distances from a plane, as a fraction of the largest."""
THIN = 1e-10
"""Least principal moment, as a fraction of the largest, that counts as inertia about an axis."""
ADDS = "kt.library.bodies.rigid adds what is missing"
_TRIED = 5000
_COUNT = {1: "a node", 2: "two nodes", 3: "three nodes"}


Driven = Mapping[str, Sequence[tuple[str, str]]]
"""First end -> name and other end of each member whose length is driven."""


def place_faults(model: ModelData, body: Body, path: tuple[str, str], dim: int, driven: Driven) -> Iterator[Fault]:
    """Faults of carriers that do not span the mass, and of nodes that bars cannot hold."""
    import numpy as np

    from kinetruss.model.parts.body_mass import inertia_of, on_carriers, placed, principal, quality, second_moments

    about = (*((("nodes", name)) for name in body.nodes), (*path, "frame"), (*path, "center"), (*path, "inertia"))
    at = {name: np.array(model.nodes[name].at, float) for name in body.nodes}
    for one, two in combinations(body.nodes, 2):
        if np.array_equal(at[one], at[two]):
            place = ", ".join(f"{float(v):.6g}" for v in at[one])
            message = f"{one!r} and {two!r} stand at one place, ({place})."
            yield Fault((*path, "nodes"), message, _instead(model, path[1], at, dim), about=about)
            return
    carriers = body.carried_by(dim)
    points = np.array([at[name] for name in carriers])
    if (found := quality(points)) <= FLAT:
        how = _close(carriers, points) or f"{', '.join(map(repr, carriers))} lie {lying(points)}"
        message = f"{how} (normalised volume {found:.1e}, 1 is best)."
        mend = _others(model, path[1], body, at, dim)
        yield Fault((*path, "carriers" if body.carriers else "nodes"), message, mend, about=about)
        return
    if body.center is not None and body.mass and len(carriers) <= dim and not (dim == 2 and len(carriers) == 2):
        origin, axes = placed(body.frame, dim)
        S = second_moments(inertia_of(body, dim))
        _, off = on_carriers(points, body.mass, origin + axes.T @ np.array(body.center), S)
        if off > ROUND:
            where = "the line of its two carriers" if len(carriers) == 2 else "the plane of its three carriers"
            message = f"has mass off {where} ({off:.1e} of its moments)."
            mend = f"Give four nodes that are not in one plane ({ADDS}), or a centre and moments in it: the moment about "
            mend += "its normal is "
            mend += "the sum of the other two." if len(carriers) == 3 else "0 about the line."
            yield Fault(path, message, mend, about=about)
    if body.kind == "rigid" and body.mass and dim == 3 and len(carriers) > 2 and body.inertia is not None:
        moments = principal(body, dim)
        if moments[0] <= THIN * moments[2]:
            message = f"has no moment of inertia about its own line, about which its nodes turn ({moments[0]:.3g} kg m^2)."
            mend = "Let two nodes of that line carry it: carriers: [.., ..]; or give it a small moment."
            if not moments[2]:
                message, mend = "is 0: the mass is a point.", "Give moments in kg m^2, or the mass to a node instead of a body."
            yield Fault((*path, "inertia"), message, mend, about=about)
    if body.kind == "rigid":
        yield from _held(model, body, at, path, dim, driven)


def lying(points: Any) -> str:
    """The degenerate position of points (k, dim) in words: two of them at one place, all on one line, or in one plane."""
    span = _span(points)
    return "almost at one place" if span == 0 else "on one line" if span == 1 else "in one plane"


def _instead(model: ModelData, name: str, at: dict[str, Any], dim: int) -> str:
    """The fix for a body with nodes at one place."""
    import numpy as np

    points = np.unique(np.array(list(at.values())), axis=0)
    if len(points) < 2:
        return "Move all but one of them apart."
    if (span := _span(points)) == dim:
        return "Keep one of them."
    new = [_free(model, f"{name}.apex{k + 1}") for k in range(dim - span)]
    if not new:
        return "Give it nodes of which none lies far off all others."
    return f"Keep one of them. {_add(points, dim, new)[:-1]}; or move the other there."


def _span(points: Any) -> int:
    """Dimension of what points (k, dim) span: 0 a place, 1 a line, 2 a plane, 3 space."""
    import numpy as np

    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return int(np.sum(spread > FLAT * spread[0]))


def _close(names: tuple[str, ...], points: Any) -> str:
    """Two points almost at one place, in words; empty if there are none."""
    import numpy as np

    size = np.abs(points - points.mean(axis=0)).max()
    for i, j in combinations(range(len(names)), 2):
        apart = float(np.linalg.norm(points[i] - points[j]))
        if apart <= FLAT * size:
            return f"{names[i]!r} and {names[j]!r} stand almost at one place, {apart:.1e} m apart"
    return ""


def _others(model: ModelData, name: str, body: Body, at: dict[str, Any], dim: int) -> str:
    """The fix: other carriers, or places of further nodes, or fewer carriers for a flat body or a rod."""
    import numpy as np

    from kinetruss.model.parts.body_mass import quality

    def best(count: int) -> tuple[str, ...]:
        tried = islice(combinations(body.nodes, count), _TRIED)
        found = max(tried, key=lambda names: _worth(np.array([at[key] for key in names])), default=())
        return found if found and quality([at[key] for key in found]) > FLAT else ()

    count = len(body.carried_by(dim))
    if found := best(dim + 1) or best(count):
        return f"Take others: carriers: [{', '.join(found)}]."
    span = _span(np.array(list(at.values())))
    good = best(span + 1)
    new = [_free(model, f"{name}.apex{k + 1}") for k in range(dim - span)]
    if not new:
        return "Give it nodes of which none lies far off all others."
    mend = f"{_add(np.array(list(at.values())), dim, new)} and let them carry it: carriers: [{', '.join((*good, *new))}]."
    if not span:
        return mend
    if body.brace and body.kind == "rigid" and len(body.nodes) > span + 1:  # bars would not hold its nodes on this line
        return f"{mend} {_of_beams(body.nodes, at)}({ADDS}.)"
    fewer = "In the plane two carry any body" if dim == 2 else ("If it is a rod, two" if span == 1 else "If it is flat, three")
    return f"{mend} {fewer}{'' if dim == 2 else ' carry it'}: carriers: [{', '.join(good)}]. ({ADDS}.)"


def _of_beams(nodes: tuple[str, ...], at: dict[str, Any]) -> str:
    """How a straight link is made of beams, if the nodes are on one line; with a blank at the end."""
    import numpy as np

    points = np.array([at[node] for node in nodes], float)
    if _span(points) != 1:
        return ""
    along = points[int(np.argmax(np.linalg.norm(points - points[0], axis=1)))] - points[0]
    order = [nodes[k] for k in np.argsort(points @ along, kind="stable")]
    pairs = ", ".join(f"{a}-{b}" for a, b in pairwise(order))
    return f"Or make a straight link of beams in place of the body: {pairs}; stiff where they meet, bars are pinned to them. "


def _worth(points: Any) -> tuple[float, float]:
    """Quality of points (k, dim) as carriers: their normalised volume; of equal ones the larger."""
    import numpy as np

    from kinetruss.model.parts.body_mass import quality

    return round(quality(points), 9), float(np.linalg.norm(points - points.mean(axis=0)))


def _free(model: ModelData, name: str) -> str:
    while name in model.nodes:
        name += "'"
    return name


def _add(points: Any, dim: int, new: list[str]) -> str:
    """The fix: nodes to add to points (k, dim) so that they span all directions, with their names."""
    places = beside(points, dim)
    shown = [f"{key}: [{', '.join(f'{float(v):.4g}' for v in place)}]" for key, place in zip(new, places, strict=True)]
    return f"Add {_COUNT[len(shown)]} beside them to the model and the body, e.g. nodes: {{{', '.join(shown)}}},"


def beside(points: Any, dim: int) -> list[Any]:
    """Places (dim,) beside points (k, dim) that lie in a plane or on a line: each at their mean distance from their centroid,
    as many as are needed to span all directions.
    """
    import numpy as np

    points, found = np.array(points, float), []
    while (span := _span(points)) < dim:
        middle = points.mean(axis=0)
        _, _, rows = np.linalg.svd(points - middle)
        off = np.sqrt(np.mean(np.sum((points - middle) ** 2, axis=1)))
        if not off:  # a single place has no size
            break
        # the normal nearest to an axis, so that round coordinates stay round
        normals = rows[span:]
        axis = int(np.argmax(np.sum(normals**2, axis=0).round(9)))
        normal = normals[:, axis] @ normals
        place = middle + off * normal / np.linalg.norm(normal)
        place[np.abs(place) < 1e-12 * off] = 0.0
        found.append(place)
        points = np.vstack([points, place])
    return found


def _held(model: ModelData, body: Body, at: dict[str, Any], path: tuple[str, str], dim: int, driven: Driven) -> Iterator[Fault]:
    """No bar between nodes of a rigid body may change its length; more nodes than a simplex must not be flat."""
    import numpy as np

    for start in body.nodes:
        for name, end in driven.get(start, ()):
            if end in body.nodes:
                mend = "Take one of its ends out of the body, or make the body kind: straining."
                message = f"is rigid, but {name!r} drives the distance of its nodes {start!r} and {end!r}."
                yield Fault(path, message, mend, about=(("bars", name), ("active", name)))
    points = np.array(list(at.values()))
    span = _span(points)
    if body.brace and len(points) > span + 1 and span < dim:
        where = "in one plane" if span == 2 else "on one line"
        message = f"has {len(points)} nodes {where}, which bars between them hold to second order only."
        new = [_free(model, f"{path[1]}.apex{k + 1}") for k in range(dim - span)]
        mend = f"{_add(points, dim, new)[:-1]}; {'it needs' if len(new) == 1 else 'they need'} no mass ({ADDS})."
        if not body.carriers:
            mend += f" Keep its carriers: [{', '.join(body.carried_by(dim))}]."
        mend += f" {_of_beams(body.nodes, at)}".rstrip()
        yield Fault((*path, "nodes"), message, mend, about=(*(("nodes", name) for name in body.nodes),))
