"""Braces: the missing rigid bars between the nodes of a body."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any

from kinetruss.model.motion.drives import LengthDrive
from kinetruss.model.parts.members import Bar

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

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
    rigid = [set(body.nodes) for body in groups.values() if body.kind == "rigid" and body.brace]
    kept = {
        name: bar
        for name, bar in model.bars.items()
        if not bar.brace
        or (bar.kind == "free" and not name.endswith(CHORD))  # it measures a hinge
        or any(set(bar.ends) <= one for one in rigid)
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


def _grown(
    model: ModelData, groups: Mapping[str, Body], faulty: Iterable[str]
) -> tuple[dict[str, Bar], set[Pair], list[set[str]]]:
    """`braces` of bodies, then all pairs of nodes with a rigid bar, and the sets of nodes of rigid parts."""
    skip = set(faulty)
    axes = "xyz"[: model.dim]
    odd = {name for name, node in model.nodes.items() if len(node.at) != model.dim}
    ground = {name for name, fixed in model.fixed.items() if set(fixed) >= set(axes)}
    pairs = rigid_pairs(model)
    clusters = [ground]
    found: dict[str, Bar] = {}
    for name, body in groups.items():
        if body.kind != "rigid" or name in skip or odd & set(body.nodes):
            continue
        if body.brace:
            for one, two in _missing(model, body, pairs, clusters):
                found[_name(model, found, f"{name}.{one}-{two}")] = Bar(ends=(one, two), brace=True)
                pairs.add(frozenset((one, two)))
        clusters = _joined(model, clusters, set(body.nodes))
    return found, pairs, clusters


def _name(model: ModelData, found: dict[str, Bar], name: str) -> str:
    """The name, or a similar free one if another member has it."""
    while name in model.bars or name in model.active or name in found:
        name += "'"
    return name


def _missing(model: ModelData, body: Body, pairs: set[Pair], clusters: list[set[str]]) -> list[tuple[str, str]]:
    """Pairs of nodes that need a bar."""
    import numpy as np

    nodes = body.nodes
    x = np.array([model.nodes[name].at for name in nodes], float)
    space = _Space(x)
    for i, j in combinations(range(len(nodes)), 2):
        if frozenset((nodes[i], nodes[j])) in pairs or any({nodes[i], nodes[j]} <= one for one in clusters):
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

    def new(self, i: int, j: int) -> Any:
        """The part of the gradient of the distance between two nodes that is independent of kept ones."""
        import numpy as np

        row = np.zeros_like(self.x)
        u = self.x[j] - self.x[i]
        u = u / np.linalg.norm(u) * np.sqrt(0.5)
        row[i], row[j] = -u, u
        rest = row.reshape(-1)
        for _ in range(2):
            rest = rest - self.basis.T @ (self.basis @ rest)
        return rest

    def take(self, i: int, j: int) -> bool:
        """Keep a distance; False if it depends on kept ones."""
        import numpy as np

        if len(self.basis) >= self.most:
            return False
        rest = self.new(i, j)
        size = float(np.linalg.norm(rest))
        if size <= INDEPENDENT:
            return False
        self.basis = np.vstack([self.basis, rest / size])
        return True

    def best(self, candidates: list[tuple[int, int]]) -> list[tuple[int, int]]:
        """The pairs with independent distances, the most independent first."""
        import numpy as np

        found = []
        while candidates and len(self.basis) < self.most:
            sizes = [float(np.linalg.norm(self.new(i, j))) for i, j in candidates]
            # nearly equal ones in the order of the nodes, independent of round-off
            first = next(k for k, size in enumerate(sizes) if size >= 0.999 * max(sizes))
            if not self.take(*candidates[first]):
                break
            found.append(candidates.pop(first))
        return found


def _joined(model: ModelData, clusters: list[set[str]], nodes: set[str]) -> list[set[str]]:
    """Sets of nodes of rigid parts, with one more set; sets welded to it are merged with it."""
    from kinetruss.model.parts.body_mass import quality

    apart = []
    for one in clusters:
        shared = [model.nodes[name].at for name in sorted(one & nodes)]
        if any(quality(points) > INDEPENDENT for points in combinations(shared, model.dim)):
            nodes = nodes | one
        else:
            apart.append(one)
    return [*apart, nodes]
