"""Equations of motion in chosen degrees of freedom q: linear about a state, and in numbers at one state.

    T^T M X0 c'' + T^T (2 M X1 + C X0) c' + T^T (M X2 + C X1 + K X0) c = T^T f,    c = (q, s)

with dx = X0 c, dv = X0 c' + X1 c, da = X0 c'' + 2 X1 c' + X2 c from the rows of `mechanics.coordinates`, and T the columns of
q in X0.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.dynamics.linear_state import Input, Output, moving_forces, unit_load_of
from kinetruss.errors import InputError
from kinetruss.mechanics import RANK_TOLERANCE, compile, constraint_jacobian, ends_of, row_scales
from kinetruss.mechanics.arguments import number_of, positions_of
from kinetruss.mechanics.balance import balance_of, row_tensions
from kinetruss.mechanics.coordinates import (
    Basis,
    Coordinate,
    derivatives_of,
    dof_basis,
    first_order_of,
    row_of,
    second_order_of,
)
from kinetruss.mechanics.matrices import bar_laws, mass_matrix
from kinetruss.mechanics.rows import Derivatives, row_derivatives
from kinetruss.model import Model
from kinetruss.results import variable
from kinetruss.results.user_parts import part_axes, users
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.dynamics.linear_state import State


Floats = Any


@dataclass(frozen=True, kw_only=True, eq=False)
class Reduced:
    """M, C, K (dofs, columns) of columns c = (q, s); F (dofs, forces) of force inputs, commanded lengths among them;
    X0, X1, X2 (3 n, columns).

    full : M, C, K (3 n, 3 n) and unit loads (3 n, forces) before reduction. tension (m,) N. forces : the force inputs.
    """

    M: NDArray[np.float64]
    C: NDArray[np.float64]
    K: NDArray[np.float64]
    F: NDArray[np.float64]
    X: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
    full: tuple[Any, Any, Any, NDArray[np.float64]]
    tension: NDArray[np.float64]
    forces: list[Input]


def reduced(state: State, at: Basis, inputs: list[Input]) -> Reduced:
    """The reduced equations of a state on a basis, with the inputs."""
    balance, x, v = state.balance, state.x, state.v
    system = balance.system
    _, L, u = ends_of(system, x)
    Ld = np.einsum("mc,mc->m", u, v[system.q] - v[system.p])
    force = bar_laws(system, L, Ld).tension - balance.push
    M = mass_matrix(system, x)
    moving = {} if state.still else {"v": v, "a": state.a}
    K, C = balance.tangents(x, state.N, force, **moving)
    motions = [one for one in inputs if one.kind == "motion"]
    X0, X1, X2 = X = _columns(state, at, motions)
    # x = T q: T^T M T, T^T (2 M T' + C T), T^T (M T'' + C T' + K T)
    T = X0[:, : len(at.dofs)]
    forces = [one for one in inputs if one.kind != "motion"]
    push = np.stack([unit_load_of(at.system, one, x) for one in forces], axis=1) if forces else np.zeros((x.size, 0))
    return Reduced(
        M=T.T @ (M @ X0),
        C=T.T @ (2 * (M @ X1) + C @ X0),
        K=T.T @ (M @ X2 + C @ X1 + K @ X0),
        F=T.T @ push,
        X=X,
        full=(M, C, K, push),
        tension=force + row_tensions(system, x, state.N)[0],
        forces=forces,
    )


def _columns(state: State, at: Basis, motions: list[Input]) -> tuple[Floats, Floats, Floats]:
    """X0, X1, X2 (3 n, columns)."""
    system, k, m = at.system, len(at.dofs), len(motions)
    rates = (None, None) if state.still else (state.v, state.a)
    rows, dofs = row_derivatives(system, state.x, *rates), derivatives_of(system, at.dofs, state.x, *rates)
    given = np.zeros((len(rows.r), k + m))
    moved = np.zeros((state.x.size, k + m))
    for j, one in enumerate(motions):
        for part, factor in one.parts:
            if part.kind == "node":
                moved[part.index, k + j] += factor
            else:
                given[row_of(system, part), k + j] += factor
    # G X0 = r s', with unit coordinates and motions
    unit = np.hstack([np.eye(k), np.zeros((k, m))])
    X0 = _solved(at, rows, dofs, rows.r[:, [0]] * given, dofs.r[:, [0]] * unit, moved)
    if state.still:
        return X0, np.zeros_like(X0), np.zeros_like(X0)
    none = np.zeros_like(moved)
    # G X1 = r' s - G' X0
    turned = [rows.r[:, [1]] * given - rows.g[1] @ X0, dofs.r[:, [1]] * unit - dofs.g[1] @ X0]
    X1 = _solved(at, rows, dofs, turned[0], turned[1], none)
    # G X2 = r'' s - 2 G' X1 - G'' X0
    second = [j.r[:, [2]] * s - 2 * (j.g[1] @ X1) - j.g[2] @ X0 for j, s in ((rows, given), (dofs, unit))]
    return X0, X1, _solved(at, rows, dofs, second[0], second[1], none)


def _solved(at: Basis, rows: Derivatives, dofs: Derivatives, by_row: Floats, by_dof: Floats, moved: Floats) -> Floats:
    """Changes (3 n, columns) for right sides of rows and dofs, with prescribed coordinates moved."""
    return moved + at.solve(by_row - rows.g[0] @ moved, by_dof - dofs.g[0] @ moved)


def signal_rows(state: State, at: Basis, found: Reduced, outputs: list[Output]) -> tuple[Floats, Floats, Floats, Floats]:
    """Outputs as linear functions of c, c', c'' (outputs, columns) each, and of force inputs (outputs, forces)."""
    columns, forces = found.M.shape[1], found.F.shape[1]
    sums = [np.zeros((len(outputs), columns)) for _ in range(3)] + [np.zeros((len(outputs), forces))]
    parts = [(i, one, factor) for i, output in enumerate(outputs) for one, factor in output.parts]
    moved = [part for part in parts if outputs[part[0]].kind == "motion"]
    rows = _motion_rows(state, at, found, [one for _, one, _ in moved])
    for k, (i, _, factor) in enumerate(moved):
        order = outputs[i].order
        for power in range(order + 1):
            sums[power][i] += factor * comb(order, power) * rows[order - power][k]
    carried = [part for part in parts if outputs[part[0]].kind == "force"]
    if carried:
        bear = _Bearing(state, at, found)
        for i, one, factor in carried:
            for total, row in zip(sums, bear.rows(one), strict=True):
                total[i] += factor * row
    return sums[0], sums[1], sums[2], sums[3]


