"""The Delta robot: three arms, six rods, a platform that never turns."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np

from kinetruss.library._builder import builder
from kinetruss.library._placing import bars_between, leg_angle, places, point, refuse, turned_about
from kinetruss.model import AngleDrive, Bar, Free, GravityVector, Length, Mass, Model, Node, PositiveLength, Quintic, Run

__all__ = ["delta"]

LIFT = -0.3
"""Angles of all arms in the run ``move``, rad."""
CORNERS = ("1a", "1b", "2a", "2b", "3a", "3b")
"""Corners of the platform in order: arm and side."""
SIDES = {"a": -1, "b": 1}
"""Bars of the plane of an arm."""


@builder("mechanisms.delta")
def delta(
    *,
    base: PositiveLength = 0.2,
    arm: PositiveLength = 0.35,
    rod: PositiveLength = 0.8,
    platform: PositiveLength = 0.09,
    at: tuple[Length, Length, Length] = (0.0, 0.0, -0.75),
    arm_mass: Mass = 0.6,
    rod_mass: Mass = 0.08,
    platform_mass: Mass = 0.5,
    arm_apex: PositiveLength = 0.06,
    platform_apex: PositiveLength = 0.05,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    title: str = "Delta robot",
) -> Model:
    """Three arms that turn about fixed axes, each with two parallel rods to a platform: 45 bars, 66 coordinates, 18 fixed.

    Arm k is at the azimuth 0, 120, 240 deg. Its nodes: ``Aka``, ``Akb`` on the fixed axis, ``Bka``, ``Bkb`` at the
    elbow, ``Ck`` off the plane of the four (a flat rectangle would be stiff only to second order). Rods run from ``Bka``,
    ``Bkb`` to the corners ``Pka``, ``Pkb`` of the platform, a regular hexagon; ``Q`` below its centre makes it a body
    of seven nodes and 15 bars: six sides, six spokes, three short diagonals. With three long diagonals instead, the number of
    bars is the same but the rank is 14: six points on a conic, joined as two threes (Bolker & Roth 1980).

    Drives ``arm1``, ``arm2``, ``arm3`` are the angles of the arms, positive below the horizontal; run ``move`` lifts the
    platform, run ``fall`` releases it.

    Parameters
    ----------
    base : distance of the arms' axes from the centre, m. arm, rod : lengths, m. platform : circumradius of the hexagon, m;
        the rods of a pair are half of it to either side.
    at : centre of the hexagon at the start, m, z up.
    arm_mass : of each arm, as two uniform bars A-B, kg. rod_mass : of each of the six rods, kg. platform_mass : in six equal
        parts at the corners, kg.
    arm_apex, platform_apex : distance of the nodes C and Q from their planes, m.
    gravity : m/s^2; None for none.

    Notes
    -----
    Three degrees of freedom: the platform moves along x, y and z. Angle t of an arm:
    2 L (a cos t - z sin t) = |d|^2 + L^2 - l^2 with d = (a, s, z) from the arm's axis to the middle of its side of the
    platform, in the arm's own directions.

    Raises
    ------
    ModelError : faults of the parameters; a position that a rod does not reach.

    Source
    ------
    R. Clavel, Delta, a fast robot with parallel geometry, 18th Int. Symp. on Industrial Robots (1988) 91-100. The sizes and
    masses are an example, not those of a product.

    Examples
    --------
    >>> model = delta(at=(0.05, -0.08, -0.75))
    >>> len(model.bars), len(model.nodes), [round(x, 6) for x in model.nodes["B1a"].at]
    (45, 22, [0.542793, -0.045, -0.070663])
    """
    places_of: dict[str, Any] = {}
    bars: dict[str, Bar] = {}
    drives, moves = {}, {}
    for k in range(3):
        R = turned_about(2, 2 * math.pi * k / 3)
        angle = _arm_angle(R, at, (base, arm, rod, platform), k + 1)
        places_of |= _arm(R, angle, base, arm, platform / 2, arm_apex, k + 1)
        places_of |= {f"P{k + 1}{s}": np.array(at) + R @ _corner(platform, s) for s in SIDES}
        bars |= _arm_bars(k + 1, arm_mass, rod_mass)
        drives[f"arm{k + 1}"] = AngleDrive(f"A{k + 1}a-B{k + 1}a", axis=point(R[:, 1]), reference=point(R[:, 0]))
        moves[f"arm{k + 1}"] = (angle, angle + LIFT)
    places_of["Q"] = np.array(at) - (0, 0, platform_apex)
    bars |= bars_between(_platform_bars())
    corners = {f"P{name}" for name in CORNERS}
    nodes = {
        name: Node(at=place, mass=platform_mass / 6 if name in corners else 0.0) for name, place in places(places_of).items()
    }
    return Model(
        title=title,
        nodes=nodes,
        fixed=[name for name in nodes if name.startswith("A")],
        bars=bars,
        gravity=gravity,
        drives=drives,
        runs={
            "move": Run(trajectory=Quintic(moves=moves, duration=0.5)),
            "fall": Run(analysis="dynamics.simulate", t_end=0.15, tasks=dict.fromkeys(drives, Free())),
        },
    )


def _corner(platform: float, side: str) -> Any:
    """Corners of the hexagon, from its centre, in the directions of the arm."""
    return np.array([platform * math.sqrt(3) / 2, SIDES[side] * platform / 2, 0.0])


def _arm_angle(R: Any, at: tuple[float, float, float], sizes: tuple[float, float, float, float], arm: int) -> float:
    """Angle of an arm below the horizontal, rad."""
    base, length, rod, platform = sizes
    x, y, z = R.T @ np.array(at)
    angle = leg_angle(x + platform * math.sqrt(3) / 2 - base, -z, y, length, rod)
    if angle is None:
        raise refuse("at", f"arm {arm} does not reach {tuple(at)} m.", "Move the platform nearer, or lengthen arm or rod.")
    return angle


def _arm(R: Any, angle: float, base: float, arm: float, half: float, apex: float, k: int) -> dict[str, Any]:
    """Nodes of an arm; C is off the middle of A and B, on the upper side."""
    out = np.array([math.cos(angle), 0.0, -math.sin(angle)])
    up = np.array([math.sin(angle), 0.0, math.cos(angle)])
    a, b = np.array([base, 0.0, 0.0]), np.array([0.0, half, 0.0])
    found = {
        f"{node}{k}{s}": R @ (a + far * out + sign * b) for node, far in (("A", 0.0), ("B", arm)) for s, sign in SIDES.items()
    }
    return found | {f"C{k}": R @ (a + arm / 2 * out + apex * up)}


def _arm_bars(k: int, arm_mass: float, rod_mass: float) -> dict[str, Bar]:
    """Eight bars of an arm (its axis lies between two fixed nodes and has none) and its two rods."""
    a, b, c = (f"A{k}a", f"A{k}b"), (f"B{k}a", f"B{k}b"), f"C{k}"
    return (
        bars_between(zip(a, b, strict=True), mass=arm_mass / 2)
        | bars_between([b, (a[0], b[1]), *((c, each) for each in (*a, *b))])
        | bars_between([(f"B{k}{s}", f"P{k}{s}") for s in SIDES], mass=rod_mass)
    )


def _platform_bars() -> list[tuple[str, str]]:
    """Sides, spokes and short diagonals."""
    corners = [f"P{name}" for name in CORNERS]
    short = [(f"P{name}", f"P{other}") for name, other in pairwise(("1a", "2a", "3a", "1a"))]
    return [*pairwise([*corners, corners[0]]), *(("Q", corner) for corner in corners), *short]
