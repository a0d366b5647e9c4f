"""Memory for results that are written once: several arrays cut from one buffer."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

__all__ = ["allocate"]

_HUGE = 1 << 22  # NumPy asks for huge pages from 4 MB on
_WORTH = 1 << 18
_LINE = 8  # float64 numbers a cache line


def allocate(*shapes: tuple[int, ...]) -> tuple[NDArray[np.float64], ...]:
    """Uninitialised C-contiguous float64 arrays of the given shapes, side by side in one buffer.

    Touching fresh memory page by page can cost several times the arithmetic that fills it; one buffer that is large enough
    for huge pages costs next to nothing.

    >>> a, b = allocate((1000, 21, 7), (1000, 21, 7, 2))
    >>> a.shape, b.shape, b.flags["C_CONTIGUOUS"]
    ((1000, 21, 7), (1000, 21, 7, 2), True)
    """
    parts, total = [], 0
    for shape in shapes:
        size = math.prod(shape)
        parts.append((total, total + size, shape))
        total += -(-size // _LINE) * _LINE
    if total * 8 >= _WORTH:
        total = max(total, _HUGE // 8)
    buffer = np.empty(total)
    return tuple([buffer[start:end].reshape(shape) for start, end, shape in parts])
