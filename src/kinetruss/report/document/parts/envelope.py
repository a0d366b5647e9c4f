"""Minima and maxima over a whole run: member forces, reactions, drives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.model import turns

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["drive_spans", "envelopes", "reactions"]


def envelopes(run: RunResult) -> dict[str, list[dict[str, Any]]]:
    """Smallest and largest mean axial force (N), with times (s), by load case and member, largest magnitude first.

    ``at_rest`` is the force in the same pose at rest at the time of the larger of the two.
    """
    found: dict[str, list[dict[str, Any]]] = {}
    for case, forces in run.forces.items():
        data = forces.data
        if not data.sizes["time"]:
            continue
        time, values = data["time"].values, data["member_force"].values
        still = None if forces.static is None else forces.static.data["member_force"].values
        low, high = values.argmin(axis=0), values.argmax(axis=0)
        unsure = set(data.attrs.get("not_unique", []))
        entries = []
        for k, name in enumerate(data["member"].values.tolist()):
            least, largest = values[low[k], k], values[high[k], k]
            at = int(low[k] if -least > largest else high[k])
            entries.append(
                {
                    "member": str(name),
                    "least": float(least),
                    "least_time": float(time[low[k]]),
                    "largest": float(largest),
                    "largest_time": float(time[high[k]]),
                    "at_rest": None if still is None else float(still[at, k]),
                    "unique": name not in unsure,
                }
            )
        found[case] = sorted(entries, key=lambda entry: -max(-entry["least"], entry["largest"]))
    return found


def reactions(run: RunResult) -> list[dict[str, Any]]:
    """Force of largest magnitude on the structure (N), its time (s) and its components, by support and load case."""
    found = []
    for case, forces in run.forces.items():
        data = forces.data
        if not data.sizes["time"] or not data.sizes["support"]:
            continue
        values, time = data["reaction"].values, data["time"].values
        size = np.linalg.norm(np.nan_to_num(values), axis=2)
        axes = [str(axis) for axis in data["axis"].values]
        for k, name in enumerate(data["support"].values.tolist()):
            at = int(size[:, k].argmax())
            parts = dict(zip(axes, values[at, k].tolist(), strict=True))
            found.append(
                {
                    "support": str(name),
                    "load_case": case,
                    "magnitude": float(size[at, k]),
                    "time": float(time[at]),
                    "force": parts,
                }
            )
    return found


def drive_spans(run: RunResult) -> list[dict[str, Any]]:
    """Smallest and largest position, largest rate and acceleration of every drive; m or rad, s; limits of travel."""
    data = run.motion.data
    if not data.sizes["time"] or "drive" not in data.sizes:
        return []
    found = []
    for k, name in enumerate(map(str, data["drive"].values)):
        drive = run.model.all_drives[name]
        position, rate, acceleration = (data[f"drive_{one}"].values[:, k] for one in ("position", "velocity", "acceleration"))
        member = run.model.active.get(getattr(drive, "bar", ""))
        found.append(
            {
                "drive": name,
                "kind": drive.kind,
                "unit": "rad" if turns(drive) else "m",
                "least": float(position.min()),
                "largest": float(position.max()),
                "rate": _peak(rate),
                "acceleration": _peak(acceleration),
                "travel": None if member is None or member.limits is None else [float(one) for one in member.limits],
            }
        )
    return found


def _peak(values: Any) -> float:
    """The value of largest magnitude, with its sign."""
    return float(values[int(np.argmax(np.abs(values)))])
