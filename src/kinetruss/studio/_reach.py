"""Moves from one good pose to another, and decides which poses may be shown."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kinetruss import kinematics, statics
from kinetruss.errors import AnalysisError, KinetrussError
from kinetruss.mechanics import arrange, compile
from kinetruss.model import Model, Quintic
from kinetruss.studio._close import CLOSED, closed, gap

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Pose = NDArray[np.float64]

__all__ = ["LEAST", "Reached", "reach", "stand", "start_of"]

LEAST = 1e-3
"""Singularity measure at which a slider stops: forces and drive rates are then up to 1000 times those of a good pose."""

COARSE, FINE = 33, 513
"""Number of samples on the path to a new pose; if its end cannot be reached, more are used to stop close to the limit."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Reached:
    """The last good pose on a path.

    position : (n_nodes, dim), m. values : drive values there, m or rad. gauge : smallest singular value of the Jacobian's
    blocks, NaN if parts hang freely. stopped : why the path ends before the wanted values, or empty.
    note : other remarks on the pose.
    """

    position: Pose
    values: dict[str, float]
    gauge: float = float("nan")
    stopped: str = ""
    note: str = ""


def start_of(model: Model) -> Reached:
    """The own pose of the model.

    Raises
    ------
    AnalysisError, InputError : lengths that cannot be closed, or no equilibrium.
    """
    system = compile(model)
    values = {name: float(value) for name, value in zip(system.drives, system.drive_start, strict=True)}
    if arrange(system).plan is None:
        return _settled(model, None, values)
    position = kinematics.assemble(model)
    return _checked(model, Reached(position=position, values=values, gauge=_gauge(model, position, values)))


def stand(model: Model, position: Pose, values: Mapping[str, float]) -> Reached:
    """A changed model at drive values (m or rad): closed from the pose shown, else from its own pose, or in equilibrium.

    Raises
    ------
    AnalysisError, InputError : it cannot be closed from either pose, or has no equilibrium.
    """
    if arrange(compile(model)).plan is None:
        return _settled(model, position, values)
    note = ""
    try:
        found = closed(model, position, values)
    except KinetrussError as first:
        try:
            found = closed(model, kinematics.assemble(model), values)
        except KinetrussError:
            raise first from None
        note = "It could not be closed from the previous pose; it was closed from the pose of the model instead."
    return _checked(model, Reached(position=found, values=dict(values), gauge=_gauge(model, found, values), note=note))


def _checked(model: Model, pose: Reached) -> Reached:
    """The pose, after a check that all lengths and angles are satisfied.

    Raises
    ------
    AnalysisError : a length or an angle is not satisfied.
    """
    miss, what = gap(model, pose.position, pose.values)
    if miss <= CLOSED:
        return pose
    raise AnalysisError(f"The lengths cannot be closed: {what!r} is off by {miss:.2g} of the structure's size.")


def reach(model: Model, position: Pose, now: Mapping[str, float], wanted: Mapping[str, float]) -> Reached:
    """Move drives from their present to new values, continuously in steps, up to the last good pose.

    Parameters
    ----------
    position : (n_nodes, dim) a good pose at the values `now`, m. wanted : values of some or all drives, m or rad.
    """
    goal = dict(now) | dict(wanted)
    if arrange(compile(model)).plan is None:
        try:
            return _settled(model, position, goal)
        except KinetrussError as error:
            return Reached(position=position, values=dict(now), stopped=_reason(str(error)))
    if goal == dict(now):
        return Reached(position=position, values=goal, gauge=_gauge(model, position, now))
    try:
        found = _followed(model, position, now, goal, COARSE)
        return _checked(model, found if not found.stopped else _followed(model, position, now, goal, FINE))
    except KinetrussError as error:
        return Reached(position=position, values=dict(now), gauge=_gauge(model, position, now), stopped=_reason(str(error)))


def _followed(model: Model, position: Pose, now: Mapping[str, float], goal: Mapping[str, float], samples: int) -> Reached:
    moves = {name: (now[name], goal[name]) for name in goal}
    way = Quintic(moves=moves, duration=1.0)
    motion = kinematics.follow(model, way, samples=samples, start=position, least=LEAST, raise_on_failure=False)
    found = motion.arrays
    if not len(found["time"].values):
        return Reached(position=position, values=dict(now), stopped=_reason(motion.message))
    names = [str(name) for name in found["drive"].values]
    return Reached(
        position=np.array(found["position"].values[-1]),
        values=dict(goal)
        if motion.status.ok
        else dict(zip(names, map(float, found["drive_position"].values[-1]), strict=True)),
        gauge=float(found["singularity"].values[-1]),
        stopped="" if motion.status.ok else _reason(motion.message),
    )


TIMED = re.compile(r" \(t = [^)]*\)| (?:at|between|from) t = \S+ s(?: and \S+ s)?(?: on)?|^At t = \S+ s ")
"""Parts of messages with the time of a path, which a slider does not have."""

ADVICE = ("The motion is good", "Start the path", "Correct the path", "Change the path to avoid it", "Drive one of them less")
"""Starts of sentences that apply only to paths."""


def _reason(message: str) -> str:
    """The reason, without times and advice that apply to a path but not to a slider."""
    sentences = re.split(r"(?<=[.!?]) (?=[A-Z])", message)
    kept = " ".join(TIMED.sub("", one) for one in sentences if not one.startswith(ADVICE))
    kept = kept.replace("The path runs", "This motion runs").replace("at the start of the path ", "").rstrip(".")
    return f"{kept[:1].upper()}{kept[1:]}. Stopped at the last good pose: move the drives in another way."


def _settled(model: Model, position: Pose | None, values: Mapping[str, float]) -> Reached:
    """The equilibrium of a structure with springs or loose parts at given drive values."""
    rest = statics.equilibrium(model, position, lengths=values)
    note = rest.message
    if not rest.stable:
        note = f"{note} {'; '.join(rest.ways_out)}".strip()
    return _checked(model, Reached(position=np.array(rest.data["position"].values), values=dict(values), note=note))


def _gauge(model: Model, position: Pose, values: Mapping[str, float]) -> float:
    """The singularity measure of one pose, computed for a path that stays there."""
    if not values:
        return float("nan")
    way = Quintic(moves={name: (value, value) for name, value in values.items()}, duration=1.0)
    motion = kinematics.follow(model, way, times=[0.0], start=position, raise_on_failure=False)
    gauge = motion.arrays["singularity"].values
    return float(gauge[0]) if len(gauge) else 0.0
