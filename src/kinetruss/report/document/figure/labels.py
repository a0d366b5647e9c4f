"""Places labels beside points, away from lines and from each other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.font_manager import FontProperties
from matplotlib.patheffects import withStroke
from matplotlib.textpath import TextPath

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["CROWDED", "Labels"]

SIZE = 7.0
"""Size of the letters, points."""
HIGH = 1.25
"""Height of a line, of its letters."""
AWAY = (0.05, 0.13, 0.26, 0.42)
"""Distances between a point and its label that are tried, inches."""
NEAR = 2
"""How many of them are tried for a label that may be left out: far from its point nobody knows what it names."""
ASIDE = 0.3
"""Component of a direction from which on a label stands wholly on that side of its point."""
SPACING = 0.08
"""Distance of the points by which lines are covered, inches."""
MARK = 0.16
"""Size of the mark of a support, inches."""
CROWDED = 3.0
"""What a label that may be left out covers at most."""


def _along(line: Array, spacing: float) -> Array:
    """Points on a line (g, 2), about a spacing apart."""
    pieces = []
    for start, end in pairwise(line):
        share = np.linspace(0, 1, 2 + int(np.linalg.norm(end - start) / spacing))[:, None]
        pieces.append(start + share * (end - start))
    return np.concatenate(pieces)


def _width(words: str, bold: bool) -> float:
    """Width of a text on paper, inches."""
    style = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")
    return float(TextPath((0, 0), words, size=SIZE, prop=style).get_extents().width) / 72 + 0.02


class Labels:
    """Labels of one drawing. scale : m an inch; lines : points (g, 2), m, and marks : points (k, 2), m,
    that labels avoid.
    """

    def __init__(self, ax: Any, scale: float, lines: Sequence[Array], marks: Array) -> None:
        self._ax, self._scale = ax, scale
        points = [_along(line, SPACING * scale) for line in lines]
        self._ink = np.concatenate(points) if points else np.zeros((0, 2))
        half = MARK / 2 * scale
        self._boxes: list[tuple[Array, Array]] = [(mark - half, mark + half) for mark in marks]

    def put(self, words: str, at: Array, colour: str, *, bold: bool = False, most: float = np.inf) -> None:
        """Write a label near a point, where it covers least; not at all if it covers more than `most`."""
        size = np.array([_width(words, bold), SIZE / 72 * HIGH])
        extent = size * self._scale
        choices = []
        for far in AWAY if np.isinf(most) else AWAY[:NEAR]:
            for angle in np.radians([35, 145, -35, -145, 0, 180, 90, -90]):
                way = np.array([np.cos(angle), np.sin(angle)])
                side = np.where(np.abs(way) > ASIDE, np.sign(way), 0.0)
                middle = at + way * (far * self._scale) + side * extent / 2
                choices.append((self._covered(middle - extent / 2, middle + extent / 2) + 0.4 * AWAY.index(far), middle))
        cost, middle = min(choices, key=lambda one: one[0])
        if cost > most:
            return
        self._boxes.append((middle - extent / 2, middle + extent / 2))
        weight = "bold" if bold else "normal"
        text = self._ax.text(*middle, words, fontsize=SIZE, color=colour, ha="center", va="center", fontweight=weight)
        text.set_path_effects([withStroke(linewidth=2.2, foreground="white")])

    def _covered(self, low: Array, high: Array) -> float:
        """How much a box covers: other labels count ten times a piece of line; outside of the drawing it counts most."""
        inside = np.all((self._ink > low) & (self._ink < high), axis=1).sum()
        over = sum(bool(np.all(low < top) and np.all(high > bottom)) for bottom, top in self._boxes)
        (left, right), (bottom, top) = self._ax.get_xlim(), self._ax.get_ylim()
        out = low[0] < left or high[0] > right or low[1] < bottom or high[1] > top
        return float(inside + 10 * over + 100 * out)
