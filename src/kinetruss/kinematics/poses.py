"""Position and orientation of a body, from its nodes."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr

from kinetruss.errors import InputError, shown
from kinetruss.kinematics.jacobians import state_of
from kinetruss.kinematics.turns import refuse_uncounted, with_passed
from kinetruss.mechanics import System, compile, turned
from kinetruss.mechanics.arguments import names_of
from kinetruss.mechanics.positions import centred, spin_of
from kinetruss.mechanics.transfer import flat_positions
from kinetruss.model import Body, Frame, Model, nearest
from kinetruss.model.bodies import barycentric, placed
from kinetruss.model.data import ModelData
from kinetruss.results import Column, Motion, variable
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import NDArray


def nodes_of(model: Model, body: str | Sequence[str]) -> tuple[str, ...]:
    """Names of a body's nodes, or the given names; of ``ground`` the nodes that are fixed in all directions; in the plane also
    the ends of a bar.

    Raises
    ------
    InputError : no such body.
    """
    if not isinstance(body, str):
        return tuple(names_of(body, "a body, or nodes that move as one, e.g. ('P1', 'P2', 'P3')"))
    whole = model.whole
    if body == "ground" and body not in whole.bodies:
        return tuple(name for name, axes in whole.fixed.items() if set(axes) >= set("xyz"[: model.dim]))
    if body not in whole.bodies and model.dim == 2 and body in whole.members:
        return whole.members[body].ends
    if body not in whole.bodies:
        hint = nearest(body, model.bodies) if model.bodies else "The model has no bodies: name nodes, e.g. ('P1', 'P2', 'P3')."
        raise InputError(f"No body called {body!r}. {hint}")
    return whole.bodies[body].nodes


def start_frame(
    model: Model, body: str | Sequence[str], frame: Frame | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Origin (3,) m and axes (3, 3), rows, of the frame of a body in the start configuration (see `pose`)."""
    named = model.whole.bodies.get(body) if isinstance(body, str) else None
    if frame is not None and not isinstance(frame, Frame):
        raise InputError(f"frame is {shown(frame)}. Give kt.Frame(origin=..), or leave it out.")
    own = named.frame if frame is None and named is not None else frame
    origin, axes = np.zeros(3), np.eye(3)
    place, turned = placed(own, model.dim)
    if own is None or own.origin is None:
        place = _centre(model, named) if named is not None else _middle(model, nodes_of(model, body))
    origin[: model.dim], axes[: model.dim, : model.dim] = place, turned
    return origin, axes


def _centre(model: Model, body: Body) -> NDArray[np.float64]:
    """Centre of mass of a body (dim,), m; the centroid of the carriers if none is given (even mass)."""
    if body.center is None:
        return _middle(model, body.carried_by(model.dim))
    origin, axes = placed(body.frame, model.dim)
    return np.asarray(origin + axes.T @ np.array(body.center, float))


def _middle(model: Model, names: Sequence[str]) -> NDArray[np.float64]:
    return np.asarray(np.mean([model.whole.nodes[name].at for name in names], axis=0))


# Position and orientation of a body, from its nodes.

Array = Any


class Carried(NamedTuple):
    """Motion of a frame: origin r, R (axes as columns), both with two rates: r', r'' and w, alpha; speed of its nodes relative
    to the rigid motion. at_start : the axes of the frame in the start configuration as rows, so that R at_start is the
        rotation since then.
    """

    r: tuple[Array, Array, Array]
    R: Array
    w: Array
    alpha: Array
    stretch: Array
    at_start: Array


