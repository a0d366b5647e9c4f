"""The drive train of an active member."""

from __future__ import annotations

from typing import NamedTuple

from kinetruss.errors import InputError
from kinetruss.model import Active, Amplifier, DriveTrain, Gear, LeadScrew, Model, Motor, nearest

__all__ = ["Parts", "parts_of", "train_of"]


class Parts(NamedTuple):
    """What is known of the drive train of an active member."""

    screw: LeadScrew | None
    gear: Gear | None
    motor: Motor | None
    amplifier: Amplifier | None


def parts_of(model: Model, active: Active) -> Parts:
    """Screw, gear, motor and amplifier of an active member, looked up where they are named; None where it has none."""
    return Parts(
        model.screws[active.screw] if isinstance(active.screw, str) else active.screw,
        model.gears[active.gear] if isinstance(active.gear, str) else active.gear,
        model.motors[active.motor] if isinstance(active.motor, str) else active.motor,
        model.amplifiers[active.amplifier] if isinstance(active.amplifier, str) else active.amplifier,
    )


def train_of(model: Model, member: str) -> DriveTrain:
    """The drive train of an active member of `model`, as `simulate_drive` takes it.

    Raises
    ------
    InputError : no active member of that name, or one without screw or motor.
    """
    if member not in model.active:
        raise InputError(f"The model has no active member {member!r}. {nearest(member, model.active)}")
    screw, gear, motor, amplifier = parts_of(model, model.active[member])
    if screw is None or motor is None:
        lacks = " and no ".join(name for name, part in (("screw", screw), ("motor", motor)) if part is None)
        raise InputError(f"Active member {member!r} has no {lacks}: there is no drive train. Give it one.")
    return DriveTrain(screw=screw, motor=motor, gear=gear or Gear(ratio=1.0), amplifier=amplifier)
