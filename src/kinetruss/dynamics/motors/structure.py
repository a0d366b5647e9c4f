"""The structure as the body of its motors: how it answers to the accelerations of the coordinates that they drive."""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.actuators.forward import unwrapped
from kinetruss.errors import AnalysisError
from kinetruss.kernels.solve.kkt import kinetic, prepare_rows
from kinetruss.kernels.solve.motors import MotorPlaces, MotorResponse, motor_project, motor_response

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kernels.structure.equations import Equations, Workspace

    Floats = NDArray[np.float64]

__all__ = ["StructureBody", "motor_places"]

TOLERANCE = 1e-13
"""Of projections, in parts of a length."""
REST = 1e-12
"""Of the largest velocity: below this share a coordinate is at rest at the start."""


class StructureBody:
    """Accelerations and forces at an instant, as straight lines over the accelerations w (k,) of the coordinates of `rows`.

    a = a0 + w da, N = N0 + w dN; see `kinetruss.actuators.forward.body.Body`. Its own numbers in a state are free positions and
    velocities. stand (3 n,) : positions at the start, of coordinates that are not free.
    """

    places: Sequence[tuple[int, int]] | None = None

    def __init__(self, eq: Equations, ws: Workspace, user: Any, rows: NDArray[np.int64], period: Floats, stand: Floats) -> None:
        k, size, count = len(rows), eq.local.size, len(eq.A)
        self.eq, self.ws, self.user, self.rows, self.period, self.stand = eq, ws, user, rows, period, stand
        shapes: dict[str, Any] = dict.fromkeys(("rows", "value", "rate", "scale"), (k,))
        shapes |= {"a": (size,), "N": (count,), "da": (k, size), "dN": (k, count)}
        self._response = made = MotorResponse.zeros(shapes)
        made.rows[:] = rows
        self._stuck, self.count = motor_places(rows, size), 2 * len(eq.free)
        self.scale, self.a0, self.N0, self.da, self.dN = made.scale, made.a, made.N, made.da, made.dN
        self.pivot, self.value, self.rate, self.thrust = 0.0, list[float](), list[float](), list[float]()
        self.mass = list[list[float]]()

    def state(self, y: Floats) -> tuple[Floats, Floats]:
        """Positions and velocities (3 n,); prescribed coordinates as at the start."""
        free, x, v = self.eq.free, self.stand.copy(), np.zeros_like(self.stand)
        x[free], v[free] = y[: len(free)], y[len(free) : 2 * len(free)]
        return x, v

    def evaluate(self, t: float, x: Floats, v: Floats, near: Any) -> StructureBody:
        """Evaluate; prescribed coordinates of x and v are set. Angles are counted on from the turn that `near` (k,) is in."""
        self.pivot = motor_response(self.eq, self.ws, self.user.call, t, x, v, self._response)
        self.value = unwrapped(self._response.value, near, self.period).tolist()
        self.rate = self._response.rate.tolist()
        self.thrust = (-self.scale * self.N0[self.rows]).tolist()
        self.mass = (-self.scale[:, None] * self.dN[:, self.rows].T).tolist()
        return self

    def at(self, t: float, interval: int, y: Floats, near: list[float]) -> None:  # noqa: ARG002 - the equations know their jumps
        """Evaluate at t (s) of a state."""
        self.evaluate(t, *self.state(y), near)

    def found(self, w: list[float]) -> tuple[Floats, Floats]:
        """a (3 n,) and N (r,) with these accelerations of the coordinates."""
        return self.a0 + np.dot(w, self.da), self.N0 + np.dot(w, self.dN)

    def pushed(self, w: list[float]) -> list[float]:
        """Thrusts (k,), N, with these accelerations of the coordinates."""
        return [f + sum(map(mul, row, w)) for f, row in zip(self.thrust, self.mass, strict=True)]

    def rates(self, y: Floats, w: list[float]) -> list[float]:
        """Velocities and accelerations of the free coordinates."""
        free: list[float] = self.found(w)[0][self.eq.free].tolist()
        return [*y[len(free) : 2 * len(free)].tolist(), *free]

    def observed(self, t: float, y: Floats, w: list[float]) -> tuple[Floats, Floats, Floats, Floats]:
        """x, v, a (3 n,), N (r,) where `at` was called last, prescribed coordinates included."""
        x, v = self.state(y)
        a, N = self.found(w)
        prepare_rows(self.eq, self.ws, t, x, v)
        return x, v, a, N

    def project(self, t: float, y: Floats, stuck: list[bool], places: list[float]) -> tuple[Floats, float]:
        """Bring a state onto the constraints, coordinates that stick at rest."""
        x, v = self.state(y)
        own, free = self._stuck, self.eq.free
        own.stuck[:], own.value[:] = stuck, places
        good, moved = motor_project(self.eq, self.ws, t, x, v, own, TOLERANCE)
        if not good:
            raise AnalysisError(f"The lengths of the bars could not be closed at t = {t:.6g} s.")
        y[: len(free)], y[len(free) : 2 * len(free)] = x[free], v[free]
        return own.value, moved

    def moving(self, y: Floats) -> list[bool]:
        """Which coordinates (k,) move, where `at` was called last."""
        least = REST * np.abs(y[len(self.eq.free) : self.count]).max(initial=0.0)
        found: list[bool] = (np.abs(self._response.rate * self.scale) > least).tolist()
        return found

    def kinetic(self, y: Floats) -> float:
        """Kinetic energy, J."""
        return float(kinetic(self.eq, self.ws, *self.state(y)))


def motor_places(rows: NDArray[np.int64], size: int) -> MotorPlaces:
    """Workspace to project motor-driven rows beside `size` coordinates; none is stuck."""
    k = len(rows)
    made = MotorPlaces.zeros({"rows": (k,), "stuck": (k,), "value": (k,), "rate": (k,), "scratch": (size,)})
    made.rows[:] = rows
    return made
