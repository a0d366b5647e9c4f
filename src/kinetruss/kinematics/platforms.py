"""Position, tilt and angular velocity of a plane or platform, and its Jacobian by the drives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics.jacobians import jacobian, singularity_at, state_of
from kinetruss.kinematics.poses import nodes_of
from kinetruss.kinematics.turns import refuse_uncounted, with_passed
from kinetruss.mechanics import compile
from kinetruss.mechanics.arguments import number_of
from kinetruss.mechanics.positions import Rates, centred, gimbal_angles, normalised, size, spin_of, turn, vector_area
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Model
from kinetruss.results import Column, Motion, variable
from kinetruss.results.wide_tables import drive_unit

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


ORDERS = (("", ""), ("_rate", "/s"), ("_acceleration", "/s^2"))


def platform(model: Model, motion: Motion, nodes: Sequence[str], *, base: Sequence[str] | None = None) -> xr.Dataset:
    """Centroid, height, tilt, angular velocity and acceleration of the plane through three or more nodes.

    Parameters
    ----------
    nodes : three or more, counter-clockwise seen from where the normal points to (for a double-octahedral bay N7, N9, N8);
        in the plane two or more.
    base : nodes of the reference plane, in the same order (N1, N2, N3); by default the global axes and origin.

    Returns
    -------
    Dataset, rates exact. ``centroid`` (time, axis) m, ``centroid_velocity``, ``centroid_acceleration``;
    ``height`` (time): distance of the centroids, m, with ``height_rate``, ``height_acceleration``;
    ``angular_velocity`` rad/s, ``angular_acceleration`` rad/s^2 (time, rotation): global axes;
    ``stretch`` (time): largest speed, m/s, of a node relative to that rigid motion: 0 for a rigid platform.
    In space also ``normal`` (time, axis) and the gimbal angles ``beta``, ``gamma`` (time), rad, of the normal
    (-sin gamma, -sin beta cos gamma, cos beta cos gamma) in the base's frame (x from its first node to its second, z its
    normal), with ``beta_rate``, ``beta_acceleration`` and so on. In the plane ``angle`` (time), rad, from the first node to the
    last, against the base's, with its rates.

    Raises
    ------
    InputError : unknown nodes, too few, nodes on one line; a motion of another model; samples of a given motion too far apart
        to count whole turns.

    Notes
    -----
    The angular velocity is that of a rigid body with the angular momentum of equal masses at the nodes, w = I^-1 sum r x r',
    and alpha is its derivative: for a rigid platform the rates of the body, for nodes that move against each other their mean
    rotation. The normal is that of the polygon, sum r_i x r_(i+1) (Newell), differentiated twice. Lacy (1991), eq. 4.31 to
    4.36, divides by a quantity that vanishes in every pure beta tilt; see the errata.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.double_octahedral()
    >>> motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(0.0, 0.1), duration=1.0), samples=2)
    >>> found = kt.kinematics.platform(model, motion, ["N7", "N9", "N8"], base=["N1", "N2", "N3"])
    >>> found.beta.values[-1].round(6).item()  # rad
    0.1
    """
    system = compile(model)
    motion, samples = with_passed(system, motion)
    x, time = state_of(system, motion)
    histories = [x] + [flat_positions(system, motion.whole[name].values) for name in ("velocity", "acceleration")]
    centre, arms = centred(system, histories, nodes)
    spin = spin_of(arms, nodes, system.dim)
    refuse_uncounted(time.values, spin[0], f"platform of {', '.join(nodes)}")
    stretch = np.linalg.norm(arms[1] - np.cross(spin[0][:, None], arms[0]), axis=2).max(axis=1)
    turns = slice(2, 3) if system.dim == 2 else slice(0, 3)
    data = _vectors("centroid", ("", "_velocity", "_acceleration"), centre, system.dim)
    words = ("angular velocity", "angular acceleration")
    for name, unit, value in zip(words, ("rad/s", "rad/s^2"), spin, strict=True):
        data[name.replace(" ", "_")] = variable(("time", "rotation"), value[:, turns], unit, name)
    data["stretch"] = variable(("time",), stretch, "m/s", "largest departure from a rigid motion")
    below = None if base is None else centred(system, histories, base)
    apart = [c if below is None else c - b for c, b in zip(centre, below[0] if below else centre, strict=True)]
    data |= _scalars("height", size(apart), "m", "distance of the centroids")
    if system.dim == 2:
        data |= _scalars("angle", _angle(arms, below[1] if below else None), "rad", "angle")
    else:
        normal = normalised(vector_area(arms))
        data["normal"] = variable(("time", "axis"), normal[0], "", "normal of the plane")
        for name, rates in gimbal_angles(normal, below[1] if below else None, base).items():
            data |= _scalars(name, rates, "rad", f"gimbal angle {name}")
    coords = {"time": time, "axis": motion.whole["axis"], "rotation": ["x", "y", "z"][turns]}
    attrs = {"kind": "platform", "nodes": list(nodes), "base": list(base or ())}
    return xr.Dataset(data, coords=coords, attrs=attrs).isel(time=samples)


def _vectors(name: str, suffixes: tuple[str, ...], rates: list[Any], dim: int) -> dict[str, Column]:
    units = ("m", "m/s", "m/s^2")
    return {
        f"{name}{suffix}": variable(("time", "axis"), value[:, :dim], unit, f"{name}{suffix.replace('_', ' ')}")
        for suffix, unit, value in zip(suffixes, units, rates, strict=True)
    }


def _scalars(name: str, rates: Rates, unit: str, words: str) -> dict[str, Column]:
    return {
        f"{name}{suffix}": variable(("time",), value, f"{unit}{per}", f"{words}{suffix.replace('_', ', ')}")
        for (suffix, per), value in zip(ORDERS, rates, strict=True)
    }


def _angle(arms: list[Any], base: list[Any] | None) -> Rates:
    """Angle of the line from the first node to the last, against the base's."""
    found = turn(*([y[:, -1, k] - y[:, 0, k] for y in arms] for k in (0, 1)))
    if base is None:
        return found
    other = turn(*([y[:, -1, k] - y[:, 0, k] for y in base] for k in (0, 1)))
    return found[0] - other[0], found[1] - other[1], found[2] - other[2]


# The Jacobian of a platform by its drives, and measures of both kinds of singular position.

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
