"""A flyball governor whose rods are thin bodies, and its equations in three coordinates: turn, spread, slider."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

import kinetruss as kt
from kinetruss.library import bodies

__all__ = ["AXIAL", "governor", "reference", "seen"]

DENSITY, WIDTH, BALL, G, TILT, RATE, SPRING, REST = 3000.0, 0.01, 5.0, 9.81, math.pi / 6, 2 * math.pi, 8e5, 0.5
ROD, SLIDER = DENSITY * WIDTH**2, 3.0
AXIAL = ROD * WIDTH**2 / 6
"""Moment of inertia of a rod about its own line, kg m^2."""


def rod(model: kt.Model, name: str, way: np.ndarray, nodes: list[str], axial: float | None) -> kt.Model:
    """A rod of 1 m hung up at T, with its hinge along z; `axial`, kg m^2, its moment of inertia about its own line."""
    axes = np.array([np.cross(way, [0, 0, 1]), way, [0, 0, 1]])
    at = np.array([0.0, 1.0, 0.0]) + 0.5 * way
    given = bodies.box_properties((WIDTH, 1.0, WIDTH), density=DENSITY, at=tuple(at), axes=axes)
    if axial is not None:
        across = ROD * (1 + WIDTH**2) / 12
        given = bodies.MassProperties(mass=ROD, center=at, inertia=axes.T @ np.diag([across, axial, across]) @ axes)
    return bodies.rigid(model, name, given, nodes=nodes)


def governor(damping: float, axial: float | None = None) -> kt.Model:
    """Shaft O-T, rods T-R and T-L with balls at their ends, springs from their middles to the slider S on the shaft."""
    top, nodes = np.array([0.0, 1.0, 0.0]), {"O": (0, 0, 0), "T": (0, 1, 0), "H": (0, 1, 0.1)}
    low = 1 - 2 * 0.5 * math.cos(TILT)
    model = kt.Model(nodes=nodes | {"S": kt.Node(at=(0, low, 0), mass=SLIDER)}, fixed={"O": "xyz", "T": "xyz", "S": "xz"},
                     gravity=(0, -G, 0))  # fmt: skip
    model = bodies.box(model, "shaft", (WIDTH, 1.0, WIDTH), density=DENSITY, at=(0, 0.5, 0), nodes=["O", "T", "H"])
    for end, side in (("R", 1.0), ("L", -1.0)):
        way = np.array([side * math.sin(TILT), -math.cos(TILT), 0.0])
        more = {end: kt.Node(at=tuple(top + way), mass=BALL), f"M{end}": tuple(top + 0.5 * way)}
        model = model.with_(nodes={**model.nodes, **more})
        model = rod(model, f"rod{end}", way, ["T", "H", f"M{end}", end], axial)
        spring = kt.Bar(ends=("S", f"M{end}"), kind="elastic", stiffness=SPRING, damping=damping, natural_length=REST)
        model = model.with_(bars={**model.bars, f"spring{end}": spring})
    held = ("O", "T", "S")
    velocities = {n: (RATE * node.at[2], 0.0, -RATE * node.at[0]) for n, node in model.nodes.items() if n not in held}
    return model.with_(velocities=velocities)


def reference(t: np.ndarray, damping: float, axial: float) -> np.ndarray:
    """Turn, spread and height of the slider at t (s), (3, t), from Lagrange's equations."""
    along, around = ROD * (1 / 3 + WIDTH**2 / 12) + BALL, ROD * WIDTH**2 / 6

    def rates(_, y):
        _, a, s, turning, opening, v = y
        dx, dy = 0.5 * math.sin(a), 1 - 0.5 * math.cos(a) - s
        length = math.hypot(dx, dy)
        by_a, by_s = (dx * 0.5 * math.cos(a) + dy * 0.5 * math.sin(a)) / length, -dy / length
        pull = SPRING * (length - REST) + damping * (by_a * opening + by_s * v)
        inertia = around + 2 * (along * math.sin(a) ** 2 + axial * math.cos(a) ** 2)
        change = 4 * (along - axial) * math.sin(a) * math.cos(a)
        spread = (0.5 * change * turning**2 - 2 * G * (ROD / 2 + BALL) * math.sin(a) - 2 * pull * by_a) / (2 * along)
        return [turning, opening, v, -change * opening * turning / inertia, spread, -G - 2 * pull * by_s / SLIDER]

    start = [0.0, TILT, 1 - math.cos(TILT), RATE, 0.0, 0.0]
    tight = {"method": "Radau", "rtol": 1e-11, "atol": 1e-13} if damping else {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    return solve_ivp(rates, (0.0, t[-1]), start, t_eval=t, **tight).y[:3]


def seen(run: kt.results.Simulation) -> np.ndarray:
    """The same three from a simulation."""
    x, y, z = run.motion.position.sel(node="R").values.T
    slider = run.motion.position.sel(node="S", axis="y").values
    return np.array([np.unwrap(np.arctan2(-z, x)), np.arctan2(np.hypot(x, z), 1 - y), slider])
