"""Measures and models used by several groups."""

from __future__ import annotations

from typing import Any

import numpy as np

import kinetruss as kt

__all__ = ["cylinder", "drift", "off"]


def off(found: Any, exact: Any) -> float:
    """Largest difference, relative to the largest exact value."""
    return float(np.abs(found - exact).max() / np.abs(exact).max())


def drift(run: kt.results.Simulation) -> float:
    """Largest change of the energy, relative to the largest kinetic energy."""
    whole = run.kinetic_energy.values + run.potential_energy.values
    return float(np.abs(whole - whole[0]).max() / run.kinetic_energy.values.max())


def cylinder(train: kt.DriveTrain, mass: float, push: float = 0.0) -> kt.Model:
    """An active member on a line, 1 m long, that moves a mass (kg) against a force (N)."""
    member = kt.Active(
        ends=("A", "B"),
        base=kt.Part(length=0.6, mass=2.0),
        tube=kt.Part(length=0.4, mass=0.5),
        screw=train.screw,
        gear=train.gear,
        motor=train.motor,
        amplifier=train.amplifier,
    )
    return kt.Model(
        nodes={"A": (0.0, 0.0), "B": kt.Node(at=(1.0, 0.0), mass=mass)},
        fixed={"A": "xy", "B": "y"},
        active={"M": member},
        loads={"push": kt.NodalForce(node="B", force=(-push, 0.0))},
    )
