"""A trajectory at given times: value, rate and acceleration of every drive of a model."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, Fault, InputError, ModelError
from kinetruss.kernels.motion import profiles
from kinetruss.kernels.motion.gimbal import gimbal_inverse
from kinetruss.kinematics.gimbal_poses import check_pose, gimbal_pose, unreachable
from kinetruss.kinematics.measured_motions import measured_law
from kinetruss.kinematics.time_tables import check_reach, through
from kinetruss.mechanics import ByIdentity, System, cached, compile, is_measured
from kinetruss.mechanics.bays import POSE
from kinetruss.model import (
    AngleDrive,
    ConstantRate,
    CoordinateDrive,
    Cyclic,
    Measured,
    Model,
    Quintic,
    Sine,
    StepResponse,
    Tabulated,
    Trapezoid,
    moved_by,
    trajectory_faults,
)

Floats = NDArray[np.float64]
Law = tuple[Floats, Floats, Floats]


@dataclass(frozen=True, kw_only=True, eq=False)
class Sampled:
    """Values, rates and accelerations of a model's drives at given times.

    drives : names, in the order of ``model.all_drives``.
    times : (n_times,), s.
    value, rate, acceleration : (n_times, n_drives), m or rad, per s, per s^2.
    space : ``pose`` if the trajectory moves at least one pose coordinate, else ``lengths``.
    poses : name of a prescribed pose -> its beta, gamma (rad) and height (m), (n_times, 3).
    """

    drives: tuple[str, ...]
    times: Floats
    value: Floats
    rate: Floats
    acceleration: Floats
    space: Literal["lengths", "pose"]
    poses: Mapping[str, Floats] = field(default_factory=dict)


def sample(model: Model, trajectory: Any, times: ArrayLike) -> Sampled:
    """Value, rate and acceleration of every drive of `model` along `trajectory`, exact (no differences).

    A drive that the trajectory does not move holds its value in the model. A pose coordinate that is not moved holds the
    value of the model's own configuration while another coordinate of its pose moves.

    Parameters
    ----------
    model : Model.
    trajectory : a trajectory record. Time 0 is its start (for a table, its first row).
    times : (n_times,), s. Outside the trajectory, moves hold their ends, periodic and constant-rate laws and step
        responses go on; a table is refused.

    Returns
    -------
    Sampled.

    Raises
    ------
    ModelError : the trajectory names what the model does not have, all faults at once.
    InputError : times outside a table.
    AnalysisError : a pose out of reach; ``error.result`` holds the samples before it.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": {"ends": ("A", "B"), "kind": "driven"}})
    >>> print(sample(model, kt.ConstantRate(rates={"b": 0.5}, duration=2), [0, 2]).value[:, 0])
    [1. 2.]
    """
    check_trajectory(compile(model), trajectory)
    t = np.atleast_1d(array_of(times, "times", {}, {"times": None}, unit="s"))
    return sample_from(model, trajectory, t, _starts(compile(model)))


def sample_from(model: Model, trajectory: Any, t: Floats, start: Mapping[str, float]) -> Sampled:
    """`sample` at times (n_times,), s, with given initial values of all drives, in their order."""
    drives = tuple(model.all_drives)
    names = moved_by(trajectory)[1]
    poses = [name for name in model.poses if any(f"{name}.{key}" in names and f"{name}.{key}" not in start for key in POSE)]
    standing = {**start} | _standing_poses(model, poses, start, names)
    moved = sample_profile(trajectory, t, standing)
    derivatives = np.zeros((t.size, len(drives), 3))
    derivatives[:, :, 0] = np.fromiter(start.values(), float, len(start))
    column = {name: k for k, name in enumerate(drives)}
    for name, law in moved.items():
        if name in column:
            derivatives[:, column[name]] = np.stack(law, axis=-1)
    asked, margin = _move_poses(model, poses, standing, moved, column, derivatives)
    value, rate, acceleration = (np.ascontiguousarray(derivatives[:, :, order]) for order in range(3))
    space: Literal["lengths", "pose"] = "pose" if poses else "lengths"
    wanted = {name: asked[:, j, :, 0] for j, name in enumerate(poses)}
    sampled = Sampled(drives=drives, times=t, value=value, rate=rate, acceleration=acceleration, space=space, poses=wanted)
    _check_reach(sampled, model, poses, asked, margin)
    return sampled


def check_trajectory(system: System, trajectory: Any) -> None:
    """Refuse a trajectory with names that the model does not have. The check of a record is kept with the model.

    Raises `ModelError`, all faults at once.
    """
    if found := _faults(system, ByIdentity(trajectory)):
        raise ModelError(list(found))


@cached()
def _faults(system: System, trajectory: ByIdentity) -> tuple[Fault, ...]:
    return tuple(trajectory_faults(system.given, trajectory.model))


def sample_profile(trajectory: Any, times: Floats, start: Mapping[str, float]) -> dict[str, Law]:
    """Value, rate and acceleration (n_times,) of every coordinate that `trajectory` names: of drives, poses or nodes.

    `start` gives the initial values of constant-rate and sine laws (0 if absent).

    Raises `InputError` for times outside a table.
    """
    names = moved_by(trajectory)[1]
    if isinstance(trajectory, Tabulated):
        value, rate, acceleration = _table(trajectory, times)
        return {name: (value[:, k], rate[:, k], acceleration[:, k]) for k, name in enumerate(names)}
    law = _law(trajectory, times)
    laws = {}
    for name, change in names.items():
        begin, swing = (change[0], change[1] - change[0]) if isinstance(change, tuple) else (start.get(name, 0.0), change)
        laws[name] = (begin + swing * law[0], swing * law[1], swing * law[2])
    return laws


def start_values(model: Model) -> dict[str, float]:
    """Initial value of every drive of `model`: its given length, else the value at the node positions; m or rad."""
    return dict(_starts(compile(model)))


@cached()
def _starts(system: System) -> dict[str, float]:
    return {name: _stand(system, name, drive) for name, drive in system.model.all_drives.items()}


def _stand(system: System, name: str, drive: Any) -> float:
    model = system.model
    if isinstance(drive, CoordinateDrive):
        return model.nodes[drive.node].at["xyz".index(drive.axis)]
    if is_measured(model, drive):
        return float(system.drive_start[system.drives.index(name)])
    member = model.members[drive.bar]
    p, q = (model.nodes[end].at for end in member.ends)
    if isinstance(drive, AngleDrive):
        return math.atan2(q[1] - p[1], q[0] - p[0])
    return member.length if member.length is not None else math.dist(p, q)


def _law(trajectory: Any, t: Floats) -> Law:
    """The function of time that is common to all coordinates of a trajectory."""
    if isinstance(trajectory, Quintic):
        return profiles.quintic(t, trajectory.duration)
    if isinstance(trajectory, Trapezoid):
        return profiles.trapezoid(t, trajectory.duration, trajectory.ramp)
    if isinstance(trajectory, ConstantRate):
        return profiles.steady(t)
    if isinstance(trajectory, Sine):
        return profiles.sine(t, trajectory.period, trajectory.phase)
    if isinstance(trajectory, Cyclic):
        return profiles.cyclic(t, trajectory.period)
    if isinstance(trajectory, StepResponse):
        return profiles.step_response(t, trajectory.frequency, trajectory.damping, trajectory.pole)
    raise InputError(f"{type(trajectory).__name__} is not a trajectory. Give one of the trajectory records, e.g. kt.Quintic.")


def _table(trajectory: Tabulated, t: Floats) -> Law:
    """A measured table; times count from its first row."""
    if t.size:
        check_reach("the trajectory (counted from its first row)", 0.0, trajectory.duration, float(t.min()), float(t.max()))
    rows = np.array(trajectory.times)
    inside = np.clip(rows[0] + t, rows[0], rows[-1])
    if isinstance(trajectory, Measured):
        return measured_law(trajectory, inside)
    columns = np.array(list(trajectory.values.values())).T
    return through(inside, rows, columns, getattr(trajectory, "shape", "spline"))


def _standing_poses(model: Model, poses: list[str], start: Mapping[str, float], names: Mapping[str, Any]) -> dict[str, float]:
    """Pose coordinates of the model's own configuration, computed from its lengths, for poses that need them."""
    standing: dict[str, float] = {}
    for name in poses:
        pose = model.poses[name]
        check_pose(compile(model), name)
        if all(isinstance(names.get(f"{name}.{key}"), tuple) for key in POSE):
            continue
        found = gimbal_pose(pose.base, pose.longeron, [start[drive] for drive in pose.drives])
        standing |= {f"{name}.{key}": float(value) for key, value in zip(POSE, found, strict=True)}
    return standing


