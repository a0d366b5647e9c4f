"""Draws the structure of a report: members, supports, drives, loads with values, names beside points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure as Canvas
from matplotlib.font_manager import FontProperties
from matplotlib.patheffects import withStroke
from matplotlib.textpath import TextPath

from kinetruss.display import DRIVEN, LOAD, quantity
from kinetruss.mechanics.continua import skin_of
from kinetruss.model import HingeDrive
from kinetruss.model.beam_frames import FRAME, shown_kinds, shown_names
from kinetruss.report.pictures.drawing import projected
from kinetruss.report.pictures.picture import curves_of
from kinetruss.report.pictures.specs import ALARM, INK, PRINT, QUIET, RC

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.report.document.figure_contents import Loaded

    Array = NDArray[np.float64]


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


# Draws the structure of a report: members, supports, drives, loads with values, names, axes and scale.

FACE = "#dde3ea"
HALO = "#f3d9a4"
"""Band about the governing member: the colour of what is picked in the viewer, on paper."""
WIDTH, TALLEST = 6.9, 4.9
"""Width and largest height of the figure, inches: it takes at most half of a sheet."""
NAMED = 40
"""Number of nodes up to which their names are shown; above it those of supports and loads only."""
FEW = 12
"""Number of supports up to which all of them are named."""
BESIDE = 0.95
"""Cosine of the angle between an arrow and a member from which on they cover each other."""
ARROW = 0.13
"""Length of the largest arrow, of the size of the structure."""


def drawn(figure: Loaded, tallest: float = TALLEST) -> Canvas:
    """A matplotlib figure, at most so high, inches."""
    points = projected(figure.position)
    arrows, axes = _arrows(figure), lines_of_members(figure, points)
    ends = [np.array([start, end]) for start, end, _ in arrows]
    shown = np.concatenate([points[seen(figure.model)], *axes.values(), *ends])
    low, high = shown.min(axis=0), shown.max(axis=0)
    reach = float(np.max(high - low)) or 1.0
    low, high = low - 0.07 * reach, high + 0.07 * reach
    size = np.maximum(high - low, 0.25 * reach)
    # room at the left for axes, gravity and scale
    aside = 1.0
    width = WIDTH - aside
    height = min(tallest, width * float(size[1] / size[0]))
    with mpl.rc_context(RC | PRINT):
        canvas = Canvas(figsize=(WIDTH, height))
        FigureCanvasAgg(canvas)
        ax = canvas.add_axes((aside / WIDTH, 0, width / WIDTH, 1))
        middle = (low + high) / 2
        scale = max(size[0] / width, size[1] / height)  # m an inch
        ax.set_xlim(middle[0] - scale * width / 2, middle[0] + scale * width / 2)
        ax.set_ylim(middle[1] - scale * height / 2, middle[1] + scale * height / 2)
        ax.set_axis_off()
        _members(ax, figure, points, axes)
        draw_supports(ax, figure.model, points)
        held = [k for k in seen(figure.model) if list(figure.model.nodes)[k] in figure.model.fixed]
        labels = Labels(ax, scale, [*axes.values(), *ends], points[held])
        _governing(ax, figure, axes, labels)
        for start, end, words in arrows:
            pen = {"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.1, "shrinkA": 0, "shrinkB": 0}
            ax.annotate("", tuple(end), tuple(start), arrowprops=pen)
            if words:
                labels.put(words, (start + end) / 2, LOAD)
        _drives(figure, axes, labels)
        _names(figure, points, labels)
        _aside(canvas, figure, scale, height)
    return canvas


def _ends(figure: Loaded) -> dict[str, tuple[int, int]]:
    """Members and beams with the indices of their ends; the frames of beams are left out."""
    model, names = figure.model, shown_names(figure.model)
    index = {name: k for k, name in enumerate(model.nodes)}
    shown = {names[name]: model.members[name].ends for name, kind in shown_kinds(model).items() if kind != FRAME}
    return {name: (index[a], index[b]) for name, (a, b) in shown.items()}


def lines_of_members(figure: Loaded, points: Array) -> dict[str, Array]:
    """Members and beams with their points (g, 2) on paper: elastic beams along their bent axes."""
    curves = curves_of(figure.model, figure.position)
    return {
        name: projected(curves[k]) if k in curves else points[list(pair)]
        for k, (name, pair) in enumerate(_ends(figure).items())
    }


def seen(model: Model) -> list[int]:
    """Indices of all nodes but those of the frames of beams."""
    return [k for k, node in enumerate(model.nodes.values()) if not node.director]


def _middle(line: Array) -> Array:
    """The point halfway along a line (g, 2)."""
    run = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    return np.array([np.interp(run[-1] / 2, run, line[:, k]) for k in range(2)])


def _members(ax: Any, figure: Loaded, points: Array, lines: Mapping[str, Array]) -> None:
    model = figure.model
    skin = skin_of(model)
    if len(skin.nodes):
        faces = points[skin.nodes]
        ax.add_collection(PolyCollection(list(faces), facecolors=FACE, edgecolors="#8a8a8a60", linewidths=0.3))
    driven = [line for name, line in lines.items() if name in _driven(model)]
    ax.add_collection(LineCollection(list(lines.values()), colors=INK, linewidths=1.0, capstyle="round"))
    ax.add_collection(LineCollection(driven, colors=DRIVEN, linewidths=2.4, capstyle="round"))
    used = sorted({k for pair in _ends(figure).values() for k in pair})
    ax.plot(*points[used].T, "o", color=INK, markersize=2.4)
    index = {name: k for k, name in enumerate(model.nodes)}
    hinged = [drive.axis for drive in model.all_drives.values() if isinstance(drive, HingeDrive)]
    for axis in hinged:
        place = points[[index[node] for node in axis]].mean(axis=0)
        ax.plot(*place, "o", color=DRIVEN, markersize=7, markerfacecolor="none", markeredgewidth=1.4)


def _driven(model: Model) -> set[str]:
    """Bars and active members that a drive moves."""
    return {*model.active, *(getattr(drive, "bar", "") for drive in model.all_drives.values())}


def draw_supports(ax: Any, model: Model, points: Array) -> None:
    """Squares clamped, triangles held, circles guided."""
    names = list(model.nodes)
    for k in seen(model):
        axes = model.fixed.get(names[k], "")
        clamped = model.clamped.get(names[k]) == "ground"
        if axes or clamped:
            marker = "s" if clamped else "^" if len(axes) == model.dim else "o"
            ax.plot(*points[k], marker, color=INK, markersize=8, markerfacecolor="white", markeredgewidth=1.0)


def _governing(ax: Any, figure: Loaded, lines: Mapping[str, Array], labels: Labels) -> None:
    """The governing member: red only if it is over its capacity, else in its own colour on a broad band."""
    if figure.governing is None:
        return
    model, (name, words) = figure.model, figure.governing
    bar = getattr(model.all_drives.get(name), "bar", name)
    if bar not in lines:
        return
    line = lines[bar]
    if figure.over:
        ax.add_collection(LineCollection([line], colors=ALARM, linewidths=3.2, capstyle="round"))
    else:
        ax.add_collection(LineCollection([line], colors=HALO, linewidths=9.0, capstyle="round", zorder=0.5))
        if bar not in _driven(model):
            ax.add_collection(LineCollection([line], colors=INK, linewidths=2.4, capstyle="round"))
    labels.put(words, _middle(line), ALARM if figure.over else INK, bold=True)


def _arrows(figure: Loaded) -> list[tuple[Array, Array, str]]:
    """Start and end on paper of each force, and the value of the largest `NAMED`: it ends away from its node, or at it where it
    would else lie on a member.
    """
    if not figure.loads:
        return []
    size = float(np.linalg.norm(np.ptp(figure.position, axis=0)))
    largest = max(float(np.linalg.norm(force)) for _, force in figure.loads)
    found = []
    least = sorted((float(np.linalg.norm(force)) for _, force in figure.loads), reverse=True)[:NAMED][-1]
    for node, force in figure.loads:
        way = force * (ARROW * size / largest)
        start = figure.position[node] - (way if _along_member(figure, node, way) else 0.0)
        end = start + way
        size_of = float(np.linalg.norm(force))
        words = quantity(size_of, "N") if size_of >= least else ""
        found.append((projected(start[None])[0], projected(end[None])[0], words))
    return found


def _along_member(figure: Loaded, node: int, way: Array) -> bool:
    """True if a member leaves a node in a direction on paper, and none in the opposite one."""
    points = projected(np.vstack([figure.position, figure.position[node] + way]))
    sides = [points[b if a == node else a] - points[node] for a, b in _ends(figure).values() if node in (a, b)]
    pointed = points[-1] - points[node]
    size = np.linalg.norm(pointed) or 1.0
    cosines = [float(one @ pointed) / (float(np.linalg.norm(one)) or 1.0) / size for one in sides]
    return any(one > BESIDE for one in cosines) and not any(one < -BESIDE for one in cosines)


def _drives(figure: Loaded, lines: Mapping[str, Array], labels: Labels) -> None:
    """Names of driven members at their middle."""
    model = figure.model
    chief = figure.governing[0] if figure.governing else ""
    shown = 0
    for name, drive in model.all_drives.items():
        bar = getattr(drive, "bar", "")
        if bar in lines and chief not in (name, bar) and shown < NAMED // 2:
            shown += 1
            labels.put(name, _middle(lines[bar]), DRIVEN, most=CROWDED)


def _names(figure: Loaded, points: Array, labels: Labels) -> None:
    model = figure.model
    loaded = {node for node, _ in figure.loads}
    used, held = {k for pair in _ends(figure).values() for k in pair}, model.fixed
    for k, node in enumerate(model.nodes):
        important = (node in model.fixed and len(model.fixed) <= NAMED) or (k in loaded and len(loaded) <= NAMED)
        always = (node in held and len(held) < FEW) or (k in loaded and len(loaded) < FEW)
        if (k in used or k in loaded) and (len(used) <= NAMED or important):
            labels.put(node, points[k], QUIET, most=np.inf if always else CROWDED)


def _aside(canvas: Canvas, figure: Loaded, scale: float, height: float) -> None:
    """Axes, direction of gravity and scale, at the left."""
    ax = canvas.add_axes((0, 0, 1.0 / WIDTH, 1))
    ax.set_xlim(0, 1.0)
    ax.set_ylim(0, height)
    ax.set_axis_off()
    dim = figure.model.dim
    axes = projected(np.eye(dim)) * 0.34
    origin = np.array([0.42, 0.85])
    for name, end in zip("xyz", axes, strict=False):
        pen = {"arrowstyle": "-|>", "color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
        ax.annotate("", tuple(origin + end), tuple(origin), arrowprops=pen)
        ax.text(
            float((origin + 1.3 * end)[0]),
            float((origin + 1.3 * end)[1]),
            name,
            fontsize=7,
            ha="center",
            va="center",
            color=INK,
        )
    if figure.model.gravity and any(figure.model.gravity) and height > 1.8:
        down = np.asarray(figure.model.gravity, float)
        arrow = projected(down[None] / np.linalg.norm(down))[0] * 0.36
        start = np.array([0.42, 1.72])
        pen = {"arrowstyle": "-|>", "color": QUIET, "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 9}
        ax.annotate("", tuple(start + arrow), tuple(start), arrowprops=pen)
        ax.text(0.56, 1.62, "g", fontsize=8, color=QUIET, va="center")
    length = round_length(0.85 * scale)
    ax.plot([0.05, 0.05 + length / scale], [0.16, 0.16], color=QUIET, linewidth=2, solid_capstyle="butt")
    ax.text(0.05, 0.22, quantity(length, "m"), fontsize=7, color=QUIET, va="bottom")


def round_length(most: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is at most `most`."""
    power = 10 ** np.floor(np.log10(most))
    return float(power * max(step for step in (1, 2, 5) if step * power <= most * (1 + 1e-9)))
