"""Drive trains forwards and backwards: self-locking limit, energy, the inverse of the forward drive, placed poles."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import actuators, dynamics, kinematics
from kinetruss.library import drives
from kinetruss.model import (
    Active,
    Amplifier,
    Cyclic,
    DriveLoad,
    DriveTrain,
    ExponentialInput,
    Gear,
    LeadScrew,
    Model,
    Part,
    PositionLoop,
    SineInput,
    StepInput,
)
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

ENERGY = Reference("identity", "First law: electrical = winding + motor + gear + screw + stored + mechanical")
INVERSE = Reference("agreement", "A forward drive train read backwards gives its own input")
POLES = Reference(
    "closed-form", "Step response of w^2/(s^2 + 2 zeta w s + w^2), closed form; Franklin et al., Feedback Control, ch. 3"
)
SHIGLEY = Reference("closed-form", "Shigley, power screws: self-locking where lead = mu d/2 sec(flank)")

LOSSY = drives.TRAIN_LACY.with_(
    gear=Gear(ratio=5.2, efficiency=0.8, inertia=1e-6),
    motor=drives.MOTOR_LACY.with_(friction_torque=1e-3, inductance=2e-3),
)
STEEP = LOSSY.with_(screw=LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1))
MASS, PUSH = 12.0, 300.0


def locking() -> dict[str, float]:
    """Lowering torque at the limit, square and trapezoidal thread; difference it makes to a drive that lowers a load."""
    square = drives.SCREW_LACY_PLANAR
    flank = math.radians(15)
    acme = LeadScrew(lead=0.1 * 0.006 / math.cos(flank), mean_diameter=0.012, friction=0.1, flank=flank)
    train = DriveTrain(screw=square, motor=drives.MOTOR_LACY)
    loaded, empty = (
        actuators.simulate_drive(train, StepInput(voltage=-1.0), load=load, duration=0.5, samples=11) for load in (100.0, 0.0)
    )
    return {
        "square_thread": actuators.lowering_torque(square, 1.0),
        "trapezoidal_thread": actuators.lowering_torque(acme, 1.0),
        "lowering_a_load": float(np.abs(loaded.length.values - empty.length.values).max()),
    }


def energy() -> dict[str, float]:
    """What is not accounted for, as a share: forwards of the energy, backwards of the largest power."""
    found = {}
    for name, train in (("self_locking", LOSSY), ("driven_back", STEEP)):
        run = actuators.simulate_drive(
            train, SineInput(voltage=20.0, period=0.5), load=DriveLoad(thrust=100.0, mass=10.0), duration=1.0, samples=201
        )
        found[f"forward_{name}"] = float(np.abs(run.energy_balance.values).max() / np.abs(run.electrical_energy.values).max())
        model = _model(train)
        motion = kinematics.follow(model, _swing(), samples=201)
        demand = actuators.evaluate(model, motion, dynamics.inverse(model, motion, static=False))
        flow = actuators.power_flow(model, motion, demand)
        found[f"inverse_{name}"] = float(np.abs(flow["balance"]).max() / np.abs(flow["electrical"]).max())
    return found


def round_trip() -> dict[str, float]:
    """Largest differences of voltage and current, as shares of the largest: sample by sample, and through a whole model."""
    train = drives.TRAIN_LACY
    history = ExponentialInput(voltage=(0.0, 12.0), time_constant=0.3)
    run = actuators.simulate_drive(train, history, load=DriveLoad(thrust=PUSH, mass=MASS + 0.5), duration=1.0, samples=1001)
    screw = drives.SCREW_LACY_SPATIAL
    torque = actuators.screw_torque(screw, run.thrust.values, run.length_rate.values)
    rate, acceleration = run.length_rate.values, run.length_acceleration.values
    direct = actuators.motor_demand(screw, train.gear, train.motor, torque, rate, acceleration)
    model = _model(train)
    motion = kinematics.follow(model, run.trajectory("M"), times=run.time.values)
    whole = actuators.evaluate(model, motion, dynamics.inverse(model, motion, static=False))
    moving, away = rate != 0, run.time.values > run.episodes[0].end + 0.02
    found = {}
    for name in ("voltage", "current"):
        given = run.data[name].values
        size = np.abs(given).max()
        found[f"{name}_by_sample"] = float(np.abs(direct[name] - given)[moving].max() / size)
        found[f"{name}_by_model"] = float(np.abs(whole.data[name].values[:, 0] - given)[away].max() / size)
    return found


def poles() -> dict[str, float]:
    """Lengths of a loop without friction behind a step of 1 mm, in mm of the step: a current and a voltage amplifier."""
    found: dict[str, float] = {}
    for name, amplifier in (("current", Amplifier(current_gain=1.8)), ("voltage", Amplifier(voltage_gain=3.0))):
        train = drives.TRAIN_LACY.with_(
            screw=drives.SCREW_LACY_SPATIAL.with_(friction=0.0),
            amplifier=amplifier,
            motor=drives.MOTOR_LACY.with_(max_voltage=None),
        )
        loop = PositionLoop(target=1.001, settling_time=0.5, damping=0.8)
        run = actuators.simulate_drive(train, loop, load=DriveLoad(mass=MASS), duration=0.5, times=TIMES)
        found |= {f"{name}_at_{t:g}s": float(x - 1) * 1e3 for t, x in zip(TIMES, run.length.values, strict=True)}
    return found


TIMES = (0.05, 0.1, 0.2, 0.3, 0.5)


def _step(t: float, w: float = 4 / (0.8 * 0.5), zeta: float = 0.8) -> float:
    damped = w * math.sqrt(1 - zeta**2)
    return 1 - math.exp(-zeta * w * t) * (math.cos(damped * t) + zeta * w / damped * math.sin(damped * t))


def _model(train: DriveTrain) -> Model:
    """One active member on a line pushes a mass against a force."""
    active = Active(
        ends=("A", "B"),
        base=Part(length=0.6, mass=2.0),
        tube=Part(length=0.4, mass=0.5),
        screw=train.screw,
        gear=train.gear,
        motor=train.motor,
    )
    return Model.model_validate(
        {
            "nodes": {"A": (0, 0), "B": {"at": (1, 0), "mass": MASS}},
            "fixed": {"A": "xy", "B": "y"},
            "active": {"M": active},
            "loads": {"push": {"node": "B", "force": (-PUSH, 0.0)}},
        }
    )


def _swing() -> Cyclic:
    return Cyclic(moves={"M": (1.0, 1.05)}, period=1.0)


def cases() -> Iterator[Case]:
    """Exact identities to round-off or to the tolerance of the integration, 1e-9."""
    for name in ("square_thread", "trapezoidal_thread"):
        yield Case(f"drive_train.locking.{name}", SHIGLEY, 0.0, 1e-15, locking, at=(name,), scale=1e-3)
    yield Case("drive_train.locking.lowering_a_load", SHIGLEY, 0.0, 1e-10, locking, at=("lowering_a_load",), scale=1.0)
    for name in ("self_locking", "driven_back"):
        for way, tolerance in (("forward", 1e-8), ("inverse", 1e-12)):
            key = f"{way}_{name}"
            yield Case(f"drive_train.energy.{key}", ENERGY, 0.0, tolerance, energy, at=(key,), scale=1.0)
    for name in ("voltage", "current"):
        for way, tolerance in (("by_sample", 1e-12), ("by_model", 1e-6)):
            key = f"{name}_{way}"
            yield Case(f"drive_train.inverse.{key}", INVERSE, 0.0, tolerance, round_trip, at=(key,), scale=1.0)
    for name in ("current", "voltage"):
        for t in TIMES:
            yield Case(f"drive_train.poles.{name}_at_{t:g}s", POLES, _step(t), 1e-8, poles, at=(f"{name}_at_{t:g}s",))
