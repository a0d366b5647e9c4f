"""Pictures of a run inside the page: vector drawings in the page's colours, of limited size."""

from __future__ import annotations

import base64
import html
import re
from dataclasses import replace
from io import BytesIO, StringIO
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Markup, element
from kinetruss.report.pictures.specs import Figure, Histories, Panel, Shape

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["embedded", "lines_of", "picture"]

FINE = 4000
"""Number of samples up to which a curve is drawn completely; else minima and maxima of `BUCKETS` intervals are drawn."""
BUCKETS = 700
MEMBERS = 400
"""Number of members up to which a shape is drawn in lines; above it in pixels."""

COLOURS = {
    "#ffffff": "--paper",
    "#222222": "--ink",
    "#000000": "--ink",
    "#666666": "--quiet",
    "#dde3ea": "--band",
    "#e6e6e6": "--rule",
}
"""Colours of text and background in the house style; the page replaces them for light and dark mode."""


def picture(figure: Figure, number: int, caption: str) -> Markup:
    """A figure with its caption; `number` makes its element names unique in the page. Panels are drawn one by one, so that
    they can stand on different sheets of paper.
    """
    from kinetruss.report.pictures.draw import draw

    bare = replace(figure, title="")  # the title is in the caption
    if isinstance(bare, Histories):
        whole = thinned(bare)
        panels = [draw(replace(whole, panels=(panel,))) for panel in whole.panels]
        return embedded([lines_of(drawn, f"{number}-{k}", caption) for k, drawn in enumerate(panels)], caption)
    drawn = draw(bare)
    heavy = isinstance(figure, Shape) and len(figure.ends) > MEMBERS
    return embedded([_pixels(drawn, caption) if heavy else lines_of(drawn, f"{number}", caption)], caption)


def embedded(panels: list[Markup], caption: str, *, rows: bool = False) -> Markup:
    """Drawings above each other as one figure with its caption. rows : they have the same width."""
    shown = [element("div", one, class_="scroll", tabindex="0") for one in panels]
    kind = "picture panels" if len(panels) > 1 else "picture"
    kind += " rows" if rows else ""
    return element("figure", shown, element("figcaption", caption), class_=kind)


def thinned(figure: Histories) -> Histories:
    """The same curves with fewer samples, without losing peaks: minimum and maximum of each time interval."""
    if max((len(one) for one in _times(figure)), default=0) <= FINE:
        return figure
    edges = [edge for panel in figure.panels if panel.band is not None for edge in panel.band]
    common = _kept(edges or [figure.time], len(figure.time))
    panels = tuple(_thinned(panel, figure.time, common) for panel in figure.panels)
    return replace(figure, time=figure.time[common], panels=panels)


def _times(figure: Histories) -> list[NDArray[np.float64]]:
    return [figure.time, *(time for panel in figure.panels for time in panel.times.values())]


def _thinned(panel: Panel, time: NDArray[np.float64], common: NDArray[np.int64]) -> Panel:
    lines, dashed, times = {}, {}, {}
    for label, values in panel.lines.items():
        own = panel.times.get(label, time)
        still = panel.dashed.get(label)
        kept = _kept([values] if still is None else [values, still], len(values))
        lines[label], times[label] = values[kept], own[kept]
        if still is not None:
            dashed[label] = still[kept]
    band = None if panel.band is None else (panel.band[0][common], panel.band[1][common])
    return replace(panel, lines=lines, dashed=dashed, times=times, band=band)


def _kept(curves: list[NDArray[np.float64]], count: int) -> NDArray[np.int64]:
    """Indices of the ends, and of the minimum and maximum of each curve in each interval."""
    size = -(-count // BUCKETS)
    places = np.minimum(np.arange(-(-count // size) * size), count - 1).reshape(-1, size)  # the last one repeated
    rows = np.arange(len(places))
    found = [np.array([0, count - 1])]
    for values in curves:
        known = np.isfinite(values)
        found.append(places[rows, np.where(known, values, np.inf)[places].argmin(axis=1)])
        found.append(places[rows, np.where(known, values, -np.inf)[places].argmax(axis=1)])
    return np.unique(np.concatenate(found))


def lines_of(drawn: Any, number: str, words: str) -> Markup:
    """SVG text for a page: unique names, no global style, the page's colours. words : for readers who do not see it."""
    import matplotlib as mpl

    from kinetruss.report.pictures.style import RC

    written = StringIO()
    with mpl.rc_context(RC):
        drawn.savefig(written, format="svg", metadata={"Date": None}, bbox_inches="tight", pad_inches=0.04)
    text = written.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r"<style[^>]*>.*?</style>", "", text, flags=re.DOTALL)
    text = re.sub(r'(\bid="|url\(#|href="#)', rf"\g<1>p{number}-", text)
    for colour, name in COLOURS.items():
        text = re.sub(rf"(?i)(:\s*){colour}\b", rf"\1var({name})", text)
    width = re.search(r'width="([\d.]+)pt"', text)
    text = re.sub(r'(<svg[^>]*?) height="[\d.]+pt"', r"\1", text, count=1)
    shown = f'role="img" aria-label="{html.escape(words)}" style="width:{width[1] if width else 500}pt"'
    return Markup(re.sub(r'(<svg[^>]*?) width="[\d.]+pt"', lambda found: f"{found[1]} {shown}", text, count=1))


def _pixels(drawn: Any, words: str) -> Markup:
    import matplotlib as mpl

    from kinetruss.report.pictures.style import RC

    written = BytesIO()
    with mpl.rc_context(RC):
        drawn.savefig(written, format="png")
    source = "data:image/png;base64," + base64.b64encode(written.getvalue()).decode("ascii")
    return element("img", alt=words, src=source, class_="pixels")
