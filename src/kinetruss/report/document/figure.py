"""The figure of a report: the structure at one instant with loads and their values, or its deflected shape."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure as Canvas

from kinetruss.display import instant, number, quantity
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import case_loads
from kinetruss.report.document.demands import cased, is_over, share_of, value_of
from kinetruss.report.document.figure_drawing import WIDTH, Labels, draw_supports, drawn, lines_of_members, round_length, seen
from kinetruss.report.document.result import governing_entry
from kinetruss.report.document.run_pictures import embedded, lines_of
from kinetruss.report.pictures.drawing import projected
from kinetruss.report.pictures.specs import INK, PRINT, QUIET, RC
from kinetruss.report.run_lines import shift_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.display import Markup
    from kinetruss.model import Model
    from kinetruss.runs import RunResult


if TYPE_CHECKING:
    Array = NDArray[np.float64]


LEAST_FORCE = 1e-9
"""Forces below this share of the largest are not drawn."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Loaded:
    """One instant. position (n, dim), m; loads : node index, force (dim,) N; governing : member and what its label says; over :
    whether it is over its capacity.
    """

    model: Model
    position: Array
    loads: tuple[tuple[int, Array], ...]
    governing: tuple[str, str] | None
    over: bool
    caption: str


def loaded(run: RunResult, record: Mapping[str, Any]) -> Loaded:
    """The instant of the governing entry, or of the largest member force, with the loads that act then."""
    worst = governing_entry(record)
    model, case, k = run.model, next(iter(run.forces), None), 0
    entry: Mapping[str, Any] | None = worst or next(iter(record["largest_forces"]), None)
    if entry is not None:
        case = entry["load_case"] if entry["load_case"] in run.forces else case
        k = _sample(run, entry)
    time = run.motion.data["time"].values
    found = case_loads(compile(model), time, case if case in model.load_cases else None, rotating=True)
    force = np.asarray(found.force[:, :, : model.dim])[k] if len(found.node) else np.zeros((0, model.dim))
    largest = float(np.linalg.norm(force, axis=1).max(initial=0.0))
    loads = tuple(
        (int(node), one)
        for node, one in zip(found.node, force, strict=True)
        if largest and np.linalg.norm(one) > LEAST_FORCE * largest
    )
    governing, over = None, False
    if worst is not None:
        member = worst["part"].rpartition(".")[0] if worst["part"] not in _names(model) else worst["part"]
        used = share_of(worst["utilisation"])
        over = is_over(worst)
        governing = (member, f"{worst['part']}: {worst['rule']} {used}")
    return Loaded(
        model=model,
        position=run.motion.data["position"].values[k],
        loads=loads,
        governing=governing,
        over=over,
        caption=_caption(run, case, k, governing, over, len(loads)),
    )


def _names(model: Model) -> set[str]:
    return {*model.members, *model.beams, *model.drives}


def _sample(run: RunResult, entry: Mapping[str, Any]) -> int:
    if entry.get("pose") and "pose" in run.motion.data.coords:
        return int(np.flatnonzero(run.motion.data["pose"].values == entry["pose"])[0])
    when = value_of(entry["time"])
    return 0 if np.isnan(when) else int(np.abs(run.motion.data["time"].values - when).argmin())


def supports_of(model: Model) -> list[str]:
    """The marks of supports that the figure has."""
    ground = {name for name, one in model.clamped.items() if one == "ground"}
    axes = [axes for name, axes in model.fixed.items() if name not in ground and not model.nodes[name].director]
    kinds = (("squares clamped", ground), ("triangles held", [one for one in axes if len(one) == model.dim]))
    found = [words for words, some in kinds if some]
    return [*found, *["circles guided"] * any(len(one) < model.dim for one in axes)]


def _caption(run: RunResult, case: str | None, k: int, governing: tuple[str, str] | None, over: bool, count: int) -> str:
    model, time = run.model, run.motion.data["time"].values
    when = f"at t = {instant(time[k])}" if len(time) > 1 else "in the computed position"
    if "pose" in run.motion.data.coords:
        when = f"in pose {run.motion.data['pose'].values[k]}"
    words = [f"The structure {when}{f', {cased(case)}' if case else ''}"]
    if governing:
        mark = "red, over its capacity" if over else "on a broad pale band"
        words.append(f"the governing part {mark} ({governing[1]})")
    if model.all_drives:
        words.append("driven members green")
    if held := supports_of(model):
        words.append(f"supports: {', '.join(held)}")
    if count:
        words.append("arrows: forces on nodes")
    others = [name for name, load in model.loads.items() if type(load).__name__ != "NodalForce"]
    if others:
        words.append(f"not drawn: {', '.join(others)}")
    if model.gravity and any(model.gravity):
        words.append(f"gravity {number(float(np.linalg.norm(model.gravity)))} m/s², grey arrow")
    return "; ".join(words) + "."


# Draws the deflected shape of a structure at rest, magnified, above the shape without loads.

SHARE = 0.1
"""Size of the largest drawn displacement at most, of the structure."""
TALLEST, LEAST = 3.6, 1.2
"""Largest and smallest height, inches."""
GHOST = "#a8b0b9"


def deflected_figure(run: RunResult, record: Mapping[str, Any]) -> list[Markup]:
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
    return [embedded([lines_of(canvas, "deflected", caption)], caption)]


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


def loaded_figure(run: RunResult, record: Mapping[str, Any], *, small: bool = False) -> list[Markup]:
    """The figure as part of a page; nothing for a run without a good sample. small : for a summary."""
    if not run.good:
        return []
    found = loaded(run, record)
    canvas = drawn(found, SMALL) if small else drawn(found)
    return [embedded([lines_of(canvas, "loaded", found.caption)], found.caption)]
