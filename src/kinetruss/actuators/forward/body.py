"""What motors move: any body that answers with a thrust to the accelerations of the coordinates that they drive."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["Body", "Coordinate"]


class Body(Protocol):
    """A body with k driven coordinates, lengths (m) or angles (rad).

    count : numbers of its own at the beginning of a state. scale (k,) : of the coordinates, to compare rates with velocities.
    places : where value and rate of each coordinate stand in a state; None where they are no states.

    `at` evaluates value, rate, thrust (k,) and mass (k, k): with accelerations w (k,) of the coordinates the motors push with
    F = thrust + mass w, N or N m.
    """

    count: int
    places: Sequence[tuple[int, int]] | None
    scale: Floats
    value: Floats
    rate: Floats
    thrust: Floats
    mass: Floats

    def at(self, t: float, interval: int, y: Floats, near: Floats) -> None:
        """Evaluate at t (s) of an interval between two jumps; angles are counted on from those of `near` (k,)."""

    def rates(self, y: Floats, w: Floats, out: Floats) -> None:
        """Rates of its own numbers into `out`, with the accelerations w (k,), where `at` was called last."""

    def project(self, t: float, y: Floats, stuck: Floats, places: Floats) -> tuple[Floats, float]:
        """Bring its own numbers onto its constraints, coordinates that are `stuck` (k,) at rest at `places` (k,).

        Returns values (k,), angles in any turn, and the largest change, m.
        """

    def fastest(self, y: Floats) -> float:
        """The largest velocity, m/s."""

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""


class Coordinate:
    """The body of a drive alone: a mass (kg, kg m^2) moves with the length or angle, thrust(t, length) pushes against it.

    thrusts : one law for each interval.
    """

    def __init__(self, mass: float, thrusts: Sequence[Callable[[float, float], float]]) -> None:
        self.thrusts, self.count = thrusts, 2
        self.places: Sequence[tuple[int, int]] | None = ((0, 1),)
        self.scale, self.value, self.rate, self.thrust = np.ones(1), np.zeros(1), np.zeros(1), np.zeros(1)
        self.mass = np.array([[mass]])

    def at(self, t: float, interval: int, y: Floats, near: Floats) -> None:  # noqa: ARG002 - the angle itself is the state
        """Evaluate at t (s) of a state."""
        self.value[0], self.rate[0] = y[0], y[1]
        self.thrust[0] = self.thrusts[interval](t, y[0])

    def rates(self, y: Floats, w: Floats, out: Floats) -> None:
        """Rate and acceleration into `out`."""
        out[0], out[1] = y[1], w[0]

    def project(self, t: float, y: Floats, stuck: Floats, places: Floats) -> tuple[Floats, float]:  # noqa: ARG002
        """A coordinate that sticks stands at its place."""
        if stuck[0]:
            y[0], y[1] = places[0], 0.0
        return y[:1], 0.0

    def fastest(self, y: Floats) -> float:
        """Its rate, m/s."""
        return abs(float(y[1]))

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""
        return 0.5 * float(self.mass[0, 0]) * float(y[1]) ** 2
