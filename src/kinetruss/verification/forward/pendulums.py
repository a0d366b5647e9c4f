"""Free pendulums: elliptic functions, Lagrange's equations in angles."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt

METHODS = {"dop853": kt.DOP853(rtol=1e-12, atol=1e-13), "taylor": kt.Taylor(rtol=1e-12, atol=1e-13)}


def pendulum(method: str) -> dict[str, float]:
    """Places of the bob at whole seconds, from horizontal."""
    run = kt.dynamics.simulate(kt.library.mechanisms.pendulum(angle=-math.pi / 2), 10.0, samples=11, method=METHODS[method])
    at = run.motion.position.sel(node="P1").values
    return {f"{axis}_at_{k}s": at[k, i] for k in range(1, 11) for i, axis in enumerate("xy")}


def tension() -> dict[str, float]:
    """Tension of the bar at whole seconds divided by its closed form 3 m g cos(angle)."""
    run = kt.dynamics.simulate(kt.library.mechanisms.pendulum(angle=-math.pi / 2), 10.0, samples=11, method=METHODS["dop853"])
    axial = run.forces.member_force.sel(member="link1").values
    y = run.motion.position.sel(node="P1", axis="y").values
    return {"tension": float(np.abs(axial + 3 * 9.81 * y).max() / (3 * 9.81))}


def triple(method: str) -> dict[str, float]:
    """Places of the tip of three rods."""
    run = kt.dynamics.simulate(
        kt.library.mechanisms.n_pendulum(links=3), 2.0, times=[0.0, 0.5, 1.0, 2.0], method=METHODS[method]
    )
    tip = run.motion.position.sel(node="P3")
    return {f"{axis}_at_{t:g}s": tip.sel(time=t, axis=axis).item() for t in (0.5, 1.0, 2.0) for axis in "xy"}
