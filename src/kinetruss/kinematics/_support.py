"""Supports that follow a given history."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.kernels._profiles import spline
from kinetruss.system import System

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["support_history", "with_supports"]

Histories = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]


def with_supports(system: System, t: NDArray[np.float64], moving: Histories) -> Histories:
    """Value, rate and acceleration (times, coordinates) of given coordinates and, behind them, of moving supports."""
    if system.model.support_motion:
        value, rate, second = (np.hstack(pair) for pair in zip(moving, support_history(system, t), strict=True))
        moving = value, rate, second
    value, rate, second = map(np.ascontiguousarray, moving)
    return value, rate, second


def support_history(system: System, t: NDArray[np.float64]) -> Histories:
    """Position, velocity, acceleration (times, coordinates) of the supports' moving coordinates, in the plan's order.

    Quintic spline through the table (lower degree below 6 entries); before and after the table the support stands still.
    """
    columns: list[list[NDArray[np.float64]]] = [[], [], []]
    for node, history in system.model.support_motion.items():
        start = system.x0[system.node_index(node)]
        table = np.array(history.displacements)
        inside = np.clip(t, history.times[0], history.times[-1])
        outside = t != inside
        for order, values in enumerate(spline(inside, np.array(history.times), table)):
            if order:
                values[outside] = 0.0
            for axis in system.model.fixed[node]:
                k = "xyz".index(axis)
                columns[order].append(values[:, k] + (start[k] if order == 0 else 0.0))
    empty = np.zeros((len(t), 0))
    position, velocity, acceleration = (np.stack(c, axis=1) if c else empty for c in columns)
    return position, velocity, acceleration
