"""Derivatives of coordinates by others: dense Jacobians with names."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics.given.own_motion import check_motion
from kinetruss.mechanics import System, compile
from kinetruss.mechanics.configuration import POSE, pose_members, positions_of
from kinetruss.mechanics.freedom import (
    Coordinate,
    contradicted,
    coordinate_gradients,
    coordinates,
    flat_positions,
    is_prescribed,
    row_of,
    transfers,
)
from kinetruss.model import Model
from kinetruss.results import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["jacobian", "sensitivities"]


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
    system = compile(model)
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
        return flat_positions(system, state.data["position"].values), state.data["time"]
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
