"""The coordinates of tasks in time, and errors of targets that a structure cannot follow."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.motion import profiles
from kinetruss.kinematics.sampling import sample_profile
from kinetruss.kinematics.task_programs import DIRECTION, EVEN, Asked, Tasks, moved
from kinetruss.kinematics.time_tables import through
from kinetruss.mechanics import RANK_TOLERANCE, System, jacobian
from kinetruss.model import TRAJECTORY_TASKS, Way

if TYPE_CHECKING:
    from numpy.typing import NDArray


PLATFORM = ("x", "y", "z", "roll", "pitch", "yaw")
WAYS = ("move along x", "move along y", "move along z", "roll (turn about x)", "pitch (turn about y)", "yaw (turn about z)")
LARGEST = 1200
"""Largest number of free coordinates for which the degrees of freedom of a structure are counted."""


def explained(system: System, targets: Sequence[str], platform: Sequence[str] | None, error: InputError) -> InputError:
    """An error of the sweep in terms of targets: degrees of freedom left, motions that are impossible or held for the platform.

    system : with its drives; targets : names of the coordinates that move; platform : nodes that move as one, or None.
    """
    if len(system.free) > LARGEST or len(system.coordinate_drive):
        return error
    ways = freedoms(system)
    count = ways.shape[1]
    if platform is not None:
        cannot = _cannot(system, ways, platform)
        if cannot:
            able = (6 if system.dim == 3 else 3) - len(cannot)
            return InputError(
                f"To first order the platform cannot {' nor '.join(cannot)} from where it stands: its drives give it {able} of "
                f"the {able + len(cannot)} motions of a rigid body, and a platform's targets hold all of them. Start from "
                "another position, or name coordinates of single nodes as targets instead of a platform."
            )
    wanted = (6 if system.dim == 3 else 3) if platform is not None else len(targets)
    if count > wanted:
        left = count - wanted
        hold = ", or hold drives: make them bars of a given length." if system.drives else "."
        return InputError(
            f"The targets fix {wanted} of the {count} freedoms of the structure; {left} {'is' if left == 1 else 'are'} left. "
            f"Name as many targets as there are freedoms{hold}"
        )
    if platform is not None:
        held = [name for name in (PLATFORM if system.dim == 3 else ("x", "y", "yaw")) if name not in targets]
        if held:
            return InputError(
                f"{error} The targets of a platform hold all its motions: {', '.join(held)}, which are not named, stay as they "
                "are in the model. To leave them free, name coordinates of single nodes as targets."
            )
    return error


def freedoms(system: System) -> NDArray[np.float64]:
    """Orthonormal velocities (free, k) that the drives can produce, with all rows but theirs held."""
    kept = system.row_drive < 0
    J = jacobian(system, system.x0, system.drive_start)[kept]
    if not len(J):
        return np.eye(len(system.free))
    _, sizes, right = np.linalg.svd(J, full_matrices=True)
    rank = int(np.count_nonzero(sizes > RANK_TOLERANCE * max(1.0, float(sizes.max(initial=0.0)))))
    return np.ascontiguousarray(right[rank:].T)


def _cannot(system: System, ways: NDArray[np.float64], platform: Sequence[str]) -> list[str]:
    """Rigid-body motions of the platform that no degree of freedom contains, in words, by the nearest axes."""
    index = [system.node_index(name) for name in platform]
    full = np.zeros((system.x0.size, ways.shape[1]))
    full[system.free] = ways
    moves = full.reshape(len(system.nodes), 3, -1)[index]
    arms = system.x0[index] - system.x0[index].mean(axis=0)
    size = float(np.linalg.norm(arms, axis=1).max()) or 1.0
    turns = np.stack([np.cross(axis, arms) / size for axis in np.eye(3)], axis=-1)
    shifts = np.broadcast_to(np.eye(3), (len(index), 3, 3))
    rigid = np.concatenate([shifts, turns], axis=-1)[:, :, list(range(6)) if system.dim == 3 else [0, 1, 5]]
    names = WAYS if system.dim == 3 else (WAYS[0], WAYS[1], WAYS[5])
    flat = rigid.reshape(-1, rigid.shape[-1])
    twists = np.linalg.lstsq(flat, moves.reshape(-1, ways.shape[1]), rcond=None)[0]
    left, sizes, _ = np.linalg.svd(twists)
    rank = int(np.count_nonzero(sizes > 1e-8 * max(1.0, float(sizes.max(initial=0.0)))))
    lacking = left[:, rank:]
    found: list[str] = []
    for k in np.argsort(-np.linalg.norm(lacking, axis=1)):
        if len(found) < lacking.shape[1]:
            found.append(names[int(k)])
    return found


# The coordinates of tasks in time: values with two exact rates.

Floats = Any
Law = tuple[Floats, Floats, Floats]
PANELS, DEGREE = 16, 20
"""Of the interpolant through the values of a function of time, from which its rates are taken."""


def parameters_of(tasks: Tasks, start: Floats, t: Floats) -> Floats:
    """Taylor coefficients (3, times, parameters) of what tasks ask for at times t (s,); start : values of what is asked for."""
    columns: list[Floats] = []
    turns: list[Floats] = []
    for asked, value in zip(tasks.asked, start, strict=True):
        law = np.stack(course_of(tasks, asked, float(value), t))
        law[2] *= 0.5
        if asked.rotation < 0:
            columns.append(law)
            continue
        turns.append(law)
        if asked.rotation == 2:
            R = _rotation(*turns) if _still(asked.task) else _shortest(tasks, asked.task, t)
            columns += [R[:, :, i, j] for i in range(3) for j in range(3)]
            turns = []
    return np.ascontiguousarray(np.stack(columns, axis=2))


def _rotation(roll: Floats, pitch: Floats, yaw: Floats) -> Floats:
    """Taylor coefficients (3, times, 3, 3) of Rz Ry Rx from those of the angles (3, times)."""
    return _product(_product(_about(2, yaw), _about(1, pitch)), _about(0, roll))


def _still(task: Any) -> bool:
    """True of a task whose turns go by their angles, and not by the shortest way to an attitude or a direction."""
    return getattr(task, "attitude", None) is None and getattr(task, "direction", None) is None


def _shortest(tasks: Tasks, task: Any, t: Floats) -> Floats:
    """Taylor coefficients (3, times, 3, 3) of the shortest turn of a frame from where it starts."""
    first = tasks.begin_turned[id(task)]
    if getattr(task, "attitude", None) is None:  # its third axis is to have a direction
        axis, turn = _between(first[:, 2], np.array(task.direction))
    else:
        by = np.array(task.attitude) @ first.T
        half = np.array([by[2, 1] - by[1, 2], by[0, 2] - by[2, 0], by[1, 0] - by[0, 1]]) / 2
        turn = math.atan2(float(np.linalg.norm(half)), (np.trace(by) - 1) / 2)
        axis = half / max(float(np.linalg.norm(half)), 1e-300)
    _refuse_half(turn, "The attitude")
    return _turn_about(axis, turn * _share(task, t)) @ first


def _between(a: Floats, b: Floats) -> tuple[Floats, float]:
    """Axis and angle (rad) of the shortest turn from one unit vector (3,) to another."""
    normal = np.cross(a, b)
    size = float(np.linalg.norm(normal))
    return normal / max(size, 1e-300), math.atan2(size, float(a @ b))


def _refuse_half(turn: float, what: str) -> None:
    if turn > math.pi - EVEN:
        raise InputError(
            f"{what} is half a turn from the start, so there is more than one shortest way. Go to one in between first, in a "
            "motion of its own."
        )


def _share(task: Any, t: Floats) -> Floats:
    """Taylor coefficients (3, times) of the share of its only move that a task has done, by its law."""
    value, rate, second = _through(Way(values=(1.0,)), task, 0.0, t)
    return np.stack([value, rate, 0.5 * second])


def _turn_about(axis: Floats, a: Floats) -> Floats:
    """Taylor coefficients (3, times, 3, 3) of the turn about a unit vector by angles a (3, times): c 1 + s K + (1 - c) k kT."""
    about = _about(2, a)
    cosine, sine = about[:, :, :1, :1], about[:, :, 1:2, :1]
    one = np.zeros_like(cosine)
    one[0] = 1.0
    K = np.cross(axis, np.eye(3)).T
    return cosine * np.eye(3) + sine * K + (one - cosine) * np.outer(axis, axis)


def _product(A: Floats, B: Floats) -> Floats:
    return np.stack([sum(A[i] @ B[k - i] for i in range(k + 1)) for k in range(3)])


def _about(axis: int, a: Floats) -> Floats:
    """Taylor coefficients of the rotation about an axis by angles with coefficients a (3, times)."""
    c, s = np.cos(a[0]), np.sin(a[0])
    cosine = np.stack([c, -s * a[1], -s * a[2] - 0.5 * c * a[1] ** 2])
    sine = np.stack([s, c * a[1], c * a[2] - 0.5 * s * a[1] ** 2])
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.zeros((3, len(c), 3, 3))
    R[0, :, axis, axis] = 1.0
    R[:, :, i, i] = R[:, :, j, j] = cosine
    R[:, :, j, i], R[:, :, i, j] = sine, -sine
    return R


def course_of(tasks: Tasks, asked: Asked, start: float, t: Floats) -> Law:
    """Value, rate and second rate (times,) of one coordinate; start : its value at the start."""
    task, name = asked.task, asked.name
    if moved(task):
        return sample_profile(task, t, {name: start})[name]
    if name in DIRECTION:
        return _arc(tasks, task, name, t)
    path = getattr(task, "path", None)
    if path is not None and name in ("x", "y", "z"):
        return _around(tasks, task, path, name, t)
    if name not in task.moves:
        return np.full(len(t), start), np.zeros(len(t)), np.zeros(len(t))
    given = task.moves[name]
    if isinstance(given, TRAJECTORY_TASKS):
        found = sample_profile(given, t, {name: start})
        if name not in found:
            raise InputError(f"The course of {name!r} moves {', '.join(found)}, not {name!r}. Name {name!r} in it.")
        return found[name]
    if callable(given):
        return _function(given, name, task.duration, t)
    way = given if isinstance(given, Way) else Way(values=given if isinstance(given, tuple) else (given,))
    return _through(way, task, start, t)


def _leg(law: str, ramp: float, t: Floats, duration: float) -> Law:
    """From 0 to 1 in a time, and at rest outside."""
    if law == "trapezoid":
        return profiles.trapezoid(t, duration, ramp)
    if law == "constant":
        s = t / duration
        inside = (s >= 0) & (s <= 1)
        return np.clip(s, 0.0, 1.0), np.where(inside, 1.0 / duration, 0.0), np.zeros(len(t))
    return profiles.quintic(t, duration)


def _through(way: Way, task: Any, start: float, t: Floats) -> Law:
    """Way points with their law."""
    values = np.array([start, *way.values] if len(way.values) == 1 else way.values)
    law, ramp, dwell = (getattr(task, name) if getattr(way, name) is None else getattr(way, name)
                        for name in ("law", "ramp", "dwell"))  # fmt: skip
    times = _times(way, len(values), task.duration, dwell)
    if law == "spline":
        inside = np.clip(t, times[0, 0], times[-1, 0])
        value, rate, second = (one[:, 0] for one in through(inside, times[:, 0], values[:, None], "spline"))
        return value, np.where(inside == t, rate, 0.0), np.where(inside == t, second, 0.0)
    value, rate, second = np.full(len(t), values[0]), np.zeros(len(t)), np.zeros(len(t))
    for k in range(len(values) - 1):
        begin, end = times[k, 1], times[k + 1, 0]
        own = _leg(law, ramp, t - begin, end - begin)
        swing = values[k + 1] - values[k]
        # at a way point the rate is that of the leg that begins there
        here = (t >= begin) & (t <= end)
        value += swing * own[0]
        rate[here], second[here] = swing * own[1][here], swing * own[2][here]
    return value, rate, second


def _times(way: Way, count: int, duration: float, dwell: float) -> Floats:
    """Arrival and departure (count, 2), s, at way points."""
    if way.times is not None:
        given = np.array(way.times if len(way.times) == count else (0.0, *way.times))
        return np.stack([given, given], axis=1)
    begin, end = way.start or 0.0, duration if way.end is None else way.end
    leg = (end - begin - dwell * (count - 2)) / (count - 1)
    if leg <= 0:
        raise InputError(
            f"From {begin:g} s to {end:g} s there is no time for {count - 1} legs and {count - 2} dwells of {dwell:g} s. "
            "Make the motion longer, or the dwells shorter."
        )
    arrive = begin + np.arange(count) * leg + np.maximum(np.arange(count) - 1, 0) * dwell
    depart = arrive + np.where((np.arange(count) > 0) & (np.arange(count) < count - 1), dwell, 0.0)
    return np.stack([arrive, depart], axis=1)


def _around(tasks: Tasks, task: Any, circle: Any, name: str, t: Floats) -> Law:
    """A coordinate of a circle or helix that begins where the point of the task is."""
    if name in task.moves:
        raise InputError(f"{name!r} moves and the task has a path too. Keep one.")
    first = tasks.begin[id(task)]
    centre, axis = np.array([*circle.centre, 0.0][:3]), np.array(circle.axis)
    arm = first - centre
    along = (arm @ axis) * axis
    out = arm - along
    if np.linalg.norm(out) < 1e-12:
        raise InputError("The path is a circle about a line on which the point itself starts. Give another centre.")
    s, rate, second = _leg(task.law, task.ramp, t, task.duration)
    full = math.tau * circle.turns
    c, w = np.cos(full * s), np.sin(full * s)
    k = "xyz".index(name)
    u, v = out[k], np.cross(axis, out)[k]
    value = centre[k] + along[k] + u * c + v * w + circle.rise * axis[k] * s
    first_by, second_by = full * (v * c - u * w) + circle.rise * axis[k], -(full**2) * (u * c + v * w)
    return value, first_by * rate, second_by * rate**2 + first_by * second


def _arc(tasks: Tasks, task: Any, name: str, t: Floats) -> Law:
    """A part of a direction that turns by the shortest way from where it starts."""
    first = tasks.begin[id(task)]
    axis, turn = _between(first, np.array(task.direction))
    _refuse_half(turn, "The direction")
    value, rate, half = (_turn_about(axis, turn * _share(task, t)) @ first)[:, :, DIRECTION.index(name)]
    return value, rate, 2.0 * half


def _function(given: Callable[[Any], Any], name: str, duration: float, t: Floats) -> Law:
    """A function of time: value, rate and second rate as it gives them, or from a Chebyshev interpolant of its values."""
    first = _called(given, name, float(t[0]) if len(t) else 0.0)
    if np.ndim(first) == 1 and len(first) == 3:
        rows = np.array([_called(given, name, float(one)) for one in t], float).reshape(-1, 3)
        return rows[:, 0], rows[:, 1], rows[:, 2]
    if np.ndim(first) != 0:
        raise InputError(f"The course of {name!r} returns {first!r}. Return the value, or value, rate and second rate.")
    edges = np.linspace(0.0, max(duration, float(t[-1]) if len(t) else 0.0), PANELS + 1)
    panel = np.clip(np.searchsorted(edges, t, side="right") - 1, 0, PANELS - 1)
    found = np.zeros((3, len(t)))
    for k in np.unique(panel):
        here = panel == k
        curve = np.polynomial.Chebyshev.interpolate(
            lambda u: np.array([float(_called(given, name, float(one))) for one in np.atleast_1d(u)]),
            DEGREE,
            domain=[edges[k], edges[k + 1]],
        )
        found[:, here] = curve(t[here]), curve.deriv(1)(t[here]), curve.deriv(2)(t[here])
    return found[0], found[1], found[2]


def _called(given: Callable[[Any], Any], name: str, t: float) -> Any:
    try:
        value = np.asarray(given(t), float)
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        raise InputError(
            f"The course of {name!r} fails at t = {t:g} s: {type(error).__name__}: {error}. It must return a number, or value, "
            "rate and second rate, over the whole motion."
        ) from error
    if not np.all(np.isfinite(value)):
        raise InputError(f"The course of {name!r} is {value} at t = {t:g} s. It must be finite over the whole motion.")
    return value


def at_values(tasks: Tasks, values: Floats) -> Floats:
    """Parameters (poses, p) of coordinates that have given values (poses, asked)."""
    columns: list[Floats] = []
    for k, asked in enumerate(tasks.asked):
        if asked.rotation < 0:
            columns.append(values[:, k])
        elif asked.rotation == 2:
            still = np.zeros((3, 3, len(values)))
            still[:, 0] = values[:, k - 2 : k + 1].T
            R = _rotation(*still)[0]
            columns += [R[:, i, j] for i in range(3) for j in range(3)]
    return np.ascontiguousarray(np.stack(columns, axis=1))
