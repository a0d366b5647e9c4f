"""First- and second-order geometric transfer functions: how all nodes and lengths go with chosen degrees of freedom."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kernels.structure.plan import ANGLE
from kinetruss.kinematics.freedom.rows import Basis, basis, chosen_dofs, released
from kinetruss.kinematics.path.positions import positions_of
from kinetruss.mechanics import System, compile, measure_curvature
from kinetruss.model import Model
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["transfer_functions"]


def transfer_functions(
    model: Model, dofs: str | Iterable[str] | None = None, position: ArrayLike | None = None, *, free: Iterable[str] = ()
) -> xr.Dataset:
    """Derivatives of all node coordinates and member lengths by chosen degrees of freedom, first and second.

    Parameters
    ----------
    dofs : names of node coordinates (``"B.x"``), lengths (``"M7"``, a driven or elastic member), angles (``"crank.angle"``),
        mixed; as many as the structure has freedoms once the drives among them are let go. None chooses node coordinates.
    position : (n_nodes, dim), m; by default the model's own configuration.
    free : names of further drives that are let go.

    Returns
    -------
    Dataset. ``first`` F' (node, axis, dof), ``second`` F'' (node, axis, dof, by): of node positions, m per unit of the dof;
    ``length_first`` (member, dof), ``length_second`` (member, dof, by): of member lengths. ``dof_unit``: m or rad. A motion
    of the dofs q(t) has v = F' q' and a = F' q'' + (F'' q') q'.

    Raises
    ------
    InputError : unknown names, too many or too few of them, a coordinate that is held, a set that does not fix the
        configuration (a dead centre).

    Notes
    -----
    J F' = dq on the prescribed rows, J F''_ij = -F'_i^T H F'_j with the Hessian H = P/L of a length and -(n u^T + u n^T)/L^2
    of an angle: sparse solves with one matrix. Source: Meijaard, on truss elements in multibody dynamics (geometric transfer
    functions).

    >>> import kinetruss as kt
    >>> crank = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    >>> found = kt.kinematics.transfer_functions(crank, "b.angle")
    >>> found.first.sel(node="B").values.ravel().tolist(), found.second.sel(node="B").values.ravel().tolist()
    ([0.0, 2.0], [-2.0, 0.0])
    """
    system = compile(model)
    x = positions_of(system, position)
    at = dof_basis(system, dofs, x, free)
    F = first_order_of(at)
    return _dataset(at, x, F, second_order_of(at, F))


def dof_basis(system: System, dofs: str | Iterable[str] | None, x: NDArray[np.float64], free: Iterable[str]) -> Basis:
    """The basis of named degrees of freedom, the drives among them and those of `free` let go."""
    names = [free] if isinstance(free, str) else list(free)
    if unknown := [name for name in names if name not in system.drives]:
        raise InputError(f"No drive called {unknown[0]!r} to let go. There are: {', '.join(system.drives) or 'none'}.")
    chosen, own = (None, ()) if dofs is None else chosen_dofs(system, dofs)
    return basis(released(system, tuple(dict.fromkeys([*names, *own]))), chosen, x)


def first_order_of(at: Basis) -> NDArray[np.float64]:
    """F' (3 n, dofs)."""
    return at.solve(np.zeros((len(at.system.row_member), len(at.dofs))), np.diag(at.scale))


def second_order_of(at: Basis, F: NDArray[np.float64]) -> NDArray[np.float64]:
    """F'' (3 n, dofs, dofs)."""
    system, k = at.system, len(at.dofs)
    rows = -_curved(system, at.x, F, system.row_member.astype(np.int64), system.row_kind == ANGLE)
    for r in system.sums:
        m = system.row_measure[r]
        rows[r] = -system.measure_scale[m] * measure_curvature(system, m, at.x, F)
    dofs = np.zeros((k, k, k))
    for place, one in enumerate(at.dofs):
        if one.kind == "sum":
            dofs[place] = -measure_curvature(system, one.index, at.x, F)
    own = [j for j, one in enumerate(at.dofs) if one.kind in ("length", "angle")]
    member = np.array([at.dofs[j].index for j in own], np.int64)
    dofs[own] = -_curved(system, at.x, F, member, np.array([at.dofs[j].kind == "angle" for j in own], np.bool_))
    i, j = np.triu_indices(k)
    found = np.empty((at.x.size, k, k))
    found[:, i, j] = found[:, j, i] = at.solve(rows[:, i, j], dofs[:, i, j])
    return found


def _curved(
    system: System, x: NDArray[np.float64], F: NDArray[np.float64], member: NDArray[np.int64], angle: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """F'_i^T H F'_j (members, dofs, dofs) of lengths, or of angles times the length, with their Hessians H."""
    p, q = system.p[member], system.q[member]
    d = x[q] - x[p]
    L = np.linalg.norm(d, axis=1)[:, None, None]
    change = F.reshape(-1, 3, F.shape[1])
    D = change[q] - change[p]
    along = np.einsum("mc,mck->mk", d, D) / L[:, 0]
    found = np.asarray((np.einsum("mci,mcj->mij", D, D) - along[:, :, None] * along[:, None, :]) / L)
    if angle.any():
        n = np.stack([-d[:, 1], d[:, 0], np.zeros(len(d))], axis=1)
        across = np.einsum("mc,mck->mk", n, D) / L[:, 0]
        both = across[:, :, None] * along[:, None, :]
        found[angle] = (-(both + both.swapaxes(1, 2)) / L)[angle]
    return found


def _dataset(at: Basis, x: NDArray[np.float64], F: NDArray[np.float64], S: NDArray[np.float64]) -> xr.Dataset:
    system, k = at.system, len(at.dofs)
    members = np.arange(len(system.members))
    u = (x[system.q] - x[system.p]) / np.linalg.norm(x[system.q] - x[system.p], axis=1, keepdims=True)
    one, two = F.reshape(-1, 3, k), S.reshape(-1, 3, k, k)
    length_first = np.einsum("mc,mck->mk", u, one[system.q] - one[system.p])
    length_second = np.einsum("mc,mcij->mij", u, two[system.q] - two[system.p])
    length_second += _curved(system, x, F, members, np.zeros(len(members), np.bool_))
    names = [dof.name for dof in at.dofs]
    data = {
        "first": variable(("node", "axis", "dof"), one[:, : system.dim], "m per dof_unit", "first-order transfer functions"),
        "second": variable(
            ("node", "axis", "dof", "by"), two[:, : system.dim], "m per dof_unit^2", "second-order transfer functions"
        ),
        "length_first": variable(("member", "dof"), length_first, "m per dof_unit", "first derivatives of lengths"),
        "length_second": variable(("member", "dof", "by"), length_second, "m per dof_unit^2", "second derivatives of lengths"),
    }
    coords = {
        "node": list(system.nodes), "axis": ["x", "y", "z"][: system.dim], "member": list(system.members), "dof": names,
        "by": names, "dof_unit": ("dof", [dof.unit for dof in at.dofs]),
    }  # fmt: skip
    return xr.Dataset(data, coords=coords, attrs={"kind": "transfer_functions"})
