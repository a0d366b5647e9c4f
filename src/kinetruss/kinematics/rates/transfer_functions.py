"""First- and second-order geometric transfer functions: derivatives of nodes and lengths by chosen degrees of freedom."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.mechanics import compile, constraint_curvature, constraint_jacobian
from kinetruss.mechanics.configuration import positions_of
from kinetruss.mechanics.freedom import Basis, Coordinate, coordinate_rows, dof_basis, first_order_of, second_order_of
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
        mixed; as many as the structure has degrees of freedom with the drives among them released. None chooses node
        coordinates.
    position : (n_nodes, dim), m; by default the model's own configuration.
    free : names of further drives that are released.

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


def _dataset(at: Basis, x: NDArray[np.float64], F: NDArray[np.float64], S: NDArray[np.float64]) -> xr.Dataset:
    system, k = at.system, len(at.dofs)
    lengths = coordinate_rows(system, tuple(Coordinate(name, "length", i) for i, name in enumerate(system.members)))
    J, one, two = constraint_jacobian(lengths, x), F.reshape(-1, 3, k), S.reshape(-1, 3, k, k)
    length_first = J @ F
    length_second = (J @ S.reshape(-1, k * k)).reshape(-1, k, k) + constraint_curvature(lengths, x, F)
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
        "node": list(system.nodes),
        "axis": ["x", "y", "z"][: system.dim],
        "member": list(system.members),
        "dof": names,
        "by": names,
        "dof_unit": ("dof", [dof.unit for dof in at.dofs]),
    }
    return xr.Dataset(data, coords=coords, attrs={"kind": "transfer_functions"})
