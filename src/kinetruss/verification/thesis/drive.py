"""Screw and motor of the thesis' active members: errata 10 and 11, and the self-locking limit."""

from __future__ import annotations

from collections.abc import Iterator

from kinetruss import actuators
from kinetruss.library import drives
from kinetruss.model import Gear
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

FORCES = (74.5, 29.5)  # N, of M8 at the start and at the end of the slew in section 5.7
RATE = 0.1212 / 5.5  # m/s, mean of the slew


def demands() -> dict[str, float]:
    """Torques at 74.5 N, voltages at standstill as the thesis has them (load not divided by the gear) and right, back-emf."""
    screw, motor, gear = drives.SCREW_LACY_SPATIAL, drives.MOTOR_LACY, drives.GEAR_LACY
    against, lesser = (actuators.raising_torque(screw, force) for force in FORCES)
    direct, geared = (actuators.motor_demand(screw, one, motor, against, 0.0, 0.0) for one in (Gear(ratio=1.0), gear))
    weaker = actuators.motor_demand(screw, Gear(ratio=1.0), motor, lesser, 0.0, 0.0)
    turning = [float(actuators.motor_demand(screw, gear, motor, 0.0, rate, 0.0)["voltage"]) for rate in (1.0, RATE)]
    return {
        "torque_with_load": float(actuators.screw_torque(screw, FORCES[0], -1.0)) * -1,
        "torque_against_load": float(actuators.screw_torque(screw, FORCES[0], 1.0)),
        "voltage_without_gear_74.5N": float(direct["voltage"]),
        "voltage_without_gear_29.5N": float(weaker["voltage"]),
        "voltage_74.5N": float(geared["voltage"]),
        "back_emf_per_speed": turning[0],
        "back_emf_of_slew": turning[1],
        "torque_at_the_self_locking_limit": actuators.lowering_torque(drives.SCREW_LACY_PLANAR, 100.0),
    }


def cases() -> Iterator[Case]:
    """Figures to half a unit of their last digit; the self-locking limit, lead = mu d/2, exactly."""
    data = load("derived")
    digits = {"back_emf_per_speed": 0, "back_emf_of_slew": 2, "voltage_74.5N": 2, "voltage_without_gear_74.5N": 3}
    for name, expected in data["drive"].items():
        note = "load not divided by the gear ratio, as in eq. 4.78; right: divided" if "without_gear" in name else ""
        reference = Reference("independent", data["source"], note)
        accuracy = 0.51 * 10.0 ** -digits.get(name, 3 if "voltage" in name else 4) / expected
        yield Case(f"drive.{name}", reference, expected, accuracy, demands, at=(name,))
    name = "torque_at_the_self_locking_limit"
    yield Case(
        f"drive.{name}",
        Reference("closed-form", "Lacy (1991), eq. 2.36: zero where lead = friction x radius"),
        0.0,
        1e-15,
        demands,
        at=(name,),
        scale=100.0 * drives.SCREW_LACY_PLANAR.lead,
    )
