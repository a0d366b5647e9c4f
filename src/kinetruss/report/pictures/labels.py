"""Names and values beside points and lines of a drawing, where they cover as little as possible."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


SIZE, HIGH = 7.0, 1.25
"""Size of the letters, points, and height of a line, of its letters."""
AWAY, NEAR = (3.6, 9.4, 18.7, 30.2), 2
"""Distances between a point and its label that are tried, points of paper; how many of them for a label that may be left out:
far from its point nobody knows what it names."""
AROUND = np.radians([35, 145, -35, -145, 0, 180, 90, -90])
ASIDE = 0.3
"""Component of a direction from which on a label stands wholly on that side of its point."""
ALONG = (0.5, 0.4, 0.6, 0.3, 0.7)
"""Places along a line beside which its name is tried."""
SPACING, MARK = 5.8, 11.5
"""Distance of the points by which lines are covered, and size of the mark of a support, points of paper."""
GROUND = {"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.7}
FREE, CROWDED, APART = 0.0, 3.0, 9.5
"""What a label covers at most that may be left out: nothing; a few pieces of lines; any line, but no other label."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Label:
    """Words beside a place on paper: a point (2,), m, or a line (g, 2), m. It is left out where it covers more than `most`."""

    words: str
    at: Array
    colour: str
    bold: bool = False
    most: float = np.inf


def put(ax: Any, labels: Iterable[Label], lines: Sequence[Array], marks: Array) -> None:
    """Write labels in their order on axes, away from lines (g, 2) and marks (k, 2), m, and from each other."""
    ax.apply_aspect()
    scale = 72 / ax.figure.dpi

    def on_paper(points: Array) -> Array:
        found: Array = ax.transData.transform(points) * scale
        return found

    drawn = [_pieces(on_paper(line)) for line in lines]
    ink = np.concatenate(drawn) if drawn else np.zeros((0, 2))
    sheet = np.array(ax.get_window_extent().get_points()) * scale
    boxes = [(mark - MARK / 2, mark + MARK / 2) for mark in (on_paper(marks) if len(marks) else ())]
    for one in labels:
        extent = np.array([_width(one.words, one.bold), SIZE * HIGH])
        at = on_paper(one.at)
        places = _beside(at, extent) if at.ndim == 2 else _about(at, extent, AWAY if np.isinf(one.most) else AWAY[:NEAR])
        choices = [(_covered(middle, extent, ink, boxes, sheet) + more, middle) for more, middle in places]
        cost, middle = min(choices, key=lambda choice: choice[0])
        if cost > one.most + FAR:
            continue
        boxes.append((middle - extent / 2, middle + extent / 2))
        place = ax.transData.inverted().transform(middle / scale)
        weight = "bold" if one.bold else "normal"
        # a ground instead of a rim about the letters, with which they would not stay text in SVG and PDF
        pen = {"fontsize": SIZE, "color": one.colour, "ha": "center", "va": "center", "fontweight": weight, "bbox": GROUND}
        ax.text(*place, one.words, **pen)


FAR = 0.4
"""What a step away from a point counts, in pieces of a line that are covered."""


def _about(at: Array, extent: Array, away: Sequence[float]) -> Iterable[tuple[float, Array]]:
    """Middles of a label about a point, with what their distance counts."""
    for step, far in enumerate(away):
        for angle in AROUND:
            way = np.array([np.cos(angle), np.sin(angle)])
            side = np.where(np.abs(way) > ASIDE, np.sign(way), 0.0)
            yield FAR * step, at + way * far + side * extent / 2


def _beside(line: Array, extent: Array) -> Iterable[tuple[float, Array]]:
    """Middles of a label beside a line (g, 2)."""
    for part in ALONG:
        at, along = point_of(line, part), line[-1] - line[0]
        normal = np.array([-along[1], along[0]]) / (np.hypot(*along) or 1.0)
        apart = float(np.abs(normal) @ extent) / 2 + 2.0
        for side in (1, -1):
            yield 0.0, at + side * apart * normal


def _covered(middle: Array, extent: Array, ink: Array, boxes: Sequence[tuple[Array, Array]], sheet: Array) -> float:
    """How much a box covers: other labels count ten times a piece of line; outside of the drawing it counts most."""
    low, high = middle - extent / 2, middle + extent / 2
    inside = np.all((ink > low) & (ink < high), axis=1).sum()
    over = sum(bool(np.all(low < top) and np.all(high > bottom)) for bottom, top in boxes)
    return float(inside + 10 * over + 100 * bool(np.any(low < sheet[0]) or np.any(high > sheet[1])))


def _pieces(line: Array) -> Array:
    """Points on a line (g, 2), about `SPACING` apart."""
    found = []
    for start, end in pairwise(line):
        share = np.linspace(0, 1, 2 + int(np.linalg.norm(end - start) / SPACING))[:, None]
        found.append(start + share * (end - start))
    return np.concatenate(found)


def _width(words: str, bold: bool) -> float:
    """Width of a text, points of paper."""
    style = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")
    return float(TextPath((0, 0), words, size=SIZE, prop=style).get_extents().width) + 1.4


def point_of(line: Array, part: float = 0.5) -> Array:
    """The point at a part of the length of a line (g, dim)."""
    run = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    return np.array([np.interp(part * run[-1], run, line[:, k]) for k in range(line.shape[1])])
