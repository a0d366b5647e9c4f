"""Specifications of figures as plain arrays, and the style of all pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import COLOURS, OVER

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.report.pictures.labels import Label

    Array = NDArray[np.float64]


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


# Specifications of figures as plain arrays.


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Panel:
    """Curves over time that share one axis.

    lines : label -> values (times,), in `unit`. dashed : the same, drawn thin and dashed (a comparison).
    band : least and largest of all members at each instant. limit : largest allowed magnitude, drawn as a horizontal line.
    times : label -> its own time axis, if it differs from the figure's.
    """

    quantity: str
    unit: str
    lines: dict[str, Array]
    dashed: dict[str, Array] = field(default_factory=dict)
    band: tuple[Array, Array] | None = None
    limit: float | None = None
    times: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Histories:
    """Panels above each other over one time axis (s). width : mm, for print; None: for a screen."""

    name: str
    title: str
    time: Array
    panels: tuple[Panel, ...]
    width: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Bars:
    """Horizontal bars of values in `unit`, worst first; `notes` are next to them; `limit` is drawn as a line."""

    name: str
    title: str
    quantity: str
    unit: str
    labels: tuple[str, ...]
    values: Array
    notes: tuple[str, ...]
    limit: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Colouring:
    """The colour quantity: label, unit, labels at the ends, ends in SI; diverging about zero or not.

    missing : meaning of grey, or an empty text.
    """

    label: str
    unit: str
    words: tuple[str, str]
    limits: tuple[float, float]
    diverging: bool
    missing: str = ""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Area:
    """A curve beside a member: base and tips (s, 2), m on paper, values (s,); kind : ``plain``, ``signed`` with the colours of
    tension and compression, or ``line`` without an area.
    """

    base: Array
    tips: Array
    values: Array
    kind: str


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Stand:
    """One instant of a drawing, on paper: lines (g, 2), m, of members, and their values (members,) that colour; dots (k, 2), m,
    of nodes; bodies as corners (k, 3, 2), m; faces of membranes and solids as corners (f, 3, 2), m, from back to front, with
    their brightness (f,), 0 to 1, and values (f,) of the colour quantity; motors (h, 2), m; supports as
    kind, place (2,), m, and axes x, y (2, 2) of their symbol;
    arrows as pairs of a start and an end, m; band : the member that governs, and whether it is over its capacity; areas :
    curves beside members.
    """

    caption: str
    lines: Sequence[Array]
    dots: Array
    bodies: Array
    faces: Array
    light: Array
    motors: Array
    supports: Sequence[tuple[str, Array, Array]]
    values: Array | None = None
    face_values: Array | None = None
    arrows: Sequence[tuple[Array, Array]] = ()
    labels: Sequence[Label] = ()
    band: tuple[int, bool] | None = None
    areas: Sequence[Area] = ()


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Drawing:
    """The structure, `width` mm wide, at one or more instants beside each other.

    kinds : of the members. unsure : members whose force is not unique. ghost : lines of another pose; ways : of nodes, each
    (times, 2), m. axes : directions (dim, 2) of the axes on paper, and of gravity (2,) or None, drawn at the left. tallest :
    height of the structure at most, inches. note : text below.
    """

    name: str
    title: str
    width: float
    kinds: Sequence[str]
    stands: Sequence[Stand]
    colouring: Colouring | None = None
    unsure: Sequence[int] = ()
    ghost: Sequence[Array] = ()
    ways: Sequence[Array] = ()
    axes: tuple[Array, Array | None] | None = None
    tallest: float = np.inf
    note: str = ""


Figure = Histories | Bars | Drawing
