"""How results look, defined in one place: numbers with units, colours, tables, the frame of a page."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.display.html import POLICY, Markup, element, html_page, joined
from kinetruss.display.numbers import DIGIT, POINT, aligned, counted, instant, margin, number, quantity, round_up, scale, ticks
from kinetruss.display.tables import Table
from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.display.palettes import (
        COLOURS,
        DIVERGING,
        DRIVEN,
        ELASTIC,
        KINDS,
        LOAD,
        MISSING,
        OVER,
        SEQUENTIAL,
        SKINS,
        THEMES,
        colours_of,
        contrast,
        limits_of,
        rgb,
    )

__all__ = [
    "COLOURS", "DIGIT", "DIVERGING", "DRIVEN", "ELASTIC", "KINDS", "LOAD", "MISSING", "OVER", "POINT", "POLICY",
    "SEQUENTIAL", "SKINS", "THEMES",
    "Markup", "Table", "aligned", "colours_of", "contrast", "counted", "element", "html_page", "instant", "joined", "limits_of",
    "margin", "number", "quantity", "rgb", "round_up", "scale", "ticks",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "palettes": "COLOURS DIVERGING DRIVEN ELASTIC KINDS LOAD MISSING OVER SEQUENTIAL SKINS THEMES colours_of contrast "
        "limits_of rgb"
    },
)
