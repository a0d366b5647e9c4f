"""Limits that two drives share, and the nearest of two corners of a region out of reach."""

from __future__ import annotations

import kinetruss as kt


def shared_rate() -> dict[str, float]:
    """Two slides in a row with largest rates 0.3 and 0.6 m/s take their end 1 m on in 2 s: the least common excess."""
    slides = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, fixed={"A": "xy", "B": "y", "C": "y"},
        bars={"a": kt.Bar(ends=("A", "B"), kind="driven"), "b": kt.Bar(ends=("B", "C"), kind="driven")},
    )  # fmt: skip
    task = kt.Coordinates(moves={"C.x": 3.0}, duration=2.0, rate={"a": 0.3, "b": 0.6})
    return {"ratio": float(kt.kinematics.inverse(slides, task).attrs["worst_ratio"])}


def nearest_corner() -> dict[str, float]:
    """A point on two actuators with strokes 0.9 ... 1.3 m and 0.5 ... 1.7 m, 1 m apart: nearest to (0.05, -0.2)."""
    a, b = 1.0, 1.6
    x = 0.5 * (a**2 - b**2 + 1)
    rods = {"base": kt.Part(length=0.3, mass=1.0), "tube": kt.Part(length=0.3, mass=1.0)}
    jib = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (x, (a**2 - x**2) ** 0.5)}, fixed=["A", "B"],
        active={"a": kt.Active(ends=("A", "C"), limits=(0.9, 1.3), **rods),
                "b": kt.Active(ends=("B", "C"), limits=(0.5, 1.7), **rods)},
    )  # fmt: skip
    found = kt.kinematics.reach(jib, kt.Positioning(node="C", moves={"x": 0.05, "y": -0.2}))
    place = found.position.sel(node="C").values[0]
    return {"x": float(place[0]), "y": float(place[1])}
