"""The energy-momentum method: a chaotic pendulum for a long time, a stiff one with long steps, a free structure."""

from __future__ import annotations

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import drift

LONG = 1000.0
"""s, of the chaotic double pendulum."""


def chaotic() -> dict[str, float]:
    """Change of energy, relative to the largest kinetic one, and elongation of the bars, of a double pendulum released from a
    high position.
    """
    model = kt.library.mechanisms.double_pendulum(angles=(2.0, 2.5))
    run = kt.dynamics.simulate(model, LONG, samples=2001, method=kt.EnergyMomentum(0.01))
    return {"energy": drift(run), "length": float(np.abs(run.motion.length.values - 1).max())}


def stiff() -> dict[str, float]:
    """Change of energy, of the largest kinetic one, of a stiff pendulum (Green's strain) over 1,000 swings of its bar."""
    model = kt.Model(
        nodes={"O": (0.0, 0.0), "P": kt.Node(at=(1.0, 0.0), mass=1.0)},
        fixed=["O"],
        bars={"bar": kt.Bar(ends=("O", "P"), kind="elastic", strain="green", stiffness=4e5, mass=0.0)},
        gravity=(0.0, -9.81),
    )
    return {"energy": drift(kt.dynamics.simulate(model, 10.0, samples=101, method=kt.EnergyMomentum(0.01)))}
