"""The largest of several: values that differ by round-off are equal, and of equal ones the first in their order comes first."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

SAME = 1e-9
"""Relative difference below which two values are equal."""
T = TypeVar("T")


def levels(values: Iterable[float]) -> list[int]:
    """The place of each value in the order from the largest to the smallest, the same for equal ones; NaN comes last.

    >>> levels([1.0, 3.0, 3.0000000001, float("nan"), float("inf"), 2.0])
    [3, 1, 1, 4, 0, 2]
    """
    sizes = [float(one) for one in values]
    ranked = sorted((k for k, one in enumerate(sizes) if not math.isnan(one)), key=lambda k: -sizes[k])
    found, level = [0] * len(sizes), -1
    for before, k in zip([None, *ranked], ranked, strict=False):
        level += before is None or not _same(sizes[before], sizes[k])
        found[k] = level
    return [level + 1 if math.isnan(one) else own for one, own in zip(sizes, found, strict=True)]


def _same(larger: float, smaller: float) -> bool:
    return larger == smaller or larger - smaller <= SAME * max(abs(larger), abs(smaller)) < math.inf


def order_of(values: Iterable[float]) -> list[int]:
    """Places of values from the largest to the smallest, those of equal ones ascending; NaN comes last.

    >>> order_of([1.0, 3.0, 3.0000000001, float("nan"), float("inf"), 2.0])
    [4, 1, 2, 5, 0, 3]
    """
    found = levels(values)
    return sorted(range(len(found)), key=found.__getitem__)


def largest_first(rows: Iterable[T], size: Callable[[T], float | tuple[float, ...]]) -> list[T]:
    """Rows from the largest to the smallest size; of sizes that are tuples the first numbers count before the next ones.

    >>> largest_first(["strut", "tie", "post"], {"strut": 1.0, "tie": 2.0, "post": 2.0000000001}.get)
    ['tie', 'post', 'strut']
    >>> largest_first(["tie", "strut", "post"], {"tie": (False, 3.0), "strut": (True, 1.0), "post": (True, 2.0)}.get)
    ['post', 'strut', 'tie']
    """
    every = list(rows)
    sizes = [one if isinstance(one, tuple) else (one,) for one in map(size, every)]
    ranks = list(zip(*map(levels, zip(*sizes, strict=True)), strict=True))
    return [every[k] for k in sorted(range(len(every)), key=ranks.__getitem__)]


def largest(rows: Iterable[T], size: Callable[[T], float | tuple[float, ...]]) -> T:
    """The first of the rows of the largest size; there must be one."""
    return largest_first(rows, size)[0]


def place_of_largest(values: Any, axis: int | None = None) -> Any:
    """The place of the first of the largest values, along an axis or in the flat array; NaN counts only where all are NaN.

    >>> place_of_largest([1.0, 2.0, 2.0000000001, float("nan")])
    1
    """
    given: NDArray[np.float64] = np.asarray(values, float)
    every = np.where(np.isnan(given), -np.inf, given)
    if axis is None:
        every, axis = every.reshape(-1), 0
    most = every.max(axis=axis, keepdims=True)
    with np.errstate(invalid="ignore"):
        least = np.where(np.isfinite(most), most - SAME * np.abs(most), most)
    found = np.argmax(every >= least, axis=axis)
    return int(found) if found.ndim == 0 else found
