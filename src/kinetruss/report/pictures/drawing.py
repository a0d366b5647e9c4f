"""Line drawings of a structure: lines, faces, marks, arrows and names, a scale and the colours."""

from __future__ import annotations

from textwrap import wrap
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colorbar import ColorbarBase
from matplotlib.colors import LinearSegmentedColormap, Normalize, to_rgb
from matplotlib.figure import Figure as Canvas
from matplotlib.path import Path

from kinetruss.display import DIVERGING, DRIVEN, ELASTIC, KINDS, LOAD, MISSING, OVER, SEQUENTIAL, number, quantity, scale
from kinetruss.display.symbols import SUPPORTS
from kinetruss.report.pictures.labels import put
from kinetruss.report.pictures.specs import ALARM, INK, PRINT, QUIET, RC, WIDTHS, Area, Colouring, Drawing, Stand

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


INCH = 25.4
GHOST, WAY, FACE, BODY = "#a8b0b9", "#444444", "#c9d4de", "#dde3ea"
BAND = "#f3d9a4"
"""Band about the governing member: the colour of what is picked in the viewer, on paper."""
AREA = BODY
TALLEST = 1.4
"""Largest ratio of height to width of a figure, or of a page, so that it fits on the sheet (A4: 1.414)."""
NOTE, ASIDE, LETTER, SMALLER = 0.14, 0.7, 0.075, 0.055
"""Height of a line under the scale, width of the axes at the left, and of a letter of the title and of a note, inches."""
TENSION, COMPRESSION = DIVERGING[4], DIVERGING[2]
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
SYMBOL = 9.0
"""Size of the symbols of supports, points."""


def drawn(figure: Drawing) -> Canvas:
    """A matplotlib figure, `width` mm wide and as high as needed."""
    with mpl.rc_context(RC | PRINT):
        low, high = _box(figure)
        size = np.maximum(high - low, 0.05 * float(np.max(high - low)))
        width, count = figure.width / INCH, len(figure.stands)
        aside = ASIDE * (figure.axes is not None)
        cell = (width - 0.1 - aside) / count
        high_cell = min(cell * float(size[1] / size[0]), 1.5 * max(cell, 2.0), figure.tallest)
        title = wrap(figure.title, int(width / LETTER))
        above = 0.06 + 0.06 * bool(title) + 0.14 * len(title) + 0.18 * any(one.caption for one in figure.stands)
        # The line under the scale: what grey, red and broken members are.
        missing = "" if figure.colouring is None else figure.colouring.missing
        note = "; ".join(filter(None, [missing, "broken: not unique" if figure.unsure else ""]))
        said = wrap(figure.note, int((width - 0.16) / SMALLER))
        below = 0.24 + 0.44 * (figure.colouring is not None) + NOTE * bool(note) + NOTE * len(said) + 0.04 * bool(said)
        high_cell = min(high_cell, TALLEST * max(width, WIDTHS["page"] / INCH) - above - below)
        height = above + high_cell + below
        canvas = Canvas(figsize=(width, height))
        FigureCanvasAgg(canvas)
        for k, one in enumerate(figure.stands):
            left = 0.05 + aside + k * cell
            ax = canvas.add_axes((left / width, below / height, cell / width, high_cell / height))
            ax.set_xlim(low[0], low[0] + size[0])
            ax.set_ylim(low[1], low[1] + size[1])
            ax.set_aspect("equal")
            ax.set_axis_off()
            _stand(ax, figure, one)
            canvas.text((left + 0.03) / width, (below + high_cell + 0.05) / height, one.caption, va="bottom")
        canvas.text(0.08 / width, 1 - 0.05 / height, "\n".join(title), va="top", fontweight="bold")
        if figure.axes is not None:
            _axes(canvas, *figure.axes, below + high_cell / 2, height)
        _scale_bar(canvas, canvas.axes[0], float(size[0]), height)
        low_note = (0.04 + 0.44 * (figure.colouring is not None) + NOTE * bool(note)) / height
        canvas.text(0.08 / width, low_note, "\n".join(said), va="bottom", fontsize=6.5, color=QUIET, linespacing=1.2)
        if figure.colouring is not None:
            _legend(canvas, figure.colouring, width, height, NOTE * bool(note))
            canvas.text(1 - 0.08 / width, 0.04 / height, note, ha="right", va="bottom", fontsize=6.5, color=QUIET)
        return canvas


