"""Drive trains forwards and backwards: self-locking limit, energy, the inverse of the forward drive, placed poles."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import cylinder

drives = kt.library.drives

LOSSY = drives.TRAIN_LACY.with_(
    gear=kt.Gear(ratio=5.2, efficiency=0.8, inertia=1e-6),
    motor=drives.MOTOR_LACY.with_(friction_torque=1e-3, inductance=2e-3),
)
STEEP = LOSSY.with_(screw=kt.LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1))
MASS, PUSH = 12.0, 300.0


def locking() -> dict[str, float]:
    """Lowering torque at the limit, square and trapezoidal thread; difference it makes to a drive that lowers a load."""
    square = drives.SCREW_LACY_PLANAR
    flank = math.radians(15)
    acme = kt.LeadScrew(lead=0.1 * 0.006 / math.cos(flank), mean_diameter=0.012, friction=0.1, flank=flank)
    train = kt.DriveTrain(screw=square, motor=drives.MOTOR_LACY)
    loaded, empty = (
        kt.actuators.simulate_drive(train, kt.StepInput(voltage=-1.0), load=load, duration=0.5, samples=11)
        for load in (100.0, 0.0)
    )
    return {
        "square_thread": kt.actuators.lowering_torque(square, 1.0),
        "trapezoidal_thread": kt.actuators.lowering_torque(acme, 1.0),
        "lowering_a_load": float(np.abs(loaded.length.values - empty.length.values).max()),
    }


def energy() -> dict[str, float]:
    """Errors of the balance: forwards as a fraction of the energy, backwards of the largest power."""
    found = {}
    for name, train in (("self_locking", LOSSY), ("driven_back", STEEP)):
        run = kt.actuators.simulate_drive(
            train, kt.SineInput(voltage=20.0, period=0.5), load=kt.DriveLoad(thrust=100.0, mass=10.0), duration=1.0, samples=201
        )
        found[f"forward_{name}"] = float(np.abs(run.energy_balance.values).max() / np.abs(run.electrical_energy.values).max())
        model = cylinder(train, MASS, PUSH)
        motion = kt.kinematics.follow(model, kt.Cyclic(moves={"M": (1.0, 1.05)}, period=1.0), samples=201)
        demand = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion, static=False))
        flow = kt.actuators.power_flow(model, motion, demand)
        found[f"inverse_{name}"] = float(np.abs(flow["balance"]).max() / np.abs(flow["electrical"]).max())
    return found


def round_trip() -> dict[str, float]:
    """Largest differences of voltage and current, as fractions of the largest: sample by sample, and through a whole model."""
    train = drives.TRAIN_LACY
    history = kt.ExponentialInput(voltage=(0.0, 12.0), time_constant=0.3)
    run = kt.actuators.simulate_drive(
        train, history, load=kt.DriveLoad(thrust=PUSH, mass=MASS + 0.5), duration=1.0, samples=1001
    )
    screw = drives.SCREW_LACY_SPATIAL
    torque = kt.actuators.screw_torque(screw, run.thrust.values, run.length_rate.values)
    rate, acceleration = run.length_rate.values, run.length_acceleration.values
    direct = kt.actuators.motor_demand(screw, train.gear, train.motor, torque, rate, acceleration)
    model = cylinder(train, MASS, PUSH)
    motion = kt.kinematics.follow(model, run.trajectory("M"), times=run.time.values)
    whole = kt.actuators.evaluate(model, motion, kt.dynamics.inverse(model, motion, static=False))
    moving, away = rate != 0, run.time.values > run.episodes[0].end + 0.02
    found = {}
    for name in ("voltage", "current"):
        given = run.data[name].values
        size = np.abs(given).max()
        found[f"{name}_by_sample"] = float(np.abs(direct[name] - given)[moving].max() / size)
        found[f"{name}_by_model"] = float(np.abs(whole.data[name].values[:, 0] - given)[away].max() / size)
    return found


def poles() -> dict[str, float]:
    """Lengths of a position loop without friction after a step of 1 mm, as a fraction of the step: a current and a voltage
    amplifier.
    """
    found: dict[str, float] = {}
    for name, amplifier in (("current", kt.Amplifier(current_gain=1.8)), ("voltage", kt.Amplifier(voltage_gain=3.0))):
        train = drives.TRAIN_LACY.with_(
            screw=drives.SCREW_LACY_SPATIAL.with_(friction=0.0),
            amplifier=amplifier,
            motor=drives.MOTOR_LACY.with_(max_voltage=None),
        )
        loop = kt.PositionLoop(target=1.001, settling_time=0.5, damping=0.8)
        run = kt.actuators.simulate_drive(train, loop, load=kt.DriveLoad(mass=MASS), duration=0.5, times=TIMES)
        found |= {f"{name}_at_{t:g}s": float(x - 1) * 1e3 for t, x in zip(TIMES, run.length.values, strict=True)}
    return found


TIMES = (0.05, 0.1, 0.2, 0.3, 0.5)
