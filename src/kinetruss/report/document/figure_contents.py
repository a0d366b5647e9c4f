"""What the figure of a report shows: one instant of a run, with loads as arrows and their values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, number
from kinetruss.mechanics import compile
from kinetruss.mechanics.loads import case_loads
from kinetruss.report.document.result import governing_entry
from kinetruss.report.tables import cased, is_over, share_of, value_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.model import Model
    from kinetruss.runs import RunResult

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
