"""Specifications of figures as plain arrays, and the style of all pictures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from kinetruss.display import COLOURS, OVER

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

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
class Pose:
    """One configuration: caption, node positions (n_nodes, dim), m, loads as pairs of a start and an end, m, and by member the
    points (g, dim), m, of beams.
    """

    caption: str
    position: Array
    loads: tuple[tuple[Array, Array], ...] = ()
    curves: Mapping[int, Array] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Shape:
    """The structure at some instants: members as pairs of node indices, which are driven, held nodes, names of members."""

    name: str
    title: str
    nodes: tuple[str, ...]
    ends: tuple[tuple[int, int], ...]
    driven: tuple[bool, ...]
    held: tuple[int, ...]
    poses: tuple[Pose, ...]
    members: tuple[str, ...] = ()


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
class Stand:
    """One instant of a drawing, on paper: nodes (n, 2), m; values (members,) that colour; loads as pairs of a start
    and an end, m; bodies as corners (k, 3, 2), m; faces of membranes and solids as corners (f, 3, 2), m, from back to front,
    with their brightness (f,), 0 to 1, and values (f,) of the colour quantity; hinges (h, 2), m, with a motor; curves, by
    member the points (g, 2), m, of beams.
    """

    caption: str
    points: Array
    values: Array | None
    loads: tuple[tuple[Array, Array], ...]
    bodies: Array
    faces: Array
    light: Array
    face_values: Array | None
    hinges: Array
    curves: Mapping[int, Array] = field(default_factory=dict)

    def lines(self, ends: Iterable[tuple[int, int]]) -> list[Array]:
        """Points (g, 2), m, of members from end to end: beams along their curves."""
        return [self.curves.get(k, self.points[list(pair)]) for k, pair in enumerate(ends)]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Drawing:
    """The structure for print, `width` mm wide, at one or more instants beside each other.

    kinds : of the members. joined : nodes of members and bodies. held : nodes held in all axes; guided : in some. ghost : start
    pose (n, 2), m; ways : of nodes, each (times, 2), m. members : names that are
    written. unsure : members whose force is not unique.
    """

    title: str
    width: float
    nodes: tuple[str, ...]
    ends: tuple[tuple[int, int], ...]
    kinds: tuple[str, ...]
    joined: tuple[int, ...]
    held: tuple[int, ...]
    guided: tuple[int, ...]
    stands: tuple[Stand, ...]
    colouring: Colouring | None
    ghost: Array | None
    ways: tuple[Array, ...]
    names: bool
    members: tuple[str, ...] = ()
    unsure: tuple[int, ...] = ()


Figure = Histories | Bars | Shape
