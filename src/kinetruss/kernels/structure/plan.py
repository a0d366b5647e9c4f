"""The order of work: rows (prescribed lengths and angles) and free coordinates as a row of small square blocks."""

from __future__ import annotations

from kinetruss.kernels.compiled.record import F1, F2, I0, I1, I2, Record, record

__all__ = [
    "ALONE",
    "ALONG",
    "ANGLE",
    "AROUND",
    "CABLE",
    "COSINE",
    "ENGINEERING",
    "FIXED_AXIS",
    "GREEN",
    "LENGTH",
    "NODE",
    "NONE",
    "OFFSET",
    "RIGID_SHAPE",
    "SIZE",
    "SUM",
    "Plan",
]

LENGTH, ANGLE, SUM = 0, 1, 2
NONE, ENGINEERING, GREEN, CABLE = 0, 1, 2, 3
"""Constitutive laws of bars."""
ALONG, FIXED_AXIS, AROUND, OFFSET, NODE, COSINE = 0, 1, 2, 3, 4, 5
"""Terms of sums: length from 1 to P; angle of 1 -> P about a fixed axis; of P about the axis 1 -> 2; distance of P from the
line 1 -> 2 in the plane, to its left; a coordinate of P; the cosine of that of a scalar (see constraints.terms)."""

RIGID_SHAPE, ALONE, SIZE = 0, 1, 2
"""How a row counts in the singularity measure: not, as a bar that keeps the shape of a rigid part; by itself; as one of the
bars that give a rigid part its size."""


@record
class Plan(Record):
    """Arrays that the sweeps run on, everything about rows in the order of work.

    Coordinates are flat: 3 node + axis (planar models have z = 0, never free). Row k is row[k] of the system; it prescribes
    the length between the nodes at coordinates A[k] and B[k] (kind LENGTH) or the angle of that line (ANGLE): value[k], or
    drive[k] of the trajectory where drive[k] >= 0 (those k are listed in `driven`); member[k] is the member that it holds.
    Block b takes rows ptr[b]:ptr[b+1] and solves coordinates col[ptr[b]:ptr[b+1]]; it depends on earlier blocks only.
    Rows from ptr[-1] on are redundant and in no block. `width` is the size of the largest block.
    Entries entry_ptr[b]:entry_ptr[b+1] of block b: component entry_axis of the gradient of row entry_row, times entry_sign
    (+1 at B, -1 at A), goes to column entry_col of that row of the block's matrix.
    Sums (kind SUM): sum_row (s,) their rows, of which sum_ptr[b]:sum_ptr[b+1] are in block b and the last ones redundant;
    terms term_ptr[j]:term_ptr[j+1] of sum j, term_kind, term_at, term_data (constraints.terms); sum_scale (s,) of the row,
    sum_period (s,). Entries sum_entry_ptr[b]:sum_entry_ptr[b+1]: axis sum_entry[., 3] of what term sum_entry[., 1] has at its
    node sum_entry[., 2] (P, 1, 2) is added to row sum_entry[., 0], column sum_entry[., 4].
    Rigid parts (mechanics.rigid_parts): counts (rows,) RIGID_SHAPE, ALONE or SIZE; seen (cols,) 0 where nothing but
    its own part depends on a node, else 1. Parts sized_ptr[b]:sized_ptr[b+1] of block b have the rows size_row[., 0] from
    size_ptr[g] to size_ptr[g+1]; size_row[., 1] is 1 for those that may be the longest. hand[hand_ptr[b]:hand_ptr[b+1]]: flat
    coordinates of nodes of a part, the last one of which (the third if the fourth is -1) keeps its side of the others.
    """

    width: I0
    A: I1
    B: I1
    kind: I1
    drive: I1
    value: F1
    row: I1
    member: I1
    driven: I1
    ptr: I1
    col: I1
    entry_ptr: I1
    entry_row: I1
    entry_col: I1
    entry_axis: I1
    entry_sign: F1
    moving: I1
    sum_ptr: I1
    sum_row: I1
    sum_scale: F1
    sum_period: F1
    term_ptr: I1
    term_kind: I1
    term_at: I2
    term_data: F2
    sum_entry_ptr: I1
    sum_entry: I2
    counts: I1
    seen: F1
    sized_ptr: I1
    size_ptr: I1
    size_row: I2
    hand_ptr: I1
    hand: I2
