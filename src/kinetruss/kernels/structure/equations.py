"""The equations of motion as arrays: M(x) a + J^T N = f(t, x, v), J a = gamma, and the room in which they are solved.

Vectors over coordinates are flat, 3 node + axis (planar models keep z = 0). Rows have unit gradients at the solution, so N is
the tension of a bar (N) and, of an angle row, minus the torque over the length. Both records are two buffers
(kernels.compiled.parts); from Python their parts have names, in kernels numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinetruss.kernels.compiled.parts import pack, unpack

__all__ = ["ANGLE_FORCE", "COORDINATE_FORCE", "DENSE", "LENGTH_FORCE", "SPARSE", "SUM_FORCE", "SWEEP", "Equations", "Workspace"]

DENSE, SPARSE, SWEEP = 0, 1, 2
COORDINATE_FORCE, LENGTH_FORCE, ANGLE_FORCE, SUM_FORCE = 0, 1, 2, 3

# new parts go to the end: kernels of other files are compiled with these numbers
_EQUATIONS = (
    "setup", "free", "local", "held", "held_motion", "row", "A", "B", "kind", "motion", "spare", "motion_kind", "motion_ptr",
    "mass_A", "mass_B", "var_A", "var_B", "law_A", "law_B", "law_kind", "law_member", "force_kind", "force_A", "force_B",
    "force_ptr", "force_drive",
    "value", "weight", "motion_data", "piece_start", "piece", "mass", "lump", "constant", "var", "gravity", "lump_gravity",
    "law", "force_time", "force_value",
    "dense", "dense_pair", "dense_inverse", "dense_mass",
    "sweep_plans", "sweep_row_ptr", "sweep_col_ptr", "sweep_place", "sweep_row", "sweep_col", "sweep_entry_ptr",
    "sweep_entry_at", "sweep_entry_row", "sweep_entry_axis", "sweep_entry_sign",
    "sparse_ptr", "sparse_below", "sparse_target", "sparse_entry", "sparse_block", "sparse_stiff_row", "sparse_stiff_block",
    "sparse_sort", "sparse_place", "sparse_row_place", "sparse_base", "sparse_stiff", "sparse_law_block", "sparse_bar_block",
    "follower_mode", "follower_node_ptr", "follower_node", "follower_ptr", "follower_time", "follower_value", "follower_data",
    "follower_vector",
    "edge_A", "edge_B", "edge_rest", "triangle_edge", "triangle_stiff", "tetrahedron_edge", "tetrahedron_stiff",
    "six_edge", "six_stiff",
    "sum_row", "sum_ptr", "term_kind", "term_at", "sparse_sum_entry", "sum_scale", "sum_period", "sum_size", "term_data",
)  # fmt: skip
(
    SETUP, FREE, LOCAL, HELD, HELD_MOTION, ROW, A_, B_, KIND, MOTION, SPARE, MOTION_KIND, MOTION_PTR,
    MASS_A, MASS_B, VAR_A, VAR_B, LAW_A, LAW_B, LAW_KIND, LAW_MEMBER, FORCE_KIND, FORCE_A, FORCE_B,
    FORCE_PTR, FORCE_DRIVE,
    VALUE, WEIGHT, MOTION_DATA, PIECE_START, PIECE, MASS, LUMP, CONSTANT, VAR, GRAVITY, LUMP_GRAVITY,
    LAW, FORCE_TIME, FORCE_VALUE,
    DENSE_STIFF, DENSE_PAIR, DENSE_INVERSE, DENSE_MASS,
    SWEEP_PLANS, SWEEP_ROW_PTR, SWEEP_COL_PTR, SWEEP_PLACE, SWEEP_ROW, SWEEP_COL, SWEEP_ENTRY_PTR,
    SWEEP_ENTRY_AT, SWEEP_ENTRY_ROW, SWEEP_ENTRY_AXIS, SWEEP_ENTRY_SIGN,
    SPARSE_PTR, SPARSE_BELOW, SPARSE_TARGET, SPARSE_ENTRY, SPARSE_BLOCK, SPARSE_STIFF_ROW, SPARSE_STIFF_BLOCK,
    SPARSE_SORT, SPARSE_PLACE, SPARSE_ROW_PLACE, SPARSE_BASE, SPARSE_STIFF, SPARSE_LAW_BLOCK, SPARSE_BAR_BLOCK,
    FOLLOWER_MODE, FOLLOWER_NODE_PTR, FOLLOWER_NODE, FOLLOWER_PTR, FOLLOWER_TIME, FOLLOWER_VALUE, FOLLOWER_DATA,
    FOLLOWER_VECTOR,
    EDGE_A, EDGE_B, EDGE_REST, TRIANGLE_EDGE, TRIANGLE_STIFF, TETRAHEDRON_EDGE, TETRAHEDRON_STIFF,
    SIX_EDGE, SIX_STIFF,
    SUM_ROW, SUM_PTR, TERM_KIND, TERM_AT, SPARSE_SUM_ENTRY, SUM_SCALE, SUM_PERIOD, SUM_SIZE, TERM_DATA,
) = range(len(_EQUATIONS))  # fmt: skip

_WORKSPACE = (
    "dropped", "order", "row_at", "col_at", "taken",
    "now", "u", "aim", "gamma", "f", "g", "h", "x", "y", "rest", "rhs", "pull", "D", "W", "S", "diagonal", "b", "c",
    "states", "matrix", "z", "lu", "T", "MT", "R", "q", "values", "gain", "law_s", "law_r", "values_share",
    "terms", "term_room",
)  # fmt: skip
(
    DROPPED, ORDER, ROW_AT, COL_AT, TAKEN,
    NOW, U, AIM, GAMMA, F, G, H, X, Y, REST, RHS, PULL, D_, W_, S_, DIAGONAL, BB, CC,
    STATES, MATRIX, Z, LU, T_, MT_, R_, Q_, VALUES, GAIN, LAW_S, LAW_R, VALUES_SHARE,
    TERMS, TERM_ROOM,
) = range(len(_WORKSPACE))  # fmt: skip

_FLOATS = {"value", "weight", "piece_start", "lump", "constant", "gravity", "force_time", "force_value", "dense",
           "sweep_entry_sign", "sparse_base", "sparse_stiff", "follower_time", "follower_value", "edge_rest", "sum_scale",
           "sum_period", "sum_size"}  # fmt: skip
_MATRICES = {"motion_data", "piece", "mass", "var", "lump_gravity", "law", "dense_pair", "dense_inverse", "dense_mass",
             "follower_data", "follower_vector", "triangle_stiff", "tetrahedron_stiff", "six_stiff", "term_data"}  # fmt: skip
_GRIDS = {"sparse_entry", "sparse_block", "sparse_stiff_block", "sparse_law_block", "sparse_bar_block", "triangle_edge",
          "tetrahedron_edge", "six_edge", "term_at", "sparse_sum_entry"}  # fmt: skip
_ROOM_WHOLE = {"dropped", "order", "row_at", "col_at", "taken"}
_ROOM_MATRICES = {"now", "u", "aim", "D", "W", "S", "states", "matrix", "T", "MT", "R", "terms"}


class Equations(NamedTuple):
    """What does not change along a run; read only.

    setup : solver, mode of the dense solver, 1 if made for implicit steps, 1 if the sparse solver shares redundant forces,
    1 if rows that are spare are so all along the motion.
    free (nf,) flat free coordinates; local (3 n,) their place, -1 where prescribed.
    held (h,) prescribed coordinates that move and held_motion (h,) the motion of each.
    Rows: row (r,) index in the system; A, B (r,) flat first coordinates of the ends; kind (r,) LENGTH, ANGLE, SUM; motion (r,)
    of the value or -1; value (r,); weight (r,) of the least-squares share; spare (r,) redundant at the start.
    Motions (see _motions): motion_kind (d,), motion_data (d, 4), motion_ptr (d + 1,), piece_start (p,), piece (p, w).
    Constant mass: mass_A, mass_B (k,), mass (k, 4) = AA, AB, BB and the skew part of AB about z; lump (n,); weight force
    constant (3 n,) of it. Changing mass: var_A, var_B (j,), var (j, 6) = m_A, m_B, h_A, h_B, second moment, axial mass.
    gravity (3,), lump_gravity (n, 3).
    Laws: law_A, law_B (s,), law_kind (s,), law (s, 3) = stiffness, natural length, damping; law_member (s,).
    Sums: sum_row (s,) the rows of kind SUM; terms sum_ptr[j]:sum_ptr[j+1] of sum j in term_kind (t,), term_at (t, 4),
    term_data (t, 7) as in _terms, behind them those of given forces; sum_scale, sum_period (s,), sum_size (s,) m.
    Given forces: force_kind, force_A, force_B (g,) coordinates (of a SUM_FORCE first and last term), force_ptr (g + 1,),
    force_time, force_value; force_drive (g,) or -1.
    Loads on bodies: follower_mode (p,), follower_node of p at node_ptr[p]:node_ptr[p + 1], flat, with follower_data (nodes, 4),
    follower_vector (p, 4) (dynamics.assembly.followers); amounts in time as those of given forces.
    Membranes and solids: edge_A, edge_B (e,) flat ends, edge_rest (e,) squared lengths without stress; triangle_*,
    tetrahedron_*, six_* : edges of each element and what they resist with (kernels.structure.continua).
    dense_*, sweep_*, sparse_* : see the solvers.
    """

    ints: NDArray[np.int64]
    reals: NDArray[np.float64]

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name not in _EQUATIONS:
            raise AttributeError(name)
        whole = name not in _FLOATS and name not in _MATRICES
        found = unpack(self, _EQUATIONS.index(name), whole, name not in _MATRICES and name not in _GRIDS)
        return found.astype(np.bool_) if name == "spare" else found

    def place_of(self, name: str) -> slice:
        """Where a part stands in its buffer."""
        offset, rows, columns = self.ints[3 * _EQUATIONS.index(name) :][:3]
        return slice(int(offset), int(offset + rows * columns))

    @classmethod
    def of(cls, arrays: Mapping[str, NDArray[Any]]) -> Equations:
        """The record of named arrays."""
        return cls(*pack(_EQUATIONS, arrays))


class Workspace(NamedTuple):
    """Room for one evaluation; nothing in it is remembered from one call to the next but the factors of `factor`.

    now (3, d) value, rate and acceleration of every motion. u (3, r) gradients at B; aim (3, r) target length or angle, its
    rate and its reciprocal length; gamma, rhs, pull (r,); f, g, h, x, y, rest (3 n,). Dense: D (nf, nf), W (nf, r), S (r, r),
    diagonal (r,), b, c (nf,), dropped, order (r,), states, matrix, z. Sweep: lu, row_at, col_at, taken, T, MT (dof, 3 n),
    R (dof, dof), q (dof,). Sparse: values, gain. terms (t, 10) gradients of sums.
    """

    ints: NDArray[np.int64]
    reals: NDArray[np.float64]

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name not in _WORKSPACE:
            raise AttributeError(name)
        return unpack(self, _WORKSPACE.index(name), name in _ROOM_WHOLE, name not in _ROOM_MATRICES)

    @classmethod
    def of(cls, shapes: Mapping[str, tuple[int, ...]]) -> Workspace:
        """Room of zeros of these shapes; parts that are not named are empty."""
        zeros = {}
        for name in _WORKSPACE:
            nothing = (0, 0) if name in _ROOM_MATRICES else (0,)
            zeros[name] = np.zeros(shapes.get(name, nothing), np.int64 if name in _ROOM_WHOLE else np.float64)
        return cls(*pack(_WORKSPACE, zeros))
