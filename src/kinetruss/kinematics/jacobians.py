"""First and second derivatives of coordinates by others: Jacobians with names, transfer functions, the singularity measure."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kernels.structure.structure import ALONE, Plan
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import System, arrange, compile, constraint_curvature, constraint_jacobian, rearrange
from kinetruss.mechanics.arguments import positions_of
from kinetruss.mechanics.bays import POSE, pose_members
from kinetruss.mechanics.beam_shapes import shaped
from kinetruss.mechanics.coordinates import (
    Basis,
    Coordinate,
    coordinate_gradients,
    coordinate_rows,
    coordinates,
    dof_basis,
    first_order_of,
    is_prescribed,
    row_of,
    second_order_of,
)
from kinetruss.mechanics.transfer import contradicted, flat_positions, transfers
from kinetruss.model import Model
from kinetruss.results import Motion, variable
from kinetruss.results.user_parts import part_axes, users
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def jacobian(
    model: Model,
    state: Motion | ArrayLike | None = None,
    *,
    of: str | Iterable[str],
    wrt: str | Iterable[str] | None = None,
) -> xr.DataArray:
    """Exact first derivatives of coordinates `of` with respect to coordinates `wrt`.

    Parameters
    ----------
    state : positions (n_nodes, dim), m; a Motion, for all its samples; by default the model's own configuration.
    of : names. ``"N8"`` all axes of a node, ``"N8.x"`` one; ``"M7"`` the length of a member (``"M7.length"`` if a node has
        that name too); ``"crank.angle"`` the angle of a bar in the plane; a drive; ``"bay.beta"`` of a pose.
    wrt : likewise; by default all drives. Prescribed lengths, angles and supports change one at a time, with all others held:
        so the length of a rigid bar, or a fixed coordinate ``"N1.x"``, is allowed too. Pose coordinates change with the rest
        of their pose held. Any other set (the coordinates of a node, for instance) replaces all drives, and must have as many
        coordinates as there are drives.

    Returns
    -------
    DataArray (of, wrt), for a Motion (time, of, wrt); coordinates ``of_unit``, ``wrt_unit`` (m or rad).

    Raises
    ------
    InputError : unknown or ambiguous names; a set that does not fix the configuration; a coordinate that others hold too;
        drives that leave freedoms.

    Notes
    -----
    J dx = dq by one forward sweep over the blocks for each column, then d(of) = g . dx with the gradient g of each coordinate.
    A set that replaces the drives adds the inverse of d(set)/d(drives). Exact: no finite differences.

    >>> import kinetruss as kt
    >>> crank = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed=["A"], bars={"b": {"ends": ("A", "B"), "kind": "driven"}},
    ...                  drives={"turn": kt.AngleDrive("b")})
    >>> print(kt.kinematics.jacobian(crank, of="B", wrt=["turn", "b"]).values.round(9) + 0.0)
    [[0. 1.]
     [2. 0.]]
    """
    system = shaped(compile(model))
    x, time = state_of(system, state)
    wanted = coordinates(system, of)
    by = coordinates(system, list(system.drives) if wrt is None else wrt)
    S = sensitivities(system, x, by)
    own = {row_of(system, one) for one in by}
    if bad := [(r, k) for r, k in contradicted(system, x, S) if r not in own]:
        r, k = bad[0]
        raise InputError(
            f"{by[k].name!r} cannot change alone: {system.part_of(r)!r} holds it, too. Choose another coordinate, or "
            "release that bar (kind: elastic or free)."
        )
    found = coordinate_gradients(system, wanted, x) @ S
    coords: dict[str, Any] = {
        "of": [one.name for one in wanted],
        "wrt": [one.name for one in by],
        "of_unit": ("of", [one.unit for one in wanted]),
        "wrt_unit": ("wrt", [one.unit for one in by]),
    }
    attrs = {"long_name": "first derivatives", "units": "of_unit per wrt_unit"}
    if time is None:
        return xr.DataArray(found[0], coords=coords, dims=("of", "wrt"), name="jacobian", attrs=attrs)
    return xr.DataArray(found, coords=coords | {"time": time}, dims=("time", "of", "wrt"), name="jacobian", attrs=attrs)


def state_of(system: System, state: Motion | ArrayLike | None) -> tuple[NDArray[np.float64], Any]:
    """Flat positions (times, 3 n) of a state, and the time axis of a motion."""
    if isinstance(state, Motion):
        check_motion(system, state)
        return flat_positions(system, state.whole["position"].values), state.whole["time"]
    return positions_of(system, state).reshape(1, -1).copy(), None


def sensitivities(system: System, x: NDArray[np.float64], by: list[Coordinate]) -> NDArray[np.float64]:
    """d(node coordinates)/d(coordinates), (times, 3 n, k), at flat positions x (times, 3 n); see `jacobian`."""
    if all(is_prescribed(system, one) for one in by):
        return _columns(system, x, by)
    base = coordinates(system, system.drives)
    base += [one for one in by if is_prescribed(system, one) and not any(_same(one, other) for other in base)]
    full = _completed(system, by)
    if len(full) != len(base):
        raise InputError(
            f"{', '.join(one.name for one in full)} cannot take the place of the drives ({', '.join(system.drives)}): they are "
            f"{len(full)}, wanted are {len(base)}. Name as many coordinates as there are drives."
        )
    columns = _columns(system, x, base)
    change = coordinate_gradients(system, full, x) @ columns
    size = np.linalg.norm(change, axis=2).max(axis=1)
    if np.any(np.linalg.svd(change, compute_uv=False)[:, -1] < 1e-10 * np.maximum(size, 1e-300)):
        raise InputError(
            f"{', '.join(one.name for one in full)} do not fix the configuration: the drives can move while they stand still. "
            "Name other coordinates."
        )
    return np.asarray((columns @ np.linalg.inv(change))[:, :, : len(by)])


def _same(one: Coordinate, other: Coordinate) -> bool:
    return (one.kind, one.index, one.pose) == (other.kind, other.index, other.pose)


def _columns(system: System, x: NDArray[np.float64], by: list[Coordinate]) -> NDArray[np.float64]:
    """Columns of prescribed coordinates, in the order given."""
    rows = [k for k, one in enumerate(by) if one.kind != "node"]
    held = [k for k, one in enumerate(by) if one.kind == "node"]
    found = transfers(
        system, x, np.array([row_of(system, by[k]) for k in rows], np.int64), np.array([by[k].index for k in held], np.int64)
    )
    return found[:, :, np.argsort([*rows, *held], kind="stable")]


def _completed(system: System, by: list[Coordinate]) -> list[Coordinate]:
    """`by`, the other coordinates of its poses, and the remaining drives: all of them if `by` names poses only."""
    if any(one.kind != "pose" and not is_prescribed(system, one) for one in by):
        return by
    poses = list(dict.fromkeys(one.pose for one in by if one.kind == "pose"))
    full = list(by)
    for pose in poses:
        rest = [Coordinate(f"{pose}.{part}", "pose", k, pose) for k, part in enumerate(POSE)]
        full += [one for one in rest if not any(_same(one, other) for other in by)]
    moved = {i for pose in poses for i in pose_members(system, pose)}
    free = [one for one in coordinates(system, system.drives) if not (one.kind == "length" and one.index in moved)]
    return full + [one for one in free if not any(_same(one, other) for other in full)]


# First- and second-order geometric transfer functions: derivatives of nodes and lengths by chosen degrees of freedom.


@one_thread
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
    system = shaped(compile(model))
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
        **part_axes(system),
        "dof": names,
        "by": names,
        "dof_unit": ("dof", [dof.unit for dof in at.dofs]),
    }
    return users(xr.Dataset(data, coords=coords, attrs={"kind": "transfer_functions"}))


# The singularity measure at given positions: how far a structure is from a position in which its drives do not hold it.


def singularity_at(system: System, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """The measure (times,) at flat positions x (times, 3 n), m; 0 where the drives leave anything free.

    1/|P A^-1 E| of the worst block A of the block triangular form, rows of unit length: E has a column for the length or angle
    of each row, but for a rigid part only one, its size; P leaves out nodes that only their own part depends on. Without
    rigid parts it is the smallest singular value of the block. `Motion.singularity` is the same, by iteration. Of a redundant
    structure the blocks have independent rows, chosen at each position.
    """
    system = shaped(system)
    arrangement, found = arrange(system), np.zeros(len(x))
    regular = arrangement.plan is not None and not len(arrangement.redundant)
    for i, place in enumerate(x.reshape(len(x), *system.x0.shape)):
        plan = arrangement.plan if regular else rearrange(system, place, None).plan
        if plan is not None:
            J = constraint_jacobian(system, place).tocsr()
            found[i] = min((_of_block(plan, b, J, place) for b in range(len(plan.ptr) - 1)), default=1.0)
    return found


def _of_block(plan: Plan, b: int, J: Any, x: NDArray[np.float64]) -> float:
    """The measure of one block of J at positions x (n, 3), at most 1."""
    rows, columns = slice(*plan.ptr[b : b + 2]), plan.col[plan.ptr[b] : plan.ptr[b + 1]]
    A = J[plan.row[rows]][:, columns].toarray()
    counts, seen = plan.counts[rows], plan.seen[rows]
    if (counts == ALONE).all() and seen.all():
        return min(1.0, float(np.linalg.svd(A, compute_uv=False)[-1]))
    rates = [np.eye(len(A))[:, counts == ALONE]]
    for first, last in pairwise(plan.size_ptr[plan.sized_ptr[b] : plan.sized_ptr[b + 1] + 1]):
        mine, longest = plan.size_row[first:last].T
        length = np.linalg.norm(
            x.ravel()[plan.B[mine][:, None] + range(3)] - x.ravel()[plan.A[mine][:, None] + range(3)], axis=1
        )
        column = np.zeros((len(A), 1))
        column[mine - plan.ptr[b], 0] = length / length[longest == 1].max()
        rates.append(column)
    E = np.hstack(rates)
    if not E.size or not seen.any():
        return 1.0
    try:
        moved = np.linalg.solve(A, E)[seen == 1]
    except np.linalg.LinAlgError:
        return 0.0
    return float(min(1.0, 1 / max(float(np.linalg.norm(moved, 2)), 1e-300)))
