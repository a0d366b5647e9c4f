"""Load factors of linear buckling."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.elements.kinds import present
from kinetruss.errors import AnalysisError, InputError
from kinetruss.mechanics import compile, constraint_jacobian, ends_of
from kinetruss.mechanics.balance import Balance, balance_of, measure_forces, row_tensions, sum_stiffness
from kinetruss.mechanics.matrices import bar_laws, geometric_stiffness
from kinetruss.mechanics.rows import null_basis
from kinetruss.model import Model
from kinetruss.results import Result, provenance, variable
from kinetruss.results.user_parts import part_axes
from kinetruss.statics.large_displacements import must_begin
from kinetruss.statics.paths import scaled_force, scaled_loads, without
from kinetruss.statics.saddle_point import Saddle, rows_of
from kinetruss.statics.search import SearchResult, find_equilibrium
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class Buckling(Result):
    """Load factors and modes of linear buckling."""


@one_thread
def buckling(
    model: Model,
    load: str | Mapping[str, float],
    *,
    start: Result | ArrayLike | None = None,
    load_case: str | None = None,
    lengths: Mapping[str, float] | None = None,
    tasks: Mapping[str, Any] | None = None,
    modes: int = 6,
) -> Buckling:
    """Factors of a load at which a structure buckles, if its displacements up to there are small.

    Parameters
    ----------
    load, start, load_case, lengths, tasks : as in `path`: the load that is scaled, and the equilibrium under all other loads,
        with its prestress. modes : largest number of modes.

    Returns
    -------
    Buckling. ``load_factor`` (mode), smallest positive first; ``mode_shape`` (mode, node, axis), largest component 1;
    ``member_force`` (member) N of the state, ``member_force_of_load`` (member) N per unit of the factor. There are no modes if
    no factor makes the structure unstable.

    Raises
    ------
    InputError : an unknown load, one without force; a structure that is unstable, or left free, without the load.
    AnalysisError : no equilibrium without the load.

    Notes
    -----
    (K + factor K_N) shape = 0 on the changes that rigid bars allow, with the geometric stiffness K_N of the forces that the
    load adds to first order. `path` follows the nonlinear equilibrium, which matters most for limit points of shallow
    structures.

    >>> import kinetruss as kt
    >>> column = kt.Model(nodes={"A": (0, 0), "B": (0, 1), "C": (0, 2), "W": (1, 1)}, fixed={"A": "xy", "C": "x", "W": "xy"},
    ...                   bars={"a": ("A", "B"), "b": ("B", "C"), "s": kt.Bar(ends=("B", "W"), kind="elastic", stiffness=10.0)},
    ...                   loads={"P": kt.NodalForce(node="C", force=(0, -1.0))})
    >>> round(kt.statics.buckling(column, "P").load_factor.item(), 9)
    5.0
    """
    system = compile(model)
    push = scaled_force(system, scaled_loads(system, load))
    balance = balance_of(without(system, load, load_case), load_case, tasks)
    reached = at_rest(balance, start, lengths or {})
    free = balance.system.free
    J = constraint_jacobian(balance.system, reached.x)[:, free]
    K = balance.stiffness(reached.x, reached.N)[free][:, free]
    added, geometric = of_load(balance, reached.x, *by_load(balance, reached.x, K, J, push))
    Z = null_basis(J)
    factors, shapes = factors_and_shapes(Z.T @ (K @ Z), Z.T @ (geometric[free][:, free] @ Z))
    kept = min(modes, len(factors))
    full = np.zeros((kept, system.x0.size))
    full[:, free] = (Z @ shapes[:, :kept]).T
    full = full.reshape(kept, len(system.nodes), 3)[:, :, : system.dim]
    full = full / np.abs(full).max(axis=(1, 2), keepdims=True)
    tension = balance.tension(reached.x) + row_tensions(balance.system, reached.x, reached.N)[0]
    data = {
        "load_factor": variable(("mode",), factors[:kept], "", "load factor at which it buckles"),
        "mode_shape": variable(("mode", "node", "axis"), full, "", "its shape, largest component 1"),
        "member_force": variable(("member",), tension, "N", "mean axial force without the load, tension positive"),
        "member_force_of_load": variable(("member",), added, "N", "force that a unit of the load factor adds"),
    }
    return Buckling(
        data=xr.Dataset(data, coords=part_axes(system), attrs={"kind": "buckling", "load_case": balance.name}),
        message="" if kept else "No factor of this load makes the structure unstable.",
        provenance=provenance(model, load_case=balance.name),
    )


def at_rest(balance: Balance, start: Any, lengths: Mapping[str, float]) -> SearchResult:
    """The state without the load; it must be stable."""
    x, wanted, _ = must_begin(balance, start, lengths)
    reached = find_equilibrium(balance, x, wanted, 1e-13, 500)
    if not reached.good:
        raise AnalysisError("The structure has no equilibrium before the load is applied. See statics.equilibrium.")
    if reached.stability.negative or reached.stability.neutral:
        raise InputError("The structure is unstable, or left free, already without the load. See statics.equilibrium.")
    return reached


def by_load(
    balance: Balance, x: NDArray[np.float64], K: Any, J: Any, push: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Displacements (n, 3), m, and row forces (rows,), N, that the load adds to first order at positions x (n, 3)."""
    free = balance.system.free
    rows = rows_of(balance.system, x)
    dx, N = Saddle(K, J, rows).solve(push[free], np.zeros(J.shape[0]))
    flat = np.zeros(push.size)
    flat[free] = dx
    # the forces that the load adds to redundant rigid bars are of least norm, as all others
    return flat.reshape(-1, 3), rows.shared(J, N)


def of_load(
    balance: Balance, x: NDArray[np.float64], moved: NDArray[np.float64], N: NDArray[np.float64]
) -> tuple[NDArray[np.float64], Any]:
    """Tension (members,) N of what a load adds, `by_load`, and its geometric stiffness (3 n, 3 n), N/m."""
    system = balance.system
    _, L, u = ends_of(system, x)
    added = bar_laws(system, L).slope * np.einsum("mc,mc->m", u, moved[system.q] - moved[system.p])
    tension, torque = row_tensions(system, x, N)
    geometric = geometric_stiffness(system, x, added + tension, torque)
    for one, record in present(system):
        if one.geometric is not None:
            geometric = geometric + one.geometric(system, record, x, moved)
    if len(system.measures):
        geometric = geometric + sum_stiffness(system, x, measure_forces(system, N))
    return added + tension, geometric


def factors_and_shapes(K: NDArray[np.float64], G: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positive factors with (K + factor G) shape = 0, ascending, and shapes; K is positive definite."""
    from scipy.linalg import eigh

    if not len(K):
        return np.zeros(0), np.zeros((0, 0))
    inverse, shapes = eigh(-0.5 * (G + G.T), 0.5 * (K + K.T))
    found = np.flatnonzero(inverse > 1e-12 * max(float(np.abs(inverse).max()), 1e-300))[::-1]
    return 1 / inverse[found], shapes[:, found]
