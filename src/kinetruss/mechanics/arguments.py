"""Arguments of users, checked: positions and velocities of the nodes, names, single numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.arrays import array_of
from kinetruss.errors import InputError, shown
from kinetruss.mechanics.system import System

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def positions_of(system: System, position: ArrayLike | None, name: str = "position") -> NDArray[np.float64]:
    """Positions (n, 3), m, from given ones (n_nodes, dim); without any, those of the model.

    Raises
    ------
    InputError : see `kinetruss.arrays.array_of`.
    """
    return system.x0 if position is None else vectors_of(system, position, name, "m")


def names_of(given: Any, what: str) -> list[str]:
    """The given name or names, as a list.

    Raises
    ------
    InputError : something other than text; `what` says what is expected.
    """
    if isinstance(given, str):
        return [given]
    if not isinstance(given, Iterable) or isinstance(given, (bytes, Mapping)):
        raise InputError(f"{shown(given)} is not a name. Give {what}.")
    found = list(given)
    if odd := [one for one in found if not isinstance(one, str)]:
        raise InputError(f"{shown(odd[0])} is not a name. Give {what}.")
    return found


def number_of(value: Any, name: str, unit: str, *, infinite: bool = False) -> float:
    """A given number as a float.

    Raises
    ------
    InputError : text, another object, a number that is not finite (infinity only if `infinite`).
    """
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise InputError(f"{name} is {shown(value)}. Give a number ({unit}).")
    if not (np.isfinite(value) or (infinite and not np.isnan(value))):
        raise InputError(f"{name} is {value}. Give a finite number ({unit}).")
    return float(value)


def refuse_without_inner(system: System, given: ArrayLike, name: str) -> None:
    """Refuse vectors (.., nodes, dim) of the user's nodes alone, of a model with inner ones."""
    own, every = len(system.given.nodes), len(system.nodes)
    if own < every and np.shape(given)[-2:] == (own, system.dim):
        raise InputError(
            f"{name} has the {own} nodes of the model, but not the {every - own} inner ones that represent its beams, bodies "
            f"and hubs, whose rotations do not follow from these. Give the result itself, or its whole[{name!r}]."
        )


def vectors_of(system: System, given: ArrayLike, name: str, unit: str) -> NDArray[np.float64]:
    """Vectors (n, 3) of all nodes from given ones (n_nodes, dim), or of the result that has them by this name.

    Raises
    ------
    InputError : they are only those of the user's nodes, of a model with inner ones. See also `kinetruss.arrays.array_of`.
    """
    given = given.whole[name] if hasattr(given, "whole") else given
    refuse_without_inner(system, given, name)
    full = np.zeros_like(system.x0)
    full[:, : system.dim] = array_of(given, name, {"n_nodes": system.nodes, "dim": system.dim}, unit=unit)
    return full
