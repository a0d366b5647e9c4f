"""The Jacobian of a platform by its drives, and measures of both kinds of singular position."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics.poses.body_nodes import nodes_of
from kinetruss.kinematics.rates.jacobian import jacobian, state_of
from kinetruss.kinematics.rates.singularity import singularity_at
from kinetruss.mechanics import compile
from kinetruss.mechanics.configuration import centred, number_of
from kinetruss.model import Model
from kinetruss.results import Motion, variable
from kinetruss.results.records import drive_unit

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["TWIST", "platform_jacobian", "twists"]

TWIST = {2: ("v_x", "v_y", "w_z"), 3: ("v_x", "v_y", "v_z", "w_x", "w_y", "w_z")}


def platform_jacobian(
    model: Model,
    platform: str | Sequence[str],
    state: Motion | ArrayLike | None = None,
    *,
    length: float | None = None,
) -> xr.Dataset:
    """Velocity and angular velocity of a platform per unit rate of each drive, and singularity measures.

    Parameters
    ----------
    platform : name of a body, or of nodes that move as one (three or more in space, two or more in the plane).
    state : positions (n_nodes, dim), m; a Motion, for all its samples; by default the model's own configuration.
    length : m, converts rotation to translation in the singularity measures; by default the root mean square distance of the
        platform's nodes from their middle.

    Returns
    -------
    Dataset. ``jacobian`` (time, twist, drive): v of the centroid of the nodes (m/s) and w (rad/s), global axes, per unit rate;
    ``inverse`` (time, drive, twist): rates of the drives for a twist (the pseudoinverse if not all twists are possible);
    ``serial`` (time): ratio of the smallest to the largest singular value of the Jacobian with w times `length`: near 0
    the drives move while the platform does not (first kind, border of the workspace); ``parallel`` (time): smallest singular
    value of the prescribed rows of unit size: near 0 the platform can move with all drives held (second kind, forces become
    unbounded); ``manipulability`` (time): product of the singular values.

    Raises
    ------
    InputError : unknown names, no drives, freedoms that no drive holds, nodes on one line.

    Notes
    -----
    Exact, by one forward sweep over the blocks for each drive. The two kinds: C. Gosselin & J. Angeles, Singularity analysis of
    closed-loop kinematic chains, IEEE Trans. Robotics and Automation 6 (1990) 281-290.

    >>> import kinetruss as kt
    >>> leg = {"kind": "driven"}
    >>> lift = kt.Model(nodes={"A": (0, 0), "B": (2, 0), "P": (0, 1), "Q": (2, 1)}, fixed={"A": "xy", "B": "xy", "P": "x"},
    ...                 bars={"left": {"ends": ("A", "P"), **leg}, "right": {"ends": ("B", "Q"), **leg}, "top": ("P", "Q")})
    >>> kt.kinematics.platform_jacobian(lift, ("P", "Q")).jacobian.round(12).values.tolist()
    [[0.0, 0.0], [0.5, 0.5], [-0.5, 0.5]]
    """
    system = compile(model)
    if not system.drives:
        raise InputError("The model has no drives. Add drives, or make bars driven.")
    if length is not None and not 0 < number_of(length, "length", "m", infinite=True) < np.inf:
        raise InputError(f"length={length:g} must be greater than 0. Give a length, m, or leave it out.")
    x, time = state_of(system, state)
    names = nodes_of(model, platform)
    arms = centred(system, [x, x, x], names)[1][0]
    moved = jacobian(model, state, of=list(names)).values
    moved = moved.reshape(len(x), len(names), model.dim, len(system.drives))
    J = twists(arms, moved, model.dim)
    scale = np.ones(J.shape[1])
    scale[model.dim :] = float(np.sqrt(np.mean(np.sum(arms**2, axis=2)))) if length is None else length
    values = np.linalg.svd(J * scale[:, None], compute_uv=False)
    unit, named = drive_unit(system)
    data = {
        "jacobian": variable(("time", "twist", "drive"), J, f"twist_unit/{unit}", "twist of the platform per rate of a drive"),
        "inverse": variable(
            ("time", "drive", "twist"), np.linalg.pinv(J, rcond=1e-12), f"{unit}/twist_unit", "drives per twist"
        ),
        "serial": variable(("time",), values[:, -1] / np.maximum(values[:, 0], 1e-300), "", "smallest over largest value"),
        "parallel": variable(("time",), singularity_at(system, x), "", "singularity measure"),
        "manipulability": variable(("time",), np.prod(values, axis=1), "", "product of the singular values"),
    }
    twist = list(TWIST[model.dim])
    own = ["m" if name.startswith("v") else "rad" for name in twist]
    coords = {"twist": twist, "drive": list(system.drives), "twist_unit": ("twist", own), **named}
    attrs = {"kind": "platform_jacobian", "length": float(scale[-1])}
    found = xr.Dataset(data, coords=coords, attrs=attrs)
    return found.isel(time=0) if time is None else found.assign_coords(time=time)


def twists(arms: NDArray[np.float64], moved: NDArray[np.float64], dim: int) -> NDArray[np.float64]:
    """Velocity of the centroid and w (times, twist, k) of nodes with velocities (times, nodes, dim, k); arms (times, nodes, 3).

    w = I^-1 sum r x v with I = sum |r|^2 1 - r r^T.
    """
    full = np.zeros((*moved.shape[:2], 3, moved.shape[3]))
    full[:, :, :dim] = moved
    turning = np.cross(arms[..., None], full, axisa=2, axisb=2, axisc=2).sum(axis=1)
    square = np.einsum("tnc,tnc->t", arms, arms)
    if dim == 2:
        w = turning[:, 2:] / square[:, None, None]
    else:
        inertia = square[:, None, None] * np.eye(3) - np.einsum("tni,tnj->tij", arms, arms)
        size = np.linalg.eigvalsh(inertia)
        if np.any(size[:, 0] < 1e-9 * size[:, -1]):
            raise InputError("The nodes of the platform lie on one line, so it has no orientation. Name another node of it.")
        w = np.linalg.solve(inertia, turning)
    return np.concatenate([full.mean(axis=1)[:, :dim], w], axis=1)
