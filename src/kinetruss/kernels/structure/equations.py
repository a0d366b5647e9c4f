"""The equations of motion as arrays: M(x) a + J^T N = f(t, x, v), J a = gamma, and the workspace in which they are solved.

Vectors over coordinates are flat, 3 node + axis (planar models keep z = 0). Rows have unit gradients at the solution, so N is
the tension of a bar (N) and, of an angle row, minus the torque over the length. Both are records
(kernels.compiled.record).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.record import F1, F2, I0, I1, I2, Record, record
from kinetruss.kernels.structure.structure import Structure

__all__ = ["ANGLE_FORCE", "COORDINATE_FORCE", "DENSE", "LENGTH_FORCE", "SPARSE", "SUM_FORCE", "SWEEP", "Equations", "Workspace"]

DENSE, SPARSE, SWEEP = 0, 1, 2
COORDINATE_FORCE, LENGTH_FORCE, ANGLE_FORCE, SUM_FORCE = 0, 1, 2, 3


@record
class Equations(Structure):
    """The element tables of a structure, and what else does not change along a run; read only.

    solver : DENSE, SPARSE, SWEEP; factor_at, solve_at : addresses of its kernels (solve.kkt). mode : of the dense solver.
    shared : 1 if the sparse solver shares redundant forces. sure : 1 if rows that are redundant are so all along the motion.
    free (nf,) flat free coordinates; local (3 n,) their place, -1 where prescribed.
    held (h,) prescribed coordinates that move and held_motion (h,) the motion of each.
    Rows: row (r,) index in the system; A, B (r,) flat first coordinates of the ends; kind (r,) LENGTH, ANGLE, SUM; motion (r,)
    of the value or -1; value (r,); weight (r,) of the least-squares share; redundant_row (r,) redundant at the start.
    Motions (structure.rows): motion_kind (d,), motion_data (d, 4), motion_ptr (d + 1,), piece_start (p,), piece (p, w).
    constant (3 n,) : weight of constant masses; gravity (3,), lump_gravity (n, 3).
    Sums: sums, addresses of their kernels (structure.sums), or none; sum_row (s,) the rows of kind SUM; terms
    sum_ptr[j]:sum_ptr[j+1] of sum j in term_form (t, 3), term_at (t, 4), term_data (t, 7) as in structure.terms, behind them
    those of given forces; sum_scale, sum_period (s,), sum_size (s,) m.
    Given forces: force_kind, force_A, force_B (g,) coordinates (of a SUM_FORCE first and last term), force_ptr (g + 1,),
    force_time, force_value; force_drive (g,) or -1.
    Loads that depend on positions: load, load_ints, load_reals, a table of kinds as `element`, with forces alone
    (elements.loads); load_time, at which their amounts bend, s.
    Friction of bearings: rubs, addresses of its kernels (solve.kkt), or none; buffers of the records `Bearings` and
    `JointLoads` of structure.bearings, empty without bearings.
    dense_*, sweep_*, sparse_* : see the solvers.
    """

    solver: I0
    factor_at: I0
    solve_at: I0
    mode: I0
    shared: I0
    sure: I0
    free: I1
    local: I1
    held: I1
    held_motion: I1
    row: I1
    A: I1
    B: I1
    kind: I1
    motion: I1
    redundant_row: I1
    motion_kind: I1
    motion_ptr: I1
    force_kind: I1
    force_A: I1
    force_B: I1
    force_ptr: I1
    force_drive: I1
    value: F1
    weight: F1
    motion_data: F2
    piece_start: F1
    piece: F2
    constant: F1
    gravity: F1
    lump_gravity: F2
    force_time: F1
    force_value: F1
    dense: F1
    dense_pair: F2
    dense_inverse: F2
    dense_mass: F2
    sweep_plans: I1
    sweep_row_ptr: I1
    sweep_col_ptr: I1
    sweep_place: I1
    sweep_row: I1
    sweep_col: I1
    sweep_entry_ptr: I1
    sweep_entry_at: I1
    sweep_entry_row: I1
    sweep_entry_axis: I1
    sweep_entry_sign: F1
    sparse_ptr: I1
    sparse_below: I1
    sparse_target: I1
    sparse_entry: I2
    sparse_block: I2
    augmented_row: I1
    augmented_block: I2
    sparse_sort: I1
    sparse_place: I1
    sparse_row_place: I1
    sparse_base: F1
    augmentation: F1
    sparse_bar_block: I2
    load: I2
    load_ints: I1
    load_reals: F1
    load_time: F1
    rubs: I1
    bearing_ints: I1
    bearing_reals: F1
    pressed_ints: I1
    pressed_reals: F1
    sums: I1
    sum_row: I1
    sum_ptr: I1
    term_form: I2
    term_at: I2
    sparse_sum_entry: I2
    sum_scale: F1
    sum_period: F1
    sum_size: F1
    term_data: F2

    @property
    def redundant(self) -> NDArray[np.bool_]:
        """Rows (r,) that are redundant at the start, as a mask."""
        return self.redundant_row > 0


@record
class Workspace(Record):
    """Workspace of one evaluation; nothing in it is remembered from one call to the next but the factors of `factor`.

    now (3, d) value, rate and acceleration of every motion. u (3, r) gradients at B; target (3, r) length or angle, its
    rate and its reciprocal length; gamma, rhs, multiplier (r,); f, g, h, x, y, rest (3 n,). Dense: D (nf, nf), W (nf, r), S (r,
    r), diagonal (r,), b, c (nf,), dependent, order (r,), states, matrix, z. Sweep: lu, row_at, col_at, taken, T, MT (dof, 3 n),
    R (dof, dof), q (dof,). Sparse: values, gain. terms (t, 24) gradients of sums. pivot (2,) : the scaled one of the
    last factors, and the largest one along the motion (0: not known). couple (k,) of bearings in the last accelerations, N m;
    jammed (1,) : 1 + the one whose couple did not settle there, else 0.
    """

    dependent: I1
    order: I1
    row_at: I1
    col_at: I1
    taken: I1
    jammed: I1
    now: F2
    u: F2
    target: F2
    gamma: F1
    f: F1
    g: F1
    h: F1
    x: F1
    y: F1
    rest: F1
    rhs: F1
    multiplier: F1
    D: F2
    W: F2
    S: F2
    diagonal: F1
    b: F1
    c: F1
    states: F2
    matrix: F2
    z: F1
    lu: F1
    T: F2
    MT: F2
    R: F2
    q: F1
    values: F1
    gain: F1
    values_share: F1
    terms: F2
    term_work: F1
    pivot: F1
    couple: F1
