"""The robots as nodes and bars: kinetruss with a compiled force for the robot's drives, and what is compared at the end."""

from __future__ import annotations

import math

import numpy as np
from _robots import END, RATES
from numba import njit

import kinetruss as kt

NODES = list(kt.library.mechanisms.robot().nodes)
B, C, E, G, H, J, U, X = (3 * NODES.index(name) for name in "BCEGHJUX")


@njit
def _twist(x, f, foot, node, ux, uy, uz, moment):
    """A moment across an arm, as two forces at its ends."""
    rx, ry, rz = x[node] - x[foot], x[node + 1] - x[foot + 1], x[node + 2] - x[foot + 2]
    share = moment / (rx * rx + ry * ry + rz * rz)
    for k, push in ((0, uy * rz - uz * ry), (1, uz * rx - ux * rz), (2, ux * ry - uy * rx)):
        f[node + k] += share * push
        f[foot + k] -= share * push


@njit
def _unit(x, a, b):
    ux, uy, uz = x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]
    size = math.sqrt(ux * ux + uy * uy + uz * uz)
    return ux / size, uy / size, uz / size


@njit
def pushes(t, x, _, f):
    """Lift, swing, shoulder, reach and wrist: forces along two bars, couples about three axes."""
    f[B + 2] += 3550.0 + 200.0 * math.sin(4.0 * t)
    _twist(x, f, B, X, 0.0, 0.0, 1.0, 60.0 * math.cos(3.0 * t))
    ux, uy, uz = _unit(x, B, C)
    shoulder = -60.0 + 60.0 * math.sin(6.0 * t)
    _twist(x, f, B, E, ux, uy, uz, shoulder)
    _twist(x, f, B, X, ux, uy, uz, -shoulder)
    ux, uy, uz = _unit(x, G, H)
    wrist = 78.0 + 15.0 * math.cos(5.0 * t)
    _twist(x, f, G, U, ux, uy, uz, wrist)
    _twist(x, f, G, J, ux, uy, uz, -wrist)
    ux, uy, uz = _unit(x, B, G)
    reach = -80.0 + 60.0 * t
    for k, u in ((0, ux), (1, uy), (2, uz)):
        f[G + k] += reach * u
        f[B + k] -= reach * u


def robot(rtol: float):
    """A simulation that is set up, over 0.8 s."""
    model = kt.library.mechanisms.robot(rates=tuple(float(rate) for rate in RATES))
    tasks = dict.fromkeys(model.all_drives, kt.Free())
    return kt.dynamics.prepare(model, END, tasks=tasks, user_force=pushes, method=kt.DOP853(rtol=rtol, atol=rtol))


def robot_coordinates(x: np.ndarray) -> np.ndarray:
    """Lift, swing, shoulder, reach, wrist of the places of all nodes (n, 3), m and rad."""
    at = {name: x[NODES.index(name)] for name in "BCEGHJUX"}
    arm = at["X"] - at["B"]
    return np.array([
        at["B"][2], math.atan2(arm[1], arm[0]), _angle(at["C"] - at["B"], arm, at["E"] - at["B"]),
        np.linalg.norm(at["G"] - at["B"]), _angle(at["H"] - at["G"], at["J"] - at["G"], at["U"] - at["G"]),
    ])  # fmt: skip


def _angle(axis: np.ndarray, start: np.ndarray, end: np.ndarray) -> float:
    u = axis / np.linalg.norm(axis)
    return math.atan2(u @ np.cross(start, end), start @ end - (u @ start) * (u @ end))
