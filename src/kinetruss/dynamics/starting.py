"""A consistent start of a simulation, and when a position counts as singular."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kinetruss.errors import InputError
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian
from kinetruss.mechanics.arguments import positions_of, vectors_of
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


LARGEST = 2000
"""Number of free coordinates up to which velocities that were not given are computed."""

REPORTED = 1e-9
"""A relative change of the start below this value is round-off and not reported."""


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


def named_coordinates(system: System, velocities: Mapping[str, Sequence[float]] | ArrayLike | None) -> NDArray[np.bool_]:
    """Mask of flat coordinates (3 n,) whose velocity is given by name; all if velocities are an array."""
    named = system.model.velocities if velocities is None else velocities
    if not isinstance(named, Mapping):
        return np.ones(3 * len(system.nodes), bool)
    return np.repeat(np.isin(system.nodes, list(named)), 3)


def completed_velocities(
    reduced: System, x: NDArray[np.float64], v: NDArray[np.float64], allowed: NDArray[np.float64], named: NDArray[np.bool_]
) -> NDArray[np.float64] | None:
    """Velocities (3 n,) that keep those of named coordinates and satisfy the constraints by moving other nodes.

    reduced : the system with the active constraints. v : given velocities, else 0. allowed : any velocities that satisfy the
    constraints at positions x (3 n,). The other coordinates get the velocities of least norm. Returns None if nothing is left
    to complete, or the given velocities contradict each other.
    """
    free = reduced.free
    open_ = ~named[free]
    speed = float(np.abs(v).max(initial=0.0))
    fits = bool(np.abs(allowed - v)[free].max(initial=0.0) <= REPORTED * speed)
    if fits or not open_.any() or open_.all() or len(free) > LARGEST:
        return None
    J = jacobian(reduced, x.reshape(-1, 3))
    wanted = J @ allowed[free] - J[:, ~open_] @ v[free][~open_]
    rest = np.linalg.lstsq(J[:, open_], wanted, rcond=RANK_TOLERANCE)[0]
    if np.abs(J[:, open_] @ rest - wanted).max(initial=0.0) > REPORTED * speed:
        return None
    found = allowed.copy()
    found[free[open_]], found[free[~open_]] = rest, v[free[~open_]]
    return found


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
