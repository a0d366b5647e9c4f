"""Free structures in space: a tumbling symmetric top against its closed form; energy and momenta of two hinged bodies."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

import kinetruss as kt
from kinetruss.verification._measures import drift

if TYPE_CHECKING:
    from numpy.typing import NDArray


SPIN = np.array([1.5, -0.4, 4.0])
"""rad/s."""
DRIFT = np.array([0.3, 0.2, -0.1])
"""m/s."""
METHODS = {"default": None, "energy_momentum": kt.EnergyMomentum(0.002)}


def bipyramid() -> tuple[kt.Model, NDArray[np.float64], tuple[float, float]]:
    """Nine bars, three of them round the equator; places (5, 3) from the centre; moments of inertia A (twice) and C."""
    turns = [2 * math.pi * k / 3 for k in range(3)]
    at = np.array([*((0.5 * math.cos(a), 0.5 * math.sin(a), 0.0) for a in turns), (0, 0, 0.7), (0, 0, -0.7)])
    names = ["E1", "E2", "E3", "N", "S"]
    pairs = [(0, 1), (1, 2), (2, 0)] + [(k, apex) for k in range(3) for apex in (3, 4)]
    masses = [2.0] * 3 + [1.0] * 6
    second = np.zeros((3, 3))
    for (i, j), mass in zip(pairs, masses, strict=True):
        p, q = at[i], at[j]
        second += mass / 6 * (2 * np.outer(p, p) + 2 * np.outer(q, q) + np.outer(p, q) + np.outer(q, p))
    inertia = np.trace(second) * np.eye(3) - second
    model = kt.Model(
        nodes={name: tuple(place) for name, place in zip(names, at.tolist(), strict=True)},
        bars={
            f"{names[i]}{names[j]}": kt.Bar(ends=(names[i], names[j]), mass=m) for (i, j), m in zip(pairs, masses, strict=True)
        },
        velocities={name: tuple((DRIFT + np.cross(SPIN, r)).tolist()) for name, r in zip(names, at, strict=True)},
    )
    return model, at, (float(inertia[0, 0]), float(inertia[2, 2]))


def tumble() -> dict[str, float]:
    """Largest distance of the nodes from the closed form over 10 s, m."""
    model, at, (A, C) = bipyramid()
    run = kt.dynamics.simulate(model, 10.0, samples=21, method=kt.DOP853(rtol=1e-12, atol=1e-13))
    turning = np.array([A, A, C]) * SPIN / A
    off = 0.0
    for t, place in zip(run.motion.time.values, run.motion.position.values, strict=True):
        turned = _turn(turning * t) @ _turn(np.array([0.0, 0.0, (1 - C / A) * SPIN[2] * t]))
        off = max(off, float(np.abs(place - (DRIFT * t + at @ turned.T)).max()))
    return {"place": off}


def _turn(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotation matrix of a rotation vector (Rodrigues)."""
    angle = float(np.linalg.norm(vector))
    x, y, z = vector / (angle or 1.0)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turned: NDArray[np.float64] = np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
    return turned


def hinged() -> kt.Model:
    """Two tetrahedra of rigid bars that share a node, and a spring between them; each turns its own way about that node."""
    one = {"A1": (1.0, 0.1, 0.0), "A2": (0.3, 0.9, 0.2), "A3": (0.4, 0.2, 1.0)}
    two = {"B1": (-0.9, 0.0, 0.2), "B2": (-0.2, -0.8, 0.1), "B3": (-0.3, -0.4, 0.9)}
    nodes = {"S": (0.0, 0.0, 0.0)} | one | two
    rates = {"A": np.array([1.0, 2.0, -1.5]), "B": np.array([-2.0, 0.5, 1.0]), "S": np.zeros(3)}
    bars = {
        f"{a}{b}": kt.Bar(ends=(a, b), mass=1.0)
        for body in (one, two)
        for k, a in enumerate(("S", *body))
        for b in list(body)[max(0, k) :]
        if a != b
    }
    spring = kt.Bar(ends=("A1", "B1"), kind="elastic", strain="green", stiffness=60.0, natural_length=1.5, mass=0.0)
    return kt.Model(
        nodes=nodes,
        bars=bars | {"spring": spring},
        velocities={name: tuple((DRIFT + np.cross(rates[name[0]], at)).tolist()) for name, at in nodes.items()},
    )


def conserved(name: str) -> dict[str, float]:
    """Changes over 10 s: of energy as a fraction of the largest kinetic one, of momenta as a fraction of their size."""
    run = kt.dynamics.simulate(hinged(), 10.0, samples=201, method=METHODS[name])
    found = {"energy": drift(run)}
    for key in ("momentum", "angular_momentum"):
        value = run.data[key].values
        found[key] = float(np.abs(value - value[0]).max() / np.linalg.norm(value[0]))
    return found
