"""How results look, defined in one place: numbers with units, colours, tables, the frame of a page."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.display.html import POLICY, Markup, element, html_page, joined
from kinetruss.display.numbers import instant, number, quantity, scale
from kinetruss.display.tables import Table
from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.display.palettes import (
        COLOURS,
        DIVERGING,
        KINDS,
        MISSING,
        OVER,
        SEQUENTIAL,
        SKINS,
        colours_of,
        limits_of,
        rgb,
    )

__all__ = [
    "COLOURS", "DIVERGING", "KINDS", "MISSING", "OVER", "POLICY", "SEQUENTIAL", "SKINS", "Markup", "Table",
    "colours_of", "element", "html_page", "instant", "joined", "limits_of", "number", "quantity", "rgb", "scale",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__, {"palettes": "COLOURS DIVERGING KINDS MISSING OVER SEQUENTIAL SKINS colours_of limits_of rgb"}
)
