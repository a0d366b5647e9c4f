"""Tables of a run without the columns that say nothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kinetruss.display import Table, instant

__all__ = ["IDLE", "moment", "poses_of", "telling"]

IDLE = {"load case": "all", "of it by motion": "-"}
"""Column -> the cell that says nothing, if all are equal to it."""


def poses_of(run: Any) -> list[str]:
    """Names of the poses of a run at rest; empty for a motion, whose samples have times."""
    data = run.motion.data
    return [str(name) for name in data["pose"].values] if "pose" in data.coords else []


def moment(time: float, poses: Sequence[str]) -> str:
    """When a value is found: the name of a pose, whose time is its number, or the time.

    >>> moment(1.0, ["low", "high"]), moment(0.5, [])
    ('pose high', 't = 0.5 s')
    """
    return f"pose {poses[round(time)]}" if poses and time == time else f"t = {instant(time)}"


def telling(head: Sequence[str], rows: Sequence[Sequence[str]], idle: Mapping[str, str] = IDLE) -> str:
    """The table as text, without columns whose cells are all idle.

    >>> print(telling(("member", "force", "load case"), [("M1", "58.3 N", "all")]))
    member   force
    M1      58.3 N
    """
    kept = [k for k, name in enumerate(head) if name not in idle or any(row[k] != idle[name] for row in rows)]
    return Table([head[k] for k in kept], [[row[k] for k in kept] for row in rows]).text
