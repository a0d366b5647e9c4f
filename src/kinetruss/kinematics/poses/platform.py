"""Position, tilt and angular velocity of a plane or platform."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from kinetruss.kinematics.path.passed import refuse_uncounted, with_passed
from kinetruss.kinematics.rates.jacobian import state_of
from kinetruss.mechanics import compile
from kinetruss.mechanics.configuration import Rates, centred, gimbal_angles, normalised, size, spin_of, turn, vector_area
from kinetruss.mechanics.freedom import flat_positions
from kinetruss.model import Model
from kinetruss.results import Column, Motion, variable

__all__ = ["platform"]

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
    histories = [x] + [flat_positions(system, motion.data[name].values) for name in ("velocity", "acceleration")]
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
    coords = {"time": time, "axis": motion.data["axis"], "rotation": ["x", "y", "z"][turns]}
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
