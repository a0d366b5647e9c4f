"""Drives of a run without a motor in the tables: largest forces and torques, rates and powers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import instant, quantity
from kinetruss.model import turns
from kinetruss.report.run_text.columns import telling

if TYPE_CHECKING:
    from kinetruss.results import Forces
    from kinetruss.runs import RunResult

__all__ = ["drive_cells", "drive_loads", "drives_text"]

HEAD = ("drive", "force or torque", "at", "rate", "power", "load case")
MOST = 12
"""Largest number of printed drives."""


def drive_loads(run: RunResult, shown: Sequence[Mapping[str, Any]] = ()) -> list[dict[str, Any]]:
    """Largest force (N) or torque (N m), its time (s), rate (m/s, rad/s) and power (W) of every drive and load case.

    shown : rows of the table of motors, whose drives are omitted.
    """
    found, elsewhere = [], {(row["active"], row["load_case"]) for row in shown}
    for case, forces in run.forces.items():
        if not forces.data.sizes["time"]:
            continue
        time, rates = forces.data["time"].values, run.motion.data["drive_velocity"].values
        for k, name in enumerate(map(str, forces.data["drive"].values)):
            drive, push, rate = run.model.all_drives[name], forces.data["drive_force"].values[:, k], rates[:, k]
            if (getattr(drive, "bar", name) if drive.kind == "length" else name, case) in elsewhere or np.isnan(push).all():
                continue
            at = int(np.nanargmax(np.abs(push)))
            found.append(
                {
                    "drive": name,
                    "kind": drive.kind,
                    "unit": "N m" if turns(drive) else "N",
                    "load": float(push[at]),
                    "time": float(time[at]),
                    "pose": pose_at(forces, at),
                    "rate": _peak(rate),
                    "power": _peak(push * rate),
                    "load_case": case,
                }
            )
    return found


def pose_at(forces: Forces, at: int) -> str:
    """Name of the pose of a sample; empty for instants of a motion."""
    return str(forces.data["pose"].values[at]) if "pose" in forces.data.coords else ""


def drives_text(found: Sequence[Mapping[str, Any]], *, timed: bool = True) -> list[str]:
    """The table as text, for drives with a force; of one pose at rest (`timed` False) without times, rates and powers."""
    rows = [drive_cells(one) for one in found if one["load"]]
    if not rows:
        return []
    more = f"\nand {len(rows) - MOST} more" if len(rows) > MOST else ""
    if timed and any(one["pose"] for one in found):
        posed = [(name, load, pose, case) for name, load, pose, _, _, case in rows[:MOST]]
        return [f"Drives, held (largest values of the poses)\n{telling((*HEAD[:2], 'pose', HEAD[-1]), posed)}{more}"]
    if timed:
        return [f"Drives (largest values of the motion)\n{telling(HEAD, rows[:MOST])}{more}"]
    still = [(name, load, case) for name, load, _, _, _, case in rows[:MOST]]
    return [f"Drives, held\n{telling((*HEAD[:2], HEAD[-1]), still)}{more}"]


def drive_cells(one: Mapping[str, Any]) -> tuple[str, ...]:
    """A row of the table; numbers that are none may be None."""
    load, rate, power = (math.nan if one[key] is None else one[key] for key in ("load", "rate", "power"))
    per = "rad/s" if one["unit"] == "N m" else "m/s"
    return (
        one["drive"],
        quantity(load, one["unit"]),
        one["pose"] or instant(one["time"]),
        quantity(rate, per),
        quantity(power, "W"),
        one["load_case"],
    )


def _peak(values: np.ndarray) -> float:
    """The value of largest magnitude, with its sign."""
    return math.nan if np.isnan(values).all() else float(values[int(np.nanargmax(np.abs(values)))])
