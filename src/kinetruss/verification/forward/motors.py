"""A given force; motors in a structure: closed forms, drive trains alone, inverse dynamics of what they did, energy."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import cylinder

METHOD = kt.DOP853(rtol=1e-11, atol=1e-12)
MASS, PUSH = 12.5, 60.0
LACY, SCREW = kt.library.drives.TRAIN_LACY, kt.library.drives.SCREW_LACY_SPATIAL
LOSSY = LACY.with_(
    gear=kt.Gear(ratio=5.2, efficiency=0.8, inertia=1e-6),
    motor=kt.library.drives.MOTOR_LACY.with_(friction_torque=1e-3, inductance=2e-2),
)
TRAINS: dict[str, tuple[kt.DriveTrain, Any]] = {
    "pulse": (LACY, kt.StepInput(voltage=12.0, start=0.1, end=0.4)),
    "reversals": (LOSSY, kt.SineInput(voltage=20.0, period=0.25)),
    "driven_back": (LOSSY.with_(screw=kt.LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1)), kt.StepInput(voltage=0.0)),
    "sticking": (
        LACY.with_(screw=SCREW.with_(static_friction=0.35)),
        kt.SineInput(voltage=8.0, period=0.4),
    ),
    "saturated_loop": (
        LACY.with_(amplifier=kt.Amplifier(voltage_gain=3.0, max_voltage=9.0)),
        kt.PositionLoop(target=1.002, settling_time=0.2),
    ),
}


def pushed() -> dict[str, float]:
    """Length after 1 s under 50 N."""
    method = kt.DOP853(rtol=1e-12, atol=1e-13)
    run = kt.dynamics.simulate(cylinder(LACY, 12.0), 1.0, samples=3, tasks={"M": kt.GivenForce(force=50.0)}, method=method)
    return {"force": run.motion.length.values[-1, 0]}


def default() -> dict[str, float]:
    """Largest difference of lengths with a motor by default settings, as a fraction of the stroke."""
    task = kt.StepInput(voltage=6.0)
    run = kt.dynamics.simulate(cylinder(LACY, 12.0), 1.0, samples=101, tasks={"M": task})
    same = kt.actuators.simulate_drive(LACY, task, load=kt.DriveLoad(mass=12.5), length=1.0, duration=1.0, samples=101)
    return {"motor": float(np.abs(run.motion.length.values[:, 0] - same.length.values).max() / np.ptp(same.length.values))}


def run_up() -> dict[str, float]:
    """Largest difference of lengths from the closed form, as a fraction of the stroke."""
    train = LACY.with_(screw=SCREW.with_(friction=0.0))
    motor, per_metre, voltage = train.motor, train.gear.ratio / SCREW.lead, 10.0
    run = kt.dynamics.simulate(
        cylinder(train, MASS - 0.5, PUSH), 0.3, samples=31, tasks={"M": kt.StepInput(voltage=voltage)}, method=METHOD
    )
    inertia = (motor.inertia + train.gear.inertia) * per_metre + MASS / per_metre
    tau = inertia * motor.resistance / (motor.torque_constant * motor.emf_constant * per_metre)
    last = (voltage - PUSH / per_metre * motor.resistance / motor.torque_constant) / (motor.emf_constant * per_metre)
    t = run.motion.time.values
    length = 1 + last * (t - tau * (1 - np.exp(-t / tau)))
    return {"run_up": float(np.abs(run.motion.length.values[:, 0] - length).max() / np.ptp(length))}


def alone() -> dict[str, float]:
    """Largest differences of lengths, as fractions of the stroke, and of currents, of the largest."""
    found = {}
    for name, (train, history) in TRAINS.items():
        run = kt.dynamics.simulate(cylinder(train, MASS - 0.5, PUSH), 0.5, samples=26, tasks={"M": history}, method=METHOD)
        same = kt.actuators.simulate_drive(
            train, history, load=kt.DriveLoad(thrust=PUSH, mass=MASS), length=1.0, duration=0.5, samples=26, rtol=1e-11
        )
        for key, ours, theirs in (
            ("length", run.motion.length.values[:, 0], same.length.values),
            ("current", run.data.motor_current.values[:, 0], same.current.values),
        ):
            found[f"{name}.{key}"] = float(np.abs(ours - theirs).max() / np.ptp(theirs))
    return found


def together() -> dict[str, float]:
    """Three motors of a bay in closed loop: current and voltage backwards; energy; one of them without voltage."""
    bay = kt.library.vgt.double_octahedral(
        tip_force=(0.0, 0.0, -46.0),
        screw=SCREW,
        gear=kt.library.drives.GEAR_LACY,
        motor=kt.library.drives.MOTOR_LACY,
    )
    targets = {"M7": 1.160, "M9": 1.175, "M11": 1.172}
    tasks = {name: kt.PositionLoop(target=target, settling_time=0.4) for name, target in targets.items()}
    run = kt.dynamics.simulate(bay, 0.6, samples=61, tasks=tasks)
    demand = kt.actuators.evaluate(bay, run.motion, kt.dynamics.inverse(bay, run.motion, static=False)).data
    moving = np.abs(run.motion.length_rate.sel(member=list(targets)).values) > 1e-8
    found = {}
    for name in ("current", "voltage"):
        given = run.data[f"motor_{name}"].values
        found[name] = float(np.abs(demand[name].values - given)[moving].max() / np.abs(given).max())
    taken = run.data.electrical_energy.values
    found["energy"] = float(np.abs(run.data.motor_energy_balance.values).max() / taken.max())
    locked = kt.dynamics.simulate(
        bay, 0.2, samples=3, tasks={"M7": kt.StepInput(voltage=20.0), "M9": kt.StepInput(voltage=0.0)}
    )
    lengths = locked.motion.length.sel(member="M9").values
    found["locked"] = float(np.abs(lengths - lengths[0]).max())
    return found
