"""Choice of the solver of the equations of motion, and its arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.solve.kkt import factor_of_solver, solve_of_solver
from kinetruss.kernels.solve.kkt_dense import ASSEMBLED, COUPLED, SEPARATE, dense_factor, dense_solve
from kinetruss.kernels.solve.kkt_sparse import sparse_factor, sparse_solve
from kinetruss.kernels.solve.kkt_sweep import sweep_factor, sweep_solve
from kinetruss.kernels.solve.ldl import REDUNDANT, ROW
from kinetruss.kernels.structure.equations import DENSE, SPARSE, SWEEP, Equations, Workspace
from kinetruss.mechanics.measures import flats_of
from kinetruss.mechanics.sparse_plan import sparse_arrays
from kinetruss.mechanics.sweep_plan import sweep_arrays, sweep_plans
from kinetruss.mechanics.system import System
from kinetruss.mechanics.tables import mass_of_pairs
from kinetruss.mechanics.undetermined import redundant_nearby

if TYPE_CHECKING:
    from numpy.typing import NDArray


SOLVERS = {"dense": DENSE, "sparse": SPARSE, "sweep": SWEEP}
KERNELS = {DENSE: (dense_factor, dense_solve), SPARSE: (sparse_factor, sparse_solve), SWEEP: (sweep_factor, sweep_solve)}
"""Those of a solver that factor and solve; a solver is compiled when it is first chosen."""
LARGEST_DENSE = 400
"""Largest number of free coordinates for dense algebra, also for the rank at the start."""
DEARER = 4.0
"""Plans of sweeps that cost more than this multiple of the cheapest other solver are not looked at."""
_WHOLE = np.int64


def solver_arrays(
    system: System, masses: dict[str, Any], solver: str, *, shared: bool = False
) -> tuple[dict[str, Any], NDArray[np.int64]]:
    """Arrays of the chosen solver, and the order of the system's rows in the equations.

    shared : with a workspace for least-norm forces of redundant rows; the sparse solver finds these rows by their pivots.
    """
    if solver != "auto" and solver not in SOLVERS:
        raise InputError(f"no solver called {solver!r}. There are: auto, {', '.join(SOLVERS)}.")
    redundant, weight, sure, bound = _redundant(system, shared)
    augmented_row, augmentation = _augmentation(system, masses)
    sums = len(system.sums) > 0
    if sums and solver == "sweep":
        raise InputError("the sweep solver takes no hinges, axes and couplings. Take auto, dense or sparse.")
    assembled = sums or len(augmented_row) > 0
    costs = _costs(system, masses, assembled, len(redundant) > 0)
    worth = solver == "sweep" or (solver == "auto" and _sweep_cost(system, masses, 0.0) < min(costs.values()))
    most = np.inf if solver == "sweep" else DEARER * min(costs.values())
    plans = sweep_plans(system, most=most) if worth and not len(redundant) and not sums else []
    if plans and plans[0].pivot > 1e-3 and len(system.free) > len(system.row_member):
        costs[SWEEP] = _sweep_cost(system, masses, plans[0].cost)
    chosen = SOLVERS[solver] if solver != "auto" else min(costs, key=lambda one: costs[one])
    if bound and chosen == SPARSE:
        chosen = DENSE  # only there the independent rows are chosen again along the motion
    if chosen == SPARSE and np.isin(augmented_row, system.sums).any():
        chosen = DENSE  # only there sums are added to nodes without mass
    if chosen == SWEEP and not plans:
        raise InputError("the sweep solver needs rows that are independent of each other; some are redundant. Take sparse.")
    rows = np.arange(len(system.row_member))
    order = np.concatenate([np.setdiff1d(rows, redundant), redundant]).astype(np.int64) if chosen == DENSE else rows
    ordered = system.with_rows(order)
    augmented_row = np.flatnonzero(np.isin(order, augmented_row))
    arrays = _nothing() | {"redundant_row": np.isin(order, redundant), "weight": weight[order]}
    arrays |= {"augmented_row": augmented_row, "augmentation": np.array([augmentation])}
    mode = 0
    if chosen == DENSE:
        mode, found = _dense(ordered, masses, assembled)
        arrays |= found
    elif chosen == SPARSE:
        arrays |= sparse_arrays(ordered, masses, augmented_row, shared)
    else:
        arrays |= sweep_arrays(ordered, plans)
    return arrays | addresses_of(chosen) | {"solver": chosen, "mode": mode, "shared": shared, "sure": sure}, order


def addresses_of(solver: int) -> dict[str, int]:
    """The addresses in `Equations` of the kernels of a solver."""
    factor, solve = KERNELS[solver]
    return {"factor_at": factor_of_solver.address(factor), "solve_at": solve_of_solver.address(solve)}


def _redundant(system: System, shared: bool) -> tuple[NDArray[np.int64], NDArray[np.float64], bool, bool]:
    """Rows that are redundant near the start, the weights of the least-norm forces, and `Redundancy`.

    For large systems only the weights, by one rule for all rows.
    """
    r = len(system.row_member)
    if r and len(system.free) <= LARGEST_DENSE:
        found = redundant_nearby(system)
        return found.arrangement.redundant, found.arrangement.weight, found.sure, found.bound
    soft = system.compliance[system.row_member] * system.length0[system.row_member] + system.yielding[system.row_member]
    if not shared or not np.isfinite(soft).all() or (system.row_kind != 0).any():
        return np.zeros(0, np.int64), np.ones(r), False, False
    return np.zeros(0, np.int64), soft / soft.mean(), False, False


def _augmentation(system: System, masses: dict[str, Any]) -> tuple[NDArray[np.int64], float]:
    """Rows at massless nodes, or at bodies that lie in a plane or on a line, and the penalty added for them."""
    n = len(system.nodes)
    own = masses["lump"] + masses["share"]
    for A, values in (
        (masses["pair_A"], masses["pair"][:, 0]),
        (masses["pair_B"], masses["pair"][:, 2]),
        (masses["varying_A"], masses["varying"][:, 0]),
        (masses["varying_B"], masses["varying"][:, 1]),
    ):
        np.add.at(own, A // 3, values)
    free = ~system.prescribed.reshape(n, 3).all(axis=1)
    typical = float(np.mean(own[free & (own > 0)])) if np.any(free & (own > 0)) else 1.0
    bare = free & ((own <= 1e-10 * typical) | system.thin)
    p, q = system.p[system.row_member], system.q[system.row_member]
    touched = bare[p] | bare[q]
    for row in system.sums:
        touched[row] = bare[flats_of(system, row) // 3].any()
    return np.flatnonzero(touched).astype(np.int64), typical


def _costs(system: System, masses: dict[str, Any], assembled: bool, shared: bool) -> dict[int, float]:
    """Estimated time of an evaluation with the sparse and the dense solver, ns; numbers fitted to measurements.

    assembled : the dense solver cannot take fixed forms. shared : some rows are redundant.
    """
    nf, r, plane = len(system.free), len(system.row_member), system.dim == 2
    costs = {SPARSE: (400.0 + (55.0 if plane else 120.0) * (nf + r)) * (2.5 if shared else 1.0)}
    if nf <= LARGEST_DENSE:
        fixed = not assembled and not len(masses["varying_A"])
        costs[DENSE] = 300.0 + 50.0 * r + 2.0 * r**2 + 0.12 * r**3 + 0.5 * nf**2 if fixed else 700.0 + 150.0 * nf + 0.3 * nf**3
    return costs


def _sweep_cost(system: System, masses: dict[str, Any], plan: float) -> float:
    """Estimated time with the block sweeps of a plan, from its cost, ns."""
    nf, members = len(system.free), len(masses["pair_A"]) + 3 * len(masses["varying_A"])
    dofs = nf - len(system.row_member)
    return 800.0 + plan + (dofs + 1) * 8.0 * members + dofs * (dofs + 4) * nf * 0.6


def _nothing() -> dict[str, Any]:
    """Empty arrays of the solvers that are not chosen."""
    sweep = "plans row_ptr col_ptr place row col entry_ptr entry_at entry_row entry_axis"
    sparse = "ptr below target sort place row_place"
    found: dict[str, Any] = {f"sweep_{name}": np.zeros(0, _WHOLE) for name in sweep.split()}
    found |= {f"sparse_{name}": np.zeros(0, _WHOLE) for name in sparse.split()}
    found |= {name: np.zeros((0, 36), _WHOLE) for name in ("sparse_block", "augmented_block", "sparse_bar_block")}
    found["sparse_sum_entry"] = np.zeros((0, 12), _WHOLE)
    found |= {name: np.zeros((0, 0)) for name in ("dense_pair", "dense_inverse", "dense_mass")}
    empty = np.zeros(0)
    return found | {"sparse_entry": np.zeros((0, 6), _WHOLE), "sweep_entry_sign": empty, "sparse_base": empty, "dense": empty}


def _dense(system: System, masses: dict[str, Any], bare: bool) -> tuple[int, dict[str, Any]]:
    """Mode and arrays of the dense solver: inverse mass and quadratic forms, or the constant mass."""
    free = system.free
    nf = len(free)
    local = np.full(system.x0.size, -1, np.int64)
    local[free] = np.arange(nf)
    M = mass_of_pairs(masses["pair_A"], masses["pair_B"], masses["pair"], masses["lump"] + masses["share"])
    M = M.toarray()[np.ix_(free, free)]
    skew = bool(np.any(masses["pair"][:, 3]))
    regular = not bare and nf > 0 and bool(np.linalg.eigvalsh(M)[0] > 1e-12 * np.abs(M).max())
    if not regular or len(masses["varying_A"]) or (skew and system.dim == 3):
        return ASSEMBLED, {"dense_mass": M}
    inverse = np.linalg.inv(M)
    inverse = 0.5 * (inverse + inverse.T)
    member = system.row_member
    pick = np.zeros((3, len(member), nf))
    for c in range(3):
        for end, sign in ((system.q, 1.0), (system.p, -1.0)):
            at = local[3 * end[member].astype(np.int64) + c]
            some = at >= 0
            pick[c, np.flatnonzero(some), at[some]] += sign
    axes = [(0, 0), (0, 1), (1, 0), (1, 1)] if skew else [(0, 0), (1, 1), (2, 2)]
    pair = np.concatenate([pick[a] @ inverse @ pick[b].T for a, b in axes])
    return (COUPLED if skew else SEPARATE), {"dense_inverse": inverse, "dense_pair": pair}


def mark_dropped(eq: Equations, ws: Workspace) -> bool:
    """Mark as redundant the rows that the last sparse factorisation found dependent on others; True if there are any."""
    gone = ws.values[eq.sparse_below.size + eq.sparse_row_place] == 0.0
    eq.sparse_sort[eq.sparse_row_place] = np.where(gone, REDUNDANT, ROW)
    eq.ints[eq.place_of("redundant_row")] = gone
    return bool(gone.any())


def workspace_for(eq: Equations) -> Workspace:
    """A workspace for these equations."""
    n, r, nf, d = eq.local.size, eq.row.size, eq.free.size, eq.motion_kind.size
    shapes: dict[str, tuple[int, ...]] = {"now": (3, d), "u": (3, r), "target": (3, r)}
    shapes |= dict.fromkeys(("gamma", "rhs", "multiplier"), (r,)) | dict.fromkeys(("f", "g", "h", "x", "y", "rest"), (n,))
    shapes |= {"terms": (len(eq.term_form), 24), "term_work": (24,), "pivot": (2,)}
    if eq.solver == DENSE:
        shapes |= {"D": (nf, nf), "W": (nf, r), "S": (r, r), "states": (r, r), "matrix": (r, r), "b": (nf,), "c": (nf,)}
        shapes |= dict.fromkeys(("diagonal", "dependent", "order", "z"), (r,))
    elif eq.solver == SWEEP:
        dofs = nf - r
        widest = int(np.diff(eq.sweep_row_ptr).max(initial=0))
        shapes |= {"lu": (int(eq.sweep_place[-1]),), "row_at": (eq.sweep_row.size,), "col_at": (eq.sweep_col.size,)}
        shapes |= {"taken": (1,), "T": (dofs, n), "MT": (dofs, n), "R": (dofs, dofs), "q": (dofs,), "z": (widest,)}
    else:
        shapes |= {"values": (eq.sparse_base.size,), "gain": (nf + r,)}
        shapes |= {"values_share": (eq.sparse_base.size * eq.shared,)}
    return Workspace.zeros(shapes)
