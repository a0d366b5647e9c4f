"""Where the nodes of a double-octahedral bay stand, in plain NumPy: for building models, which must not need Numba.

Lacy (1991), chapter 4; symbols and node numbers as in `kernels.motion.gimbal`, which holds the same closed form with rates.
"""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.record import Floats

__all__ = ["base_triangle", "equal_share", "place_bay", "reach", "tilt"]


EDGES = ((2, 0), (1, 2), (0, 1))
"""Base nodes (from 0) of the edges about which N4, N5 and N6 swing."""


def base_triangle(base: float) -> Floats:
    """N1, N2, N3 of an equilateral triangle of side `base` (m) about the origin, (3, 3); N3 lies on +y."""
    r = base / (2.0 * np.sqrt(3.0))
    return np.array([[-base / 2, -r, 0.0], [base / 2, -r, 0.0], [0.0, 2.0 * r, 0.0]])


def reach(base: float, longeron: float, beta: float, gamma: float, height: float) -> float:
    """How far the pose is from where a longeron pair lies flat against the midplane: 1 - max C^2/(a^2 + B^2).

    Positive for reachable poses, negative beyond.
    """
    rim, u, c = _rim(base, longeron), _mid_normal(beta, gamma), []
    # largest C^2/(a^2 + B^2) over the three hinges: 1 where a longeron pair is stretched flat
    for m, o in _hinges(base):
        flat = (o @ u) ** 2 + u[2] ** 2
        c.append((height / 2 - m @ u) ** 2 / (rim**2 * flat))
    return float(1.0 - max(c))


def place_bay(base: float, longeron: float, beta: float, gamma: float, height: float) -> Floats:
    """Nodes N1..N9 of a bay in the frame of its base triangle, (9, 3), m.

    The midplane {r.u = height/2} halves the way from the base plane to the top plane, whose normal is
    (-sin gamma, -sin beta cos gamma, cos beta cos gamma). N4, N5, N6 swing about the base edges into the midplane; the
    top is the mirror image of the base, N1 -> N7, N2 -> N9, N3 -> N8. The pose must be reachable (see `reach`).
    """
    rim, u = _rim(base, longeron), _mid_normal(beta, gamma)
    low = base_triangle(base)
    mid = []
    # a cos t + b sin t = c: swing angle that brings the node into the midplane
    for m, o in _hinges(base):
        a, b, c = rim * (o @ u), rim * u[2], height / 2 - m @ u
        q = np.sqrt(a * a + b * b - c * c)
        mid.append(m + rim * ((a * c + b * q) * o + (b * c - a * q) * np.array([0.0, 0.0, 1.0])) / (a * a + b * b))
    top = low - 2.0 * np.outer(low @ u - height / 2, u)
    return np.vstack([low, mid, top[[0, 2, 1]]])


def tilt(beta: float, gamma: float) -> tuple[Floats, Floats]:
    """Unit vector u halfway between z and a tilted normal, (3,), and the frame turned into it without twist, (3, 3).

    R = (1 - 2 u u')(1 - 2 z z'), columns: axes of the tilted frame.
    """
    u = _mid_normal(beta, gamma)
    return u, (np.eye(3) - 2.0 * np.outer(u, u)) @ np.diag([1.0, 1.0, -1.0])


def equal_share(beta: Floats, gamma: Floats, height: Floats, bays: int) -> tuple[Floats, Floats, Floats]:
    """beta, gamma, height of each of `bays` bays in equal poses that together give this pose of the top; arrays of one shape.

    Turns without twist about one horizontal axis add up, so each bay tilts by the same fraction a of the whole tilt about it;
    the steps h u from centroid to centroid lie on a circle, and their sum is h sin(bays a/2)/sin(a/2).
    """
    x, y, z = -np.sin(gamma), -np.sin(beta) * np.cos(gamma), np.cos(beta) * np.cos(gamma)
    side = np.hypot(x, y)
    a = np.arctan2(side, z) / bays
    with np.errstate(invalid="ignore"):
        x, y = (np.where(side > 0, np.sin(a) * part / side, 0.0) for part in (x, y))
    stretch = bays * np.sinc(bays * a / (2 * np.pi)) / np.sinc(a / (2 * np.pi))
    return np.arctan2(-y, np.cos(a)), np.arcsin(-x), height / stretch


def _rim(base: float, longeron: float) -> float:
    """Radius on which a mid node swings about its base edge, m."""
    return float(np.sqrt(longeron**2 - base**2 / 4))


def _mid_normal(beta: float, gamma: float) -> Floats:
    top = np.array([-np.sin(gamma), -np.sin(beta) * np.cos(gamma), np.cos(beta) * np.cos(gamma)])
    halfway = top + np.array([0.0, 0.0, 1.0])
    return np.asarray(halfway / np.sqrt(halfway @ halfway))


def _hinges(base: float) -> list[tuple[Floats, Floats]]:
    """Midpoint and outward unit vector of the edges of N4, N5, N6."""
    low = base_triangle(base)
    middles = [(low[i] + low[j]) / 2 for i, j in EDGES]
    return [(m, m / np.sqrt(m @ m)) for m in middles]
