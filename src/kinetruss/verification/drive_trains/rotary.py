"""Gears and motors on drives of angles: a geared crank by hand, power through a robot's motors."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt

GEAR = kt.Gear(ratio=12.0, efficiency=0.85, inertia=3e-6)
MOTOR = kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06, friction_torque=0.004)
MASS, ARM, G, START, WAY, DURATION = 1.7, 0.4, 9.81, 0.2, 2.4, 1.5
INSTANTS = {"driving": 90, "driven": 240}
"""Indices of samples (of 301): the motor lifts the crank, and after the top the crank drives the motor."""


def crank() -> dict[str, Any]:
    """A geared crank with a point mass in the vertical plane, from 0.2 to 2.6 rad in 1.5 s."""
    model = kt.Model(
        nodes={"O": kt.Node(at=(0.0, 0.0)), "A": kt.Node(at=(ARM * math.cos(START), ARM * math.sin(START)), mass=MASS)},
        fixed={"O": "xy"},
        gravity=(0.0, -G),
        bars={"crank": kt.Bar(ends=("O", "A"), mass=0.0)},
        drives={"turn": kt.AngleDrive("crank", gear=GEAR, motor=MOTOR)},
    )
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (START, START + WAY)}, duration=DURATION), samples=301)
    found = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion))
    flow = kt.actuators.power_flow(model, motion, found)
    names = ("drive_torque", "motor_speed", "motor_torque", "current", "voltage", "electrical_power")
    at = {place: {name: found.data[name].values[k, 0] for name in names} for place, k in INSTANTS.items()}
    return at | {"balance": np.abs(flow["balance"]).max() / np.abs(flow["electrical"]).max()}


def robot() -> dict[str, float]:
    """Power of the three motors of a Delta robot without their losses and stored energy, compared with the rate of its
    energy.
    """
    plain = kt.library.mechanisms.delta(at=(0.0, 0.0, -0.7))
    drives = {name: drive.with_(gear=GEAR, motor=MOTOR) for name, drive in plain.drives.items()}
    model = plain.with_(drives=drives, gravity=(0.0, 0.0, -G))
    share = np.linspace(0.0, 1.0, 201)
    s = 10 * share**3 - 15 * share**4 + 6 * share**5
    way = zip("xyz", (0.0, 0.0, -0.7), (0.15, -0.1, -0.12), strict=True)
    path = kt.Spline(times=tuple(0.4 * share), values={f"Q.{axis}": tuple(c + d * s) for axis, c, d in way})
    motion = kt.kinematics.inverse(model, path, samples=201)
    forces = kt.dynamics.inverse(model, motion)
    flow = kt.actuators.power_flow(model, motion, kt.actuators.evaluate(model, motion, forces))
    spent = sum(flow[name].values for name in ("copper", "motor", "gear", "stored"))
    supplied = flow["electrical"].values
    missing = np.sum(supplied - spent, axis=1) - forces.data["energy_rate"].values
    return {"power": float(np.abs(missing).max() / np.abs(supplied.sum(axis=1)).max())}
