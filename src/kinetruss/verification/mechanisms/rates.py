"""Kinematic quantities: angular rates against closed forms and exact samples, first-order prediction by its order."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import kinematics
from kinetruss.library import vgt
from kinetruss.model import ConstantRate, Quintic
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference
from kinetruss.verification.thesis.triangle import EXACT, truss

__all__ = ["cases"]

TOP, BASE = ("N7", "N9", "N8"), ("N1", "N2", "N3")
TILT = math.radians(10)
TIMES = (0.25, 0.5, 0.8)
ROUND_OFF = 1e-10

STEPS = (4e-3, 2e-3, 1e-3)
"""m or rad; small enough for the square to rule, large enough for round-off not to."""


def tilted(angle: str) -> dict[str, Any]:
    """Top plane of a bay whose beta or gamma goes from -10 to 10 degrees in 1 s."""
    model = vgt.double_octahedral()
    slew = Quintic(moves={f"bay.{angle}": (-TILT, TILT)}, duration=1.0)
    motion = kinematics.follow(model, slew, times=np.array(TIMES))
    found = kinematics.platform(model, motion, TOP, base=BASE)
    return {str(name): found[name].values for name in found.data_vars}


def turned() -> dict[str, Any]:
    """Rates of both members of the triangular truss at the times of the exact samples."""
    times = sorted(map(float, load("triangle")["samples"]))
    model = truss()
    found = kinematics.member_rates(model, kinematics.follow(model, vgt.lacy_step(), times=np.array([0.0, *times])))
    rates = {}
    for symbol, member in (("phi", "follower"), ("th", "actuator")):
        # phi is measured clockwise
        sign = -1.0 if member == "follower" else 1.0
        for order, name in (("d", "angular_velocity"), ("dd", "angular_acceleration")):
            rates[f"{symbol}{order}"] = sign * found[name].sel(member=member).values[1:, 0]
    return rates


def slope(case: str) -> float:
    """Order of the error of the first-order prediction: slope of its logarithm over the step's."""
    if case == "triangle":
        model, drives = truss(), {"actuator": 1.0}
    elif case == "chain":
        model = vgt.double_octahedral(3, beta=0.1, gamma=0.05)
        drives = {"B1.M7": 1.0, "B2.M9": -0.5, "B3.M11": 0.7}
    else:
        model, drives = vgt.double_octahedral(beta=0.1), {"M7": 1.0, "M9": -0.4, "M11": 0.2}
        if case == "bay_in_pose":
            drives = {"bay.beta": 1.0, "bay.gamma": -0.5}
    errors = []
    for step in STEPS:
        if case == "bay_in_pose":
            motion = kinematics.follow(model, vgt.slew(beta=(0.1, 0.1 + step), gamma=(0.0, -0.5 * step)), times=[0.0, 1.0])
            found = kinematics.first_order(model, motion, list(drives))
        else:
            move = ConstantRate(rates={name: step * rate for name, rate in drives.items()}, duration=1.0)
            found = kinematics.first_order(model, kinematics.follow(model, move, times=[0.0, 1.0]))
        errors.append(float(found["largest_error"].values[-1]))
    return float(np.polyfit(np.log(STEPS), np.log(errors), 1)[0])


def cases() -> Iterator[Case]:
    """A pure tilt turns the top about a fixed axis; the triangle's rates are stored; the order of the prediction is 2."""
    source = Reference("closed-form", "quintic 10 s^3 - 15 s^4 + 6 s^5; the top turns about +x with beta, about -y with gamma")
    for angle, axis, sign in (("beta", 0, 1.0), ("gamma", 1, -1.0)):
        for i, s in enumerate(TIMES):
            jet = (
                10 * s**3 - 15 * s**4 + 6 * s**5,
                30 * s**2 - 60 * s**3 + 30 * s**4,
                60 * s - 180 * s**2 + 120 * s**3,
            )
            value = (-TILT + 2 * TILT * jet[0], 2 * TILT * jet[1], 2 * TILT * jet[2])
            prefix = f"rates.{angle}.t={s:g}"
            for name, expected in zip((angle, f"{angle}_rate", f"{angle}_acceleration"), value, strict=True):
                yield Case(f"{prefix}.{name}", source, expected, ROUND_OFF, tilted, (angle,), (name, i), TILT)
            for name, order in (("angular_velocity", 1), ("angular_acceleration", 2)):
                for k in range(3):
                    expected = sign * value[order] if k == axis else 0.0
                    yield Case(
                        f"{prefix}.{name}.{'xyz'[k]}", source, expected, ROUND_OFF, tilted, (angle,), (name, (i, k)), 2 * TILT
                    )
    data = load("triangle")
    for i, t in enumerate(sorted(data["samples"], key=float)):
        for name in ("phid", "phidd", "thd", "thdd"):
            label = f"rates.triangle.t={t}.{name}"
            yield Case(label, Reference("independent", data["source"]), data["samples"][t][name], EXACT, turned, (), (name, i))
    source = Reference("count", "the error of a first-order prediction falls as the square of the step (Taylor)")
    for case in ("triangle", "bay", "bay_in_pose", "chain"):
        yield Case(f"rates.first_order_slope.{case}", source, 2.0, 0.025, slope, (case,))
