"""Limits of numbers and sizes, which are checked before memory is allocated or work is done.

Larger values describe nothing sensible, and sums and products of them would leave the range of float64.
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
"""Largest magnitude of any number, in SI: its 8th power is still a float64."""

SMALLEST = 1e-30
"""Least magnitude of a number that must not be zero, in SI."""

MOST_WHOLE = 2**53
"""Largest magnitude of whole numbers: above it float64 does not represent all of them."""

MOST_COUNT = 1_000_000_000
"""Largest count, e.g. steps of an integration."""

MOST_ENTRIES = 200_000
"""Largest number of entries in one table of a model: nodes, bars, loads. A model of so many bars takes about a gigabyte."""

MOST_SAMPLES = 10_000_000
"""Largest number of samples of one run."""

MOST_STATIONS = 1001
"""Largest number of sections along one member."""

MOST_VALUES = 250_000_000
"""Largest number of values of one result in memory (2 GB)."""

MOST_VARIANTS = 100_000
"""Largest number of variants of a model, or of settings of a grid."""


def whole(value: Any, name: str, *, least: int = 1, most: int = MOST_SAMPLES) -> int:
    """A whole number from `least` to `most`.

    Raises
    ------
    InputError : another value; the message calls it `name`.

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
    """Refuse a result that would hold more than `most` values in memory.

    Raises
    ------
    InputError : `count` is larger; the message names the result (`what`) and its values (`of`), and ends with the fix (`mend`).
    """
    if count > most:
        raise InputError(f"{what} would hold {_count(count)} {of}, more than the limit of {most:,}. {mend}")


def _count(value: Any) -> str:
    return f"{value:,}" if value < 10**12 else f"about 1e{len(str(int(value))) - 1 if value < 10**4000 else 4000}"
