"""DXF of a model in a pose: a line for each bar, points at supports."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.exchange._needed import needed
from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["write_dxf"]

LAYERS = {"rigid": "bars", "driven": "active", "elastic": "elastic", "cable": "cables", "free": "free"}
METRES = 6
"""Number of the metre in $INSUNITS."""


def write_dxf(path: Path, model: Model, x: NDArray[np.float64]) -> list[LeftOut]:
    """Write lines on layers by what the bars do (``bars``, ``active``, ``bodies``, ...), names as texts at their middles, and
    points on ``support`` at fixed nodes; lengths in m. x (n, 3).
    """
    ezdxf = needed("ezdxf", "exchange")
    document: Any = ezdxf.new("R2010", units=METRES)
    space = document.modelspace()
    place = {name: k for k, name in enumerate(model.nodes)}
    driven = model.driven_members
    for name, member in model.members.items():
        a, b = (x[place[node]] for node in member.ends)
        brace = getattr(member, "brace", False)
        layer = "active" if name in driven else "bodies" if brace else LAYERS[getattr(member, "kind", "rigid")]
        space.add_line(a.tolist(), b.tolist(), dxfattribs={"layer": layer})
        if not brace:
            height = 0.02 * float(((b - a) @ (b - a)) ** 0.5)
            text = re.sub(r"[\x00-\x1f]", " ", name)
            space.add_text(text, height=height, dxfattribs={"layer": layer, "insert": ((a + b) / 2).tolist()})
    for name in model.fixed:
        space.add_point(x[place[name]].tolist(), dxfattribs={"layer": "support"})
    document.saveas(path)
    left = [LeftOut("fixed", name, f"is held along {axes} only; a point marks it") for name, axes in model.fixed.items()
            if len(axes) < model.dim]  # fmt: skip
    for table in ("beams", "membranes", "solids"):
        left += [LeftOut(table, name, "only bars are drawn") for name in getattr(model, table)]
    return left
