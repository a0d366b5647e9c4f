"""Planes through nodes: vector area, normal and gimbal angles, with two rates where the nodes have them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.mechanics import direction_rates
from kinetruss.mechanics.configuration.rigid_motion import inertia_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Rates", "gimbal_angles", "normalised", "size", "turn", "vector_area"]

Rates = tuple["NDArray[np.float64]", ...]
"""A quantity (times, ...) alone, or with its first and second rate."""


def _product(multiply: Callable[[Any, Any], Any], p: Any, q: Any) -> Rates:
    """A product with its rates, by Leibniz's rule."""
    return tuple(sum(comb(k, i) * multiply(p[i], q[k - i]) for i in range(k + 1)) for k in range(len(p)))


def _dot(y: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.einsum("tc,tc->t", y, z))


def vector_area(arms: Sequence[Any]) -> Rates:
    """Vector area of the polygon of the arms (times, nodes, 3), with the rates that they have."""
    return tuple(y.sum(axis=1) for y in _product(np.cross, arms, [np.roll(y, -1, axis=1) for y in arms]))


def size(rates: Any) -> Rates:
    """Size of a vector with its rates; zero rates where it vanishes."""
    value = np.linalg.norm(rates[0], axis=1)
    if len(rates) == 1:
        return (value,)
    d, v, a = rates
    safe = np.where(value > 0, value, 1.0)
    rate = _dot(d, v) / safe
    second = (_dot(d, a) + _dot(v, v) - rate**2) / safe
    return value, rate, np.where(value > 0, second, 0.0)


def normalised(rates: Any) -> Rates:
    """Unit vector with its rates."""
    return (rates[0] / size(rates)[0][:, None],) if len(rates) == 1 else direction_rates(*rates)[1]


def gimbal_angles(normal: Rates, base: list[Any] | None, names: Sequence[str] | None) -> dict[str, Rates]:
    """beta and gamma of a normal in the frame of the base, with their rates."""
    zero = np.zeros_like(normal[0])
    frame: list[Any] = [(zero + axis, zero, zero)[: len(normal)] for axis in np.eye(3)]
    if base is not None:
        inertia_of(base[0], names or (), 3)
        up = normalised(vector_area(base))
        side = [y[:, 1] - y[:, 0] for y in base]
        ahead = normalised(_product(np.cross, up, side))  # y = z x (first to second), so that x lies in the plane
        frame = [_product(np.cross, ahead, up), ahead, up]
    x, y, z = (_product(_dot, normal, axis) for axis in frame)
    return {"beta": turn(z, tuple(-part for part in y)), "gamma": _tilt(x, y, z)}


def turn(c: Any, s: Any) -> Rates:
    """Angle of the vector (c, s) with its rates, unwrapped."""
    value = np.unwrap(np.arctan2(s[0], c[0]))
    if len(c) == 1:
        return (value,)
    square, slope = c[0] ** 2 + s[0] ** 2, 2 * (c[0] * c[1] + s[0] * s[1])
    rate = (c[0] * s[1] - s[0] * c[1]) / square
    return value, rate, (c[0] * s[2] - s[0] * c[2]) / square - slope * rate / square


def _tilt(x: Any, y: Any, z: Any) -> Rates:
    """gamma = atan2(-x, sqrt(y^2 + z^2))."""
    pair = [np.stack([p, q], axis=1) for p, q in zip(y, z, strict=True)]
    return turn(size(pair), tuple(-part for part in x))
