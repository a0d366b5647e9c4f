"""Gimbal angles, lengths and chained tilts of double-octahedral bays against independent figures."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from typing import Any

import numpy as np

from kinetruss import kinematics
from kinetruss.library import vgt
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

INCH = 0.0254
BASE = 48 * INCH


def lengths_of(beta: float, longeron: float, height: float) -> dict[str, float]:
    """Lengths of the active members for a pure beta tilt (degrees)."""
    found = kinematics.gimbal_lengths(BASE, longeron * INCH, np.radians(beta), 0.0, height)
    return dict(zip(("M7", "M9", "M11"), found.tolist(), strict=True))


def pose_of(lengths: tuple[float, float, float], longeron: float) -> dict[str, float]:
    """beta (degrees) and height (m) that three lengths belong to."""
    beta, _, height = kinematics.gimbal_pose(BASE, longeron * INCH, lengths)
    return {"beta": float(np.degrees(beta)), "height": float(height)}


def tip_of(bays: int, beta: float, gamma: float) -> dict[str, float]:
    """Angles (degrees) of the top of a chain, all bays alike, from the positions at the end of a slew."""
    model = vgt.double_octahedral(bays)
    b, g = np.radians(beta), np.radians(gamma)
    motion = kinematics.follow(model, vgt.slew(bays, beta=(0.0, b), gamma=(0.0, g)), times=np.array([0.0, 1.0]))
    seven, eight, nine = (motion.position.sel(node=f"B{bays}.N{k}").values[-1] for k in (7, 8, 9))
    normal = np.cross(nine - seven, eight - seven)
    x, y, z = normal / np.linalg.norm(normal)
    angles = {"tip_beta": np.arctan2(-y, z), "tip_gamma": np.arcsin(-x), "tilt": np.arccos(z)}
    return {name: float(np.degrees(angle)) for name, angle in angles.items()}


def cases() -> Iterator[Case]:
    """Each figure to half a unit of its last digit."""
    data = load("derived")
    source, poses = Reference("independent", data["source"]), data["poses"]
    for one in poses["lengths"]:
        for name in ("M7", "M9", "M11"):
            given = (one["beta"], one["longeron_in"], one["height"])
            yield _case(f"pose.beta={one['beta']:g}deg.{name}", source, one[name], 6, lengths_of, given)
    for one in poses["angles"]:
        for name, digits in (("beta", 3), ("height", 4)):
            if name in one:
                label = f"pose.M7={one['lengths'][0]}.longeron={one['longeron_in']:g}in.{name}"
                yield _case(label, source, one[name], digits, pose_of, (tuple(one["lengths"]), one["longeron_in"]))
    yield _case("pose.level.height", source, poses["level_height"], 7, pose_of, ((1.1684,) * 3, 35.0))
    for one in poses["chains"]:
        for name in ("tip_beta", "tip_gamma", "tilt"):
            if name in one:
                label = f"pose.chain.{one['beta']:.4g}deg.{one['gamma']:.4g}deg.{name}"
                digits = 3 if name == "tilt" else 4 if one["beta"] == 10 else 7
                yield _case(label, source, one[name], digits, tip_of, (one["bays"], one["beta"], one["gamma"]))


def _case(
    label: str, source: Reference, expected: float, digits: int, make: Callable[..., Any], arguments: tuple[Hashable, ...]
) -> Case:
    """Good to half a unit of the given decimal (a little more: the figure's own rounding)."""
    name = label.rsplit(".", 1)[1]
    return Case(label, source, expected, 0.51 * 10.0**-digits / abs(expected), make, arguments, (name,))
