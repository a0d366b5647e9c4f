"""Text of table cells."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sized
from typing import Any

from kinetruss.display import Markup, instant, margin, quantity
from kinetruss.report.document._bars import bar

__all__ = [
    "MOST",
    "at",
    "bars_of",
    "cased",
    "exceeds",
    "is_over",
    "is_single",
    "left_out",
    "margin_of",
    "named",
    "percents",
    "share_of",
    "used_of",
    "value_of",
]

MOST = 40
"""Largest number of rows of a table; the data in the page have all."""
BEYOND = 1.5
ROUND_OFF = 1e-9
"""Utilisation below which it counts as zero; excess over a limit, and margin, that count as none."""


def named(case: str) -> str:
    """A load case as text."""
    return "all loads" if case == "all" else case


def cased(case: str) -> str:
    """A load case within a sentence."""
    return "all loads" if case == "all" else f"load case {case}"


def percents(rows: Iterable[dict[str, Any]], key: str = "utilisation") -> list[str]:
    """Utilisations of a column as percentages, all with one decimal."""
    shares = [value_of(row[key]) for row in rows]
    return ["-" if math.isnan(one) else "∞" if math.isinf(one) else f"{100 * one:.1f}" for one in shares]


def is_single(record: Mapping[str, Any]) -> bool:
    """True for results of one position: they have no times."""
    return bool(record["samples"]["good"] == 1 and "what" not in record["samples"])


def at(time: float | None) -> str:
    """An instant as text."""
    return instant(time)


def value_of(value: Any) -> float:
    """A number from a record: NaN for None, infinity for its text."""
    return math.nan if value is None else float(value)


def share_of(value: Any) -> str:
    """A utilisation as text."""
    share = value_of(value)
    return quantity(0.0 if abs(share) < ROUND_OFF else share, "%")


def used_of(value: Any) -> str:
    """A utilisation within a sentence."""
    return f"{share_of(value)} of what is allowed"


def margin_of(row: dict[str, Any]) -> str:
    """A margin as text, if there is a demand."""
    used = value_of(row["utilisation"])
    if used < ROUND_OFF or math.isinf(used):
        return "-"
    left = value_of(row["margin"])
    return margin(0.0 if abs(left) < ROUND_OFF else left)


def is_over(row: dict[str, Any]) -> bool:
    """True if a limit is exceeded by more than round-off."""
    return exceeds(value_of(row["utilisation"]))


def exceeds(utilisation: float) -> bool:
    """True if a utilisation is above 1 by more than round-off: a drive held at its limit does not exceed it."""
    return utilisation > 1 + ROUND_OFF


def bars_of(rows: Iterable[dict[str, Any]]) -> list[Markup]:
    """Utilisations as bars on one scale: up to the limit, or 1.5 times the limit if one exceeds it."""
    shares = [value_of(row["utilisation"]) for row in rows]
    most = BEYOND if any(share > 1 for share in shares) else 1.0
    return [bar(share, most) for share in shares]


def left_out(entries: Sized) -> str:
    """The note on rows that a table does not show."""
    left = len(entries) - MOST
    return f"{left} more are in the data of this page. " if left > 0 else ""
