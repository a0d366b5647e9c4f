"""Buffers of a record that a kernel makes for itself."""

from __future__ import annotations

import numpy as np

from kinetruss.kernels.compiled.jit import kernel
from kinetruss.kernels.compiled.record import F1, I1

__all__ = ["laid_out"]


@kernel
def laid_out(shapes: tuple[tuple[int, int], ...], integers: int, reals: int) -> tuple[I1, F1]:
    """Integers and reals of a record of zeros, all of whose arrays are of reals.

    shapes : rows and columns (1 of a vector) of the arrays, in the order of the fields. integers, reals : how many single ones.
    """
    ints, at = np.zeros(3 * len(shapes) + integers, np.int64), reals
    # entry of the table: offset, rows and columns of each array
    for k, (height, width) in enumerate(shapes):
        ints[3 * k], ints[3 * k + 1], ints[3 * k + 2] = at, height, width
        at += height * width
    return ints, np.zeros(at)
