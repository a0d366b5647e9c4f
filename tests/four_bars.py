"""Four-bar linkages by their lengths."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt


def four_bar(lengths: tuple[float, float, float], ground: float, angle: float = math.pi / 2) -> kt.Model:
    """Crank, rod and rocker between A and D on the ground, with the rod above."""
    a, b, c = lengths
    B, D = a * np.array([math.cos(angle), math.sin(angle)]), np.array([ground, 0.0])
    far = float(np.linalg.norm(D - B))
    along = (far**2 + b**2 - c**2) / (2 * far)
    u = (D - B) / far
    C = B + along * u + math.sqrt(b**2 - along**2) * np.array([-u[1], u[0]])
    return kt.Model(
        nodes={"A": (0, 0), "B": tuple(B), "C": tuple(C), "D": tuple(D)}, fixed={"A": "xy", "D": "xy"},
        bars={"crank": ("A", "B"), "rod": ("B", "C"), "rocker": ("D", "C")}, drives={"motor": kt.AngleDrive("crank")},
        loads={"F": kt.NodalForce(node="C", force=(0, -100))}, gravity=(0, 0),
    )  # fmt: skip
