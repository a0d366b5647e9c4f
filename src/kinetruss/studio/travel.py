"""Converts key frames to a motion and a run, and finds the worst instants of the run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import runs
from kinetruss.errors import InputError
from kinetruss.model import Model, Quintic, Run, Spline
from kinetruss.studio.poses import number

if TYPE_CHECKING:
    from kinetruss.runs import RunResult
    from kinetruss.studio.commands import KeyFrame


NAME = "studio"
"""Name of the trajectory and of the run made from key frames."""

MOST = 4_000_000
"""Largest product of samples and members of a run from a page."""


def way_of(frames: Sequence[KeyFrame], start: Mapping[str, float]) -> Quintic | Spline:
    """The trajectory through key frames; drives that a frame does not name keep the value of the previous frame.

    Two frames: a quintic move from rest to rest. More: a spline through all of them (with three, and the points half-way
    between them).
    """
    ordered = sorted(frames, key=lambda frame: frame.time)
    if len(ordered) < 2:
        raise InputError("Set at least two key frames, at different times.")
    times = [frame.time - ordered[0].time for frame in ordered]
    if any(b - a < 1e-6 for a, b in pairwise(times)):
        raise InputError("Two key frames have the same time. Give them different times.")
    rows, last = [], dict(start)
    for frame in ordered:
        last = last | {name: value for name, value in frame.values.items() if name in start}
        rows.append(last)
    if len(rows) == 2:
        return Quintic(moves={name: (rows[0][name], rows[1][name]) for name in start}, duration=times[1])
    t = np.array(times)
    if len(t) == 3:
        t = np.insert(t, [1, 2], (t[:-1] + t[1:]) / 2)
    values = {name: tuple(np.interp(t, times, [row[name] for row in rows]).tolist()) for name in start}
    return Spline(times=tuple(t.tolist()), values=values, largest_gap=1e9)


def with_way(model: Model, way: Quintic | Spline, samples: int) -> Model:
    """The model with the key frames as a trajectory and a run, both called ``studio``."""
    run = Run(trajectory=NAME, samples=samples)
    return model.with_(trajectories={**model.trajectories, NAME: way}, runs={**model.runs, NAME: run})


def travelled(model: Model, frames: Sequence[KeyFrame], start: Mapping[str, float], samples: int) -> RunResult:
    """The run of key frames: motion, forces of all load cases, margins, motor demand."""
    if not start:
        raise InputError("This model has no drive that could follow key frames.")
    if samples * len(model.members) > MOST:
        raise InputError(f"{samples} samples of {len(model.members)} members are too many here. Take fewer samples.")
    return runs.run(with_way(model, way_of(frames, start), samples), NAME)


def worst_rows(result: RunResult, most: int = 12) -> list[dict[str, Any]]:
    """The worst instants of a run: rule, member, utilisation and time; highest utilisation first."""
    rows: list[dict[str, Any]] = []
    if result.verdict is not None:
        rows += [
            {
                "what": row.rule,
                "member": row.member,
                "used": _share(row.utilisation),
                "value": number(row.value),
                "unit": row.unit,
                "time": number(row.time),
                "case": row.load_case,
            }
            for row in result.verdict.table()
            if row.checked
        ]
    for case, demand in result.demand.items():
        data = demand.data
        for k, name in enumerate(data["active"].values):
            for q, what in enumerate(data["quantity"].values):
                used = float(data["utilisation"].values[k, q])
                if np.isfinite(used):
                    value, time = number(data["value"].values[k, q]), number(data["time_of"].values[k, q])
                    rows.append(
                        {
                            "what": str(what),
                            "member": str(name),
                            "used": used,
                            "value": value,
                            "unit": str(data["unit"].values[q]),
                            "time": time,
                            "case": case,
                        }
                    )
    rows.sort(key=lambda row: -float(row["used"]))
    return rows[:most] + _largest(result)


def _share(used: float) -> float | str:
    """A utilisation for JSON; it is infinite above Euler's load."""
    return used if np.isfinite(used) else "Infinity"


def _largest(result: RunResult) -> list[dict[str, Any]]:
    """Largest tension and compression, and the pose nearest to a singularity."""
    found = []
    for case, forces in result.forces.items():
        N = forces.arrays["member_force"].values
        for what, at in (("largest tension", N.argmax()), ("largest compression", N.argmin())):
            t, k = np.unravel_index(at, N.shape)
            found.append(
                {
                    "what": what,
                    "member": str(forces.arrays["member"].values[k]),
                    "used": None,
                    "value": float(N[t, k]),
                    "unit": "N",
                    "time": float(forces.arrays["time"].values[t]),
                    "case": case,
                }
            )
    gauge = result.motion.arrays["singularity"].values
    if np.isfinite(gauge).any():
        weak = int(np.nanargmin(gauge))
        found.append(
            {
                "what": "nearest to singular",
                "member": "",
                "used": None,
                "value": float(gauge[weak]),
                "unit": "",
                "time": float(result.motion.arrays["time"].values[weak]),
                "case": "",
            }
        )
    return found
