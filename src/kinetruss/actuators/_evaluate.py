"""Demand on the screws and motors of all active members along a motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.actuators._motor import motor_demand
from kinetruss.actuators._screw import is_self_locking, screw_torque
from kinetruss.model import Active, Model
from kinetruss.results import Demand, Forces, Motion, provenance, variable

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["evaluate", "summarise"]

STANDSTILL = 1e-9
"""Rates of length below this (m/s) count as standing still."""

HISTORIES = {
    "thrust": ("N", "actuator force, positive pushing the ends apart"),
    "length_rate": ("m/s", "rate of length"),
    "stroke": ("m", "length from the middle between its limits"),
    "actuator_power": ("W", "power of the thrust"),
    "screw_torque": ("N m", "torque on the screw, positive when it drives the member longer"),
    "screw_speed": ("rad/s", "speed of the screw"),
    "motor_speed": ("rad/s", "speed of the motor"),
    "motor_torque": ("N m", "motor torque (torque constant x current)"),
    "current": ("A", "motor current"),
    "voltage": ("V", "motor voltage"),
    "mechanical_power": ("W", "motor torque x speed"),
    "electrical_power": ("W", "voltage x current"),
}

QUANTITIES = {
    "voltage": ("V", "voltage", "max_voltage"),
    "current": ("A", "current", "max_current"),
    "speed": ("rad/s", "motor_speed", "max_speed"),
    "torque": ("N m", "motor_torque", "max_torque"),
    "stroke": ("m", "stroke", None),
}
"""What is held against a limit: unit, history, field of the motor."""


def evaluate(model: Model, motion: Motion, forces: Forces) -> Demand:
    """What the screw, gear and motor of every active member must deliver.

    Parameters
    ----------
    motion, forces : from `kinematics.follow` and `dynamics.inverse` of the same model. For ``forces.static`` the members
        stand still: the result holds the load at every pose.

    Returns
    -------
    Demand. Over (time, active): ``thrust`` N, ``length_rate`` m/s, ``stroke`` m, ``actuator_power`` W, ``screw_torque`` N m,
    ``screw_speed`` rad/s, ``motor_speed``, ``motor_torque``, ``current``, ``voltage``, ``mechanical_power``,
    ``electrical_power``; NaN where a member has no screw or no motor. Then the summary of `summarise`. ``.table()`` lists
    peaks against limits, worst first.

    Notes
    -----
    A screw raises its load where the thrust does positive work (thrust x rate > 0), lowers it where it does negative work,
    and holds at standstill (rates below 1e-9 m/s); see `screw_torque` and `motor_demand`. Friction of starting and winding
    inductance are not modelled.
    """
    names = list(model.active)
    still = bool(forces.data.attrs.get("at_rest", 0))
    pick = [list(motion.data["member"].values).index(name) for name in names]
    thrust = -forces.data["member_force"].values[:, pick]
    length, rate, acceleration = (
        motion.data[name].values[:, pick] for name in ("length", "length_rate", "length_acceleration")
    )
    if still:
        rate, acceleration = np.zeros_like(rate), np.zeros_like(acceleration)
    columns = [
        _member(model, active, thrust[:, k], length[:, k], rate[:, k], acceleration[:, k])
        for k, active in enumerate(model.active.values())
    ]
    time = motion.data["time"].values
    data = {
        key: variable(("time", "active"), _stacked(columns, key, len(time)), unit, words)
        for key, (unit, words) in HISTORIES.items()
    }
    coords = {"time": motion.data.coords["time"], "active": np.array(names, dtype=object).astype(str)}
    attrs = {"kind": "demand", "load_case": forces.load_case}
    timed = xr.Dataset(data, coords=coords, attrs=attrs)
    demand = Demand(
        data=timed, status=forces.status, message=forces.message,
        provenance=provenance(model, load_case=forces.load_case),
    )  # fmt: skip
    return summarise(model, demand)


def summarise(model: Model, demand: Demand) -> Demand:
    """The same demand with what follows from its whole time history.

    Use it after joining histories of consecutive stretches of time; `evaluate` has done it already.

    Returns
    -------
    Demand with, over (active, quantity), ``value`` (largest magnitude), ``limit``, ``utilisation``, ``margin``, ``time_of``,
    ``note`` for voltage, current, speed, torque and stroke; and over (active): ``electrical_energy`` J (net),
    ``drawn_energy`` J (nothing fed back), ``actuator_work`` J, ``rms_torque`` N m, ``self_locking``.
    """
    kept = demand.data[list(HISTORIES)]
    time = kept["time"].values
    power, work = kept["electrical_power"].values, kept["actuator_power"].values
    duration = time[-1] - time[0] if len(time) > 1 else 0.0
    square = kept["motor_torque"].values ** 2
    # a single instant has no duration: its own torque counts
    rms = np.sqrt(_integral(time, square) / duration if duration else square.sum(axis=0))
    members = list(model.active.values())
    locking = np.array([m is not None and is_self_locking(m) for m in (_screw(model, a) for a in members)], np.bool_)
    over = ("active",)
    totals = {
        "electrical_energy": variable(over, _integral(time, power), "J", "electrical energy of the motion, net"),
        "drawn_energy": variable(over, _integral(time, np.maximum(power, 0)), "J", "electrical energy without feeding back"),
        "actuator_work": variable(over, _integral(time, work), "J", "work of the thrust"),
        "rms_torque": variable(over, rms, "N m", "root mean square motor torque"),
        "self_locking": variable(over, locking, "", "the screw holds by itself"),
    }
    data = kept.assign(totals | _peaks(model, members, kept))
    return demand.with_(data=data.assign_coords(
        quantity=np.array(list(QUANTITIES)), unit=("quantity", np.array([unit for unit, _, _ in QUANTITIES.values()]))
    ))  # fmt: skip


def _screw(model: Model, active: Active) -> Any:
    return model.screws[active.screw] if isinstance(active.screw, str) else active.screw


def _motor(model: Model, active: Active) -> Any:
    return model.motors[active.motor] if isinstance(active.motor, str) else active.motor


def _gear(model: Model, active: Active) -> Any:
    return model.gears[active.gear] if isinstance(active.gear, str) else active.gear


def _member(
    model: Model, active: Active, thrust: NDArray[np.float64], length: NDArray[np.float64], rate: NDArray[np.float64],
    acceleration: NDArray[np.float64],
) -> dict[str, NDArray[np.float64]]:  # fmt: skip
    """Histories of one active member, as far as its drive train is known."""
    found = {"thrust": thrust, "length_rate": rate, "actuator_power": thrust * rate}
    if active.limits is not None:
        found["stroke"] = length - sum(active.limits) / 2
    screw, gear, motor = _screw(model, active), _gear(model, active), _motor(model, active)
    if screw is None:
        return found
    moving = np.where(np.abs(rate) < STANDSTILL, 0.0, rate)
    found |= {"screw_torque": screw_torque(screw, thrust, moving), "screw_speed": rate / screw.lead}
    if motor is not None:
        found |= motor_demand(screw, gear, motor, found["screw_torque"], moving, acceleration)
    return found


def _stacked(columns: list[dict[str, NDArray[np.float64]]], key: str, count: int) -> NDArray[np.float64]:
    nothing = np.full(count, np.nan)
    return np.stack([column.get(key, nothing) for column in columns], axis=1) if columns else np.empty((count, 0))


def _integral(time: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Trapezoidal rule along time (times, ...)."""
    step = np.diff(time)[:, None]
    total: NDArray[np.float64] = np.sum(step * (values[1:] + values[:-1]) / 2, axis=0)
    return total


