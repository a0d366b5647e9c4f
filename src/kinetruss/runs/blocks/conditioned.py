"""Runs under an operating condition: the model and the drives as they are then."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from kinetruss import kinematics
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kinematics import conditions
from kinetruss.model import Condition, Free, Hold, Model, Quintic, Run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.results import Motion

__all__ = ["conditioned", "followed", "poses_under"]

SIMULATED, TASKED = "dynamics.simulate", ("dynamics.simulate", "statics.equilibrium")


def conditioned(model: Model, run: Run) -> tuple[Model, Run, Condition | None]:
    """The model under the condition of a run, the run as done on it, and the condition.

    Where drives have tasks, locked ones are held and released ones free; elsewhere released ones are taken out.

    Raises
    ------
    ModelError, InputError : as `conditions.under`; node histories under a condition that changes them.
    """
    run = run.with_(trajectory=model.trajectory_of(run))
    if run.condition is None:
        return model, run, None
    condition = conditions.named_condition(model, run.condition)
    if run.motion is not None and condition.moves_otherwise:
        raise InputError(
            f"The motion is given by node histories, which do not know what {run.condition!r} changes. Give a trajectory, or a "
            "condition without temperature and without locked, released or failed parts."
        )
    if run.analysis not in TASKED:
        return conditions.under(model, run.condition), run, condition
    fates = dict.fromkeys(condition.locked, Hold()) | dict.fromkeys(condition.released, Free())
    trajectory = run.trajectory if run.analysis == SIMULATED else None
    run = run.with_(tasks={**run.tasks, **fates}, trajectory=trajectory)
    return conditions.under(model, condition.with_(locked=(), released=())), run, condition


def followed(
    models: tuple[Model, Model],
    condition: Condition | None,
    trajectory: Any,
    times: NDArray[Any],
    start: ArrayLike | None = None,
    *,
    raising: bool = True,
) -> Motion:
    """The motion of a trajectory; models : as given, and under the condition. As `kinematics.follow`."""
    given, changed = models
    if condition is None or not condition.moves_otherwise:
        return kinematics.follow(changed, trajectory, times=times, start=start, raise_on_failure=raising)
    motion = conditions.commanded(given, changed, condition, trajectory, times, start=start)
    if raising and not motion.status.ok:
        raise AnalysisError(f"{motion.status.value} {motion.message}", motion)
    return motion


def poses_under(model: Model, condition: Condition | None, poses: Mapping[str, Mapping[str, float]]) -> dict[str, Any]:
    """Listed poses as commands of the drives that are left; locked ones stay."""
    if condition is None or not condition.moves_otherwise:
        return {name: dict(pose) for name, pose in poses.items()}
    gone = {*condition.released, *condition.locked}
    gone |= {name for name, drive in model.all_drives.items() if getattr(drive, "bar", None) in condition.failed}
    found = {}
    for name, pose in poses.items():
        commands = {}
        if pose:
            standing = Quintic(moves={one: (value, value) for one, value in pose.items()}, duration=1.0)
            value = kinematics.sample(model, standing, [0.0]).value[0]
            commands = dict(zip(model.all_drives, value.tolist(), strict=True))
        found[name] = {one: value for one, value in commands.items() if one not in gone}
    return found
