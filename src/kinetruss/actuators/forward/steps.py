"""Steps of SciPy's methods through the modes of motors: each ends at the first event, behind which a new one begins.

Between two events the equations are smooth; Coulomb friction is never smoothed. The method is DOP853, or Radau where a
winding is very quick.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853, Radau

from kinetruss.actuators.forward.events import Interpolant, ModeEvent, Values, first_change

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.actuators.forward.modes import MotorModes

    Floats = NDArray[np.float64]

__all__ = ["Step", "Tolerances", "finite_rates", "method_from", "step_of"]


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
