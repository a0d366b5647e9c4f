"""On paper: the view of all pictures, and names where they cover no other name and as few lines as possible."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.report.pictures.style import INK, QUIET

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["MEMBERS", "VIEWS", "eye", "names_of", "projected", "write_names"]

VIEWS = {"iso": (-62.0, 16.0), "front": (-90.0, 0.0), "side": (0.0, 0.0), "top": (-90.0, 90.0)}
"""Azimuth and elevation of the views, degrees."""

MEMBERS = 40
"""Number of members up to which their names are shown by default."""

WIDE, HIGH, GAP, STEP = 0.62, 1.25, 2.0, 4.0
"""Width of a character and height of a line over the font size; distances of a name from its place, of points on lines, pt."""

SIZE, MARK = 7.0, 2.5
"""Font size, and radius of the marks of nodes, points."""

AROUND = np.array([(1, 1), (1, -1), (-1, 1), (-1, -1), (0, 1), (0, -1), (1, 0), (-1, 0)], float)
ALONG = (0.5, 0.4, 0.6, 0.3, 0.7)


def eye(view: str) -> NDArray[np.float64]:
    """Unit vector (3,) from the structure to the eye."""
    azimuth, elevation = np.radians(VIEWS[view])
    return np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])


def projected(points: NDArray[np.float64], view: str = "iso") -> NDArray[np.float64]:
    """Points (.., 2) or (.., 3), m, on paper (.., 2): the plane as it is, space in parallel projection with z upright."""
    if points.shape[-1] == 2:
        return points
    toward = eye(view)
    right = np.array([-np.sin(np.radians(VIEWS[view][0])), np.cos(np.radians(VIEWS[view][0])), 0.0])
    seen: NDArray[np.float64] = points @ np.column_stack([right, np.cross(toward, right)])
    return seen


def write_names(
    ax: Any,
    points: Array,
    nodes: Sequence[str],
    ends: Sequence[tuple[int, int]],
    members: Sequence[str],
    loads: Sequence[tuple[Array, Array]] = (),
) -> None:
    """Write names of nodes beside points (n, 2), and names of members beside their lines where nothing crosses them.

    A name that finds no free place is omitted. Behind each is a white ground, so that it can be read across a line.
    """
    ax.apply_aspect()
    inch = 72 / ax.figure.dpi
    seen = ax.transData.transform(points) * inch
    arrows = [ax.transData.transform(np.array(pair)) * inch for pair in loads]
    segments = [*((seen[a], seen[b]) for a, b in ends), *((pair[0], pair[1]) for pair in arrows)]
    marks = (seen[:, None] + MARK * AROUND).reshape(-1, 2)
    sheet = _Sheet(ax, np.concatenate([marks, *(_between(p, q) for p, q in segments)]))
    for k, name in enumerate(nodes):
        sheet.put(name, _besides(seen[k], name, SIZE), INK)
    for (a, b), name in zip(ends, members, strict=False):
        sheet.put(name, _along(seen[a], seen[b], name, SIZE), QUIET, free=True)


class _Sheet:
    """Axes with lines, as points (k, 2) on paper, and the places that names have taken."""

    def __init__(self, ax: Any, lines: Array) -> None:
        self.ax, self.lines, self.inch = ax, lines, 72 / ax.figure.dpi
        self.taken: list[Array] = []
        self.corners = np.array(ax.get_window_extent().get_points()) * self.inch

    def put(self, name: str, places: Iterable[Array], colour: str, *, free: bool = False) -> None:
        """Write a name at the place that covers the fewest lines. free : only where it covers none."""
        found = [box for box in _within(self.corners, places) if not any(_meet(box, one) for one in self.taken)]
        covered = [int(((self.lines >= box[0]) & (self.lines <= box[1])).all(axis=1).sum()) for box in found]
        if not found or (free and min(covered)):
            return
        box = found[int(np.argmin(covered))]
        self.taken.append(box)
        ground = {"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.7}
        at = self.ax.transData.inverted().transform(box.mean(axis=0) / self.inch)
        self.ax.text(*at, name, fontsize=SIZE, color=colour, ha="center", va="center", bbox=ground)


def _within(sheet: Array, boxes: Iterable[Array]) -> list[Array]:
    """The boxes that lie on the sheet, or all if none does."""
    found = list(boxes)
    return [box for box in found if (box[0] >= sheet[0]).all() and (box[1] <= sheet[1]).all()] or found


def _between(p: Array, q: Array) -> Array:
    """Points on a line."""
    count = max(2, int(np.hypot(*(q - p)) / STEP))
    found: Array = p + np.linspace(0, 1, count)[:, None] * (q - p)
    return found


def _besides(at: Array, name: str, size: float) -> Iterator[Array]:
    half = _half(name, size)
    return (_box(at + way * (half + GAP), half) for way in AROUND)


def _along(p: Array, q: Array, name: str, size: float) -> Iterator[Array]:
    half, along = _half(name, size), q - p
    normal = np.array([-along[1], along[0]]) / (np.hypot(*along) or 1.0)
    apart = float(np.abs(normal) @ half) + GAP
    return (_box(p + part * along + side * apart * normal, half) for part in ALONG for side in (1, -1))


def _half(name: str, size: float) -> Array:
    return np.array([WIDE * size * len(name), HIGH * size]) / 2


def _box(middle: Array, half: Array) -> Array:
    return np.stack([middle - half, middle + half])


def _meet(one: Array, other: Array) -> bool:
    return bool((one[0] < other[1]).all() and (other[0] < one[1]).all())


def names_of(count: int, most: int, asked: bool | None, names: Iterable[str]) -> tuple[str, ...]:
    """The names, if they are asked for, or by default if there are not too many."""
    return tuple(names) if (count <= most if asked is None else asked) else ()
