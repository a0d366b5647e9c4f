"""What a demand says of energy: the single moves of every drive, and where its electrical power goes at every instant."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.actuators.demand_summary import current_rate
from kinetruss.actuators.demands import STANDSTILL
from kinetruss.actuators.shafts import at_motor, output_of, parts_of
from kinetruss.model import Active, Model
from kinetruss.results import Demand, Motion, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

TERMS = {
    "electrical": "voltage x current",
    "copper": "heat in the winding",
    "motor": "friction of the motor",
    "gear": "lost in the gear",
    "screw": "friction of the screw",
    "stored": "rate of the energy in rotor and winding",
    "actuator": "power of the thrust",
    "balance": "electrical minus all others",
}


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


def power_flow(model: Model, motion: Motion, demand: Demand) -> xr.Dataset:
    """Powers (W) through every drive train along a motion.

    Returns
    -------
    Dataset over (time, active), in the order of `Model.actuators`.
    ``electrical`` = ``copper`` + ``motor`` + ``gear`` + ``screw`` + ``stored`` + ``actuator``.
    Losses are never negative, whichever way the power flows; ``balance`` is what is not accounted for, round-off. NaN where
    there is no motor.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> motion = kt.kinematics.follow(model, kt.ConstantRate(rates={"actuator": 0.01}, duration=1.0), samples=11)
    >>> demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    >>> power = kt.actuators.power_flow(model, motion, demand).sel(active="actuator")
    >>> bool((power.electrical > power.actuator).all())  # losses
    True
    >>> bool(abs(power.balance).max() < 1e-9)  # nothing is unaccounted for
    True
    """
    members = list(model.actuators)
    data, time = demand.data, demand.arrays["time"].values
    flow = {name: np.full((len(time), len(members)), np.nan) for name in TERMS}
    for k, (name, active) in enumerate(model.actuators.items()):
        parts = parts_of(model, active)
        gear, motor = parts.gear, parts.motor
        histories = {str(key): one.values[:, k] for key, one in data.items() if one.dims == ("time", "active")}
        behind = output_of(parts, active, histories)
        if behind is None or motor is None:
            continue
        load = data["thrust" if isinstance(active, Active) else "drive_torque"].values[:, k]
        rate, torque, turning, lead = behind
        speed, current = (data[key].values[:, k] for key in ("motor_speed", "current"))
        acceleration = _acceleration(motion, name, isinstance(active, Active))
        moving = np.where(np.abs(rate) < STANDSTILL, 0.0, rate)
        ratio, inertia = (1.0, motor.inertia) if gear is None else (gear.ratio, motor.inertia + gear.inertia)
        change = current_rate(time, current, moving, load) if motor.inductance else np.zeros_like(current)
        carried = at_motor(gear, torque, moving) * speed
        flow["electrical"][:, k] = data["electrical_power"].values[:, k]
        flow["copper"][:, k] = motor.resistance * current**2
        mismatch = (motor.emf_constant - motor.torque_constant) * speed * current
        flow["motor"][:, k] = motor.friction_torque * np.abs(speed) + mismatch
        flow["gear"][:, k] = carried - torque * turning
        flow["screw"][:, k] = torque * turning - load * rate
        own = np.zeros_like(rate) if np.all(speed == 0) else ratio * acceleration / lead
        flow["stored"][:, k] = inertia * own * speed + motor.inductance * change * current
        flow["actuator"][:, k] = load * rate
    flow["balance"] = flow["electrical"] - sum(
        flow[name] for name in ("copper", "motor", "gear", "screw", "stored", "actuator")
    )
    variables = {name: variable(("time", "active"), flow[name], "W", words) for name, words in TERMS.items()}
    return xr.Dataset(variables, coords={"time": data.coords["time"], "active": data.coords["active"]})


def _acceleration(motion: Motion, name: str, member: bool) -> NDArray[np.float64]:
    """Second rate (time,) of the length of a member, or of the angle of a drive."""
    what, along = ("length_acceleration", "member") if member else ("drive_acceleration", "drive")
    found: NDArray[np.float64] = motion.whole[what].values[:, list(motion.whole[along].values).index(name)]
    return found
