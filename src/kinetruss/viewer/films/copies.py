"""Copies of a shape: many rods, balls or cones, each with its own place, size and colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import rgb

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["Copies", "copies", "striped"]

STRIPES, SEVERAL = 25, 300
"""Number of stripes of a bar, and of striped bars above which there are a third as many."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Copies:
    """Copies of a shape: start (n, 3), end (n, 3), m; radius (n,), m; colour (n, 3), 0 to 255; second (n, 3) a direction
    across, 0 if any will do; wide (n,), m, the radius across both.
    """

    start: Array
    end: Array
    radius: Array
    colour: NDArray[np.uint8]
    second: Array
    wide: Array

    @classmethod
    def all(cls, several: Sequence[Copies]) -> Copies:
        """Several sets of copies, joined."""
        kept = [one for one in several if len(one.radius)]
        if not kept:
            return copies(np.zeros((0, 3)), np.zeros((0, 3)), 0.0, np.zeros((0, 3)))
        return cls(**{name: np.concatenate([getattr(one, name) for one in kept]) for name in cls.__slots__})


def copies(
    start: Array, end: Array, radius: Array | float, colour: Any, second: Array | None = None, wide: Array | None = None
) -> Copies:
    """Copies with one colour, or one colour each; round ones, or with a direction across and another radius across both."""
    count = len(start)
    shade = np.array(rgb(colour) if isinstance(colour, str) else colour, np.uint8)
    return Copies(
        start=start,
        end=end,
        radius=np.broadcast_to(np.asarray(radius, float), count).copy(),
        colour=np.broadcast_to(shade, (count, 3)).copy(),
        second=np.zeros((count, 3)) if second is None else second,
        wide=np.broadcast_to(np.asarray(radius if wide is None else wide, float), count).copy(),
    )


def striped(several: Copies, ever: NDArray[np.bool_], now: NDArray[np.bool_], pale: str) -> Copies:
    """Bars of which those that are `ever` striped are cut into pieces; every other piece has the pale colour if they are `now`.

    The number of copies does not change in time.
    """
    count = STRIPES if ever.sum() <= SEVERAL else STRIPES // 3
    cut = {name: getattr(several, name)[ever] for name in Copies.__slots__}
    along, light = cut["end"] - cut["start"], rgb(pale)
    found = [Copies(**{name: getattr(several, name)[~ever] for name in Copies.__slots__})]
    for k in range(count):
        start, end = (cut["start"] + (k + one) / count * along for one in (0, 1))
        colour = np.where(now[ever][:, None] & bool(k % 2), light, cut["colour"])
        found.append(copies(start, end, cut["radius"], colour, cut["second"], cut["wide"]))
    return Copies.all(found)
