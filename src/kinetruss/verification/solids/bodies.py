"""Planar bodies: the extended mass matrix, and inverse dynamics of Andrews' mechanism along its exact motion."""

from __future__ import annotations

import cmath
from typing import Any

import numpy as np

import kinetruss as kt
from kinetruss.verification._cases import stored
from kinetruss.verification.forward.andrews import multipliers

BACK = -1j
"""(sin a, -cos a) = -i exp(i a)."""


def matrix(turned: float) -> dict[str, float]:
    """Entries of the mass matrix of a body whose bar stands at an angle (rad): reactions to unit accelerations of its ends."""
    d = 0.5 * cmath.exp(1j * turned)
    body = kt.PlanarBody(mass=2.0, center=(0.2, 0.1), inertia=0.03)
    model = kt.Model(
        nodes={"A": (0.0, 0.0), "B": (d.real, d.imag)},
        fixed=["A", "B"],
        bars={"body": kt.Bar(ends=("A", "B"), length=0.5, body=body)},
    )
    still = np.zeros((4, 2, 2))
    at = np.broadcast_to([node.at for node in model.nodes.values()], still.shape)
    motion = kt.kinematics.from_arrays(model, np.arange(4.0), at, still, np.eye(4).reshape(4, 2, 2))
    found = kt.dynamics.inverse(model, motion, static=False).data["reaction"].values.reshape(4, 4).T
    return {f"{i}{j}": float(found[i, j]) for i in range(4) for j in range(4)} | {"det": float(np.linalg.det(found))}


def andrews() -> dict[str, float]:
    """Torque of the motor and multipliers of the three loops at 0.03 s, from the exact angles, rates and accelerations."""
    model = kt.library.mechanisms.andrews()
    exact = np.array(stored("forward")["exact"]["andrews"])
    motion = kt.kinematics.from_arrays(model, [0.0, 1.0], *(np.stack([_nodes(model, exact)[k]] * 2) for k in range(3)))
    forces = kt.dynamics.inverse(model, motion, static=False)
    return {"torque": forces.drive_force.sel(drive="motor")[0]} | multipliers(forces, 0)


def _nodes(model: kt.Model, state: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
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
