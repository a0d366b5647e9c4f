"""Where the electrical power of every drive goes, instant by instant."""

from __future__ import annotations

import numpy as np
import xarray as xr

from kinetruss.actuators._current_rate import current_rate
from kinetruss.actuators._evaluate import STANDSTILL
from kinetruss.actuators._motor import at_motor
from kinetruss.actuators._train_of import parts_of
from kinetruss.model import Model
from kinetruss.results import Demand, Motion, variable

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
    Dataset over (time, active): ``electrical`` = ``copper`` + ``motor`` + ``gear`` + ``screw`` + ``stored`` + ``actuator``.
    Losses are never negative, whichever way the power flows; ``balance`` is what is not accounted for, round-off. NaN where
    there is no motor.
    """
    members = list(model.active)
    pick = [list(motion.data["member"].values).index(name) for name in members]
    acceleration = motion.data["length_acceleration"].values[:, pick]
    data, time = demand.data, demand.data["time"].values
    flow = {name: np.full((len(time), len(members)), np.nan) for name in TERMS}
    for k, active in enumerate(model.active.values()):
        screw, gear, motor, _ = parts_of(model, active)
        if screw is None or motor is None:
            continue
        rate, thrust, torque, turning, speed, current = (
            data[name].values[:, k]
            for name in ("length_rate", "thrust", "screw_torque", "screw_speed", "motor_speed", "current")
        )
        moving = np.where(np.abs(rate) < STANDSTILL, 0.0, rate)
        ratio, inertia = (1.0, motor.inertia) if gear is None else (gear.ratio, motor.inertia + gear.inertia)
        change = current_rate(time, current, moving, thrust) if motor.inductance else np.zeros_like(current)
        carried = at_motor(gear, torque, moving) * speed
        flow["electrical"][:, k] = data["electrical_power"].values[:, k]
        flow["copper"][:, k] = motor.resistance * current**2
        mismatch = (motor.emf_constant - motor.torque_constant) * speed * current
        flow["motor"][:, k] = motor.friction_torque * np.abs(speed) + mismatch
        flow["gear"][:, k] = carried - torque * turning
        flow["screw"][:, k] = torque * turning - thrust * rate
        own = np.zeros_like(rate) if np.all(speed == 0) else ratio * acceleration[:, k] / screw.lead
        flow["stored"][:, k] = inertia * own * speed + motor.inductance * change * current
        flow["actuator"][:, k] = thrust * rate
    flow["balance"] = flow["electrical"] - sum(
        flow[name] for name in ("copper", "motor", "gear", "screw", "stored", "actuator")
    )
    variables = {name: variable(("time", "active"), flow[name], "W", words) for name, words in TERMS.items()}
    return xr.Dataset(variables, coords={"time": data.coords["time"], "active": data.coords["active"]})
