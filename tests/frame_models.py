"""A portal frame of beams that tests share."""

from __future__ import annotations

import kinetruss as kt

G = 9.81
SIDE = 0.1
STEEL = kt.Material(E=210e9, density=7850.0, yield_strength=235e6)
NODES = {"A": (0, 0), "B": (0, 3), "M": (2, 3), "C": (4, 3), "D": (4, 0)}
BEAMS = {"left": ("A", "B"), "top1": ("B", "M"), "top2": ("M", "C"), "right": ("D", "C")}
LOADS = {"B": (4e3, 0.0), "M": (0.0, -12e3)}


def portal(**changes: object) -> kt.Model:
    fields = {
        "nodes": NODES,
        "clamped": ["A", "D"],
        "beams": BEAMS,
        "section": kt.Rectangle(width=SIDE, height=SIDE),
        "material": STEEL,
        "gravity": (0, -G),
        "loads": {f"on_{node}": kt.NodalForce(node=node, force=force) for node, force in LOADS.items()},
        "runs": {"load": kt.Run(analysis="statics.linear")},
    }
    return kt.Model(**fields | changes)
