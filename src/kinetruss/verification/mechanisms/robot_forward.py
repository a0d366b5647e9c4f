"""The robot of five freedoms under given forces, against Lagrange's equations in its five coordinates."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

START = (-0.3, 0.8, 0.5, 0.2, -1.0)
"""Rates of lift, swing, shoulder, reach and wrist, m/s and rad/s."""
TIMES = (0.2, 0.4, 0.6, 0.8)


def given_forces(t: float, x: Any, _: Any) -> dict[str, Any]:
    """Forces of the drives on the nodes, N: along the lift and the reach, and as couples at the three hinges."""
    at = dict(zip(NODES, x, strict=True))
    force = {name: np.zeros(3) for name in ("A", "B", "G", "X", "E", "J", "U")}
    force["B"] += (0.0, 0.0, 3550 + 200 * math.sin(4 * t))
    along = (at["G"] - at["B"]) / np.linalg.norm(at["G"] - at["B"])
    _pull(force, "G", "B", (-80 + 60 * t) * along)
    _twist(force, at, "X", "B", np.array([0.0, 0.0, 60 * math.cos(3 * t)]))
    axis = (at["C"] - at["B"]) / np.linalg.norm(at["C"] - at["B"])
    for node, sign in (("E", 1.0), ("X", -1.0)):
        _twist(force, at, node, "B", sign * (-60 + 60 * math.sin(6 * t)) * axis)
    axis = (at["H"] - at["G"]) / np.linalg.norm(at["H"] - at["G"])
    for node, sign in (("U", 1.0), ("J", -1.0)):
        _twist(force, at, node, "G", sign * (78 + 15 * math.cos(5 * t)) * axis)
    return force


NODES = tuple(kt.library.mechanisms.robot().nodes)


def _pull(force: dict[str, Any], node: str, foot: str, tension: Any) -> None:
    force[node] += tension
    force[foot] -= tension


def _twist(force: dict[str, Any], at: dict[str, Any], node: str, foot: str, moment: Any) -> None:
    """A moment across an arm, as two forces at its ends."""
    arm = at[node] - at[foot]
    _pull(force, node, foot, np.cross(moment, arm) / (arm @ arm))


def run() -> dict[str, dict[str, float]]:
    """The five coordinates at the four instants, and their rates at the last."""
    found = kt.dynamics.simulate(
        kt.library.mechanisms.robot(rates=START),
        0.8,
        times=(0.0, *TIMES),
        tasks=dict.fromkeys(kt.library.mechanisms.robot().all_drives, kt.Free()),
        user_force=given_forces,
        method=kt.DOP853(rtol=1e-11, atol=1e-12),
    )
    return {f"{t}s": coordinates(found.motion.data.sel(time=t)) for t in TIMES}


def coordinates(now: Any) -> dict[str, float]:
    """Lift, swing, shoulder, reach, wrist and their rates, from places and velocities of nodes."""
    at = {name: now.position.sel(node=name).values for name in "BCXEGHJU"}
    v = {name: now.velocity.sel(node=name).values for name in "BCXEGHJU"}
    along = (at["G"] - at["B"]) / np.linalg.norm(at["G"] - at["B"])
    upright = np.array([0.0, 0.0, 1.0])
    swing = _angle(upright, np.array([1.0, 0.0, 0.0]), at["X"] - at["B"])
    return {
        "lift": at["B"][2],
        "swing": swing,
        "shoulder": _angle(at["C"] - at["B"], at["X"] - at["B"], at["E"] - at["B"]),
        "reach": float(np.linalg.norm(at["G"] - at["B"])),
        "wrist": _angle(at["H"] - at["G"], at["J"] - at["G"], at["U"] - at["G"]),
        "lift_rate": v["B"][2],
        "reach_rate": along @ (v["G"] - v["B"]),
        "swing_rate": _rate(upright, at["X"] - at["B"], v["X"] - v["B"]),
    }


def _angle(axis: Any, start: Any, end: Any) -> float:
    u = axis / np.linalg.norm(axis)
    return math.atan2(u @ np.cross(start, end), start @ end - (u @ start) * (u @ end))


def _rate(axis: Any, arm: Any, speed: Any) -> float:
    return float(axis @ np.cross(arm, speed) / (arm @ arm))
