"""Motors on angles: run-up of a disc and a placed loop in closed form, drive trains alone, a robot read backwards."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import actuators, dynamics
from kinetruss.library import mechanisms
from kinetruss.model import (
    DOP853,
    AngleDrive,
    Bar,
    DriveLoad,
    Gear,
    HingeDrive,
    Model,
    Motor,
    Node,
    PositionLoop,
    SineInput,
    StepInput,
)
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

RUN_UP = Reference(
    "closed-form", "(J_m n^2 + J) q'' = n K (U - K n q')/R, time constant R (J_m n^2 + J)/(K n)^2, last rate U/(K n)"
)
LOOP = Reference("closed-form", "q = target (1 - exp(-zeta w t)(cos w_d t + zeta w/w_d sin w_d t)), poles as asked for")
ALONE = Reference(
    "agreement", "drive train alone on the inertia that the motor turns, by another integration (`simulate_drive`)"
)
INVERSE = Reference("agreement", "inverse dynamics and drive demand along the motion")
ENERGY = Reference(
    "identity", "First law: electrical = copper + friction + gear + work of the torque + change of what is stored"
)

METHOD = DOP853(rtol=1e-11, atol=1e-12)
MASS, ARM, VOLTAGE = 1.7, 0.4, 12.0
INERTIA = MASS * ARM**2
IDEAL = Gear(ratio=12.0, inertia=3e-6)
MOTOR = Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
RUBBING = MOTOR.with_(friction_torque=0.004)
TRAINS: dict[str, tuple[Gear, Motor, Any]] = {
    "efficiency": (IDEAL.with_(efficiency=0.85), RUBBING.with_(inductance=2e-3), SineInput(voltage=20.0, period=0.25)),
    "worm": (
        Gear(ratio=40.0, efficiency=0.4, back_efficiency=-0.1, inertia=1e-5),
        RUBBING,
        SineInput(voltage=15.0, period=0.6),
    ),
    "torque": (IDEAL.with_(efficiency=0.85), RUBBING, SineInput(torque=0.2, period=0.5)),
}


def turning(kind: str, gear: Gear, motor: Motor) -> Model:
    """A point mass on a crank: driven at the angle of its bar in the plane, or at a hinge in space."""
    if kind == "angle":
        return Model(
            nodes={"O": (0.0, 0.0), "A": Node(at=(ARM, 0.0), mass=MASS)},
            fixed={"O": "xy"},
            bars={"crank": Bar(ends=("O", "A"), mass=0.0)},
            drives={"turn": AngleDrive("crank", gear=gear, motor=motor)},
        )
    return Model(
        nodes={"O": (0.0, 0.0, 0.0), "E": (0.0, 0.6, 0.8), "F": (1.0, 0.0, 0.0), "A": Node(at=(ARM, 0.0, 0.0), mass=MASS)},
        fixed=dict.fromkeys("OEF", "xyz"),
        bars={"near": Bar(ends=("O", "A"), mass=0.0), "far": Bar(ends=("E", "A"), mass=0.0)},
        drives={"turn": HingeDrive(axis=("O", "E"), start="F", end="A", gear=gear, motor=motor)},
    )


def run_up() -> dict[str, float]:
    """Largest differences of angle, rate, current and torque on the crank from the closed form, as shares of the largest."""
    n, R, K = IDEAL.ratio, MOTOR.resistance, MOTOR.torque_constant
    inertia = INERTIA + (MOTOR.inertia + IDEAL.inertia) * n**2
    tau, last, found = R * inertia / (K * n) ** 2, VOLTAGE / (K * n), {}
    for kind in ("angle", "hinge"):
        model = turning(kind, IDEAL, MOTOR)
        run = dynamics.simulate(model, 0.6, samples=31, tasks={"turn": StepInput(voltage=VOLTAGE)}, method=METHOD)
        t = run.motion.time.values
        decay = np.exp(-t / tau)
        pairs = {
            "angle": (run.motion.drive_position.values, last * (t - tau * (1 - decay))),
            "rate": (run.motion.drive_velocity.values, last * (1 - decay)),
            "current": (run.data.motor_current.values, VOLTAGE / R * decay),
            "torque": (run.forces.drive_force.values, INERTIA * last / tau * decay),
        }
        for name, (ours, exact) in pairs.items():
            found[f"{kind}.{name}"] = float(np.abs(ours[:, 0] - exact).max() / np.abs(exact).max())
    return found


def loop() -> dict[str, float]:
    """A position loop turns a hinge: largest difference from the closed form, as share of the target."""
    asked = PositionLoop(target=1.2, settling_time=0.4)
    run = dynamics.simulate(turning("hinge", IDEAL, MOTOR), 0.8, samples=41, tasks={"turn": asked}, method=METHOD)
    w, zeta, t = asked.natural_frequency, asked.damping, run.motion.time.values
    wd = w * np.sqrt(1 - zeta**2)
    exact = 1.2 * (1 - np.exp(-zeta * w * t) * (np.cos(wd * t) + zeta * w / wd * np.sin(wd * t)))
    return {"angle": float(np.abs(run.motion.drive_position.values[:, 0] - exact).max() / 1.2)}


def alone() -> dict[str, float]:
    """Largest differences of angles and currents from the train alone, as shares of their ranges; energy not accounted for."""
    found = {}
    for name, (gear, motor, history) in TRAINS.items():
        model = turning("angle", gear, motor)
        run = dynamics.simulate(model, 0.6, samples=31, tasks={"turn": history}, method=METHOD)
        same = actuators.simulate_drive(
            actuators.train_of(model, "turn"), history, load=DriveLoad(inertia=INERTIA), duration=0.6, samples=31, rtol=1e-11
        )
        for key, ours, theirs in (
            ("angle", run.motion.drive_position.values[:, 0], same.angle.values),
            ("current", run.data.motor_current.values[:, 0], same.current.values),
        ):
            found[f"{name}.{key}"] = float(np.abs(ours - theirs).max() / np.ptp(theirs))
        taken = run.data.electrical_energy.values.max()
        found[f"{name}.energy"] = float(np.abs(run.data.motor_energy_balance.values).max() / taken)
    return found


def robot() -> dict[str, float]:
    """Three motors of the robot of five freedoms in closed loop: current and voltage backwards, energy of all."""
    plain = mechanisms.robot(gravity=(0.0, 0.0, -9.81))
    motor = RUBBING.with_(inertia=1e-4, torque_constant=0.1, emf_constant=0.1, resistance=0.5)
    train = {"gear": Gear(ratio=80.0, efficiency=0.8, inertia=1e-5), "motor": motor}
    targets = {"swing": 0.6, "shoulder": -0.3, "wrist": -1.0}
    model = plain.with_(drives={n: one.with_(**train) if n in targets else one for n, one in plain.drives.items()})
    tasks = {name: PositionLoop(target=target, settling_time=0.3) for name, target in targets.items()}
    run = dynamics.simulate(model, 0.4, samples=21, tasks=tasks)
    demand = actuators.evaluate(model, run.motion, dynamics.inverse(model, run.motion, static=False)).data
    moving, found = np.abs(run.motion.drive_velocity.sel(drive=list(targets)).values) > 1e-6, {}
    for name in ("current", "voltage"):
        given = run.data[f"motor_{name}"].values
        found[name] = float(np.abs(demand[name].sel(active=list(targets)).values - given)[moving].max() / np.abs(given).max())
    energy, work = run.data.energy.values, run.data.actuator_work.values.sum(axis=1)
    found["energy"] = float(np.abs(energy - energy[0] - work).max() / np.ptp(energy))
    return found


def cases() -> Iterator[Case]:
    """Closed forms to what is left between the steps of an integration; two integrations of the same train; identities."""
    for kind in ("angle", "hinge"):
        for key in ("angle", "rate", "current", "torque"):
            yield Case(f"forward.rotary.run_up.{kind}.{key}", RUN_UP, 0.0, 1e-9, run_up, at=(f"{kind}.{key}",), scale=1.0)
    yield Case("forward.rotary.loop", LOOP, 0.0, 1e-9, loop, at=("angle",), scale=1.0)
    for name in TRAINS:
        # of a given torque the current is no result
        for key in ("angle",) if name == "torque" else ("angle", "current"):
            yield Case(f"forward.rotary.{name}.{key}", ALONE, 0.0, 1e-8, alone, at=(f"{name}.{key}",), scale=1.0)
        yield Case(f"forward.rotary.{name}.energy", ENERGY, 0.0, 1e-8, alone, at=(f"{name}.energy",), scale=1.0)
    for key in ("current", "voltage"):
        yield Case(f"forward.rotary.robot.{key}", INVERSE, 0.0, 1e-8, robot, at=(key,), scale=1.0)
    yield Case("forward.rotary.robot.energy", ENERGY, 0.0, 1e-8, robot, at=("energy",), scale=1.0)
