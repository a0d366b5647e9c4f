"""Free motion of overconstrained loops for seconds: closed forms of their angles, energy, and the equation of their one
freedom.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

import kinetruss as kt
from kinetruss.verification._cases import stored
from kinetruss.verification._measures import drift

if TYPE_CHECKING:
    from numpy.typing import NDArray


BENNETT: dict[str, dict[str, Any]] = {
    "default": {"twist": 0.7, "other_twist": 1.3, "angle": 1.0},
    "slender": {"twist": 0.3, "other_twist": 1.5, "angle": 2.0},
    "wide": {"twist": 0.5, "other_twist": 2.5, "angle": 0.3},
}


def let_go(name: str, time: float) -> Any:
    """A simulation of one of `BENNETT`, or of the orthogonal loop of six."""
    model = kt.library.mechanisms.bricard() if name == "bricard" else kt.library.mechanisms.bennett(**BENNETT[name])
    return kt.dynamics.simulate(model, time, samples=301, method=kt.DOP853(rtol=1e-11, atol=1e-12))


def hinge_angles(model: kt.Model, position: Any, count: int) -> NDArray[np.float64]:
    """Angles (samples, count) of the hinges of a loop `P1`, `A1`, `P2` ..., rad, from places of its nodes."""
    at = {name: position.sel(node=name).values for name in model.nodes}
    found = []
    for k in range(1, count + 1):
        before, after = (k - 2) % count + 1, k % count + 1
        axis = at[f"A{k}"] - at[f"P{k}"]
        axis = axis / np.linalg.norm(axis, axis=1, keepdims=True)
        came, goes = at[f"P{k}"] - at[f"P{before}"], at[f"P{after}"] - at[f"P{k}"]
        found.append(np.arctan2((axis * np.cross(came, goes)).sum(axis=1), (came * goes).sum(axis=1)))
    return np.stack(found, axis=1)


def history(name: str, time: float) -> dict[str, float]:
    """Change of the energy of the largest kinetic one, and the residual of the closed form of the angles."""
    run = let_go(name, time)
    found = {"energy": drift(run)}
    if name == "bricard":
        t = hinge_angles(kt.library.mechanisms.bricard(), run.motion.position, 6)
        c = np.cos(t)
        left = [c[:, i] + c[:, i - 1] + c[:, i] * c[:, i - 1] for i in range(6)]
        return found | {"closure": float(np.abs(left).max())}
    twist, other = BENNETT[name]["twist"], BENNETT[name]["other_twist"]
    t = hinge_angles(kt.library.mechanisms.bennett(**BENNETT[name]), run.motion.position, 4) / 2
    down, up = math.sin((other - twist) / 2), math.sin((other + twist) / 2)
    left = [down * np.sin(t[:, 0]) * np.sin(t[:, 1]) - up * np.cos(t[:, 0]) * np.cos(t[:, 1])]
    return found | {"closure": float(np.abs(left).max())}


def against_one_freedom(name: str) -> dict[str, float]:
    """Largest distance of P2, A2, P3, A3 after 3 s from where the equation of the one freedom has them, m."""
    end = let_go(name, 3.0).motion.position.isel(time=-1).sel(node=["P2", "A2", "P3", "A3"]).values
    return {"one_freedom": float(np.abs(end - stored("mechanisms")["exact"]["bennett"][name]).max())}
