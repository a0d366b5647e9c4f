"""Symbols of supports, as lines in a unit square: the node at (0, 0), the ground below it."""

from __future__ import annotations

import math

Line = list[tuple[float, float]]


def _ground(low: float, wide: float = 0.7) -> list[Line]:
    """A line with hatches below it."""
    step, count = wide / 2.5, 5
    hatches = [[(-wide + (k + 1) * step, low), (-wide + k * step, low - 0.22)] for k in range(count)]
    return [[(-wide, low), (wide, low)], *[[(round(x, 3), round(y, 3)) for x, y in one] for one in hatches]]


def _arc(radius: tuple[float, float], turn: tuple[float, float], pieces: int) -> Line:
    """A spiral from one radius and angle (of full turns) to others."""
    share = [k / pieces for k in range(pieces + 1)]
    at = [(radius[0] + s * (radius[1] - radius[0]), 2 * math.pi * (turn[0] + s * (turn[1] - turn[0]))) for s in share]
    return [(round(r * math.cos(a), 3), round(r * math.sin(a), 3)) for r, a in at]


def _shifted(line: Line, x: float, y: float) -> Line:
    return [(round(a + x, 3), round(b + y, 3)) for a, b in line]


WHEEL = _arc((0.13, 0.13), (0.0, 1.0), 8)
TRIANGLE: Line = [(0.0, 0.0), (-0.5, -0.75), (0.5, -0.75), (0.0, 0.0)]
ROLLING: Line = [(0.0, 0.0), (-0.42, -0.6), (0.42, -0.6), (0.0, 0.0)]
ZIGZAG: Line = [
    (0.0, 0.0),
    (0.0, -0.15),
    (0.25, -0.24),
    (-0.25, -0.42),
    (0.25, -0.6),
    (-0.25, -0.78),
    (0.0, -0.87),
    (0.0, -1.0),
]
COIL = _arc((0.15, 0.48), (0.25, 2.0), 28)

SUPPORTS: dict[str, list[Line]] = {
    "clamp": _ground(0.0, 0.8),
    "pin": [TRIANGLE, *_ground(-0.75)],
    "roller": [ROLLING, _shifted(WHEEL, -0.25, -0.73), _shifted(WHEEL, 0.25, -0.73), *_ground(-0.86)],
    "spring": [ZIGZAG, *_ground(-1.0, 0.5)],
    "gap": [[(0.0, 0.0), (0.0, -0.3)], [(-0.35, -0.3), (0.35, -0.3)], *_ground(-0.55, 0.5)],
    "turn": [[(-0.35, -0.35), (0.35, -0.35), (0.35, 0.35), (-0.35, 0.35), (-0.35, -0.35)]],
    "turning spring": [COIL, [(0.48, -0.25), (0.48, 0.25)]],
    "turning gap": [_arc((0.6, 0.6), (0.1, 0.4), 10), [(0.36, 0.26), (0.61, 0.44)], [(-0.36, 0.26), (-0.61, 0.44)]],
}
"""Lines of each kind of support; closed ones are areas.

``clamp`` holds all; ``pin`` all translations; ``roller`` one; ``turn`` a rotation; springs yield; behind a gap a contact
acts. y is the direction held, from the ground to the node; of rotations x and y are across their axis.
"""
