"""Gimbal angles, lengths and chained tilts of double-octahedral bays against independent figures."""

from __future__ import annotations

import numpy as np

import kinetruss as kt

INCH = 0.0254
BASE = 48 * INCH


def lengths_of(beta: float, longeron: float, height: float) -> dict[str, float]:
    """Lengths of the active members for a pure beta tilt (degrees)."""
    found = kt.kinematics.gimbal_lengths(BASE, longeron * INCH, np.radians(beta), 0.0, height)
    return dict(zip(("M7", "M9", "M11"), found.tolist(), strict=True))


def pose_of(lengths: tuple[float, float, float], longeron: float) -> dict[str, float]:
    """beta (degrees) and height (m) that three lengths belong to."""
    beta, _, height = kt.kinematics.gimbal_pose(BASE, longeron * INCH, lengths)
    return {"beta": float(np.degrees(beta)), "height": float(height)}


def tip_of(bays: int, beta: float, gamma: float) -> dict[str, float]:
    """Angles (degrees) of the top of a chain, all bays alike, from the positions at the end of a slew."""
    model = kt.library.vgt.double_octahedral(bays)
    b, g = np.radians(beta), np.radians(gamma)
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(bays, beta=(0.0, b), gamma=(0.0, g)), times=np.array([0.0, 1.0]))
    seven, eight, nine = (motion.position.sel(node=f"B{bays}.N{k}").values[-1] for k in (7, 8, 9))
    normal = np.cross(nine - seven, eight - seven)
    x, y, z = normal / np.linalg.norm(normal)
    angles = {"tip_beta": np.arctan2(-y, z), "tip_gamma": np.arcsin(-x), "tilt": np.arccos(z)}
    return {name: np.degrees(angle) for name, angle in angles.items()}
