"""Bars of a drawing that meet where no node is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from kinetruss.model import Bar

__all__ = ["unjoined"]

MOST = 20
"""Largest number of crossings that are named."""
LARGEST_DRAWING = 5000
"""Lines; each is compared with those near it."""


def unjoined(places: Mapping[str, Any], bars: Mapping[str, Bar], near: float) -> list[str]:
    """Notes on lines that cross, or touch another between its ends, without a node there: their bars pass each other."""
    from scipy.spatial import cKDTree

    if len(bars) < 2:
        return []
    if len(bars) > LARGEST_DRAWING:
        return [f"not checked for lines that meet without a node: more than {LARGEST_DRAWING:,} lines"]
    names = list(bars)
    a, b = (np.array([places[bars[name].ends[k]] for name in names]) for k in (0, 1))
    middle, half = (a + b) / 2, np.linalg.norm(b - a, axis=1) / 2
    tree, found = cKDTree(middle), []
    for i, name in enumerate(names):
        for j in tree.query_ball_point(middle[i], half[i] + float(half.max()) + near):
            if j <= i or set(bars[name].ends) & set(bars[names[j]].ends):
                continue
            if (place := _crossing(a[i], b[i], a[j], b[j], near)) is not None:
                found.append(f"{name} and {names[j]} at ({', '.join(f'{round(float(x), 12) + 0.0:.6g}' for x in place)}) m")
        if len(found) > MOST:
            break
    if not found:
        return []
    more = [f"  {text}" for text in found[:MOST]] + ["  and more"] * (len(found) > MOST)
    head = "lines that meet between their ends are not joined; break them where they meet if they are to be:"
    return [head, *more]


def _crossing(a: Any, b: Any, c: Any, d: Any, near: float) -> Any:
    """The point where two segments come nearer than `near`, between the ends of one of them; None without."""
    u, v, w = b - a, d - c, a - c
    uu, uv, vv, uw, vw = u @ u, u @ v, v @ v, u @ w, v @ w
    det = uu * vv - uv * uv
    if det <= 1e-12 * uu * vv:
        return None  # parallel
    s = min(1.0, max(0.0, (uv * vw - vv * uw) / det))
    t = min(1.0, max(0.0, (uv * s + vw) / vv))
    s = min(1.0, max(0.0, (uv * t - uw) / uu))
    place = a + s * u
    return place if float(np.linalg.norm(place - c - t * v)) <= near else None
