"""Records of the library by name: the model looks them up without importing the library.

The package registers each shelf when it is imported; a shelf is loaded when a name is first looked up on it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

__all__ = ["put_up", "shelf", "shelves"]

_LOADERS: dict[str, Callable[[], Mapping[str, Any]]] = {}


def put_up(table: str, load: Callable[[], Mapping[str, Any]]) -> None:
    """Register the function that loads the library's records for a table of a model, e.g. ``materials``."""
    _LOADERS[table] = load


def shelves() -> tuple[str, ...]:
    """Tables of a model for which the library has records."""
    return tuple(_LOADERS)


def shelf(table: str) -> Mapping[str, Any]:
    """Name -> record of the library, for a table of a model; empty if the library has none.

    >>> sorted(shelf("gears"))
    ['gear_lacy', 'gear_lacy_slewing']
    """
    load = _LOADERS.get(table)
    return {} if load is None else load()
