"""Second-order Taylor arithmetic: a value with its first two time derivatives, exact to rounding."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

__all__ = ["Taylor", "cos", "sin", "sqrt", "stack"]


@dataclass(frozen=True)
class Taylor:
    """A quantity (number or array) with its rate and acceleration."""

    value: np.ndarray
    rate: np.ndarray
    acceleration: np.ndarray

    __array_ufunc__ = None

    def __add__(self, other: Taylor | np.ndarray | float) -> Taylor:
        o = _lift(other)
        return Taylor(self.value + o.value, self.rate + o.rate, self.acceleration + o.acceleration)

    def __mul__(self, other: Taylor | np.ndarray | float) -> Taylor:
        o = _lift(other)
        return Taylor(
            self.value * o.value,
            self.rate * o.value + self.value * o.rate,
            self.acceleration * o.value + 2 * self.rate * o.rate + self.value * o.acceleration,
        )

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Taylor:
        return self * -1.0

    def __sub__(self, other: Taylor | np.ndarray | float) -> Taylor:
        return self + _lift(other) * -1.0

    def __rsub__(self, other: np.ndarray | float) -> Taylor:
        return _lift(other) - self

    def __truediv__(self, other: Taylor | np.ndarray | float) -> Taylor:
        o = _lift(other)
        return self * apply(o, 1 / o.value, -1 / o.value**2, 2 / o.value**3)

    def dot(self, other: Taylor | np.ndarray) -> Taylor:
        """Sum of products over the last axis."""
        return (self * other).total()

    def total(self) -> Taylor:
        """Sum over the last axis."""
        return Taylor(self.value.sum(-1), self.rate.sum(-1), self.acceleration.sum(-1))


def _lift(other: Taylor | np.ndarray | float) -> Taylor:
    if isinstance(other, Taylor):
        return other
    value = np.asarray(other, float)
    return Taylor(value, np.zeros_like(value), np.zeros_like(value))


def apply(q: Taylor, f: np.ndarray, first: np.ndarray, second: np.ndarray) -> Taylor:
    """f(q) from f, f', f'' at q."""
    return Taylor(f, first * q.rate, second * q.rate**2 + first * q.acceleration)


def sin(q: Taylor) -> Taylor:
    """Sine."""
    return apply(q, np.sin(q.value), np.cos(q.value), -np.sin(q.value))


def cos(q: Taylor) -> Taylor:
    """Cosine."""
    return apply(q, np.cos(q.value), -np.sin(q.value), -np.cos(q.value))


def sqrt(q: Taylor) -> Taylor:
    """Square root."""
    root = np.sqrt(q.value)
    return apply(q, root, 0.5 / root, -0.25 / root**3)


def stack(parts: list[Taylor]) -> Taylor:
    """Parts as the last axis (numbers) or the first (vectors)."""
    return Taylor(*(np.stack([getattr(part, name) for part in parts]) for name in ("value", "rate", "acceleration")))
