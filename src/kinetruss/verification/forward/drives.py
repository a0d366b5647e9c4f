"""Drives that push: a given force, and a motor behind its screw, against the same drive train alone."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from kinetruss import actuators, dynamics
from kinetruss.library import drives
from kinetruss.model import DOP853, Active, DriveLoad, GivenForce, Model, Node, Part, StepInput
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

PUSHED = Reference("closed-form", "x = x0 + F t^2/(2 m)")
MOTOR = Reference("agreement", "the same drive train behind the same mass alone, integrated as a first-order system of its own")


def cylinder() -> Model:
    """An active member on a line pushes a mass."""
    train = drives.TRAIN_LACY
    active = Active(
        ends=("A", "B"),
        base=Part(length=0.6, mass=2.0),
        tube=Part(length=0.4, mass=0.5),
        screw=train.screw,
        gear=train.gear,
        motor=train.motor,
    )
    return Model(
        nodes={"A": (0.0, 0.0), "B": Node(at=(1.0, 0.0), mass=12.0)}, fixed={"A": "xy", "B": "y"}, active={"M": active}
    )


def pushed() -> dict[str, float]:
    """Length after 1 s under 50 N."""
    method = DOP853(rtol=1e-12, atol=1e-13)
    run = dynamics.simulate(cylinder(), 1.0, samples=3, tasks={"M": GivenForce(force=50.0)}, method=method)
    return {"force": run.motion.length.sel(member="M").values[-1].item()}


def motor() -> dict[str, float]:
    """Largest difference of lengths behind the motor, as share of the stroke."""
    task = StepInput(voltage=6.0)
    run = dynamics.simulate(cylinder(), 1.0, samples=101, tasks={"M": task})
    alone = actuators.simulate_drive(drives.TRAIN_LACY, task, load=DriveLoad(mass=12.5), length=1.0, duration=1.0, samples=101)
    length = run.motion.length.sel(member="M").values
    return {"motor": float(np.abs(length - alone.length.values).max() / np.ptp(alone.length.values))}


def cases() -> Iterator[Case]:
    """A closed form; two integrations of the same drive."""
    yield Case("forward.drive.given_force", PUSHED, 1 + 50.0 / 12.5 / 2, 1e-10, pushed, (), ("force",))
    yield Case("forward.drive.motor", MOTOR, 0.0, 1e-7, motor, (), ("motor",), 1.0)