def _box(figure: Drawing) -> tuple[Any, Any]:
    shown = [one.dots for one in figure.stands] + [np.array(pair) for one in figure.stands for pair in one.arrows]
    shown += [points.reshape(-1, 2) for one in figure.stands for points in (one.bodies, one.faces)]
    shown += [*figure.ways, *figure.ghost, *(line for one in figure.stands for line in one.lines)]
    shown += [area.tips for one in figure.stands for area in one.areas]
    points = np.concatenate(shown)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.08 * (float(np.max(high - low)) or 1.0)  # of a single point, 1 m
    return low - margin, high + margin


def _stand(ax: Any, figure: Drawing, one: Stand) -> None:
    ax.add_collection(LineCollection(list(figure.ghost), colors=GHOST, linewidths=0.5))
    for way in figure.ways:
        ax.plot(*way.T, color=WAY, linewidth=0.7, linestyle=(0, (4, 1.5)))
    ax.add_collection(PolyCollection(list(one.bodies), facecolors=BODY, edgecolors="none"))
    if len(one.faces):
        _faces(ax, figure, one)
    if one.band is not None and not one.band[1]:
        line = [one.lines[one.band[0]]]
        ax.add_collection(LineCollection(line, colors=BAND, linewidths=9.0, capstyle="round", zorder=0.5))
    for area in one.areas:
        _area(ax, area)
    if figure.colouring is None or one.values is None:
        for kind, pen in PENS.items():
            chosen = [line for line, own in zip(one.lines, figure.kinds, strict=True) if own == kind]
            ax.add_collection(LineCollection(chosen, **pen))
    else:
        _coloured(ax, figure, one)
    if one.band is not None and one.band[1]:
        ax.add_collection(LineCollection([one.lines[one.band[0]]], colors=ALARM, linewidths=3.2, capstyle="round"))
    ax.plot(*one.dots.T, "o", color=INK, markersize=1.1 * _thickness(ax, one))
    ax.plot(*one.motors.T, "o", color=DRIVEN, markersize=7, markerfacecolor="none", markeredgewidth=1.4)
    _symbols(ax, one)
    for start, end in one.arrows:
        pen = {"arrowstyle": "-|>", "color": LOAD, "linewidth": 1.0, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", end, start, arrowprops=pen)
    covered = [*one.lines, *(np.array(pair) for pair in one.arrows), *(area.tips for area in one.areas)]
    put(ax, one.labels, covered, _middles(ax, one))


def _area(ax: Any, area: Area) -> None:
    """The area between a member and its curve, of axial forces in the colours of tension and compression, and its rim."""
    for side, colour in ((1.0, TENSION), (-1.0, COMPRESSION)) if area.kind == "signed" else ((0.0, AREA),):
        if area.kind == "line":
            break
        there = np.ones(len(area.values)) if side == 0.0 else (side * area.values > 0).astype(float)
        rim = area.base + there[:, None] * (area.tips - area.base)
        ax.fill(*np.concatenate([area.base, rim[::-1]]).T, facecolor=colour, edgecolor="none", alpha=0.6, zorder=0.6)
    rim = area.tips if area.kind == "line" else np.concatenate([area.base[:1], area.tips, area.base[-1:]])
    ax.add_collection(LineCollection([rim], colors=INK, linewidths=1.2 if area.kind == "line" else 0.7, zorder=2.2))


def _symbols(ax: Any, one: Stand) -> None:
    """Supports by their symbols, those alike at once. A marker of matplotlib is as large as its farthest point."""
    alike: dict[tuple[str, tuple[float, ...]], list[Array]] = {}
    for kind, at, axes in one.supports:
        alike.setdefault((kind, tuple(axes.round(6).ravel().tolist())), []).append(at)
    for (kind, across), places in alike.items():
        for line in SUPPORTS[kind]:
            points = np.array(line) @ np.reshape(across, (2, 2))
            fill = "white" if line[0] == line[-1] and kind in ("pin", "roller") else "none"
            size = 2 * SYMBOL * float(np.abs(points).max())
            pen = {"color": INK, "markerfacecolor": fill, "markeredgewidth": 0.7, "linestyle": "none", "clip_on": False}
            ax.plot(*np.transpose(places), marker=Path(points), markersize=size, **pen)


def _middles(ax: Any, one: Stand) -> Array:
    """The middles (k, 2), m, of the symbols of supports, which names keep clear of."""
    if not one.supports:
        return np.zeros((0, 2))
    ax.apply_aspect()
    shift = [axes[1] * (0.0 if kind.startswith("turn") else -0.5) for kind, _, axes in one.supports]
    pixels = ax.transData.transform(np.array([at for _, at, _ in one.supports])) + np.array(shift) * SYMBOL * ax.figure.dpi / 72
    found: Array = ax.transData.inverted().transform(pixels)
    return found


def _coloured(ax: Any, figure: Drawing, one: Stand) -> None:
    """Members in the colours of their values."""
    assert figure.colouring is not None  # noqa: S101 - for mypy
    assert one.values is not None  # noqa: S101 - for mypy
    # a dark rim keeps pale colours visible on white paper
    thick, lines = _thickness(ax, one), list(one.lines)
    ax.add_collection(LineCollection(lines, colors=INK, linewidths=1.3 * thick, capstyle="round"))
    colours = LineCollection(
        lines, cmap=_map(figure.colouring), norm=Normalize(*figure.colouring.limits), linewidths=thick, capstyle="round"
    )
    colours.set_array(np.ma.masked_invalid(one.values))
    ax.add_collection(colours)
    # with white gaps: a force that is not unique, or what was not checked
    broken = sorted({*figure.unsure, *np.flatnonzero(np.isnan(one.values)).tolist()})
    ax.add_collection(
        LineCollection([lines[k] for k in broken], colors="white", linewidths=1.4 * thick, linestyles=(0, (0.6, 2.4)))
    )


def _thickness(ax: Any, one: Stand) -> float:
    """Width of coloured lines, points: thinner where members are short on paper, or they would run together."""
    if not one.lines:
        return 2.0
    ax.apply_aspect()
    ends = np.array([[line[0], line[-1]] for line in one.lines])
    ends = ax.transData.transform(ends.reshape(-1, 2)).reshape(-1, 2, 2) * 72 / ax.figure.dpi
    usual = float(np.median(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)))
    return float(np.clip(usual / 12, 0.5, 2.0))


