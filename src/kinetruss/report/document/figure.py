"""The figure of a report as part of its page: the structure at one instant, or its deflected shape, magnified, at rest."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure as Canvas

from kinetruss.display import quantity
from kinetruss.report.document.figure_contents import Loaded, loaded, supports_of
from kinetruss.report.document.figure_drawing import WIDTH, Labels, draw_supports, drawn, lines_of_members, round_length, seen
from kinetruss.report.document.run_pictures import lines_of
from kinetruss.report.entries import Figure
from kinetruss.report.pictures.drawing import projected
from kinetruss.report.pictures.specs import INK, PRINT, QUIET, RC
from kinetruss.report.run_lines import shift_of
from kinetruss.report.tables import cased

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]


TALLEST, LEAST = 3.6, 1.2
"""Largest and smallest height, inches."""

SHARE = 0.1
"""Size of the largest drawn displacement at most, of the structure."""
GHOST = "#a8b0b9"


def deflected_figure(run: RunResult, record: Mapping[str, Any]) -> list[Entry]:
    """The figure of the load case of the governing entry; nothing for runs over time, and without displacements."""
    if run.good != 1 or not run.statics:
        return []
    case = _case(run, record)
    shift = shift_of(run, run.statics[case])
    figure = loaded(run, record)
    visible = seen(figure.model)
    size = np.linalg.norm(shift[0][visible], axis=1) if shift is not None and shift.size and visible else np.zeros(1)
    if not size.max() > 0 or not lines_of_members(figure, projected(figure.position)):
        return []
    start = np.array([node.at for node in run.origin.nodes.values()], float)
    extent = float(np.linalg.norm(np.ptp(start[visible], axis=0))) or 1.0
    factor = max(1.0, round_length(SHARE * extent / float(size.max())))
    rest, moved = replace(figure, position=start), replace(figure, position=start + factor * shift[0])
    farthest = visible[int(size.argmax())]
    words = f"{list(run.model.nodes)[farthest]}: {quantity(float(size.max()), 'm')}"
    scale = "to scale" if factor == 1 else f"displacements {factor:g} times as large as they are"
    held = supports_of(run.model)
    caption = f"The deflected shape, {cased(case)}, {scale}; grey: without loads; the largest displacement is named" + (
        f"; supports: {', '.join(held)}." if held else "."
    )
    canvas = _drawn(rest, moved, (farthest, words))
    return [Figure(panels=[lines_of(canvas, "deflected", caption)], caption=caption)]


def _case(run: RunResult, record: Mapping[str, Any]) -> str:
    """The load case of the governing entry that has displacements, or the first."""
    named = [row["load_case"] for row in record["strength"] if row["utilisation"] is not None]
    return next((case for case in named[:1] if case in run.statics), next(iter(run.statics)))


def _drawn(rest: Loaded, moved: Loaded, label: tuple[int, str]) -> Canvas:
    points = [projected(one.position) for one in (rest, moved)]
    before, after = (list(lines_of_members(one, own).values()) for one, own in zip((rest, moved), points, strict=True))
    shown = np.concatenate([*before, *after])
    low, high = shown.min(axis=0), shown.max(axis=0)
    reach = float(np.max(high - low)) or 1.0
    low, high = low - 0.08 * reach, high + 0.08 * reach
    height = float(np.clip(WIDTH * (high - low)[1] / (high - low)[0], LEAST, TALLEST))
    scale = max((high - low)[0] / WIDTH, (high - low)[1] / height)
    with mpl.rc_context(RC | PRINT):
        canvas = Canvas(figsize=(WIDTH, height))
        FigureCanvasAgg(canvas)
        ax = canvas.add_axes((0, 0, 1, 1))
        middle = (low + high) / 2
        ax.set_xlim(middle[0] - scale * WIDTH / 2, middle[0] + scale * WIDTH / 2)
        ax.set_ylim(middle[1] - scale * height / 2, middle[1] + scale * height / 2)
        ax.set_axis_off()
        ax.add_collection(LineCollection(before, colors=GHOST, linewidths=0.8))
        ax.add_collection(LineCollection(after, colors=INK, linewidths=1.4, capstyle="round"))
        draw_supports(ax, rest.model, points[0])
        node, words = label
        ax.plot(*np.array([points[0][node], points[1][node]]).T, color=QUIET, linewidth=0.8, linestyle=(0, (2, 1.5)))
        ax.plot(*points[1][node], "o", color=INK, markersize=3.5)
        Labels(ax, scale, [*before, *after], points[0][:0]).put(words, points[1][node], INK, bold=True)
    return canvas


# The figure as part of a page.

SMALL = 2.45
"""Height of the figure of a summary, inches."""


def loaded_figure(run: RunResult, record: Mapping[str, Any], *, small: bool = False) -> list[Entry]:
    """The figure as part of a page; nothing for a run without a good sample. small : for a summary."""
    if not run.good:
        return []
    found = loaded(run, record)
    canvas = drawn(found, SMALL) if small else drawn(found)
    return [Figure(panels=[lines_of(canvas, "loaded", found.caption)], caption=found.caption)]
