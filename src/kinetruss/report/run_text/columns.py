"""Tables of a run without the columns that say nothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinetruss.display import Table

__all__ = ["IDLE", "telling"]

IDLE = {"load case": "all", "of it by motion": "-"}
"""Column -> the cell that says nothing, if all are equal to it."""


def telling(head: Sequence[str], rows: Sequence[Sequence[str]], idle: Mapping[str, str] = IDLE) -> str:
    """The table as text, without columns whose cells are all idle.

    >>> print(telling(("member", "force", "load case"), [("M1", "58.3 N", "all")]))
    member   force
    M1      58.3 N
    """
    kept = [k for k, name in enumerate(head) if name not in idle or any(row[k] != idle[name] for row in rows)]
    return Table([head[k] for k in kept], [[row[k] for k in kept] for row in rows]).text
