"""The order of work: rows (prescribed lengths and angles) and free coordinates as a row of small square blocks."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

__all__ = ["ANGLE", "LENGTH", "Plan"]

LENGTH, ANGLE = 0, 1


class Plan(NamedTuple):
    """Arrays that the sweeps run on. Coordinates are flat: 3 node + axis (planar models have z = 0, never free).

    Row r prescribes the length of the bar p[r] -> q[r] (kind LENGTH) or its angle in the plane (ANGLE): the constant
    value[r], or drive[r] of the trajectory where drive[r] >= 0. Block b takes rows row[ptr[b]:ptr[b+1]] and solves
    coordinates col[ptr[b]:ptr[b+1]]; it depends on earlier blocks only. entry_* list, for each row in block order, the
    columns of its own block that it touches: local column, axis, sign (+1 at q, -1 at p).
    """

    p: np.ndarray
    q: np.ndarray
    kind: np.ndarray
    drive: np.ndarray
    value: np.ndarray
    ptr: np.ndarray
    row: np.ndarray
    col: np.ndarray
    entry_ptr: np.ndarray
    entry_col: np.ndarray
    entry_axis: np.ndarray
    entry_sign: np.ndarray
    lu_ptr: np.ndarray
    moving: np.ndarray
