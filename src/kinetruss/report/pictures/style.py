"""How every picture looks, said once."""

from __future__ import annotations

from typing import Any

from kinetruss.display import COLOURS

STYLES = ("-", (0, (6, 2)), (0, (2, 1.5)))
"""Curves beyond the last colour take the next line style, so that no two look the same."""

REST = (0, (3, 2))
"""Line of the same poses at rest, thin beside the motion."""

INK, QUIET, BAND, ALARM, ACCENT = "#222222", "#8a8a8a", "#dde3ea", "#B22222", COLOURS[0]
DRIVEN = COLOURS[2]
"""What moves by itself, in every picture; blue is compression."""

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
"""The fixed salt makes the same run give the same SVG, byte by byte. Letters stay letters in SVG and PDF."""

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
"""On top of it for figures of a stated width: letters of 7 and 8 points, as journals ask."""

WIDTHS = {"column": 90.0, "page": 190.0}
"""Widths of figures, mm: one column and both of a page, as most publishers have them (Elsevier, artwork sizing)."""


def pen(index: int) -> dict[str, object]:
    """Colour and line style of curve number `index`."""
    return {"color": COLOURS[index % len(COLOURS)], "linestyle": STYLES[index // len(COLOURS) % len(STYLES)]}