@one_thread
def pose(
    model: Model,
    motion: Motion,
    body: str | Sequence[str],
    *,
    frame: Frame | None = None,
    seen_from: str | Sequence[str] | None = None,
    euler: str = "ZYX",
) -> xr.Dataset:
    """Position and orientation of a body along a motion, with angular velocity and acceleration.

    Parameters
    ----------
    body : name of a body, in the plane also of a bar, or the names of nodes that move as one (three or more not on a line; in
        the plane two or more).
    frame : axes fixed in the body, given in the start configuration; by default the body's own frame, with its
        origin at the centre of mass if none is given; of bare nodes their centroid and the global axes.
    seen_from : another body (or nodes): everything is then relative to it and in its axes, as seen by an observer on it.
    euler : sequence of the Euler angles, capitals for turns about the turning axes (``ZYX``: yaw, pitch, roll), small letters
        about fixed ones.

    Returns
    -------
    Dataset. ``position`` (time, axis) of the frame's origin, m, with ``velocity``, ``acceleration``;
    ``rotation_matrix`` (time, axis, column): R = global_from_body, the body's axes as columns; ``quaternion`` (time,
    component): w, x, y, z, with continuous sign; ``rotation_vector`` (time, rotation): axis times angle, rad, unwrapped: full
    turns count; ``euler`` (time, turn), rad, unwrapped; ``angular_velocity``, ``angular_acceleration`` (time, rotation).
    In the plane ``angle`` (time), rad, unwrapped, takes the place of matrix, quaternion, vector and Euler angles.
    ``stretch`` (time): largest speed of a node relative to the rigid motion, m/s: 0 for a rigid body.

    Raises
    ------
    InputError : unknown body or node, nodes on one line, a motion of another model, no such Euler sequence; samples of a given
        motion so far apart that whole turns cannot be counted. Samples of `follow` and `simulate` can be any distance apart.

    Notes
    -----
    R is the rotation that fits the nodes best, from the singular value decomposition of sum r r_0^T (Kabsch, 1976): exact for
    a rigid body, the mean rotation of a straining one. w = I^-1 sum r x r' with I = sum |r|^2 1 - r r^T of the nodes, and its
    derivative; neither uses angles, so there are no singular orientations. Points of a straining body move with its carriers.
    At gimbal lock of the Euler angles the third is set to 0.

    >>> import numpy as np, kinetruss as kt
    >>> bar = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"],
    ...                drives={"turn": kt.AngleDrive("b")})
    >>> motion = kt.kinematics.follow(bar, kt.ConstantRate(rates={"turn": 1.0}, duration=10.0), samples=101)
    >>> found = kt.kinematics.pose(bar, motion, ("A", "B"))
    >>> round(float(found.angle[-1]), 9), round(float(found.angular_velocity[-1, 0]), 9)
    (10.0, 1.0)
    """
    motion, samples = with_passed(compile(model), motion)
    found = carried(model, motion, body, frame)
    if seen_from is not None:
        found = _relative(found, carried(model, motion, seen_from, None))
    refuse_uncounted(motion.arrays["time"].values, found.w, f"pose of {_called(body)}")
    dim, turns = model.dim, slice(2, 3) if model.dim == 2 else slice(0, 3)
    names, units = ("position", "velocity", "acceleration"), ("m", "m/s", "m/s^2")
    data = {
        name: variable(("time", "axis"), value[:, :dim], unit, f"{name} of the origin")
        for name, unit, value in zip(names, units, found.r, strict=True)
    }
    data |= _turned(found.R, dim, euler)
    for name, unit, value in (("angular_velocity", "rad/s", found.w), ("angular_acceleration", "rad/s^2", found.alpha)):
        data[name] = variable(("time", "rotation"), value[:, turns], unit, name.replace("_", " "))
    data["stretch"] = variable(("time",), found.stretch, "m/s", "largest departure from a rigid motion")
    coords = {"time": motion.whole["time"], "axis": motion.whole["axis"], "rotation": ["x", "y", "z"][turns]}
    if dim == 3:
        coords |= {"column": ["x", "y", "z"], "component": ["w", "x", "y", "z"], "turn": list(euler)}
    named = {"body": _called(body), "seen_from": "" if seen_from is None else _called(seen_from)}
    return xr.Dataset(data, coords=coords, attrs={"kind": "pose", **named}).isel(time=samples)


def carried(model: Model, motion: Motion, body: str | Sequence[str], frame: Frame | None) -> Carried:
    """The motion of a frame fixed in a body."""
    system = compile(model)
    x, _ = state_of(system, motion)
    histories = [x] + [flat_positions(system, motion.whole[name].values) for name in ("velocity", "acceleration")]
    names = nodes_of(model, body)
    _, arms = centred(system, histories, names)
    R = _rotations(system, names, arms[0])
    w, alpha = spin_of(arms, names, system.dim)
    origin, axes = start_frame(model, body, frame)
    own, along, across, fixed = _follows(system.model, body, names, origin)
    index = [system.node_index(name) for name in own]
    nodes = [y.reshape(len(x), -1, 3)[:, index] for y in histories]
    x_c, v_c, a_c = (np.einsum("k,tkc->tc", along, y) + np.einsum("k,tkc->tc", across, turned(y)) for y in nodes)
    arm = np.einsum("tij,j->ti", R, fixed)
    turning = np.cross(w, arm)
    r = (x_c + arm, v_c + turning, a_c + np.cross(alpha, arm) + np.cross(w, turning))
    stretch = np.linalg.norm(arms[1] - np.cross(w[:, None], arms[0]), axis=2).max(axis=1)
    return Carried(r, R @ axes.T, w, alpha, stretch, axes)


def _follows(
    model: ModelData, body: str | Sequence[str], names: Sequence[str], origin: Array
) -> tuple[Sequence[str], Array, Array, Array]:
    """Position of a point from nodes: x = sum of along_k x_k + across_k (x_k turned left), + R fixed (m); the nodes first.

    A point of a rigid body is the centroid of the nodes plus a rotating arm. A point of a straining body follows its carriers
    by barycentric coordinates; with two carriers in the plane, by a similarity.
    """
    start = np.array([model.nodes[name].at for name in names], float)
    strained = _straining(model, body, names)
    dim = model.dim
    if strained is None:
        middle = start.mean(axis=0)
        return names, np.full(len(names), 1 / len(names)), np.zeros(len(names)), origin - np.pad(middle, (0, 3 - dim))
    carriers = strained.carried_by(dim)
    points = np.array([model.nodes[name].at for name in carriers], float)
    if dim == 2 and len(carriers) == 2:
        d, c = points[1] - points[0], origin[:2] - points[0]
        e, f = float(c @ d / (d @ d)), float((d[0] * c[1] - d[1] * c[0]) / (d @ d))
        return carriers, np.array([1 - e, e]), np.array([-f, f]), np.zeros(3)
    along, _ = barycentric(points, origin[:dim])
    return carriers, along, np.zeros(len(carriers)), origin - np.pad(along @ points, (0, 3 - dim))


