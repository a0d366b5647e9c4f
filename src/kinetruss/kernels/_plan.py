"""The order of work: rows (prescribed lengths and angles) and free coordinates as a row of small square blocks."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

__all__ = ["ANGLE", "CABLE", "ENGINEERING", "GREEN", "LENGTH", "NONE", "Plan"]

LENGTH, ANGLE = 0, 1
NONE, ENGINEERING, GREEN, CABLE = 0, 1, 2, 3
"""Laws by which bars pull."""


class Plan(NamedTuple):
    """Arrays that the sweeps run on, everything about rows in the order of work.

    Coordinates are flat: 3 node + axis (planar models have z = 0, never free). Row k is row[k] of the system; it prescribes
    the length between the nodes at coordinates A[k] and B[k] (kind LENGTH) or the angle of that line (ANGLE): value[k], or
    drive[k] of the trajectory where drive[k] >= 0 (those k are listed in `driven`).
    Block b takes rows ptr[b]:ptr[b+1] and solves coordinates col[ptr[b]:ptr[b+1]]; it depends on earlier blocks only.
    Rows from ptr[-1] on are redundant and in no block. `width` is the size of the largest block.
    Entries entry_ptr[b]:entry_ptr[b+1] of block b: component entry_axis of the gradient of row entry_row, times entry_sign
    (+1 at B, -1 at A), goes to column entry_col of that row of the block's matrix.
    """

    A: np.ndarray
    B: np.ndarray
    kind: np.ndarray
    drive: np.ndarray
    value: np.ndarray
    row: np.ndarray
    driven: np.ndarray
    ptr: np.ndarray
    col: np.ndarray
    width: int
    entry_ptr: np.ndarray
    entry_row: np.ndarray
    entry_col: np.ndarray
    entry_axis: np.ndarray
    entry_sign: np.ndarray
    moving: np.ndarray
