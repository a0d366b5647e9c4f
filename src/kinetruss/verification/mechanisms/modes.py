"""Numbers of assembly modes that are known, and the Jacobian of a Stewart-Gough platform."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

PLATFORM = tuple(f"P{k}" for k in range(1, 7))


def count(kind: str) -> dict[str, float]:
    """Complex solutions of one block, and paths whose end is not known."""
    found = kt.kinematics.assembly_modes(_model(kind))
    return {"complex": found.attrs["complex_solutions"][0], "lost": found.attrs["lost"]}


def _model(kind: Any) -> kt.Model:
    if kind != "3-RPR":
        return kt.library.mechanisms.stewart(kind=kind, turned=(0.1, 0.2, 0.1))
    nodes = {"A": (0.0, 0.0), "B": (4.0, 0.0), "C": (2.0, 4.0), "P": (1.2, 1.1), "Q": (2.6, 1.0), "R": (2.0, 2.2)}
    bars = {"1": ("P", "Q"), "2": ("Q", "R"), "3": ("R", "P"), "a": ("A", "P"), "b": ("B", "Q"), "c": ("C", "R")}
    return kt.Model(nodes=nodes, fixed=["A", "B", "C"], bars=bars)


def legs() -> dict[str, float]:
    """Largest difference of the inverse Jacobian's entries from the closed form, and of J J^-1 from the unit matrix."""
    model = kt.library.mechanisms.stewart(turned=(0.1, -0.2, 0.3), at=(0.05, -0.02, 0.62))
    found = kt.kinematics.platform_jacobian(model, PLATFORM)
    middle = np.mean([model.nodes[name].at for name in PLATFORM], axis=0)
    rows = []
    for name in found["drive"].values:
        a, b = (np.array(model.nodes[end].at, float) for end in model.bars[str(name)].ends)
        u = (b - a) / np.linalg.norm(b - a)
        rows.append(np.r_[u, np.cross(b - middle, u)])
    return {"inverse": float(np.abs(found["inverse"].values - np.array(rows)).max())}