def _axes(canvas: Canvas, triad: Array, gravity: Array | None, middle: float, height: float) -> None:
    """Directions of the axes, and of gravity, at the left."""
    ax = canvas.add_axes((0, 0, (ASIDE + 0.2) / canvas.get_figwidth(), 1))
    ax.set_xlim(0, ASIDE + 0.2)
    ax.set_ylim(0, height)
    ax.set_axis_off()

    def arrow(start: Array, way: Array, name: str, colour: str) -> None:
        pen = {"arrowstyle": "-|>", "color": colour, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
        ax.annotate("", tuple(start + way), tuple(start), arrowprops=pen)
        x, y = (start + 1.3 * way).tolist()
        ax.text(x, y, name, fontsize=7, ha="center", va="center", color=colour)

    origin = np.array([0.4, max(0.4, middle - 0.35)])
    for name, way in zip("xyz", triad, strict=False):
        arrow(origin, 0.32 * way, name, INK)
    if gravity is not None and height > 1.6:
        above = 0.75 + max(0.0, -0.42 * float(gravity[1]))
        arrow(origin + np.array([0.0, above]), 0.32 * gravity, "g", QUIET)


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
    length = round_length(aim)
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


def round_length(most: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is at most `most`."""
    power = 10 ** np.floor(np.log10(most))
    return float(power * max(step for step in (1, 2, 5) if step * power <= most * (1 + 1e-9)))
