"""Steps of SciPy's methods through the modes of motors: each ends at the first event, behind which a new one begins.

Between two events the equations are smooth; Coulomb friction is never smoothed. The method is DOP853, or Radau where a
winding is very quick.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853, Radau

from kinetruss.actuators.forward.events import ModeEvent, Values, first_change

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.forward.modes import MotorModes

    Floats = NDArray[np.float64]

__all__ = ["Interpolant", "Step", "Tolerances", "finite_rates", "method_from", "step_of"]


LEAST = 1e-140
"""Rates (SI) below which the squares of errors are no numbers any more."""


@dataclass(frozen=True, slots=True)
class Tolerances:
    """rtol, atol (size,) : of a state. first : size of a step to begin with, s; 0 where the method finds one."""

    rtol: float
    atol: Floats
    first: float = 0.0


@dataclass(frozen=True, slots=True)
class Step:
    """From `begin` to `end` (s). at : the interpolant, at(t) the state; event : what ends the mode, if anything.

    size, next : of steps, s.
    """

    begin: float
    end: float
    at: Interpolant
    event: ModeEvent | None
    size: float
    next: float


class Interpolant:
    """A step of SciPy's as one product: y(x) = y_0 + sum_i w_i(x) row_i, x from 0 to 1 between `t_min` and `t_max` (s).

    w_i of DOP853: x, x (1 - x), x^2 (1 - x), x^2 (1 - x)^2, ... (Hairer, Norsett & Wanner, Solving ODEs I, II.6); of Radau:
    x, x^2, x^3. SciPy's own call takes as long as several evaluations of a drive.
    """

    def __init__(self, dense: Any) -> None:
        self.t_min, self.t_max = float(dense.t_min), float(dense.t_max)
        self.start, self._length = dense.y_old, float(dense.h)
        self.nested = hasattr(dense, "F")
        self.rows = dense.F if self.nested else dense.Q.T

    def __call__(self, t: float) -> Floats:
        """The state (size,) at t (s)."""
        found: Floats = self.start + np.array(_weights((t - self.t_min) / self._length, self.nested)) @ self.rows
        return found

    def bernstein(self) -> Floats:
        """Coefficients (13, size) of the state in Bernstein's basis, of which every value is a mean."""
        found: Floats = self.start + _to_bernstein(self.nested) @ self.rows
        return found


def _weights(x: Any, nested: bool) -> tuple[Any, ...]:
    if not nested:
        return x, x * x, x * x * x
    y = 1.0 - x
    a = x * y
    b, c = a * x, a * a
    return x, a, b, c, c * x, c * a, c * b


@cache
def _to_bernstein(nested: bool) -> Floats:
    from kinetruss.kernels.integrate.roots import NODES, TO_BERNSTEIN

    found: Floats = TO_BERNSTEIN @ np.array(_weights(NODES, nested)).T
    return found


def method_from(modes: MotorModes, interval: int, t: float, y: Floats, until: float, given: Tolerances) -> Any:
    """SciPy's method from a state on, in the present modes, to `until` (s), the end of the interval or of the run."""
    rates, last = modes.rates(interval), np.nextafter(until, -np.inf)
    solver = (Radau if modes.drives.stiff else DOP853)(
        # a jump at the end belongs to the next interval
        lambda t, y: finite_rates(rates(min(t, last), y)),
        t,
        y,
        until,
        max_step=modes.drives.longest,
        rtol=given.rtol,
        atol=given.atol,
    )
    if given.first > 0:
        solver.h_abs = given.first
    return solver


def finite_rates(rates: Iterable[float]) -> Floats:
    """Rates without those so small that the error estimate of SciPy's DOP853 would divide the zeros of their squares."""
    return np.array([0.0 if -LEAST < rate < LEAST else rate for rate in rates])


def step_of(solver: Any, watched: tuple[list[ModeEvent], Values]) -> Step | None:
    """One step, cut at the first event; None where none can be taken. watched : see `ends.watch`."""
    begin, y = float(solver.t), solver.y
    solver.step()
    if solver.status == "failed" or not np.isfinite(solver.y).all():
        return None
    dense = Interpolant(solver.dense_output())
    event, end = first_change(*watched, (begin, y), dense)
    return Step(begin, end, dense, event, float(solver.t - begin), float(solver.h_abs))
