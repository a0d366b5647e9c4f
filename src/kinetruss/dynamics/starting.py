"""A consistent start of a simulation, and when a position counts as singular."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import System
from kinetruss.mechanics.arguments import positions_of, vectors_of
from kinetruss.mechanics.velocities import REPORTED
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def given_positions(system: System, positions: ArrayLike | None) -> NDArray[np.float64]:
    """Start positions (3 n,), m, from (n_nodes, dim) or the model's own.

    Raises
    ------
    InputError : a wrong shape, numbers that are not finite.
    """
    return positions_of(system, positions, "start position").reshape(-1).copy()


def given_velocities(system: System, velocities: Mapping[str, Sequence[float]] | ArrayLike | None) -> NDArray[np.float64]:
    """Start velocities (3 n,), m/s, from node -> vector, from (n_nodes, dim), or the model's own (None).

    Raises
    ------
    InputError : an unknown node, a wrong shape, numbers that are not finite.
    """
    if velocities is None:
        return system.velocity0.reshape(-1).copy()
    if not isinstance(velocities, Mapping):
        return vectors_of(system, velocities, "start velocity", "m/s").reshape(-1)
    v: Any = np.zeros((len(system.nodes), system.dim)).tolist()
    for name, vector in velocities.items():
        if name not in system.nodes:
            raise InputError(f"velocities: no node called {name!r}. {nearest(name, system.nodes)}")
        if np.shape(vector) != (system.dim,):
            raise InputError(f"velocities: node {name!r} has shape {np.shape(vector)}. Give {system.dim} numbers (m/s).")
        v[system.node_index(name)] = list(vector)
    return vectors_of(system, v, "start velocity", "m/s").reshape(-1)


def start_notes(
    system: System, before: tuple[Any, Any], after: tuple[Any, Any], size: float
) -> tuple[list[str], dict[str, Any]]:
    """The changes made by the projection: sentences, and attributes for the results.

    before, after : positions and velocities (3 n,); size : a length of the structure, m.
    """
    moved, turned = (np.linalg.norm((b - a).reshape(-1, 3), axis=1) for a, b in zip(before, after, strict=True))
    speed = np.linalg.norm(before[1].reshape(-1, 3), axis=1)
    attrs = {"start_moved": float(moved.max()), "start_velocity_changed": float(turned.max())}
    notes = []
    if moved.max() > REPORTED * size:
        i = int(np.argmax(moved))
        notes.append(
            f"The start positions did not fit the lengths of the bars; they were moved by the smallest "
            f"change that fits, most at node {system.nodes[i]} by {moved[i]:.3g} m."
        )
    if speed.max() > 0 and turned.max() > REPORTED * speed.max():
        i = int(np.argmax(turned))
        vector = ", ".join(f"{c:.6g}" for c in after[1].reshape(-1, 3)[i, : system.dim])
        notes.append(
            "The start velocities contradicted the bars, drives or supports; they were changed to the nearest consistent ones, "
            f"most at node {system.nodes[i]}: by {turned[i]:.3g} m/s, to ({vector}) m/s."
        )
    return notes, attrs


# Data of a start near a singular position, and the limits of pivots at which a position is singular.

SINGULAR = 1e-3
"""A position is singular if its scaled pivot is below this fraction of the largest one so far."""
EXACTLY = 1e-7
"""Fraction of the largest scaled pivot below which the distance to a singular position is lost in round-off."""


class Singular(NamedTuple):
    """A start near a singular position.

    pivot, most : scaled pivot at the start, and the largest one near it. gain : size of the accelerations near it, m/s^2.
    a (3 n,) : accelerations that the equations give at the start. size : length of the shortest member, m.
    """

    pivot: float
    most: float
    gain: float
    a: NDArray[np.float64]
    size: float

    @property
    def near(self) -> bool:
        """True if the equations do not give accurate accelerations at the start."""
        return self.pivot < SINGULAR * self.most
