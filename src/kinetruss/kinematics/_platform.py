"""A plane or platform of a model: where it is, how it is tilted, how fast it turns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.kinematics._jacobian import state_of
from kinetruss.kinematics._rigid_motion import centred, spin_of
from kinetruss.kinematics._transfer import flat_positions
from kinetruss.model import Model
from kinetruss.results import Motion, variable
from kinetruss.system import compile

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["platform"]

Jet = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]

ORDERS = (("", ""), ("_rate", "/s"), ("_acceleration", "/s^2"))


def platform(model: Model, motion: Motion, nodes: Sequence[str], *, base: Sequence[str] | None = None) -> xr.Dataset:
    """Centroid, height, tilt, angular velocity and acceleration of the plane through three or more nodes.

    Parameters
    ----------
    nodes : three or more, counter-clockwise seen from where the normal points to (for a double-octahedral bay N7, N9, N8);
        in the plane two or more.
    base : nodes of the plane that it is seen from, in the same order (N1, N2, N3); by default the global axes and origin.

    Returns
    -------
    Dataset, rates exact. ``centroid`` (time, axis) m, ``centroid_velocity``, ``centroid_acceleration``;
    ``height`` (time): distance of the centroids, m, with ``height_rate``, ``height_acceleration``;
    ``angular_velocity`` rad/s, ``angular_acceleration`` rad/s^2 (time, rotation): global axes;
    ``stretch`` (time): largest speed, m/s, by which a node departs from that rigid motion: 0 for a rigid platform.
    In space also ``normal`` (time, axis) and the gimbal angles ``beta``, ``gamma`` (time), rad, of the normal
    (-sin gamma, -sin beta cos gamma, cos beta cos gamma) in the base's frame (x from its first node to its second, z its
    normal), with ``beta_rate``, ``beta_acceleration`` and so on. In the plane ``angle`` (time), rad, from the first node to the
    last, against the base's, with its rates.

    Raises
    ------
    InputError : unknown nodes, too few, nodes on one line; a motion of another model.

    Notes
    -----
    The angular velocity is the one that carries the angular momentum of equal masses at the nodes, w = I^-1 sum r x r', and
    alpha is its derivative: for a rigid platform the rates of the body, for nodes that move against each other their mean
    rotation. The normal is that of the polygon, sum r_i x r_(i+1) (Newell), differentiated twice. Lacy (1991), eq. 4.31 to
    4.36, divides by what vanishes in every pure beta tilt; see the errata.
    """
    system = compile(model)
    x, time = state_of(system, motion)
    histories = [x] + [flat_positions(system, motion.data[name].values) for name in ("velocity", "acceleration")]
    centre, arms = centred(system, histories, nodes)
    spin = spin_of(arms, nodes, system.dim)
    stretch = np.linalg.norm(arms[1] - np.cross(spin[0][:, None], arms[0]), axis=2).max(axis=1)
    turns = slice(2, 3) if system.dim == 2 else slice(0, 3)
    data = _vectors("centroid", ("", "_velocity", "_acceleration"), centre, system.dim)
    words = ("angular velocity", "angular acceleration")
    for name, unit, value in zip(words, ("rad/s", "rad/s^2"), spin, strict=True):
        data[name.replace(" ", "_")] = variable(("time", "rotation"), value[:, turns], unit, name)
    data["stretch"] = variable(("time",), stretch, "m/s", "largest departure from a rigid motion")
    below = None if base is None else centred(system, histories, base)
    apart = [c if below is None else c - b for c, b in zip(centre, below[0] if below else centre, strict=True)]
    data |= _scalars("height", _norm(apart), "m", "distance of the centroids")
    if system.dim == 2:
        data |= _scalars("angle", _angle(arms, below[1] if below else None), "rad", "angle")
    else:
        normal = _unit(_area(arms))
        data["normal"] = variable(("time", "axis"), normal[0], "", "normal of the plane")
        for name, jet in _gimbal(normal, below[1] if below else None, base).items():
            data |= _scalars(name, jet, "rad", f"gimbal angle {name}")
    coords = {"time": time, "axis": motion.data["axis"], "rotation": ["x", "y", "z"][turns]}
    attrs = {"kind": "platform", "nodes": list(nodes), "base": list(base or ())}
    return xr.Dataset(data, coords=coords, attrs=attrs)


def _vectors(name: str, suffixes: tuple[str, ...], jet: list[Any], dim: int) -> dict[str, xr.Variable]:
    units = ("m", "m/s", "m/s^2")
    return {
        f"{name}{suffix}": variable(("time", "axis"), value[:, :dim], unit, f"{name}{suffix.replace('_', ' ')}")
        for suffix, unit, value in zip(suffixes, units, jet, strict=True)
    }


def _scalars(name: str, jet: Jet, unit: str, words: str) -> dict[str, xr.Variable]:
    return {
        f"{name}{suffix}": variable(("time",), value, f"{unit}{per}", f"{words}{suffix.replace('_', ', ')}")
        for (suffix, per), value in zip(ORDERS, jet, strict=True)
    }


def _area(arms: list[Any]) -> Jet:
    """Vector area of the polygon, with two rates."""
    r, v, a = arms
    s, sv, sa = (np.roll(y, -1, axis=1) for y in arms)
    value = np.cross(r, s).sum(axis=1)
    first = (np.cross(v, s) + np.cross(r, sv)).sum(axis=1)
    second = (np.cross(a, s) + 2 * np.cross(v, sv) + np.cross(r, sa)).sum(axis=1)
    return value, first, second


def _norm(jet: Any) -> Jet:
    """Size of a vector with its rates; zero rates where it vanishes."""
    d, v, a = jet
    size = np.linalg.norm(d, axis=1)
    safe = np.where(size > 0, size, 1.0)
    rate = np.einsum("tc,tc->t", d, v) / safe
    second = (np.einsum("tc,tc->t", d, a) + np.einsum("tc,tc->t", v, v) - rate**2) / safe
    return size, rate, np.where(size > 0, second, 0.0)


def _unit(jet: Any) -> Jet:
    """Unit vector with its rates."""
    d, v, a = jet
    size, rate, second = (y[:, None] for y in _norm(jet))
    u = d / size
    ud = (v - rate * u) / size
    return u, ud, (a - second * u - 2 * rate * ud) / size


def _cross(p: Any, q: Any) -> Jet:
    return (
        np.cross(p[0], q[0]),
        np.cross(p[1], q[0]) + np.cross(p[0], q[1]),
        np.cross(p[2], q[0]) + 2 * np.cross(p[1], q[1]) + np.cross(p[0], q[2]),
    )


def _dot(p: Any, q: Any) -> Jet:
    def one(y: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(np.einsum("tc,tc->t", y, z))

    return one(p[0], q[0]), one(p[1], q[0]) + one(p[0], q[1]), one(p[2], q[0]) + 2 * one(p[1], q[1]) + one(p[0], q[2])


def _gimbal(normal: Jet, base: list[Any] | None, names: Sequence[str] | None) -> dict[str, Jet]:
    """beta and gamma of a normal in the frame of the base, with their rates."""
    zero = np.zeros_like(normal[0])
    frame: list[Any] = [(zero + axis, zero, zero) for axis in np.eye(3)]
    if base is not None:
        spin_of(base, names or (), 3)
        up = _unit(_area(base))
        side = [y[:, 1] - y[:, 0] for y in base]
        ahead = _unit(_cross(up, side))  # y = z x (first to second), so that x lies in the plane
        frame = [_cross(ahead, up), ahead, up]
    x, y, z = (_dot(normal, axis) for axis in frame)
    return {"beta": _turn(z, tuple(-part for part in y)), "gamma": _tilt(x, y, z)}


def _turn(c: Any, s: Any) -> Jet:
    """Angle whose cosine and sine go like c and s, with its rates, without jumps."""
    square, slope = c[0] ** 2 + s[0] ** 2, 2 * (c[0] * c[1] + s[0] * s[1])
    rate = (c[0] * s[1] - s[0] * c[1]) / square
    return np.unwrap(np.arctan2(s[0], c[0])), rate, (c[0] * s[2] - s[0] * c[2]) / square - slope * rate / square


def _tilt(x: Any, y: Any, z: Any) -> Jet:
    """gamma = atan2(-x, sqrt(y^2 + z^2))."""
    pair = [np.stack([p, q], axis=1) for p, q in zip(y, z, strict=True)]
    return _turn(_norm(pair), tuple(-part for part in x))


def _angle(arms: list[Any], base: list[Any] | None) -> Jet:
    """Angle of the line from the first node to the last, against the base's."""
    found = _turn(*([y[:, -1, k] - y[:, 0, k] for y in arms] for k in (0, 1)))
    if base is None:
        return found
    other = _turn(*([y[:, -1, k] - y[:, 0, k] for y in base] for k in (0, 1)))
    return found[0] - other[0], found[1] - other[1], found[2] - other[2]
