"""Motors in a structure: a closed form, the same drive trains alone, inverse dynamics of what they did, energy."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import actuators, dynamics
from kinetruss.library import drives, vgt
from kinetruss.model import (
    DOP853,
    Active,
    Amplifier,
    DriveLoad,
    DriveTrain,
    Gear,
    LeadScrew,
    Model,
    Node,
    Part,
    PositionLoop,
    SineInput,
    StepInput,
)
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

RUN_UP = Reference(
    "closed-form", "Direct-current motor at a constant voltage, closed form: v = v0 (1 - exp(-t/tau)), tau = J' R/(K_t K_b)"
)
ALONE = Reference("agreement", "the same drive train behind the same mass alone, integrated as a first-order system of its own")
INVERSE = Reference("agreement", "inverse dynamics along the motion found, and the motors' equations read backwards")
ENERGY = Reference("identity", "First law: electrical = winding + motor + gear + screw + stored + work on the structure")
LOCKED = Reference("identity", "self-locking screw without voltage")

METHOD = DOP853(rtol=1e-11, atol=1e-12)
MASS, PUSH = 12.5, 60.0
LACY = drives.TRAIN_LACY
LOSSY = LACY.with_(
    gear=Gear(ratio=5.2, efficiency=0.8, inertia=1e-6), motor=drives.MOTOR_LACY.with_(friction_torque=1e-3, inductance=2e-2)
)
TRAINS: dict[str, tuple[DriveTrain, Any]] = {
    "pulse": (LACY, StepInput(voltage=12.0, start=0.1, end=0.4)),
    "reversals": (LOSSY, SineInput(voltage=20.0, period=0.25)),
    "driven_back": (LOSSY.with_(screw=LeadScrew(lead=2e-3, mean_diameter=0.0127, friction=0.1)), StepInput(voltage=0.0)),
    "sticking": (
        LACY.with_(screw=drives.SCREW_LACY_SPATIAL.with_(static_friction=0.35)),
        SineInput(voltage=8.0, period=0.4),
    ),
    "saturated_loop": (
        LACY.with_(amplifier=Amplifier(voltage_gain=3.0, max_voltage=9.0)),
        PositionLoop(target=1.002, settling_time=0.2),
    ),
}


def pushing(train: DriveTrain) -> Model:
    """An active member on a line pushes a mass against a force."""
    member = Active(
        ends=("A", "B"),
        base=Part(length=0.6, mass=2.0),
        tube=Part(length=0.4, mass=0.5),
        screw=train.screw,
        gear=train.gear,
        motor=train.motor,
        amplifier=train.amplifier,
    )
    return Model.model_validate(
        {
            "nodes": {"A": (0.0, 0.0), "B": Node(at=(1.0, 0.0), mass=MASS - 0.5)},
            "fixed": {"A": "xy", "B": "y"},
            "active": {"M": member},
            "loads": {"push": {"node": "B", "force": (-PUSH, 0.0)}},
        }
    )


def run_up() -> dict[str, float]:
    """Largest difference of lengths from the closed form, as share of the stroke."""
    train = LACY.with_(screw=drives.SCREW_LACY_SPATIAL.with_(friction=0.0))
    motor, per_metre, voltage = train.motor, train.gear.ratio / drives.SCREW_LACY_SPATIAL.lead, 10.0
    run = dynamics.simulate(pushing(train), 0.3, samples=31, tasks={"M": StepInput(voltage=voltage)}, method=METHOD)
    inertia = (motor.inertia + train.gear.inertia) * per_metre + MASS / per_metre
    tau = inertia * motor.resistance / (motor.torque_constant * motor.emf_constant * per_metre)
    last = (voltage - PUSH / per_metre * motor.resistance / motor.torque_constant) / (motor.emf_constant * per_metre)
    t = run.motion.time.values
    length = 1 + last * (t - tau * (1 - np.exp(-t / tau)))
    return {"run_up": float(np.abs(run.motion.length.values[:, 0] - length).max() / np.ptp(length))}


def alone() -> dict[str, float]:
    """Largest differences of lengths, as shares of the stroke, and of currents, of the largest."""
    found = {}
    for name, (train, history) in TRAINS.items():
        run = dynamics.simulate(pushing(train), 0.5, samples=26, tasks={"M": history}, method=METHOD)
        same = actuators.simulate_drive(
            train, history, load=DriveLoad(thrust=PUSH, mass=MASS), length=1.0, duration=0.5, samples=26, rtol=1e-11
        )
        for key, ours, theirs in (
            ("length", run.motion.length.values[:, 0], same.length.values),
            ("current", run.data.motor_current.values[:, 0], same.current.values),
        ):
            found[f"{name}_{key}"] = float(np.abs(ours - theirs).max() / np.ptp(theirs))
    return found


def together() -> dict[str, float]:
    """Three motors of a bay in closed loop: current and voltage backwards; energy; one of them without voltage."""
    bay = vgt.double_octahedral(
        tip_force=(0.0, 0.0, -46.0), screw=drives.SCREW_LACY_SPATIAL, gear=drives.GEAR_LACY, motor=drives.MOTOR_LACY
    )
    targets = {"M7": 1.160, "M9": 1.175, "M11": 1.172}
    tasks = {name: PositionLoop(target=target, settling_time=0.4) for name, target in targets.items()}
    run = dynamics.simulate(bay, 0.6, samples=61, tasks=tasks)
    demand = actuators.evaluate(bay, run.motion, dynamics.inverse(bay, run.motion, static=False)).data
    moving = np.abs(run.motion.length_rate.sel(member=list(targets)).values) > 1e-8
    found = {}
    for name in ("current", "voltage"):
        given = run.data[f"motor_{name}"].values
        found[name] = float(np.abs(demand[name].values - given)[moving].max() / np.abs(given).max())
    taken = run.data.electrical_energy.values
    found["energy"] = float(np.abs(run.data.motor_energy_balance.values).max() / taken.max())
    locked = dynamics.simulate(bay, 0.2, samples=3, tasks={"M7": StepInput(voltage=20.0), "M9": StepInput(voltage=0.0)})
    lengths = locked.motion.length.sel(member="M9").values
    found["locked"] = float(np.abs(lengths - lengths[0]).max())
    return found


def cases() -> Iterator[Case]:
    """A closed form to the tolerance of the integration; two integrations of the same drive; identities."""
    yield Case("forward.motor.run_up", RUN_UP, 0.0, 1e-10, run_up, at=("run_up",), scale=1.0)
    for name in TRAINS:
        for key in ("length", "current"):
            yield Case(f"forward.motor.{name}.{key}", ALONE, 0.0, 1e-8, alone, at=(f"{name}_{key}",), scale=1.0)
    for key in ("current", "voltage"):
        yield Case(f"forward.motor.bay.{key}", INVERSE, 0.0, 1e-8, together, at=(key,), scale=1.0)
    yield Case("forward.motor.bay.energy", ENERGY, 0.0, 1e-8, together, at=("energy",), scale=1.0)
    yield Case("forward.motor.bay.locked", LOCKED, 0.0, 1e-13, together, at=("locked",), scale=1.0)
