"""Single moves of a demand, from standstill or reversal to the next."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.actuators.demand.evaluate import STANDSTILL
from kinetruss.results import Demand

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Move", "moves"]


@dataclass(frozen=True, slots=True)
class Move:
    """One move of one active member, or of one geared angle.

    start, end : s. travel : m, positive longer; of an angle rad.
    drawn, returned, energy : J, electrical: taken, fed back, their difference.
    positive_work, negative_work : J, of the thrust. rms_torque : N m, of the motor. peak_power : W, electrical.
    """

    active: str
    start: float
    end: float
    travel: float
    drawn: float
    returned: float
    energy: float
    positive_work: float
    negative_work: float
    rms_torque: float
    peak_power: float


def moves(demand: Demand) -> tuple[Move, ...]:
    """The moves of every active member: what happens between two standstills or reversals, with energies and mean torque.

    Integrals are by the trapezoidal rule over the samples of the move, the standstills at its ends included. Members without a
    motor have no energies (NaN).

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.Cyclic(moves={"actuator": (2.5, 2.6)}, period=2.0), samples=41)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> [(one.active, round(one.travel, 3)) for one in kt.actuators.moves(demand)]  # m: there and back
    [('actuator', 0.1), ('actuator', -0.1)]
    """
    return tuple(one for k in range(demand.data.sizes["active"]) for one in _of_member(demand, k))


def _of_member(demand: Demand, k: int) -> Iterator[Move]:
    data = demand.data
    time, rate = data["time"].values, data["length_rate"].values[:, k]
    if "angle_rate" in data and np.isnan(rate).all():
        rate = data["angle_rate"].values[:, k]
    names = ("electrical_power", "actuator_power", "motor_torque")
    power, work, torque = (data[name].values[:, k] for name in names)
    direction = np.where(np.abs(rate) < STANDSTILL, 0.0, np.sign(rate))
    for part in np.split(np.arange(len(time)), np.flatnonzero(np.diff(direction)) + 1):
        if not len(part) or direction[part[0]] == 0:
            continue
        # standstills beside it belong to the move
        first, last = max(part[0] - 1, 0), min(part[-1] + 1, len(time) - 1)
        first = first if direction[first] == 0 else part[0]
        last = last if direction[last] == 0 else part[-1]
        span = slice(first, last + 1)
        t = time[span]
        duration = float(t[-1] - t[0])
        mean = np.sqrt(_integral(t, torque[span] ** 2) / duration) if duration else abs(torque[first])
        yield Move(
            active=str(data["active"].values[k]),
            start=float(t[0]),
            end=float(t[-1]),
            travel=_integral(t, rate[span]),
            drawn=_integral(t, np.maximum(power[span], 0)),
            returned=_integral(t, np.maximum(-power[span], 0)),
            energy=_integral(t, power[span]),
            positive_work=_integral(t, np.maximum(work[span], 0)),
            negative_work=_integral(t, np.minimum(work[span], 0)),
            rms_torque=float(mean),
            peak_power=float(np.max(power[span])),
        )


def _integral(time: NDArray[np.float64], values: NDArray[np.float64]) -> float:
    return float(np.sum(np.diff(time) * (values[1:] + values[:-1])) / 2)
