"""How large numbers and sizes may be. They are held against these before memory is taken or work is done.

Beyond them nothing sensible is described, and sums and products of what follows would leave the range of float64.
"""

from __future__ import annotations

from numbers import Integral
from typing import Any

from kinetruss.errors import InputError, shown

__all__ = [
    "LARGEST",
    "MOST_COUNT",
    "MOST_ENTRIES",
    "MOST_SAMPLES",
    "MOST_STATIONS",
    "MOST_VALUES",
    "MOST_VARIANTS",
    "MOST_WHOLE",
    "SMALLEST",
    "hold",
    "whole",
]

LARGEST = 1e30
"""Magnitude of any number, in SI: its 8th power is still a float64."""

SMALLEST = 1e-30
"""Least magnitude of a number that must not be zero, in SI."""

MOST_WHOLE = 2**53
"""Magnitude of whole numbers: beyond it float64 leaves some out."""

MOST_COUNT = 1_000_000_000
"""Whatever is counted, e.g. steps of an integration."""

MOST_ENTRIES = 200_000
"""Entries of one table of a model: nodes, bars, loads. A model of so many bars takes about a gigabyte."""

MOST_SAMPLES = 10_000_000
"""Instants of one run."""

MOST_STATIONS = 1001
"""Sections along one member."""

MOST_VALUES = 250_000_000
"""Numbers of one result that is held in memory (2 GB)."""

MOST_VARIANTS = 100_000
"""Variants of a model, or settings of a grid."""


def whole(value: Any, name: str, *, least: int = 1, most: int = MOST_SAMPLES) -> int:
    """A whole number from `least` to `most`.

    Raises
    ------
    InputError : it is none; the message calls it `name`.

    Examples
    --------
    >>> whole(201, "samples", least=2)
    201
    """
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise InputError(f"{name} is {shown(value)}. Give a whole number of at least {least}.")
    number = int(value)
    if number < least:
        raise InputError(f"{name} is {number}. Give at least {least}.")
    if number > most:
        raise InputError(f"{name} is {_count(number)}, more than the limit of {most:,}. Give at most that.")
    return number


def hold(count: int, what: str, mend: str, *, most: int = MOST_VALUES, of: str = "numbers") -> None:
    """Refuse what holds more `of` something than is held in memory at once.

    Raises
    ------
    InputError : more than `most`; the message calls the whole `what` and ends with `mend`.
    """
    if count > most:
        raise InputError(f"{what} would hold {_count(count)} {of}, more than the limit of {most:,}. {mend}")


def _count(value: Any) -> str:
    return f"{value:,}" if value < 10**12 else f"about 1e{len(str(int(value))) - 1 if value < 10**4000 else 4000}"
