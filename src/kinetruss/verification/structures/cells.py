"""Cells: closed forms of gimbal poses against the general solver, counts of every cell by rank."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

import kinetruss as kt

BASE, LONGERON = 1.2192, 0.889
ANGLES = np.radians([-40.0, -20.0, 0.0, 20.0, 40.0])
HEIGHTS = (0.55, 0.75, 0.9)
"""Of one bay, m: all angles are reachable at all of them."""

HALF = {"H1": ("H1.N1", "H1.N2", "H1.N3"), "H2": ("H2.N7", "H2.N9", "H2.N8")}
ONE = {"H1": ("N1", "N2", "N3"), "H2": ("N7", "N9", "N8")}


def gimbal(bays: int) -> dict[str, float]:
    """Largest difference between the wanted pose of a grid over the workspace, and that of the nodes which the solver finds."""
    cells = kt.library.cells
    short: dict[str, Any] = {"base_length": 0.2, "tube_length": 0.1}
    cell = cells.double_octahedron(**short) if bays == 1 else cells.quadruple_octahedron(**short)
    model, corners = cells.stack([cell]), ONE if bays == 1 else HALF
    places = {name: k for k, name in enumerate(model.nodes)}
    low, high = ([places[name] for name in side] for side in corners.values())
    worst = np.zeros(3)
    for beta, gamma, height in product(ANGLES, ANGLES, HEIGHTS):
        wanted = np.array([beta, gamma, bays * height])
        lengths = kt.kinematics.chain_lengths(BASE, LONGERON, beta, gamma, bays * height, bays=bays)
        x = kt.kinematics.assemble(model, dict(zip(model.active, lengths.tolist(), strict=True)))
        worst = np.maximum(worst, np.abs(_pose(x[low], x[high]) - wanted))
        back = np.array(kt.kinematics.chain_pose(BASE, LONGERON, lengths))
        worst = np.maximum(worst, np.abs(back - wanted))
    return dict(zip(("beta", "gamma", "height"), worst.tolist(), strict=True))


def _pose(low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
    """beta, gamma, height of a top triangle over a base in the xy plane."""
    x, y, z = np.cross(high[1] - high[0], high[2] - high[0])
    rise = high.mean(axis=0) - low.mean(axis=0)
    return np.array([np.arctan2(-y, z), np.arctan2(-x, np.hypot(y, z)), np.sqrt(rise @ rise)])


def share(beta: float, gamma: float, bays: int) -> dict[str, float]:
    """Angles of each of equal bays (degrees) that give these angles of the top, from its lengths."""
    lengths = kt.kinematics.chain_lengths(BASE, LONGERON, np.radians(beta), np.radians(gamma), bays * 1.1, bays)
    one, other, _ = kt.kinematics.gimbal_pose(BASE, LONGERON, lengths[:3])
    return {"beta": float(np.degrees(one)), "gamma": float(np.degrees(other))}


def count(name: str) -> dict[str, float]:
    """Nodes, members, freedoms besides those of a rigid body, and states of self-stress of a free cell, drives held."""
    cells = kt.library.cells
    cell = getattr(cells, name)()
    found = kt.kinematics.mobility(cells.stack([cell], fixed=()))
    rigid = 6 if found.system.dim == 3 else 3
    internal = found.undriven - rigid
    return {"nodes": len(cell.nodes), "members": len(cell.members), "freedoms": internal, "self_stress": found.self_stress}
