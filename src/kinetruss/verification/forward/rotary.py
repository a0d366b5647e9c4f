"""Motors on angles: run-up of a disc and a placed loop in closed form, drive trains alone, a robot read backwards."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import off

METHOD = kt.DOP853(rtol=1e-11, atol=1e-12)
MASS, ARM, VOLTAGE = 1.7, 0.4, 12.0
INERTIA = MASS * ARM**2
IDEAL = kt.Gear(ratio=12.0, inertia=3e-6)
MOTOR = kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
RUBBING = MOTOR.with_(friction_torque=0.004)
TRAINS: dict[str, tuple[kt.Gear, kt.Motor, Any]] = {
    "efficiency": (IDEAL.with_(efficiency=0.85), RUBBING.with_(inductance=2e-3), kt.SineInput(voltage=20.0, period=0.25)),
    "worm": (
        kt.Gear(ratio=40.0, efficiency=0.4, back_efficiency=-0.1, inertia=1e-5),
        RUBBING,
        kt.SineInput(voltage=15.0, period=0.6),
    ),
    "torque": (IDEAL.with_(efficiency=0.85), RUBBING, kt.SineInput(torque=0.2, period=0.5)),
}


def turning(kind: str, gear: kt.Gear, motor: kt.Motor) -> kt.Model:
    """A point mass on a crank: driven at the angle of its bar in the plane, or at a hinge in space."""
    if kind == "angle":
        return kt.Model(
            nodes={"O": (0.0, 0.0), "A": kt.Node(at=(ARM, 0.0), mass=MASS)},
            fixed={"O": "xy"},
            bars={"crank": kt.Bar(ends=("O", "A"), mass=0.0)},
            drives={"turn": kt.AngleDrive("crank", gear=gear, motor=motor)},
        )
    return kt.Model(
        nodes={"O": (0.0, 0.0, 0.0), "E": (0.0, 0.6, 0.8), "F": (1.0, 0.0, 0.0), "A": kt.Node(at=(ARM, 0.0, 0.0), mass=MASS)},
        fixed=dict.fromkeys("OEF", "xyz"),
        bars={"near": kt.Bar(ends=("O", "A"), mass=0.0), "far": kt.Bar(ends=("E", "A"), mass=0.0)},
        drives={"turn": kt.HingeDrive(axis=("O", "E"), start="F", end="A", gear=gear, motor=motor)},
    )


def run_up() -> dict[str, float]:
    """Largest differences of angle, rate, current and torque on the crank from the closed form, as fractions of the largest."""
    n, R, K = IDEAL.ratio, MOTOR.resistance, MOTOR.torque_constant
    inertia = INERTIA + (MOTOR.inertia + IDEAL.inertia) * n**2
    tau, last, found = R * inertia / (K * n) ** 2, VOLTAGE / (K * n), {}
    for kind in ("angle", "hinge"):
        model = turning(kind, IDEAL, MOTOR)
        run = kt.dynamics.simulate(model, 0.6, samples=31, tasks={"turn": kt.StepInput(voltage=VOLTAGE)}, method=METHOD)
        t = run.motion.time.values
        decay = np.exp(-t / tau)
        pairs = {
            "angle": (run.motion.drive_position.values, last * (t - tau * (1 - decay))),
            "rate": (run.motion.drive_velocity.values, last * (1 - decay)),
            "current": (run.data.motor_current.values, VOLTAGE / R * decay),
            "torque": (run.forces.drive_force.values, INERTIA * last / tau * decay),
        }
        for name, (ours, exact) in pairs.items():
            found[f"{kind}.{name}"] = off(ours[:, 0], exact)
    return found


def loop() -> dict[str, float]:
    """A position loop turns a hinge: largest difference from the closed form, as a fraction of the target."""
    asked = kt.PositionLoop(target=1.2, settling_time=0.4)
    run = kt.dynamics.simulate(turning("hinge", IDEAL, MOTOR), 0.8, samples=41, tasks={"turn": asked}, method=METHOD)
    w, zeta, t = asked.natural_frequency, asked.damping, run.motion.time.values
    wd = w * np.sqrt(1 - zeta**2)
    exact = 1.2 * (1 - np.exp(-zeta * w * t) * (np.cos(wd * t) + zeta * w / wd * np.sin(wd * t)))
    return {"angle": float(np.abs(run.motion.drive_position.values[:, 0] - exact).max() / 1.2)}


def alone() -> dict[str, float]:
    """Largest differences of angles and currents from the train alone, as fractions of their ranges; error of the energy
    balance.
    """
    found = {}
    for name, (gear, motor, history) in TRAINS.items():
        model = turning("angle", gear, motor)
        run = kt.dynamics.simulate(model, 0.6, samples=31, tasks={"turn": history}, method=METHOD)
        same = kt.actuators.simulate_drive(
            kt.actuators.train_of(model, "turn"),
            history,
            load=kt.DriveLoad(inertia=INERTIA),
            duration=0.6,
            samples=31,
            rtol=1e-11,
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
    plain = kt.library.mechanisms.robot(gravity=(0.0, 0.0, -9.81))
    motor = RUBBING.with_(inertia=1e-4, torque_constant=0.1, emf_constant=0.1, resistance=0.5)
    train = {"gear": kt.Gear(ratio=80.0, efficiency=0.8, inertia=1e-5), "motor": motor}
    targets = {"swing": 0.6, "shoulder": -0.3, "wrist": -1.0}
    model = plain.with_(drives={n: one.with_(**train) if n in targets else one for n, one in plain.drives.items()})
    tasks = {name: kt.PositionLoop(target=target, settling_time=0.3) for name, target in targets.items()}
    run = kt.dynamics.simulate(model, 0.4, samples=21, tasks=tasks)
    demand = kt.actuators.evaluate(model, run.motion, kt.dynamics.inverse(model, run.motion, static=False)).data
    moving, found = np.abs(run.motion.drive_velocity.sel(drive=list(targets)).values) > 1e-6, {}
    for name in ("current", "voltage"):
        given = run.data[f"motor_{name}"].values
        found[name] = float(np.abs(demand[name].sel(active=list(targets)).values - given)[moving].max() / np.abs(given).max())
    energy, work = run.data.energy.values, run.data.actuator_work.values.sum(axis=1)
    found["energy"] = float(np.abs(energy - energy[0] - work).max() / np.ptp(energy))
    return found
