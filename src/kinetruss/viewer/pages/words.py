"""Numbers and words of a legend, as in the page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

__all__ = ["heading", "number", "scale", "ticks"]

PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def scale(largest: float, unit: str) -> tuple[float, str]:
    """Factor and unit with the prefix that puts the largest value between 1 and 1000."""
    if not unit or not abs(largest) > 1e-12 or not math.isfinite(largest):
        return 1.0, unit
    power = 3 * math.floor(math.log10(abs(largest) * (1 + 1e-9)) / 3)
    power = max(-9, min(0 if unit[0] in "ms" else 9, power))
    return 10.0**-power, PREFIXES[power] + unit


def number(value: float, digits: int = 3) -> str:
    """A number with some significant digits."""
    if math.isnan(value):
        return "–"
    if not math.isfinite(value):
        return "∞" if value > 0 else "−∞"
    decimals = 0 if value == 0 else max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{value:.{min(decimals, 12)}f}".replace("-", "−")


def heading(channel: dict[str, Any], limits: Sequence[float]) -> str:
    """What is coloured, with its unit."""
    unit = scale(limits[1], channel["unit"])[1]
    return f"{channel['label']}{f' ({unit})' if unit else ''}"


def ticks(channel: dict[str, Any], limits: Sequence[float]) -> list[str]:
    """Five numbers from the low to the high end; margins of stability are 1/utilisation - 1."""
    low, high = limits
    values = [low + part * (high - low) for part in (0, 0.25, 0.5, 0.75, 1)]
    if channel["scale"] == "margin":
        return [number(1 / value - 1 if value > 0 else math.inf, 2) for value in values]
    factor = scale(high, channel["unit"])[0]
    return [number(value * factor if abs(value) > 1e-12 * abs(high) else 0.0) for value in values]


def ends(channel: dict[str, Any], limits: Sequence[float], single: bool = False) -> tuple[str, str]:
    """Words at the two ends. single : of one instant alone."""
    high = channel["high"]
    if single and high == "largest of the run":
        high = "largest"
    if limits[1] < 1 and channel["scale"] in ("capacity", "margin"):
        high = "most used here"
    return channel["low"], high
