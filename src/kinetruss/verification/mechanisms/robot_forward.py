"""The robot of five freedoms under given forces, against Lagrange's equations in its five coordinates."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Free
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

SOURCE = Reference(
    "independent", "Lagrange's equations in five coordinates, substitute data (own; the handbook's are not public)"
)
NAMES = ("lift", "swing", "shoulder", "reach", "wrist")
START = (-0.3, 0.8, 0.5, 0.2, -1.0)
END = {
    0.2: (1.4448668350467202, 0.5585120738372124, 0.0153655289717462, 0.9490645044738542, 0.37673560086571634),
    0.4: (1.4135408674533878, 0.7083409706571652, 0.7111907083549615, 1.0178092868158781, 0.42441039133177233),
    0.6: (1.4056560739045565, 0.8445266116429292, 1.6080128956241693, 1.128501328165815, 0.9416131604261408),
    0.8: (1.4009915808357993, 0.9580814887134403, 2.167377712192491, 1.2917929326437128, 1.9963469433491754),
}
RATES = (-0.08672297302064215, 0.48909345610224425, 1.8077618949559882, 0.80755894335451, 5.775444171279861)
"""At 0.8 s, m/s and rad/s."""


def pushes(t: float, x: Any, _: Any) -> dict[str, Any]:
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


NODES = tuple(mechanisms.robot().nodes)


def _pull(force: dict[str, Any], node: str, foot: str, pull: Any) -> None:
    force[node] += pull
    force[foot] -= pull


def _twist(force: dict[str, Any], at: dict[str, Any], node: str, foot: str, moment: Any) -> None:
    """A moment across an arm, as two forces at its ends."""
    arm = at[node] - at[foot]
    _pull(force, node, foot, np.cross(moment, arm) / (arm @ arm))


def run() -> dict[float, dict[str, float]]:
    """The five coordinates at the four instants, and their rates at the last."""
    found = dynamics.simulate(
        mechanisms.robot(rates=START),
        0.8,
        times=(0.0, *END),
        tasks=dict.fromkeys(mechanisms.robot().all_drives, Free()),
        user_force=pushes,
        method=DOP853(rtol=1e-11, atol=1e-12),
    )
    data = found.motion.data
    return {float(t): coordinates(data.sel(time=t)) for t in data.time.values}


def coordinates(now: Any) -> dict[str, float]:
    """Lift, swing, shoulder, reach, wrist and their rates, from places and velocities of nodes."""
    at = {name: now.position.sel(node=name).values for name in "BCXEGHJU"}
    v = {name: now.velocity.sel(node=name).values for name in "BCXEGHJU"}
    along = (at["G"] - at["B"]) / np.linalg.norm(at["G"] - at["B"])
    upright = np.array([0.0, 0.0, 1.0])
    swing = _angle(upright, np.array([1.0, 0.0, 0.0]), at["X"] - at["B"])
    found = {
        "lift": at["B"][2],
        "swing": swing,
        "shoulder": _angle(at["C"] - at["B"], at["X"] - at["B"], at["E"] - at["B"]),
        "reach": float(np.linalg.norm(at["G"] - at["B"])),
        "wrist": _angle(at["H"] - at["G"], at["J"] - at["G"], at["U"] - at["G"]),
        "lift rate": v["B"][2],
        "reach rate": along @ (v["G"] - v["B"]),
        "swing rate": _rate(upright, at["X"] - at["B"], v["X"] - v["B"]),
    }
    return {name: float(value) for name, value in found.items()}


def _angle(axis: Any, start: Any, end: Any) -> float:
    u = axis / np.linalg.norm(axis)
    return math.atan2(u @ np.cross(start, end), start @ end - (u @ start) * (u @ end))


def _rate(axis: Any, arm: Any, speed: Any) -> float:
    return float(axis @ np.cross(arm, speed) / (arm @ arm))


def cases() -> Iterator[Case]:
    """Angles and lengths to 1e-10 over 0.8 s."""
    for t, values in END.items():
        for name, value in zip(NAMES, values, strict=True):
            yield Case(f"robot.forward.{t}s.{name}", SOURCE, value, 1e-10, run, (), (t, name), 1.0)
    for k, name in ((0, "lift"), (1, "swing"), (3, "reach")):
        yield Case(f"robot.forward.0.8s.{name}_rate", SOURCE, RATES[k], 1e-9, run, (), (0.8, f"{name} rate"), 1.0)
