"""Colours of pages, pictures and films, defined in one place; colour-blind readers can distinguish them.

Categories: Wong (2011), Nature Methods 8, 441. SEQUENTIAL: viridis (Smith and van der Walt, 2015).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["COLOURS", "DIVERGING", "KINDS", "MISSING", "OVER", "SEQUENTIAL", "SKINS", "colours_of", "limits_of", "rgb"]

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
"""Colours of curves, in their order."""
DIVERGING = ("#053a7a", "#2b7bba", "#8fc1e3", "#d4d4d4", "#f2b279", "#d9662b", "#8c2d04")
"""Colour scale from compression to tension."""
SEQUENTIAL = ("#482878", "#3e4a89", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725")
"""Colour scale from zero to the largest value."""
MISSING, OVER = "#8a8a8a", "#e5007d"
"""Colours for missing values, and for values above the capacity."""
KINDS = {
    "rigid": "#7f93a8",
    "driven": "#009e73",
    "active": "#009e73",
    "elastic": "#cc79a7",
    "beam": "#cc79a7",
    "cable": "#d99a00",
    "free": "#b0b7bf",
    "frame": "#b0b7bf",
}
"""Colours of bars without a value, by kind."""
SKINS = {"membrane": "#9fb6cc", "solid": "#c2b59b"}
"""Colours of faces without a value, by kind."""


def rgb(colour: str) -> NDArray[np.float64]:
    """A colour as (3,), 0 to 255."""
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)], float)


def colours_of(scale: str, values: NDArray[Any], limits: Sequence[float]) -> NDArray[np.uint8]:
    """Colours (n, 3), 0 to 255, of values (n,) on a ``diverging``, ``sequential``, ``capacity`` or ``margin`` scale."""
    table = np.array([rgb(one) for one in (DIVERGING if scale == "diverging" else SEQUENTIAL)])
    low, high = limits
    place = np.clip((np.nan_to_num(values) - low) / ((high - low) or 1.0), 0, 1) * (len(table) - 1)
    left = np.minimum(place.astype(int), len(table) - 2)
    part = (place - left)[:, None]
    found = (1 - part) * table[left] + part * table[left + 1]
    if scale in ("capacity", "margin"):
        found[values > 1] = rgb(OVER)
    found[np.isnan(values)] = rgb(MISSING)
    shades: NDArray[np.uint8] = found.round().astype(np.uint8)
    return shades


def limits_of(scale: str, values: NDArray[Any]) -> tuple[float, float]:
    """Ends of the colour scale for the given values."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    if scale == "diverging":
        largest = max(abs(low), abs(high)) or 1.0
        return -largest, largest
    if scale in ("capacity", "margin"):
        return (
            0.0,
            high if 0 < high <= 0.5 else 1.0,
        )  # if utilisation is low everywhere, the scale shows differences instead of one colour
    return 0.0, high or 1.0