def _motion_rows(state: State, at: Basis, found: Reduced, ones: list[Coordinate]) -> tuple[Floats, Floats, Floats]:
    """s = S0 c, s' = S0 c' + S1 c, s'' = S0 c'' + 2 S1 c' + S2 c of coordinates; see `mechanics.coordinates`."""
    rates = (None, None) if state.still else (state.v, state.a)
    derived = derivatives_of(at.system, ones, state.x, *rates)
    g0, g1, g2 = derived.g
    r0, r1, r2 = (derived.r[:, [order]] for order in range(3))
    X0, X1, X2 = found.X
    s = (g0 @ X0) / r0
    s1 = (g0 @ X1 - r1 * s + g1 @ X0) / r0
    return s, s1, (g0 @ X2 - 2 * r1 * s1 - r2 * s + 2 * (g1 @ X1) + g2 @ X0) / r0


class _Bearing:
    """Forces of rows, supports and members that balance the remaining nodal forces."""

    def __init__(self, state: State, at: Basis, found: Reduced) -> None:
        self.state, self.at, self.found = state, at, found
        M, C, K, push = found.full
        X0, X1, X2 = found.X
        # f - M da - C dv - K dx
        self.left = [-(M @ X2 + C @ X1 + K @ X0), -(2 * (M @ X1) + C @ X0), -(M @ X0), push]
        self.G = constraint_jacobian(at.system, state.x)
        share = np.linalg.pinv(self.G[:, at.system.free].toarray().T, rcond=RANK_TOLERANCE)
        self.constraint_forces = [share @ part[at.system.free] for part in self.left]

    def rows(self, one: Coordinate) -> list[Floats]:
        """Output rows of the tension of a member, the torque of a held angle, the force of a support on the structure."""
        row = row_of(self.at.system, one)
        if one.kind == "node":
            column = self.G[:, [one.index]].toarray()[:, 0]
            return [column @ force - part[one.index] for part, force in zip(self.left, self.constraint_forces, strict=True)]
        if row is None:
            return self._law_rows(one)
        arm = float(row_scales(self.at.system, self.state.x, [row])[0])
        return [(arm if one.kind == "length" else -arm) * force[row] for force in self.constraint_forces]

    def _law_rows(self, one: Coordinate) -> list[Floats]:
        """Tension of a member without a row: its law minus the forces of inputs."""
        state, i = self.state, one.index
        s, s1, _ = _motion_rows(state, self.at, self.found, [one])
        _, L, u = ends_of(self.at.system, state.x)
        Ld = np.einsum("mc,mc->m", u, state.v[self.at.system.q] - state.v[self.at.system.p])
        _, slope, damping, _ = bar_laws(self.at.system, L, Ld)
        own = [sum(f for part, f in force.parts if part.kind == "length" and part.index == i) for force in self.found.forces]
        return [slope[i] * s[0] + damping[i] * s1[0], damping[i] * s[0], np.zeros_like(s[0]), -np.array(own, float)]


# The equations of motion in chosen degrees of freedom, at one state, in numbers.


@one_thread
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
    coords = {"dof": names, "by": names, "dof_unit": own, **part_axes(system)}
    return users(xr.Dataset(data, coords=coords, attrs={"kind": "reduced_equations"}))
