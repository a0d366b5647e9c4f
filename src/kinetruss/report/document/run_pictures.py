"""Pictures of a run and diagrams along its members, inside the page."""

from __future__ import annotations

import base64
import html
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from io import BytesIO, StringIO
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Markup, element, quantity
from kinetruss.model.links import bends
from kinetruss.report.document.diagram_pages import drawn, scales_of
from kinetruss.report.entries import Figure
from kinetruss.report.member_diagrams import governing_diagrams
from kinetruss.report.pictures.specs import Drawing, Histories, Panel

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.report.entries import Entry
    from kinetruss.report.member_diagrams import Subject
    from kinetruss.report.pictures.specs import Figure as Spec
    from kinetruss.runs import RunResult


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
    "#444444": "--quiet",
    "#dde3ea": "--band",
    "#e6e6e6": "--rule",
}
"""Colours of text and background in the house style; the page replaces them for light and dark mode."""


def picture(figure: Spec, number: int, caption: str) -> Figure:
    """A figure with its caption; `number` makes its element names unique in the page. Panels are drawn one by one, so that
    they can stand on different sheets of paper.
    """
    from kinetruss.report.pictures.draw import draw

    bare = replace(figure, title="")  # the title is in the caption
    if isinstance(bare, Histories):
        whole = thinned(bare)
        panels = [draw(replace(whole, panels=(panel,))) for panel in whole.panels]
        return Figure(panels=[lines_of(drawn, f"{number}-{k}", caption) for k, drawn in enumerate(panels)], caption=caption)
    drawn = draw(bare)
    heavy = isinstance(figure, Drawing) and len(figure.kinds) > MEMBERS
    return Figure(panels=[_pixels(drawn, caption) if heavy else lines_of(drawn, f"{number}", caption)], caption=caption)


def thinned(figure: Histories) -> Histories:
    """The same curves with fewer samples, without losing peaks: minimum and maximum of each time interval."""
    times = [figure.time, *(time for panel in figure.panels for time in panel.times.values())]
    if max(map(len, times)) <= FINE:
        return figure
    edges = [edge for panel in figure.panels if panel.band is not None for edge in panel.band]
    common = _sampled(edges or [figure.time], len(figure.time))
    panels = tuple(_thinned(panel, figure.time, common) for panel in figure.panels)
    return replace(figure, time=figure.time[common], panels=panels)


def _thinned(panel: Panel, time: NDArray[np.float64], common: NDArray[np.int64]) -> Panel:
    lines, dashed, times = {}, {}, {}
    for label, values in panel.lines.items():
        own = panel.times.get(label, time)
        still = panel.dashed.get(label)
        kept = _sampled([values] if still is None else [values, still], len(values))
        lines[label], times[label] = values[kept], own[kept]
        if still is not None:
            dashed[label] = still[kept]
    band = None if panel.band is None else (panel.band[0][common], panel.band[1][common])
    return replace(panel, lines=lines, dashed=dashed, times=times, band=band)


def _sampled(curves: list[NDArray[np.float64]], count: int) -> NDArray[np.int64]:
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

    from kinetruss.report.pictures.specs import RC

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

    from kinetruss.report.pictures.specs import RC

    written = BytesIO()
    with mpl.rc_context(RC):
        drawn.savefig(written, format="png")
    source = "data:image/png;base64," + base64.b64encode(written.getvalue()).decode("ascii")
    return element("img", alt=words, src=source, class_="pixels")


# Diagrams along the governing members and the beams, as part of a page.

SIGNS = (
    "Tension is positive (orange), compression blue; the B side exerts shear forces and moments on the A side, along and about "
    "the axes of the member."
)
ZERO = {"V2": "shear forces V₂", "V3": "V₃", "M2": "bending moments M₂", "M3": "M₃", "T_t": "torques"}


def diagrams_of(run: RunResult, record: Mapping[str, Any]) -> list[Entry]:
    """The diagrams of governing members and of beams, each as a figure that may stand on several sheets."""
    members, beams = governing_diagrams(run, record)
    count = sum(bends(run.model, one) for one in run.model.bending.values())
    found: list[Entry] = []
    if members:
        words = "Section forces along the governing members, each at the instant of its governing entry."
        found.append(_figure(members, f"{words} {SIGNS}", "members"))
    if beams:
        most = f"the {len(beams)} beams of the highest stress, of {count}" if count > len(beams) else "the beams"
        when = beams[0].moment
        words = f"Section forces along {most}{f' ({when})' if when else ''}, the most stressed first."
        found.append(_figure(beams, words if members else f"{words} {SIGNS}", "beams"))
    return found


def _figure(subjects: Sequence[Subject], words: str, number: str) -> Figure:
    scales = scales_of(subjects)
    zero = [name for key, name in ZERO.items() if key not in scales and key in subjects[0].along.lines]
    caption = words
    if any(one.place is not None for one in subjects):
        caption += " Dotted: the section of the governing check."
    if zero:
        caption += f" Zero in all of them: {', '.join(zero)}."
    panels = [lines_of(drawn([one], scales=scales), f"{number}{k}", _described(one)) for k, one in enumerate(subjects)]
    return Figure(panels=panels, caption=caption, rows=True)


def _described(one: Subject) -> str:
    """A diagram in words."""
    ends = [
        f"{line.words} {quantity(line.least[0], line.unit)} to {quantity(line.largest[0], line.unit)}"
        for line in one.along.lines.values()
    ]
    return f"{one.along.part}: {'; '.join(ends)}"
