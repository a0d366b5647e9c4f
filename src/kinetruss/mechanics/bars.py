"""The bar that joins two nodes, and the end at which it is held."""

from __future__ import annotations

import math
from collections import deque
from typing import TYPE_CHECKING

from kinetruss.elements.caching import cached
from kinetruss.kernels.structure.structure import CABLE
from kinetruss.mechanics.members import FREE
from kinetruss.mechanics.system import System
from kinetruss.model.members import Brace

if TYPE_CHECKING:
    from collections.abc import Iterable


class Bars:
    """Members by the pair of nodes that they join, and the pivot of each.

    Nodes are indices. Free bars and cables carry no transverse force, so they do not count here. Of several bars between two
    nodes the first counts, a brace of a body last.
    """

    def __init__(self, system: System) -> None:
        model = system.model
        self.system = system
        self.brace = [isinstance(one, Brace) for one in model.members.values()]
        self.ground = {system.node_index(name) for name, axes in model.fixed.items() if len(axes) == model.dim}
        self.index = {name: i for i, name in enumerate(system.members)}
        self._at: list[list[int]] = [[] for _ in system.nodes]
        for i in range(len(system.members)):
            for node in self.ends(i):
                self._at[node].append(i)
        self._joining: dict[frozenset[int], int] = {}
        for i in sorted(range(len(system.members)), key=lambda i: self.brace[i]):
            if system.kind[i] != FREE and system.law[i] != CABLE:
                self._joining.setdefault(frozenset(self.ends(i)), i)
        self._distance = self._distances()

    def ends(self, i: int) -> tuple[int, int]:
        """Nodes A and B of member i."""
        return int(self.system.p[i]), int(self.system.q[i])

    def between(self, a: int, b: int) -> int:
        """The member that joins two nodes, -1 if there is none."""
        return self._joining.get(frozenset((a, b)), -1)

    def pivot(self, i: int) -> int:
        """The end of member i (0 is A) with fewer members between it and a fixed node; A if both are equal."""
        a, b = self.ends(i)
        return int(self._distance[b] < self._distance[a])

    def touching(self, nodes: Iterable[int]) -> tuple[str, ...]:
        """Members with an end at one of the nodes; if one body has all these nodes, only members between its nodes."""
        wanted = set(nodes)
        for body in self.system.model.bodies.values():
            own = {self.system.node_index(name) for name in body.nodes}
            if wanted <= own:
                return self.inside(own)
        return tuple(self.system.members[i] for i in self._near(wanted) if not self.brace[i])

    def inside(self, nodes: set[int]) -> tuple[str, ...]:
        """Members with both ends among the nodes, without braces of bodies."""
        return tuple(self.system.members[i] for i in self._between(nodes) if not self.brace[i])

    def braced(self, nodes: set[int]) -> bool:
        """True if a brace of a body has both ends among the nodes."""
        return any(self.brace[i] for i in self._between(nodes))

    def _near(self, nodes: set[int]) -> list[int]:
        return sorted({i for node in nodes for i in self._at[node]})

    def _between(self, nodes: set[int]) -> list[int]:
        return [i for i in self._near(nodes) if nodes.issuperset(self.ends(i))]

    def _distances(self) -> list[float]:
        """Number of members between each node and the nearest fixed one (n,); infinite if there is no path."""
        found = [math.inf] * len(self._at)
        for node in self.ground:
            found[node] = 0.0
        waiting = deque(self.ground)
        while waiting:
            one = waiting.popleft()
            for i in self._at[one]:
                for other in self.ends(i):
                    if found[other] == math.inf:
                        found[other] = found[one] + 1.0
                        waiting.append(other)
        return found


@cached()
def bars_of(system: System) -> Bars:
    """The bars of a system."""
    return Bars(system)
