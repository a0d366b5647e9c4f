"""Mean rigid motion of a group of nodes: centroid, arms from it, angular velocity and acceleration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import System
from kinetruss.mechanics.configuration.positions import names_of
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["centred", "inertia_of", "spin_of"]


def centred(system: System, histories: list[NDArray[np.float64]], names: Sequence[str]) -> tuple[list[Any], list[Any]]:
    """Centroid (times, 3) of named nodes and their arms from it (times, nodes, 3), each with two rates."""
    least = system.dim
    if not isinstance(names, str):
        names = names_of(names, f"at least {least} nodes, e.g. ('N7', 'N9', 'N8')")
    if isinstance(names, str) or len(set(names)) != len(names) or len(names) < least:
        raise InputError(f"{names!r} is no plane. Name at least {least} different nodes, e.g. ('N7', 'N9', 'N8').")
    if unknown := [name for name in names if name not in system.nodes]:
        raise InputError(f"No node called {unknown[0]!r}. {nearest(unknown[0], system.nodes)}")
    index = [system.node_index(name) for name in names]
    nodes = [y.reshape(len(y), -1, 3)[:, index] for y in histories]
    centre = [y.mean(axis=1) for y in nodes]
    return centre, [y - c[:, None] for y, c in zip(nodes, centre, strict=True)]


def inertia_of(r: NDArray[np.float64], names: Sequence[str], dim: int) -> NDArray[np.float64]:
    """sum |r|^2 1 - r r^T (times, 3, 3) of arms r (times, nodes, 3).

    Raises
    ------
    InputError : the nodes are on one line.
    """
    matrix = _second_moment(r, r)
    if dim == 2:  # about z alone; nodes on one line are enough
        matrix[:, :2], matrix[:, :, :2] = 0.0, 0.0
        matrix[:, 0, 0] = matrix[:, 1, 1] = matrix[:, 2, 2]
    size = np.linalg.eigvalsh(matrix)
    if np.any(size[:, 0] < 1e-9 * size[:, -1]):
        raise InputError(f"Nodes {', '.join(names)} lie on one line, so they span no plane. Name another one.")
    return matrix


def spin_of(arms: list[Any], names: Sequence[str], dim: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """w = I^-1 h and its derivative I^-1 (h' - I' w), with h = sum r x r' and I = sum |r|^2 1 - r r^T."""
    r, v, a = arms
    matrix, change = inertia_of(r, names, dim), _second_moment(r, v)
    change = change + change.transpose(0, 2, 1)
    if dim == 2:
        change[:, :2], change[:, :, :2] = 0.0, 0.0
    w = np.linalg.solve(matrix, np.cross(r, v).sum(axis=1)[..., None])
    left = np.cross(r, a).sum(axis=1)[..., None] - change @ w
    return w[..., 0], np.linalg.solve(matrix, left)[..., 0]


def _second_moment(p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """sum p . q 1 - p q^T over the nodes, (times, 3, 3)."""
    return np.asarray(np.einsum("tnc,tnc->t", p, q)[:, None, None] * np.eye(3) - np.einsum("tni,tnj->tij", p, q))
