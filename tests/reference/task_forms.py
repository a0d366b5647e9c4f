"""Closed forms of tasks with limits, SI."""

from __future__ import annotations

import math

__all__ = ["tasks"]


def tasks() -> dict[str, float]:
    """Peak of a quintic of 1 m in 2 s over the sum of two largest rates; where two circles of least lengths meet."""
    a, b = 0.9, 0.5
    x = (a * a - b * b + 1) / 2
    return {
        "tasks.limits.ratio": 15 / 8 * 1.0 / 2.0 / (0.3 + 0.6),
        "tasks.nearest.x": x,
        "tasks.nearest.y": math.sqrt(a * a - x * x),
    }
