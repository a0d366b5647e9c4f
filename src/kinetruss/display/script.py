"""The units and colours of this package as a JavaScript module for the viewer's page."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from kinetruss.display import numbers, palettes

__all__ = ["script"]

NUMBERS = ("UNITS", "FLOORS", "DIGITS", "LONG", "SHORT", "ROUND_OFF", "DIGIT", "POINT", "ENDS", "FAR")
PALETTES = ("COLOURS", "DIVERGING", "SEQUENTIAL", "MISSING", "OVER", "LOAD", "ELASTIC", "KINDS", "SKINS", "THEMES")
HEAD = "// Written from src/kinetruss/display by `make viewer`: change it there.\n"


def script() -> str:
    """Text of ``viewer-src/src/display.js``: the tables of units and the colours."""
    tables = {name: getattr(numbers, name) for name in NUMBERS} | {name: getattr(palettes, name) for name in PALETTES}
    lines = [f"export const {name} = {json.dumps(table, ensure_ascii=False)};" for name, table in tables.items()]
    return HEAD + "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(script(), encoding="utf-8")
