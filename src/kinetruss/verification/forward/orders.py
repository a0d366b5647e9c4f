"""Measured order of convergence of every integrator with fixed steps."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification._cases import stored

END = 0.5
"""s, of the triple pendulum from horizontal."""
STEPS = {"dop853": (12, 24), "radau": (25, 50), "taylor": (50, 100)}
"""Of the two runs compared; 200 and 400 for methods of order 2."""


def order(method: str) -> dict[str, float]:
    """log2 of the ratio of the errors (root mean square over the nodes) with a step and half of it."""
    exact = stored("forward")["exact"]["triple_pendulum"]
    errors = []
    for steps in STEPS.get(method, (200, 400)):
        h = END / steps
        chosen = {
            "dop853": kt.DOP853(step=h),
            "energy_momentum": kt.EnergyMomentum(h),
            "generalized_alpha": kt.GeneralizedAlpha(h),
            "radau": kt.Radau(rtol=1e-12, step=h),
            "rattle": kt.Rattle(h),
            "taylor": kt.Taylor(order=6, step=h),
        }[method]
        run = kt.dynamics.simulate(kt.library.mechanisms.n_pendulum(links=3), END, times=[0.0, END], method=chosen)
        errors.append(float(np.sqrt(np.mean((run.motion.position.values[-1, 1:] - exact) ** 2))))
    return {"order": math.log2(errors[0] / errors[1])}
