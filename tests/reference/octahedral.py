"""One double-octahedral bay by its closed form, in its own base frame (Lacy 1991, chapter 4).

Thesis numbers: base triangle 1, 2, 3; middle nodes 4, 5, 6, each swinging about one edge of the base; top 7, 8, 9, the
base triangle reflected in the plane of the middle nodes (1 -> 7, 2 -> 9, 3 -> 8).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from reference.newton_euler import Member, Rod, Truss
from reference.taylor import Taylor, cos, sin, sqrt, stack

__all__ = ["ACTIVE", "BARS", "Bay", "MEMBERS", "bay_nodes", "bay_truss", "quintic", "turn"]

BARS = {
    "M1": (6, 2), "M2": (6, 1), "M3": (4, 1), "M4": (4, 3), "M5": (5, 3), "M6": (5, 2),
    "M13": (6, 9), "M14": (6, 7), "M15": (4, 7), "M16": (4, 8), "M17": (5, 8), "M18": (5, 9),
    "M19": (7, 9), "M20": (8, 7), "M21": (8, 9),
}  # fmt: skip
ACTIVE = {"M7": (4, 5), "M9": (5, 6), "M11": (4, 6)}
MEMBERS = BARS | ACTIVE


@dataclass(frozen=True)
class Bay:
    """Sizes and masses of a bay, SI: base side, cross longeron, tubes, density, the two rods of an active member."""

    base: float = 48 * 0.0254
    longeron: float = 35 * 0.0254
    outer: float = 0.75 * 0.0254
    inner: float = 0.63 * 0.0254
    density: float = 2711.5
    rod_mass: float = 3.0
    rod_length: float = 0.7
    tube_length: float = 0.254

    @property
    def area(self) -> float:
        """Of all tubes, m^2."""
        return math.pi / 4 * (self.outer**2 - self.inner**2)

    @property
    def triangle(self) -> np.ndarray:
        """Nodes 1, 2, 3 in the base frame, its origin at their centroid, z to the top (3, 3)."""
        b, r = self.base, math.sqrt(3)
        return np.array([(-b / 2, -b / (2 * r), 0), (b / 2, -b / (2 * r), 0), (0, b / r, 0)])


def quintic(t: float, duration: float, start: float, end: float) -> Taylor:
    """start + (end - start)(10 s^3 - 15 s^4 + 6 s^5), s = t/duration."""
    s, step = t / duration, end - start
    return Taylor(
        np.array(start + step * s**3 * (10 - 15 * s + 6 * s**2)),
        np.array(step * 30 * s**2 * (1 - s) ** 2 / duration),
        np.array(step * 60 * s * (1 - s) * (1 - 2 * s) / duration**2),
    )


def normal(beta: Taylor, gamma: Taylor) -> Taylor:
    """Unit normal of the plane of the middle nodes: halfway between the normals of base and top."""
    top = stack([-sin(gamma), -(sin(beta) * cos(gamma)), cos(beta) * cos(gamma)])
    sum_ = top + np.array([0.0, 0.0, 1.0])
    return sum_ / sqrt(sum_.dot(sum_))


def bay_nodes(bay: Bay, beta: Taylor, gamma: Taylor, height: Taylor) -> Taylor:
    """Nodes 1 to 9 in the base frame (9, 3), with derivatives; `height` is the distance of the centroids."""
    base, u = bay.triangle, normal(beta, gamma)
    at = {k + 1: Taylor(base[k], np.zeros(3), np.zeros(3)) for k in range(3)}
    for node, (i, j) in {6: (0, 1), 4: (2, 0), 5: (1, 2)}.items():
        at[node] = _swing(bay, (base[i] + base[j]) / 2, u, height)
    for node, low in {7: 1, 9: 2, 8: 3}.items():
        at[node] = at[low] + u * (height - u.dot(at[low]) * 2.0)
    return stack([at[k] for k in range(1, 10)])


def _swing(bay: Bay, middle: np.ndarray, u: Taylor, height: Taylor) -> Taylor:
    """The node that swings about the base edge with this midpoint and lies in the plane r.u = height/2."""
    rim = math.sqrt(bay.longeron**2 - bay.base**2 / 4)
    outward, z = middle / np.linalg.norm(middle), np.array([0.0, 0.0, 1.0])
    a, b, c = u.dot(outward) * rim, u.dot(z) * rim, height * 0.5 - u.dot(middle)
    square = a * a + b * b
    q = sqrt(square - c * c)
    cosine, sine = (a * c + b * q) / square, (b * c - a * q) / square
    return (cosine * outward + sine * z) * rim + middle


def turn(beta: Taylor, gamma: Taylor) -> Taylor:
    """Rotation from the top frame to the base frame (3, 3): (I - 2 u u')(I - 2 z z'), no twist."""
    u = normal(beta, gamma)
    column = Taylor(u.value[:, None], u.rate[:, None], u.acceleration[:, None])
    row = Taylor(u.value[None, :], u.rate[None, :], u.acceleration[None, :])
    return (np.eye(3) + (column * row) * -2.0) * np.array([1.0, 1.0, -1.0])


def bay_truss(bay: Bay, gravity: np.ndarray, lump: np.ndarray | None = None) -> Truss:
    """The 18 members of one bay on nodes 1 to 9, held at 1, 2, 3."""
    supported = np.zeros((9, 3), bool)
    supported[:3] = True
    lump = np.zeros(9) if lump is None else lump
    return Truss(members(bay, {k: k - 1 for k in range(1, 10)}), supported, gravity, lump, np.tile(gravity, (9, 1)))


def members(bay: Bay, node_of: dict[int, int]) -> tuple[Member, ...]:
    """The 18 members in the order of `MEMBERS`, thesis node number -> index by `node_of`."""
    line = bay.density * bay.area
    lengths = dict.fromkeys(BARS, bay.longeron) | dict.fromkeys(("M19", "M20", "M21"), bay.base)
    bars = [Member(node_of[p], node_of[q], (Rod(line * lengths[name], lengths[name]),)) for name, (p, q) in BARS.items()]
    rods = (Rod(bay.rod_mass, bay.rod_length), Rod(line * bay.tube_length, bay.tube_length))
    return tuple(bars + [Member(node_of[p], node_of[q], rods) for p, q in ACTIVE.values()])
