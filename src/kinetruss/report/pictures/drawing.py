"""Line drawings of a structure for print: their view, and names where they cover as little as possible."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colorbar import ColorbarBase
from matplotlib.colors import LinearSegmentedColormap, Normalize, to_rgb
from matplotlib.figure import Figure as Canvas

from kinetruss.display import DIVERGING, DRIVEN, ELASTIC, KINDS, LOAD, MISSING, OVER, SEQUENTIAL, number, quantity, scale
from kinetruss.report.pictures.specs import INK, PRINT, QUIET, RC, WIDTHS, Colouring, Drawing, Stand

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


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
    return (_around(at + way * (half + GAP), half) for way in AROUND)


def _along(p: Array, q: Array, name: str, size: float) -> Iterator[Array]:
    half, along = _half(name, size), q - p
    normal = np.array([-along[1], along[0]]) / (np.hypot(*along) or 1.0)
    apart = float(np.abs(normal) @ half) + GAP
    return (_around(p + part * along + side * apart * normal, half) for part in ALONG for side in (1, -1))


def _half(name: str, size: float) -> Array:
    return np.array([WIDE * size * len(name), HIGH * size]) / 2


def _around(middle: Array, half: Array) -> Array:
    return np.stack([middle - half, middle + half])


def _meet(one: Array, other: Array) -> bool:
    return bool((one[0] < other[1]).all() and (other[0] < one[1]).all())


def names_of(count: int, most: int, asked: bool | None, names: Iterable[str]) -> tuple[str, ...]:
    """The names, if they are asked for, or by default if there are not too many."""
    return tuple(names) if (count <= most if asked is None else asked) else ()


# Line drawings of a structure for print.

INCH = 25.4
GHOST, WAY, FACE = "#a8b0b9", "#444444", "#c9d4de"
TALLEST = 1.4
"""Largest ratio of height to width of a figure, or of a page, so that it fits on the sheet (A4: 1.414)."""
NOTE = 0.14
"""Height of the line under the scale, inches."""
PENS: dict[str, dict[str, Any]] = {
    "rigid": {"colors": INK, "linewidths": 1.0},
    "driven": {"colors": DRIVEN, "linewidths": 2.2},
    "active": {"colors": DRIVEN, "linewidths": 2.2},
    "elastic": {"colors": ELASTIC, "linewidths": 1.4},
    "beam": {"colors": ELASTIC, "linewidths": 2.0, "capstyle": "round"},
    "cable": {"colors": KINDS["cable"], "linewidths": 0.9, "linestyles": (0, (4, 1.5))},
    "free": {"colors": QUIET, "linewidths": 0.7, "linestyles": (0, (1, 1.5))},
}
"""Styles of members without a value, by kind."""


def drawn(figure: Drawing) -> Canvas:
    """A matplotlib figure, `width` mm wide and as high as needed."""
    with mpl.rc_context(RC | PRINT):
        low, high = _box(figure)
        size = np.maximum(high - low, 0.05 * float(np.max(high - low)))
        width, count = figure.width / INCH, len(figure.stands)
        cell = (width - 0.1) / count
        high_cell = min(cell * float(size[1] / size[0]), 1.5 * max(cell, 2.0))
        above = 0.06 + 0.2 * bool(figure.title) + 0.18 * any(one.caption for one in figure.stands)
        # The line under the scale: what grey, red and broken members are.
        missing = "" if figure.colouring is None else figure.colouring.missing
        note = "; ".join(filter(None, [missing, "broken: not unique" if figure.unsure else ""]))
        below = 0.24 + 0.44 * (figure.colouring is not None) + NOTE * bool(note)
        high_cell = min(high_cell, TALLEST * max(width, WIDTHS["page"] / INCH) - above - below)
        height = above + high_cell + below
        canvas = Canvas(figsize=(width, height))
        FigureCanvasAgg(canvas)
        for k, one in enumerate(figure.stands):
            ax = canvas.add_axes(((0.05 + k * cell) / width, below / height, cell / width, high_cell / height))
            ax.set_xlim(low[0], low[0] + size[0])
            ax.set_ylim(low[1], low[1] + size[1])
            ax.set_aspect("equal")
            ax.set_axis_off()
            _stand(ax, figure, one)
            canvas.text((0.08 + k * cell) / width, (below + high_cell + 0.05) / height, one.caption, va="bottom")
        if figure.title:
            canvas.text(0.08 / width, 1 - 0.05 / height, figure.title, va="top", fontweight="bold")
        _scale_bar(canvas, canvas.axes[0], float(size[0]), height)
        if figure.colouring is not None:
            _legend(canvas, figure.colouring, width, height, NOTE * bool(note))
            canvas.text(1 - 0.08 / width, 0.04 / height, note, ha="right", va="bottom", fontsize=6.5, color=QUIET)
        return canvas


def _box(figure: Drawing) -> tuple[Any, Any]:
    shown = [one.points for one in figure.stands] + [np.array(pair) for one in figure.stands for pair in one.loads]
    shown += [one.bodies.reshape(-1, 2) for one in figure.stands if one.bodies.size] + list(figure.ways)
    if figure.ghost is not None:
        shown.append(figure.ghost)
    shown += [points for one in figure.stands for points in one.curves.values()]
    points = np.concatenate(shown)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = (0.09 if figure.names else 0.06) * (float(np.max(high - low)) or 1.0)  # of a single point, 1 m
    return low - margin, high + margin


def _stand(ax: Any, figure: Drawing, one: Stand) -> None:
    if figure.ghost is not None:
        ax.add_collection(LineCollection([figure.ghost[list(ends)] for ends in figure.ends], colors=GHOST, linewidths=0.5))
    for way in figure.ways:
        ax.plot(*way.T, color=WAY, linewidth=0.7, linestyle=(0, (4, 1.5)))
    if one.bodies.size:
        ax.add_collection(PolyCollection(list(one.bodies), facecolors="#dde3ea", edgecolors="none"))
    if len(one.faces):
        _faces(ax, figure, one)
    lines = one.lines(figure.ends)
    if figure.colouring is None or one.values is None:
        for kind, pen in PENS.items():
            chosen = [line for line, own in zip(lines, figure.kinds, strict=True) if own == kind]
            ax.add_collection(LineCollection(chosen, **pen))
    else:
        # a dark rim keeps pale colours visible on white paper
        thick = _thickness(ax, figure, one)
        ax.add_collection(LineCollection(lines, colors=INK, linewidths=1.3 * thick, capstyle="round"))
        colours = LineCollection(
            lines,
            cmap=_map(figure.colouring),
            norm=Normalize(*figure.colouring.limits),
            linewidths=thick,
            capstyle="round",
        )
        colours.set_array(np.ma.masked_invalid(one.values))
        ax.add_collection(colours)
        # with white gaps: a force that is not unique, or what was not checked
        broken = sorted({*figure.unsure, *np.flatnonzero(np.isnan(one.values)).tolist()})
        ax.add_collection(
            LineCollection([lines[k] for k in broken], colors="white", linewidths=1.4 * thick, linestyles=(0, (0.6, 2.4)))
        )
    mesh = len(one.faces) > 0
    ax.plot(
        *one.points[list(figure.joined) if mesh else slice(None)].T,
        "o",
        color=INK,
        markersize=1.1 * _thickness(ax, figure, one),
    )
    ax.plot(*one.hinges.T, "o", color=DRIVEN, markersize=7, markerfacecolor="none", markeredgewidth=1.4)
    for nodes, marker in ((figure.held, "^"), (figure.guided, "o")):
        ax.plot(*one.points[list(nodes)].T, marker, color=INK, markersize=5, markerfacecolor="white", markeredgewidth=0.8)
    for start, end in one.loads:
        pen = {"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.0, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", end, start, arrowprops=pen)
    write_names(ax, one.points, figure.nodes if figure.names else (), figure.ends, figure.members, one.loads)


def _thickness(ax: Any, figure: Drawing, one: Stand) -> float:
    """Width of coloured lines, points: thinner where members are short on paper, or they would run together."""
    if not figure.ends:
        return 2.0
    ax.apply_aspect()
    lines = one.points[np.array(figure.ends)].reshape(-1, 2)
    ends = ax.transData.transform(lines).reshape(-1, 2, 2) * 72 / ax.figure.dpi
    usual = float(np.median(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)))
    return float(np.clip(usual / 12, 0.5, 2.0))


def _faces(ax: Any, figure: Drawing, one: Stand) -> None:
    """Membranes and solids, shaded; coloured by stress if that is the colour quantity."""
    colours = np.tile(np.array(to_rgb(FACE)), (len(one.faces), 1))
    if figure.colouring is not None and one.face_values is not None:
        colours = _map(figure.colouring)(Normalize(*figure.colouring.limits)(one.face_values))[:, :3]
    shades = colours * (0.7 + 0.3 * one.light[:, None])
    ax.add_collection(PolyCollection(list(one.faces), facecolors=shades, edgecolors="#2b333b40", linewidths=0.3))


def _map(colouring: Colouring) -> Any:
    found = LinearSegmentedColormap.from_list("kinetruss", DIVERGING if colouring.diverging else SEQUENTIAL)
    return found.with_extremes(bad=MISSING, over=OVER)


def _scale_bar(canvas: Canvas, ax: Any, size: float, height: float) -> None:
    """The scale bar under the first pose."""
    aim = size / 4
    power = 10 ** np.floor(np.log10(aim))
    length = power * max(step for step in (1, 2, 5) if step * power <= aim * (1 + 1e-9))
    box = ax.get_position()
    left, level = box.x0 + 0.01, box.y0 - 0.12 / height
    # the axes keep the shape of what they show, so that they may be narrower than their cell
    shown = min(box.width, box.height * height / canvas.get_figwidth() * size / float(np.diff(ax.get_ylim())[0]))
    right = left + length / size * shown
    canvas.add_artist(mpl.lines.Line2D([left, right], [level, level], color=QUIET, linewidth=1.2, solid_capstyle="butt"))
    words = quantity(float(length), "m")
    canvas.text(right + 0.05 / canvas.get_figwidth(), level, words, va="center", fontsize=7, color=QUIET)


def _legend(canvas: Canvas, colouring: Colouring, width: float, height: float, above: float) -> None:
    long = min(0.5 * width, 2.4)
    left = width - long - 0.75
    ax = canvas.add_axes((left / width, (0.28 + above) / height, long / width, 0.09 / height))
    factor, unit = scale(max(map(abs, colouring.limits)), colouring.unit)
    low, high = (factor * one for one in colouring.limits)
    bar = ColorbarBase(ax, cmap=_map(colouring), norm=Normalize(low, high), orientation="horizontal")
    bar.outline.set_visible(False)
    for steps in ax.collections:
        steps.set(rasterized=False, edgecolor="face")  # no pixels in a vector drawing
    numbers = [low + part * (high - low) for part in (0, 0.25, 0.5, 0.75, 1)]
    bar.set_ticks(numbers, labels=[number(one, 3) for one in numbers])
    words = f"{colouring.label} ({unit})" if unit else colouring.label
    ax.set_title(words, fontsize=8, fontweight="normal", loc="center", pad=3)
    for side, end in zip(("right", "left"), colouring.words, strict=True):
        ax.annotate(
            end,
            (side == "left", 0.5),
            xytext=(5 if side == "left" else -5, 0),
            xycoords="axes fraction",
            textcoords="offset points",
            ha=side,
            va="center",
            fontsize=7,
            color=QUIET,
        )
