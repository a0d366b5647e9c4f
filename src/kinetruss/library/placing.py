"""Positions of nodes in closed form: intersections of circles in the plane, rotations in space."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from kinetruss.errors import Fault, ModelError
from kinetruss.model import Bar, Point


def meet(first: complex, reach: float, second: complex, other: float) -> complex | None:
    """The point at distance `reach` from `first` and `other` from `second`, to the left of first -> second; None if there is
    none.

    >>> meet(0j, 3.0, 5 + 0j, 4.0)
    (1.8+2.4j)
    """
    way = second - first
    span = abs(way)
    along = (reach**2 - other**2 + span**2) / (2 * span) if span > 0 else math.inf
    if not along**2 < reach**2:
        return None
    return first + complex(along, math.sqrt(reach**2 - along**2)) * way / span


def on_link(first: complex, second: complex, at: tuple[float, float]) -> complex:
    """A point of a link: at[0] along it from `first` towards `second`, at[1] to its left, m."""
    return first + complex(*at) * (second - first) / abs(second - first)


def turned_about(axis: int, angle: Any) -> Any:
    """Rotation matrix (3, 3) about x, y or z (0, 1, 2); complex angles are allowed.

    >>> turned_about(2, math.pi / 2).round(6).tolist()
    [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    """
    c, s = np.cos(angle), np.sin(angle)
    R = np.zeros((3, 3), dtype=type(c))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[axis, axis] = 1.0
    R[i, i] = R[j, j] = c
    R[i, j], R[j, i] = -s, s
    return R


def leg_angle(out: float, down: float, side: float, arm: float, rod: float) -> float | None:
    """Angle below the horizontal of an arm whose end is joined to a point by a rod; None if the rod does not reach.

    The arm turns in the plane of `out` and `down`; the point lies `out` in front of its axis, `down` below and `side` beside
    it. Of the two solutions, the one with the knee outside: 2 L (out cos t + down sin t) = out^2 + down^2 + side^2 + L^2 - l^2.
    """
    reach = math.hypot(out, down)
    cosine = (reach**2 + side**2 + arm**2 - rod**2) / (2 * arm * reach) if reach > 0 else math.inf
    return math.atan2(down, out) - math.acos(cosine) if abs(cosine) <= 1 else None


def point(place: Any) -> Point:
    """Plain floats of a complex number or an array."""
    if isinstance(place, complex):
        return (place.real, place.imag)
    return tuple(float(value) for value in place)


def places(table: Mapping[str, Any]) -> dict[str, Any]:
    """`point` of every entry."""
    return {name: point(place) for name, place in table.items()}


def bars_between(pairs: Iterable[tuple[str, str]], **fields: Any) -> dict[str, Bar]:
    """Bars called ``A-B`` after their ends, massless by default."""
    return {f"{a}-{b}": Bar(ends=(a, b), **({"mass": 0.0} | fields)) for a, b in pairs}


def refuse(parameter: str, text: str, mend: str) -> ModelError:
    """The error of a parameter with which the mechanism cannot be assembled."""
    return ModelError([Fault((parameter,), text, mend)])


def does_not_close(parameter: str, angle: float, mend: str = "Change lengths, or turn the crank.") -> ModelError:
    """The error of a linkage whose loop is open at an angle (rad) of its crank."""
    return refuse(parameter, f"the linkage does not close at {math.degrees(angle):.4g} deg.", mend)
