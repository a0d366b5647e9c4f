"""Inverse kinematics: drives for a prescribed motion of nodes or of a platform, and for single poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from kinetruss.arrays import array_of
from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.kernels.motion.gimbal import platform_motion
from kinetruss.kinematics.drive_limits import limits_of, reported
from kinetruss.kinematics.motions import Course, Swept, course_at, instants, motion_of, sweep_path, with_note
from kinetruss.kinematics.objectives import KNOTTED, best_state
from kinetruss.kinematics.redundant import LEAST, Path
from kinetruss.kinematics.sampling import sample_profile
from kinetruss.kinematics.task_courses import LARGEST, PLATFORM, at_values, explained, freedoms, parameters_of
from kinetruss.kinematics.task_motions import (
    cannot,
    choice_of,
    divided,
    nearest_text,
    prescribed_values,
    tasks_course,
    turned_off,
)
from kinetruss.kinematics.task_problem import MET, STARTS, Problem, State, problem
from kinetruss.kinematics.time_tables import Histories, table_notes, with_supports
from kinetruss.kinematics.turns import REFINED, between, halved
from kinetruss.limits import whole
from kinetruss.mechanics import System, cached, compile
from kinetruss.mechanics.arguments import names_of
from kinetruss.mechanics.bays import POSE
from kinetruss.mechanics.positions import drive_values
from kinetruss.model import TARGETS, Combined, Coordinates, Docking, Model, moved_by, nearest, target_faults
from kinetruss.results import Motion, variable
from kinetruss.results.wide_tables import drive_unit, unit_along
from kinetruss.threads import one_thread

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@one_thread
def inverse(
    model: Model,
    targets: Any,
    *,
    platform: Sequence[str] | None = None,
    samples: int = 201,
    times: ArrayLike | None = None,
    least: float = LEAST,
    raise_on_failure: bool = True,
) -> Motion:
    """The motion, and with it the drive lengths, for tasks of the structure.

    Parameters
    ----------
    targets : a task (`Gimbal`, `Positioning`, `Reflecting`, `Docking`, `Pointing`, `Coordinates`, `Combined`), a list of them,
        or a mapping of coordinates to trajectory records. Or a trajectory record that moves node coordinates (``"N8.x"``) or
        other ones (``"follower.angle"``, ``"bay.beta"``), or with `platform` the displacement ``x, y, z`` (m) of the platform's
        centroid and the rotations ``roll, pitch, yaw`` (rad; R = Rz(yaw) Ry(pitch) Rx(roll)), both relative to its pose in
        the model. In the plane: ``x, y, yaw``.
    platform : names of the nodes that move as one rigid body.
    samples, times, least, raise_on_failure : as in `follow`.

    Returns
    -------
    Motion; ``drive_position`` and its rates are the required motion of the drives.

    Raises
    ------
    ModelError : names of a task that the model does not have, all faults at once.
    InputError : unknown names, targets that the drives cannot do to first order (with the rank, and the direction that they
        lack), a start out of reach. AnalysisError : as in `follow`, or out of reach; the message has the nearest pose found.

    Notes
    -----
    A trajectory of as many node coordinates as the structure has freedoms replaces the drives: its coordinates are prescribed,
    all driven lengths and angles are released, and the same sweep as in `follow` solves for the other coordinates. All else
    is solved for the drives: those that meet the tasks and have the least objective (see `Coordinates`), by Newton's method
    with exact rates; strokes (`Active.limits`) are kept.

    Limits of rates and accelerations (of the task, and of the largest speed of motors) are kept by redundant drives where that
    is found (see `docs/tasks.md`). Attributes of ``motion.data``: ``limits_kept`` (1 or 0), ``worst_limit``, ``worst_drive``,
    ``worst_time`` (s) and ``worst_ratio`` (value over limit); the message says what is not kept, and what is not checked.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> x, y = model.nodes["B"].at
    >>> lift = kt.Quintic(moves={"B.y": (y, y - 0.1)}, duration=1.0)
    >>> motion = kt.kinematics.inverse(model, lift, samples=3)
    >>> (motion.position.sel(node="B", axis="y").values - y).round(6).tolist()  # m
    [0.0, -0.05, -0.1]
    >>> motion.drive_position.sel(drive="actuator").values.round(3).tolist()  # m: what the actuator must do
    [2.5, 2.35, 2.231]
    """
    system = compile(model)
    targets = task_of(system, targets, platform)
    platform = None if isinstance(targets, TARGETS) else platform
    t = instants(targets.duration, samples, times, model)
    course, found = course_to(system, targets, t, platform, least)
    motion = motion_of(system, course, "targets", found.status, found.message)
    if raise_on_failure and not motion.status.ok:
        raise AnalysisError(motion.message, motion)
    return with_note(motion, table_notes(model, targets))


def task_of(system: System, targets: Any, platform: Sequence[str] | None) -> Any:
    """What is asked for: a task, several of them, or a trajectory that fixes all freedoms by itself (see `inverse`).

    A trajectory that leaves freedoms, or moves coordinates other than those of nodes, becomes a task.
    """
    if isinstance(targets, (list, tuple)):
        targets = Combined(tasks=tuple(targets))
    if isinstance(targets, Mapping) and targets and all(hasattr(one, "duration") for one in targets.values()):
        targets = Coordinates(moves=dict(targets), duration=max(one.duration for one in targets.values()))
    if isinstance(targets, TARGETS):
        if platform is not None:
            raise InputError("A task names its platform itself. Leave `platform` out.")
        if faults := list(target_faults(system.given, targets)):
            raise ModelError(faults)
        return targets
    names = list(moved_by(targets)[1])  # refuses anything but a trajectory
    if not system.drives or len(system.free) > LARGEST:
        return targets
    if platform is not None:
        count = 6 if system.dim == 3 else 3
        free = len(system.coordinate_drive) == 0 and freedoms(system).shape[1] > count
        return _docking(system, targets, platform) if free else targets
    nodes = {f"{node}.{axis}" for node in system.nodes for axis in "xyz"[: system.dim]}
    others = [name for name in names if name not in nodes]
    if others:
        known = {*system.drives, *system.members, *(f"{bar}.angle" for bar in system.members)}
        known |= {f"{pose}.{part}" for pose in system.model.poses for part in POSE}
        return (
            Coordinates(moves=dict.fromkeys(names, targets), duration=targets.duration) if known.issuperset(others) else targets
        )
    held = any(system.prescribed[3 * system.node_index(n.rpartition(".")[0]) + "xyz".index(n[-1])] for n in names)
    if not held and not len(system.coordinate_drive) and freedoms(system).shape[1] > len(names):
        return Coordinates(moves=dict.fromkeys(names, targets), duration=targets.duration)
    return targets


def _docking(system: System, targets: Any, platform: Sequence[str]) -> Docking | Any:
    """A trajectory of a platform, relative to where it stands, as a task."""
    platform = names_of([platform] if isinstance(platform, str) else platform, "the nodes of the platform")
    names, known = list(moved_by(targets)[1]), PLATFORM if system.dim == 3 else ("x", "y", "yaw")
    if any(name not in system.nodes for name in platform) or any(name not in known for name in names):
        return targets
    centre = system.x0[[system.node_index(name) for name in platform]].mean(axis=0)

    def course(name: str) -> Any:
        begin = float(centre["xyz".index(name)]) if name in ("x", "y", "z") else 0.0

        def at(t: float) -> tuple[float, float, float]:
            value, rate, second = (float(one[0]) for one in sample_profile(targets, np.array([t]), {name: 0.0})[name])
            return begin + value, rate, second

        return at

    return Docking(platform=tuple(platform), moves={name: course(name) for name in names}, duration=targets.duration)


def course_to(
    system: System, targets: Any, t: NDArray[np.float64], platform: Sequence[str] | None, least: float
) -> tuple[Course, Swept]:
    """The histories that take targets along their trajectory, at the instants t (s,) s, and how it ended."""
    targets = task_of(system, targets, platform)
    if isinstance(targets, TARGETS):
        return tasks_course(system, targets, t)
    dense = between(targets, t)
    for _ in range(REFINED):
        found = _swept(system, targets, dense, platform, least)
        finer = halved(system, found.x, found.v, dense)
        if len(finer) == len(dense):
            break
        dense = finer
    shape = (len(found.x), len(system.nodes), 3)
    drives = drive_values(system, *(y.reshape(shape) for y in (found.x, found.v, found.a)))
    kept = reported(system, limits_of(system, None), "the targets leave the drives no freedom", dense, found.x, drives)
    found = replace(found, message=f"{found.message} {kept.pop('words', '')}".strip())
    return replace(course_at(dense, t, found, drives), attrs=kept), found


def _swept(system: System, targets: Any, t: NDArray[np.float64], platform: Sequence[str] | None, least: float) -> Swept:
    """The sweep with the coordinates that the targets prescribe at the instants t (s,)."""
    if platform is None:
        flats, histories = _node_targets(system, targets, t)
    else:
        flats, histories = _platform_targets(system, targets, t, platform)
    released = release(system, tuple(int(flat) for flat in flats))
    path = Path(t=t, drive=histories, moving=with_supports(released, t, histories))
    try:
        return sweep_path(released, path, least=least)
    except InputError as error:
        raise explained(system, list(moved_by(targets)[1]), platform, error) from None


@cached()
def release(system: System, targets: tuple[int, ...]) -> System:
    """The system with all driven rows released and the given coordinates prescribed; cached, since it also holds its blocks."""
    flats = np.array(targets, np.int32)
    kept = system.row_drive < 0
    prescribed = system.prescribed.copy()
    prescribed[system.coordinate_drive[:, 0]] = False
    if np.any(prescribed[flats]):
        node, axis = divmod(int(flats[prescribed[flats]][0]), 3)
        raise InputError(f"{system.nodes[node]}.{'xyz'[axis]} is fixed and cannot be a target.")
    prescribed[flats] = True
    return system.with_rows(
        kept,
        drives=tuple(f"{system.nodes[f // 3]}.{'xyz'[f % 3]}" for f in flats),
        prescribed=prescribed,
        coordinate_drive=np.stack([flats, np.arange(len(flats), dtype=np.int32)], axis=1).astype(np.int32),
        drive_start=system.x0.reshape(-1)[flats],
    )


def _node_targets(system: System, targets: Any, t: NDArray[np.float64]) -> tuple[NDArray[np.int32], Histories]:
    names = {f"{node}.{axis}": 3 * i + k for i, node in enumerate(system.nodes) for k, axis in enumerate("xyz"[: system.dim])}
    start = {name: float(system.x0.reshape(-1)[flat]) for name, flat in names.items()}
    moved = _sampled(targets, t, start, "The model")
    flats = np.array([names[name] for name in moved], np.int32)
    return flats, _stack(list(moved.values()))


def _platform_targets(
    system: System, targets: Any, t: NDArray[np.float64], platform: Sequence[str]
) -> tuple[NDArray[np.int32], Histories]:
    platform = names_of([platform] if isinstance(platform, str) else platform, "the nodes of the platform")
    if unknown := [name for name in platform if name not in system.nodes]:
        raise InputError(f"No node called {unknown[0]!r} for the platform.")
    known = PLATFORM if system.dim == 3 else ("x", "y", "yaw")
    moved = _sampled(targets, t, dict.fromkeys(known, 0.0), "A platform")
    index, dim = [system.node_index(name) for name in platform], system.dim
    flats = (3 * np.array(index)[:, None] + np.arange(dim)).reshape(-1).astype(np.int32)
    if len(held := flats[system.prescribed[flats]]):
        node, axis = divmod(int(held[0]), 3)
        raise InputError(f"Platform node {system.nodes[node]!r} is fixed in {'xyz'[axis]}.")
    centre = system.x0[index].mean(axis=0)
    derivatives = np.zeros((3, len(t), len(PLATFORM)))
    for k, name in enumerate(PLATFORM):
        if name in moved:
            derivatives[:, :, k] = moved[name]
    found = np.empty((3, len(t), len(index), dim))
    platform_motion(centre, system.x0[index] - centre, derivatives, found)
    value, rate, second = found.reshape(3, len(t), -1)
    return flats, (value, rate, second)


def _sampled(targets: Any, t: NDArray[np.float64], known: Mapping[str, float], what: str) -> dict[str, Any]:
    """Value, rate and acceleration of each coordinate a trajectory moves; `known` holds their starting values."""
    moved = sample_profile(targets, t, known)
    if odd := [name for name in moved if name not in known]:
        offer = ", ".join(list(known)[:6])
        raise InputError(f"{what} has no coordinate {odd[0]!r}. It has: {offer}{' ...' if len(known) > 6 else ''}.")
    return moved


def _stack(columns: list[Any]) -> Histories:
    value, rate, second = (np.ascontiguousarray(np.stack([c[order] for c in columns], axis=1)) for order in range(3))
    return value, rate, second


# Single poses: the drives that meet a task, or come nearest to it.


@one_thread
def reach(
    model: Model, targets: Any, values: Mapping[str, ArrayLike] | None = None, *, onward: bool = False, starts: int = STARTS
) -> xr.Dataset:
    """Drives and positions for single poses of a task: exact where it can be met, else the nearest that is found.

    Parameters
    ----------
    targets : a task, several of them, or a trajectory, as in `inverse`; of its moves the end counts.
    values : coordinate of the task -> (poses,), m or rad: these poses instead; coordinates not named stay at the start,
        also the attitude or direction of a task.
    onward : start each pose from the one before, not from the model's own configuration.
    starts : places from which a pose that is not met is sought, at most: the given one, the model's own, a spread of drives
        over their strokes (without limits: about the start) and some near by; the same in every call.

    Returns
    -------
    Dataset over `pose`: ``drive_position`` (pose, drive) m or rad, ``position`` (pose, node, axis) m, ``asked`` and ``found``
    (pose, coordinate), ``miss`` (pose) m (angles times the shortest bar), ``turn_miss`` (pose): rotation angle, rad, from the
    attitude or direction asked for (NaN: none is), ``reached`` (pose), ``starts`` (pose): how many
    were used, ``same`` (pose): how many of them came as near as the best, ``message`` (pose): empty, or what the nearest
    pose has.

    Raises
    ------
    ModelError, InputError : unknown names, values of different lengths, fewer than one start.

    Notes
    -----
    Damped least squares (Levenberg, 1944; Marquardt, 1963) within the strokes, then the drives of least objective on the
    tasks' surface. The nearest pose is the best of some starts, by the sum of squares of the misses (lengths
    in m, angles times the shortest bar); every start leads to a local minimum, and no other one is excluded.

    >>> import kinetruss as kt
    >>> bay = kt.library.vgt.double_octahedral()
    >>> top = kt.Positioning(node="N8", moves={"z": 0.95}, free=["x", "y"])
    >>> round(float(kt.kinematics.reach(bay, top).position.sel(node="N8", axis="z").values[0]), 9)
    0.95
    """
    starts = whole(starts, "starts", least=1)
    system = compile(model)
    task = task_of(system, targets, None)
    choice = choice_of(task)
    given = problem(system, divided(system, task)[0], choice)
    start = given.tasks.start(given.begin.x)
    names = [one.name for one in given.tasks.asked]
    if values is None:
        parameters = parameters_of(given.tasks, start, np.array([task.duration]))[0]
    else:
        parameters = at_values(given.tasks, _table(names, start, values))
    states, state = [], given.begin
    for row in parameters:
        found = given.reach(row, state, starts=starts)
        if choice.objective in KNOTTED and found.far <= MET * given.scale:
            found = best_state(given, row, found, choice.objective)
        states.append(found)
        state = found if onward else given.begin
    return _dataset(given, names, parameters, states)


def _table(names: list[str], start: Any, values: Mapping[str, ArrayLike]) -> Any:
    """Values (poses, asked) from given columns."""
    for name in values:
        if name not in names:
            raise InputError(f"The task has no coordinate {name!r}. {nearest(name, names)} It has: {', '.join(names)}.")
    columns = {name: np.atleast_1d(array_of(value, name, {}, {"poses": None})) for name, value in values.items()}
    if len({len(one) for one in columns.values()}) > 1:
        raise InputError(
            f"values have different lengths: {', '.join(f'{k} {len(v)}' for k, v in columns.items())}. Give as many."
        )
    count = len(next(iter(columns.values()))) if columns else 1
    table = np.tile(start, (count, 1))
    for name, column in columns.items():
        table[:, names.index(name)] = column
    return table


def _dataset(given: Problem, names: list[str], parameters: Any, states: list[State]) -> xr.Dataset:
    system, count = given.system, len(states)
    x = np.stack([one.x for one in states]).reshape(count, len(system.nodes), 3)[:, :, : system.dim]
    far = np.array([one.far for one in states])
    reached = far <= MET * given.scale
    said = [""] * count
    for k in np.flatnonzero(~reached):
        lacking = cannot(given, given.linear(given.begin, parameters[k])[1])
        said[k] = f"{lacking} {nearest_text(given, states[k], parameters[k])}".strip()
    unit, named = drive_unit(system)
    asked, also = unit_along("coordinate", [given.tasks.unit(one) for one in given.tasks.asked], "coordinate_unit", "m")
    data = {
        "drive_position": variable(("pose", "drive"), np.stack([one.q for one in states]), unit, "drive coordinate"),
        "position": variable(("pose", "node", "axis"), x, "m", "node position"),
        "asked": variable(
            ("pose", "coordinate"), np.stack([prescribed_values(given, row) for row in parameters]), asked, "asked for"
        ),
        "found": variable(("pose", "coordinate"), given.tasks.read(np.stack([one.x for one in states])), asked, "found"),
        "miss": variable(("pose",), far, "m", "largest miss of a coordinate"),
        "turn_miss": variable(
            ("pose",),
            np.array([turned_off(given, one.x, row) for one, row in zip(states, parameters, strict=True)]),
            "rad",
            "rotation angle from the attitude or direction asked for",
        ),
        "reached": ("pose", reached),
        "starts": ("pose", np.array([one.starts for one in states])),
        "same": ("pose", np.array([one.same for one in states])),
        "message": ("pose", said),
    }
    coords = {"drive": list(system.drives), "node": list(system.nodes), "axis": list("xyz"[: system.dim]), "coordinate": names}
    return xr.Dataset(data, coords=coords | named | also, attrs={"kind": "reach"})
