"""Links with a pin in their middle: what bars on one line do not hold, and how beams do."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import few

if TYPE_CHECKING:
    from kinetruss.model._data import ModelData

__all__ = ["line_advice", "middle_pins", "shared_rotations"]

LINE = 1e-6
"""A node within this fraction of the length of a link from its axis lies on it."""

OWN_NODE = (
    "where two links cross, the second one gets a node of its own at the same place (coincident: true), and two couplings keep "
    "x and y of both nodes equal"
)


def middle_pins(model: ModelData) -> list[tuple[str, str, str]]:
    """Three nodes on one line, each two joined by a rigid bar: bars hold the middle one to second order only.

    >>> import kinetruss as kt
    >>> middle_pins(kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)},
    ...                      bars={"ab": ("A", "B"), "bc": ("B", "C"), "ac": ("A", "C")}))
    [('A', 'B', 'C')]
    """
    joined: dict[str, set[str]] = {}
    pairs = [bar.ends for bar in model.bars.values() if bar.kind == "rigid" and not bar.brace]
    for a, b in pairs:
        joined.setdefault(a, set()).add(b)
        joined.setdefault(b, set()).add(a)
    found = []
    for a, c in pairs:
        x, y = (np.array(model.nodes[end].at) for end in (a, c))
        along = y - x
        square = float(along @ along)
        for middle in sorted(joined[a] & joined[c], key=list(model.nodes).index):
            d = np.array(model.nodes[middle].at) - x
            share = float(d @ along) / square
            if 0 < share < 1 and np.linalg.norm(d - share * along) <= LINE * square**0.5:
                found.append((a, middle, c))
    return found


def line_advice(model: ModelData) -> str:
    """How to make a link of which bars do not hold the middle; empty if there is none."""
    pins = middle_pins(model)
    if not pins:
        return ""
    a, m, c = pins[0]
    text = f"{a}, {m} and {c} lie on one line, so that bars do not hold {m}: make the link of two beams ({a}-{m}, {m}-{c})"
    crossed = Counter(middle for _, middle, _ in pins)[m] > 1
    return f"{text}; {OWN_NODE}" if crossed else text


def shared_rotations(model: ModelData) -> str:
    """A sentence on nodes where three beams or more share one rotation; empty if there are none."""
    count = Counter(
        end for beam in model.beams.values() for end in beam.ends if end not in beam.release and end not in beam.hinges
    )
    nodes = [node for node, beams in count.items() if beams > 2]
    if not nodes:
        return ""
    return (
        f"Beams that meet at {few(nodes, 4)} share one rotation, as if welded. Release a beam that is pinned to the others "
        f"(release: [{nodes[0]}]); {OWN_NODE}."
    )
