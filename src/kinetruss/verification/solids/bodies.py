"""Planar bodies: the extended mass matrix, and inverse dynamics of Andrews' mechanism along its exact motion."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics
from kinetruss.library import mechanisms
from kinetruss.model import Bar, Model, PlanarBody
from kinetruss.verification._case import Case
from kinetruss.verification._data import load
from kinetruss.verification._reference import Reference
from kinetruss.verification.solids import solid_bodies as _solid_bodies

__all__ = ["cases"]

MATRIX = Reference(
    "closed-form", "the moments of the body; concept of Meijaard & van der Wijk, Multibody Syst. Dyn. 48 (2020) 259-282"
)
ENTRIES = (
    (0.92, 0.0, 0.28, -0.4),
    (0.0, 0.92, 0.4, 0.28),
    (0.28, 0.4, 0.52, 0.0),
    (-0.4, 0.28, 0.0, 0.52),
)
"""kg, of m = 2 kg, centre (0.2, 0.1) m, I = 0.03 kg m^2, l = 0.5 m; det = (m I/l^2)^2 = 0.0576 kg^4."""

BACK = -1j
"""(sin a, -cos a) = -i exp(i a)."""


def matrix(turned: float) -> dict[str, float]:
    """Entries of the mass matrix of a body whose bar stands at an angle (rad): reactions to unit accelerations of its ends."""
    d = 0.5 * cmath.exp(1j * turned)
    body = PlanarBody(mass=2.0, center=(0.2, 0.1), inertia=0.03)
    model = Model(
        nodes={"A": (0.0, 0.0), "B": (d.real, d.imag)},
        fixed=["A", "B"],
        bars={"body": Bar(ends=("A", "B"), length=0.5, body=body)},
    )
    still = np.zeros((4, 2, 2))
    at = np.broadcast_to([node.at for node in model.nodes.values()], still.shape)
    motion = kinematics.from_arrays(model, np.arange(4.0), at, still, np.eye(4).reshape(4, 2, 2))
    found = dynamics.inverse(model, motion, static=False).data["reaction"].values.reshape(4, 4).T
    return {f"{i}{j}": float(found[i, j]) for i in range(4) for j in range(4)} | {"det": float(np.linalg.det(found))}


def andrews() -> dict[str, float]:
    """Torque of the motor and multipliers of the three loops at 0.03 s, from the exact angles, rates and accelerations."""
    model = mechanisms.andrews()
    exact = np.array(load("forward")["andrews"]["exact"][:21], float).reshape(3, 7)
    motion = kinematics.from_arrays(model, [0.0, 1.0], *(np.stack([_nodes(model, exact)[k]] * 2) for k in range(3)))
    forces = dynamics.inverse(model, motion, static=False)
    end = forces.data["joint_force"].isel(time=0)
    found = {"torque": float(forces.data["drive_force"].sel(drive="motor")[0])}
    # E is the second end of all bars but ED, which belongs to the body of BE
    for k, bars in enumerate((("BE", "ED"), ("GE",), ("HE",))):
        total: Any = sum(end.sel(member=bar, end="A" if bar == "ED" else "B").values for bar in bars)
        found |= {f"multiplier.{2 * k + 1}": float(total[0]), f"multiplier.{2 * k + 2}": float(total[1])}
    return found


def _nodes(model: Model, state: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Positions, velocities, accelerations of the nodes (3, nodes, 2), from angles, rates, accelerations (3, 7)."""
    beta, theta, gamma, _, delta, _, epsilon = state.T  # E is reached from the crank
    at = {name: complex(*node.at) for name, node in model.nodes.items()}
    F = _arm(0.007, beta)
    H = _arm(0.04 * BACK, epsilon)
    arms = {
        "F": F,
        "E": F - _arm(0.028, beta + theta),
        "D": _arm((0.018 + 0.020j) * BACK, gamma),
        "G": _arm(0.040, delta),
        "H": H,
    }
    origin = {"F": "O", "E": "O", "D": "B", "G": "A", "H": "A"}
    found = np.zeros((3, len(at), 2))
    for k, name in enumerate(at):
        if name in arms:
            z = arms[name] + np.array([at[origin[name]], 0, 0])
            found[:, k] = np.stack([z.real, z.imag], axis=1)
        else:
            found[0, k] = at[name].real, at[name].imag
    return found


def _arm(r: complex, angle: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """r exp(i a) and its first and second derivative, from a, a', a''."""
    a, rate, second = angle
    z = r * np.exp(1j * a)
    return np.array([z, 1j * rate * z, (1j * second - rate**2) * z])


def cases() -> Iterator[Case]:
    """The matrix at three angles of the bar, its determinant, and Andrews' torque and multipliers."""
    for turned in (0.0, 0.7, 2.5):
        for i, row in enumerate(ENTRIES):
            for j, value in enumerate(row):
                yield Case(f"bodies.mass.{turned:g}.{i}{j}", MATRIX, value, 1e-13, matrix, (turned,), (f"{i}{j}",), 1.0)
        yield Case(f"bodies.mass.{turned:g}.det", MATRIX, 0.0576, 1e-12, matrix, (turned,), ("det",))
    data = load("forward")["andrews"]
    quadrature = Reference("independent", data["source"])
    yield Case("bodies.andrews.torque", quadrature, 0.033, 1e-11, andrews, (), ("torque",))
    for k, value in enumerate(data["exact"][21:], start=1):
        yield Case(f"bodies.andrews.multiplier.{k}", quadrature, value, 1e-11, andrews, (), (f"multiplier.{k}",))
    yield from _solid_bodies.cases()
