"""Pendulums let go: elliptic functions, Lagrange's equations in angles."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import DOP853, Taylor
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

EXACT = DOP853(rtol=1e-12, atol=1e-13)
SERIES = Taylor(rtol=1e-12, atol=1e-13)


def pendulum(method: DOP853 | Taylor = EXACT) -> dict[str, float]:
    """Places of the bob at whole seconds, from horizontal."""
    run = dynamics.simulate(mechanisms.pendulum(angle=-math.pi / 2), 10.0, samples=11, method=method)
    at = run.motion.position.sel(node="P1").values
    return {f"{axis}_at_{k}s": float(at[k, i]) for k in range(1, 11) for i, axis in enumerate("xy")}


def tension() -> dict[str, float]:
    """Pull of the bar at whole seconds over its closed form 3 m g cos(angle)."""
    run = dynamics.simulate(mechanisms.pendulum(angle=-math.pi / 2), 10.0, samples=11, method=EXACT)
    pull = run.forces.member_force.sel(member="link1").values
    y = run.motion.position.sel(node="P1", axis="y").values
    return {"tension": float(np.abs(pull + 3 * 9.81 * y).max() / (3 * 9.81))}


def triple(method: DOP853 | Taylor = EXACT) -> dict[str, float]:
    """Places of the tip of three rods."""
    run = dynamics.simulate(mechanisms.n_pendulum(links=3), 2.0, times=[0.0, 0.5, 1.0, 2.0], method=method)
    tip = run.motion.position.sel(node="P3")
    return {f"{axis}_at_{t:g}s": tip.sel(time=t, axis=axis).item() for t in (0.5, 1.0, 2.0) for axis in "xy"}


def cases() -> Iterator[Case]:
    """Closed forms to ten digits."""
    data = load("forward")
    elliptic = Reference("closed-form", data["pendulum"]["source"])
    lagrange = Reference("independent", data["triple_pendulum"]["source"])
    for t, *place in data["pendulum"]["table"]:
        for axis, value in zip("xy", place, strict=True):
            name = f"{axis}_at_{t}s"
            for where, method in (("forward", EXACT), ("forward.taylor", SERIES)):
                key = f"{where}.pendulum.{name}"
                yield Case(key, elliptic, value, 1e-10, pendulum, (method,), (name,), 1.0)
    source = Reference("closed-form", "N = m (g cos a + l a'^2) = 3 m g cos a, from horizontal at rest")
    yield Case("forward.pendulum.tension", source, 0.0, 1e-10, tension, (), ("tension",), 1.0)
    for t, *place in data["triple_pendulum"]["table"]:
        for axis, value in zip("xy", place, strict=True):
            name = f"{axis}_at_{t:g}s"
            for where, method in (("forward", EXACT), ("forward.taylor", SERIES)):
                key = f"{where}.triple_pendulum.{name}"
                yield Case(key, lagrange, value, 1e-10, triple, (method,), (name,))
