"""Where the electrical power of every drive goes, instant by instant."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.actuators.demand.evaluate import STANDSTILL
from kinetruss.actuators.demand.rates import current_rate
from kinetruss.actuators.trains.motor import at_motor
from kinetruss.actuators.trains.train_of import output_of, parts_of
from kinetruss.model import Active, Model
from kinetruss.results import Demand, Motion, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["power_flow"]

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
    found: NDArray[np.float64] = motion.data[what].values[:, list(motion.data[along].values).index(name)]
    return found
