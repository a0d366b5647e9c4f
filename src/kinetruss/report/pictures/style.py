"""The style of all pictures."""

from __future__ import annotations

from typing import Any

from kinetruss.display import COLOURS, OVER

STYLES = ("-", (0, (6, 2)), (0, (2, 1.5)))
"""Line styles: after the last colour, curves take the next style, so that no two look the same."""

REST = (0, (3, 2))
"""Line style of the same poses at rest, thinner than that of the motion."""

INK, QUIET, BAND, ALARM, ACCENT = "#222222", "#666666", "#dde3ea", OVER, "#5b7083"
"""Text and lines; quiet text; bands; limits and what is above them; bars of values without a sign."""

RC: dict[Any, Any] = {
    "figure.dpi": 100,
    "savefig.dpi": 130,
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.unicode_minus": False,  # as numbers are written elsewhere
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "xtick.color": INK,
    "ytick.color": INK,
    "svg.hashsalt": "kinetruss",
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
}
"""Options of files. With the fixed salt the same run gives the same SVG, byte by byte. Text stays text in SVG and PDF."""

PRINT: dict[Any, Any] = {
    "savefig.dpi": 300,
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 7,
    "lines.linewidth": 1.1,
    "axes.linewidth": 0.6,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
}
"""Additional style of figures with a given width: fonts of 7 and 8 points, as journals require."""

WIDTHS = {"column": 90.0, "page": 190.0}
"""Widths of figures, mm: one column and both of a page, as most publishers have them (Elsevier, artwork sizing)."""


def pen(index: int) -> dict[str, object]:
    """Colour and line style of curve number `index`."""
    return {"color": COLOURS[index % len(COLOURS)], "linestyle": STYLES[index // len(COLOURS) % len(STYLES)]}
