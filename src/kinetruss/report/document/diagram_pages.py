"""Draws diagrams of section forces: a row for every part, a panel for every section force."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Canvas
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke

from kinetruss.display import DIVERGING, number, quantity, scale
from kinetruss.errors import InputError
from kinetruss.report.drive_data import limits
from kinetruss.report.member_diagrams import Subject, diagrams_record, governing_diagrams, requested
from kinetruss.report.page import Page
from kinetruss.report.pictures.draw import SUFFIXES, write
from kinetruss.report.pictures.picture import width_of
from kinetruss.report.pictures.specs import BAND, INK, PRINT, QUIET, RC
from kinetruss.report.run_data import plain, strength

if TYPE_CHECKING:
    from kinetruss.report.member_diagrams import Line
    from kinetruss.runs import RunResult


WIDTH = 6.9
"""Width on a page, inches."""
NARROW, WIDE = 1.12, 2.6
"""Least and largest width of a panel, inches."""
TITLE, NAME, HIGH, FOOT = 0.24, 0.17, 0.62, 0.2
"""Heights of the title of a part, of the name of a panel, of its curve and of its axis, inches."""
GAP = 0.09
ALIKE = 0.02
"""Share of the largest magnitude by which two extremes differ at least, if both are written."""
TENSION, COMPRESSION = DIVERGING[4], DIVERGING[2]
SYMBOLS = {"T": "T", "V2": "V₂", "V3": "V₃", "M2": "M₂", "M3": "M₃", "T_t": "Tₜ"}
SHORT = {"T": "axial force", "V2": "shear", "V3": "shear", "M2": "moment", "M3": "moment", "T_t": "torque"}

Scales = dict[str, tuple[float, str]]


def scales_of(subjects: Sequence[Subject]) -> Scales:
    """Factor and unit of each section force that is not zero in all diagrams; shear forces, and moments, share theirs."""
    sizes: dict[str, float] = {}
    for one in subjects:
        for name, line in one.along.lines.items():
            sizes[name] = max(sizes.get(name, 0.0), abs(line.least[0]), abs(line.largest[0]))
    groups = {"T": ("T",), "V": ("V2", "V3"), "M": ("M2", "M3", "T_t")}
    found: Scales = {}
    for name, size in sizes.items():
        group = next(group for group in groups.values() if name in group)
        largest = max(sizes.get(other, 0.0) for other in group)
        if size or name == "T":
            found[name] = scale(largest, "N m" if group is groups["M"] else "N")
    return found


def drawn(subjects: Sequence[Subject], width: float = WIDTH, scales: Scales | None = None) -> Canvas:
    """A matplotlib figure, `width` inches wide. scales : those of other diagrams that go with these."""
    shared = scales_of(subjects) if scales is None else scales
    line = max(1, min(len(shared), int(width / NARROW)))
    lines = -(-len(shared) // line)
    each = min(WIDE, width / line)
    row = TITLE + lines * (NAME + HIGH + FOOT)
    height = row * len(subjects)
    with mpl.rc_context(RC | PRINT):
        canvas = Canvas(figsize=(width, height))
        FigureCanvasAgg(canvas)
        canvas.add_artist(Rectangle((0, 0), 1, 1, transform=canvas.transFigure, facecolor="none", edgecolor="none"))
        for k, one in enumerate(subjects):
            top = height - k * row
            _title(canvas, one, (top - 0.06) / height)
            for place, (name, (factor, unit)) in enumerate(shared.items()):
                left = (place % line) * each
                above = top - TITLE - (place // line) * (NAME + HIGH + FOOT)
                box = ((left + GAP) / width, (above - NAME - HIGH) / height, (each - 2 * GAP) / width, HIGH / height)
                ax = canvas.add_axes(box)
                _panel(ax, one, one.along.lines.get(name), factor)
                words = f"{SHORT[name]} {SYMBOLS[name]} ({unit})"
                canvas.text(box[0], (above - 0.02) / height, words, va="top", fontsize=6.8, color=QUIET)
    return canvas


def _title(canvas: Any, one: Subject, top: float) -> None:
    """Name of the part, why it is shown, when and under which loads."""
    words = " · ".join(filter(None, [one.why, one.moment]))
    left = GAP / canvas.get_figwidth()
    name = canvas.text(left, top, one.along.part, va="top", fontsize=8, fontweight="bold", color=INK)
    end = name.get_window_extent(canvas.canvas.get_renderer()).x1 / canvas.dpi / canvas.get_figwidth()
    canvas.text(end + 0.1 / canvas.get_figwidth(), top, words, va="top", fontsize=8, color=QUIET)


def _panel(ax: Any, one: Subject, line: Line | None, factor: float) -> None:
    x = one.along.x
    begin, end = float(x[0]), float(x[-1])
    for side in ("left", "bottom"):
        ax.spines[side].set_visible(False)
    ax.grid(visible=False)
    ax.set_yticks([])
    ax.set_xlim(begin, end)
    ax.set_xticks([begin, end], [number(begin, 3), quantity(end, "m", 3)])
    ax.tick_params(length=2, labelsize=6.3, pad=1.5, colors=QUIET)
    for text, side in zip(ax.get_xticklabels(), ("left", "right"), strict=True):
        text.set_horizontalalignment(side)
    ax.axhline(0.0, color=INK, linewidth=0.7)
    values = np.zeros(len(x)) if line is None else factor * line.values
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    room = (high - low) or 1.0
    ax.set_ylim(low - room * (0.42 if low < 0 else 0.12), high + room * (0.42 if high > 0 else 0.12))
    if line is None or not values.any():
        ax.text((begin + end) / 2, 0.06 * room, "0", ha="center", va="bottom", fontsize=6.5, color=QUIET)
        return
    if line.symbol == "T":
        ax.fill_between(x, values, where=values >= 0, color=TENSION, linewidth=0)
        ax.fill_between(x, values, where=values <= 0, color=COMPRESSION, linewidth=0)
    else:
        ax.fill_between(x, values, color=BAND, linewidth=0)
    ax.plot(x, values, color=INK, linewidth=1.0)
    if one.place is not None and begin <= one.place <= end:
        ax.axvline(one.place, color=INK, linewidth=0.8, linestyle=(0, (1, 1.5)))
    for value, place in _extremes(line):
        _mark(ax, factor * value, place, begin, end)


def _extremes(line: Line) -> list[tuple[float, float]]:
    """The extreme values that are written: one if they hardly differ, or if one of them is zero."""
    pair = [line.least, line.largest]
    size = max(abs(value) for value, _ in pair)
    if pair[1][0] - pair[0][0] < ALIKE * size:
        return [max(pair, key=lambda one: abs(one[0]))]
    return [one for one in pair if abs(one[0]) > ALIKE * size]


def _mark(ax: Any, value: float, place: float, begin: float, end: float) -> None:
    """A dot at an extreme value and the value, with its place if that is not an end."""
    ax.plot([place], [value], "o", color=INK, markersize=2.4, clip_on=False)
    share = (place - begin) / (end - begin)
    side = "left" if share < 0.3 else "right" if share > 0.7 else "center"
    within = 1e-4 < share < 1 - 1e-4
    words = f"{number(value)} at {quantity(place, 'm', 3)}" if within else number(value)
    shift = (2.0 if side == "left" else -2.0 if side == "right" else 0.0, 2.5 if value >= 0 else -2.5)
    text = ax.annotate(
        words, (place, value), xytext=shift, textcoords="offset points", fontsize=6.5, color=INK,
        ha=side, va="bottom" if value >= 0 else "top", annotation_clip=False,
    )  # fmt: skip
    text.set_path_effects([withStroke(linewidth=1.8, foreground="white")])


# Draws diagrams of section forces into a file.

INCH = 25.4


def diagrams(
    run: RunResult,
    file: str | Path,
    *,
    members: Sequence[str] = (),
    at: float | str | None = None,
    case: str | None = None,
    width: str | float = "page",
) -> Path:
    """Draw axial force, shear forces, bending moments and torque along members and beams at one instant.

    Parameters
    ----------
    file : ``.png``, ``.svg`` or ``.pdf``.
    members : members, base rods and tubes (``M7.tube``), elastic beams; by default the governing members, each at the instant
        of its governing entry, and the 12 beams of the highest stress at that of the worst one, as in a report.
    at : instant, s or text with a unit (the nearest computed sample is shown), or the name of a pose; by default the start.
        case : load case, by default the first. width : mm, or ``column`` (90 mm), ``page`` (190 mm).

    Raises
    ------
    InputError : an unknown member, instant, load case, suffix or width; section forces that are not known.
    StoreError : the file cannot be written.

    Notes
    -----
    Values are those of `strength.sections` and `strength.beams`, with their signs and member axes. A panel has the least and
    the largest value with its place from end A; a dotted line marks the section of the governing check. Round-off is 0.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.report.diagrams(kt.run(model), f"{folder}/crank.svg", members=["crank"], at="250 ms").name
    'crank.svg'
    """
    path = Path(file)
    if path.suffix[1:] not in SUFFIXES:
        raise InputError(f"{path}: pictures end in {', '.join('.' + suffix for suffix in SUFFIXES)}.")
    write(drawn(_subjects(run, members, at, case), width_of(width) / INCH), path, dots=300)
    return path


def diagrams_page(run: RunResult, members: Sequence[str] = (), at: float | str | None = None, case: str | None = None) -> Page:
    """The extreme values of `diagrams`, which has the same arguments, as a page: `record` of plain data, SI.

    >>> import kinetruss as kt
    >>> steel = kt.Material(E=200e9, density=0.0)
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, clamped=["A"], material=steel, section=kt.Rod(diameter=0.01),
    ...                  beams={"arm": ("A", "B")}, loads={"P": kt.NodalForce(node="B", force=(0, -10))},
    ...                  runs={"rest": kt.Run(analysis="statics.linear")})
    >>> one = kt.report.diagrams_page(kt.run(model), ["arm"]).record[-1]
    >>> one["symbol"], round(one["least"], 9), one["least_at"], one["largest"]
    ('M3', -10.0, 0.0, 0.0)
    """
    return Page(found=_subjects(run, members, at, case), as_record=diagrams_record)


def _subjects(run: RunResult, members: Sequence[str], at: float | str | None, case: str | None) -> list[Subject]:
    if members:
        return requested(run, members, at, case)
    if at is not None or case is not None:
        raise InputError("Name the members too: without them the governing ones are shown, each at its own instant.")
    record = plain({"strength": strength(run), "limits": limits(run)})
    found = [one for group in governing_diagrams(run, record) for one in group]
    if not found:
        raise InputError("No member governs and there are no beams. Name members: members=['M1'].")
    return found
