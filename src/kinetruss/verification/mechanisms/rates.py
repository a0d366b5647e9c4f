"""Kinematic quantities: angular rates against closed forms and exact samples, first-order prediction by its order."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.triangle import SAMPLES, truss

TOP, BASE = ("N7", "N9", "N8"), ("N1", "N2", "N3")
TILT = math.radians(10)
TIMES = (0.25, 0.5, 0.8)

STEPS = (4e-3, 2e-3, 1e-3)
"""m or rad; small enough for the square to rule, large enough for round-off not to."""


def tilted(angle: str) -> dict[str, Any]:
    """Top plane of a bay whose beta or gamma goes from -10 to 10 degrees in 1 s."""
    model = kt.library.vgt.double_octahedral()
    slew = kt.Quintic(moves={f"bay.{angle}": (-TILT, TILT)}, duration=1.0)
    motion = kt.kinematics.follow(model, slew, times=np.array(TIMES))
    found = kt.kinematics.platform(model, motion, TOP, base=BASE)
    return {f"t={t:g}": {str(name): found[name].values[i] for name in found.data_vars} for i, t in enumerate(TIMES)}


def turned() -> dict[str, dict[str, float]]:
    """Rates of both members of the triangular truss at the times of the exact samples."""
    model = truss()
    motion = kt.kinematics.follow(model, kt.library.vgt.lacy_step(), times=np.array([0.0, *SAMPLES]))
    found = kt.kinematics.member_rates(model, motion)
    rates: dict[str, dict[str, float]] = {f"t={t:g}": {} for t in SAMPLES}
    for symbol, member in (("phi", "follower"), ("th", "actuator")):
        # phi is measured clockwise
        sign = -1.0 if member == "follower" else 1.0
        for order, name in (("d", "angular_velocity"), ("dd", "angular_acceleration")):
            for at, value in zip(rates.values(), found[name].sel(member=member).values[1:, 0], strict=True):
                at[f"{symbol}{order}"] = sign * value
    return rates


def slope(case: str) -> dict[str, float]:
    """Order of the error of the first-order prediction: slope of its logarithm over the step's."""
    if case == "triangle":
        model, drives = truss(), {"actuator": 1.0}
    elif case == "chain":
        model = kt.library.vgt.double_octahedral(3, beta=0.1, gamma=0.05)
        drives = {"B1.M7": 1.0, "B2.M9": -0.5, "B3.M11": 0.7}
    else:
        model, drives = kt.library.vgt.double_octahedral(beta=0.1), {"M7": 1.0, "M9": -0.4, "M11": 0.2}
        if case == "bay_in_pose":
            drives = {"bay.beta": 1.0, "bay.gamma": -0.5}
    errors = []
    for step in STEPS:
        if case == "bay_in_pose":
            slew = kt.library.vgt.slew(beta=(0.1, 0.1 + step), gamma=(0.0, -0.5 * step))
            found = kt.kinematics.first_order(model, kt.kinematics.follow(model, slew, times=[0.0, 1.0]), list(drives))
        else:
            move = kt.ConstantRate(rates={name: step * rate for name, rate in drives.items()}, duration=1.0)
            found = kt.kinematics.first_order(model, kt.kinematics.follow(model, move, times=[0.0, 1.0]))
        errors.append(float(found["largest_error"].values[-1]))
    return {"slope": np.polyfit(np.log(STEPS), np.log(errors), 1)[0]}