def _move_poses(
    model: Model,
    poses: list[str],
    standing: Mapping[str, float],
    moved: Mapping[str, Law],
    column: Mapping[str, int],
    derivatives: Floats,
) -> tuple[Floats, Floats]:
    """Write the drives of all moved poses into derivatives; returns their poses (n, poses, 3, 3) and reach margins."""
    asked = np.zeros((derivatives.shape[0], len(poses), 3, 3))
    lengths, margin = np.empty_like(asked), np.ones(asked.shape[:2])
    if not poses:
        return asked, margin
    for j, name in enumerate(poses):
        for k, key in enumerate(POSE):
            if (law := moved.get(f"{name}.{key}")) is not None:
                asked[:, j, k] = np.stack(law, axis=-1)
            else:
                asked[:, j, k, 0] = standing[f"{name}.{key}"]
    records = [model.poses[name] for name in poses]
    base, longeron = (np.array([getattr(record, side) for record in records]) for side in ("base", "longeron"))
    gimbal_inverse(base, longeron, asked, lengths, margin)
    columns = [[column[drive] for drive in record.drives] for record in records]
    derivatives[:, columns] = lengths
    return asked, margin


def _check_reach(sampled: Sampled, model: Model, poses: list[str], asked: Floats, margin: Floats) -> None:
    """AnalysisError at the first time at which a pose is out of reach, with the samples before it."""
    beyond = ~(margin > 0)
    if not beyond.any():
        return
    i = int(beyond.any(axis=1).argmax())
    j = int(beyond[i].argmax())
    pose = model.poses[poses[j]]
    text = unreachable(pose.base, pose.longeron, *map(float, asked[i, j, :, 0]))
    good = replace(
        sampled,
        times=sampled.times[:i],
        value=sampled.value[:i],
        rate=sampled.rate[:i],
        acceleration=sampled.acceleration[:i],
        poses={name: values[:i] for name, values in sampled.poses.items()},
    )
    raise AnalysisError(f"pose {poses[j]!r} at t = {sampled.times[i]:g} s: {text}", good)
