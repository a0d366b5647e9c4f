"""What motors move: any body that answers with a thrust to the accelerations of the coordinates that they drive."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["Body", "Coordinate"]


class Body(Protocol):
    """A body with k driven coordinates, lengths (m) or angles (rad).

    count : numbers of its own at the beginning of a state.
    places : where value and rate of each coordinate stand in a state; None where they are no states.

    `at` evaluates value, rate, thrust (k,) and mass (k, k): with accelerations w (k,) of the coordinates the motors push with
    F = thrust + mass w, N or N m. They are plain numbers: a drive alone has one, and arrays of one would take its time.
    """

    count: int
    places: Sequence[tuple[int, int]] | None
    value: list[float]
    rate: list[float]
    thrust: list[float]
    mass: list[list[float]]

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:
        """Evaluate at t (s) of an interval between two jumps; angles are counted on from those of `near` (k,)."""

    def pushed(self, w: list[float]) -> list[float]:
        """F (k,), with the accelerations w (k,), where `at` was called last."""

    def rates(self, y: Floats, w: list[float]) -> list[float]:
        """Rates of its own numbers, with the accelerations w (k,), where `at` was called last."""

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:
        """Bring its own numbers onto its constraints, coordinates that are `stuck` (k,) at rest at `places` (k,).

        Returns values (k,), angles in any turn, and the largest change, m.
        """

    def moving(self, y: Floats) -> list[bool]:
        """Which coordinates (k,) move, beyond round-off, where `at` was called last."""

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""


class Coordinate:
    """The body of a drive alone: a mass (kg, kg m^2) moves with the length or angle, thrust(t, length) acts against it.

    thrusts : one law for each interval.
    """

    def __init__(self, mass: float, thrusts: Sequence[Callable[[float, float], float]]) -> None:
        self.thrusts, self.count = thrusts, 2
        self.places: Sequence[tuple[int, int]] | None = ((0, 1),)
        self.value, self.rate, self.thrust = [0.0], [0.0], [0.0]
        self.mass = [[mass]]

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:  # noqa: ARG002 - the angle itself is the state
        """Evaluate at t (s) of a state."""
        self.value[0], self.rate[0] = y.item(0), y.item(1)
        self.thrust[0] = self.thrusts[interval](t, self.value[0])

    def pushed(self, w: list[float]) -> list[float]:
        """The whole thrust, with the mass that is accelerated."""
        return [self.thrust[0] + self.mass[0][0] * w[0]]

    def rates(self, y: Floats, w: list[float]) -> list[float]:  # noqa: ARG002 - its rate is known
        """Rate and acceleration."""
        return [self.rate[0], w[0]]

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:  # noqa: ARG002
        """A coordinate that sticks stands at its place."""
        if stuck[0]:
            y[0], y[1] = places[0], 0.0
        return y[:1], 0.0

    def moving(self, y: Floats) -> list[bool]:
        """Whether it has a rate."""
        return [y[1] != 0]

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""
        return 0.5 * self.mass[0][0] * float(y[1]) ** 2
