"""The figures of a report: the structure at the governing instant with loads and their values, and its deflected shape."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import DRIVEN, instant, number, quantity
from kinetruss.model import Pressure
from kinetruss.model.links import bends, piece_at
from kinetruss.report.document.run_pictures import lines_of
from kinetruss.report.entries import Figure
from kinetruss.report.pictures.drawing import drawn, round_length
from kinetruss.report.pictures.labels import CROWDED, Label
from kinetruss.report.pictures.over_structure import areas, note, of_run, written
from kinetruss.report.pictures.specs import ALARM, INK, QUIET, WIDTHS, Drawing
from kinetruss.report.pictures.stands import arrows, drawing, middle, projected, stand, values_of
from kinetruss.report.run_lines import shift_of
from kinetruss.report.tables import cased, share_of, value_of
from kinetruss.strength.curves import factor_of, quantities_shown
from kinetruss.viewer.places import Places
from kinetruss.viewer.scenes import snapshots
from kinetruss.viewer.support_marks import WORDS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.report.entries import Entry
    from kinetruss.results import Row
    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]


LEAST_FORCE = 1e-9
"""Forces below this share of the largest are not drawn."""
NAMED, FEW = 40, 12
"""Number of nodes up to which their names are shown, above it those of supports and loads only; number of supports up to which
all of them are named.
"""
TALLEST, SMALL, LOW = 4.6, 2.1, 3.4
"""Largest height of the structure, inches: at most half of a sheet; in a summary; of the deflected shape."""
BESIDE, DRAWN = 2, 200
"""Number of section forces beside each other over the structure; number of beams and links up to which they are drawn."""
SHARE = 0.1
"""Size of the largest drawn displacement at most, of the structure."""


def loaded_figure(run: RunResult, record: Mapping[str, Any], *, small: bool = False) -> list[Entry]:
    """The structure at the governing instant, as part of a page; nothing without a good sample. small : for a summary."""
    if not run.good:
        return []
    figure, caption = loaded(run, record, SMALL if small else TALLEST)
    return [Figure(panels=[lines_of(drawn(figure), "loaded", caption)], caption=caption)]


def loaded(run: RunResult, record: Mapping[str, Any], tallest: float = TALLEST) -> tuple[Drawing, str]:
    """The instant of the governing entry, or of the largest member force, with the loads that act then; and its caption."""
    worst, (case, k) = run.finding.governing, _chief(run, record)
    places = Places(snapshots(run, case=case, samples=[k]))
    header, model = places.scene.header, run.model
    pairs = arrows(places, 0, least=LEAST_FORCE)
    over, labels, chief = False, [], None
    if worst is not None:
        over = worst.status == "exceeded"
        chief = None if run.finding.kind == "quantity" else _member(places, run, worst.part, getattr(worst, "position", None))
    if worst is not None and chief is not None:
        words = f"{worst.part}: {worst.rule} {share_of(worst.utilisation)}"
        labels.append(Label(words=words, at=middle(places, chief), colour=ALARM if over else INK, bold=True))
    lengths = [float(np.linalg.norm(end - start)) for start, end, _ in pairs]
    least = sorted(lengths, reverse=True)[:NAMED][-1] if lengths else 0.0
    labels += values_of(pair for pair, length in zip(pairs, lengths, strict=True) if length >= least)
    labels += [*_drives(places, chief), *_names(places)]
    gravity = np.asarray(header["gravity"], float)
    down = projected(gravity[None] / np.linalg.norm(gravity))[0] if gravity.any() else None
    seen = stand(
        places,
        arrows=[pair for *pair, _ in pairs],
        labels=labels,
        band=None if chief is None else (chief, over),
    )
    figure = drawing(places.scene, [seen], width=WIDTHS["page"], axes=(projected(np.eye(model.dim)), down), tallest=tallest)
    return figure, _caption(run, case, k, worst, over, places)


def _chief(run: RunResult, record: Mapping[str, Any]) -> tuple[str | None, int]:
    """Load case and sample of the governing entry, or of the largest member force."""
    worst, case = run.finding.governing, next(iter(run.forces), None)
    entry: Mapping[str, Any] | None = next(iter(record["largest_forces"]), None)
    if worst is not None:
        entry = {"load_case": worst.load_case, "pose": worst.pose, "time": worst.time}
    if entry is None:
        return case, 0
    return entry["load_case"] if entry["load_case"] in run.forces else case, _sample(run, entry)


def over_structure(run: RunResult, record: Mapping[str, Any]) -> list[Entry]:
    """Section forces over the structure at the governing instant, those that are not zero; nothing without beams and links that
    bend, or where nothing is known of them.
    """
    bent = sum(bends(run.model, one) for one in run.model.bending.values())
    if not run.good or not run.forces or not 0 < bent <= DRAWN:
        return []
    case, k = _chief(run, record)
    found = [of_run(run, show, case, k) for show in quantities_shown(run.model.dim) if show != "deflection"]
    found = [one for one in found if one.largest > 0]
    if not found:
        return []
    scene = snapshots(run, case=case, samples=[k])
    places, panels, stands = Places(scene), [], []
    for one in found:
        factor = factor_of([one], scene.header["extent"])
        labels, words = written(one, factor), one.quantity.words
        stands.append(stand(places, caption=words[0].upper() + words[1:], areas=areas(one, factor), labels=labels))
    for first in range(0, len(stands), BESIDE):
        pair = stands[first : first + BESIDE]
        figure = drawing(scene, pair, width=WIDTHS["page"] * len(pair) / BESIDE, tallest=LOW)
        panels.append(lines_of(drawn(figure), f"over{first}", ", ".join(one.caption for one in pair)))
    signs = ". ".join(note([one], 1.0) for one in found)
    caption = f"Section forces over the structure, {_when(run, k)}, {cased(str(case))}, each to a scale of its own. {signs}."
    return [Figure(panels=panels, caption=caption)]


def _when(run: RunResult, k: int) -> str:
    if "pose" in run.motion.whole.coords:
        return f"in pose {run.motion.whole['pose'].values[k]}"
    time = run.motion.whole["time"].values
    return f"at t = {instant(time[k])}" if len(time) > 1 else "in the computed position"


def _member(places: Places, run: RunResult, part: str, place: float | None = None) -> int | None:
    """The place among the members shown of the member that an entry is about."""
    model = run.model
    name = part if part in {*model.whole.members, *model.bending, *model.drives} else part.rpartition(".")[0]
    name = getattr(model.all_drives.get(name), "bar", name)
    if name in model.links:
        name = piece_at(model, name, place or 0.0)
    names = [places.scene.header["members"][k] for k in places.members]
    return names.index(name) if name in names else None


def _sample(run: RunResult, entry: Mapping[str, Any]) -> int:
    if entry.get("pose") and "pose" in run.motion.whole.coords:
        return int(np.flatnonzero(run.motion.whole["pose"].values == entry["pose"])[0])
    when = value_of(entry["time"])
    return 0 if np.isnan(when) else int(np.abs(run.motion.whole["time"].values - when).argmin())


def _drives(places: Places, chief: int | None) -> list[Label]:
    """Names of drives at the middle of the members that they move."""
    shown = {member: k for k, member in enumerate(places.members)}
    moved = [(one["name"], shown[one["member"]]) for one in places.scene.header["drives"]
             if one.get("member") in shown and "axis" not in one]  # fmt: skip
    return [
        Label(words=name, at=middle(places, k), colour=DRIVEN, most=CROWDED) for name, k in moved[: NAMED // 2] if k != chief
    ]


def _names(places: Places) -> list[Label]:
    """Names of nodes: of all where they are few, else of supports and loads; where those are few they stand in any case."""
    header = places.scene.header
    held = {one["node"] for one in header["supports"]}
    loads = {one["node"] for one in header["loads"] if "node" in one and not one.get("pressure")}
    used = set(places.joined)
    found = []
    for k in places.nodes:
        important = (k in held and len(held) <= NAMED) or (k in loads and len(loads) <= NAMED)
        always = (k in held and len(held) < FEW) or (k in loads and len(loads) < FEW)
        if (k in used or k in loads) and (len(used) <= NAMED or important):
            most = np.inf if always else CROWDED
            found.append(Label(words=header["nodes"][k], at=projected(places.x[k]), colour=QUIET, most=most))
    return found


def _marks(places: Places) -> list[str]:
    """The symbols of supports that a figure has, in words."""
    there = {kind for kind, *_ in places.supports}
    return [words for kind, words in WORDS.items() if kind in there]


def _caption(run: RunResult, case: str | None, k: int, worst: Row | None, over: bool, places: Places) -> str:
    model, header = run.model, places.scene.header
    words = [f"The structure {_when(run, k)}{f', {cased(case)}' if case else ''}"]
    if worst is not None and run.finding.kind == "quantity":
        words.append(f"where {worst.part} is nearest to its limit, or farthest beyond it ({share_of(worst.utilisation)})")
    elif worst is not None:
        mark = "red, over its capacity" if over else "on a broad pale band"
        words.append(f"the governing part {mark} ({worst.part}: {worst.rule} {share_of(worst.utilisation)})")
    if header["drives"]:
        words.append("driven members green")
    if held := _marks(places):
        words.append(f"supports: {', '.join(held)}")
    force = np.linalg.norm(places.scene.arrays["load_force"][0], axis=1)
    if (force > LEAST_FORCE * header["largest_load"]).any():
        pressing = ", of pressure some of them and without values" * any(one.get("pressure") for one in header["loads"])
        along = ", along members parts of the whole with its value a length" * any("span" in one for one in header["loads"])
        words.append(f"arrows: forces{pressing}{along}")
    there = {one["name"] for one in header["loads"]}
    chosen = None if case not in model.cases else model.cases[case].loads
    acting = model.loads if chosen is None else [name for name, factor in chosen.items() if factor]
    others = [name for name in acting if name not in there and not isinstance(model.loads[name], Pressure)]
    if others:
        words.append(f"not drawn: {', '.join(others)}")
    if any(header["gravity"]):
        words.append(f"gravity {number(float(np.linalg.norm(header['gravity'])))} m/s², grey arrow")
    return "; ".join(words) + "."


def deflected_figure(run: RunResult, record: Mapping[str, Any]) -> list[Entry]:
    """The figure of the load case of the governing entry; nothing for runs over time, and without displacements."""
    if run.good != 1 or not run.statics:
        return []
    named = [row["load_case"] for row in record["strength"] if row["utilisation"] is not None]
    case = next((case for case in named[:1] if case in run.statics), next(iter(run.statics)))
    shift = shift_of(run, run.statics[case])
    scene = snapshots(run)
    visible = Places(scene).nodes
    size = np.linalg.norm(shift[0][visible], axis=1) if shift is not None and shift.size and visible else np.zeros(1)
    if not size.max() > 0 or not Places(scene).lines:
        return []
    start = np.array([node.at for node in run.origin.whole.nodes.values()], float)
    extent = float(np.linalg.norm(np.ptp(start[visible], axis=0))) or 1.0
    factor = max(1.0, round_length(SHARE * extent / float(size.max())))
    rest, moved = Places(scene, x=start), Places(scene, x=start + factor * shift[0])
    farthest = visible[int(size.argmax())]
    words = f"{scene.header['nodes'][farthest]}: {quantity(float(size.max()), 'm')}"
    drawn_scale = "to scale" if factor == 1 else f"displacements {factor:g} times as large as they are"
    held = _marks(rest)
    caption = f"The deflected shape, {cased(case)}, {drawn_scale}; grey: without loads; the largest displacement is named" + (
        f"; supports: {', '.join(held)}." if held else "."
    )
    label = Label(words=words, at=projected(moved.x[farthest]), colour=INK, bold=True)
    figure = drawing(
        scene,
        [stand(moved, labels=[label])],
        width=WIDTHS["page"],
        ghost=[projected(line) for line in rest.lines],
        ways=[projected(np.array([rest.x[farthest], moved.x[farthest]]))],
        tallest=LOW,
    )
    return [Figure(panels=[lines_of(drawn(figure), "deflected", caption)], caption=caption)]
