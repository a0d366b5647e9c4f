"""The missing rigid bars between the nodes of a body: the span of its nodes, and places for additional ones."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from itertools import combinations, islice
from typing import TYPE_CHECKING, Any

from kinetruss.errors import Fault
from kinetruss.model.drives import LengthDrive
from kinetruss.model.members import Brace

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kinetruss.model.bodies import Body
    from kinetruss.model.data import ModelData
    from kinetruss.model.members import Bar


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

    from kinetruss.model.bodies import inertia_of, on_carriers, placed, principal, quality, second_moments

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

    from kinetruss.model.bodies import quality

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
        return f"{mend} {_as_link(name, body.nodes, at)}({ADDS}.)"
    fewer = "In the plane two carry any body" if dim == 2 else ("If it is a rod, two" if span == 1 else "If it is flat, three")
    return f"{mend} {fewer}{'' if dim == 2 else ' carry it'}: carriers: [{', '.join(good)}]. ({ADDS}.)"


def _as_link(name: str, nodes: tuple[str, ...], at: dict[str, Any]) -> str:
    """How it is made a link, if the nodes are on one line; with a blank at the end."""
    import numpy as np

    points = np.array([at[node] for node in nodes], float)
    if _span(points) != 1:
        return ""
    along = points[int(np.argmax(np.linalg.norm(points - points[0], axis=1)))] - points[0]
    order = [nodes[k] for k in np.argsort(points @ along, kind="stable")]
    return f"Or make it a link in place of the body (links: {{{name}: [{', '.join(order)}]}}): other parts are pinned to it. "


def _worth(points: Any) -> tuple[float, float]:
    """Quality of points (k, dim) as carriers: their normalised volume; of equal ones the larger."""
    import numpy as np

    from kinetruss.model.bodies import quality

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
        mend += f" {_as_link(path[1], body.nodes, at)}".rstrip()
        yield Fault((*path, "nodes"), message, mend, about=(*(("nodes", name) for name in body.nodes),))


# Braces: the missing rigid bars between the nodes of a body.

CHORD = ".chord"
"""End of the name of the free bar along a beam; it goes with its beam."""

INDEPENDENT = 1e-6
"""Least norm of the new part of the gradient of a bar that counts as independent."""

SOUND = 0.01
"""Normalised volume above which all edges of a simplex are independent."""

Pair = frozenset[str]


def rigid_pairs(model: ModelData) -> set[Pair]:
    """Pairs of nodes joined by a rigid bar."""
    driven = {drive.bar for drive in model.drives.values() if isinstance(drive, LengthDrive)}
    return {frozenset(bar.ends) for name, bar in model.bars.items() if bar.kind == "rigid" and name not in driven}


def braces(model: ModelData, groups: Mapping[str, Body], faulty: Iterable[str] = ()) -> dict[str, dict[str, Bar]]:
    """Bars to be added, by name: for each of these bodies the fewest that, with existing rigid bars, make its nodes rigid.

    Rigid bars, distances in previous bodies and distances between fixed nodes are kept. Then come the edges of the carriers,
    then for every further node the bars with the most independent gradients; a dependent bar is left out.
    """
    skip = set(faulty)
    axes = "xyz"[: model.dim]
    odd = {name for name, node in model.nodes.items() if len(node.at) != model.dim}
    ground = {name for name, fixed in model.fixed.items() if set(fixed) >= set(axes)}
    pairs = rigid_pairs(model)
    clusters = _Clusters(model, ground)
    found: dict[str, dict[str, Bar]] = {}
    taken = set[str]()
    for name, body in groups.items():
        if body.kind != "rigid" or name in skip or odd & set(body.nodes):
            continue
        if body.brace:
            own = found[name] = {}
            for one, two in _missing(model, body, pairs, clusters):
                own[_name(model, taken, f"{name}.{one}-{two}")] = Brace.model_construct(ends=(one, two))
                pairs.add(frozenset((one, two)))
            taken.update(own)
        elif _missing(model, body, pairs, clusters):  # nothing holds its nodes apart yet: what is braced later may have to
            continue
        clusters.add(set(body.nodes))
    return found


class _Clusters:
    """Sets of nodes of rigid parts; of two that share enough nodes to be welded one is made."""

    def __init__(self, model: ModelData, ground: set[str]) -> None:
        self.model = model
        self.sets: list[set[str]] = []
        """A set that became part of a later one is empty."""
        self.of: dict[str, set[int]] = {}
        self.add(ground)

    def together(self, one: str, two: str) -> bool:
        """True if both nodes belong to one set."""
        return not self.of.get(one, set()).isdisjoint(self.of.get(two, ()))

    def add(self, nodes: set[str]) -> None:
        """One more set, with the sets that are welded to it."""
        from kinetruss.model.bodies import quality

        own, last = set(nodes), -1
        beside = {key for name in own for key in self.of.get(name, ())}
        while later := [key for key in beside if key > last]:
            last = min(later)
            shared = [self.model.nodes[name].at for name in sorted(self.sets[last] & own)]
            if any(quality(points) > INDEPENDENT for points in combinations(shared, self.model.dim)):
                beside |= {key for name in self.sets[last] for key in self.of[name]}
                own |= self.sets[last]
                for name in self.sets[last]:
                    self.of[name].discard(last)
                self.sets[last] = set()
        for name in own:
            self.of.setdefault(name, set()).add(len(self.sets))
        self.sets.append(own)


def _name(model: ModelData, taken: Container[str], name: str) -> str:
    """The name, or a similar free one if another member has it."""
    while name in model.bars or name in model.active or name in taken:
        name += "'"
    return name


def _missing(model: ModelData, body: Body, pairs: set[Pair], clusters: _Clusters) -> list[tuple[str, str]]:
    """Pairs of nodes that need a bar."""
    import numpy as np

    from kinetruss.model.bodies import quality

    nodes = body.nodes
    x = np.array([model.nodes[name].at for name in nodes], float)
    every = list(combinations(range(len(nodes)), 2))
    kept = [(i, j) for i, j in every if frozenset((nodes[i], nodes[j])) in pairs or clusters.together(nodes[i], nodes[j])]
    if len(kept) == len(every):
        return []
    carriers = [nodes.index(name) for name in body.carried_by(model.dim)]
    if not kept and len(carriers) == len(nodes) and quality(x) > SOUND:  # all edges are independent
        return [(nodes[i], nodes[j]) for i, j in every]
    space = _Space(x)
    for i, j in kept:
        space.take(i, j)
    edges = [sorted(pair) for pair in combinations(carriers, 2)]
    wanted: list[tuple[int, int]] = [(i, j) for i, j in sorted(edges) if space.take(i, j)]
    done = sorted(carriers)
    for k in range(len(nodes)):
        if k not in carriers:
            wanted += space.best([(i, k) for i in done])
            done.append(k)
    wanted += space.best(every)
    return [(nodes[i], nodes[j]) for i, j in wanted]


class _Space:
    """Gradients of kept distances, as an orthonormal basis."""

    def __init__(self, x: Any) -> None:
        import numpy as np

        self.x = x
        n, dim = x.shape
        # n points that span the space have dim (dim + 1)/2 rigid motions
        self.most = n * (n - 1) // 2 if n <= dim else dim * n - dim * (dim + 1) // 2
        self.basis: Any = np.zeros((0, x.size))

    def rows(self, pairs: Sequence[tuple[int, int]]) -> Any:
        """The parts of the gradients of the distances of some pairs that are independent of kept ones, (pairs, n dim)."""
        import numpy as np

        one, two = np.array(pairs).T
        u = self.x[two] - self.x[one]
        length = np.linalg.norm(u, axis=1)
        sound = (length > 0) & (length < np.inf)  # nodes of a faulty model may be at one place, or beyond all numbers
        u[sound] *= np.sqrt(0.5) / length[sound, None]
        u[~sound] = 0.0
        found = np.zeros((len(pairs), *self.x.shape))
        found[np.arange(len(pairs)), one], found[np.arange(len(pairs)), two] = -u, u
        rest = found.reshape(len(pairs), -1)
        for _ in range(2):
            rest = rest - rest @ self.basis.T @ self.basis
        return rest

    def take(self, i: int, j: int) -> bool:
        """Keep a distance; False if it depends on kept ones."""
        return len(self.basis) < self.most and self._keep(self.rows([(i, j)])[0])

    def _keep(self, rest: Any) -> bool:
        import numpy as np

        size = float(np.linalg.norm(rest))
        if size > INDEPENDENT:
            self.basis = np.vstack([self.basis, rest / size])
        return size > INDEPENDENT

    def best(self, candidates: list[tuple[int, int]]) -> list[tuple[int, int]]:
        """The pairs with independent distances, the most independent first."""
        import numpy as np

        found: list[tuple[int, int]] = []
        if not candidates or len(self.basis) >= self.most:
            return found
        rest = self.rows(candidates)
        while len(self.basis) < self.most:
            sizes = np.linalg.norm(rest, axis=1)
            # nearly equal ones in the order of the nodes, independent of round-off
            first = int(np.argmax(sizes >= 0.999 * sizes.max()))
            own = rest[first] - self.basis.T @ (self.basis @ rest[first])
            if not self._keep(own):
                break
            found.append(candidates[first])
            rest = rest - np.outer(rest @ self.basis[-1], self.basis[-1])
        return found
