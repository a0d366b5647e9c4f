"""Measured order of convergence of every integrator with fixed steps."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, EnergyMomentum, GeneralizedAlpha, Radau, Rattle, Taylor
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

END = 0.5
"""s, of the triple pendulum from horizontal."""
ORDERS = {
    "dop853": (8.0, 0.3, (12, 24)),
    "energy_momentum": (2.0, 0.1, (200, 400)),
    "generalized_alpha": (2.0, 0.1, (200, 400)),
    "radau": (5.0, 0.3, (25, 50)),
    "rattle": (2.0, 0.1, (200, 400)),
    "taylor": (6.0, 0.3, (50, 100)),
}
"""Order in theory, allowed difference, steps of the two runs compared."""


def order(method: str) -> dict[str, float]:
    """log2 of the ratio of the errors (root mean square over the nodes) with a step and half of it."""
    exact = load("forward")["triple_pendulum"]["places_at_0.5s"]
    errors = []
    for steps in ORDERS[method][2]:
        h = END / steps
        chosen = {
            "dop853": DOP853(step=h),
            "energy_momentum": EnergyMomentum(h),
            "generalized_alpha": GeneralizedAlpha(h),
            "radau": Radau(rtol=1e-12, step=h),
            "rattle": Rattle(h),
            "taylor": Taylor(order=6, step=h),
        }[method]
        run = dynamics.simulate(mechanisms.n_pendulum(links=3), END, times=[0.0, END], method=chosen)
        errors.append(float(np.sqrt(np.mean((run.motion.position.values[-1, 1:] - exact) ** 2))))
    return {"order": math.log2(errors[0] / errors[1])}


def cases() -> Iterator[Case]:
    """Within 0.1 of theory, 0.3 for the high orders."""
    source = Reference("count", "error ~ h^p; triple pendulum against Lagrange's equations in angles")
    for method, (theory, allowed, _) in ORDERS.items():
        yield Case(f"forward.order.{method}", source, theory, allowed / theory, order, (method,), ("order",))
