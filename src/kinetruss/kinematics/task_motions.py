"""Motions for tasks: the drives along a path, what holds them back, and what a task asks that a structure cannot do."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.kernels.tasks import track as warm
from kinetruss.kinematics.drive_limits import Limits, limits_of, reported
from kinetruss.kinematics.motions import Course, Swept, course_at
from kinetruss.kinematics.objectives import KNOTTED, nearest_along, reference_along
from kinetruss.kinematics.task_courses import parameters_of
from kinetruss.kinematics.task_problem import MET, OPEN, Problem, State, followed, problem
from kinetruss.kinematics.task_programs import DIRECTION
from kinetruss.kinematics.turns import REFINED, divided_into, halved
from kinetruss.kinematics.within_limits import INSTANTS, references_within
from kinetruss.mechanics import System
from kinetruss.mechanics.positions import shortest
from kinetruss.model import Combined, Coordinates, Gimbal, Way
from kinetruss.results import Status

if TYPE_CHECKING:
    from numpy.typing import NDArray


RANK = 1e-7
"""Singular value of the derivatives of tasks, as a share of the largest, below which their drives cannot do one of them."""


ONWARD = (
    "The drives of least objective end in a fold after t = {:g} s, beyond which they would jump. Over the whole motion those "
    "nearest to the ones shortly before are taken instead, so the same pose need not have the same drives."
)
FOLD = 1e-3
"""Smallest singular value of the derivatives of tasks, as a share of the largest, above which drives can do all of them."""
ALMOST = 1e-5
"""Distance of the nearest pose, as a share of the shortest bar, below which it is the end that is singular."""


@dataclass(frozen=True, kw_only=True)
class Choice:
    """How drives are chosen (see `model.Combined`)."""

    objective: str = "least_change"
    weights: Any = None
    hold: tuple[str, ...] = ()
    within_stroke: bool = True
    within_rates: bool = True


def choice_of(targets: Any) -> Any:
    """The record of choices of a task; those of a trajectory are the default ones."""
    return targets if hasattr(targets, "objective") else Choice(weights={})


def tasks_course(system: System, targets: Any, t: NDArray[np.float64]) -> tuple[Course, Swept]:
    """The histories that do tasks at the instants t (s,) s, and how they ended."""
    targets, wanted = divided(system, targets)
    choice = choice_of(targets)
    given = problem(system, targets, choice)
    readings = given.tasks.start(given.begin.x)
    limits = limits_of(system, choice)
    dense = divided_into(t, INSTANTS) if limits.moving else t
    for _ in range(REFINED):
        found, drives, notes = _swept(given, choice, limits, readings, dense)
        finer = halved(system, found.x, found.v, dense)
        if len(finer) == len(dense):
            break
        dense = finer
    if wanted is not None and len(found.x):
        notes = f"{notes} {_division(system, wanted, found.x[-1], t)}"
    kept = reported(system, limits, _why(given, choice), dense, found.x, drives)
    found = replace(found, message=f"{found.message} {notes} {kept.pop('words', '')}".strip())
    return replace(course_at(dense, t, found, drives), attrs=kept), found


def _why(given: Problem, choice: Any) -> str:
    """Why limits that are not kept are not."""
    if np.count_nonzero(given.drives.held != 3) <= len(given.tasks.labels):
        return "the task leaves the drives no freedom"
    if not choice.within_rates:
        return "redundant drives do not mind them"
    return "no choice of the redundant drives was found that keeps them all"


def _swept(given: Problem, choice: Any, limits: Limits, readings: Any, t: NDArray[np.float64]) -> tuple[Swept, Any, str]:
    """The sweep along the drives that do the tasks at t (s,); drives; what is to be said."""
    parameters = parameters_of(given.tasks, readings, t)
    state, reference, onward = first_state(given, parameters[0, 0], float(t[0])), None, ""
    if choice.objective in KNOTTED:
        reference, state = reference_along(given, t, parameters, state, choice.objective)
    given, state, reference = _begun(given, choice, limits, t, parameters, state, reference)
    reason, good, out = given.track(t, parameters, state, reference)
    if reason != warm.DONE and choice.objective not in KNOTTED:
        # the least change may end in a fold, beyond which other drives are nearer; those next to the drives before go on
        other = nearest_along(given, t, parameters, state)
        begun = None if other is None else _begun(given, choice, limits, t, parameters, state, other)
        again = None if begun is None else begun[0].track(t, parameters, *begun[1:])
        if begun is not None and again is not None and again[0] == warm.DONE:
            onward = ONWARD.format(t[max(0, good - 1)])
            (given, state, _), (reason, good, out) = begun, again
    d = len(given.reference)
    drives = tuple(np.ascontiguousarray(scale * out.z[k, :good, :d]) for k, scale in enumerate((1.0, 1.0, 2.0)))
    if good == 0:
        raise InputError(f"The motion cannot start (t = {t[0]:g} s): {_stuck(given, state, parameters[0, 0])}")
    found = followed(given.system, t[:good], drives, state.x)
    notes = f"{onward} {_limits_text(given, t, out.held[:good])}".strip()
    if len(found.x) < good or not found.status.ok:
        return found, drives, notes
    if reason == warm.DONE:
        return found, drives, notes
    last = State(x=out.x[0, good - 1], q=drives[0][-1], s=out.z[0, good - 1, d:], miss=np.zeros(given.tape.tasks))
    status, why = _ended(given, last, parameters[0], t, good)
    return replace(found, status=status, message=f"{why} The motion is good up to t = {t[good - 1]:g} s."), drives, notes


def _begun(
    given: Problem, choice: Any, limits: Limits, t: NDArray[np.float64], parameters: Any, state: State, reference: Any
) -> tuple[Problem, State, Any]:
    """The problem, its first state and the curve (3, times, d) to be near to, from a first curve, or None."""
    if reference is not None:
        given = replace(given, reference=reference[0, 0].copy())
        state = first_state(given, parameters[0, 0], float(t[0]), state)
    if limits.moving and choice.within_rates:
        reference = references_within(given, limits, t, parameters, state, reference)
        given = given if reference is None else replace(given, reference=reference[0, 0].copy())
        state = first_state(given, parameters[0, 0], float(t[0]), state)
    return given, state, reference


def first_state(given: Problem, parameters: NDArray[np.float64], t: float, start: State | None = None) -> State:
    """The state in which a motion begins: the tasks are met, and the drives are the best.

    Raises
    ------
    InputError : out of reach, or tasks of which the drives cannot do one to first order.
    """
    state, names = start or given.begin, [asked.name for asked in given.tasks.asked]
    if not given.closes(state, parameters):
        raise InputError(f"The motion cannot start (t = {t:g} s): {OPEN}")
    c, A = given.linear(state, parameters)
    beyond = np.any((state.q < given.drives.lower - 1e-9) | (state.q > given.drives.upper + 1e-9))
    if np.abs(c).max() > 1e-12 * given.scale or beyond or np.any(given.reference != state.q):
        state = given.reach(parameters, state)
        if state.far > MET * given.scale:
            if lacking := cannot(given, A):
                raise InputError(f"{lacking} {nearest_text(given, state, parameters)}")
            raise InputError(f"The task is out of reach at its start (t = {t:g} s). {nearest_text(given, state, parameters)}")
        c, A = given.linear(state, parameters)
    if lacking := cannot(given, A):
        raise InputError(f"{lacking} Leave that free, or start from another position. (Its coordinates: {', '.join(names)}.)")
    free = given.drives.held != 3
    weighted = (given.drives.weight * (state.q - given.reference))[free]
    s = np.linalg.lstsq(A[:, free].T, weighted, rcond=None)[0]
    return replace(state, s=s)


def cannot(given: Problem, A: NDArray[np.float64]) -> str:
    """What the drives cannot do of the tasks to first order, with the rank; empty if there is nothing."""
    free = given.drives.held != 3
    left, sizes, _ = np.linalg.svd(A[:, free])
    rank = int(np.count_nonzero(sizes > RANK * max(1.0, float(sizes.max(initial=0.0)))))
    if rank == len(A):
        return ""
    ways = []
    for vector in left[:, rank:].T:
        order = np.argsort(-np.abs(vector), kind="stable")
        main = [k for k in order if abs(vector[k]) > 0.3 * abs(vector[order[0]])]
        names = list(dict.fromkeys(given.tasks.labels[k] for k in main))
        ways.append(names[0] if len(names) == 1 else f"do this alone: {' with '.join(names)}")
    held = f" with {', '.join(n for n, h in zip(given.system.drives, ~free, strict=True) if h)} held" if not free.all() else ""
    return (
        f"To first order the structure cannot {' nor '.join(dict.fromkeys(ways))} from where it stands{held}: its "
        f"{int(free.sum())} drives give it {rank} of the {len(A)} motions that the task asks for (rank {rank})."
    )


def nearest_text(given: Problem, state: State, parameters: NDArray[np.float64]) -> str:
    """The nearest state in words: what is asked for, what it has."""
    found = given.tasks.read(state.x[None])[0]
    wanted = prescribed_values(given, parameters)
    each = zip(given.tasks.asked, found, wanted, strict=True)
    said = [f"{asked.name} {value:.9g} (wanted {want:.9g})" for asked, value, want in each
            if np.isfinite(want) and abs(value - want) > 1e-9]  # fmt: skip
    turn = turned_off(given, state.x, parameters)
    if turn > 1e-9:
        said.insert(0, f"an attitude {np.degrees(turn):.6g} deg from the one wanted")
    ends = np.minimum(np.abs(state.q - given.drives.lower), np.abs(state.q - given.drives.upper)) < 1e-9
    at = [name for name, there in zip(given.system.drives, ends, strict=True) if there]
    edge = f" At the ends of their strokes: {', '.join(at)}." if at else ""
    starts = f"best of {state.starts} starts, {state.same} of them came as near" if state.starts > 1 else "from one start"
    if state.far < ALMOST * shortest(given.system) and not at:
        return (
            f"The nearest pose found ({starts}) is only {state.far:.2g} m away: the end itself is a singular position, or the "
            "edge of the reach. Ask for a little less."
        )
    return (
        f"The nearest pose found ({starts}) has {', '.join(said[:8])}, {state.far:.3g} m away.{edge} "
        "Ask for less, or give longer strokes."
    )


def prescribed_values(given: Problem, parameters: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (asked,) that parameters stand for."""
    found, at = [], 0
    asked = given.tasks.asked
    for one in asked:
        if one.rotation < 0:
            found.append(parameters[at])
            at += 1
        elif one.rotation == 2:
            R = parameters[at : at + 9].reshape(3, 3)
            found += [
                np.arctan2(R[2, 1], R[2, 2]),
                np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])),
                np.arctan2(R[1, 0], R[0, 0]),
            ]
            at += 9
    return np.array(found)


