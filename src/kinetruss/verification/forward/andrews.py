"""Andrews' mechanism: angles, rates, accelerations, multipliers and bar forces at the start and after 0.03 s."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

METHODS = {
    "dop853": kt.DOP853(rtol=1e-13, atol=1e-15),
    "radau": kt.Radau(rtol=1e-12, atol=1e-14),
    "taylor": kt.Taylor(rtol=1e-13, atol=1e-15),
}

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
"""Bars with directions (sin, -cos) of their angle: a quarter turn less."""

KINDS = ("angle", "rate", "acceleration")


def spin(method: str) -> dict[str, float]:
    """Everything at the start (``start.``) and at 0.03 s."""
    run = kt.dynamics.simulate(
        kt.library.mechanisms.andrews(),
        0.03,
        samples=301,
        tasks={"motor": kt.GivenForce(torque=kt.library.mechanisms.ANDREWS_TORQUE)},
        method=METHODS[method],
    )
    found: dict[str, float] = {}
    for prefix, i in (("start.", 0), ("", -1)):
        found |= {f"{prefix}{name}": value for name, value in _angles(run.motion, i).items()}
        force = run.forces.member_force.isel(time=i)
        found |= {f"{prefix}force.{name}": force.sel(member=name).item() for name in ("OF", *force.member.values)}
        found |= {f"{prefix}{name}": value for name, value in multipliers(run.forces, i).items()}
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
    return {f"{kind}.{name}": value[k].item() for name, value in single.items() for k, kind in enumerate(KINDS)}


def _cross(a: Any, b: Any) -> Any:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def multipliers(forces: kt.results.Forces, i: int) -> dict[str, float]:
    """Forces at joint E on the bodies of B, G and H: the multipliers of the three loops."""
    end = forces.joint_force.isel(time=i)
    found: dict[str, float] = {}
    for k, bars in enumerate((("BE", "ED"), ("GE",), ("HE",))):
        # E is the second end of all bars but ED, which belongs to the body of BE
        total: Any = sum(end.sel(member=bar, end="A" if bar == "ED" else "B").values for bar in bars)
        found |= {f"multiplier.{2 * k + 1}": total[0], f"multiplier.{2 * k + 2}": total[1]}
    return found