def _straining(model: ModelData, body: str | Sequence[str], names: Sequence[str]) -> Body | None:
    """The straining body of a name or of given nodes."""
    if isinstance(body, str):
        found = model.bodies.get(body)
        return found if found is not None and found.kind == "straining" else None
    for one in model.bodies.values():
        if one.kind == "straining" and set(names) in (set(one.nodes), set(one.carried_by(model.dim))):
            return one
    return None


def _rotations(system: System, names: Sequence[str], arms: Array) -> NDArray[np.float64]:
    """Rotation (times, 3, 3) of arms (times, nodes, 3) since the start configuration."""
    start = system.x0[[system.node_index(name) for name in names]]
    H = np.einsum("tni,nj->tij", arms, start - start.mean(axis=0))
    if system.dim == 2:
        H[:, :, 2], H[:, 2, :] = 0.0, 0.0
        angle = np.arctan2(H[:, 1, 0] - H[:, 0, 1], H[:, 0, 0] + H[:, 1, 1])
        return _about_z(angle)
    left, _, right = np.linalg.svd(H)
    # flat bodies have no third direction: choose the one that makes a rotation
    left[:, :, 2] *= np.linalg.det(left @ right)[:, None]
    return np.asarray(left @ right)


def _about_z(angle: Array) -> NDArray[np.float64]:
    R = np.zeros((len(angle), 3, 3))
    R[:, 0, 0] = R[:, 1, 1] = np.cos(angle)
    R[:, 1, 0] = np.sin(angle)
    R[:, 0, 1] = -R[:, 1, 0]
    R[:, 2, 2] = 1.0
    return R


def _relative(one: Carried, base: Carried) -> Carried:
    """Motion of a frame in the axes of another, as seen from it."""
    d, v, a = (p - q for p, q in zip(one.r, base.r, strict=True))
    turned = np.cross(base.w, d)
    v_seen = v - turned
    a_seen = a - np.cross(base.alpha, d) - np.cross(base.w, turned) - 2 * np.cross(base.w, v_seen)
    w = one.w - base.w
    alpha = one.alpha - base.alpha - np.cross(base.w, w)

    def seen(y: Array) -> Array:
        return np.einsum("tji,tj->ti", base.R, y)

    R = np.einsum("tji,tjk->tik", base.R, one.R)
    stretch = np.maximum(one.stretch, base.stretch)
    return Carried((seen(d), seen(v_seen), seen(a_seen)), R, seen(w), seen(alpha), stretch, one.at_start)


def _turned(R: Array, dim: int, euler: str) -> dict[str, Column]:
    """Variables of the orientation."""
    if dim == 2:
        return {"angle": variable(("time",), np.unwrap(np.arctan2(R[:, 1, 0], R[:, 0, 0])), "rad", "angle")}
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_matrix(R)
    q = turn.as_quat(scalar_first=True)
    jumps = np.einsum("tc,tc->t", q[1:], q[:-1]) < 0
    q[1:] *= np.where(np.cumsum(jumps) % 2, -1.0, 1.0)[:, None]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # gimbal lock: said in `pose`
        try:
            angles = turn.as_euler(euler)
        except ValueError:
            raise InputError(
                f"euler={euler!r} is not a sequence of rotations. Write three letters, e.g. 'ZYX' or 'xyz'."
            ) from None
    return {
        "rotation_matrix": variable(("time", "axis", "column"), R, "", "axes of the body as columns"),
        "quaternion": variable(("time", "component"), q, "", "unit quaternion"),
        "rotation_vector": variable(("time", "rotation"), _unwrapped(turn.as_rotvec()), "rad", "axis times angle"),
        "euler": variable(("time", "turn"), np.unwrap(angles, axis=0), "rad", f"Euler angles {euler}"),
    }


def _unwrapped(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotation vectors without jumps: of equal rotations, the one nearest to the vector before."""
    out = vectors.copy()
    for i in range(1, len(out)):
        angle = float(np.linalg.norm(vectors[i]))
        along = vectors[i] / angle if angle > 1e-12 else out[i - 1] / max(float(np.linalg.norm(out[i - 1])), 1e-300)
        out[i] = (angle + 2 * np.pi * np.round((out[i - 1] @ along - angle) / (2 * np.pi))) * along
    return out


def _called(body: str | Sequence[str]) -> str:
    return body if isinstance(body, str) else ", ".join(body)