def turned_off(given: Problem, x: NDArray[np.float64], parameters: NDArray[np.float64]) -> float:
    """Largest rotation angle (rad) from an attitude or direction that parameters stand for to that at flat positions x (3 n,).

    NaN if the tasks ask for none.
    """
    angles, at = [np.nan], 0
    found = given.tasks.read(x[None])[0]
    for k, one in enumerate(given.tasks.asked):
        if one.rotation == 2:
            by = parameters[at : at + 9].reshape(3, 3).T @ given.tasks.attitude(id(one.task), x)
            # |R - 1| = 2 sqrt(2) sin(angle/2) in Frobenius' norm
            angles.append(2 * np.arcsin(min(1.0, float(np.linalg.norm(by - np.eye(3))) / np.sqrt(8))))
        elif one.name == DIRECTION[2]:
            wanted, got = parameters[at - 2 : at + 1], found[k - 2 : k + 1]
            angles.append(np.arctan2(np.linalg.norm(np.cross(wanted, got)), wanted @ got))
        at += 1 if one.rotation < 0 else 9 * (one.rotation == 2)
    return float(np.nanmax(angles)) if len(angles) > 1 else np.nan


def _stuck(given: Problem, state: State, parameters: NDArray[np.float64]) -> str:
    c, A = given.linear(state, parameters)
    return cannot(given, A) or f"the task is off by {np.abs(c).max():.3g} m and does not come nearer."


