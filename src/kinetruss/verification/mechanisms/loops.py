"""Linkages whose count misleads: rank and freedom; straight lines that are straight."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import drift
from kinetruss.verification.mechanisms.loops_let_go import hinge_angles


def rank(name: str) -> dict[str, float]:
    """Count and rank, no drive held."""
    found = kt.kinematics.mobility(getattr(kt.library.mechanisms, name)().with_(drives={}, runs={}))
    return {"count": found.maxwell, "rank": found.rank, "mechanisms": found.undriven, "self_stress": found.self_stress}


def line(name: str) -> dict[str, float]:
    """Largest and smallest x of P along its run, m."""
    model = getattr(kt.library.mechanisms, name)()
    motion = kt.kinematics.follow(model, model.runs["swing"].trajectory, samples=101)
    x = motion.position.sel(node="P", axis="x").values
    return {"most": float(x.max()), "least": float(x.min())}


def straight() -> dict[str, float]:
    """Largest way of the Sarrus linkage's platform off its line, and turn, m."""
    model = kt.library.mechanisms.sarrus()
    motion = kt.kinematics.follow(model, model.runs["lift"].trajectory, samples=51)
    x = motion.position.sel(node=["G", "H", "K"]).values
    return {"off": float(np.abs((x - x[0])[..., [0, 2]]).max() + np.ptp((x - x[0])[..., 1], axis=1).max())}


def energy(name: str) -> dict[str, float]:
    """Change of energy of a loop released for 0.3 s, of the largest kinetic one."""
    run = kt.dynamics.simulate(getattr(kt.library.mechanisms, name)(), 0.3, samples=31)
    return {"energy": drift(run)}


def bennett_turn() -> dict[str, float]:
    """tan(t1/2) tan(t2/2) after 0.2 s, from hinge angles measured at the links."""
    model = kt.library.mechanisms.bennett()
    run = kt.dynamics.simulate(model, 0.2, samples=2)
    end = run.motion.position.isel(time=[-1])
    angles = hinge_angles(model, end, 4)[0]
    return {"turn": math.tan(angles[0] / 2) * math.tan(angles[1] / 2)}
