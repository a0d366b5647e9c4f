"""Places from which a pose is sought: the given one, where the structure stands, all over the strokes, and near by.

They are the same in every call.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


__all__ = ["STARTS", "starts_of"]

STARTS = 16
"""Starts of a pose that is not met."""
NEAR = 0.15
"""Change of drives near by, in units of the shortest bar or rad, and 0.4 of the stroke at most."""
WIDE = 0.4
"""Spread of lengths without limits about the start, in units of the shortest bar; angles turn half a turn to either side."""


def starts_of(given: Any, first: Any, count: int) -> Iterator[Any]:
    """At most `count` states to start from: the first, the model's own, then in turn from the spread and near the first.

    given, first : the `Problem` of the task and a `State` of it.
    """
    yield first
    own = not np.array_equal(first.q, given.begin.q)
    if own and count > 1:
        yield given.begin
    rng, rest = np.random.default_rng(1), max(0, count - 1 - own)
    spread = _spread(given, rng, (rest + 1) // 2)
    for k in range(rest):
        start = given.begin if k % 2 == 0 else first
        wanted = spread[k // 2] if k % 2 == 0 else _near(given, rng, first.q)
        # a share of the way where the structure cannot be closed on all of it
        for share in (1.0, 0.5, 0.25):
            if (found := given.moved(start, start.q + share * (wanted - start.q))) is not None:
                yield found
                break


def _spread(given: Any, rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Drives (count, d) in all parts of their strokes, by a Latin hypercube (McKay, Beckman and Conover, 1979).

    Every other one has all its drives at the nearer ends of their strokes, where nearest poses often are.
    """
    lower, upper, own = given.drives.lower, given.drives.upper, given.begin.q
    room = np.where(given.turning, np.pi, WIDE * given.scale)
    low, high = np.where(np.isfinite(lower), lower, own - room), np.where(np.isfinite(upper), upper, own + room)
    cells = np.stack([rng.permutation(count) for _ in own], axis=1) + rng.uniform(size=(count, len(own)))
    share = cells / max(1, count)
    share[::2] = np.round(share[::2])
    found: NDArray[np.float64] = np.where(given.drives.held == 3, own, low + (high - low) * share)
    return found


def _near(given: Any, rng: np.random.Generator, q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Some other drives (d,) near by, within their strokes."""
    lower, upper = given.drives.lower, given.drives.upper
    room = np.minimum(NEAR * given.units, 0.4 * (upper - lower))
    return np.where(given.drives.held == 3, q, np.clip(q + rng.uniform(-1, 1, len(q)) * room, lower, upper))