def _peaks(model: Model, members: list[Active], data: xr.Dataset) -> dict[str, xr.Variable]:
    """Largest magnitudes against limits, over (active, quantity)."""
    shape = (len(members), len(QUANTITIES))
    value, limit, when = (np.full(shape, np.nan) for _ in range(3))
    note = np.full(shape, "", dtype="<U48")
    for j, (_, history, field) in enumerate(QUANTITIES.values()):
        for i, active in enumerate(members):
            motor, magnitudes = _motor(model, active), np.abs(data[history].values[:, i])
            if not magnitudes.size or np.isnan(magnitudes).all():
                # one line a member is enough to say that its motor is missing
                missing = "screw" if _screw(model, active) is None else "motor"
                note[i, j] = f"not checked: no {missing}" if history == "motor_torque" else ""
                continue
            at = int(np.nanargmax(magnitudes))
            value[i, j], when[i, j] = magnitudes[at], data["time"].values[at]
            allowed = getattr(motor, field) if field else (active.limits[1] - active.limits[0]) / 2 if active.limits else None
            limit[i, j] = np.nan if allowed is None else allowed
            note[i, j] = "no limit given" if allowed is None else ""
    utilisation = value / limit
    with np.errstate(divide="ignore"):
        margin = 1 / utilisation - 1
    over = ("active", "quantity")
    return {
        "value": variable(over, value, "", "largest magnitude, in the quantity's unit"),
        "limit": variable(over, limit, "", "limit, in the quantity's unit"),
        "utilisation": variable(over, utilisation, "", "value over limit"),
        "margin": variable(over, margin, "", "1/utilisation - 1"),
        "time_of": variable(over, when, "s", "time of the largest magnitude"),
        "note": variable(over, note, "", "why there is no utilisation"),
    }
