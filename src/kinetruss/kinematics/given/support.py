"""Supports that follow a given history."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kinematics.given.tables import check_reach, through
from kinetruss.mechanics import System
from kinetruss.model import History, Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["check_support", "check_supports", "support_history", "with_supports"]

Histories = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]


def with_supports(system: System, t: NDArray[np.float64], moving: Histories) -> Histories:
    """Value, rate and acceleration (times, coordinates) of given coordinates and, after them, of moving supports."""
    if system.model.support_motion:
        value, rate, second = (np.hstack(pair) for pair in zip(moving, support_history(system, t), strict=True))
        moving = value, rate, second
    value, rate, second = map(np.ascontiguousarray, moving)
    return value, rate, second


def support_history(system: System, t: NDArray[np.float64]) -> Histories:
    """Position, velocity, acceleration (times, coordinates) of the supports' moving coordinates, in the order of the plan.

    Quintic spline through the table (lower degree below 6 entries), or monotone.

    Raises
    ------
    InputError : times outside the table of a support that moves.
    """
    columns: list[list[NDArray[np.float64]]] = [[], [], []]
    for node, history in system.model.support_motion.items():
        start = system.x0[system.node_index(node)]
        table = np.array(history.displacements)
        if len(t):
            check_support(node, history, float(t[0]), float(t[-1]))
        for order, values in enumerate(through(t, np.array(history.times), table, history.shape)):
            for axis in system.model.fixed[node]:
                k = "xyz".index(axis)
                columns[order].append(values[:, k] + (start[k] if order == 0 else 0.0))
    empty = np.zeros((len(t), 0))
    position, velocity, acceleration = (np.stack(c, axis=1) if c else empty for c in columns)
    return position, velocity, acceleration


def check_supports(model: Model, begin: float, end: float) -> None:
    """InputError if a run from `begin` to `end` (s) goes beyond the table of a support that moves."""
    for node, history in model.support_motion.items():
        check_support(node, history, begin, end)


def check_support(node: str, history: History, begin: float, end: float) -> None:
    """InputError if a run from `begin` to `end` (s) goes beyond the table of a support that moves."""
    if any(row != history.displacements[0] for row in history.displacements):
        check_reach(f"support {node!r}", history.times[0], history.times[-1], begin, end)
