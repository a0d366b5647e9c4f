"""Cells of tables in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sized
from typing import Any

from kinetruss.display import Markup, instant, number, quantity
from kinetruss.report.document._bars import bar

__all__ = [
    "MOST",
    "at",
    "bars_of",
    "counted",
    "is_over",
    "left_out",
    "long",
    "margin_of",
    "named",
    "share_of",
    "station_of",
    "value_of",
]

MOST = 40
"""Rows of a table; the data in the page hold all."""
BEYOND = 1.5
ROUND_OFF = 1e-9
"""Utilisation that is none."""


def named(case: str) -> str:
    """A load case in words."""
    return "all loads" if case == "all" else case


def at(time: float | None) -> str:
    """An instant."""
    return instant(time)


def station_of(row: dict[str, Any]) -> str:
    """Where along the member."""
    position = value_of(row["position"])
    return quantity(position, "m")


def value_of(value: Any) -> float:
    """A number of a record as it was: NaN from None, infinity from its text."""
    return math.nan if value is None else float(value)


def share_of(value: Any) -> str:
    """A utilisation; an infinite one is beyond the buckling load."""
    share = value_of(value)
    return quantity(0.0 if abs(share) < ROUND_OFF else share, "%")


def margin_of(row: dict[str, Any]) -> str:
    """A margin, where there is a demand at all."""
    used = value_of(row["utilisation"])
    return "-" if used < ROUND_OFF else number(value_of(row["margin"]), 3)


def is_over(row: dict[str, Any]) -> bool:
    """True where a limit is exceeded."""
    return value_of(row["utilisation"]) > 1


def bars_of(rows: Iterable[dict[str, Any]]) -> list[Markup]:
    """Utilisations as bars, all to one scale: to the limit, or to half as much again where one is beyond it."""
    shares = [value_of(row["utilisation"]) for row in rows]
    most = BEYOND if any(share > 1 for share in shares) else 1.0
    return [bar(share, most) for share in shares]


def long(value: float, unit: str) -> str:
    """A value of a drive, with as many digits as a length needs."""
    return quantity(value, unit, 6)


def counted(count: int, noun: str) -> str:
    """How many of a thing."""
    return f"{count or 'no'} {noun}{'' if count == 1 else 's'}"


def left_out(entries: Sized) -> str:
    """What a table does not show."""
    left = len(entries) - MOST
    return f"{left} more are in the data of this page. " if left > 0 else ""
