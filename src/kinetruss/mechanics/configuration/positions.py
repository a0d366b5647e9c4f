"""What users give of the nodes, checked: positions and velocities."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, shown
from kinetruss.mechanics import System

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["names_of", "number_of", "numbers_of", "positions_of", "vectors_of"]


def positions_of(system: System, position: ArrayLike | None, name: str = "position") -> NDArray[np.float64]:
    """Positions (n, 3), m, from (n_nodes, dim) given, or the model's own.

    Raises
    ------
    InputError : another shape, no numbers, numbers that are not finite.
    """
    return system.x0 if position is None else vectors_of(system, position, name, "m")


def names_of(given: Any, what: str) -> list[str]:
    """Names that were given: one, or several.

    Raises
    ------
    InputError : something else than text; `what` says what is wanted.
    """
    if isinstance(given, str):
        return [given]
    if not isinstance(given, Iterable) or isinstance(given, (bytes, Mapping)):
        raise InputError(f"{shown(given)} is no name. Give {what}.")
    found = list(given)
    if odd := [one for one in found if not isinstance(one, str)]:
        raise InputError(f"{shown(odd[0])} is no name. Give {what}.")
    return found


def numbers_of(given: Any, name: str) -> NDArray[np.float64]:
    """Numbers that were given, as an array of any shape.

    Raises
    ------
    InputError : no numbers.
    """
    try:
        return np.asarray(given, float)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {shown(given)}. Give numbers.") from None


def number_of(value: Any, name: str, unit: str, *, infinite: bool = False) -> float:
    """A number that was given, as a float.

    Raises
    ------
    InputError : text, no number, one that is not finite (unless `infinite`).
    """
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise InputError(f"{name} is {shown(value)}. Give a number ({unit}).")
    if not (np.isfinite(value) or (infinite and not np.isnan(value))):
        raise InputError(f"{name} is {value}. Give a finite number ({unit}).")
    return float(value)


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
