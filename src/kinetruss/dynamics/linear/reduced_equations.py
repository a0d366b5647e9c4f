"""The equations of motion in chosen degrees of freedom, at one state, in numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.dynamics.linear.state import moving_forces
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.mechanics.assembly import balance_of, mass_matrix
from kinetruss.mechanics.configuration import number_of, positions_of
from kinetruss.mechanics.freedom import dof_basis, first_order_of, second_order_of
from kinetruss.model import Model
from kinetruss.results import variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["reduced_equations"]


def reduced_equations(
    model: Model,
    dofs: str | Iterable[str] | None = None,
    position: ArrayLike | None = None,
    rates: Mapping[str, float] | None = None,
    *,
    free: Iterable[str] = (),
    load_case: str | None = None,
    tasks: Mapping[str, Any] | None = None,
    time: float = 0.0,
) -> xr.Dataset:
    """Reduced mass matrix and right-hand side for degrees of freedom of any mix of coordinates and lengths.

    Parameters
    ----------
    dofs, free : as in `linearise` and `kinematics.transfer_functions`; the drives among them are released.
    position : (n_nodes, dim) m; by default the model's own configuration.
    rates : name of a dof -> its rate, m/s or rad/s; 0 if not given.
    load_case, tasks, time : loads and given drive forces at that instant, s.

    Returns
    -------
    Dataset. ``mass`` (dof, by): T^T M T; ``force`` (dof): T^T (f - M (T' q') q'), N or N m; ``acceleration`` (dof): q'' that
    follows; ``rate`` (dof); ``velocity``, ``node_acceleration`` (node, axis): of all nodes.

    Raises
    ------
    InputError : as in `kinetruss.kinematics.transfer_functions`; a rate of a name that is no dof; degrees of freedom without
        mass.

    Notes
    -----
    T and its derivative are the first- and second-order geometric transfer functions, so v = T q' and
    a = T q'' + (T' q') q' hold exactly, and forces of rigid bars drop out (Meijaard, on truss elements in multibody dynamics).

    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2.0, 0)}, fixed=["A"], bars={"b": kt.Bar(ends=("A", "B"), mass=3.0)},
    ...                gravity=(0, -9.81))
    >>> found = kt.dynamics.reduced_equations(rod, "b.angle", rates={"b.angle": 5.0})
    >>> round(found.mass.item(), 12), round(found.acceleration.item(), 12)
    (4.0, -7.3575)
    """
    system = compile(model)
    x = positions_of(system, position)
    balance = balance_of(system, load_case, tasks, time)
    at = dof_basis(balance.system, dofs, x, free)
    names = [one.name for one in at.dofs]
    if odd := [name for name in (rates or {}) if name not in names]:
        raise InputError(f"{odd[0]!r} is no degree of freedom here. They are: {', '.join(names)}.")
    q = np.array([number_of((rates or {}).get(name, 0.0), f"rates[{name!r}]", "m/s or rad/s") for name in names])
    T = first_order_of(at)
    v = T @ q
    bent = np.einsum("cij,i,j->c", second_order_of(at, T), q, q)
    M = mass_matrix(system, x)
    mass = T.T @ (M @ T)
    force = T.T @ (moving_forces(balance, x, v.reshape(-1, 3)) - M @ bent)
    if np.linalg.matrix_rank(mass, tol=1e-13 * np.abs(mass).max(initial=0.0)) < len(q):
        raise InputError(f"{', '.join(names)} can move without moving any mass. Give a node or bar there a mass, or hold it.")
    second = np.linalg.solve(mass, force)
    nodal = ("node", "axis")
    shaped = [y.reshape(-1, 3)[:, : model.dim] for y in (v, T @ second + bent)]
    data = {
        "mass": variable(("dof", "by"), mass, "kg m^2/dof_unit^2", "reduced mass matrix"),
        "force": variable(("dof",), force, "N m/dof_unit", "reduced force"),
        "acceleration": variable(("dof",), second, "dof_unit/s^2", "acceleration of the degrees of freedom"),
        "rate": variable(("dof",), q, "dof_unit/s", "rate of the degrees of freedom"),
        "velocity": variable(nodal, shaped[0], "m/s", "node velocity"),
        "node_acceleration": variable(nodal, shaped[1], "m/s^2", "node acceleration"),
    }
    own = ("dof", [dof.unit for dof in at.dofs])
    coords = {"dof": names, "by": names, "dof_unit": own, "node": list(system.nodes), "axis": ["x", "y", "z"][: model.dim]}
    return xr.Dataset(data, coords=coords, attrs={"kind": "reduced_equations"})
