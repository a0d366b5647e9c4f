"""Places labels beside points, away from lines and from each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["CROWDED", "Labels"]

SIZE = 7.0
"""Size of the letters, points."""
WIDE, HIGH = 0.6, 1.25
"""Width and height of a letter, of its size."""
AWAY = (0.05, 0.13, 0.26)
"""Distances between a point and its label that are tried, inches."""
SAMPLES = 24
MARK = 0.16
"""Size of the mark of a support, inches."""
CROWDED = 9.0
"""What a label that may be left out covers at most."""


class Labels:
    """Labels of one drawing. scale : m an inch; lines : pairs of points (2, 2), m, and marks : points (k, 2), m,
    that labels avoid.
    """

    def __init__(self, ax: Any, scale: float, lines: Sequence[Array], marks: Array) -> None:
        self._ax, self._scale = ax, scale
        share = np.linspace(0, 1, SAMPLES)[:, None]
        points = [line[0] + share * (line[1] - line[0]) for line in lines]
        self._ink = np.concatenate(points) if points else np.zeros((0, 2))
        half = MARK / 2 * scale
        self._boxes: list[tuple[Array, Array]] = [(mark - half, mark + half) for mark in marks]

    def put(self, words: str, at: Array, colour: str, *, bold: bool = False, most: float = np.inf) -> None:
        """Write a label near a point, where it covers least; not at all if it covers more than `most`."""
        size = SIZE / 72 * np.array([WIDE * len(words), HIGH]) * (1.06 if bold else 1.0)
        extent = size * self._scale
        choices = []
        for far in AWAY:
            for angle in np.radians([35, 145, -35, -145, 0, 180, 90, -90]):
                way = np.array([np.cos(angle), np.sin(angle)])
                middle = at + way * (far * self._scale) + way * extent / 2
                choices.append((self._covered(middle - extent / 2, middle + extent / 2) + 0.4 * AWAY.index(far), middle))
        cost, middle = min(choices, key=lambda one: one[0])
        if cost > most:
            return
        self._boxes.append((middle - extent / 2, middle + extent / 2))
        weight = "bold" if bold else "normal"
        self._ax.text(*middle, words, fontsize=SIZE, color=colour, ha="center", va="center", fontweight=weight)

    def _covered(self, low: Array, high: Array) -> float:
        """How much a box covers: other labels count ten times a piece of line; outside of the drawing it counts most."""
        inside = np.all((self._ink > low) & (self._ink < high), axis=1).sum()
        over = sum(bool(np.all(low < top) and np.all(high > bottom)) for bottom, top in self._boxes)
        (left, right), (bottom, top) = self._ax.get_xlim(), self._ax.get_ylim()
        out = low[0] < left or high[0] > right or low[1] < bottom or high[1] > top
        return float(inside + 10 * over + 100 * out)
