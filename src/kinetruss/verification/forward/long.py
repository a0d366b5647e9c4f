"""The energy-momentum method: a chaotic pendulum for a long time, a stiff one with long steps, a free structure."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics
from kinetruss.library import mechanisms
from kinetruss.model import Bar, EnergyMomentum, Model, Node
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference
from kinetruss.verification.forward.free import KEPT, KEPT_BY, conserved

__all__ = ["cases"]

EXACT = Reference("identity", "the midpoint rule with discrete gradients keeps energy (Gonzalez 1999)")
LONG = 1000.0
"""s, of the chaotic double pendulum."""


def chaotic() -> dict[str, float]:
    """Change of energy, of the largest kinetic one, and stretch of the bars, of a double pendulum from high up."""
    model = mechanisms.double_pendulum(angles=(2.0, 2.5))
    run = dynamics.simulate(model, LONG, samples=2001, method=EnergyMomentum(0.01))
    kinetic, energy = run.kinetic_energy.values, run.kinetic_energy.values + run.potential_energy.values
    return {
        "energy": float(np.abs(energy - energy[0]).max() / kinetic.max()),
        "length": float(np.abs(run.motion.length.values - 1).max()),
    }


def stiff() -> dict[str, float]:
    """Change of energy, of the largest kinetic one, of a stiff pendulum (Green's strain) over 1,000 swings of its bar."""
    model = Model(
        nodes={"O": (0.0, 0.0), "P": Node(at=(1.0, 0.0), mass=1.0)},
        fixed=["O"],
        bars={"bar": Bar(ends=("O", "P"), kind="elastic", strain="green", stiffness=4e5, mass=0.0)},
        gravity=(0.0, -9.81),
    )
    run = dynamics.simulate(model, 10.0, samples=101, method=EnergyMomentum(0.01))
    kinetic = run.kinetic_energy.values
    energy = kinetic + run.potential_energy.values
    return {"energy": float(np.abs(energy - energy[0]).max() / kinetic.max())}


def cases() -> Iterator[Case]:
    """Energy to 1e-9 of the largest kinetic energy."""
    yield Case("forward.long.chaotic.energy", EXACT, 0.0, 1e-9, chaotic, (), ("energy",), 1.0)
    source = Reference("identity", "rigid bars keep their length")
    yield Case("forward.long.chaotic.length", source, 0.0, 1e-10, chaotic, (), ("length",), 1.0)
    yield Case("forward.long.stiff.energy", EXACT, 0.0, 1e-9, stiff, (), ("energy",), 1.0)
    for key in KEPT_BY:
        yield Case(f"forward.long.hinged.{key}", KEPT, 0.0, 1e-9, conserved, ("energy_momentum",), (key,), 1.0)
