"""A base that rotates: velocities and accelerations in space of what moves relative to it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.elements.caching import cached

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from kinetruss.mechanics.system import System


ROTATION = "base_rotation"
"""Attribute of forces under a rotating base: `RotatingBase.numbers`."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RotatingBase:
    """velocity w, acceleration alpha (3,) rad/s, rad/s^2; center c (3,) m; turns: gravity keeps its direction in space.

    All along the axes of the base, which at any instant are also those of a frame that does not rotate. In this frame

        v = v_rel + w x r,    a = a_rel + 2 w x v_rel + alpha x r + w x (w x r),    r = x - c

    so every formula for members, bodies and sections holds with these v and a. Source: any textbook of mechanics, for example
    Goldstein, Classical Mechanics (1980), eq. 4-107.
    """

    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    center: NDArray[np.float64]
    turns: bool

    @property
    def numbers(self) -> list[float]:
        """All in one list of 10, to be stored."""
        return [*self.velocity.tolist(), *self.acceleration.tolist(), *self.center.tolist(), float(self.turns)]

    @classmethod
    def stored(cls, attrs: Mapping[str, Any]) -> RotatingBase | None:
        """The rotation in the attributes of forces; None if the base did not rotate."""
        if (found := attrs.get(ROTATION)) is None:
            return None
        values = np.array(found, float)
        return cls(velocity=values[:3], acceleration=values[3:6], center=values[6:9], turns=bool(values[9]))

    def velocities(self, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        """Velocities in space (times, n, 3) at positions x (times, n, 3) and relative velocities v; v may have one row."""
        return np.asarray(v + np.cross(self.velocity, x - self.center))

    def accelerations(
        self, x: NDArray[np.float64], v: NDArray[np.float64], a: NDArray[np.float64], falling: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Accelerations in space less `falling` (times, 3): the change of gravity as seen from the base (`gravity_change`)."""
        r, w = x - self.center, self.velocity
        turned = np.cross(self.acceleration, r) + np.cross(w, np.cross(w, r) + 2.0 * v)
        return np.asarray(a + turned - falling[:, None])

    def gravity_change(self, t: NDArray[np.float64], gravity: NDArray[np.float64]) -> NDArray[np.float64]:
        """Gravity at times t (times,) less that at 0 s, along the axes of the base, (times, 3); gravity (3,)."""
        rate = float(np.linalg.norm(self.velocity))
        if not (self.turns and rate):
            return np.zeros((len(t), 3))
        axis, angle = self.velocity / rate, -rate * t[:, None]
        # Rodrigues: R g - g = sin k x g + (1 - cos) k x (k x g)
        across = np.cross(axis, gravity)
        return np.asarray(np.sin(angle) * across + (1.0 - np.cos(angle)) * np.cross(axis, across))


@cached()
def base_of(system: System) -> RotatingBase | None:
    """The rotation of the base of a model; None if it does not rotate."""
    found = system.model.base_rotation
    if found is None or not any((*(found.angular_velocity or ()), *(found.angular_acceleration or ()))):
        return None
    vectors = np.zeros((3, 3))
    for row, (given, first) in enumerate(((found.angular_velocity, 2), (found.angular_acceleration, 2), (found.center, 0))):
        if given is not None:
            first = 0 if system.dim == 3 else first
            vectors[row, first : first + len(given)] = given
    return RotatingBase(velocity=vectors[0], acceleration=vectors[1], center=vectors[2], turns=found.gravity_turns)


def rates_in_space(
    attrs: Mapping[str, Any],
    t: NDArray[np.float64],
    x: NDArray[np.float64],
    v: NDArray[np.float64],
    a: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Velocities and accelerations in space (times, n, dim) of a motion x, v, a relative to the base of forces.

    attrs : of the forces. The accelerations are less the change of gravity, so that the gravity of the forces belongs to them.
    """
    base, dim = RotatingBase.stored(attrs), x.shape[-1]
    if base is None:
        return v, a
    gravity = np.zeros(3)
    gravity[:dim] = attrs["gravity"]
    x, v, a = (np.pad(y, ((0, 0), (0, 0), (0, 3 - dim))) for y in (x, v, a))
    felt = base.accelerations(x, v, a, base.gravity_change(t, gravity))
    return tuple(np.ascontiguousarray(y[..., :dim]) for y in (base.velocities(x, v), felt))  # type: ignore[return-value]
