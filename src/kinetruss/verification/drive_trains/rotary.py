"""Gears and motors on drives of angles: a geared crank by hand, power through a robot's motors."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import actuators, dynamics, kinematics
from kinetruss.library import mechanisms
from kinetruss.model import AngleDrive, Bar, Gear, Model, Motor, Node, Quintic, Spline
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

CRANK = Reference(
    "closed-form", "T = m l^2 q'' + m g l cos q; T_m = T eta^(-+1)/G + J G q'' + T_f, i = T_m/K, U = R i + K G q'"
)
BALANCE = Reference("identity", "First law: electrical = winding + motor + gear + stored + torque x rate")
ROBOT = Reference("identity", "First law: power of all motors = their losses and stores + rate of energy of the mechanism")

GEAR = Gear(ratio=12.0, efficiency=0.85, inertia=3e-6)
MOTOR = Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06, friction_torque=0.004)
MASS, ARM, G, START, WAY, DURATION = 1.7, 0.4, 9.81, 0.2, 2.4, 1.5
INSTANTS = {"driving": 90, "driven": 240}
"""Samples of 301: the motor lifts the crank, and behind the top the crank drives the motor."""


def crank() -> dict[str, float]:
    """A geared crank with a point mass in the vertical plane, from 0.2 to 2.6 rad in 1.5 s."""
    model = Model(
        nodes={"O": Node(at=(0.0, 0.0)), "A": Node(at=(ARM * math.cos(START), ARM * math.sin(START)), mass=MASS)},
        fixed={"O": "xy"},
        gravity=(0.0, -G),
        bars={"crank": Bar(ends=("O", "A"), mass=0.0)},
        drives={"turn": AngleDrive("crank", gear=GEAR, motor=MOTOR)},
    )
    motion = kinematics.follow(model, Quintic(moves={"turn": (START, START + WAY)}, duration=DURATION), samples=301)
    found = actuators.evaluate(model, motion, dynamics.inverse(model, motion))
    flow = actuators.power_flow(model, motion, found)
    return {
        f"{place}.{name}": found.data[name].values[at, 0].item() for place, at in INSTANTS.items() for name in _by_hand(0.5)
    } | {"balance": float(np.abs(flow["balance"]).max() / np.abs(flow["electrical"]).max())}


def robot() -> dict[str, float]:
    """Power of the three motors of a Delta robot without their losses and stores, beside the rate of its energy."""
    plain = mechanisms.delta(at=(0.0, 0.0, -0.7))
    drives = {name: drive.with_(gear=GEAR, motor=MOTOR) for name, drive in plain.drives.items()}
    model = plain.with_(drives=drives, gravity=(0.0, 0.0, -G))
    share = np.linspace(0.0, 1.0, 201)
    s = 10 * share**3 - 15 * share**4 + 6 * share**5
    way = zip("xyz", (0.0, 0.0, -0.7), (0.15, -0.1, -0.12), strict=True)
    path = Spline(times=tuple(0.4 * share), values={f"Q.{axis}": tuple(c + d * s) for axis, c, d in way})
    motion = kinematics.inverse(model, path, samples=201)
    forces = dynamics.inverse(model, motion)
    flow = actuators.power_flow(model, motion, actuators.evaluate(model, motion, forces))
    spent = sum(flow[name].values for name in ("copper", "motor", "gear", "stored"))
    supplied = flow["electrical"].values
    missing = np.sum(supplied - spent, axis=1) - forces.data["energy_rate"].values
    return {"power": float(np.abs(missing).max() / np.abs(supplied.sum(axis=1)).max())}


def _by_hand(s: float) -> dict[str, float]:
    """Demands at a share s of the duration (SI), no standstill."""
    q = START + WAY * (10 * s**3 - 15 * s**4 + 6 * s**5)
    rate = WAY / DURATION * 30 * s**2 * (1 - s) ** 2
    second = WAY / DURATION**2 * (60 * s - 180 * s**2 + 120 * s**3)
    torque = MASS * ARM**2 * second + MASS * G * ARM * math.cos(q)
    loss = 1 / GEAR.efficiency if torque * rate > 0 else GEAR.efficiency
    speed = GEAR.ratio * rate
    at_motor = torque * loss / GEAR.ratio + (MOTOR.inertia + GEAR.inertia) * GEAR.ratio * second + MOTOR.friction_torque
    current = at_motor / MOTOR.torque_constant
    voltage = MOTOR.resistance * current + MOTOR.emf_constant * speed
    return {
        "drive_torque": torque,
        "motor_speed": speed,
        "motor_torque": at_motor,
        "current": current,
        "voltage": voltage,
        "electrical_power": voltage * current,
    }


def cases() -> Iterator[Case]:
    """Closed forms of a crank, first law of a crank and of a robot."""
    for place, at in INSTANTS.items():
        for name, value in _by_hand(at / 300).items():
            yield Case(f"actuators.rotary.{place}.{name}", CRANK, value, 1e-10, crank, (), (f"{place}.{name}",))
    yield Case("actuators.rotary.balance", BALANCE, 0.0, 1e-12, crank, (), ("balance",), 1.0)
    yield Case("actuators.rotary.delta", ROBOT, 0.0, 1e-9, robot, (), ("power",), 1.0)
