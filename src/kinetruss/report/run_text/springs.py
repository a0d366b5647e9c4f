"""Springs of a run in the tables: largest forces and moments, and where they act."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import Table, instant, quantity
from kinetruss.model import Spring, turns

if TYPE_CHECKING:
    from kinetruss.runs import RunResult

__all__ = ["spring_loads", "springs_text"]

HEAD = ("spring", "force or moment", "at value", "time", "load case")
MOST = 12
"""Largest number of printed springs."""


def spring_loads(run: RunResult) -> list[dict[str, Any]]:
    """Largest force (N) or moment (N m) of every spring and load case, its time (s) and the coordinate there (m or rad)."""
    found = []
    for case, forces in run.forces.items():
        if "spring_force" not in forces.data or not forces.data.sizes["time"]:
            continue
        time, push, value = (forces.data[name].values for name in ("time", "spring_force", "spring_value"))
        for k, name in enumerate(map(str, forces.data["spring"].values)):
            at = int(np.argmax(np.abs(push[:, k])))
            found.append(
                {
                    "spring": name,
                    "angle": _turns(run.model.springs[name]),
                    "load": float(push[at, k]),
                    "value": float(value[at, k]),
                    "time": float(time[at]),
                    "load_case": case,
                }
            )
    return found


def springs_text(found: Sequence[Mapping[str, Any]]) -> list[str]:
    """The table as text, the largest forces first."""
    rows = sorted((one for one in found if one["load"]), key=lambda one: -abs(one["load"]))
    if not rows:
        return []
    more = f"\nand {len(rows) - MOST} more" if len(rows) > MOST else ""
    return [f"Springs (largest values of the motion)\n{Table(HEAD, map(_cells, rows[:MOST])).text}{more}"]


def _cells(one: Mapping[str, Any]) -> tuple[str, ...]:
    units = ("N m", "rad") if one["angle"] else ("N", "m")
    return (
        one["spring"],
        quantity(one["load"], units[0]),
        quantity(one["value"], units[1]),
        instant(one["time"]),
        one["load_case"],
    )


def _turns(spring: Spring) -> bool:
    """Whether its first coordinate is an angle."""
    return turns(spring.parts[0][0])
