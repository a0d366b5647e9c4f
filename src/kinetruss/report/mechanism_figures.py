"""The pictures of what a mechanism does: paths of nodes, angles of members, transmission, quantities of the model."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.report.mechanism_data import angle_histories, driver, member_turns, moves, node_paths
from kinetruss.report.pictures.specs import Drawing, Figure, Histories, Panel
from kinetruss.report.pictures.stands import drawing, projected, shown_at
from kinetruss.viewer.scenes import snapshots

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.runs import RunResult

    Array = NDArray[np.float64]

CURVES = 6
ALIKE = 1e-9
"""Difference of two curves, as a share of the larger, below which they are drawn as one."""
WIDTH = 130.0
"""Of the picture of paths, mm."""


def mechanism_figures(run: RunResult) -> Iterator[Figure]:
    """Paths, angles and angular velocities, speeds, quantities; none of a run without a motion."""
    yield from quantity_figures(run)
    if not moves(run):
        return
    rows = member_turns(run)
    yield from _angles(run, [row["member"] for row in rows])
    paths = [row["node"] for row in sorted(node_paths(run), key=lambda row: -row["path"])]
    if paths:
        yield path_figure(run, _apart(run, paths))
        yield speed_figure(run, _apart(run, paths), "speeds")


def path_figure(run: RunResult, nodes: Sequence[str], name: str = "paths") -> Drawing:
    """The mechanism at the start with the paths of nodes."""
    scene = snapshots(run, case=next(iter(run.forces), None), samples=[0])
    data = run.motion.whole
    place = {str(one): k for k, one in enumerate(data["node"].values)}
    whose = f"Path{'s' if len(nodes) > 1 else ''} of {', '.join(nodes)}"
    return drawing(
        scene,
        shown_at(scene, [""], "iso", loads=False),
        width=WIDTH,
        name=name,
        title=f"{whose}; the mechanism at the start",
        ways=[projected(data["position"].values[:, place[one]]) for one in nodes],
    )


def speed_figure(run: RunResult, nodes: Sequence[str], name: str, *, places: bool = False) -> Histories:
    """Speeds and accelerations of nodes, with `places` also their coordinates."""
    data = run.motion.whole
    place = {str(one): k for k, one in enumerate(data["node"].values)}
    panels = []
    if places:
        axes = [str(axis) for axis in data["axis"].values]
        single = len(nodes) == 1
        lines = {
            (axis if single else f"{node} {axis}"): data["position"].values[:, place[node], k]
            for node in nodes
            for k, axis in enumerate(axes)
        }
        panels.append(Panel(quantity="position", unit="m", lines=lines))
    for what, unit, key in (("speed", "m/s", "velocity"), ("acceleration", "m/s^2", "acceleration")):
        lines = {node: np.linalg.norm(data[key].values[:, place[node]], axis=1) for node in nodes}
        panels.append(Panel(quantity=what, unit=unit, lines=lines))
    whose = ", ".join(nodes)
    title = f"Position, speed and acceleration of {whose}" if places else f"Speed and acceleration of {whose}"
    return Histories(name=name, title=title, time=data["time"].values, panels=tuple(panels))


def turn_figure(run: RunResult, members: Sequence[str], name: str) -> Histories:
    """Angles and angular velocities of members, and their ratios to the rate of the one drive."""
    series, time = angle_histories(run, members), run.motion.whole["time"].values
    panels = [
        Panel(quantity=what, unit=unit, lines={one: series[i][k] for i, one in enumerate(members)})
        for k, (what, unit) in enumerate((("angle", "rad"), ("angular velocity", "rad/s")))
    ]
    return Histories(name=name, title=f"Angle and angular velocity of {', '.join(members)}", time=time, panels=tuple(panels))


def quantity_figures(run: RunResult) -> Iterator[Histories]:
    """The quantities of the model, a panel for each unit, with their limits where one quantity has them."""
    for case, data in run.quantities.items():
        if "time" not in data.coords or data.sizes["time"] < 2 or "pose" in data.coords:
            continue
        units: dict[str, list[int]] = {}
        for k, unit in enumerate(map(str, data["quantity_unit"].values)):
            if np.isfinite(data["value"].values[:, k]).any():
                units.setdefault(unit, []).append(k)
        panels = []
        for unit, own in units.items():
            names = [str(data["quantity"].values[k]) for k in own]
            words = names[0] if len(names) == 1 else "quantities"
            for first in range(0, len(own), CURVES):
                lines = {str(data["quantity"].values[k]): data["value"].values[:, k] for k in own[first : first + CURVES]}
                panels.append(Panel(quantity=words, unit=unit, lines=lines, limit=_limit(run, names)))
        if panels:
            several = len(run.quantities) > 1
            title = f"Quantities of the model{f', load case {case}' if several else ''}"
            name = f"quantities_{case}" if several else "quantities"
            yield Histories(name=name, title=title, time=data["time"].values, panels=tuple(panels))


def _limit(run: RunResult, names: Sequence[str]) -> float | None:
    """The limit of one quantity that holds in both directions alike, or in one."""
    limits = run.model.quantities[names[0]].limits if len(names) == 1 else None
    if limits is None:
        return None
    low, high = limits
    if low is None:
        return None if high is None else float(high)
    return float(high) if high is not None and high == -low else None


def _angles(run: RunResult, members: Sequence[str]) -> Iterator[Histories]:
    """Members that turn, but not those that turn as one before, or as a drive at a constant rate does."""
    series = dict(zip(members, angle_histories(run, members), strict=True)) if members else {}
    chosen: list[str] = []
    drive = driver(run)
    moved = getattr(run.model.all_drives[drive], "bar", "") if drive else ""
    for name, (_, w, _b) in series.items():
        # members of one rigid part turn alike; what is prescribed is in the picture of drives
        if name != moved and not any(_same(w, series[other][1]) for other in chosen):
            chosen.append(name)
    if chosen:
        yield turn_figure(run, chosen[:CURVES], "turning")


def _same(a: Array, b: Array) -> bool:
    return bool(np.allclose(a, b, rtol=0.0, atol=ALIKE * max(float(np.abs(a).max()), 1e-300), equal_nan=True))


def _apart(run: RunResult, nodes: Sequence[str]) -> list[str]:
    """The first nodes of those whose speeds differ."""
    data = run.motion.whole
    place = {str(one): k for k, one in enumerate(data["node"].values)}
    speeds: dict[str, Any] = {}
    for node in nodes:
        speed = np.linalg.norm(data["velocity"].values[:, place[node]], axis=1)
        if len(speeds) < CURVES and not any(_same(speed, one) for one in speeds.values()):
            speeds[node] = speed
    return list(speeds)
