"""Andrews' mechanism: angles, rates, accelerations, multipliers and bar forces at the start and after 0.03 s."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, GivenForce, Radau, Taylor
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

EXACT, SERIES = DOP853(rtol=1e-13, atol=1e-15), Taylor(rtol=1e-13, atol=1e-15)
IMPLICIT = Radau(rtol=1e-12, atol=1e-14)

TURNS = {
    "beta": "OF",
    "beta+Theta": "EF",
    "gamma": "BE",
    "Phi+delta": "GE",
    "delta": "AG",
    "Omega+epsilon": "HE",
    "epsilon": "AH",
}
"""Sums of angles that are directions of bars, first to second letter."""

QUARTER = ("gamma", "Phi+delta", "epsilon")
"""Directions (sin, -cos) of their angle: a quarter turn behind."""

QUANTITIES = (("angle", 1e-11, 1e-9), ("rate", 1e-9, 1e-7), ("acceleration", 1e-8, 2e-6))
"""Kind, tolerance against the exact values, and against the published ones, which are good for that only."""
LOOSER = 10.0
"""Tolerances of a method of order 5, in parts of those."""


def spin(method: DOP853 | Radau | Taylor = EXACT) -> dict[str, float]:
    """Everything at the start (``start.``) and at 0.03 s."""
    run = dynamics.simulate(
        mechanisms.andrews(),
        0.03,
        samples=301,
        tasks={"motor": GivenForce(torque=mechanisms.ANDREWS_TORQUE)},
        method=method,
    )
    found: dict[str, float] = {}
    for prefix, i in (("start.", 0), ("", -1)):
        found |= {f"{prefix}{name}": value for name, value in _angles(run.motion, i).items()}
        force = run.forces.member_force.isel(time=i)
        found |= {f"{prefix}force.{name}": force.sel(member=name).item() for name in ("OF", *force.member.values)}
        found |= {f"{prefix}{name}": value for name, value in _multipliers(run.forces, i).items()}
    at = run.motion.position.isel(time=-1)
    return found | {f"{node}.{axis}": at.sel(node=node, axis=axis).item() for node in "FEDGH" for axis in "xy"}


def _angles(motion: Any, i: int) -> dict[str, float]:
    """The seven angles, unwrapped along the motion, their rates and accelerations at sample i."""
    turned: dict[str, np.ndarray[Any, Any]] = {}
    for name, bar in TURNS.items():
        a, b = bar[0], bar[1]
        d, v, w = (
            motion.data[key].sel(node=b).values - motion.data[key].sel(node=a).values
            for key in ("position", "velocity", "acceleration")
        )
        square = (d**2).sum(axis=1)
        angle = np.unwrap(np.arctan2(d[:, 1], d[:, 0])) + (np.pi / 2 if name in QUARTER else 0.0)
        rate = _cross(d, v) / square
        second = (_cross(d, w) - 2 * (d * v).sum(axis=1) * rate) / square
        turned[name] = np.array([angle[i], rate[i], second[i]])
    single = {
        "beta": turned["beta"],
        "Theta": turned["beta+Theta"] - turned["beta"],
        "gamma": turned["gamma"],
        "Phi": turned["Phi+delta"] - turned["delta"],
        "delta": turned["delta"],
        "Omega": turned["Omega+epsilon"] - turned["epsilon"],
        "epsilon": turned["epsilon"],
    }
    return {f"{kind}.{name}": value[k].item() for name, value in single.items() for k, (kind, _, _) in enumerate(QUANTITIES)}


def _cross(a: Any, b: Any) -> Any:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _multipliers(forces: Any, i: int) -> dict[str, float]:
    """Forces at joint E on the bodies of B, G and H: the multipliers of the three loops."""
    end = forces.joint_force.isel(time=i)
    on = {"B": ("BE", "ED"), "G": ("GE",), "H": ("HE",)}
    found: dict[str, float] = {}
    for k, bars in enumerate(on.values()):
        # E is the second end of all but ED
        total = sum(end.sel(member=bar, end="A" if bar == "ED" else "B").values for bar in bars)
        found |= {f"multiplier.{2 * k + 1}": float(total[0]), f"multiplier.{2 * k + 2}": float(total[1])}
    return found


def cases() -> Iterator[Case]:
    """28-digit values, the published ones at their own accuracy, an independent program for the bars."""
    data = load("forward")["andrews"]
    quadrature, bars_source = (Reference("independent", data[key]) for key in ("source", "bars_source"))
    for which, column in (("exact", 1), ("published", 2)):
        source = quadrature if which == "exact" else Reference("printed", data["published_source"])
        for k, quantity in enumerate(QUANTITIES):
            for name, value in zip(data["names"], data[which][7 * k :], strict=False):
                key = f"{quantity[0]}.{name}"
                yield Case(f"forward.andrews.{which}.{key}", source, value, float(quantity[column]), spin, (), (key,))
                if which == "exact":
                    where = f"forward.taylor.andrews.{key}"
                    yield Case(where, source, value, float(quantity[column]), spin, (SERIES,), (key,))
                    where = f"forward.radau.andrews.{key}"
                    yield Case(where, source, value, LOOSER * float(quantity[column]), spin, (IMPLICIT,), (key,))
        for k, value in enumerate(data[which][21:], start=1):
            key = f"multiplier.{k}"
            yield Case(f"forward.andrews.{which}.{key}", source, value, 1e-8 if column == 1 else 2e-6, spin, (), (key,))
    for node, place in data["points"].items():
        for axis, value in zip("xy", place, strict=True):
            yield Case(f"forward.andrews.{node}.{axis}", quadrature, value, 1e-11, spin, (), (f"{node}.{axis}",), 0.02)
    start, largest = data["start"], max(data["start"]["accelerations"])
    for name, value in zip(data["names"], start["accelerations"], strict=True):
        key = f"start.acceleration.{name}"
        yield Case(f"forward.andrews.{key}", quadrature, value, 1e-12, spin, (), (key,), largest)
    for where, bars in (("start.", data["bars_at_start"]), ("", data["bars_at_end"])):
        for name, value in bars.items():
            key = f"{where}force.{name}"
            yield Case(f"forward.andrews.{key}", bars_source, value, 1e-8, spin, (), (key,), abs(bars["OF"]))
