"""Planes through nodes: vector area, normal and gimbal angles, each with two rates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics import direction_rates
from kinetruss.mechanics.configuration.rigid_motion import spin_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Rates", "gimbal_angles", "normalised", "size", "turn", "vector_area"]

Rates = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]
"""A quantity (times, ...) with its first and second rate."""


def vector_area(arms: list[Any]) -> Rates:
    """Vector area of the polygon, with two rates."""
    r, v, a = arms
    s, sv, sa = (np.roll(y, -1, axis=1) for y in arms)
    value = np.cross(r, s).sum(axis=1)
    first = (np.cross(v, s) + np.cross(r, sv)).sum(axis=1)
    second = (np.cross(a, s) + 2 * np.cross(v, sv) + np.cross(r, sa)).sum(axis=1)
    return value, first, second


def size(rates: Any) -> Rates:
    """Size of a vector with its rates; zero rates where it vanishes."""
    d, v, a = rates
    value = np.linalg.norm(d, axis=1)
    safe = np.where(value > 0, value, 1.0)
    rate = np.einsum("tc,tc->t", d, v) / safe
    second = (np.einsum("tc,tc->t", d, a) + np.einsum("tc,tc->t", v, v) - rate**2) / safe
    return value, rate, np.where(value > 0, second, 0.0)


def normalised(rates: Any) -> Rates:
    """Unit vector with its rates."""
    return direction_rates(*rates)[1]


def _cross(p: Any, q: Any) -> Rates:
    return (
        np.cross(p[0], q[0]),
        np.cross(p[1], q[0]) + np.cross(p[0], q[1]),
        np.cross(p[2], q[0]) + 2 * np.cross(p[1], q[1]) + np.cross(p[0], q[2]),
    )


def _dot(p: Any, q: Any) -> Rates:
    def one(y: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(np.einsum("tc,tc->t", y, z))

    return one(p[0], q[0]), one(p[1], q[0]) + one(p[0], q[1]), one(p[2], q[0]) + 2 * one(p[1], q[1]) + one(p[0], q[2])


def gimbal_angles(normal: Rates, base: list[Any] | None, names: Sequence[str] | None) -> dict[str, Rates]:
    """beta and gamma of a normal in the frame of the base, with their rates."""
    zero = np.zeros_like(normal[0])
    frame: list[Any] = [(zero + axis, zero, zero) for axis in np.eye(3)]
    if base is not None:
        spin_of(base, names or (), 3)
        up = normalised(vector_area(base))
        side = [y[:, 1] - y[:, 0] for y in base]
        ahead = normalised(_cross(up, side))  # y = z x (first to second), so that x lies in the plane
        frame = [_cross(ahead, up), ahead, up]
    x, y, z = (_dot(normal, axis) for axis in frame)
    return {"beta": turn(z, tuple(-part for part in y)), "gamma": _tilt(x, y, z)}


def turn(c: Any, s: Any) -> Rates:
    """Angle whose cosine and sine go like c and s, with its rates, without jumps."""
    square, slope = c[0] ** 2 + s[0] ** 2, 2 * (c[0] * c[1] + s[0] * s[1])
    rate = (c[0] * s[1] - s[0] * c[1]) / square
    return np.unwrap(np.arctan2(s[0], c[0])), rate, (c[0] * s[2] - s[0] * c[2]) / square - slope * rate / square


def _tilt(x: Any, y: Any, z: Any) -> Rates:
    """gamma = atan2(-x, sqrt(y^2 + z^2))."""
    pair = [np.stack([p, q], axis=1) for p, q in zip(y, z, strict=True)]
    return turn(size(pair), tuple(-part for part in x))
