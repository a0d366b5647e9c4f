"""Colours of pages, pictures and films, defined in one place, and units and colours for the viewer's page.

A colour has one meaning: green is driven, violet a load, blue compression, orange tension, red over capacity, grey not known.
Categories: Wong (2011), Nature Methods 8, 441. SEQUENTIAL: viridis (Smith and van der Walt, 2015). Contrast: WCAG 2.2, 1.4.3
and 1.4.11 (W3C, 2023): 4.5 for text, 3 for graphics.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import numbers
from kinetruss.display.numbers import round_up
from kinetruss.display.symbols import SUPPORTS

if TYPE_CHECKING:
    from numpy.typing import NDArray


COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
"""Colours of curves, in their order."""
DIVERGING = ("#053a7a", "#2b7bba", "#8fc1e3", "#d4d4d4", "#f2b279", "#d9662b", "#8c2d04")
"""Colour scale from compression to tension."""
SEQUENTIAL = ("#482878", "#3e4a89", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725")
"""Colour scale from zero to the largest value."""
DRIVEN, LOAD, ELASTIC = "#009e73", "#9429ff", "#c66b9d"
"""Colours of what a drive moves, of loads, and of springs."""
MISSING, OVER = "#8a8a8a", "#e3003a"
"""Colours for missing values, and for values above the capacity."""
KINDS = {
    "rigid": "#7a8ea3",
    "driven": DRIVEN,
    "active": DRIVEN,
    "elastic": ELASTIC,
    "beam": ELASTIC,
    "cable": "#d99a00",
    "free": "#8d98a4",
    "frame": "#8d98a4",
}
"""Colours of bars without a value, by kind."""
SKINS = {"membrane": "#9fb6cc", "solid": "#c2b59b"}
"""Colours of faces without a value, by kind."""
THEMES = {
    "light": {
        "back": "#f7f8fa", "card": "#ffffff", "ink": "#1d242b", "faint": "#5d6873", "line": "#d5dbe1", "accent": "#0b62a8",
        "pressed": "#dcebf7", "halo": "#a86400", "alarm": "#c40032", "outline": "#3a444e", "node": "#5b6672",
        "support": "#56606b", "grid": "#8a949e", "body": "#a9b6c3", "edge": "#2b333b",
        "pen-1": "#0072b2", "pen-2": "#c24e00", "pen-3": "#00795a",
    },
    "dark": {
        "back": "#14181d", "card": "#1d232a", "ink": "#e3e8ee", "faint": "#9aa6b2", "line": "#38424d", "accent": "#6db5f0",
        "pressed": "#24405a", "halo": "#ffb000", "alarm": "#ff8095", "outline": "#7d8894", "node": "#aab4bf",
        "support": "#97a3af", "grid": "#8a949e", "body": "#5d6a77", "edge": "#0b0e11",
        "pen-1": "#56b4e9", "pen-2": "#f08b47", "pen-3": "#2fc796",
    },
}  # fmt: skip
"""Colours of the page in light and dark; ``outline`` is the rim of members, which keeps pale and dark ones visible."""


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
    """Ends of the colour scale for the given values: round numbers; of utilisation always 0 and 1."""
    if scale in ("capacity", "margin"):
        return 0.0, 1.0
    known = np.abs(values[np.isfinite(values)])
    largest = round_up(float(known.max(initial=0.0)))
    return (-largest, largest) if scale == "diverging" else (0.0, largest)


def contrast(one: str, other: str) -> float:
    """Contrast ratio of two colours, 1 to 21 (WCAG 2.2: relative luminance of sRGB).

    >>> round(contrast("#ffffff", "#000000"), 1)
    21.0
    """
    light = []
    for colour in (one, other):
        share = rgb(colour) / 255
        linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
        light.append(float(linear @ [0.2126, 0.7152, 0.0722]))
    return (max(light) + 0.05) / (min(light) + 0.05)


# The units, colours and symbols of this package as a JavaScript module for the viewer's page.

NUMBERS = ("UNITS", "FLOORS", "DIGITS", "LONG", "SHORT", "ROUND_OFF", "DIGIT", "POINT", "ENDS", "FAR")
PALETTES = ("COLOURS", "DIVERGING", "SEQUENTIAL", "MISSING", "OVER", "LOAD", "ELASTIC", "KINDS", "SKINS", "THEMES")
HEAD = "// Written from src/kinetruss/display by `make viewer`: change it there.\n"


def script() -> str:
    """Text of ``viewer-src/src/display.js``: the tables of units, the colours, the symbols of supports."""
    tables = {name: getattr(numbers, name) for name in NUMBERS} | {name: globals()[name] for name in PALETTES}
    tables["SUPPORTS"] = SUPPORTS
    lines = [f"export const {name} = {json.dumps(table, ensure_ascii=False)};" for name, table in tables.items()]
    return HEAD + "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(script(), encoding="utf-8")
