"""Braces: the missing rigid bars between the nodes of a body."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any

from kinetruss.model.motion.drives import LengthDrive
from kinetruss.model.parts.members import Bar

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from kinetruss.model._data import ModelData
    from kinetruss.model.parts.bodies import Body

__all__ = ["CHORD", "braced", "braces", "braces_of_each", "rigid_pairs"]

CHORD = ".chord"
"""End of the name of the free bar along a beam; it goes with its beam."""

INDEPENDENT = 1e-6
"""Least norm of the new part of the gradient of a bar that counts as independent."""

Pair = frozenset[str]


def braced(model: ModelData, groups: Mapping[str, Body], faulty: Iterable[str] = ()) -> dict[str, Bar]:
    """The bars of a model with the braces of `groups`: its bodies, and frames of beams; braces of removed ones are left out."""
    rigid: dict[str, set[str]] = {}
    """Node -> rigid bodies with it."""
    for key, body in groups.items():
        for node in body.nodes if body.kind == "rigid" and body.brace else ():
            rigid.setdefault(node, set()).add(key)
    kept = {
        name: bar
        for name, bar in model.bars.items()
        if not bar.brace
        or (bar.kind == "free" and not name.endswith(CHORD))  # it measures a hinge
        or not rigid.get(bar.ends[0], set()).isdisjoint(rigid.get(bar.ends[1], ()))
    }
    return {**kept, **braces(model, groups, faulty)}


def rigid_pairs(model: ModelData) -> set[Pair]:
    """Pairs of nodes joined by a rigid bar."""
    driven = {drive.bar for drive in model.drives.values() if isinstance(drive, LengthDrive)}
    return {frozenset(bar.ends) for name, bar in model.bars.items() if bar.kind == "rigid" and name not in driven}


def braces(model: ModelData, groups: Mapping[str, Body], faulty: Iterable[str] = ()) -> dict[str, Bar]:
    """Bars to be added, by name: for each of these bodies the fewest that, with existing rigid bars, make its nodes rigid.

    Rigid bars, distances in previous bodies and distances between fixed nodes are kept. Then come the edges of the carriers,
    then for every further node the bars with the most independent gradients; a dependent bar is left out.
    """
    return _grown(model, groups, faulty)[0]


def braces_of_each(model: ModelData, groups: Mapping[str, Body], more: Mapping[str, Body]) -> dict[str, dict[str, Bar]]:
    """The braces of each of `more` bodies, as if the others were not there: rigid loops stay redundant."""
    _, pairs, clusters = _grown(model, groups, ())
    found: dict[str, dict[str, Bar]] = {}
    for name, body in more.items():
        missing = _missing(model, body, pairs, clusters)
        found[name] = {_name(model, {}, f"{name}.{one}-{two}"): Bar(ends=(one, two), mass=0.0) for one, two in missing}
    return found


def _grown(model: ModelData, groups: Mapping[str, Body], faulty: Iterable[str]) -> tuple[dict[str, Bar], set[Pair], _Clusters]:
    """`braces` of bodies, then all pairs of nodes with a rigid bar, and the sets of nodes of rigid parts."""
    skip = set(faulty)
    axes = "xyz"[: model.dim]
    odd = {name for name, node in model.nodes.items() if len(node.at) != model.dim}
    ground = {name for name, fixed in model.fixed.items() if set(fixed) >= set(axes)}
    pairs = rigid_pairs(model)
    clusters = _Clusters(model, ground)
    found: dict[str, Bar] = {}
    for name, body in groups.items():
        if body.kind != "rigid" or name in skip or odd & set(body.nodes):
            continue
        if body.brace:
            for one, two in _missing(model, body, pairs, clusters):
                found[_name(model, found, f"{name}.{one}-{two}")] = Bar(ends=(one, two), brace=True)
                pairs.add(frozenset((one, two)))
        clusters.add(set(body.nodes))
    return found, pairs, clusters


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
        from kinetruss.model.parts.body_mass import quality

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


def _name(model: ModelData, found: dict[str, Bar], name: str) -> str:
    """The name, or a similar free one if another member has it."""
    while name in model.bars or name in model.active or name in found:
        name += "'"
    return name


def _missing(model: ModelData, body: Body, pairs: set[Pair], clusters: _Clusters) -> list[tuple[str, str]]:
    """Pairs of nodes that need a bar."""
    import numpy as np

    nodes = body.nodes
    x = np.array([model.nodes[name].at for name in nodes], float)
    space = _Space(x)
    for i, j in combinations(range(len(nodes)), 2):
        if frozenset((nodes[i], nodes[j])) in pairs or clusters.together(nodes[i], nodes[j]):
            space.take(i, j)
    carriers = [nodes.index(name) for name in body.carried_by(model.dim)]
    edges = [sorted(pair) for pair in combinations(carriers, 2)]
    wanted: list[tuple[int, int]] = [(i, j) for i, j in sorted(edges) if space.take(i, j)]
    done = sorted(carriers)
    for k in range(len(nodes)):
        if k not in carriers:
            wanted += space.best([(i, k) for i in done])
            done.append(k)
    wanted += space.best(list(combinations(range(len(nodes)), 2)))
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