def _ended(given: Problem, last: State, asked: Any, t: NDArray[np.float64], good: int) -> tuple[Status, str]:
    """Why a path of parameters asked (times, p) ended behind a good state."""
    parameters, final = asked[good], asked[-1]
    _, A = given.linear(last, parameters)
    free = (given.drives.held == 0)[None, :]
    sizes = np.linalg.svd(np.where(free, A, 0.0), compute_uv=False)
    when = f"between t = {t[good - 1]:g} s and {t[good]:g} s"
    nearest = given.reach(parameters, last)
    if nearest.far > MET * given.scale:
        end = given.reach(final, nearest)
        if end.far <= MET * given.scale:
            return Status.OUT_OF_REACH, (
                f"The path gets out of reach {when}, though its end is within reach. Go round by way points, or leave a "
                "coordinate free on the way."
            )
        return Status.OUT_OF_REACH, f"The task gets out of reach {when}. Of its end: {nearest_text(given, end, final)}"
    if sizes[-1] > FOLD * sizes[0]:
        return Status.SINGULAR, (
            f"The drives of least objective end {when}: the task can be done there (singular values {sizes[-1]:.2g} to "
            f"{sizes[0]:.2g}), but the next drives are a jump away. Hold some drives, give them limits, or start elsewhere."
        )
    left, _, _ = np.linalg.svd(A)
    worst = given.tasks.labels[int(np.argmax(np.abs(left[:, -1])))]
    return Status.SINGULAR, (
        f"The task runs into a position {when} in which the drives cannot {worst} (smallest singular value {sizes[-1]:.2g}, "
        f"largest {sizes[0]:.2g}): beyond it there is no way on without a jump. Change the path, or leave that free."
    )


