"""Limits that a demand exceeds: which, when, by how much."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.demand.summarise import QUANTITIES
from kinetruss.display import instant, quantity
from kinetruss.results import Demand

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Exceeded", "exceeded"]


SLACK = 1e-9
"""A drive at its limit, to round-off, does not exceed it: so are those that an amplifier holds there."""


@dataclass(frozen=True, slots=True)
class Exceeded:
    """One limit exceeded for one stretch of time.

    start, end : s, between two samples by straight lines (NaN for a root mean square, which belongs to the whole motion).
    time : s, of the worst; value : its magnitude there, and limit, in `unit`.
    """

    active: str
    quantity: str
    start: float
    end: float
    time: float
    value: float
    limit: float
    unit: str

    def __str__(self) -> str:
        excess = f"{quantity(self.value / self.limit - 1, '%')} above {quantity(self.limit, self.unit)}"
        if math.isnan(self.start):
            return f"{self.active}: {self.quantity} {quantity(self.value, self.unit)} over the motion, {excess}."
        what = "stroke from the middle between its limits" if self.quantity == "stroke" else self.quantity
        when = f"at {instant(self.start)}" if self.start == self.end else f"from {instant(self.start)} to {instant(self.end)}"
        return f"{self.active}: {what} too high {when}; {quantity(self.value, self.unit)} at {instant(self.time)}, {excess}."


def exceeded(demand: Demand) -> tuple[Exceeded, ...]:
    """Every limit that a demand exceeds, with each stretch of time in which it does; worst first.

    As text, one is for example ``M7: voltage too high from 0.2941 s to 0.7059 s; 36.3 V at 0.5 s, 45.2 % above 25 V.``

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.Quintic(moves={"actuator": (2.5, 3.0)}, duration=1.0), samples=21)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> [(one.active, one.quantity, round(one.time, 2), float(one.limit)) for one in kt.actuators.exceeded(demand)]
    [('actuator', 'voltage', 0.45, 25.0)]
    """
    found = list(_found(demand))
    return tuple(sorted(found, key=lambda one: -one.value / one.limit))


def _found(demand: Demand) -> Iterator[Exceeded]:
    data = demand.data
    time = data["time"].values
    value, limit = data["value"].values, data["limit"].values
    for i, active in enumerate(data["active"].values):
        for j, (what, (unit, history)) in enumerate(QUANTITIES.items()):
            if not value[i, j] > limit[i, j] * (1 + SLACK):
                continue
            if history is None:
                yield Exceeded(str(active), what, *(math.nan,) * 3, value[i, j], limit[i, j], unit)
                continue
            magnitudes = np.abs(data[history].values[:, i])
            for start, end, at in _stretches(time, magnitudes, limit[i, j]):
                yield Exceeded(str(active), what, start, end, float(time[at]), float(magnitudes[at]), limit[i, j], unit)


def _stretches(time: NDArray[np.float64], values: NDArray[np.float64], limit: float) -> Iterator[tuple[float, float, int]]:
    """Begin, end and sample of the largest value of every stretch above the limit."""
    above = np.concatenate(([False], values > limit * (1 + SLACK), [False]))
    firsts, ends = np.flatnonzero(~above[:-1] & above[1:]), np.flatnonzero(above[:-1] & ~above[1:])
    for first, end in zip(firsts.tolist(), ends.tolist(), strict=True):
        start = _crossing(time, values, first - 1, limit) if first > 0 else float(time[0])
        stop = _crossing(time, values, end - 1, limit) if end < len(time) else float(time[-1])
        yield start, stop, first + int(np.argmax(values[first:end]))


def _crossing(time: NDArray[np.float64], values: NDArray[np.float64], at: int, limit: float) -> float:
    """Where the straight line from sample `at` to the next meets the limit; the nearer one where both are on one side of it."""
    share = (limit - values[at]) / (values[at + 1] - values[at])
    return float(time[at] + min(max(share, 0.0), 1.0) * (time[at + 1] - time[at]))
