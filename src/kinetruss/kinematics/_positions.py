"""What users give of the nodes, checked: positions and velocities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kinetruss.errors import InputError
from kinetruss.system import System

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["positions_of", "vectors_of"]


def positions_of(system: System, position: ArrayLike | None, name: str = "position") -> NDArray[np.float64]:
    """Positions (n, 3), m, from (n_nodes, dim) given, or the model's own.

    Raises
    ------
    InputError : another shape, no numbers, numbers that are not finite.
    """
    return system.x0 if position is None else vectors_of(system, position, name, "m")


def vectors_of(system: System, given: ArrayLike, name: str, unit: str) -> NDArray[np.float64]:
    """Vectors (n, 3) of all nodes from (n_nodes, dim).

    Raises
    ------
    InputError : another shape, no numbers, numbers that are not finite.
    """
    wanted = (len(system.nodes), system.dim)
    try:
        table = np.asarray(given, float)
    except (TypeError, ValueError):
        raise InputError(f"{name} is no table of numbers. Give {wanted}: nodes, axes ({unit}).") from None
    if table.shape != wanted:
        raise InputError(f"{name} has shape {table.shape}. Give {wanted}: nodes, axes ({unit}).")
    if not np.isfinite(table).all():
        node = system.nodes[int(np.flatnonzero(~np.isfinite(table).all(axis=1))[0])]
        raise InputError(f"{name} of {node!r} is not finite. Give finite numbers ({unit}).")
    full = np.zeros_like(system.x0)
    full[:, : system.dim] = table
    return full
