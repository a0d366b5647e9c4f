"""Motions from elsewhere: arrays or a node-history table."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kinematics._assemble import drive_values, shortest
from kinetruss.kinematics._follow import instants
from kinetruss.kinematics._motion import motion_of
from kinetruss.model import Model
from kinetruss.results import Motion, Status
from kinetruss.system import RIGID, System, compile

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["from_arrays"]

STRETCH = 1e-6
"""A rigid bar whose length changes by more than this share is reported."""


def from_arrays(model: Model, time: ArrayLike, position: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike) -> Motion:
    """A Motion from node histories measured or computed elsewhere.

    Parameters
    ----------
    time : (times,) s, increasing. position, velocity, acceleration : (times, n_nodes, dim), nodes in the model's order; SI.

    Returns
    -------
    Motion; its message names rigid bars whose length changes by more than 1e-6 of itself, the worst first, and
    ``data.attrs["stretched"]`` lists them.

    Raises
    ------
    InputError : wrong shapes, numbers that are not finite, times that do not increase.
    """
    system = compile(model)
    t = instants(0.0, 2, time)
    x, v, a = (
        _full(system, len(t), values, name)
        for values, name in ((position, "position"), (velocity, "velocity"), (acceleration, "acceleration"))
    )
    shaped = [y.reshape(len(t), -1, 3) for y in (x, v, a)]
    motion = motion_of(
        system, t, x, v, a, drive_values(system, *shaped), np.full(len(t), np.nan), "given", Status.COMPLETED, ""
    )
    return _with_stretch(system, motion)


def _full(system: System, count: int, values: ArrayLike, name: str) -> NDArray[np.float64]:
    given = np.asarray(values, float)
    wanted = (count, len(system.nodes), system.dim)
    if given.shape != wanted:
        raise InputError(f"{name} has shape {given.shape}. Give {wanted}: times, nodes, axes.")
    if not np.all(np.isfinite(given)):
        i, j, k = np.argwhere(~np.isfinite(given))[0]
        raise InputError(f"{name} of node {system.nodes[j]!r} at sample {i} is {given[i, j, k]}. Give finite numbers.")
    full = np.zeros((count, len(system.nodes), 3))
    full[:, :, : system.dim] = given
    return full.reshape(count, -1)


def _with_stretch(system: System, motion: Motion) -> Motion:
    length = motion.data["length"].values
    rigid = system.kind == RIGID
    change = np.abs(length - system.length0).max(axis=0) / np.maximum(system.length0, 1e-3 * shortest(system))
    bad = [i for i in np.argsort(-change) if rigid[i] and change[i] > STRETCH]
    motion.data.attrs["stretched"] = [system.members[i] for i in bad]
    if not bad:
        return motion
    named = ", ".join(f"{system.members[i]} by {change[i]:.2g}" for i in bad[:6])
    more = f" and {len(bad) - 6} more" if len(bad) > 6 else ""
    return motion.with_(message=f"Rigid bars change their length in the given motion (share of the length): {named}{more}.")