def _limits_text(given: Problem, t: NDArray[np.float64], held: NDArray[np.int64]) -> str:
    """Which drives come to the ends of their strokes, and when."""
    said = []
    for d in np.flatnonzero(np.any((held == 1) | (held == 2), axis=0)):
        k = int(np.argmax((held[:, d] == 1) | (held[:, d] == 2)))
        edge = given.drives.lower[d] if held[k, d] == 1 else given.drives.upper[d]
        said.append(f"{given.system.drives[d]} at {edge:.6g} m from t = {t[k]:g} s")
    if not said:
        return ""
    return f"Drives at the ends of their strokes: {', '.join(said[:6])}; where one gets there or leaves, rates jump."


def divided(system: System, targets: Any) -> tuple[Any, Gimbal | None]:
    """Gimbal tasks with an equal division of angles as moves of the poses of all bays."""
    if not isinstance(targets, Gimbal) or targets.division != "equal":
        if isinstance(targets, Combined) and any(getattr(task, "division", "") == "equal" for task in targets.tasks):
            raise InputError("An equal division of angles moves all drives, so it cannot be combined. Give it alone, or exact.")
        return targets, None
    poses = list(system.model.poses)
    moved = {name for pose in system.model.poses.values() for name in pose.drives}
    if other := [name for name in system.drives if name not in moved]:
        raise InputError(
            f"An equal division of angles moves bays by their poses, and {other[0]!r} belongs to none (a tapered bay has no "
            "pose, for example). Give division: exact."
        )
    given = problem(system, targets.with_(division="exact"), targets)
    start = dict(zip([one.name for one in given.tasks.asked], given.tasks.start(given.begin.x), strict=True))
    own = problem(
        system, Coordinates(moves={f"{pose}.{k}": 0.0 for pose in poses for k in ("beta", "gamma", "height")}), targets
    )
    now = dict(zip([one.name for one in own.tasks.asked], own.tasks.start(own.begin.x), strict=True))
    moves: dict[str, Any] = {f"{pose}.height": (now[f"{pose}.height"],) * 2 for pose in poses}
    for name in ("beta", "gamma"):
        course = targets.moves.get(name, start.get(name, 0.0))
        way = course if isinstance(course, Way) else Way(values=course if isinstance(course, tuple) else (course,))
        values = (float(start[name]), *way.values) if len(way.values) == 1 else way.values
        for pose in poses:
            first = now[f"{pose}.{name}"]
            shares = tuple(first + (value - float(start[name])) / len(poses) for value in values)
            moves[f"{pose}.{name}"] = way.with_(values=shares)
    kept = ("duration", "law", "ramp", "dwell", "hold", "within_stroke", "rate", "acceleration", "force", "within_rates")
    own_fields = {name: getattr(targets, name) for name in kept}
    return Coordinates(moves=moves, **own_fields), targets.with_(division="exact")


def _division(system: System, wanted: Gimbal, x: NDArray[np.float64], t: NDArray[np.float64]) -> str:
    """How far the angles that an equal division reaches are from those wanted."""
    given = problem(system, wanted, wanted)
    start = given.tasks.start(given.begin.x)
    want = prescribed_values(given, parameters_of(given.tasks, start, t[-1:])[0, 0])
    found = given.tasks.read(x[None])[0]
    said = ", ".join(f"{one.name} {np.degrees(got):.6g} deg (wanted {np.degrees(w):.6g}, off by {np.degrees(got - w):.3g})"
                     for one, got, w in zip(given.tasks.asked, found, want, strict=True))  # fmt: skip
    return f"Equal division of the angles over {len(system.model.poses)} bays reaches {said}."
