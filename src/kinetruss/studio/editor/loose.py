"""Nodes that look joined in the picture but are not: on a bar, or at the place of another node."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

__all__ = ["loose_ends"]

NEAR = 1e-6
"""Distance of a node from a bar, as a fraction of the size of the drawing, below which it lies on it."""

MOST_PAIRS = 200_000
"""Largest number of pairs of a node and a member that are looked at."""

LISTED = 4
"""Largest number of sentences."""


def loose_ends(places: Mapping[str, Sequence[float]], members: Mapping[str, Sequence[str]]) -> list[str]:
    """Sentences about nodes that lie on members, or on other nodes, without being joined to them.

    places : node -> place, m. members : name -> its two ends.

    >>> places = {"A": [0, 0], "B": [2, 0], "C": [1, 0], "D": [1, 1]}
    >>> loose_ends(places, {"b1": ["A", "B"], "b2": ["C", "D"]})
    ['C lies on b1 but is not joined to it. To join them, make b1 of two beams that meet at C; two bars would fold there.']
    """
    if not places or len(places) * max(1, len(members)) > MOST_PAIRS:
        return []
    names, x = list(places), np.array(list(places.values()), float)
    near = NEAR * (float(np.ptp(x, axis=0).max()) or 1.0)
    index = {name: k for k, name in enumerate(names)}
    same: dict[bytes, list[str]] = {}
    for name, place in zip(names, np.round(x / near), strict=True):
        same.setdefault((place + 0.0).tobytes(), []).append(name)
    found = [f"{' and '.join(some)} are at the same place but are not joined." for some in same.values() if len(some) > 1]
    labels, ends = list(members), np.array([[index[end] for end in pair] for pair in members.values()], int).reshape(-1, 2)
    start, along = x[ends[:, 0]], x[ends[:, 1]] - x[ends[:, 0]]
    square = (along**2).sum(axis=1)
    long = np.flatnonzero(square > near**2)
    start, along, size = start[long], along[long], square[long] ** 0.5
    apart = x - start[:, None]
    way = np.einsum("mnk,mk->mn", apart, along) / size[:, None]
    off = np.linalg.norm(apart - (way / size[:, None])[..., None] * along[:, None], axis=2)
    inside = (off < near) & (way > near) & (size[:, None] - way > near)
    for member, node in np.argwhere(inside).tolist():
        name = labels[long[member]]
        mend = f"To join them, make {name} of two beams that meet at {names[node]}; two bars would fold there."
        found.append(f"{names[node]} lies on {name} but is not joined to it. {mend}")
    rest = len(found) - LISTED
    return found[:LISTED] + ([f"{rest} more places where parts meet without being joined."] if rest > 0 else [])
