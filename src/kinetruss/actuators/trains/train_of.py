"""The drive train of an active member, or of a drive of an angle."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from kinetruss.errors import InputError
from kinetruss.model import (
    Active,
    Amplifier,
    AngleDrive,
    DriveTrain,
    Gear,
    HingeDrive,
    LeadScrew,
    Model,
    Motor,
    nearest,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Geared", "Output", "Parts", "output_of", "parts_of", "train_of"]

Geared = Active | AngleDrive | HingeDrive
"""What a drive train belongs to."""


class Parts(NamedTuple):
    """What is known of a drive train; of that of an angle, there is no screw."""

    screw: LeadScrew | None
    gear: Gear | None
    motor: Motor | None
    amplifier: Amplifier | None


class Output(NamedTuple):
    """Where the gear ends: rate of the length or angle (m/s or rad/s), torque there (N m) and speed (rad/s).

    lead : rate over speed, m/rad of a screw, 1 of an angle.
    """

    rate: NDArray[np.float64]
    torque: NDArray[np.float64]
    speed: NDArray[np.float64]
    lead: float


def output_of(parts: Parts, one: Geared, data: Mapping[str, NDArray[np.float64]]) -> Output | None:
    """What the histories of an actuator say behind its gear; None of a member without a screw."""
    if not isinstance(one, Active):
        return Output(data["angle_rate"], data["drive_torque"], data["angle_rate"], 1.0)
    if parts.screw is None:
        return None
    return Output(data["length_rate"], data["screw_torque"], data["screw_speed"], parts.screw.lead)


def parts_of(model: Model, active: Geared) -> Parts:
    """Screw, gear, motor and amplifier of an actuator, looked up where they are named; None where it has none."""
    screw = active.screw if isinstance(active, Active) else None
    return Parts(
        model.screws[screw] if isinstance(screw, str) else screw,
        model.gears[active.gear] if isinstance(active.gear, str) else active.gear,
        model.motors[active.motor] if isinstance(active.motor, str) else active.motor,
        model.amplifiers[active.amplifier] if isinstance(active.amplifier, str) else active.amplifier,
    )


def train_of(model: Model, name: str) -> DriveTrain:
    """The drive train of an active member, or of a drive of an angle (without a screw), as `simulate_drive` takes it.

    Raises
    ------
    InputError : nothing of that name, no screw, or no motor.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular(screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy")
    >>> train = kt.actuators.train_of(model, "actuator")
    >>> train.gear.ratio, float(train.screw.lead)
    (5.2, 0.003)
    """
    if name in model.drives and name not in model.actuators:
        raise InputError(f"Drive {name!r} has no motor: there is no drive train. Give it one.")
    if name not in model.actuators:
        raise InputError(f"The model has no active member {name!r}, and no drive of an angle. {nearest(name, model.actuators)}")
    one = model.actuators[name]
    screw, gear, motor, amplifier = parts_of(model, one)
    what, wanted = (
        ("Active member", (("screw", screw), ("motor", motor))) if isinstance(one, Active) else ("Drive", (("motor", motor),))
    )
    lacks = " and no ".join(word for word, part in wanted if part is None)
    if lacks or motor is None:
        raise InputError(f"{what} {name!r} has no {lacks}: there is no drive train. Give it one.")
    return DriveTrain(screw=screw, motor=motor, gear=gear or Gear(ratio=1.0), amplifier=amplifier)
