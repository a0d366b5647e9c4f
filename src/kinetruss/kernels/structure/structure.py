"""What a structure is made of, element by element, and the order of work: rows and free coordinates in small square blocks.

pairs        constant masses between two nodes: uniform bars, planar bodies, bodies carried by nodes
varying          members whose mass matrix turns with them: active members, bars with rotary inertia (kernels.structure.mass)
laws         constitutive laws: tension of bars by length and rate of length (kernels.structure.laws)
elements     all other kinds, by their addresses (kernels.structure.element_table, kinetruss.elements)
lump, share  masses at single nodes: lumped ones, which may have a gravity of their own, and shares of bodies
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinetruss.kernels.compiled.record import F1, F2, I0, I1, I2, Record, record


@record
class Structure(Record):
    """Element tables of a structure. Places of ends are flat, 3 node.

    pair_A, pair_B (k,) ends, pair (k, 4) : AA, AB, BB and the skew part of AB about z, kg; pair_member (k,) the member that it
    is, or -1. varying_A, varying_B (j,), varying (j, 6) : m_A, m_B, h_A, h_B, second moment, axial mass; varying_member (j,).
    law_A, law_B (s,), law_kind (s,), law (s, 3) : stiffness, natural length, damping; law_member (s,). lump, share (n,) kg.
    element (k, 9) : addresses and places in element_ints, element_reals of each kind (structure.element_table).
    """

    pair_A: I1
    pair_B: I1
    pair_member: I1
    varying_A: I1
    varying_B: I1
    varying_member: I1
    law_A: I1
    law_B: I1
    law_kind: I1
    law_member: I1
    element: I2
    element_ints: I1
    element_reals: F1
    pair: F2
    varying: F2
    law: F2
    lump: F1
    share: F1


class NodalLoads(NamedTuple):
    """gravity (3,), lump_gravity (n, 3), m/s^2; node (loads,) and force (times, loads, 3), N; t (times,) or (1,), s."""

    gravity: np.ndarray
    lump_gravity: np.ndarray
    node: np.ndarray
    force: np.ndarray
    t: np.ndarray


class States(NamedTuple):
    """Histories x, v, a (times, 3 n); at rest v and a are one row of zeros, (1, 3 n)."""

    x: np.ndarray
    v: np.ndarray
    a: np.ndarray


class EndForces(NamedTuple):
    """joint (times, members, 2, 3) : force on each member at its ends, N; rest (times, 3 n) : what is left at the nodes, N."""

    joint: np.ndarray
    rest: np.ndarray


LENGTH, ANGLE, SUM = 0, 1, 2
NONE, ENGINEERING, GREEN, CABLE = 0, 1, 2, 3
"""Constitutive laws of bars."""

RIGID_SHAPE, ALONE, SIZE = 0, 1, 2
"""How a row counts in the singularity measure: not, as a bar that keeps the shape of a rigid part; by itself; as one of the
bars that give a rigid part its size."""

SMALL = 12
"""Rows up to which a block is factored as a full matrix: it is faster than counting zeros."""


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
    Sums (kind SUM): sum_row (s,) their rows, of which sum_ptr[b]:sum_ptr[b+1] are in block b and the last ones redundant; terms
    term_ptr[j]:term_ptr[j+1] of sum j, term_form, term_at, term_data (structure.terms); sum_scale (s,) of the row, sum_period
    (s,); sums: addresses of their kernels (structure.sums), or none. Entries sum_entry_ptr[b]:sum_entry_ptr[b+1]: entry
    sum_entry[., 2] of the gradient of term sum_entry[., 1] is added to row sum_entry[., 0], column sum_entry[., 3].
    Rigid parts (mechanics.rigid_parts): counts (rows,) RIGID_SHAPE, ALONE or SIZE; seen (cols,) 0 where nothing but
    its own part depends on a node, else 1. Parts sized_ptr[b]:sized_ptr[b+1] of block b have the rows size_row[., 0] from
    size_ptr[g] to size_ptr[g+1]; size_row[., 1] is 1 for those that may be the longest. hand[hand_ptr[b]:hand_ptr[b+1]]: flat
    coordinates of nodes of a part, the last one of which (the third if the fourth is -1) keeps its side of the others.
    large, shares : addresses of kernels for blocks that are large (sweep.blocks), and for rows that are redundant
    (sweep.forces), where there are such.
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
    term_form: I2
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
    sums: I1
    large: I1
    shares: I1
