"""Figures from plain specifications, without a display: curves and bars; PNG, SVG and PDF."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Canvas

from kinetruss.display import DIGIT, POINT, aligned, quantity, scale
from kinetruss.report.pictures.drawing import drawn
from kinetruss.report.pictures.specs import (
    ACCENT,
    ALARM,
    BAND,
    PRINT,
    QUIET,
    RC,
    REST,
    Bars,
    Drawing,
    Figure,
    Histories,
    Panel,
    pen,
)
from kinetruss.results.folder import whole_file

__all__ = ["draw", "save"]

CHARACTER = 0.069
"""Width of a character of the legend, inches."""

SUFFIXES = ("png", "svg", "pdf")
SCREEN: float = RC["savefig.dpi"]


def draw(figure: Figure) -> Canvas:
    """A matplotlib figure of the specification, in the house style."""
    if isinstance(figure, Drawing):
        return drawn(figure)
    if isinstance(figure, Histories) and figure.width is not None:
        with mpl.rc_context(RC | PRINT):
            return _printed(figure, figure.width / 25.4)
    with mpl.rc_context(RC):
        if isinstance(figure, Histories):
            return _histories(figure)
        return _bars(figure)


def save(figures: Iterable[Figure], folder: Path, formats: Iterable[str] = ("png", "svg")) -> list[Path]:
    """Draw each figure into ``folder/NAME.FORMAT``; the paths written.

    Raises
    ------
    StoreError : the folder cannot be written.
    """
    written = []
    for figure in figures:
        canvas = draw(figure)
        for suffix in formats:
            written.append(folder / f"{figure.name}.{suffix}")
            write(canvas, written[-1])
    return written


def write(canvas: Canvas, path: Path, dots: float = SCREEN) -> None:
    """Write one file, completely or not at all; without a date, so that the same run gives the same bytes. dots : per inch.

    Raises
    ------
    StoreError : the file cannot be written.
    """
    with mpl.rc_context(RC | {"savefig.dpi": dots}), whole_file(path) as draft:
        metadata: Any = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(path.suffix[1:])
        # level 6 takes five times as long as level 1 and saves a tenth of these files
        options: Any = {"pil_kwargs": {"compress_level": 1}} if path.suffix == ".png" else {}
        canvas.savefig(draft, metadata=metadata, **options)


def _canvas(width: float, height: float) -> Canvas:
    canvas = Canvas(figsize=(width, height))
    FigureCanvasAgg(canvas)
    return canvas


def _histories(figure: Histories) -> Canvas:
    count = len(figure.panels)
    height = 0.9 + 2.0 * count
    width = 6.4 + max(1.6, 0.5 + CHARACTER * max((len(label) for panel in figure.panels for label in panel.lines), default=0))
    canvas = _canvas(width, height)
    axes = canvas.subplots(count, 1, sharex=True, squeeze=False)[:, 0]
    canvas.subplots_adjust(left=0.88 / width, right=6.4 / width, top=1 - 0.42 / height, bottom=0.48 / height, hspace=0.16)
    known: dict[str, Any] = {}
    for ax, panel in zip(axes, figure.panels, strict=True):
        _panel(ax, figure.time, panel)
        _legend(ax, known)
    axes[0].set_title(figure.title)
    axes[-1].set_xlabel("time (s)")
    axes[-1].set_xlim(figure.time[0], figure.time[-1] if len(figure.time) > 1 else None)
    canvas.align_ylabels(axes)
    return canvas


def _printed(figure: Histories, width: float) -> Canvas:
    """Set up for print: given font size, no title (journals use captions), the legend below the axes."""
    count = len(figure.panels)
    canvas = _canvas(width, 2.0)
    axes = canvas.subplots(count, 1, sharex=True, squeeze=False)[:, 0]
    # one legend for all panels: the same name has the same style in each
    pens = {name: k for k, name in enumerate(dict.fromkeys(label for panel in figure.panels for label in panel.lines))}
    shown: dict[str, Any] = {}
    for ax, panel in zip(axes, figure.panels, strict=True):
        _panel(ax, figure.time, panel, pens)
        handles, words = ax.get_legend_handles_labels()
        shown |= dict(zip(words, handles, strict=True))
    columns = max(1, min(len(shown), int((width - 0.5) / (0.42 + 0.065 * max(map(len, shown))))))
    below = 0.42 + 0.16 * -(-len(shown) // columns)
    height = 0.1 + min(1.5, 0.62 * width) * count + below
    canvas.set_size_inches(width, height)
    canvas.subplots_adjust(left=0.56 / width, right=1 - 0.12 / width, top=1 - 0.08 / height, bottom=below / height, hspace=0.14)
    axes[-1].set_xlabel("time (s)")
    axes[-1].set_xlim(figure.time[0], figure.time[-1] if len(figure.time) > 1 else None)
    canvas.align_ylabels(axes)
    canvas.legend(
        list(shown.values()),
        list(shown),
        loc="lower left",
        bbox_to_anchor=(0.45 / width, 0.0),
        ncol=columns,
        handlelength=1.8,
        columnspacing=1.0,
        labelspacing=0.3,
        borderpad=0.2,
    )
    return canvas


def _panel(ax: Any, time: Any, panel: Panel, pens: Mapping[str, int] | None = None) -> None:
    curves = [*panel.lines.values(), *panel.dashed.values(), *(panel.band or ())]
    shown = max((float(np.nanmax(np.abs(curve))) for curve in curves if np.isfinite(curve).any()), default=0.0)
    factor, unit = scale(shown, panel.unit)
    if panel.band is not None:
        ax.fill_between(time, *(factor * edge for edge in panel.band), color=BAND, linewidth=0, label="all members")
    for place, (label, values) in enumerate(panel.lines.items()):
        index = place if pens is None else pens[label]
        ax.plot(panel.times.get(label, time), factor * values, label=label, **pen(index))
        if label in panel.dashed:
            rest = factor * panel.dashed[label]
            ax.plot(panel.times.get(label, time), rest, color=pen(index)["color"], linewidth=0.9, linestyle=REST)
    if panel.limit is not None:
        _limit(ax, panel, factor, shown)
    if panel.dashed:
        ax.plot([], [], color=QUIET, linewidth=0.9, linestyle=REST, label="at rest")
    ax.set_ylabel(f"{panel.quantity} ({unit})" if unit else panel.quantity)


def _legend(ax: Any, known: dict[str, Any]) -> None:
    """The legend, without names that panels above already show with the same colours."""
    handles, labels = ax.get_legend_handles_labels()
    here = {
        label: str(handle.get_facecolor() if hasattr(handle, "get_facecolor") else handle.get_color())
        for handle, label in zip(handles, labels, strict=True)
    }
    clash = any(known.get(label, colour) != colour for label, colour in here.items())
    kept = [pair for pair in zip(handles, labels, strict=True) if clash or pair[1] not in known]
    if kept:
        ax.legend(*zip(*kept, strict=True), loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0)
    known.update(here)


def _limit(ax: Any, panel: Panel, factor: float, shown: float) -> None:
    """Horizontal lines at the limit, on each side that the curves reach; a far limit is only noted in the legend."""
    limit = panel.limit or 0.0
    label = f"limit {quantity(limit, panel.unit)}"
    if limit > 2.5 * shown:
        ax.plot([], [], color=ALARM, linewidth=1.0, linestyle="--", label=f"{label}, not shown")
        return
    for side in (1.0, -1.0):
        if any(np.nanmax(side * curve, initial=-np.inf) > 0 for curve in panel.lines.values()):
            ax.axhline(side * factor * limit, color=ALARM, linewidth=1.0, linestyle="--", label=label)
            label = "_nolegend_"


def _bars(figure: Bars) -> Canvas:
    count = len(figure.labels)
    height = 0.95 + 0.24 * count
    canvas = _canvas(8.0, height)
    ax = canvas.subplots()
    canvas.subplots_adjust(left=0.18, right=0.97, top=1 - 0.4 / height, bottom=0.5 / height)
    places = np.arange(count)
    colours = [ALARM if value > figure.limit else ACCENT for value in figure.values]
    largest = max(float(np.nanmax(figure.values, initial=0.0)), 1e-12)
    factor, unit = scale(largest, figure.unit)
    ax.barh(places, factor * figure.values, color=colours, height=0.7)
    texts = aligned([quantity(value, figure.unit) for value in figure.values])
    for place, value, text, note in zip(places, figure.values, texts, figure.notes, strict=True):
        words = f"{text.replace(DIGIT, '').replace(POINT, '')}{note if note.startswith(',') else f'  {note}'}"
        ax.annotate(words, (factor * value, place), xytext=(4, 0), textcoords="offset points", va="center", fontsize=7.5)
    if np.isfinite(figure.limit):  # up to the limit in any case, so that figures of different runs can be compared
        ax.axvline(factor * figure.limit, color=ALARM, linewidth=1.0, linestyle="--")
        ax.set_xlim(0, factor * max(1.02 * figure.limit, 1.75 * largest))
    else:
        ax.set_xlim(0, 1.75 * factor * largest)
    ax.set_yticks(places, figure.labels)
    ax.set_ylim(count - 0.4, -0.6)
    ax.grid(visible=False, axis="y")
    ax.set_xlabel(f"{figure.quantity} ({unit})")
    ax.set_title(figure.title)
    return canvas
