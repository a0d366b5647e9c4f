"""The motion of a joint between two bodies: its angle or slide, with rates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from kinetruss.errors import InputError
from kinetruss.kinematics.jacobians import state_of
from kinetruss.kinematics.poses import Carried, carried, nodes_of
from kinetruss.kinematics.turns import refuse_uncounted, with_passed
from kinetruss.mechanics import compile, coordinate_derivatives
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import HingeDrive, Model, nearest
from kinetruss.results import Motion, variable

Body = str | Sequence[str]


def joint(model: Model, motion: Motion, first: Body, second: Body | None = None) -> xr.Dataset:
    """Angles and slide of a joint by name, or the angle of the pin or revolute where two bodies meet, with rates.

    Parameters
    ----------
    first, second : names of bodies, or of nodes that move as one. They share one node in the plane (a pin), two in space (a
        revolute, about the line from the first to the second shared node, in the order of the first body). Or `first` alone:
        the name of a joint of the model.

    Returns
    -------
    Dataset. Of a joint by name: ``angle`` (time, hinge) rad, unwrapped, about the hinge's axis from its start node to its end
    node, and ``slide`` (time) m, the distance of its two nodes, whichever it has, each with ``_rate`` and ``_acceleration``.
    Of two bodies, over time: ``angle`` rad, 0 at the start configuration, unwrapped; ``angle_rate``, ``angle_acceleration``;
    ``axis`` (time, direction): of the joint, unit, global; ``play`` (time): component of the relative angular velocity normal
    to the axis, rad/s: 0 up to round-off. attrs ``nodes``: the shared ones.

    Raises
    ------
    InputError : unknown bodies or joint, a joint without angle and slide; bodies that share no such nodes (a spherical joint
        has no angle: use `pose` with `seen_from`); samples of a given motion too far apart to count whole turns.

    Notes
    -----
    Rate and acceleration are (w_2 - w_1) . k and (alpha_2 - alpha_1) . k with the axis k; no angle is differenced.

    >>> import kinetruss as kt
    >>> arms = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, bars={"one": ("A", "B"), "two": ("B", "C")}, fixed=["A"],
    ...                 drives={"a": kt.AngleDrive("one"), "b": kt.AngleDrive("two")})
    >>> turn = kt.ConstantRate(rates={"a": 1.0, "b": 3.0}, duration=4.0)
    >>> found = kt.kinematics.joint(arms, kt.kinematics.follow(arms, turn), ("A", "B"), ("B", "C"))
    >>> round(float(found.angle[-1]), 9), found.attrs["nodes"]
    (8.0, ['B'])
    """
    if second is None:
        return _named(model, motion, first)
    motion, samples = with_passed(compile(model), motion)
    common = shared_nodes(model, first, second)
    needed = 1 if model.dim == 2 else 2
    if len(common) != needed:
        raise InputError(_not_a_hinge(model, first, second, common))
    one, two = (carried(model, motion, body, None) for body in (first, second))
    axis = np.zeros((len(one.w), 3))
    axis[:, 2] = 1.0
    if model.dim == 3:
        d = np.diff(motion.whole["position"].sel(node=list(common)).values, axis=1)[:, 0]
        axis = d / np.linalg.norm(d, axis=1)[:, None]
    turning = two.w - one.w
    rate = _along(turning, axis)
    data = {
        "angle": variable(("time",), _angle(model, one, two, common), "rad", "angle of the joint"),
        "angle_rate": variable(("time",), rate, "rad/s", "rate of the joint's angle"),
        "angle_acceleration": variable(("time",), _along(two.alpha - one.alpha, axis), "rad/s^2", "second rate of the angle"),
        "axis": variable(("time", "direction"), axis, "", "axis of the joint"),
        "play": variable(("time",), np.linalg.norm(turning - rate[:, None] * axis, axis=1), "rad/s", "turning off the axis"),
    }
    refuse_uncounted(motion.arrays["time"].values, rate, f"joint of {' and '.join(map(_called, (first, second)))}")
    coords = {"time": motion.whole["time"], "direction": ["x", "y", "z"]}
    return xr.Dataset(data, coords=coords, attrs={"kind": "joint", "nodes": list(common)}).isel(time=samples)


def _named(model: Model, motion: Motion, name: Body) -> xr.Dataset:
    """Angles of the hinges and the slide of a joint of the model."""
    if not isinstance(name, str) or name not in model.joints:
        hint = nearest(name, model.joints) if isinstance(name, str) and model.joints else "Name two bodies instead."
        raise InputError(f"No joint called {name!r}. {hint}")
    record = model.joints[name]
    if not record.hinges and record.slide is None:
        raise InputError(f"{name} is a {record.kind} joint without angle or slide. Use pose(..., seen_from=...).")
    system = compile(model)
    motion, samples = with_passed(system, motion)
    x, time = state_of(system, motion)
    v, a = (flat_positions(system, motion.whole[one].values) for one in ("velocity", "acceleration"))
    states = [y.reshape(len(x), -1, 3) for y in (x, v, a)]
    data = {}
    orders = (("", ""), ("_rate", "/s"), ("_acceleration", "/s^2"))
    if record.hinges:
        drives = [HingeDrive(axis=one.axis, start=one.start, end=one.end) for one in record.hinges]
        angles = np.stack([coordinate_derivatives(system, one, *states) for one in drives], axis=1)
        refuse_uncounted(time.values, angles[:, :, 1], f"joint {name!r}")
        for k, (order, per) in enumerate(orders):
            data[f"angle{order}"] = variable(("time", "hinge"), angles[:, :, k], f"rad{per}", "angle about the hinge")
    if record.slide is not None:
        low, high = (system.node_index(node) for node in record.slide)
        for (order, per), value in zip(orders, _distance(*(y[:, high] - y[:, low] for y in states)), strict=True):
            data[f"slide{order}"] = variable(("time",), value, f"m{per}", "slide of the joint")
    coords = {"time": time} | ({"hinge": [", ".join(one.axis) for one in record.hinges]} if record.hinges else {})
    found = xr.Dataset(data, coords=coords, attrs={"kind": "joint", "joint": name, "bodies": list(record.bodies)})
    return found.isel(time=samples)


def _distance(d: Any, v: Any, a: Any) -> tuple[Any, Any, Any]:
    """Size of a vector (times, 3) with its two rates."""
    size = np.linalg.norm(d, axis=1)
    rate = _along(d, v) / size
    return size, rate, (_along(d, a) + _along(v, v) - rate**2) / size


def shared_nodes(model: Model, first: Body, second: Body) -> tuple[str, ...]:
    """Nodes that two bodies share, in the order of the first."""
    others = set(nodes_of(model, second))
    return tuple(name for name in nodes_of(model, first) if name in others)


def _angle(model: Model, one: Carried, two: Carried, common: Sequence[str]) -> Any:
    """Angle of R_1^T R_2 about the axis fixed in the first body, relative to the start configuration."""
    start = [np.array(model.whole.nodes[name].at, float) for name in common]
    k = np.array([0.0, 0.0, 1.0]) if model.dim == 2 else (start[1] - start[0]) / np.linalg.norm(start[1] - start[0])
    R = np.einsum("tji,tjk->tik", one.R @ one.at_start, two.R @ two.at_start)
    across = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1) @ k
    return np.unwrap(np.arctan2(across, np.trace(R, axis1=1, axis2=2) - 1.0))


def _called(body: Body) -> str:
    return body if isinstance(body, str) else f"({', '.join(body)})"


def _along(y: Any, axis: Any) -> Any:
    return np.einsum("tc,tc->t", y, axis)


def _not_a_hinge(model: Model, first: Body, second: Body, common: Sequence[str]) -> str:
    names = " and ".join(map(_called, (first, second)))
    has = f"share {', '.join(common)}" if common else "share no node"
    wanted = "a pin has one shared node" if model.dim == 2 else "a revolute joint has two shared nodes"
    return f"{names} {has}; {wanted}. For any other pair use pose(..., seen_from=...)."
