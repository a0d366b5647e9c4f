"""Linkages whose count misleads: rank and freedom; straight lines that are straight."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import mechanisms
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

RANK = {
    "bennett": ("G. T. Bennett (1903): the loop of four skew hinges has one freedom", (-2, 11, 1, 3)),
    "bricard": ("R. Bricard (1927): the orthogonal loop of six hinges has one freedom", (0, 23, 1, 1)),
    "sarrus": ("P. F. Sarrus (1853): one straight motion", (1, 32, 1, 0)),
    "peaucellier": ("C.-N. Peaucellier (1873): one freedom", (1, 7, 1, 0)),
    "hart": ("H. Hart (1875): one freedom", (1, 17, 1, 0)),
    "spherical_four_bar": ("classical: one freedom", (1, 5, 1, 0)),
    "watt_six_bar": ("classical: one freedom", (1, 7, 1, 0)),
    "stephenson_six_bar": ("classical: one freedom", (1, 7, 1, 0)),
}
"""Source; count, rank, mechanisms, states of self-stress."""
BUILT = Reference("input-check", "free coordinates less bars of the model as it is built")
ENERGY = Reference("identity", "energy is kept")
LINES = {
    "peaucellier": ("x = (arm^2 - side^2)/(2 crank)", (0.5**2 - 0.3**2) / (2 * 0.15)),
    "hart": ("x = -part (1 - part) (longer^2 - shorter^2)/(2 crank)", -0.25 * (0.5**2 - 0.25**2) / (2 * 0.08)),
}


def rank(name: str) -> dict[str, float]:
    """Count and rank, no drive held."""
    found = kinematics.mobility(getattr(mechanisms, name)().with_(drives={}, runs={}))
    return {"count": found.maxwell, "rank": found.rank, "mechanisms": found.undriven, "self_stress": found.self_stress}


def line(name: str) -> dict[str, float]:
    """Largest and smallest x of P along its run, m."""
    model = getattr(mechanisms, name)()
    motion = kinematics.follow(model, model.runs["swing"].trajectory, samples=101)
    x = motion.position.sel(node="P", axis="x").values
    return {"most": float(x.max()), "least": float(x.min())}


def straight() -> dict[str, float]:
    """Largest way of the Sarrus linkage's platform off its line, and turn, m."""
    model = mechanisms.sarrus()
    motion = kinematics.follow(model, model.runs["lift"].trajectory, samples=51)
    x = motion.position.sel(node=["G", "H", "K"]).values
    return {"off": float(np.abs((x - x[0])[..., [0, 2]]).max() + np.ptp((x - x[0])[..., 1], axis=1).max())}


def energy(name: str) -> dict[str, float]:
    """Change of energy of a loop let go for 0.3 s, of the largest kinetic one."""
    run = dynamics.simulate(getattr(mechanisms, name)(), 0.3, samples=31)
    whole = run.kinetic_energy.values + run.potential_energy.values
    return {"change": float(np.abs(whole - whole[0]).max() / run.kinetic_energy.values.max())}


def bennett_turn() -> dict[str, float]:
    """tan(t1/2) tan(t2/2) after 0.2 s, from hinge angles measured at the links."""
    model = mechanisms.bennett()
    run = dynamics.simulate(model, 0.2, samples=2)
    end = run.motion.position.isel(time=-1)
    at = {name: end.sel(node=name).values for name in model.nodes}
    product = 1.0
    for before, here, after in ((4, 1, 2), (1, 2, 3)):
        axis = (at[f"A{here}"] - at[f"P{here}"]) / 0.1
        came, goes = at[f"P{here}"] - at[f"P{before}"], at[f"P{after}"] - at[f"P{here}"]
        product *= math.tan(math.atan2(axis @ np.cross(came, goes), came @ goes) / 2)
    return {"product": product}


def cases() -> Iterator[Case]:
    """Whole numbers; lines to 1e-13 m; energy 1e-8."""
    for name, (source, numbers) in RANK.items():
        for key, number in zip(("count", "rank", "mechanisms", "self_stress"), numbers, strict=True):
            reference = BUILT if key == "count" else Reference("count", source)
            yield Case(f"loops.{name}.{key}", reference, number, 0.0, rank, (name,), (key,), 1.0)
    for name, (source, x) in LINES.items():
        for key in ("most", "least"):
            yield Case(f"loops.{name}.{key}", Reference("closed-form", source), x, 1e-12, line, (name,), (key,))
    yield Case(
        "loops.sarrus.straight",
        Reference("identity", "the platform moves straight and does not turn"),
        0.0,
        1e-12,
        straight,
        (),
        ("off",),
        1.0,
    )
    for name in ("bennett", "bricard", "spherical_four_bar"):
        yield Case(f"loops.{name}.energy", ENERGY, 0.0, 1e-8, energy, (name,), ("change",), 1.0)
    ratio = math.sin((1.3 + 0.7) / 2) / math.sin((1.3 - 0.7) / 2)
    turns = Reference("closed-form", "Bennett (1903): tan(t1/2) tan(t2/2) = sin((beta + alpha)/2)/sin((beta - alpha)/2)")
    yield Case("loops.bennett.turn", turns, ratio, 1e-8, bennett_turn, (), ("product",))
