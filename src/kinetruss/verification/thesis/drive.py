"""Screw and motor of the thesis' active members: errata 10 and 11, and the self-locking limit."""

from __future__ import annotations

import kinetruss as kt

FORCES = (74.5, 29.5)  # N, of M8 at the start and at the end of the slew in section 5.7
RATE = 0.1212 / 5.5  # m/s, mean of the slew


def demands() -> dict[str, float]:
    """Torques at 74.5 N, voltages at standstill as the thesis has them (load not divided by the gear) and right, back-emf."""
    screw, motor, gear = kt.library.drives.SCREW_LACY_SPATIAL, kt.library.drives.MOTOR_LACY, kt.library.drives.GEAR_LACY
    against, lesser = (kt.actuators.raising_torque(screw, force) for force in FORCES)
    direct, geared = (kt.actuators.motor_demand(screw, one, motor, against, 0.0, 0.0) for one in (kt.Gear(ratio=1.0), gear))
    weaker = kt.actuators.motor_demand(screw, kt.Gear(ratio=1.0), motor, lesser, 0.0, 0.0)
    turning = [float(kt.actuators.motor_demand(screw, gear, motor, 0.0, rate, 0.0)["voltage"]) for rate in (1.0, RATE)]
    return {
        "torque_with_load": float(kt.actuators.screw_torque(screw, FORCES[0], -1.0)) * -1,
        "torque_against_load": float(kt.actuators.screw_torque(screw, FORCES[0], 1.0)),
        "voltage_without_gear_74.5N": float(direct["voltage"]),
        "voltage_without_gear_29.5N": float(weaker["voltage"]),
        "voltage_74.5N": float(geared["voltage"]),
        "back_emf_per_speed": turning[0],
        "back_emf_of_slew": turning[1],
        "torque_at_the_self_locking_limit": kt.actuators.lowering_torque(kt.library.drives.SCREW_LACY_PLANAR, 100.0),
    }
