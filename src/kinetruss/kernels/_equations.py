"""The equations of motion as arrays: M(x) a + J^T N = f(t, x, v), J a = gamma, and the room in which they are solved.

Vectors over coordinates are flat, 3 node + axis (planar models keep z = 0). Rows have unit gradients at the solution, so N is
the tension of a bar (N) and, of an angle row, minus the torque over the length. Inner loops take arrays, not these records.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

__all__ = ["ANGLE_FORCE", "COORDINATE_FORCE", "DENSE", "LENGTH_FORCE", "SPARSE", "SWEEP", "Equations", "Workspace"]

DENSE, SPARSE, SWEEP = 0, 1, 2
COORDINATE_FORCE, LENGTH_FORCE, ANGLE_FORCE = 0, 1, 2


class Equations(NamedTuple):
    """What does not change along a run; read only.

    setup : [solver, mode of the dense solver]. dense (1,) the c of M + c J^T J. free (nf,) flat free coordinates; local (3 n,) their place, -1 where prescribed.
    held (h,) prescribed coordinates and held_motion (h,) the motion of each.
    Rows: row (r,) index in the system; A, B (r,) flat first coordinates of the ends; kind (r,) LENGTH or ANGLE; motion (r,)
    of the value or -1; value (r,); weight (r,) of the least-squares share; spare (r,) redundant at the start.
    Motions (see _motions): motion_kind (d,), motion_data (d, 4), motion_ptr (d + 1,), piece_start (p,), piece (p, w).
    Constant mass: mass_A, mass_B (k,), mass (k, 4) = AA, AB, BB and the skew part of AB about z; lump (n,); weight force
    constant (3 n,) of it and of constant loads. Changing mass: var_A, var_B (j,), var (j, 6) = m_A, m_B, h_A, h_B, second
    moment, axial mass. gravity (3,), lump_gravity (n, 3).
    Laws: law_A, law_B (s,), law_kind (s,), law (s, 3) = stiffness, natural length, damping; law_member (s,).
    Given forces: force_kind, force_A, force_B (g,), force_ptr (g + 1,), force_time, force_value.
    dense_*, sparse_*, sweep_* : see the solvers.
    """

    setup: np.ndarray
    free: np.ndarray
    local: np.ndarray
    held: np.ndarray
    held_motion: np.ndarray
    row: np.ndarray
    A: np.ndarray
    B: np.ndarray
    kind: np.ndarray
    motion: np.ndarray
    value: np.ndarray
    weight: np.ndarray
    spare: np.ndarray
    motion_kind: np.ndarray
    motion_data: np.ndarray
    motion_ptr: np.ndarray
    piece_start: np.ndarray
    piece: np.ndarray
    mass_A: np.ndarray
    mass_B: np.ndarray
    mass: np.ndarray
    lump: np.ndarray
    constant: np.ndarray
    var_A: np.ndarray
    var_B: np.ndarray
    var: np.ndarray
    gravity: np.ndarray
    lump_gravity: np.ndarray
    law_A: np.ndarray
    law_B: np.ndarray
    law_kind: np.ndarray
    law: np.ndarray
    law_member: np.ndarray
    force_kind: np.ndarray
    force_A: np.ndarray
    force_B: np.ndarray
    force_ptr: np.ndarray
    force_time: np.ndarray
    force_value: np.ndarray
    dense: np.ndarray
    dense_pair: np.ndarray
    dense_inverse: np.ndarray


class Workspace(NamedTuple):
    """Room for one evaluation; nothing in it is remembered from one call to the next but the factors of `factor`.

    now (3, d) value, rate and acceleration of every motion. u (3, r) gradients at B; aim (3, r) target length or angle, its
    rate and its reciprocal length; gamma (r,); f, g, h (3 n,); dense matrices: D (nf, nf), W (r, nf), S (r, r), and vectors
    diagonal, rhs, pull (r,), y, b (nf,); dropped (r,) rows; states, matrix, order, z for the share of their forces.
    report : [smallest pivot].
    """

    now: np.ndarray
    u: np.ndarray
    aim: np.ndarray
    gamma: np.ndarray
    f: np.ndarray
    g: np.ndarray
    h: np.ndarray
    report: np.ndarray
    D: np.ndarray
    W: np.ndarray
    S: np.ndarray
    diagonal: np.ndarray
    rhs: np.ndarray
    pull: np.ndarray
    y: np.ndarray
    b: np.ndarray
    dropped: np.ndarray
    states: np.ndarray
    matrix: np.ndarray
    order: np.ndarray
    z: np.ndarray
