"""Text and numbers of a legend, as in the page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from kinetruss.display import number, quantity, scale

__all__ = ["ends", "heading", "ticks"]


def heading(channel: dict[str, Any], limits: Sequence[float]) -> str:
    """The heading: the coloured quantity with its unit."""
    unit = scale(limits[1], channel["unit"])[1]
    return f"{channel['label']}{f' ({unit})' if unit else ''}"


def ticks(channel: dict[str, Any], limits: Sequence[float]) -> list[str]:
    """Five numbers from the low to the high end; buckling margins are 1/utilisation - 1."""
    low, high = limits
    values = [low + part * (high - low) for part in (0, 0.25, 0.5, 0.75, 1)]
    if channel["scale"] == "margin":
        return [number(1 / value - 1 if value > 0 else math.inf, 2) for value in values]
    factor = scale(high, channel["unit"])[0]
    return [number(value * factor if abs(value) > 1e-12 * abs(high) else 0.0, 3) for value in values]


def ends(channel: dict[str, Any], largest: float, single: bool = False) -> tuple[str, str]:
    """Texts at the two ends. largest : value that is shown, below the end of the scale; single : of one instant only."""
    high = channel["high"]
    if high == "largest of the run":
        high = f"largest {'' if single else 'of the run '}{quantity(largest, channel['unit'])}"
    return channel["low"], high
